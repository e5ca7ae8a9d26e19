//! The order of elimination, which decides how many entries the factor has.
//!
//! The corners of the mesh are put in an approximate minimum degree order (P. Amestoy, T. Davis, I. Duff, 1996), those of
//! large regions part by part, as if for linear elements; the middle of an edge goes right before the end that comes first.
//! That takes a quarter of the time of ordering all unknowns, and the factor has no more entries. Fixed unknowns are left out of it
//! later, so one order does for every set of coloured sides. It also does where gaps are closed, which only takes edges
//! away: so a mesh is put in order once.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

use super::dofs::{NONE, Unknowns};

/// The place of each unknown in the order of elimination, and where the groups of a corner and of the edges before it
/// end there, from the places of the corners, which come first among the unknowns.
pub(super) fn elimination_rank(unknowns: &Unknowns, corner_rank: &[u32]) -> (Vec<u32>, Vec<u32>) {
    let mut group_of = corner_rank.to_vec();
    group_of.resize(unknowns.count, 0);
    for dofs in &unknowns.of_element {
        for i in 0..3 {
            let ends = [dofs[i], dofs[(i + 1) % 3]].map(|corner| corner_rank[corner as usize]);
            group_of[dofs[3 + i] as usize] = ends[0].min(ends[1]);
        }
    }
    let mut ends = vec![0; corner_rank.len()];
    group_of.iter().for_each(|&group| ends[group as usize] += 1);
    for group in 1..ends.len() {
        ends[group] += ends[group - 1];
    }
    let mut next = ends.clone();
    // From the end of each group on: corners come first among the unknowns, so they are last in their groups.
    let place = |&group: &u32| {
        next[group as usize] -= 1;
        next[group as usize]
    };
    (group_of.iter().map(place).collect(), ends)
}

/// Number of corners, which come first among the unknowns.
pub(super) fn corner_count(unknowns: &Unknowns) -> usize {
    unknowns
        .of_element
        .iter()
        .flat_map(|dofs| &dofs[..3])
        .fold(0, |most, &corner| most.max(corner as usize + 1))
}

/// The place of each corner in an order of the corners alone.
pub(super) fn corner_rank(unknowns: &Unknowns) -> Vec<u32> {
    let triangles: Vec<_> = unknowns.of_element.iter().map(|&[a, b, c, ..]| [a, b, c]).collect();
    minimum_degree(&triangles, corner_count(unknowns))
}

/// The place of each of so many corners of triangles in an approximate minimum degree order; where there is no memory to
/// find one, as they are. Corners that are [`NONE`] are not there.
pub(super) fn minimum_degree(triangles: &[[u32; 3]], count: usize) -> Vec<u32> {
    let (column_starts, neighbours) = neighbours(triangles, count);
    let pattern =
        SymbolicSparseColMatRef::new_unsorted_checked(count, count, &column_starts, None, &neighbours);
    let scratch = amd::order_maybe_unsorted_scratch::<u32>(count, neighbours.len());
    let (mut corner_at, mut rank) = (vec![0; count], vec![0; count]);
    let order = |mut memory: MemBuffer| {
        let stack = MemStack::new(&mut memory);
        amd::order_maybe_unsorted(&mut corner_at, &mut rank, pattern, amd::Control::default(), stack).ok()
    };
    match MemBuffer::try_new(scratch).ok().and_then(order) {
        Some(_) => rank,
        None => (0..count as u32).collect(),
    }
}

/// For each corner, the next corner of each of its triangles: where each begins in a list, and the list. An edge
/// between two triangles is listed from both ends, one on a side from one end.
fn neighbours(triangles: &[[u32; 3]], corner_count: usize) -> (Vec<u32>, Vec<u32>) {
    let edges = triangles.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let edges = edges.filter(|edge| !edge.contains(&NONE));
    let mut starts = vec![0; corner_count + 1];
    edges.clone().for_each(|[from, _]| starts[from as usize + 1] += 1);
    for corner in 0..corner_count {
        starts[corner + 1] += starts[corner];
    }
    let mut next = starts.clone();
    let mut neighbours = vec![0; starts[corner_count] as usize];
    for [from, to] in edges {
        neighbours[next[from as usize] as usize] = to;
        next[from as usize] += 1;
    }
    (starts, neighbours)
}
