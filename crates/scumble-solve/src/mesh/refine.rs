//! A finer mesh of one region, where sources need it.
//!
//! Sizes pass gradually into each other, and triangles away from the sources stay as they are. Nodes are none of the
//! source's: the mesh changes little where a stroke moves a little.

use kurbo::Point;
use scumble_core::pace::Pace;

use super::cells::Cells;
use crate::brush::{Brush, Place};

/// Triangles of the finest mesh of a region beyond those of the region itself: more detail than that is left out.
const MAX_FINER: usize = 60_000;

/// Longest edge in the middle of a stroke, in radii where it is.
const LONGEST_EDGE: f64 = 0.75;

/// Longest edge at the rim of a stroke, in radii: so much, and for a weight of one so much more, which falls with its
/// root. There the colour passes into what is around it, on a way that is the shorter the stronger it is.
const RIM_EDGE: [f64; 2] = [0.2, 1.4];

/// How far from the rim the edges begin to grow, in radii.
const RIM_WIDTH: f64 = 0.4;

/// What the longest edge grows by from there on, for each du of distance.
const GROWTH: f64 = 0.6;

/// The elements of a region, refined.
#[derive(Debug)]
pub(super) struct Refined {
    pub(super) shapes: Vec<Shape>,
    /// The unknowns of each, as those of a mesh; corners come first.
    pub(super) dofs: Vec<[u32; 6]>,
    pub(super) dof_count: usize,
}

/// Where an element is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    /// The triangle of the region that it is, or is a part of, by its index there.
    pub(super) parent: u32,
    /// Where in that its corners are: the weights of that one's corners.
    pub(super) weights: [[f32; 3]; 3],
    pub(super) corners: [Point; 3],
    /// Bit `i` is set where the edge from corner `i` to corner `i + 1` bounds the region.
    pub(super) side_edges: u32,
}

/// Refines a region of some cells for sources.
pub(super) async fn refine(coarse: &Cells, brushes: &[Brush]) -> Refined {
    let mut coarsening = 1.0;
    loop {
        let mut cells = coarse.clone();
        if cells.refine(brushes, coarsening).await {
            return cells.refined();
        }
        coarsening *= 1.5;
    }
}

impl Cells {
    /// Bisects all that is too large; `false` where that is too much.
    async fn refine(&mut self, brushes: &[Brush], coarsening: f64) -> bool {
        let most = self.cells.len() + MAX_FINER;
        let mut pace = Pace::default();
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
                pace.work(1).await;
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
        let mut is_too_large = false;
        let most_du = (1.0 + RIM_WIDTH) * brush.radii_du[1] + longest_du / GROWTH;
        brush.for_each_place(middle, most_du, &mut |place| {
            is_too_large |= longest_du > place.radius_du * longest_edge(place, brush.weight);
        });
        is_too_large
    }
}

/// Longest edge that a place of a stroke allows where it is seen from, in radii.
fn longest_edge(Place { distance_du, radius_du }: Place, weight: f64) -> f64 {
    let from_rim = distance_du / radius_du - 1.0;
    let grown = GROWTH * (from_rim.abs() - RIM_WIDTH).max(0.0);
    let edge = (RIM_EDGE[0] + RIM_EDGE[1] / weight.sqrt()).min(LONGEST_EDGE) + grown;
    if from_rim < 0.0 { edge.min(LONGEST_EDGE) } else { edge }
}
