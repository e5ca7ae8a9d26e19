//! The numbers of unknowns of regions, as gaps close and open.
//!
//! They are found once, with all gaps open, and put in an order of elimination. Where gaps are closed only the sectors and
//! edges at these have other unknowns, which are eliminated where the ones that they share in an open gap would be: order and
//! pattern stay good, as closing a gap only takes couplings away. So to number regions anew is to count.

use std::mem;
use std::sync::Arc;

use scumble_core::pace::{self, Pace};
use scumble_core::{HalfEdge, Triangulation};

use super::dissection;
use super::dofs::{Dofs, NONE, Unknowns, half_edges};
use super::once::Once;
use super::pattern::{Pattern, Tree};
use crate::barriers::Barriers;

/// So many triangles are copied, or marked, in the time that other things take with one.
const CHUNK: usize = 8;

/// Finds the regions of a mesh; those that are not needed have no elements. Unknowns are in no order, but those at corners come first.
pub(super) async fn regions(barriers: Barriers<'_>, once: Option<Once<'_>>) -> Vec<Dofs> {
    let triangles: Vec<_> = (0..barriers.mesh.triangle_count() as u32).collect();
    let mut numbers = Numbers { barriers, of_triangle: vec![[NONE; 6]; triangles.len()], first: 0, next: 0 };
    let (mut regions, mut pace) = (Vec::new(), Pace::default());
    for triangles in barriers.regions(&triangles).await {
        pace.work(triangles.len()).await;
        let is_needed = once.is_none_or(|once| once.needs(barriers.mesh, &triangles));
        numbers.next = 0;
        let unknowns = numbers.unknowns(if is_needed { &triangles } else { &[] }).await;
        regions.push(Dofs::new(barriers, triangles, unknowns).await);
    }
    regions
}

/// The unknowns of a mesh of which all gaps are open, numbered in the order of elimination, region after region.
#[derive(Debug)]
pub(super) struct Numbering {
    /// Those of each triangle, as [`Unknowns::of_element`] has them.
    of_triangle: Vec<[u32; 6]>,
    /// Of each region, its first unknown.
    firsts: Vec<u32>,
    /// And its pattern, which counts from that.
    patterns: Vec<Arc<Pattern>>,
    /// Number of unknowns of all.
    count: u32,
}

impl Numbering {
    /// Puts the unknowns of the regions of a mesh in order, all gaps being open. For what is needed once, those of the
    /// regions alone where several of its colours run into each other, its gaps being closed.
    pub(super) async fn new(mesh: &Triangulation, regions: &mut [Dofs], once: Option<Once<'_>>) -> Self {
        let mut of_triangle = vec![[NONE; 6]; mesh.triangle_count()];
        let (mut firsts, mut patterns) = (Vec::new(), Vec::new());
        let (mut first, mut pace) = (0, Pace::default());
        for region in regions {
            if once.is_some_and(|once| !region.blends(&once.boundary.sides)) {
                continue;
            }
            let ends = region.order(&dissection::corner_rank(mesh, region).await);
            pace.work(region.triangles.len()).await;
            region.unknowns.pattern = pattern(&region.unknowns, &ends).await.into();
            for (&triangle, dofs) in region.triangles.iter().zip(&region.unknowns.of_element) {
                of_triangle[triangle as usize] = dofs.map(|dof| first + dof);
            }
            firsts.push(first);
            patterns.push(region.unknowns.pattern.clone());
            first += region.unknowns.count as u32;
            pace.work(region.triangles.len()).await;
        }
        Self { of_triangle, firsts, patterns, count: first }
    }

    /// The regions of a set of triangles, which is made of whole regions and ascends; their unknowns are in order.
    pub(super) async fn regions(&self, barriers: Barriers<'_>, triangles: &[u32]) -> Vec<Dofs> {
        let (numbers, own) = self.split(barriers, triangles).await;
        let parts = barriers.regions(triangles).await;
        let mut dof_of = numbers.parts(&parts).await;
        let counts = self.count(&own, &mut dof_of, &parts).await;
        let (mut regions, mut pace) = (Vec::with_capacity(parts.len()), Pace::default());
        for (triangles, Numbered { mut pattern, .. }) in parts.into_iter().zip(counts) {
            let mut of_element = Vec::with_capacity(triangles.len());
            let dofs = |t: u32| numbers.of_triangle[t as usize].map(|number| dof_of[number as usize]);
            pace::for_each(&triangles, |&t| of_element.push(dofs(t))).await;
            pattern.renumber_boundaries(|number| dof_of[number as usize]).await;
            let count = pattern.unknown_count();
            let unknowns = Unknowns { of_element, pattern: pattern.into(), count };
            pace.work(triangles.len()).await;
            regions.push(Dofs::new(barriers, triangles, unknowns).await);
        }
        regions
    }

