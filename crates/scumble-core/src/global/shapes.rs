//! Closed shapes: rooms with lines all around, so that nothing runs out of them onto the page. Where a gap is hardly wider than
//! the lines beside it, people do not see that there is one.
//!
//! Once colours have half of one, they have its corners too, behind whatever gap: nobody leaves a hole between a loose
//! scale and the outline of a fish. A larger room behind a narrow gap may well be a thing of its own.

use super::halls::Groups;
use super::pockets::{Door, doors};
use crate::planar_map::{Gap, PlanarMap};
use crate::triangulation::HalfEdge;

/// Colours have the corners of a shape once they have more than this part of its area.
const MOSTLY: f64 = 0.5;

/// A corner has less than this part of the area of its shape.
const CORNER: f64 = 1.0 / 6.0;

/// The closed shapes of a map.
#[derive(Clone, Debug)]
pub(super) struct Shapes {
    /// Per room its shape; none where the border of the page is reached without crossing a line, or a slight gap.
    of_rooms: Vec<Option<u32>>,
    /// Per room whether lines are all around it, without any gap to the border of the page.
    pub(super) are_closed: Vec<bool>,
    /// Per room the part of its shape that it has.
    parts: Vec<f64>,
    /// Between rooms of one shape, but those through slight gaps; in ascending order.
    doors: Vec<Door>,
}

impl Shapes {
    /// The shapes that rooms of these areas make up; the area of a room at the border of the page has no bound. What lies all under
    /// ink, as where two lines meet, belongs to what is around it.
    pub(super) fn new(
        map: &PlanarMap,
        gaps: &[HalfEdge],
        room_of: &[u32],
        are_clear: &[bool],
        areas_du2: &[f64],
    ) -> Self {
        let is_clear = |room: u32| are_clear[room as usize];
        let is_seen = |gap: &Gap, door: Door| !(gap.is_slight && door.into_iter().all(is_clear));
        let rooms = 0..areas_du2.len() as u32;
        let seen = doors(map, gaps, room_of, &is_seen);
        let shapes = Groups::new(&seen, areas_du2);
        let regions = Groups::new(&doors(map, gaps, room_of, &|_, _| true), areas_du2);
        let are_closed = rooms.clone().map(|room| regions.area_du2(room).is_finite()).collect();
        let part = |(room, area_du2): (u32, &f64)| area_du2 / shapes.area_du2(room);
        let parts = rooms.clone().zip(areas_du2).map(part).collect();
        let shape = |room| Some(shapes.of_rooms[room as usize]).filter(|_| shapes.area_du2(room).is_finite());
        let of_rooms: Vec<_> = rooms.map(shape).collect();
        let doors = seen.into_iter().filter(|[from, _]| of_rooms[*from as usize].is_some()).collect();
        Self { of_rooms, are_closed, parts, doors }
    }

    /// The doors into the corners that colours, which have these rooms, do not have yet of shapes that they have for the
    /// most part; in ascending order.
    pub(super) fn corner_doors(&self, are_colored: &[bool]) -> impl Iterator<Item = Door> {
        // There are no more shapes than rooms.
        let mut parts = vec![0.0; self.of_rooms.len()];
        for (room, _) in are_colored.iter().enumerate().filter(|(_, is_colored)| **is_colored) {
            self.of_rooms[room].iter().for_each(|&shape| parts[shape as usize] += self.parts[room]);
        }
        let is_mostly =
            move |room: u32| self.of_rooms[room as usize].is_some_and(|shape| parts[shape as usize] > MOSTLY);
        let is_corner = |room: u32| !are_colored[room as usize] && self.parts[room as usize] < CORNER;
        let leads = move |[from, to]: Door| is_corner(to) && (are_colored[from as usize] || is_corner(from));
        self.doors.iter().copied().filter(move |&door| is_mostly(door[0]) && leads(door))
    }
}
