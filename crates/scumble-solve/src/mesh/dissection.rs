//! The order of elimination of a large region: it is halved again and again (A. George, *Nested dissection of a regular finite
//! element mesh*, 1973), and only parts that are small enough are put in an approximate minimum degree order. The corners
//! that the elements of both halves have are eliminated after both. So the order is found in slices, and as long as the cuts
//! lead through narrow places, a factor has hardly more entries than in a minimum degree order of the whole.

use std::mem;

use kurbo::Point;
use scumble_core::Triangulation;
use scumble_core::pace;

use super::dofs::{Dofs, NONE};
use super::order;

/// Most elements of a part that is not halved.
const MOST_ELEMENTS: usize = 24_576;

/// So many places are looked at to cut a part.
const CUTS: usize = 256;

/// The place of each corner of a region in the order of elimination.
pub(super) async fn corner_rank(mesh: &Triangulation, region: &Dofs) -> Vec<u32> {
    let elements = &region.unknowns.of_element;
    if elements.len() <= MOST_ELEMENTS {
        return order::corner_rank(&region.unknowns);
    }
    let extents = region.triangles.iter().map(|&t| extents(mesh.corners(t as usize))).collect();
    pace::pause().await;
    let mut dissection = Dissection::new(elements, extents, order::corner_count(&region.unknowns));
    while dissection.go_on(MOST_ELEMENTS) {
        pace::pause().await;
    }
    dissection.rank
}

/// Where an element begins and ends along either axis.
fn extents([a, b, c]: [Point; 3]) -> [[f32; 2]; 2] {
    [[a.x, b.x, c.x], [a.y, b.y, c.y]].map(|[a, b, c]| [a.min(b).min(c) as f32, a.max(b).max(c) as f32])
}

/// Places along an axis at which elements may be cut apart, evenly spaced between the first and the last.
struct Cuts {
    bounds: [f32; 2],
    /// How many elements end before each, and how many begin before it.
    before: [[u32; CUTS]; 2],
}

impl Cuts {
    fn new(bounds: [f32; 2]) -> Self {
        Self { bounds, before: [[0; CUTS]; 2] }
    }

    /// Counts an element at the places where it ends and begins; what is before these adds up later.
    fn add(&mut self, [from, to]: [f32; 2]) {
        for (count, at) in self.before.iter_mut().zip([to, from]) {
            let part = (at - self.bounds[0]) / (self.bounds[1] - self.bounds[0]);
            count[((part * CUTS as f32) as usize).min(CUTS - 1)] += 1;
        }
    }

    /// What the best place costs, and where it is: elements that it leads through, for each of those on the side that has fewer.
    fn best(&self) -> (f64, f32) {
        let (mut best, mut sums) = ((f64::INFINITY, self.bounds[0]), [0; 2]);
        let all: u32 = self.before[0].iter().sum();
        for i in 0..CUTS - 1 {
            (0..2).for_each(|k| sums[k] += self.before[k][i]);
            let [ended, begun] = sums;
            let cost = f64::from(1 + begun - ended) / f64::from(ended.min(all - begun));
            if cost < best.0 {
                let part = (i + 1) as f32 / CUTS as f32;
                best = (cost, self.bounds[0] + part * (self.bounds[1] - self.bounds[0]));
            }
        }
        best
    }
}

/// The ranks given so far.
struct Dissection<'a> {
    elements: &'a [[u32; 6]],
    /// Of each element, in du.
    extents: Vec<[[f32; 2]; 2]>,
    /// Elements of the parts to be ranked, the first one last.
    parts: Vec<Vec<u32>>,
    /// Those of the halves of a part, before what is between them is ranked; else of none.
    halves: [Vec<u32>; 2],
    /// Of each corner; [`NONE`] as long as it has none.
    rank: Vec<u32>,
    /// Number of corners without a rank; ranks are given from the last one on.
    left: u32,
    /// For each corner the last mark that it was given.
    mark_of: Vec<u32>,
    mark: u32,
    /// For each corner its number in its part; [`NONE`] as long as it has none.
    number_of: Vec<u32>,
}

impl<'a> Dissection<'a> {
    /// That of elements by their extents, with so many corners, which have no rank yet.
    fn new(elements: &'a [[u32; 6]], extents: Vec<[[f32; 2]; 2]>, count: usize) -> Self {
        Self {
            elements,
            extents,
            parts: vec![(0..elements.len() as u32).collect()],
            halves: Default::default(),
            rank: vec![NONE; count],
            left: count as u32,
            mark_of: vec![0; count],
            mark: 0,
            number_of: vec![NONE; count],
        }
    }

    /// Ranks a part, or halves it if it has more than so many elements, or ranks what is between halves; tells whether there
    /// are more.
    fn go_on(&mut self, most_elements: usize) -> bool {
        let halves = mem::take(&mut self.halves);
        if halves.iter().all(|half| !half.is_empty()) {
            self.rank_between(&halves);
            self.parts.extend(halves);
            return true;
        }
        let Some(part) = self.parts.pop() else { return false };
        if part.len() > most_elements {
            self.halves = self.halved(&part);
        }
        if self.halves.iter().any(Vec::is_empty) {
            self.rank_part(&part);
        }
        true
    }

