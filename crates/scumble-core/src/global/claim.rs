//! What one scribble claims by itself: the triangles that it was drawn on, each at a cost.

use kurbo::Point;

use super::flood::{Cost, cost};
use crate::clearance::distance_to_lines_du;
use crate::planar_map::PlanarMap;
use crate::small_map::SmallMap;
use crate::stroke::Stroke;

/// A scribble holds its place like a passage that is this many times as wide as its distance from the drawn lines:
/// 2 is the widest that could pass there, and more keeps a careful dab near a line from being flooded.
const HOLD: f64 = 4.0;

/// A room counts as meant once the scribble has as many samples there as this part of those in the room where it has
/// most so far: less is a hand that slipped.
const MEANT: f64 = 0.25;

/// The samples of a scribble so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Claim {
    stroke: Stroke,
    /// Number of samples in the room that has most.
    most: usize,
    /// Per room the samples there.
    visits: SmallMap<Visit>,
    seeds: Vec<Seed>,
}

/// A triangle, and what it costs to claim it.
pub(super) type Seed = (usize, Cost);

/// The samples in one room.
#[derive(Clone, Debug, Default)]
struct Visit {
    sample_count: usize,
    is_meant: bool,
    /// Held back until the room is meant.
    held_back: Vec<Seed>,
}

impl Claim {
    /// The points that have been followed.
    pub(super) fn points(&self) -> &[Point] {
        self.stroke.points()
    }

    /// All triangles claimed so far.
    pub(super) fn seeds(&self) -> &[Seed] {
        &self.seeds
    }

    /// Goes on to the end of a scribble that begins with the points followed so far, and gives what that adds.
    pub(super) fn follow(&mut self, map: &PlanarMap, rooms: &[u32], points: &[Point]) -> &[Seed] {
        let known = self.seeds.len();
        let Self { stroke, most, visits, seeds } = self;
        stroke.follow(map, points, |p, triangle| {
            let visit = visits.entry(rooms[triangle]);
            visit.sample_count += 1;
            *most = visit.sample_count.max(*most);
            visit.is_meant |= visit.sample_count as f64 >= MEANT * *most as f64;
            visit.held_back.push((triangle, cost(0.0, HOLD * distance_to_lines_du(map, p, triangle))));
            if visit.is_meant {
                seeds.append(&mut visit.held_back);
            }
        });
        &self.seeds[known..]
    }
}
