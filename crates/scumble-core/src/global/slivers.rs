//! Slivers: regions so thin that they are no more than the seam between two lines of a sketch. Those that no scribble reaches
//! take the colour beside them, across a line.
//!
//! Each is one room, however narrow it is at places, and is entered from one other room alone: else a scribble that is drawn on
//! its other side could give it to one that was there before. Of those that are no slivers that is the one that it borders on for
//! longest, if it is more than beside its ends: else what is around a hatching would run on from strip to strip, or into the ends
//! of all. So a sliver that has slivers on both of its sides, as where an outline was drawn four times, has no colour.
//!
//! The inside of a single line, such as the ear of a hare, is thin by itself, and what leads out by a gap is part of what lies
//! there: neither is a sliver.

use super::flood::Passage;
use super::halls::Groups;
use super::pockets;
use crate::pace;
use crate::planar_map::PlanarMap;
use crate::sort;
use crate::triangulation::HalfEdge;

/// Beside their ink, slivers are less wide than that of a line, and than this, in du.
const WIDEST_DU: f64 = 2.0;

/// A sliver is entered from a room that it borders on along more than this part of its border: more than one side of a square.
const ENTRANCE: f64 = 0.26;

/// A side of a piece of line: the key of the region that it faces, by one of its rooms, and the room beyond; and its half-edge.
type Border = (u64, u32);

/// Makes one room of each sliver, given the room of each triangle, as if there were no gaps within it, and opens the half-edges
/// that lead into it, which come to those in gaps. No dab on a line is meant for it.
pub(super) async fn join(
    map: &PlanarMap,
    gaps: &mut Vec<HalfEdge>,
    passages: &mut [Passage],
    room_of: &mut [u32],
    are_clear: &mut [bool],
) {
    let doors = pockets::doors(map, gaps, room_of, &|_, _| true);
    let regions = Groups::new(&doors, &pockets::areas_du2(map, room_of, are_clear.len()));
    pace::pause().await;
    let borders = borders(map, &regions, room_of);
    pace::pause().await;
    let mut of_slivers: Vec<_> = borders.chunk_by(|a, b| region(a) == region(b)).collect();
    of_slivers.retain(|borders| is_sliver(map, &regions, borders));
    let mut slivers = Slivers { are_slivers: vec![false; are_clear.len()], regions };
    of_slivers.iter().for_each(|borders| slivers.are_slivers[region(&borders[0])] = true);
    for borders in of_slivers {
        let entrance = slivers.entrance(map, borders).iter();
        for h in entrance.filter_map(|&(_, h)| map.refined().twin(HalfEdge(h))) {
            passages[h.index()] = Passage::Open;
            gaps.push(h);
        }
    }
    pace::pause().await;
    slivers.make_rooms(map, passages, room_of, are_clear);
}

/// Which regions are slivers.
struct Slivers {
    regions: Groups,
    /// Per room that stands for a region.
    are_slivers: Vec<bool>,
}

impl Slivers {
    /// Whether a room is part of one.
    fn have(&self, room: u32) -> bool {
        self.are_slivers[self.regions.of_rooms[room as usize] as usize]
    }

    /// Of the borders of a sliver those with the room that it is entered from.
    fn entrance<'a>(&self, map: &PlanarMap, borders: &'a [Border]) -> &'a [Border] {
        let all_du = |borders: &[Border]| borders.iter().map(|border| length_du(map, border)).sum::<f64>();
        let (mut longest, mut longest_du) = (&borders[..0], ENTRANCE * all_du(borders));
        for with_one in
            borders.chunk_by(|a, b| a.0 == b.0).filter(|with_one| !self.have(beyond(&with_one[0])))
        {
            let with_one_du = all_du(with_one);
            if longest_du < with_one_du {
                (longest, longest_du) = (with_one, with_one_du);
            }
        }
        longest
    }

    fn make_rooms(
        &self,
        map: &PlanarMap,
        passages: &mut [Passage],
        room_of: &mut [u32],
        are_clear: &mut [bool],
    ) {
        for (triangle, room) in room_of.iter_mut().enumerate().filter(|(_, room)| self.have(**room)) {
            *room = self.regions.of_rooms[*room as usize];
            are_clear[*room as usize] = false;
            for h in (0..3).map(|i| HalfEdge::of(triangle, i)).filter(|&h| map.refined().gap(h).is_some()) {
                passages[h.index()] = Passage::Plain;
            }
        }
    }
}

/// All borders of regions within the page with others, in ascending order.
fn borders(map: &PlanarMap, regions: &Groups, room_of: &[u32]) -> Vec<Border> {
    let mesh = map.refined();
    let mut borders = Vec::new();
    for h in mesh.half_edges() {
        let Some(twin) = mesh.side(h).and(mesh.twin(h)) else { continue };
        let [room, beyond] = [h, twin].map(|h| room_of[h.triangle()]);
        if regions.area_du2(room).is_finite() && !regions.hold([room, beyond]) {
            borders.push((sort::pair([regions.of_rooms[room as usize], beyond]), h.0));
        }
    }
    sort::sort(&mut borders);
    borders
}

fn region(border: &Border) -> usize {
    (border.0 >> 32) as usize
}

fn beyond(border: &Border) -> u32 {
    border.0 as u32
}

/// Whether a region with such borders is a sliver: thin, and not beside one other region alone.
fn is_sliver(map: &PlanarMap, regions: &Groups, borders: &[Border]) -> bool {
    let mut others = borders.iter().map(|border| regions.of_rooms[beyond(border) as usize]);
    let first = others.next();
    regions.area_du2(region(&borders[0]) as u32) < borders.iter().map(|border| ink_du2(map, border)).sum()
        && others.any(|other| Some(other) != first)
}

/// What a line has of a region along a piece by its ink, and what of it may be clear besides, by half of each.
fn ink_du2(map: &PlanarMap, border: &Border) -> f64 {
    let half_du = |node| map.half_width_du(node).unwrap_or(0.0);
    let [a, b] = map.refined().ends(HalfEdge(border.1)).map(half_du);
    length_du(map, border) * (a.min(b) + a.min(b).min(0.5 * WIDEST_DU))
}

fn length_du(map: &PlanarMap, border: &Border) -> f64 {
    let [a, b] = map.refined().segment(HalfEdge(border.1));
    (b - a).hypot()
}
