//! Degrees of freedom: which unknowns a triangle has at its corners and in the middle of its edges.
//!
//! Around a node the triangles fall into sectors, separated by curves and closed gaps; all corners of one sector share
//! an unknown. At the tip of a curve the sector goes all the way round, so there the two sides meet. The two triangles
//! at an edge share the unknown in its middle, unless the edge is a side of a curve or a part of a closed gap.

use kurbo::Vec2;
use scumble_core::pace::{self, Pace};
use scumble_core::{HalfEdge, SideId, Triangulation, sort};

use super::order::{corner_rank, elimination_rank, kept_corner_rank};
use crate::barriers::Barriers;

/// Unknown that is not numbered yet, or anything else that is not there.
pub(super) const NONE: u32 = u32::MAX;

/// The triangles of one region and their unknowns, counted from 0 in each region.
#[derive(Debug)]
pub(super) struct Dofs {
    /// Triangles of the mesh, in ascending order; each is an element.
    pub(super) triangles: Vec<u32>,
    pub(super) unknowns: Unknowns,
    /// The sides of curves that bound the region.
    pub(super) sides: Vec<Side>,
    /// The sectors between two walls.
    pub(super) corners: Vec<Corner>,
    /// The gaps that it has a part in, open or closed, in ascending order.
    pub(super) gaps: Vec<u32>,
}

/// The unknowns of some elements, counted from 0.
#[derive(Debug)]
pub(super) struct Unknowns {
    /// Those of each element, at corners 0, 1, 2 and in the middle of edges 01, 12, 20.
    pub(super) of_element: Vec<[u32; 6]>,
    /// Where the groups end that are eliminated together; none before they are in the order of elimination.
    pub(super) group_ends: Vec<u32>,
    pub(super) count: usize,
}

/// A side of a curve.
#[derive(Clone, Copy, Debug)]
pub(super) struct Side {
    pub(super) id: SideId,
    /// The unknowns at its start, middle and end.
    pub(super) dofs: [u32; 3],
}

/// A sector of a node that walls bound: sides of curves, the frame, or closed gaps.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    /// Its unknown.
    pub(super) dof: u32,
    /// Where these walls lead from the node; from the first to the second it is a turn to the left.
    pub(super) ways: [Vec2; 2],
}

/// Numbers the unknowns of all regions of a set of triangles, which is made of whole regions and ascends.
pub(super) async fn number(barriers: Barriers<'_>, triangles: &[u32]) -> Vec<Dofs> {
    let mesh = barriers.mesh;
    let mut numbers = Numbers { barriers, of_triangle: vec![[NONE; 6]; mesh.triangle_count()], next: 0 };
    let (mut regions, mut pace) = (Vec::new(), Pace::default());
    for triangles in barriers.regions(triangles).await {
        pace.work(triangles.len()).await;
        regions.push(numbers.region(triangles).await);
    }
    regions
}

impl Dofs {
    /// Renumbers the unknowns in the order of elimination that the mesh was put in.
    pub(super) async fn order(&mut self, mesh_ranks: &[[u32; 3]]) {
        let corner_rank = kept_corner_rank(self, mesh_ranks);
        pace::pause_after(self.triangles.len()).await;
        let rank = self.unknowns.order_by(&corner_rank);
        let of_sides = self.sides.iter_mut().flat_map(|side| &mut side.dofs);
        of_sides.for_each(|dof| *dof = rank[*dof as usize]);
        self.corners.iter_mut().for_each(|corner| corner.dof = rank[corner.dof as usize]);
    }
}

impl Unknowns {
    /// Those of elements, by other numbers, which may leave some out.
    pub(super) fn of_elements(mut elements: Vec<[u32; 6]>) -> Self {
        let most = elements.as_flattened().iter().fold(0, |most, &dof| most.max(dof as usize + 1));
        let (mut numbers, mut count) = (vec![NONE; most], 0);
        for kind in [0..3, 3..6] {
            for dof in elements.iter_mut().flat_map(|dofs| &mut dofs[kind.clone()]) {
                let number = &mut numbers[*dof as usize];
                if *number == NONE {
                    *number = count;
                    count += 1;
                }
                *dof = *number;
            }
        }
        Self { of_element: elements, group_ends: Vec::new(), count: count as usize }
    }

