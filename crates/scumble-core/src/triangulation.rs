//! A triangulation as flat arrays of half-edges: the form that everything after the planar map walks.
//!
//! Half-edge `3 t + i` runs from corner `i` to corner `i + 1` of triangle `t`, which lies to its left. *Left* is
//! where `(dest − origin) × (p − origin) > 0`; on a page whose y axis points down that is the right hand.

mod halved;

use kurbo::Point;

use crate::pace::{self, Slices, now};
use crate::sort;

/// One edge of one triangle, in the triangle's direction of turn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct HalfEdge(pub u32);

/// One side of one piece of curve: `2 · piece` is its left, `2 · piece + 1` its right.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SideId(pub u32);

impl HalfEdge {
    /// Half-edge `i` (0..3) of a triangle.
    pub fn of(triangle: usize, i: usize) -> Self {
        Self((3 * triangle + i) as u32)
    }

    /// The triangle that it belongs to.
    pub fn triangle(self) -> usize {
        self.0 as usize / 3
    }

    /// The next one around its triangle.
    pub fn next(self) -> Self {
        Self(if self.0 % 3 == 2 { self.0 - 2 } else { self.0 + 1 })
    }

    /// The one before it around its triangle.
    pub fn prev(self) -> Self {
        Self(if self.0.is_multiple_of(3) { self.0 + 2 } else { self.0 - 1 })
    }

    /// Its place in an array of all half-edges.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

impl SideId {
    /// The left (`right == false`) or right side of a piece.
    pub fn of(piece: usize, right: bool) -> Self {
        Self(2 * piece as u32 + u32::from(right))
    }

    /// The piece whose side it is.
    pub fn piece(self) -> usize {
        self.0 as usize / 2
    }

    /// Whether it is the right side of its piece.
    pub fn is_right(self) -> bool {
        self.0 % 2 == 1
    }

    /// The other side of the same piece.
    pub fn opposite(self) -> Self {
        Self(self.0 ^ 1)
    }

    /// Its place in an array of all sides.
    pub fn index(self) -> usize {
        self.0 as usize
    }
}

/// Absent neighbour in the flat arrays.
const NONE: u32 = u32::MAX;

/// What an edge is to the half-edge that asks.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum Edge {
    /// No curve, and no gap.
    #[default]
    Plain,
    /// One side of a piece of curve.
    Side(SideId),
    /// A gap, by its index, or a part of one.
    Gap(u32),
}

/// Triangles over nodes, some of whose edges are sides of curve pieces.
#[derive(Clone, Debug, Default)]
pub struct Triangulation {
    points: Vec<Point>,
    /// The node that each half-edge starts from.
    origins: Vec<u32>,
    twins: Vec<u32>,
    edges: Vec<Edge>,
}

impl Triangulation {
    /// Builds one from nodes and triangles that turn left, where `side_of(a, b)` names the side that the
    /// half-edge from node `a` to node `b` is, if any.
    ///
    /// Edges that belong to one triangle alone have no twin.
    pub fn new(
        points: Vec<Point>,
        triangles: &[[u32; 3]],
        side_of: impl Fn(u32, u32) -> Option<SideId>,
    ) -> Self {
        let origins = triangles.as_flattened().to_vec();
        let edges = vec![Edge::default(); origins.len()];
        let mut mesh = Self { points, twins: vec![NONE; origins.len()], edges, origins };
        let mut by_ends: Vec<_> = mesh.half_edges().map(|h| (mesh.ends_key(h), h.0)).collect();
        sort::sort(&mut by_ends);
        for pair in by_ends.windows(2).filter(|pair| pair[0].0 == pair[1].0) {
            mesh.twins[pair[0].1 as usize] = pair[1].1;
            mesh.twins[pair[1].1 as usize] = pair[0].1;
        }
        for h in mesh.half_edges() {
            let [a, b] = mesh.ends(h);
            mesh.edges[h.index()] = side_of(a, b).map_or(Edge::Plain, Edge::Side);
        }
        mesh
    }

    /// Takes so many half-edges in order, three to a triangle: origin, its own name and that of its twin, edge. Names are less
    /// than their count; where no half-edge has that of a twin, there is none.
    pub(crate) async fn from_half_edges(
        points: Vec<Point>,
        count: usize,
        name_count: usize,
        half_edges: impl Iterator<Item = (u32, [usize; 2], Edge)>,
    ) -> Self {
        let [mut origins, mut twins] = [(); 2].map(|()| Vec::with_capacity(count));
        let (mut edges, mut named) = (Vec::with_capacity(count), vec![NONE; name_count]);
        pace::for_each((0..).zip(half_edges), |(h, (origin, [own, twin], edge))| {
            named[own] = h;
            origins.push(origin);
            twins.push(twin as u32);
            edges.push(edge);
        })
        .await;
        pace::for_each(&mut twins, |twin| *twin = named[*twin as usize]).await;
        Self { points, origins, twins, edges }
    }

    /// Makes the edges between the given pairs of nodes gaps, in the order of the pairs, and no other edges; sides of
    /// curves stay what they are.
    pub(crate) fn mark_gaps(&mut self, pairs: impl Iterator<Item = [u32; 2]>) {
        let mut by_ends: Vec<_> = (0..).zip(pairs).map(|(gap, ends)| (unordered(ends), gap)).collect();
        sort::sort(&mut by_ends);
        by_ends.dedup_by_key(|(ends, _)| *ends);
        for h in self.half_edges() {
            if self.side(h).is_none() {
                let found = by_ends.binary_search_by_key(&self.ends_key(h), |(ends, _)| *ends);
                self.edges[h.index()] = found.map_or(Edge::Plain, |i| Edge::Gap(by_ends[i].1));
            }
        }
    }

