//! The regions of a map among the pixels of a view.

use std::ops::Range;

use kurbo::{Affine, Point};
use scumble_core::pace::{Slices, now};
use scumble_core::{BlendColor, Boundary, HalfEdge, Triangulation};

use super::wall::{Segment, centers_from_du};
use crate::barriers::Barriers;
use crate::scene::View;

/// A mesh and what its sides are, seen in a view.
pub(super) struct PixelRegions<'a> {
    pub(super) mesh: &'a Triangulation,
    boundary: &'a Boundary,
    size_px: [u32; 2],
    centers_from_du: Affine,
}

impl<'a> PixelRegions<'a> {
    pub(super) fn new(mesh: &'a Triangulation, boundary: &'a Boundary, view: &View) -> Self {
        let size_px = [view.width_px, view.height_px];
        Self { mesh, boundary, size_px, centers_from_du: centers_from_du(view) }
    }

    /// The triangles of each region, in ascending order.
    pub(super) fn triangles(&self) -> Vec<Vec<u32>> {
        let all: Vec<_> = (0..self.mesh.triangle_count() as u32).collect();
        let barriers = Barriers { mesh: self.mesh, closed_gaps: &self.boundary.closed_gaps };
        now(Slices::new(barriers.regions(&all)))
    }

    /// The lengths of the coloured sides of a region, in du, and their colours in the middle.
    pub(super) fn colors(&self, triangles: &[u32]) -> impl Iterator<Item = (f64, BlendColor)> {
        let edges = triangles.iter().flat_map(|&t| (0..3).map(move |i| HalfEdge::of(t as usize, i)));
        edges.filter_map(|h| {
            let colors = self.boundary.sides.get(self.mesh.side(h)?.index()).copied().flatten()?;
            let [a, b] = self.mesh.segment(h);
            Some((a.distance(b), colors[1]))
        })
    }

    /// The pixels of which something holds whose centres lie in a region: by the same decisions as cuts, so that none is in two
    /// regions.
    pub(super) fn pixels(&self, triangles: &[u32], holds: &[bool]) -> Vec<u32> {
        let mut pixels = Vec::new();
        for &t in triangles {
            let corners = self.mesh.corners(t as usize).map(|p| self.centers_from_du * p);
            for row in rows(corners, self.size_px[1]) {
                // Most rows of most triangles have none, and this tells it in no time.
                if holds[self.in_row(row, columns_near(corners))].contains(&true) {
                    let within = self.in_row(row, columns_within(corners, row));
                    pixels.extend(within.filter(|&pixel| holds[pixel]).map(|pixel| pixel as u32));
                }
            }
        }
        pixels
    }

    /// The pixels of the picture in some columns of a row.
    fn in_row(&self, row: i64, columns: Range<i64>) -> Range<usize> {
        let width_px = i64::from(self.size_px[0]);
        let pixel = |column: i64| (row * width_px + column.clamp(0, width_px)) as usize;
        pixel(columns.start)..pixel(columns.end)
    }
}

/// The rows that a triangle has centres of pixels in.
fn rows([a, b, c]: [Point; 3], height_px: u32) -> Range<i64> {
    let [first, end] = [a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y)];
    Segment([Point::new(a.x, first), Point::new(a.x, end)]).rows(height_px)
}

/// Columns in which all pixels are that a triangle has, and some more.
fn columns_near([a, b, c]: [Point; 3]) -> Range<i64> {
    let [first, last] = [a.x.min(b.x).min(c.x), a.x.max(b.x).max(c.x)];
    (first - 1.0) as i64..(last + 2.0) as i64
}

/// The columns of a row that a triangle has.
fn columns_within([a, b, c]: [Point; 3], row: i64) -> Range<i64> {
    let edges = [[a, b], [b, c], [c, a]].map(Segment);
    let crossing = edges.into_iter().filter(|edge| edge.crosses_row(row));
    let mut ends = crossing.map(|edge| edge.on_row(row).before + 1);
    let [one, other] = [ends.next(), ends.next()].map(Option::unwrap_or_default);
    one.min(other)..one.max(other)
}
