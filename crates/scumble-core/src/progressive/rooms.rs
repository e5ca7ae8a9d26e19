//! Which gaps of the map the circuits of a scribble close.

use crate::triangulation::Triangulation;

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

    /// The gaps of rooms that lie within the circuits of a scribble, and whether it parts them: whether the room on the
    /// other side lies without. Takes the triangles of the sides that it sees, and whether each lies within; a room does
    /// where most of what is seen of it does.
    ///
    /// A circuit jumps from where a sample's glance leaves a line, the gap lies at the narrowest place: looking for gaps
    /// along jumps misses many.
    pub(super) fn gaps(&self, seen: impl Iterator<Item = (usize, bool)>) -> Vec<(u32, bool)> {
        let mut balance = vec![0_i64; self.count];
        for (triangle, is_within) in seen {
            balance[self.of_triangle[triangle] as usize] += if is_within { 1 } else { -1 };
        }
        let within = self.of_gap.iter().map(|rooms| rooms.map(|room| balance[room as usize] > 0));
        let found = (0..).zip(within).filter(|(_, [a, b])| *a || *b);
        found.map(|(gap, [a, b])| (gap, a != b)).collect()
    }

    /// Whether there is no gap at all.
    pub(super) fn is_one(&self) -> bool {
        self.of_gap.is_empty()
    }
}