    /// Renumbers them, of which those at corners come first, in the order of elimination.
    pub(super) fn order(&mut self) {
        self.order_by(&corner_rank(self));
    }

    /// The same from an order of the corners; says where in the order of elimination each of them is.
    fn order_by(&mut self, corner_rank: &[u32]) -> Vec<u32> {
        let (rank, group_ends) = elimination_rank(self, corner_rank);
        self.of_element.iter_mut().flatten().for_each(|dof| *dof = rank[*dof as usize]);
        self.group_ends = group_ends;
        rank
    }
}

/// The unknowns given out so far.
struct Numbers<'a> {
    barriers: Barriers<'a>,
    of_triangle: Vec<[u32; 6]>,
    next: u32,
}

impl Numbers<'_> {
    async fn region(&mut self, triangles: Vec<u32>) -> Dofs {
        self.next = 0;
        pace::for_each(&triangles, |&t| half_edges(&[t]).for_each(|h| self.number_sector(h))).await;
        pace::for_each(&triangles, |&t| half_edges(&[t]).for_each(|h| self.number_middle(h))).await;
        let of_element = triangles.iter().map(|&t| self.of_triangle[t as usize]).collect();
        let sides = self.sides(&triangles);
        pace::pause_after(triangles.len()).await;
        let corners = self.corners(&triangles).await;
        pace::pause_after(triangles.len()).await;
        Dofs {
            unknowns: Unknowns { of_element, group_ends: Vec::new(), count: self.next as usize },
            sides,
            corners,
            gaps: gaps(self.barriers.mesh, &triangles),
            triangles,
        }
    }

    /// Gives one unknown to all corners in the sector of the node that a half-edge starts from.
    fn number_sector(&mut self, h: HalfEdge) {
        if *self.corner(h) != NONE {
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
        while let Some(beside) = next(h).filter(|&beside| *self.corner(beside) == NONE) {
            *self.corner(beside) = self.next;
            h = beside;
        }
    }

    fn number_middle(&mut self, h: HalfEdge) {
        if *self.middle(h) == NONE {
            *self.middle(h) = self.next;
            if let Some(twin) = self.barriers.passage(h) {
                *self.middle(twin) = self.next;
            }
            self.next += 1;
        }
    }

    fn sides(&mut self, triangles: &[u32]) -> Vec<Side> {
        let sides = half_edges(triangles).filter_map(|h| self.barriers.mesh.side(h).map(|id| (id, h)));
        sides
            .map(|(id, h)| Side { id, dofs: [*self.corner(h), *self.middle(h), *self.corner(h.next())] })
            .collect()
    }

    async fn corners(&mut self, triangles: &[u32]) -> Vec<Corner> {
        let (mut walls, barriers) = (Vec::new(), self.barriers);
        let is_wall = |h: &HalfEdge| barriers.passage(*h).is_none();
        pace::for_each(triangles, |&t| walls.extend(half_edges(&[t]).filter(is_wall))).await;
        let mut ends = vec![None; self.next as usize];
        pace::for_each(&walls, |&h| {
            let [from, to] = barriers.mesh.segment(h);
            ends[*self.corner(h.next()) as usize] = Some(from - to);
        })
        .await;
        let corner = |h: HalfEdge| {
            let ([from, to], dof) = (self.barriers.mesh.segment(h), *self.corner(h));
            ends[dof as usize].map(|last| Corner { dof, ways: [to - from, last] })
        };
        walls.into_iter().filter_map(corner).collect()
    }

    fn corner(&mut self, h: HalfEdge) -> &mut u32 {
        &mut self.of_triangle[h.triangle()][h.index() % 3]
    }

    fn middle(&mut self, h: HalfEdge) -> &mut u32 {
        &mut self.of_triangle[h.triangle()][3 + h.index() % 3]
    }
}

fn half_edges(triangles: &[u32]) -> impl Iterator<Item = HalfEdge> {
    triangles.iter().flat_map(|&t| (0..3).map(move |i| HalfEdge::of(t as usize, i)))
}

fn gaps(mesh: &Triangulation, triangles: &[u32]) -> Vec<u32> {
    let mut gaps: Vec<_> = half_edges(triangles).filter_map(|h| mesh.gap(h)).collect();
    sort::sort_unique(&mut gaps);
    gaps
}
