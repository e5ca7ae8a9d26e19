//! Closed shapes: regions of the map with lines all around, so that nothing runs out of them onto the page.
//!
//! Once colours have half of one, they have its corners too, behind whatever gap: nobody leaves a hole between a loose
//! scale and the outline of a fish. A larger room behind a narrow gap may well be a thing of its own.

use super::pockets::{Door, doors};
use crate::planar_map::PlanarMap;
use crate::triangulation::HalfEdge;

/// Colours have the corners of a shape once they have more than this part of its area.
const MOSTLY: f64 = 0.5;

/// A corner has less than this part of the area of its shape.
const CORNER: f64 = 1.0 / 6.0;

/// The closed shapes of a map.
#[derive(Clone, Debug)]
pub(super) struct Shapes {
    /// Per room its shape; none where the border of the page is reached without crossing a line.
    of_rooms: Vec<Option<u32>>,
    /// Per room the part of its shape that it has.
    parts: Vec<f64>,
    /// Between rooms of one shape, in ascending order.
    doors: Vec<Door>,
}

impl Shapes {
    /// The shapes that rooms of these areas make up, by the regions of the mesh; the area of a room at the border of the page has no bound.
    pub(super) fn new(
        map: &PlanarMap,
        gaps: &[HalfEdge],
        room_of: &[u32],
        (region_of, region_count): (Vec<u32>, usize),
        areas_du2: &[f64],
    ) -> Self {
        let mut regions = vec![0; areas_du2.len()];
        room_of.iter().zip(region_of).for_each(|(&room, region)| regions[room as usize] = region as usize);
        let mut regions_du2 = vec![0.0; region_count];
        regions.iter().zip(areas_du2).for_each(|(&region, area_du2)| regions_du2[region] += area_du2);
        let parts = regions.iter().zip(areas_du2).map(|(&region, area_du2)| area_du2 / regions_du2[region]);
        let shape = |&region: &usize| regions_du2[region].is_finite().then_some(region as u32);
        let of_rooms: Vec<_> = regions.iter().map(shape).collect();
        let doors = doors(map, gaps, room_of, |_, [from, to]| {
            let [from, to] = [from, to].map(|room| of_rooms[room as usize]);
            from.is_some() && from == to
        });
        Self { parts: parts.collect(), of_rooms, doors }
    }

    /// Whether a room is in a closed shape.
    pub(super) fn contains(&self, room: u32) -> bool {
        self.of_rooms[room as usize].is_some()
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
