//! Pockets: small rooms beside what a colour has already, behind a gap so wide that a person hardly sees it as the end
//! of a shape. The space between the scales of a fish is one, or that between the rays of its fin.
//!
//! A gap that a line's tip points across, so that hardly any of its width counts, is as good as an end: no pocket lies
//! behind it. The others are *plain*.
//!
//! A colour takes those pockets first that are small beside the rooms that it was drawn in, then those that are small
//! beside all that it has by then. So a stroke or two fill a body, and a leaf still does not run out onto the page: what
//! is as open to the border of the page as to what is within is no pocket of that. From the border itself a colour goes
//! through wide gaps, but no further: how large the place is that it comes from, nobody knows. Only where a plain gap
//! lies between a line and the border, it goes on along that, as the sky does behind what stands before it.
//!
//! A narrow gap opens only for the corners of a closed shape. Through a crevice, a tiny room between the ends of lines, colours
//! go no further.
//!
//! Rooms that hang together through wide gaps, none of them open to the border, are a [hall](Halls). Once colours have most of
//! one, they have all of it. Where lines are all around, a part of it is enough.
//!
//! No colour ever takes less after another scribble was drawn, of whatever colour: only one that is drawn on may turn out
//! not to mean a room. Where two may go into a room, the flood decides.

use std::mem;
use std::ops::Range;

use super::halls::{Groups, Halls};
use super::shapes::Shapes;
use crate::pace::{self, Pace};
use crate::planar_map::{Gap, PlanarMap};
use crate::sets::Sets;
use crate::sort;
use crate::triangulation::HalfEdge;

/// A pocket has less than this part of the area that the colour beside it has already.
const POCKET: f64 = 0.5;

/// A room smaller than this, in du², is a crevice between the ends of lines: no colour goes on through its slight gaps, or a crown
/// would run out beside its trunk.
const CREVICE_DU2: f64 = 8.0;

/// What a colour has is set up for so many rooms in the time that one takes that it comes to.
const ROOMS: usize = 16;

/// From a room to one behind a gap.
pub(super) type Door = [u32; 2];

/// The rooms of a map, and the gaps between them.
#[derive(Clone, Debug)]
pub(super) struct Rooms {
    /// Without bound where a room reaches the border of the page, and nobody knows how far it goes on.
    areas_du2: Vec<f64>,
    /// Whether a wide gap leads to such a room, or it is one.
    are_beside_border: Vec<bool>,
    /// Through wide gaps, in ascending order.
    doors: Vec<Door>,
    /// Those that a colour may go on through by itself, in ascending order.
    plain_doors: Vec<Door>,
    /// Those that are tight, then all.
    halls: [Halls; 2],
    shapes: Shapes,
    /// What each colour had at the last call.
    grown: Vec<Grown>,
}

/// What a colour has.
#[derive(Clone, Debug)]
struct Grown {
    /// The rooms that it was drawn in, in ascending order.
    drawn: Vec<u32>,
    rooms: Vec<u32>,
    /// The wide doors that it goes through, by their places in the list of all.
    doors: Vec<u32>,
}

impl Rooms {
    /// The rooms that the triangles of the refined mesh belong to, and the half-edges in gaps between them; per room whether not
    /// all of it lies under the ink of lines, and it is no sliver.
    pub(super) async fn new(map: &PlanarMap, gaps: &[HalfEdge], room_of: &[u32], are_clear: &[bool]) -> Self {
        let areas_du2 = areas_du2(map, room_of, are_clear.len());
        pace::pause().await;
        let is_crevice = |room: u32| areas_du2[room as usize] < CREVICE_DU2;
        let leads = |h: &HalfEdge| {
            gap_and_door(map, room_of, *h)
                .is_some_and(|(gap, door)| !(gap.is_slight && door.into_iter().any(is_crevice)))
        };
        let ways: Vec<_> = gaps.iter().copied().filter(leads).collect();
        let doors = doors(map, &ways, room_of, &|gap, _| gap.is_wide);
        let is_within = |door: Door| !door.iter().all(|&room| areas_du2[room as usize].is_infinite());
        let is_plain = |gap: &Gap, door| gap.is_plain && (map.is_at_border(&gap.nodes) || is_within(door));
        let plain_doors = self::doors(map, &ways, room_of, &is_plain);
        pace::pause().await;
        let mut are_beside_border: Vec<bool> =
            areas_du2.iter().map(|area_du2| area_du2.is_infinite()).collect();
        for &[from, to] in &doors {
            are_beside_border[from as usize] |= areas_du2[to as usize].is_infinite();
        }
        let is_inner = |door: Door| !door.iter().any(|&room| are_beside_border[room as usize]);
        let [unparted, all] = [false, true].map(|is_parted| {
            let leads = |gap: &Gap, door| gap.is_wide && is_inner(door) && (is_parted || !gap.is_slight);
            Groups::new(&self::doors(map, &ways, room_of, &leads), &areas_du2)
        });
        let shapes = Shapes::new(map, gaps, room_of, are_clear, &areas_du2);
        let all = Halls::new(all, &unparted, &shapes.are_closed);
        let halls = [Halls::tight(unparted, map, gaps, room_of), all];
        Self { areas_du2, are_beside_border, doors, plain_doors, halls, shapes, grown: Vec::new() }
    }

