//! The minimum cut of a grid of pixels: Y. Boykov, V. Kolmogorov, *An Experimental Comparison of Min-Cut/Max-Flow
//! Algorithms for Energy Minimization in Vision*, IEEE TPAMI 26 (2004), 1124–1137.
//!
//! Two trees of pixels grow from source and sink; where they touch, flow goes along the path, and what the saturated
//! edges cut off is adopted elsewhere or set free. Distances to the roots, marked with the time at which they were
//! found, keep the paths short, as in the authors' own programme.

use std::collections::VecDeque;

/// Who holds a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Tree {
    Free,
    Source,
    Sink,
}

/// What a pixel hangs on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Parent {
    None,
    /// Source or sink itself.
    Root,
    /// The neighbour in that direction.
    Neighbor(u8),
}

/// One pixel of the grid.
#[derive(Clone, Copy, Debug)]
struct Node {
    /// Capacity left towards each neighbour: up, left, right, down.
    residual: [i32; 4],
    /// Capacity left from the source, or, negative, to the sink.
    pull: i32,
    tree: Tree,
    parent: Parent,
    is_active: bool,
    /// Steps to the root, as of `time`.
    distance: u32,
    time: u32,
}

const IDLE: Node = Node {
    residual: [0; 4],
    pull: 0,
    tree: Tree::Free,
    parent: Parent::None,
    is_active: false,
    distance: 0,
    time: 0,
};

/// A grid of pixels with capacities between neighbours and to source and sink.
#[derive(Clone, Debug)]
pub(super) struct GridCut {
    width: usize,
    /// With a border of idle nodes, so that all neighbours are there.
    nodes: Vec<Node>,
    active: VecDeque<usize>,
    orphans: VecDeque<usize>,
    time: u32,
}

impl GridCut {
    /// A grid without capacities.
    pub(super) fn new(width: usize, height: usize) -> Self {
        let nodes = vec![IDLE; (width + 2) * (height + 2)];
        Self { width, nodes, active: VecDeque::new(), orphans: VecDeque::new(), time: 0 }
    }

    /// Adds capacity from the source to a pixel or, where negative, from the pixel to the sink.
    pub(super) fn pull(&mut self, pixel: usize, capacity: i32) {
        let node = self.node_of(pixel);
        self.nodes[node].pull += capacity;
    }

    /// Sets the capacity between two pixels, either way. Pixels that are no neighbours are left as they are.
    pub(super) fn join(&mut self, a: usize, b: usize, capacity: i32) {
        let [a, b] = [a, b].map(|pixel| self.node_of(pixel));
        if let Some(to) = (0..4).find(|&to| self.neighbor(a, to) == b) {
            self.nodes[a].residual[usize::from(to)] = capacity;
            self.nodes[b].residual[usize::from(3 - to)] = capacity;
        }
    }

    /// For each pixel whether it is on the source's side of the minimum cut that has the fewest pixels there.
    pub(super) fn cut(mut self) -> Vec<bool> {
        self.plant();
        while let Some((node, to)) = self.grow() {
            self.time += 1;
            self.augment(node, to);
            while let Some(orphan) = self.orphans.pop_front() {
                self.adopt(orphan);
            }
        }
        let rows = self.nodes.chunks_exact(self.width + 2);
        let inner = rows.skip(1).flat_map(|row| &row[1..=self.width]);
        let count = self.nodes.len() / (self.width + 2) - 2;
        inner.take(count * self.width).map(|node| node.tree == Tree::Source).collect()
    }

    fn node_of(&self, pixel: usize) -> usize {
        (pixel / self.width + 1) * (self.width + 2) + pixel % self.width + 1
    }

    fn neighbor(&self, node: usize, to: u8) -> usize {
        match to {
            0 => node - (self.width + 2),
            1 => node - 1,
            2 => node + 1,
            _ => node + (self.width + 2),
        }
    }

    /// Roots all pixels that source or sink pull.
    fn plant(&mut self) {
        for node in 0..self.nodes.len() {
            let pull = self.nodes[node].pull;
            if pull != 0 {
                let tree = if pull > 0 { Tree::Source } else { Tree::Sink };
                self.hang(node, tree, Parent::Root, 1);
                self.activate(node);
            }
        }
    }

    fn hang(&mut self, node: usize, tree: Tree, parent: Parent, distance: u32) {
        let time = self.time;
        self.nodes[node] = Node { tree, parent, distance, time, ..self.nodes[node] };
    }

