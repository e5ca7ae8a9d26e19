//! The regions of a map among the pixels of a view.

use std::ops::Range;

use kurbo::{Affine, Point};
use scumble_core::pace::{Slices, now};
use scumble_core::{BlendColor, Boundary, HalfEdge, Triangulation};

use super::wall::{Segment, centers_from_du};
use crate::barriers::Barriers;
use crate::scene::View;

/// Pixels of a row.
#[derive(Clone, Debug)]
pub(super) struct Span {
    pub(super) row: i64,
    pub(super) columns: Range<i64>,
}

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

    /// The pixels whose centres lie in a region: by the same decisions as cuts, so that none is in two regions.
    pub(super) fn spans(&self, triangles: &[u32]) -> Vec<Span> {
        triangles.iter().flat_map(|&t| self.spans_of(self.mesh.corners(t as usize))).collect()
    }

    fn spans_of(&self, corners: [Point; 3]) -> impl Iterator<Item = Span> + use<> {
        let [width_px, height_px] = self.size_px;
        let [a, b, c] = corners.map(|p| self.centers_from_du * p);
        let edges = [[a, b], [b, c], [c, a]].map(Segment);
        let rows = edges.map(|edge| edge.rows(height_px));
        let [first, end] = [a.y.min(b.y).min(c.y), a.y.max(b.y).max(c.y)];
        // Columns are exact below; this is so that triangles beside the picture cost nothing.
        let is_beside = a.x.max(b.x).max(c.x) < -1.0 || a.x.min(b.x).min(c.x) > f64::from(width_px);
        let upright = Segment([Point::new(a.x, first), Point::new(a.x, end)]);
        let all = if is_beside { 0..0 } else { upright.rows(height_px) };
        all.filter_map(move |row| {
            let crossing = edges.iter().zip(&rows).filter(|(_, rows)| rows.contains(&row));
            let mut ends = crossing.map(|(edge, _)| edge.on_row(row).before + 1);
            let [one, other] = [ends.next()?, ends.next()?];
            Some(Span { row, columns: one.min(other).max(0)..one.max(other).min(width_px.into()) })
        })
    }
}
