//! Pockets: small places beside a large one, behind a gap so wide that a person hardly sees it as the end of a shape.
//! The space between the scales of a fish is one, or the corner behind a free end of line. A colour goes into them from
//! the large place, never out of them: so what is scribbled on a body fills it, and a leaf still does not run out onto
//! the page. What is as open to the border of the page is no pocket of anything within.

use crate::planar_map::PlanarMap;
use crate::triangulation::HalfEdge;

/// A pocket has less than this part of the area of the place beside it.
const POCKET: f64 = 0.5;

/// Per half-edge of the refined mesh whether a colour goes through: anywhere but at gaps, and there into pockets.
pub(super) fn open_ways(map: &PlanarMap, room_of: &[u32], room_count: usize) -> Vec<bool> {
    let mesh = map.refined();
    let rooms = Rooms::new(map, room_of, room_count);
    let is_open = |h: HalfEdge| match mesh.passage(h) {
        Some(twin) if mesh.gap(h).is_some() => {
            let [from, to] = [h, twin].map(|h| room_of[h.triangle()] as usize);
            is_wide_gap(map, h) && rooms.is_pocket(to, from)
        }
        _ => true,
    };
    mesh.half_edges().map(is_open).collect()
}

fn is_wide_gap(map: &PlanarMap, h: HalfEdge) -> bool {
    map.refined().gap(h).is_some_and(|gap| map.gaps()[gap as usize].is_wide)
}

/// What tells pockets from other rooms.
struct Rooms {
    /// Without bound where a room reaches the border of the page, and nobody knows how far it goes on.
    areas_du2: Vec<f64>,
    /// Whether a wide gap leads to such a room.
    are_beside_border: Vec<bool>,
}

impl Rooms {
    fn new(map: &PlanarMap, room_of: &[u32], room_count: usize) -> Self {
        let mesh = map.refined();
        let mut rooms = Self { areas_du2: vec![0.0; room_count], are_beside_border: vec![false; room_count] };
        for (triangle, &room) in room_of.iter().enumerate() {
            let [a, b, c] = mesh.corners(triangle);
            let is_at_border = (0..3).any(|i| mesh.twin(HalfEdge::of(triangle, i)).is_none());
            let area_du2 = if is_at_border { f64::INFINITY } else { 0.5 * (b - a).cross(c - a) };
            rooms.areas_du2[room as usize] += area_du2;
        }
        for h in mesh.half_edges().filter(|&h| is_wide_gap(map, h)) {
            let is_border = |twin: HalfEdge| rooms.areas_du2[room_of[twin.triangle()] as usize].is_infinite();
            rooms.are_beside_border[room_of[h.triangle()] as usize] |= mesh.passage(h).is_some_and(is_border);
        }
        rooms
    }

    fn is_pocket(&self, room: usize, beside: usize) -> bool {
        self.areas_du2[room] < POCKET * self.areas_du2[beside]
            && (self.areas_du2[beside].is_infinite() || !self.are_beside_border[room])
    }
}
