//! A finer mesh of one region, where sources need it.
//!
//! Sizes pass gradually into each other, and triangles away from the sources stay as they are. Nodes are none of the
//! source's: the mesh changes little where a stroke moves a little.

use kurbo::Point;

use super::cells::Cells;
use super::dofs::Dofs;
use crate::brush::Brush;

/// Triangles of the finest mesh of a region beyond those of the region itself: more detail than that is left out.
const MAX_FINER: usize = 60_000;

/// Longest edge under a stroke, in radii where it is.
const LONGEST_EDGE: f64 = 0.55;

/// Where the rim is, in radii: the source is all but nothing beyond.
const RIM: f64 = 0.85;

/// What the longest edge grows by beyond the rim, for each du of distance. The middle of a triangle is no farther from its
/// corners than two thirds of its longest edge, so at this it is split wherever in it the brush is.
const GROWTH: f64 = 1.5;

/// Longest edge where a stroke runs over the side of a curve, in widths of the layer there, `√(1 / strength)`.
const SIDE_EDGE: f64 = 0.75;

/// What that grows by for each du of distance from the side.
const SIDE_GROWTH: f64 = 0.7;

/// The elements of a region, refined.
#[derive(Debug)]
pub(super) struct Refined {
    pub(super) dofs: Dofs,
    pub(super) shapes: Vec<Shape>,
}

/// Where an element is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    pub(super) corners: [Point; 3],
    /// Bit `i` is set where the edge from corner `i` to corner `i + 1` bounds the region.
    pub(super) side_edges: u32,
}

/// Refines a region of some cells for sources.
pub(super) fn refine(coarse: &Cells, dofs: &Dofs, brushes: &[Brush]) -> Refined {
    let mut coarsening = 1.0;
    loop {
        let mut cells = coarse.clone();
        if cells.refine(brushes, coarsening) {
            return cells.refined(dofs);
        }
        coarsening *= 1.5;
    }
}

impl Cells {
    /// Bisects all that is too large; `false` where that is too much.
    fn refine(&mut self, brushes: &[Brush], coarsening: f64) -> bool {
        let most = self.cells.len() + MAX_FINER;
        for brush in brushes {
            let mut i = 0;
            while i < self.cells.len() {
                while self.is_too_large(i, brush, coarsening) {
                    if self.cells.len() >= most {
                        return false;
                    }
                    self.bisect(i);
                }
                i += 1;
            }
        }
        true
    }

    fn is_too_large(&self, i: usize, brush: &Brush, coarsening: f64) -> bool {
        let corners = self.cells[i].corners.map(|corner| self.points[corner as usize]);
        let [a, b, c] = corners.map(Point::to_vec2);
        let longest_du =
            [a - b, b - c, c - a].map(|edge| edge.hypot2()).into_iter().fold(0.0, f64::max).sqrt();
        let longest_du = longest_du / coarsening;
        let middle = ((a + b + c) / 3.0).to_point();
        // Beyond this distance from where the stroke has a radius the edge is short enough for it.
        let far_du =
            |radius_du: f64| RIM * radius_du + ((longest_du - LONGEST_EDGE * radius_du) / GROWTH).max(0.0);
        let (mut is_too_long, mut strength) = (false, 0.0);
        brush.for_each_place(middle, far_du(brush.radii_du[1]), &mut |place| {
            if place.distance_du < far_du(place.radius_du) {
                is_too_long |= longest_du > LONGEST_EDGE * place.radius_du;
                strength = place.strength.max(strength);
            }
        });
        is_too_long || longest_du > self.side_edge_du(i, strength)
    }

    /// Longest edge for the sake of the sides, where a stroke has some strength in the middle of a triangle.
    fn side_edge_du(&self, i: usize, strength: f64) -> f64 {
        let side_du = self.cells[i].corners.map(|corner| self.side_du[corner as usize]);
        let side_du = side_du.into_iter().fold(f64::INFINITY, f64::min);
        SIDE_EDGE / strength.sqrt() + SIDE_GROWTH * side_du
    }
}
