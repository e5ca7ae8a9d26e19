//! Degrees of freedom: which unknowns a triangle has at its corners and in the middle of its edges.
//!
//! Around a node the triangles fall into sectors, separated by curves and closed gaps; all corners of one sector share
//! an unknown. At the tip of a curve the sector goes all the way round, so there the two sides meet. The two triangles
//! at an edge share the unknown in its middle, unless the edge is a side of a curve or a part of a closed gap.

use std::sync::Arc;

use kurbo::Vec2;
use scumble_core::pace;
use scumble_core::{HalfEdge, SideColors, SideId, Triangulation, sort};

use super::order::{corner_rank, elimination_rank};
use super::pattern::Pattern;
use crate::barriers::Barriers;

/// Unknown that is not numbered yet, or anything else that is not there.
pub(super) const NONE: u32 = u32::MAX;

/// The triangles of one region and their unknowns, counted from 0 in each region.
#[derive(Debug)]
pub(super) struct Dofs {
    /// Triangles of the mesh, in ascending order; each is an element, or none is.
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
    /// Which are eliminated together; of none before they are in the order of elimination.
    pub(super) pattern: Arc<Pattern>,
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

impl Dofs {
    /// A region of so many triangles with these unknowns: finds what bounds it, if it has unknowns.
    pub(super) async fn new(barriers: Barriers<'_>, triangles: Vec<u32>, unknowns: Unknowns) -> Self {
        let (mut sides, mut gaps, mut walls) = (Vec::new(), Vec::new(), Vec::new());
        pace::for_each(triangles.iter().zip(&unknowns.of_element), |(&t, dofs)| {
            for (i, h) in half_edges(t).enumerate() {
                let ends = [dofs[i], dofs[(i + 1) % 3]];
                let side = |id| Side { id, dofs: [ends[0], dofs[3 + i], ends[1]] };
                sides.extend(barriers.mesh.side(h).map(side));
                gaps.extend(barriers.mesh.gap(h));
                if barriers.passage(h).is_none() {
                    walls.push((h, ends));
                }
            }
        })
        .await;
        sort::sort_unique(&mut gaps);
        let corners = corners(barriers.mesh, &walls, unknowns.count).await;
        pace::pause_after(triangles.len()).await;
        Self { triangles, unknowns, sides, corners, gaps }
    }

    /// Whether its sides have several colours.
    pub(super) fn blends(&self, colors: &SideColors) -> bool {
        let mut given = self.sides.iter().filter_map(|side| colors.get(side.id.index())?.as_ref()).flatten();
        given.next().is_some_and(|first| given.any(|color| color != first))
    }

    /// Renumbers the unknowns, of which those at corners come first, in the order of elimination that the corners are in.
    /// Says where groups of them end there that are eliminated together.
    pub(super) fn order(&mut self, corner_rank: &[u32]) -> Vec<u32> {
        let (rank, ends) = self.unknowns.order_by(corner_rank);
        let of_sides = self.sides.iter_mut().flat_map(|side| &mut side.dofs);
        of_sides.for_each(|dof| *dof = rank[*dof as usize]);
        self.corners.iter_mut().for_each(|corner| corner.dof = rank[corner.dof as usize]);
        ends
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
        Self { of_element: elements, pattern: Arc::default(), count: count as usize }
    }

    /// Renumbers them, of which those at corners come first, in the order of elimination.
    pub(super) fn order(&mut self) {
        let (_, ends) = self.order_by(&corner_rank(self));
        self.pattern = Pattern::new(&self.of_element, &ends).into();
    }

    /// The same from an order of the corners; says where in the order of elimination each of them is, and where groups end there.
    fn order_by(&mut self, corner_rank: &[u32]) -> (Vec<u32>, Vec<u32>) {
        let (rank, ends) = elimination_rank(self, corner_rank);
        self.of_element.iter_mut().flatten().for_each(|dof| *dof = rank[*dof as usize]);
        (rank, ends)
    }
}

/// The sectors between walls, each with the unknowns at its ends.
async fn corners(mesh: &Triangulation, walls: &[(HalfEdge, [u32; 2])], count: usize) -> Vec<Corner> {
    let mut ending_at = vec![None; count];
    pace::for_each(walls, |&(h, [_, end])| ending_at[end as usize] = Some(h)).await;
    let corner = |&(h, [dof, _]): &(HalfEdge, [u32; 2])| {
        let ([from, to], [last, _]) = (mesh.segment(h), mesh.segment(ending_at[dof as usize]?));
        Some(Corner { dof, ways: [to - from, last - from] })
    };
    walls.iter().filter_map(corner).collect()
}

/// The half-edges of a triangle.
pub(super) fn half_edges(t: u32) -> impl Iterator<Item = HalfEdge> {
    (0..3).map(move |i| HalfEdge::of(t as usize, i))
}