    fn activate(&mut self, node: usize) {
        if !std::mem::replace(&mut self.nodes[node].is_active, true) {
            self.active.push_back(node);
        }
    }

    /// What can still flow between a pixel and a neighbour, away from the root of the pixel's tree.
    fn outward(&self, node: usize, to: u8) -> i32 {
        match self.nodes[node].tree {
            Tree::Sink => self.nodes[self.neighbor(node, to)].residual[usize::from(3 - to)],
            _ => self.nodes[node].residual[usize::from(to)],
        }
    }

    /// What can still flow between a pixel and a neighbour, towards the root of the pixel's tree.
    fn inward(&self, node: usize, to: u8) -> i32 {
        match self.nodes[node].tree {
            Tree::Sink => self.nodes[node].residual[usize::from(to)],
            _ => self.nodes[self.neighbor(node, to)].residual[usize::from(3 - to)],
        }
    }

    /// Grows the trees until they touch: the edge from a pixel of the source's tree to one of the sink's.
    fn grow(&mut self) -> Option<(usize, u8)> {
        while let Some(&node) = self.active.front() {
            if self.nodes[node].tree != Tree::Free
                && let Some(to) = (0..4).find(|&to| self.outward(node, to) > 0 && self.reach(node, to))
            {
                let is_source = self.nodes[node].tree == Tree::Source;
                return Some(if is_source { (node, to) } else { (self.neighbor(node, to), 3 - to) });
            }
            self.active.pop_front();
            self.nodes[node].is_active = false;
        }
        None
    }

    /// Reaches out to a neighbour; whether it is the other tree's.
    fn reach(&mut self, node: usize, to: u8) -> bool {
        let neighbor = self.neighbor(node, to);
        let [here, there] = [node, neighbor].map(|node| self.nodes[node]);
        let is_closer = here.time >= there.time && here.distance + 1 < there.distance;
        if there.tree == Tree::Free || (there.tree == here.tree && is_closer) {
            self.nodes[neighbor] = Node {
                tree: here.tree,
                parent: Parent::Neighbor(3 - to),
                distance: here.distance + 1,
                time: here.time,
                ..there
            };
            if there.tree == Tree::Free {
                self.activate(neighbor);
            }
            return false;
        }
        there.tree != here.tree
    }

    /// Sends as much as fits from source to sink along an edge between the trees.
    fn augment(&mut self, node: usize, to: u8) {
        let sink_node = self.neighbor(node, to);
        let between = self.nodes[node].residual[usize::from(to)];
        let amount = between.min(self.narrowest(node)).min(self.narrowest(sink_node));
        self.nodes[node].residual[usize::from(to)] -= amount;
        self.nodes[sink_node].residual[usize::from(3 - to)] += amount;
        self.send(node, amount);
        self.send(sink_node, amount);
    }

    /// What fits along the path from a pixel to its root.
    fn narrowest(&self, mut node: usize) -> i32 {
        let mut narrowest = i32::MAX;
        while let Parent::Neighbor(to) = self.nodes[node].parent {
            narrowest = narrowest.min(self.inward(node, to));
            node = self.neighbor(node, to);
        }
        narrowest.min(self.nodes[node].pull.abs())
    }

    /// Takes an amount off the path from a pixel to its root; what hangs on a full edge is an orphan.
    fn send(&mut self, mut node: usize, amount: i32) {
        while let Parent::Neighbor(to) = self.nodes[node].parent {
            let parent = self.neighbor(node, to);
            let signed = if self.nodes[node].tree == Tree::Sink { amount } else { -amount };
            self.nodes[node].residual[usize::from(to)] -= signed;
            self.nodes[parent].residual[usize::from(3 - to)] += signed;
            if self.inward(node, to) == 0 {
                self.orphan(node);
            }
            node = parent;
        }
        let pull = &mut self.nodes[node].pull;
        *pull -= amount * pull.signum();
        if *pull == 0 {
            self.orphan(node);
        }
    }

    fn orphan(&mut self, node: usize) {
        self.nodes[node].parent = Parent::None;
        self.orphans.push_back(node);
    }