    /// Gives unknowns of their own to sectors and edges at closed gaps.
    async fn split<'a>(&self, barriers: Barriers<'a>, triangles: &[u32]) -> (Numbers<'a>, Own) {
        let mut of_triangle = vec![[0; 6]; self.of_triangle.len()];
        let mut copy = |t: u32| of_triangle[t as usize] = self.of_triangle[t as usize];
        pace::for_each(triangles.chunks(CHUNK), |some| some.iter().for_each(|&t| copy(t))).await;
        let mut numbers = Numbers { barriers, of_triangle, first: self.count, next: self.count };
        let mut pairs = Vec::new();
        pace::for_each(triangles, |&t| {
            for h in half_edges(t).filter(|&h| barriers.is_closed_gap(h)) {
                let shared = numbers.at(h);
                numbers.number_sector(h);
                numbers.number_sector(h.next());
                numbers.number_middle(h);
                let both = shared.into_iter().zip(numbers.at(h));
                pairs.extend(both.filter(|(shared, own)| shared != own));
            }
        })
        .await;
        let own = Own::new(numbers.next as usize, &pairs);
        (numbers, own)
    }

    /// Numbers the unknowns of some parts in order, each part from 0; in boundaries they are still as they were. In place of the
    /// part of each unknown there is its number afterwards; those that are in none stay so.
    async fn count(&self, own: &Own, unknowns: &mut [u32], parts: &[Vec<u32>]) -> Vec<Numbered> {
        let mut counts: Vec<_> = parts.iter().map(|_| Numbered::default()).collect();
        let (mut group, mut pace) = (0, Pace::default());
        let regions = self.firsts.iter().zip(&self.patterns).zip(self.has_parts(parts));
        for ((first, pattern), _) in regions.filter(|(_, has_parts)| *has_parts) {
            pace::for_each(pattern.groups(), |(pivots, boundary)| {
                group += 1;
                let mut is_in_parts = false;
                own.for_each(first, pivots, |number| {
                    let unknown = &mut unknowns[number as usize];
                    if let Some(count) = counts.get_mut(*unknown as usize) {
                        *unknown = count.next(group);
                        is_in_parts = true;
                    }
                });
                let boundary = if is_in_parts { boundary } else { &[] };
                own.for_each(first, boundary.iter().copied(), |number| {
                    let count = counts.get_mut(unknowns[number as usize] as usize);
                    if let Some(count) = count.filter(|count| count.group == group) {
                        count.pattern.add_to_boundary(number);
                    }
                });
            })
            .await;
            pace.work(pattern.groups().len()).await;
        }
        counts
    }

    /// Of which regions some parts are, all gaps being open.
    fn has_parts(&self, parts: &[Vec<u32>]) -> Vec<bool> {
        let mut has_parts = vec![false; self.firsts.len()];
        for &triangle in parts.iter().filter_map(|triangles| triangles.first()) {
            let number = self.of_triangle[triangle as usize][0];
            has_parts[self.firsts.partition_point(|&first| first <= number) - 1] = true;
        }
        has_parts
    }
}

/// The pattern of some unknowns that are in the order of elimination.
async fn pattern(unknowns: &Unknowns, ends: &[u32]) -> Pattern {
    let mut tree = Tree::new(&unknowns.of_element, ends);
    pace::pause_after(unknowns.of_element.len()).await;
    while tree.go_on() {
        pace::pause().await;
    }
    tree.pattern
}

/// The own unknowns in place of one that is shared while gaps are open.
struct Own {
    /// For each unknown the next one in its place; 0 if it is the last.
    next: Vec<u32>,
}

impl Own {
    /// From pairs of the shared one and an own one.
    fn new(count: usize, pairs: &[(u32, u32)]) -> Self {
        let mut next = vec![0; count];
        for &(shared, own) in pairs {
            next[own as usize] = mem::replace(&mut next[shared as usize], own);
        }
        Self { next }
    }

    /// Does something with each of some unknowns, which count from the first, and with the own ones in its place.
    fn for_each(&self, first: &u32, unknowns: impl Iterator<Item = u32>, mut act: impl FnMut(u32)) {
        for unknown in unknowns {
            let mut number = first + unknown;
            act(number);
            while self.next[number as usize] != 0 {
                number = self.next[number as usize];
                act(number);
            }
        }
    }
}

/// The unknowns of one part that are numbered so far.
#[derive(Default)]
struct Numbered {
    pattern: Pattern,
    /// Which group the last one is of, from 1 on.
    group: u32,
}

