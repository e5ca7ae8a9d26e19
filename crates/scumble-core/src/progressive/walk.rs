//! The cheapest closed walk that crosses a cut an odd number of times: a shortest path between the two sheets of the
//! double cover. Exact, where the paper lists circuits.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use crate::sort;

/// A directed edge of a graph with a cut through it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Edge {
    pub(super) from: u32,
    pub(super) to: u32,
    /// Not negative.
    pub(super) cost: f64,
    pub(super) is_jump: bool,
    /// Whether it crosses the cut an odd number of times.
    pub(super) is_odd: bool,
}

/// The edges of the cheapest closed walk that crosses the cut an odd number of times, in order; `None` where there
/// is none.
pub(super) fn cheapest_odd_walk(vertex_count: usize, edges: &[Edge]) -> Option<Vec<usize>> {
    let mut search = Search::new(vertex_count, edges);
    let mut starts: Vec<u32> = edges.iter().filter(|edge| edge.is_odd).map(|edge| edge.from).collect();
    sort::sort_unique(&mut starts);
    let mut best = (f64::INFINITY, None);
    for start in starts {
        if let Some((cost, walk)) = search.around(start, best.0) {
            best = (cost, Some(walk));
        }
    }
    best.1
}

/// Shortest paths over (vertex, sheet), numbered `2 · vertex + sheet`.
struct Search<'a> {
    edges: &'a [Edge],
    /// Edges by the vertex that they leave.
    order: Vec<usize>,
    first: Vec<usize>,
    cost: Vec<f64>,
    /// The edge over which each state was reached.
    by: Vec<usize>,
    reached: Vec<usize>,
    queue: BinaryHeap<Reverse<(Cost, usize)>>,
}

impl<'a> Search<'a> {
    fn new(vertex_count: usize, edges: &'a [Edge]) -> Self {
        let mut order: Vec<usize> = (0..edges.len()).collect();
        sort::sort_copies_by_key(&mut order, |&edge| edges[edge].from.into());
        let first = |vertex: usize| order.partition_point(|&edge| (edges[edge].from as usize) < vertex);
        Self {
            edges,
            first: (0..=vertex_count).map(first).collect(),
            order,
            cost: vec![f64::INFINITY; 2 * vertex_count],
            by: vec![usize::MAX; 2 * vertex_count],
            reached: Vec::new(),
            queue: BinaryHeap::new(),
        }
    }

    /// The cheapest walk from a vertex to itself on the other sheet, if it costs less than `bound`.
    fn around(&mut self, start: u32, bound: f64) -> Option<(f64, Vec<usize>)> {
        for state in self.reached.drain(..) {
            self.cost[state] = f64::INFINITY;
        }
        self.queue.clear();
        let [home, goal] = [2 * start as usize, 2 * start as usize + 1];
        self.relax(home, 0.0, usize::MAX, bound);
        while let Some(Reverse((Cost(cost), state))) = self.queue.pop() {
            if state == goal {
                return Some((cost, self.walk_to(goal, home)));
            }
            if cost > self.cost[state] {
                continue;
            }
            for i in self.first[state / 2]..self.first[state / 2 + 1] {
                let edge = self.edges[self.order[i]];
                let to = 2 * edge.to as usize + ((state % 2) ^ usize::from(edge.is_odd));
                self.relax(to, cost + edge.cost, self.order[i], bound);
            }
        }
        None
    }

    fn relax(&mut self, state: usize, cost: f64, by: usize, bound: f64) {
        if cost < self.cost[state] && cost < bound {
            self.cost[state] = cost;
            self.by[state] = by;
            self.reached.push(state);
            self.queue.push(Reverse((Cost(cost), state)));
        }
    }

    fn walk_to(&self, goal: usize, home: usize) -> Vec<usize> {
        let mut walk = Vec::new();
        let mut state = goal;
        while state != home {
            let edge = self.by[state];
            walk.push(edge);
            state = 2 * self.edges[edge].from as usize + ((state % 2) ^ usize::from(self.edges[edge].is_odd));
        }
        walk.reverse();
        walk
    }
}

/// A cost as an order for the queue.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Cost(f64);

impl Eq for Cost {}

impl PartialOrd for Cost {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cost {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    const VERTICES: usize = 6;

    fn edge() -> impl Strategy<Value = Edge> {
        let vertex = || 0..VERTICES as u32;
        (vertex(), vertex(), 0..20_u32, any::<bool>()).prop_map(|(from, to, cost, is_odd)| Edge {
            from,
            to,
            cost: f64::from(cost),
            is_jump: false,
            is_odd,
        })
    }

    /// All shortest ways between the states of the double cover (Floyd & Warshall).
    fn least(edges: &[Edge]) -> f64 {
        let mut cost = vec![[f64::INFINITY; 2 * VERTICES]; 2 * VERTICES];
        for edge in edges {
            for sheet in 0..2 {
                let to = 2 * edge.to as usize + (sheet ^ usize::from(edge.is_odd));
                let cost = &mut cost[2 * edge.from as usize + sheet][to];
                *cost = cost.min(edge.cost);
            }
        }
        for by in 0..2 * VERTICES {
            for from in 0..2 * VERTICES {
                for to in 0..2 * VERTICES {
                    cost[from][to] = cost[from][to].min(cost[from][by] + cost[by][to]);
                }
            }
        }
        (0..VERTICES).map(|vertex| cost[2 * vertex][2 * vertex + 1]).fold(f64::INFINITY, f64::min)
    }

    proptest! {
        #[test]
        fn no_closed_walk_across_the_cut_is_cheaper(edges in proptest::collection::vec(edge(), 0..20)) {
            let Some(walk) = cheapest_odd_walk(VERTICES, &edges) else {
                prop_assert_eq!(least(&edges), f64::INFINITY);
                return Ok(());
            };
            prop_assert_eq!(walk.iter().map(|&edge| edges[edge].cost).sum::<f64>(), least(&edges));
            prop_assert!(walk.iter().filter(|&&edge| edges[edge].is_odd).count() % 2 == 1);
            let next = walk.iter().cycle().skip(1);
            prop_assert!(walk.iter().zip(next).all(|(&edge, &next)| edges[edge].to == edges[next].from));
        }
    }
}