    /// The doors that colours go through, in ascending order; `drawn` are pairs of a kind of scribble, one for each
    /// colour, and a room that it was drawn in, in ascending order.
    pub(super) async fn open_doors(&mut self, drawn: &[[u32; 2]]) -> Vec<Door> {
        self.grow(drawn).await;
        let mut are_taken = vec![false; self.areas_du2.len()];
        let mut are_open = vec![false; self.doors.len()];
        for grown in &self.grown {
            grown.rooms.iter().for_each(|&room| are_taken[room as usize] = true);
            grown.doors.iter().for_each(|&door| are_open[door as usize] = true);
        }
        let mut are_filled = vec![false; are_taken.len()];
        for halls in &self.halls {
            halls.fill(&self.areas_du2, &are_taken, &mut are_filled);
            are_taken.iter_mut().zip(&are_filled).for_each(|(is_taken, is_filled)| *is_taken |= is_filled);
        }
        let is_filled = |door: Door| door.iter().all(|&room| are_filled[room as usize]);
        let is_within = |door: Door| self.halls[1].groups.hold(door) && is_filled(door);
        let doors = self.doors.iter().copied().zip(are_open);
        let open = doors.filter(|&(door, is_open)| is_open || is_within(door));
        let mut open: Vec<Door> = open.map(|(door, _)| door).collect();
        open.extend(self.shapes.corner_doors(&are_taken));
        sorted(open)
    }

    /// Finds what the colours have, but for those that were drawn in the same rooms at the last call.
    async fn grow(&mut self, drawn: &[[u32; 2]]) {
        let same_color = |first: &[u32; 2], second: &[u32; 2]| first[0] == second[0];
        let mut before = mem::take(&mut self.grown);
        let (mut grown, mut pace) = (Vec::new(), Pace::default());
        for color in drawn.chunk_by(same_color) {
            let drawn: Vec<_> = color.iter().map(|&[_, room]| room).collect();
            match before.iter().position(|before| before.drawn == drawn) {
                Some(i) => grown.push(before.swap_remove(i)),
                None => {
                    grown.push(Taken::new(self).grown(drawn));
                    pace.work(1 + self.areas_du2.len() / ROOMS).await;
                }
            }
        }
        self.grown = grown;
    }

    /// The area of a room, in du²; without bound at the border of the page.
    pub(super) fn area_du2(&self, room: u32) -> f64 {
        self.areas_du2[room as usize]
    }

    pub(super) fn is_at_border(&self, room: u32) -> bool {
        self.area_du2(room).is_infinite()
    }
}

/// The rooms on this side of a half-edge and on the other, if it is part of a gap, with that.
fn gap_and_door<'a>(map: &'a PlanarMap, room_of: &[u32], h: HalfEdge) -> Option<(&'a Gap, Door)> {
    let mesh = map.refined();
    let gap = &map.gaps()[mesh.gap(h)? as usize];
    let twin = mesh.passage(h)?;
    Some((gap, [h, twin].map(|h| room_of[h.triangle()])))
}

/// The rooms on this side of a half-edge and on the other, if it is part of a gap.
pub(super) fn door(map: &PlanarMap, room_of: &[u32], h: HalfEdge) -> Option<Door> {
    gap_and_door(map, room_of, h).map(|(_, door)| door)
}

/// From room to room through the gaps of some kind, in ascending order; by all half-edges in gaps.
pub(super) fn doors(
    map: &PlanarMap,
    gaps: &[HalfEdge],
    room_of: &[u32],
    is_kind: &dyn Fn(&Gap, Door) -> bool,
) -> Vec<Door> {
    let all = gaps.iter().filter_map(|&h| gap_and_door(map, room_of, h));
    sorted(all.filter(|&(gap, door)| is_kind(gap, door)).map(|(_, door)| door).collect())
}