impl Numbered {
    /// The number of the next one, of this group.
    fn next(&mut self, group: u32) -> u32 {
        if mem::replace(&mut self.group, group) != group {
            self.pattern.begin();
        }
        self.pattern.add_unknown()
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
        Unknowns { of_element, pattern: Arc::default(), count: self.next as usize }
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
    use kurbo::{Circle, Line, Rect, Shape, Vec2};
    use scumble_core::pace::{Slices, now};
    use scumble_core::{Curve, Drawing, PlanarMap, Sampling};

    use super::super::fronts::tests::assert_has_all_rows;
    use super::super::tests::map;
    use super::*;

    #[test]
    fn corners_and_edges_share_the_unknowns_that_they_share_if_numbered_from_scratch() {
        let map = map();
        let mesh = map.refined();
        let triangles: Vec<_> = (0..mesh.triangle_count() as u32).collect();
        let mut open = now(Slices::new(regions(Barriers { mesh, closed_gaps: &[] }, None)));
        let numbering = now(Slices::new(Numbering::new(mesh, &mut open, None)));
        for closed_gaps in [&[false], &[true]] {
            let barriers = Barriers { mesh, closed_gaps };
            let ours = now(Slices::new(numbering.regions(barriers, &triangles)));
            let fresh = now(Slices::new(regions(barriers, None)));
            assert_eq!(ours.len(), fresh.len());
            for (ours, fresh) in ours.iter().zip(&fresh) {
                assert_same_but_for_the_order(ours, fresh);
                assert_is_pattern_of(&ours.unknowns);
            }
        }
    }

    /// Three spokes in a circle, that reach neither the rim nor one another: gaps between the same regions, and several at one
    /// node.
    #[test]
    fn whichever_gaps_are_closed_fronts_have_all_rows_that_go_into_them() {
        let circle = Circle::new((300.0, 300.0), 200.0);
        let spoke = |turn: i32| {
            let way = Vec2::from_angle(2.1 * f64::from(turn));
            Line::new(circle.center + 20.0 * way, circle.center + 185.0 * way).to_path(1e-6)
        };
        let paths = (0..3).map(spoke).chain([circle.to_path(1e-6)]);
        let curves = paths.map(|path| Curve { path, line: None }).collect();
        let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
        let map = PlanarMap::build(&drawing, &Sampling::default()).expect("a map").with_gaps_closed(1.0);
        let gap_count = map.gaps().len();
        assert!((6..10).contains(&gap_count), "{gap_count} gaps");
        let mesh = map.refined();
        let triangles: Vec<_> = (0..mesh.triangle_count() as u32).collect();
        let mut open = now(Slices::new(regions(Barriers { mesh, closed_gaps: &[] }, None)));
        let numbering = now(Slices::new(Numbering::new(mesh, &mut open, None)));
        let mut region_counts = Vec::new();
        for closed in 0..1 << gap_count {
            let closed_gaps: Vec<_> = (0..gap_count).map(|gap| closed >> gap & 1 == 1).collect();
            let barriers = Barriers { mesh, closed_gaps: &closed_gaps };
            let ours = now(Slices::new(numbering.regions(barriers, &triangles)));
            let fresh = now(Slices::new(regions(barriers, None)));
            assert_eq!(ours.len(), fresh.len());
            region_counts.push(ours.len());
            for (Dofs { unknowns, .. }, fresh) in ours.iter().zip(&fresh) {
                assert_eq!(unknowns.count, fresh.unknowns.count);
                assert_is_pattern_of(unknowns);
                let is_fixed = |unknown| unknown % 5 == closed % 5;
                assert_has_all_rows(&unknowns.pattern, unknowns.count as u32, &unknowns.of_element, is_fixed);
            }
        }
        assert_eq!((region_counts.first(), region_counts.last()), (Some(&2), Some(&5)));
    }

    #[test]
    fn numbers_depend_on_the_gaps_that_are_closed_alone() {
        let map = map();
        let mesh = map.refined();
        let mut open = now(Slices::new(regions(Barriers { mesh, closed_gaps: &[] }, None)));
        let numbering = now(Slices::new(Numbering::new(mesh, &mut open, None)));
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

    /// Groups and boundaries ascend, and a group touches all that its elements and its children have.
    fn assert_is_pattern_of(unknowns: &Unknowns) {
        let groups: Vec<_> = unknowns.pattern.groups().collect();
        assert!(groups.windows(2).all(|both| both[0].0.end == both[1].0.start));
        assert_eq!(groups.last().expect("a group").0.end, unknowns.count as u32);
        let group_of = |unknown: u32| groups.partition_point(|(own, _)| own.end <= unknown);
        let boundaries = groups.iter().map(|(_, boundary)| boundary.to_vec());
        for coupled in boundaries.chain(unknowns.of_element.iter().map(|own| own.to_vec())) {
            let Some(&first) = coupled.iter().min() else { continue };
            let (own, boundary) = &groups[group_of(first)];
            assert!(coupled.iter().all(|unknown| own.contains(unknown) || boundary.contains(unknown)));
        }
        assert!(groups.iter().all(|(own, boundary)| {
            !own.is_empty() && [&[own.end - 1], *boundary].concat().is_sorted_by(|a, b| a < b)
        }));
    }

    fn assert_same(a: &Dofs, b: &Dofs) {
        assert_eq!((&a.triangles, &a.gaps), (&b.triangles, &b.gaps));
        assert_eq!(a.unknowns.of_element, b.unknowns.of_element);
        assert_eq!(a.unknowns.count, b.unknowns.count);
        assert!(a.unknowns.pattern.groups().eq(b.unknowns.pattern.groups()));
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
                assert!(!mem::replace(&mut is_taken[our as usize], true), "{our} stands for two");
            }
            assert_eq!(name_of[their as usize], our, "for {their}");
        }
    }
}
