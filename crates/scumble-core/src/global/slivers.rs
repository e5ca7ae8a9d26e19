//! Slivers: regions so thin that they are no more than the seam between two lines of a sketch. Those that no scribble reaches
//! take the colour beside them, across a line.
//!
//! Each is one room, however narrow it is at places, and is entered from one other room alone, the largest beside it: else a
//! scribble that is drawn on its other side could give it to one that was there before. The inside of a single line, such as the
//! ear of a hare, is thin by itself, and what leads out by a gap is part of what lies there: neither is a sliver.

use super::flood::{NONE, Passage};
use super::halls::Groups;
use super::pockets;
use crate::planar_map::PlanarMap;
use crate::triangulation::HalfEdge;

/// Beside their ink, slivers are less wide than that of a line, and than this, in du.
const WIDEST_DU: f64 = 2.0;

/// All that hangs together through gaps.
#[derive(Clone)]
struct Region {
    /// What is left of it without the ink of lines, and as much clear as a sliver may have beside that.
    rest_du2: f64,
    /// One of those beside it.
    other: u32,
    /// Whether there are more.
    is_between: bool,
    /// The largest room beside it, and how large that is.
    entrance: u32,
    entrance_du2: f64,
}

impl Region {
    fn is_sliver(&self) -> bool {
        self.is_between && self.rest_du2 < 0.0
    }
}

/// Makes one room of each sliver, given the room of each triangle, as if there were no gaps within it, and opens the half-edges
/// that lead into it, which come to those in gaps.
pub(super) fn join(
    map: &PlanarMap,
    gaps: &mut Vec<HalfEdge>,
    passages: &mut [Passage],
    room_of: &mut [u32],
    count: usize,
) {
    let mesh = map.refined();
    let rooms_du2 = pockets::areas_du2(map, room_of, count);
    let Groups { of_rooms, areas_du2 } =
        Groups::new(&pockets::doors(map, gaps, room_of, &|_, _| true), &rooms_du2);
    let region = |&rest_du2: &f64| Region {
        rest_du2,
        other: NONE,
        is_between: false,
        entrance: NONE,
        entrance_du2: 0.0,
    };
    let mut regions: Vec<_> = areas_du2.iter().map(region).collect();
    let mut ways = Vec::new();
    for h in mesh.half_edges() {
        let Some(from) = mesh.side(h).and(mesh.twin(h)) else { continue };
        let [room, beside] = [h, from].map(|h| room_of[h.triangle()]);
        let [own, other] = [room, beside].map(|room| of_rooms[room as usize]);
        let region = &mut regions[own as usize];
        region.rest_du2 -= ink_du2(map, h);
        if own != other {
            region.is_between |= ![NONE, other].contains(&region.other);
            region.other = other;
            if rooms_du2[beside as usize] > region.entrance_du2 {
                (region.entrance, region.entrance_du2) = (beside, rooms_du2[beside as usize]);
            }
            ways.push((own, beside, from));
        }
    }
    for (own, beside, from) in ways {
        if regions[own as usize].is_sliver() && regions[own as usize].entrance == beside {
            passages[from.index()] = Passage::Open;
            gaps.push(from);
        }
    }
    for (triangle, room) in room_of.iter_mut().enumerate() {
        let own = of_rooms[*room as usize];
        if regions[own as usize].is_sliver() {
            *room = own;
            for h in (0..3).map(|i| HalfEdge::of(triangle, i)).filter(|&h| mesh.gap(h).is_some()) {
                passages[h.index()] = Passage::Plain;
            }
        }
    }
}

/// What a line has of a region along a piece by its ink, and what of it may be clear besides, by half of each.
fn ink_du2(map: &PlanarMap, h: HalfEdge) -> f64 {
    let [a, b] = map.refined().segment(h);
    let widths_du = map.refined().ends(h).map(|node| map.half_width_du(node).unwrap_or(0.0));
    let half_du = widths_du[0].min(widths_du[1]);
    (b - a).hypot() * (half_du + half_du.min(0.5 * WIDEST_DU))
}
