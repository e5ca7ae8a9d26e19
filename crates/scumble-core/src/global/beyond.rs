//! What lies behind the gaps: places that no scribble reaches take the colour that comes to them through those gaps
//! that are open to it, and across lines into slivers, on the cheapest way.
//!
//! The flood behind the gaps goes on with the flood before them. Where a place gets wet by a scribble of its own, no
//! way leads through it any more: what had come that way is dried, and flooded anew from around it.

use super::flood::{Cost, Flood, NONE, Ways};
use crate::pace;
use crate::planar_map::PlanarMap;
use crate::triangulation::HalfEdge;

/// The flood behind the gaps.
#[derive(Clone, Debug, Default)]
pub(super) struct Beyond {
    /// Dry where the flood before the gaps is wet.
    flood: Flood,
    /// Per triangle whether the flood before the gaps is there.
    is_before: Vec<bool>,
}

impl Beyond {
    /// Forgets all.
    pub(super) fn reset(&mut self, map: &PlanarMap) {
        self.flood = Flood::new(map, Cost::MAX);
        self.is_before = vec![false; self.flood.labels.len()];
    }

    /// Floods on from what came to the flood before the gaps since the last call, and labels what it comes to.
    pub(super) async fn follow(
        &mut self,
        map: &PlanarMap,
        ways: &Ways,
        ranks: &[u32],
        before: &Flood,
        labels: &mut [u32],
    ) {
        for triangle in self.dry(map, ways, before) {
            let around = (0..3).filter_map(|i| map.refined().passage(HalfEdge::of(triangle, i)));
            around.for_each(|h| self.reach_through(map, ways, ranks, before, h));
        }
        ways.gaps.iter().for_each(|&h| self.reach_through(map, ways, ranks, before, h));
        let is_before = &self.is_before;
        let may_go = |next: usize, h: HalfEdge| ways.lead_through(h) && !is_before[next];
        pace::repeat(|| self.flood.go_on(map, &ways.costs, ranks, may_go)).await;
        for (label, &beyond) in labels.iter_mut().zip(&self.flood.labels).filter(|(label, _)| **label == NONE)
        {
            *label = beyond;
        }
    }

    /// Lets what is on this side of a half-edge, of either flood, come to the other.
    fn reach_through(&mut self, map: &PlanarMap, ways: &Ways, ranks: &[u32], before: &Flood, h: HalfEdge) {
        let Some(to) = map.refined().twin(h).map(HalfEdge::triangle) else { return };
        let from = h.triangle();
        let flood = if self.is_before[from] { before } else { &self.flood };
        let (cost, label) = (flood.costs[from], flood.labels[from]);
        if label != NONE && ways.lead_through(h) && !self.is_before[to] {
            self.flood.reach(to, cost + ways.costs[h.index()], label, ranks);
        }
    }

    /// Dries the triangles that the flood before the gaps has come to, and all that may have been reached through
    /// them; gives all that are dry now and were not.
    fn dry(&mut self, map: &PlanarMap, ways: &Ways, before: &Flood) -> Vec<usize> {
        let is_new = |&t: &usize| before.labels[t] != NONE && !self.is_before[t];
        let new: Vec<usize> = (0..self.is_before.len()).filter(is_new).collect();
        new.iter().for_each(|&t| self.is_before[t] = true);
        let mut stack: Vec<_> = new.into_iter().filter_map(|t| self.take(t)).collect();
        let mut dried = Vec::new();
        while let Some((triangle, cost, label)) = stack.pop() {
            for h in (0..3).map(|i| HalfEdge::of(triangle, i)) {
                let next = map.refined().twin(h).filter(|_| ways.lead_through(h)).map(HalfEdge::triangle);
                let Some(next) = next else { continue };
                if (self.flood.costs[next], self.flood.labels[next])
                    == (cost.saturating_add(ways.costs[h.index()]), label)
                {
                    stack.extend(self.take(next));
                    dried.push(next);
                }
            }
        }
        dried.retain(|&t| !self.is_before[t]);
        dried
    }

    /// Dries a triangle; gives what was there.
    fn take(&mut self, triangle: usize) -> Option<(usize, Cost, u32)> {
        let label = std::mem::replace(&mut self.flood.labels[triangle], NONE);
        let cost = std::mem::replace(&mut self.flood.costs[triangle], Cost::MAX);
        (label != NONE).then_some((triangle, cost, label))
    }
}
