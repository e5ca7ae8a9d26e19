//! Halls: rooms that hang together. Once colours have enough of one, they have all of it: nobody leaves a hole.

use super::pockets::{Door, doors};
use crate::planar_map::{Gap, PlanarMap};
use crate::sets::Sets;
use crate::triangulation::HalfEdge;

/// Colours have a hall once they have more than this part of its area.
const HALL: f64 = 0.5;

/// The same where slight gaps part it: what lies behind one may well be a thing of its own.
const PARTED_HALL: f64 = 0.55;

/// The same where lines are all around, so that nothing runs out onto the page: a stroke on its forehead fills a head, one
/// between two rays a fin. What is smaller still may well have a colour of its own.
const CLOSED_HALL: f64 = 1.0 / 16.0;

/// The same where lines are all around but for gaps that are narrow beside it, as in a house whose corners are open by a hair.
const TIGHT_HALL: f64 = 0.25;

/// A gap is narrow beside a hall if it is no wider than this part of its size, that of a square as large.
const NARROW: f64 = 0.075;

/// Rooms that hang together through some doors.
#[derive(Clone, Debug)]
pub(super) struct Groups {
    /// Per room its group, by one of the rooms in it.
    pub(super) of_rooms: Vec<u32>,
    /// Per room that stands for a group how large that is, in du²; without bound where it reaches the border of the page.
    areas_du2: Vec<f64>,
}

impl Groups {
    /// Those that doors make of rooms of such areas.
    pub(super) fn new(doors: &[Door], rooms_du2: &[f64]) -> Self {
        let mut sets = Sets::new(rooms_du2.len());
        for door in doors {
            let [from, to] = door.map(|room| sets.find(room));
            sets.join(from, to);
        }
        let of_rooms: Vec<_> = (0..rooms_du2.len() as u32).map(|room| sets.find(room)).collect();
        let mut areas_du2 = vec![0.0; rooms_du2.len()];
        of_rooms.iter().zip(rooms_du2).for_each(|(&group, area_du2)| areas_du2[group as usize] += area_du2);
        Self { of_rooms, areas_du2 }
    }

    /// How large the group is that a room is in, in du².
    pub(super) fn area_du2(&self, room: u32) -> f64 {
        self.areas_du2[self.of_rooms[room as usize] as usize]
    }

    /// Whether rooms hang together.
    pub(super) fn hold(&self, [from, to]: Door) -> bool {
        self.of_rooms[from as usize] == self.of_rooms[to as usize]
    }
}

/// Halls, and how much colours must have of each to have all of it.
#[derive(Clone, Debug)]
pub(super) struct Halls {
    pub(super) groups: Groups,
    /// Per room that stands for a hall, the part of its area.
    parts: Vec<f64>,
}

impl Halls {
    /// All, by those that no slight gap parts, and whether lines are all around a room.
    pub(super) fn new(groups: Groups, unparted: &Groups, are_closed: &[bool]) -> Self {
        let part = |(&is_closed, room): (&bool, u32)| match is_closed {
            true => CLOSED_HALL,
            false if unparted.area_du2(room) < groups.area_du2(room) => PARTED_HALL,
            false => HALL,
        };
        let parts = are_closed.iter().zip(0..).map(part).collect();
        Self { groups, parts }
    }

    /// Of those that no slight gap parts, the tight ones; by all gaps.
    pub(super) fn tight(groups: Groups, map: &PlanarMap, gaps: &[HalfEdge], room_of: &[u32]) -> Self {
        let is_open = |gap: &Gap, door: Door| {
            !groups.hold(door) && width_du(map, gap) > NARROW * groups.area_du2(door[0]).sqrt()
        };
        let mut parts = vec![TIGHT_HALL; groups.of_rooms.len()];
        for [room, _] in doors(map, gaps, room_of, &is_open) {
            parts[groups.of_rooms[room as usize] as usize] = f64::INFINITY;
        }
        Self { groups, parts }
    }

    /// Adds the rooms of those halls that colours have, which have these rooms of such areas.
    pub(super) fn fill(&self, rooms_du2: &[f64], are_taken: &[bool], are_filled: &mut [bool]) {
        let Groups { of_rooms, areas_du2 } = &self.groups;
        let mut taken_du2 = vec![0.0; rooms_du2.len()];
        for (room, &hall) in of_rooms.iter().enumerate().filter(|(room, _)| are_taken[*room]) {
            taken_du2[hall as usize] += rooms_du2[room];
        }
        for (is_filled, &hall) in are_filled.iter_mut().zip(of_rooms) {
            let hall = hall as usize;
            *is_filled |= taken_du2[hall] > self.parts[hall] * areas_du2[hall];
        }
    }
}

/// How much the lines at a gap leave of it, in du.
fn width_du(map: &PlanarMap, gap: &Gap) -> f64 {
    let [a, b] = gap.nodes.map(|node| map.triangulation().points()[node as usize]);
    let lines_du: f64 = gap.nodes.iter().filter_map(|&node| map.half_width_du(node)).sum();
    a.distance(b) - lines_du
}
