//! Which gaps of the map the circuits of a scribble close.

use crate::triangulation::Triangulation;

/// A room clearly lies within where so many times as many sides of it do as do not.
const CLEARLY: u32 = 8;

/// What the gaps of a map part.
#[derive(Clone, Debug)]
pub(super) struct Rooms {
    /// Per triangle.
    of_triangle: Vec<u32>,
    count: usize,
    /// Per gap the rooms on either side of it.
    of_gap: Vec<[u32; 2]>,
}

impl Rooms {
    pub(super) fn new(mesh: &Triangulation, gap_count: usize) -> Self {
        let (of_triangle, count) = mesh.rooms();
        let mut of_gap = vec![[0; 2]; gap_count];
        for h in mesh.half_edges() {
            if let (Some(gap), Some(twin)) = (mesh.gap(h), mesh.twin(h)) {
                of_gap[gap as usize] = [h, twin].map(|h| of_triangle[h.triangle()]);
            }
        }
        Self { of_triangle, count, of_gap }
    }

    /// The gaps that the circuits of a scribble part or join, and whether they part them: whether one of the rooms on
    /// either side lies within and the other does not. They join them where both clearly lie within. Takes the triangles
    /// of the sides that the scribble sees, and whether each lies within; a room does where most of what is seen of it
    /// does.
    ///
    /// A circuit jumps from where a sample's glance leaves a line, the gap lies at the narrowest place: looking for gaps
    /// along jumps misses many.
    pub(super) fn gaps(&self, seen: impl Iterator<Item = (usize, bool)>) -> Vec<(u32, bool)> {
        let mut counts = vec![[0_u32; 2]; self.count];
        for (triangle, is_within) in seen {
            counts[self.of_triangle[triangle] as usize][usize::from(is_within)] += 1;
        }
        let is_within = |room: u32, least: u32| {
            let [without, within] = counts[room as usize];
            within > least * without
        };
        let kind = |rooms: &[u32; 2]| {
            let is_parted = is_within(rooms[0], 1) != is_within(rooms[1], 1);
            (is_parted || rooms.iter().all(|&room| is_within(room, CLEARLY))).then_some(is_parted)
        };
        (0..).zip(&self.of_gap).filter_map(|(gap, rooms)| Some((gap, kind(rooms)?))).collect()
    }

    /// Whether there are any to ask for.
    pub(super) fn have_gaps(&self) -> bool {
        !self.of_gap.is_empty()
    }
}
