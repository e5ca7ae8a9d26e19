//! The flood: every triangle goes to the scribble with the cheapest way to it (Dijkstra from many seeds).

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::clearance::OPEN_DU;
use crate::planar_map::PlanarMap;
use crate::triangulation::HalfEdge;

/// The cost of a way. Sums are exact: there are at most 2²² triangles, and a step costs less than 2¹⁰¹.
pub(super) type Cost = u128;

/// Widths below this count as this, in du.
const LEAST_WIDTH_DU: f64 = 2.0;

/// Label of a triangle that no scribble reaches.
pub(super) const NONE: u32 = u32::MAX;

/// What it costs to go some way through a passage, both in du.
pub(super) fn cost(length_du: f64, width_du: f64) -> Cost {
    let narrowness = OPEN_DU / width_du.clamp(LEAST_WIDTH_DU, OPEN_DU);
    let squared = narrowness * narrowness;
    let fourth = squared * squared;
    ((1.0 + length_du) * fourth * fourth) as Cost
}

/// What it costs to go from triangle to triangle, per half-edge that is left through.
#[derive(Clone, Debug)]
pub(super) struct Ways {
    pub(super) costs: Vec<Cost>,
    /// Per triangle its room.
    pub(super) rooms: Vec<u32>,
    /// The half-edges that lead through a gap.
    pub(super) gaps: Vec<HalfEdge>,
}

impl Ways {
    pub(super) fn new(map: &PlanarMap) -> Self {
        let mesh = map.triangulation();
        let clearance = map.clearance();
        let centroid = |t: usize| {
            let [a, b, c] = mesh.corners(t).map(|p| p.to_vec2());
            (a + b + c) / 3.0
        };
        let step = |h: HalfEdge| {
            let length_du = |twin: HalfEdge| (centroid(h.triangle()) - centroid(twin.triangle())).hypot();
            mesh.passage(h).map_or(0, |twin| cost(length_du(twin), clearance.widths_du[h.index()]))
        };
        let gaps = mesh.half_edges().filter(|&h| mesh.gap(h).is_some()).collect();
        Self { costs: mesh.half_edges().map(step).collect(), rooms: mesh.rooms().0, gaps }
    }
}

/// Which scribble each triangle belongs to, so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Flood {
    /// Per triangle the scribble, or [`NONE`].
    pub(super) labels: Vec<u32>,
    /// Per triangle the cost of the way to it.
    pub(super) costs: Vec<Cost>,
    /// Cost, rank of the scribble, triangle, scribble.
    front: BinaryHeap<Reverse<(Cost, u32, u32, u32)>>,
}

impl Flood {
    /// A dry map.
    pub(super) fn new(map: &PlanarMap) -> Self {
        let count = map.triangulation().triangle_count();
        Self { labels: vec![NONE; count], costs: vec![Cost::MAX; count], front: BinaryHeap::new() }
    }

    /// Lets a scribble come to a triangle at a cost. Where two come at the same cost, the lower rank wins.
    pub(super) fn reach(&mut self, triangle: usize, cost: Cost, label: u32, ranks: &[u32]) {
        let rank = |label: u32| ranks.get(label as usize).copied().unwrap_or(NONE);
        if (cost, rank(label)) < (self.costs[triangle], rank(self.labels[triangle])) {
            (self.costs[triangle], self.labels[triangle]) = (cost, label);
            self.front.push(Reverse((cost, rank(label), triangle as u32, label)));
        }
    }

    /// Floods on from wherever scribbles have come to, not through gaps.
    pub(super) fn run(&mut self, map: &PlanarMap, ways: &Ways, ranks: &[u32]) {
        self.run_where(map, ways, ranks, |_, h| map.triangulation().gap(h).is_none());
    }

    /// Floods on through the passages that are open to `may_go(next triangle, half-edge)`.
    pub(super) fn run_where(
        &mut self,
        map: &PlanarMap,
        ways: &Ways,
        ranks: &[u32],
        may_go: impl Fn(usize, HalfEdge) -> bool,
    ) {
        let mesh = map.triangulation();
        while let Some(Reverse((cost, _, triangle, label))) = self.front.pop() {
            let triangle = triangle as usize;
            if (cost, label) != (self.costs[triangle], self.labels[triangle]) {
                continue;
            }
            for h in (0..3).map(|i| HalfEdge::of(triangle, i)) {
                if let Some(twin) = mesh.passage(h).filter(|twin| may_go(twin.triangle(), h)) {
                    self.reach(twin.triangle(), cost + ways.costs[h.index()], label, ranks);
                }
            }
        }
    }
}
