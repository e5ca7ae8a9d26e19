//! What no colour passes in a mesh: the sides of curves, the frame, and gaps that are closed.

use scumble_core::pace::{self, Pace};
use scumble_core::{HalfEdge, Triangulation};

/// A triangle that is in no region yet.
const NONE: u32 = u32::MAX;

/// A mesh and which of its gaps are closed; gaps beyond the end of the list are open.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Barriers<'a> {
    pub(crate) mesh: &'a Triangulation,
    pub(crate) closed_gaps: &'a [bool],
}

impl Barriers<'_> {
    /// Whether a half-edge is the side of a curve, on the frame, or on a closed gap.
    pub(crate) fn is_barrier(self, h: HalfEdge) -> bool {
        self.mesh.side(h).is_some() || self.is_closed_gap(h)
    }

    /// The twin of a half-edge that is no barrier.
    pub(crate) fn passage(self, h: HalfEdge) -> Option<HalfEdge> {
        self.mesh.passage(h).filter(|_| !self.is_closed_gap(h))
    }

    /// Whether it is a part of a gap that is closed.
    pub(crate) fn is_closed_gap(self, h: HalfEdge) -> bool {
        self.mesh.gap(h).is_some_and(|gap| self.closed_gaps.get(gap as usize).copied().unwrap_or(false))
    }

    /// The regions of a set of triangles that ascends, by the first triangle of each; their triangles ascend.
    pub(crate) async fn regions(self, triangles: &[u32]) -> Vec<Vec<u32>> {
        let mut region_of = vec![NONE; self.mesh.triangle_count()];
        let (mut regions, mut pace) = (Vec::new(), Pace::default());
        for &t in triangles {
            if region_of[t as usize] == NONE {
                let count = self.flood(t, regions.len() as u32, &mut region_of).await;
                regions.push(Vec::with_capacity(count));
                pace.work(count).await;
            }
        }
        pace::pause_after(triangles.len()).await;
        triangles.iter().for_each(|&t| regions[region_of[t as usize] as usize].push(t));
        regions
    }

    /// Marks all that is reached from a triangle, and says how many triangles that are.
    async fn flood(self, first: u32, region: u32, region_of: &mut [u32]) -> usize {
        let (mut stack, mut count) = (vec![first as usize], 0);
        region_of[first as usize] = region;
        pace::repeat(|| {
            let Some(t) = stack.pop() else { return false };
            count += 1;
            for twin in (0..3).filter_map(|i| self.passage(HalfEdge::of(t, i))) {
                let next = twin.triangle();
                if region_of[next] == NONE {
                    region_of[next] = region;
                    stack.push(next);
                }
            }
            true
        })
        .await;
        count
    }
}