/// In ascending order, each once.
fn sorted(mut doors: Vec<Door>) -> Vec<Door> {
    sort::sort_copies_by_key(&mut doors, |&door| sort::pair(door));
    doors.dedup();
    doors
}

/// Where those of the doors, in ascending order, are that lead from a room.
fn doors_of(doors: &[Door], room: u32) -> Range<usize> {
    let start = doors.partition_point(|&[from, _]| from < room);
    let count = doors[start..].partition_point(|&[from, _]| from == room);
    start..start + count
}

/// Per room its area, in du²; without bound at the border of the page.
pub(super) fn areas_du2(map: &PlanarMap, room_of: &[u32], room_count: usize) -> Vec<f64> {
    let mesh = map.refined();
    let mut areas_du2 = vec![0.0; room_count];
    for (triangle, &room) in room_of.iter().enumerate() {
        let [a, b, c] = mesh.corners(triangle);
        let is_at_border = (0..3).any(|i| mesh.twin(HalfEdge::of(triangle, i)).is_none());
        areas_du2[room as usize] += if is_at_border { f64::INFINITY } else { 0.5 * (b - a).cross(c - a) };
    }
    areas_du2
}

/// The rooms that a colour has: those within the page hang together through wide gaps, and count as one.
struct Taken<'a> {
    rooms: &'a Rooms,
    taken: Vec<u32>,
    is_taken: Vec<bool>,
    groups: Sets,
    /// Per room that stands for a group.
    areas_du2: Vec<f64>,
}

impl<'a> Taken<'a> {
    fn new(rooms: &'a Rooms) -> Self {
        let areas_du2 = rooms.areas_du2.clone();
        let count = areas_du2.len();
        Self { rooms, taken: Vec::new(), is_taken: vec![false; count], groups: Sets::new(count), areas_du2 }
    }

    /// What a colour has that was drawn in some rooms.
    fn grown(mut self, drawn: Vec<u32>) -> Grown {
        drawn.iter().for_each(|&room| self.add(room));
        self.grow();
        let doors = self.taken.iter().flat_map(|&room| doors_of(&self.rooms.doors, room));
        let doors =
            doors.filter(|&door| self.leads(self.rooms.doors[door])).map(|door| door as u32).collect();
        Grown { drawn, doors, rooms: self.taken }
    }

    fn add(&mut self, room: u32) {
        self.taken.push(room);
        self.is_taken[room as usize] = true;
        for &[_, beside] in &self.rooms.doors[doors_of(&self.rooms.doors, room)] {
            if self.is_taken[beside as usize] && ![room, beside].iter().any(|&at| self.rooms.is_at_border(at))
            {
                let [from, to] = [room, beside].map(|room| self.groups.find(room));
                if from != to {
                    self.groups.join(from, to);
                    self.areas_du2[to as usize] += self.areas_du2[from as usize];
                }
            }
        }
    }

    /// Takes pockets until there are none left.
    fn grow(&mut self) {
        let mut known = 0;
        while known < self.taken.len() {
            known = self.taken.len();
            let mut next = 0;
            while let Some(&room) = self.taken.get(next) {
                for &[_, beside] in &self.rooms.plain_doors[doors_of(&self.rooms.plain_doors, room)] {
                    if self.goes_on(room, beside) {
                        self.add(beside);
                    }
                }
                next += 1;
            }
        }
    }

    /// Whether the colour goes on through a plain door: from page to page, or into a pocket.
    fn goes_on(&mut self, room: u32, beside: u32) -> bool {
        let [is_at_border, is_beside_at_border] = [room, beside].map(|room| self.rooms.is_at_border(room));
        let is_page = is_at_border && is_beside_at_border;
        !self.is_taken[beside as usize] && (is_page || !is_at_border && self.is_pocket(room, beside))
    }

    fn is_pocket(&mut self, room: u32, beside: u32) -> bool {
        let group = self.groups.find(room) as usize;
        !self.rooms.are_beside_border[beside as usize]
            && self.rooms.areas_du2[beside as usize] < POCKET * self.areas_du2[group]
    }

    /// Whether the colour goes through a wide door from one of its rooms.
    fn leads(&self, [from, to]: Door) -> bool {
        let is_from_border = self.rooms.is_at_border(from) && !self.rooms.is_at_border(to);
        self.is_taken[to as usize] || is_from_border
    }
}
