//! The numbers of unknowns of regions, as gaps close and open.
//!
//! They are found once, with all gaps open, and put in an order of elimination. Where gaps are closed only the sectors and
//! edges at these have other unknowns, which are eliminated where the ones that they share in an open gap would be: the order
//! stays good, as closing a gap only takes couplings away. So to number regions anew is to count.

use std::iter;

use scumble_core::pace::{self, Pace};
use scumble_core::{HalfEdge, Triangulation, sort};

use super::dissection;
use super::dofs::{Dofs, NONE, Unknowns, half_edges};
use crate::barriers::Barriers;

/// So many triangles are copied, or marked, in the time that other things take with one.
const CHUNK: usize = 8;

/// Finds all regions of a mesh; their unknowns are in no order, but those at corners come first.
pub(super) async fn regions(barriers: Barriers<'_>) -> Vec<Dofs> {
    let triangles: Vec<_> = (0..barriers.mesh.triangle_count() as u32).collect();
    let mut numbers = Numbers { barriers, of_triangle: vec![[NONE; 6]; triangles.len()], first: 0, next: 0 };
    let (mut regions, mut pace) = (Vec::new(), Pace::default());
    for triangles in barriers.regions(&triangles).await {
        pace.work(triangles.len()).await;
        numbers.next = 0;
        let unknowns = numbers.unknowns(&triangles).await;
        regions.push(Dofs::new(barriers, triangles, unknowns).await);
    }
    regions
}

/// The unknowns of a mesh of which all gaps are open, numbered in the order of elimination, region after region.
#[derive(Debug)]
pub(super) struct Numbering {
    /// Those of each triangle, as [`Unknowns::of_element`] has them.
    of_triangle: Vec<[u32; 6]>,
    /// Where the groups end that are eliminated together.
    group_ends: Vec<u32>,
}

impl Numbering {
    /// Puts the unknowns of the regions of a mesh in order, all gaps being open.
    pub(super) async fn new(mesh: &Triangulation, regions: &mut [Dofs]) -> Self {
        let mut of_triangle = vec![[NONE; 6]; mesh.triangle_count()];
        let (mut group_ends, mut first, mut pace) = (Vec::new(), 0, Pace::default());
        for region in regions {
            region.order(&dissection::corner_rank(mesh, region).await);
            pace.work(region.triangles.len()).await;
            for (&triangle, dofs) in region.triangles.iter().zip(&region.unknowns.of_element) {
                of_triangle[triangle as usize] = dofs.map(|dof| first + dof);
            }
            group_ends.extend(region.unknowns.group_ends.iter().map(|end| first + end));
            first += region.unknowns.count as u32;
            pace.work(region.triangles.len()).await;
        }
        Self { of_triangle, group_ends }
    }

    /// The regions of a set of triangles, which is made of whole regions and ascends; their unknowns are in order.
    pub(super) async fn regions(&self, barriers: Barriers<'_>, triangles: &[u32]) -> Vec<Dofs> {
        let (numbers, split) = self.split(barriers, triangles).await;
        let parts = barriers.regions(triangles).await;
        let mut dof_of = numbers.parts(&parts).await;
        let counts = self.count(&split, &mut dof_of, parts.len()).await;
        let (mut regions, mut pace) = (Vec::with_capacity(parts.len()), Pace::default());
        for (triangles, Count { group_ends, count, .. }) in parts.into_iter().zip(counts) {
            let mut of_element = Vec::with_capacity(triangles.len());
            let dofs = |t: u32| numbers.of_triangle[t as usize].map(|number| dof_of[number as usize]);
            pace::for_each(&triangles, |&t| of_element.push(dofs(t))).await;
            let unknowns = Unknowns { of_element, group_ends, count: count as usize };
            pace.work(triangles.len()).await;
            regions.push(Dofs::new(barriers, triangles, unknowns).await);
        }
        regions
    }