    /// Hangs an orphan on the neighbour of its tree that is nearest to the root, or sets it free.
    fn adopt(&mut self, node: usize) {
        let tree = self.nodes[node].tree;
        let mut nearest: Option<(u32, u8)> = None;
        for to in 0..4 {
            let neighbor = self.neighbor(node, to);
            if self.nodes[neighbor].tree == tree
                && self.inward(node, to) > 0
                && let Some(distance) = self.distance(neighbor)
            {
                nearest = Some(nearest.map_or((distance, to), |nearest| nearest.min((distance, to))));
            }
        }
        match nearest {
            Some((distance, to)) => self.hang(node, tree, Parent::Neighbor(to), distance + 1),
            None => self.set_free(node),
        }
    }

    /// Steps from a pixel to its root, or `None` where the path ends at an orphan.
    fn distance(&mut self, node: usize) -> Option<u32> {
        let (mut at, mut steps) = (node, 0);
        let total = loop {
            let Node { parent, time, distance, .. } = self.nodes[at];
            if time == self.time && parent != Parent::None {
                break steps + distance;
            }
            match parent {
                Parent::None => return None,
                Parent::Root => break steps + 1,
                Parent::Neighbor(to) => at = self.neighbor(at, to),
            }
            steps += 1;
        };
        self.note_distances(node, total);
        Some(total)
    }

    /// Notes the distances of all pixels on the path to the root that are not known for this time.
    fn note_distances(&mut self, mut node: usize, mut distance: u32) {
        while self.nodes[node].time != self.time {
            self.nodes[node].time = self.time;
            self.nodes[node].distance = distance;
            distance -= 1;
            let Parent::Neighbor(to) = self.nodes[node].parent else { return };
            node = self.neighbor(node, to);
        }
    }

    fn set_free(&mut self, node: usize) {
        let tree = self.nodes[node].tree;
        for to in 0..4 {
            let neighbor = self.neighbor(node, to);
            if self.nodes[neighbor].tree == tree {
                if self.inward(node, to) > 0 {
                    self.activate(neighbor);
                }
                if self.nodes[neighbor].parent == Parent::Neighbor(3 - to) {
                    self.orphan(neighbor);
                }
            }
        }
        self.nodes[node].tree = Tree::Free;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WIDTH: usize = 4;
    const HEIGHT: usize = 3;
    const COUNT: usize = WIDTH * HEIGHT;

    /// A small problem with capacities from a fixed sequence.
    struct Problem {
        pulls: [i32; COUNT],
        /// Pairs of neighbours.
        joins: Vec<(usize, usize, i32)>,
    }

    impl Problem {
        fn new(seed: u32) -> Self {
            let mut state = seed;
            let mut next = |below: u32| {
                state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                (state >> 16) % below
            };
            let pulls = [(); COUNT].map(|()| if next(3) == 0 { next(21) as i32 - 10 } else { 0 });
            let right = (0..COUNT).filter(|pixel| pixel % WIDTH + 1 < WIDTH).map(|pixel| (pixel, pixel + 1));
            let down = (0..COUNT - WIDTH).map(|pixel| (pixel, pixel + WIDTH));
            let joins = right.chain(down).map(|(a, b)| (a, b, next(7) as i32)).collect();
            Self { pulls, joins }
        }

        /// What it costs to cut off these pixels with the source.
        fn cost(&self, with_source: impl Fn(usize) -> bool) -> i32 {
            let pulled = |pixel: usize| match self.pulls[pixel] {
                pull if with_source(pixel) => (-pull).max(0),
                pull => pull.max(0),
            };
            let cut = self.joins.iter().filter(|(a, b, _)| with_source(*a) != with_source(*b));
            (0..COUNT).map(pulled).sum::<i32>() + cut.map(|(_, _, capacity)| capacity).sum::<i32>()
        }
    }

    #[test]
    fn no_cut_is_cheaper() {
        for seed in 0..60 {
            let problem = Problem::new(seed);
            let mut grid = GridCut::new(WIDTH, HEIGHT);
            problem.pulls.iter().enumerate().for_each(|(pixel, pull)| grid.pull(pixel, *pull));
            problem.joins.iter().for_each(|(a, b, capacity)| grid.join(*a, *b, *capacity));
            let cut = grid.cut();
            let least = (0..1_u32 << COUNT).map(|set| problem.cost(|pixel| set >> pixel & 1 == 1)).min();
            assert_eq!(Some(problem.cost(|pixel| cut[pixel])), least, "problem {seed}");
        }
    }
}
