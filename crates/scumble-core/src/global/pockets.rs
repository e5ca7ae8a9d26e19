//! Pockets: small rooms beside what a colour has already, behind a gap so wide that a person hardly sees it as the end
//! of a shape. The space between the scales of a fish is one, or that between the rays of its fin.
//!
//! A colour takes those first that are small beside the rooms that it was drawn in, then those that are small beside
//! all that it has by then. So a stroke or two fill a body, and a leaf still does not run out onto the page: what is as
//! open to the border of the page as to what is within is no pocket of that. From the border itself a colour goes
//! through wide gaps, but no further: how large the place is that it comes from, nobody knows.
//!
//! Rooms that hang together through wide gaps, none of them open to the border, are a *hall*. Once colours have most of
//! one, they have all of it: nobody leaves a hole.
//!
//! No colour ever takes less after more was drawn, of whatever colour. Where two may go into a room, the flood decides.

use crate::planar_map::PlanarMap;
use crate::sets::Sets;
use crate::sort;
use crate::triangulation::HalfEdge;

/// A pocket has less than this part of the area that the colour beside it has already.
const POCKET: f64 = 0.5;

/// From a room to one behind a wide gap.
type Door = [u32; 2];

/// The rooms of a map, and the wide gaps between them.
#[derive(Clone, Debug)]
pub(super) struct Rooms {
    /// Without bound where a room reaches the border of the page, and nobody knows how far it goes on.
    areas_du2: Vec<f64>,
    /// Whether a wide gap leads to such a room, or it is one.
    are_beside_border: Vec<bool>,
    /// In ascending order.
    doors: Vec<Door>,
    /// Per room its hall, by one of the rooms in it.
    hall_of: Vec<u32>,
}

impl Rooms {
    /// The rooms that the triangles of the refined mesh belong to.
    pub(super) fn new(map: &PlanarMap, room_of: &[u32], room_count: usize) -> Self {
        let areas_du2 = areas_du2(map, room_of, room_count);
        let mut doors: Vec<Door> =
            map.refined().half_edges().filter_map(|h| wide_gap(map, room_of, h)).collect();
        sort::sort_copies_by_key(&mut doors, |&door| sort::pair(door));
        doors.dedup();
        let mut are_beside_border: Vec<bool> =
            areas_du2.iter().map(|area_du2| area_du2.is_infinite()).collect();
        for &[from, to] in &doors {
            are_beside_border[from as usize] |= areas_du2[to as usize].is_infinite();
        }
        let hall_of = halls(&are_beside_border, &doors);
        Self { areas_du2, are_beside_border, doors, hall_of }
    }

    /// The doors that colours go through, in ascending order; `drawn` are pairs of a colour and a room that it was drawn
    /// in, in ascending order.
    pub(super) fn open_doors(&self, drawn: &[[u32; 2]]) -> Vec<Door> {
        let same_color = |first: &[u32; 2], second: &[u32; 2]| first[0] == second[0];
        let mut open = Vec::new();
        let mut are_taken = vec![false; self.areas_du2.len()];
        for rooms in drawn.chunk_by(same_color) {
            let mut taken = Taken::new(self);
            rooms.iter().for_each(|&[_, room]| taken.add(room));
            taken.grow();
            open.extend(self.doors.iter().filter(|&&door| taken.leads(door)));
            taken.taken.iter().for_each(|&room| are_taken[room as usize] = true);
        }
        let are_colored = self.colored_halls(&are_taken);
        let is_within = |&&[from, to]: &&Door| {
            let [from, to] = [from, to].map(|room| self.hall_of[room as usize]);
            from == to && are_colored[from as usize]
        };
        open.extend(self.doors.iter().filter(is_within));
        sort::sort_copies_by_key(&mut open, |&door| sort::pair(door));
        open.dedup();
        open
    }

    /// Per room that stands for a hall whether most of the hall is taken.
    fn colored_halls(&self, are_taken: &[bool]) -> Vec<bool> {
        let mut free_du2 = vec![0.0; are_taken.len()];
        for (room, &hall) in self.hall_of.iter().enumerate() {
            free_du2[hall as usize] += self.areas_du2[room] * if are_taken[room] { -1.0 } else { 1.0 };
        }
        free_du2.iter().map(|&free_du2| free_du2 < 0.0).collect()
    }

    fn doors_of(&self, room: u32) -> &[Door] {
        let start = self.doors.partition_point(|&[from, _]| from < room);
        let count = self.doors[start..].partition_point(|&[from, _]| from == room);
        &self.doors[start..start + count]
    }

    fn is_at_border(&self, room: u32) -> bool {
        self.areas_du2[room as usize].is_infinite()
    }
}

/// The rooms on this side of a half-edge and on the other, if it is part of a wide gap.
pub(super) fn wide_gap(map: &PlanarMap, room_of: &[u32], h: HalfEdge) -> Option<Door> {
    let mesh = map.refined();
    let gap = &map.gaps()[mesh.gap(h)? as usize];
    let twin = mesh.passage(h)?;
    gap.is_wide.then(|| [h, twin].map(|h| room_of[h.triangle()]))
}

fn areas_du2(map: &PlanarMap, room_of: &[u32], room_count: usize) -> Vec<f64> {
    let mesh = map.refined();
    let mut areas_du2 = vec![0.0; room_count];
    for (triangle, &room) in room_of.iter().enumerate() {
        let [a, b, c] = mesh.corners(triangle);
        let is_at_border = (0..3).any(|i| mesh.twin(HalfEdge::of(triangle, i)).is_none());
        areas_du2[room as usize] += if is_at_border { f64::INFINITY } else { 0.5 * (b - a).cross(c - a) };
    }
    areas_du2
}

fn halls(are_beside_border: &[bool], doors: &[Door]) -> Vec<u32> {
    let mut halls = Sets::new(are_beside_border.len());
    for door in doors.iter().filter(|door| !door.iter().any(|&room| are_beside_border[room as usize])) {
        let [from, to] = door.map(|room| halls.find(room));
        halls.join(from, to);
    }
    (0..are_beside_border.len() as u32).map(|room| halls.find(room)).collect()
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

    fn add(&mut self, room: u32) {
        self.taken.push(room);
        self.is_taken[room as usize] = true;
        for &[_, beside] in self.rooms.doors_of(room) {
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
                for &[_, beside] in self.rooms.doors_of(room) {
                    if self.is_pocket(room, beside) {
                        self.add(beside);
                    }
                }
                next += 1;
            }
        }
    }

    fn is_pocket(&mut self, room: u32, beside: u32) -> bool {
        let group = self.groups.find(room) as usize;
        !self.rooms.is_at_border(room)
            && !self.is_taken[beside as usize]
            && !self.rooms.are_beside_border[beside as usize]
            && self.rooms.areas_du2[beside as usize] < POCKET * self.areas_du2[group]
    }

    fn leads(&self, [from, to]: Door) -> bool {
        let is_within = self.is_taken[to as usize] || self.rooms.is_at_border(from);
        self.is_taken[from as usize] && is_within && !self.rooms.is_at_border(to)
    }
}
