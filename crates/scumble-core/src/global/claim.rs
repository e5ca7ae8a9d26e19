//! What one scribble claims by itself: the triangles that it was drawn on, each at a cost.

use kurbo::Point;

use super::flood::{Cost, cost, length};
use crate::clearance::{OPEN_DU, distance_to_lines_du};
use crate::planar_map::PlanarMap;
use crate::small_map::SmallMap;
use crate::stroke::Stroke;

/// A scribble holds its place like a passage that is this many times as wide as its distance from the drawn lines. With
/// less, the scribble furthest from all lines takes a room for itself (which is better on drawings whose lights and
/// shadows no line marks); with more, a hand that leaves its region takes another.
const HOLD: f64 = 3.0;

/// What lies around a sample within this many times its distance from the drawn lines is at hand, and [`BESIDE_DU`]
/// more: the nearest line is, so that a careful dab near a line has its say. Where two meet, the one that was drawn in
/// the open has that much of a start. With 1 every dab would keep its place; more takes from a dab what lies between it
/// and another in the open, and parts a room better on the quality set.
const AT_HAND: f64 = 1.5;

/// At hand around any sample, in du: about a triangle of the refined mesh.
const BESIDE_DU: f64 = 12.0;

/// More than any start, in du.
const LONGEST_START_DU: f64 = AT_HAND * OPEN_DU;

/// A room counts as meant once the scribble has as many samples there as this part of those in the room where it has
/// most so far: less is a hand that slipped. So the first room always does, and no claim is ever given up while the
/// scribble grows.
const MEANT: f64 = 0.25;

/// The samples of a scribble so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Claim {
    stroke: Stroke,
    /// Of the refined mesh, where the last sample lies.
    triangle: usize,
    /// Number of samples in the room that has most.
    most: usize,
    /// Per room the samples there.
    visits: SmallMap<Visit>,
    seeds: Vec<Seed>,
}

/// Where a sample lies, and what it costs to claim it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Seed {
    pub(super) triangle: usize,
    /// In the flood over all the map.
    pub(super) cost: Cost,
    /// In the flood over what is at hand; see [`at_hand_limit`].
    pub(super) at_hand: Cost,
}

impl Seed {
    fn new(triangle: usize, distance_du: f64) -> Self {
        let start_du = AT_HAND * distance_du.clamp(0.0, OPEN_DU);
        let at_hand = length(LONGEST_START_DU - start_du);
        Self { triangle, cost: cost(0.0, HOLD * distance_du), at_hand }
    }
}

/// What a seed's claim and the way from there may come to for a place to be at hand.
pub(super) fn at_hand_limit() -> Cost {
    length(LONGEST_START_DU + BESIDE_DU)
}

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

    /// The rooms that are meant.
    pub(super) fn rooms(&self) -> impl Iterator<Item = u32> {
        self.visits.iter().filter(|(_, visit)| visit.is_meant).map(|(room, _)| *room)
    }

    /// All triangles claimed so far.
    pub(super) fn seeds(&self) -> &[Seed] {
        &self.seeds
    }

    /// Goes on to the end of a scribble that begins with the points followed so far, and gives what that adds.
    pub(super) fn follow(&mut self, map: &PlanarMap, room_of: &[u32], points: &[Point]) -> &[Seed] {
        let known = self.seeds.len();
        let Self { stroke, triangle, most, visits, seeds } = self;
        stroke.follow(map, points, |p, base| {
            *triangle = map.refined().locate(p, *triangle).unwrap_or(*triangle);
            let visit = visits.entry(room_of[*triangle]);
            visit.sample_count += 1;
            *most = visit.sample_count.max(*most);
            visit.is_meant |= visit.sample_count as f64 >= MEANT * *most as f64;
            visit.held_back.push(Seed::new(*triangle, distance_to_lines_du(map, p, base)));
            if visit.is_meant {
                seeds.append(&mut visit.held_back);
            }
        });
        &self.seeds[known..]
    }
}
