//! What one scribble claims by itself: the triangles that it was drawn on, each at a cost.

use kurbo::Point;

use super::flood::{Cost, cost};
use crate::clearance::distance_to_lines_du;
use crate::planar_map::PlanarMap;
use crate::stroke::Stroke;

/// A scribble holds its place like a passage that is this many times as wide as its distance from the drawn lines:
/// 2 is the widest that could pass there, and more keeps a careful dab near a line from being flooded.
const HOLD: f64 = 4.0;

/// The samples of a scribble so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Claim {
    stroke: Stroke,
    seeds: Vec<(usize, Cost)>,
}

impl Claim {
    /// The points that have been followed.
    pub(super) fn points(&self) -> &[Point] {
        self.stroke.points()
    }

    /// All triangles claimed so far.
    pub(super) fn seeds(&self) -> &[(usize, Cost)] {
        &self.seeds
    }

    /// Goes on to the end of a scribble that begins with the points followed so far, and gives what that adds.
    pub(super) fn follow(&mut self, map: &PlanarMap, points: &[Point]) -> &[(usize, Cost)] {
        let (known, seeds) = (self.seeds.len(), &mut self.seeds);
        self.stroke.follow(map, points, |p, triangle| {
            seeds.push((triangle, cost(0.0, HOLD * distance_to_lines_du(map, p, triangle))));
        });
        &self.seeds[known..]
    }
}