    /// All nodes, in du.
    pub fn points(&self) -> &[Point] {
        &self.points
    }

    /// Number of triangles.
    pub fn triangle_count(&self) -> usize {
        self.origins.len() / 3
    }

    /// All half-edges, triangle by triangle.
    pub fn half_edges(&self) -> impl Iterator<Item = HalfEdge> + use<> {
        (0..self.origins.len() as u32).map(HalfEdge)
    }

    /// The three nodes of a triangle.
    pub fn nodes(&self, triangle: usize) -> [u32; 3] {
        [0, 1, 2].map(|i| self.origins[3 * triangle + i])
    }

    /// The three corners of a triangle, in du.
    pub fn corners(&self, triangle: usize) -> [Point; 3] {
        self.nodes(triangle).map(|node| self.points[node as usize])
    }

    /// The node that a half-edge starts from.
    pub fn origin(&self, h: HalfEdge) -> u32 {
        self.origins[h.index()]
    }

    /// The nodes at its start and its end.
    pub fn ends(&self, h: HalfEdge) -> [u32; 2] {
        [self.origin(h), self.origin(h.next())]
    }

    /// Where it starts and ends, in du.
    pub fn segment(&self, h: HalfEdge) -> [Point; 2] {
        self.ends(h).map(|node| self.points[node as usize])
    }

    /// The same edge in the triangle on the other side, or `None` on the outer border.
    pub fn twin(&self, h: HalfEdge) -> Option<HalfEdge> {
        some(self.twins[h.index()]).map(HalfEdge)
    }

    /// The side of a curve piece that it is, or `None` for an edge that is no curve.
    pub fn side(&self, h: HalfEdge) -> Option<SideId> {
        if let Edge::Side(side) = self.edges[h.index()] { Some(side) } else { None }
    }

    /// The gap that it is or is a part of, as an index into [`crate::PlanarMap::gaps`]; `None` for any other edge.
    pub fn gap(&self, h: HalfEdge) -> Option<u32> {
        if let Edge::Gap(gap) = self.edges[h.index()] { Some(gap) } else { None }
    }

    /// The twin, if the edge is no curve: the way from one triangle to the next. Gaps are ways like others.
    pub fn passage(&self, h: HalfEdge) -> Option<HalfEdge> {
        if self.side(h).is_some() { None } else { self.twin(h) }
    }

    /// Turns around the end of a side, through what `is_open`, to the next one; `None` where there is none.
    pub(crate) fn side_after(&self, h: HalfEdge, is_open: impl Fn(HalfEdge) -> bool) -> Option<SideId> {
        let mut out = h.next();
        while let Some(twin) = self.passage(out).filter(|_| is_open(out)) {
            out = twin.next();
        }
        self.side(out)
    }

    /// Numbers the sets of triangles that are joined without crossing a curve: per triangle its region, counted
    /// from 0 in the order of each region's first triangle; and the number of regions.
    pub fn regions(&self) -> (Vec<u32>, usize) {
        now(self.finding_regions())
    }

    /// [`Triangulation::regions`] in slices.
    pub(crate) fn finding_regions(&self) -> Slices<'_, (Vec<u32>, usize)> {
        Slices::new(self.parts(true))
    }

    /// The same as [`Triangulation::regions`] for rooms, the parts of regions that gaps part.
    pub fn rooms(&self) -> (Vec<u32>, usize) {
        now(self.finding_rooms())
    }

    /// [`Triangulation::rooms`] in slices.
    pub(crate) fn finding_rooms(&self) -> Slices<'_, (Vec<u32>, usize)> {
        Slices::new(self.parts(false))
    }

    async fn parts(&self, gaps_are_open: bool) -> (Vec<u32>, usize) {
        let mut part_of = vec![NONE; self.triangle_count()];
        let (mut firsts, mut stack, mut count) = (0..part_of.len(), Vec::new(), 0);
        pace::repeat(|| {
            if let Some(t) = stack.pop() {
                self.spread(t, &mut part_of, &mut stack, gaps_are_open);
                return true;
            }
            let first = firsts.next();
            if let Some(first) = first.filter(|&first| part_of[first] == NONE) {
                part_of[first] = count;
                count += 1;
                stack.push(first);
            }
            first.is_some()
        })
        .await;
        (part_of, count as usize)
    }

    /// Gives the part of a triangle to those beside it that have none, and adds these to the ones that it is to be spread from.
    fn spread(&self, t: usize, part_of: &mut [u32], stack: &mut Vec<usize>, gaps_are_open: bool) {
        let ways = (0..3).map(|i| HalfEdge::of(t, i)).filter(|&h| gaps_are_open || self.gap(h).is_none());
        for next in ways.filter_map(|h| self.passage(h)).map(HalfEdge::triangle) {
            if part_of[next] == NONE {
                part_of[next] = part_of[t];
                stack.push(next);
            }
        }
    }

    fn ends_key(&self, h: HalfEdge) -> u64 {
        unordered(self.ends(h))
    }
}

/// The same key for both orders of a pair.
fn unordered([a, b]: [u32; 2]) -> u64 {
    sort::pair([a.min(b), a.max(b)])
}

fn some(index: u32) -> Option<u32> {
    (index != NONE).then_some(index)
}