    /// Gives unknowns of their own to sectors and edges at closed gaps; and pairs of the one that is shared while the gap is open
    /// and an own one, sorted.
    async fn split<'a>(&self, barriers: Barriers<'a>, triangles: &[u32]) -> (Numbers<'a>, Vec<(u64, u32)>) {
        let first = self.group_ends.last().copied().unwrap_or_default();
        let mut of_triangle = vec![[0; 6]; self.of_triangle.len()];
        let mut copy = |t: u32| of_triangle[t as usize] = self.of_triangle[t as usize];
        pace::for_each(triangles.chunks(CHUNK), |some| some.iter().for_each(|&t| copy(t))).await;
        let mut numbers = Numbers { barriers, of_triangle, first, next: first };
        let mut split = Vec::new();
        pace::for_each(triangles, |&t| {
            for h in half_edges(t).filter(|&h| barriers.is_closed_gap(h)) {
                let shared = numbers.at(h);
                numbers.number_sector(h);
                numbers.number_sector(h.next());
                numbers.number_middle(h);
                let both = shared.into_iter().zip(numbers.at(h));
                split.extend(
                    both.filter(|(shared, own)| shared != own).map(|(shared, own)| (shared.into(), own)),
                );
            }
        })
        .await;
        sort::sort(&mut split);
        (numbers, split)
    }

    /// Numbers the unknowns of so many parts in order, each part from 0. In place of the part of each unknown there is its number
    /// afterwards; those that are in none stay so.
    async fn count(&self, split: &[(u64, u32)], unknowns: &mut [u32], part_count: usize) -> Vec<Count> {
        let mut counts: Vec<_> = (0..part_count).map(|_| Count::default()).collect();
        let mut split = split.iter().peekable();
        let (mut start, mut pace) = (0, Pace::default());
        for &end in &self.group_ends {
            let own = iter::from_fn(|| split.next_if(|(shared, _)| *shared < end.into()));
            for number in (start..end).chain(own.map(|&(_, own)| own)) {
                let unknown = &mut unknowns[number as usize];
                if let Some(count) = counts.get_mut(*unknown as usize) {
                    *unknown = count.next(end);
                }
            }
            pace.work(1).await;
            start = end;
        }
        counts
    }
}

/// The unknowns of one part that are numbered so far.
#[derive(Default)]
struct Count {
    /// Where their groups end; the last one may go on.
    group_ends: Vec<u32>,
    count: u32,
    /// Which group the last one is of.
    group: u32,
}

impl Count {
    /// The number of the next one, of this group.
    fn next(&mut self, group: u32) -> u32 {
        self.count += 1;
        match self.group_ends.last_mut() {
            Some(end) if self.group == group => *end = self.count,
            _ => self.group_ends.push(self.count),
        }
        self.group = group;
        self.count - 1
    }
}

/// The unknowns given out so far.
struct Numbers<'a> {
    barriers: Barriers<'a>,
    of_triangle: Vec<[u32; 6]>,
    /// Those before it were given out by another, and count as not given out yet.
    first: u32,
    next: u32,
}

impl Numbers<'_> {
    /// Numbers those of a region, at corners first.
    async fn unknowns(&mut self, triangles: &[u32]) -> Unknowns {
        pace::for_each(triangles, |&t| half_edges(t).for_each(|h| self.number_sector(h))).await;
        pace::for_each(triangles, |&t| half_edges(t).for_each(|h| self.number_middle(h))).await;
        let of_element = triangles.iter().map(|&t| self.of_triangle[t as usize]).collect();
        pace::pause_after(triangles.len()).await;
        Unknowns { of_element, group_ends: Vec::new(), count: self.next as usize }
    }

    /// The part that each unknown is in, if any, of some parts of the mesh.
    async fn parts(&self, parts: &[Vec<u32>]) -> Vec<u32> {
        let (mut part_of, mut pace) = (vec![NONE; self.next as usize], Pace::default());
        for (part, triangles) in (0..).zip(parts) {
            let numbers = |&t: &u32| self.of_triangle[t as usize];
            pace::for_each(triangles.chunks(CHUNK), |some| {
                some.iter().flat_map(numbers).for_each(|number| part_of[number as usize] = part);
            })
            .await;
            pace.work(triangles.len()).await;
        }
        part_of
    }

    /// Gives one unknown to all corners in the sector of the node that a half-edge starts from.
    fn number_sector(&mut self, h: HalfEdge) {
        if self.is_numbered(h) {
            return;
        }
        *self.corner(h) = self.next;
        let barriers = self.barriers;
        self.number_on(h, |h| barriers.passage(h.prev()));
        self.number_on(h, |h| barriers.passage(h).map(HalfEdge::next));
        self.next += 1;
    }

    /// Gives the same unknown to corners after the one of `h`, up to a barrier or all around.
    fn number_on(&mut self, mut h: HalfEdge, next: impl Fn(HalfEdge) -> Option<HalfEdge>) {
        while let Some(beside) = next(h).filter(|&beside| !self.is_numbered(beside)) {
            *self.corner(beside) = self.next;
            h = beside;
        }
    }

    fn number_middle(&mut self, h: HalfEdge) {
        if !(self.first..NONE).contains(self.middle(h)) {
            *self.middle(h) = self.next;
            if let Some(twin) = self.barriers.passage(h) {
                *self.middle(twin) = self.next;
            }
            self.next += 1;
        }
    }

    /// Whether the corner that a half-edge starts from has its unknown.
    fn is_numbered(&mut self, h: HalfEdge) -> bool {
        (self.first..NONE).contains(self.corner(h))
    }

    /// The unknowns at the start, the end and in the middle of a half-edge.
    fn at(&mut self, h: HalfEdge) -> [u32; 3] {
        [*self.corner(h), *self.corner(h.next()), *self.middle(h)]
    }

    fn corner(&mut self, h: HalfEdge) -> &mut u32 {
        &mut self.of_triangle[h.triangle()][h.index() % 3]
    }

    fn middle(&mut self, h: HalfEdge) -> &mut u32 {
        &mut self.of_triangle[h.triangle()][3 + h.index() % 3]
    }
}