    /// Elements on either side of the line along an axis that leads through few of them and leaves many on either side.
    fn halved(&self, part: &[u32]) -> [Vec<u32>; 2] {
        let mut cuts = [0, 1].map(|axis| Cuts::new(self.bounds(part, axis)));
        for &element in part {
            cuts.iter_mut().zip(self.extents[element as usize]).for_each(|(cuts, extent)| cuts.add(extent));
        }
        let [across, down] = cuts.map(|cuts| cuts.best());
        let (axis, place) = if across.0 <= down.0 { (0, across.1) } else { (1, down.1) };
        let mut halves = [Vec::new(), Vec::new()];
        for &element in part {
            let [from, to] = self.extents[element as usize][axis];
            halves[usize::from(from + to > 2.0 * place)].push(element);
        }
        halves
    }

    /// Where some elements begin and end along an axis.
    fn bounds(&self, part: &[u32], axis: usize) -> [f32; 2] {
        let mut bounds = [f32::INFINITY, f32::NEG_INFINITY];
        for &element in part {
            let [from, to] = self.extents[element as usize][axis];
            bounds = [bounds[0].min(from), bounds[1].max(to)];
        }
        bounds
    }

    /// Ranks the corners that both halves have, after all others of them.
    fn rank_between(&mut self, halves: &[Vec<u32>; 2]) {
        let elements = self.elements;
        self.mark += 1;
        for &element in &halves[0] {
            elements[element as usize][..3]
                .iter()
                .for_each(|&corner| self.mark_of[corner as usize] = self.mark);
        }
        for &element in &halves[1] {
            for &corner in &elements[element as usize][..3] {
                if self.mark_of[corner as usize] == self.mark && self.rank[corner as usize] == NONE {
                    self.left -= 1;
                    self.rank[corner as usize] = self.left;
                }
            }
        }
    }

    /// Ranks the corners of a part that have no rank, before all that have one.
    fn rank_part(&mut self, part: &[u32]) {
        let mut corners = Vec::new();
        let mut number = |corner: u32| {
            let number_of = &mut self.number_of[corner as usize];
            if self.rank[corner as usize] == NONE && *number_of == NONE {
                *number_of = corners.len() as u32;
                corners.push(corner);
            }
            // Where there is a rank already, there is none.
            *number_of
        };
        let triangle = |&element: &u32| [0, 1, 2].map(|i| number(self.elements[element as usize][i]));
        let triangles: Vec<_> = part.iter().map(triangle).collect();
        self.left -= corners.len() as u32;
        for (corner, rank) in corners.iter().zip(order::minimum_degree(&triangles, corners.len())) {
            self.rank[*corner as usize] = self.left + rank;
        }
    }
}

#[cfg(test)]
mod tests {
    use kurbo::{Rect, Shape};
    use scumble_core::pace::{Slices, now};
    use scumble_core::{Curve, Drawing, PlanarMap, Sampling};

    use super::*;
    use crate::barriers::Barriers;
    use crate::mesh::fronts::Front;
    use crate::mesh::fronts::tests::fronts;
    use crate::mesh::numbering::regions;

    /// Two rooms with a door between them: one region.
    fn rooms() -> PlanarMap {
        let walls = [Rect::new(100.0, 100.0, 500.0, 900.0), Rect::new(520.0, 100.0, 900.0, 900.0)];
        let open = |wall: Rect| wall.path_elements(0.1).take(4).collect();
        let curves = walls.map(|wall| Curve { path: open(wall), line: None }).into();
        let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
        PlanarMap::build(&drawing, &Sampling::default()).expect("a map")
    }

    #[test]
    fn parts_and_what_is_between_them_make_an_order_that_fills_in_little_more() {
        let map = rooms();
        let mesh = map.refined();
        let mut regions = now(Slices::new(regions(Barriers { mesh, closed_gaps: &[] }, None)));
        assert_eq!(regions.len(), 1);
        let region = regions.remove(0);
        let entries = |most_elements: usize| {
            let elements = &region.unknowns.of_element;
            let extents = region.triangles.iter().map(|&t| extents(mesh.corners(t as usize))).collect();
            let mut dissection = Dissection::new(elements, extents, order::corner_count(&region.unknowns));
            while dissection.go_on(most_elements) {}
            let mut places = dissection.rank.clone();
            places.sort_unstable();
            assert!((0..).zip(places).all(|(i, place)| i == place), "each has its place");
            let (rank, ends) = order::elimination_rank(&region.unknowns, &dissection.rank);
            let rows: Vec<_> = elements.iter().map(|dofs| dofs.map(|dof| rank[dof as usize])).collect();
            let fronts = fronts(&rows, &ends);
            fronts.list.iter().map(Front::column_count).sum::<usize>() as f64
        };
        let whole = entries(usize::MAX);
        for most_elements in [1, 100, 1000] {
            let part = entries(most_elements) / whole;
            assert!((0.5..1.6).contains(&part), "{part} with parts of {most_elements}");
        }
    }
}