#[cfg(test)]
mod tests {
    use scumble_core::pace::{Slices, now};

    use super::super::tests::map;
    use super::*;

    #[test]
    fn corners_and_edges_share_the_unknowns_that_they_share_if_numbered_from_scratch() {
        let map = map();
        let mesh = map.refined();
        let triangles: Vec<_> = (0..mesh.triangle_count() as u32).collect();
        let mut open = now(Slices::new(regions(Barriers { mesh, closed_gaps: &[] })));
        let numbering = now(Slices::new(Numbering::new(mesh, &mut open)));
        for closed_gaps in [&[false], &[true]] {
            let barriers = Barriers { mesh, closed_gaps };
            let ours = now(Slices::new(numbering.regions(barriers, &triangles)));
            let fresh = now(Slices::new(regions(barriers)));
            assert_eq!(ours.len(), fresh.len());
            for (ours, fresh) in ours.iter().zip(&fresh) {
                assert_same_but_for_the_order(ours, fresh);
                assert!(ours.unknowns.group_ends.is_sorted_by(|a, b| a < b));
                assert_eq!(ours.unknowns.group_ends.last(), Some(&(ours.unknowns.count as u32)));
            }
        }
    }

    #[test]
    fn numbers_depend_on_the_gaps_that_are_closed_alone() {
        let map = map();
        let mesh = map.refined();
        let mut open = now(Slices::new(regions(Barriers { mesh, closed_gaps: &[] })));
        let numbering = now(Slices::new(Numbering::new(mesh, &mut open)));
        let numbers = |closed_gaps: &[bool], triangles: &[u32]| {
            now(Slices::new(numbering.regions(Barriers { mesh, closed_gaps }, triangles)))
        };
        let all: Vec<_> = (0..mesh.triangle_count() as u32).collect();
        let opened = numbers(&[false], &all);
        assert_eq!(opened.len(), open.len());
        opened.iter().zip(&open).for_each(|(opened, open)| assert_same(opened, open));
        let closed = numbers(&[true], &all);
        for region in &closed {
            let alone = numbers(&[true], &region.triangles);
            assert_eq!(alone.len(), 1);
            assert_same(&alone[0], region);
        }
    }

    fn assert_same(a: &Dofs, b: &Dofs) {
        assert_eq!((&a.triangles, &a.gaps), (&b.triangles, &b.gaps));
        assert_eq!(a.unknowns.of_element, b.unknowns.of_element);
        assert_eq!((a.unknowns.count, &a.unknowns.group_ends), (b.unknowns.count, &b.unknowns.group_ends));
    }

    fn assert_same_but_for_the_order(ours: &Dofs, fresh: &Dofs) {
        assert_eq!((&ours.triangles, &ours.gaps), (&fresh.triangles, &fresh.gaps));
        assert_eq!(ours.unknowns.count, fresh.unknowns.count);
        let dofs = |region: &Dofs| {
            let of_sides = region.sides.iter().flat_map(|side| side.dofs);
            let of_corners = region.corners.iter().map(|corner| corner.dof);
            let of_elements = region.unknowns.of_element.iter().flatten().copied();
            of_elements.chain(of_sides).chain(of_corners).collect::<Vec<_>>()
        };
        let mut name_of = vec![NONE; fresh.unknowns.count];
        let mut is_taken = vec![false; ours.unknowns.count];
        assert_eq!(dofs(ours).len(), dofs(fresh).len());
        for (our, their) in dofs(ours).into_iter().zip(dofs(fresh)) {
            if name_of[their as usize] == NONE {
                name_of[their as usize] = our;
                assert!(!std::mem::replace(&mut is_taken[our as usize], true), "{our} stands for two");
            }
            assert_eq!(name_of[their as usize], our, "for {their}");
        }
    }
}
