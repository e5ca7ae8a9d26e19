//! The walls at the nodes of a map, and the corners between them.

use kurbo::Vec2;
use scumble_core::sets::Sets;
use scumble_core::{Bends, Boundary, SideId, sort};

use super::super::straights::{Straight, straights};
use super::corner::{Corner, Face, Ray, SHORT_PX};
use super::ground::Ground;

/// Pieces of walls at the feet of needles are taken for none where their ends are nearer to each other than this, in px: where
/// lines cross, they are put on a lattice and may have such pieces in common.
const NO_PIECE_PX: f64 = 0.01;

/// All walls, by the nodes that they begin at, and by their angles there.
pub(super) struct Walls<'a> {
    ground: &'a Ground<'a>,
    rays: Vec<Ray>,
}

impl<'a> Walls<'a> {
    pub(super) fn new(ground: &'a Ground<'a>, bends: &Bends, boundary: &Boundary) -> Self {
        let face = |side: SideId, end: usize| {
            let colors = boundary.sides.get(side.index()).copied().flatten();
            Face { side: Some(side), color: colors.map(|colors| colors[end]) }
        };
        let piece = |Straight { piece, parts, ends: [a, b] }: Straight| {
            let [node, end] = ground.map.pieces()[piece].nodes;
            let [left, right] = [false, true].map(|is_right| SideId::of(piece, is_right));
            let first = Ray { node, end, along: b - a, faces: [face(left, 0), face(right, 2)] };
            let last = Ray { node: end, end: node, along: a - b, faces: [face(right, 0), face(left, 2)] };
            [(parts[0] == 0.0).then_some(first), (parts[1] == 1.0).then_some(last)].into_iter().flatten()
        };
        let gap = |[start, end]: [u32; 2]| {
            let along = ground.place(end) - ground.place(start);
            let ray = |node, end, along: Vec2| Ray { node, end, along, faces: [Face::default(); 2] };
            [ray(start, end, along), ray(end, start, -along)]
        };
        let pieces = straights(ground.map, bends, ground.centers_from_du).flat_map(piece);
        let gaps = ground.map.closed_gaps(ground.closed_gaps).flat_map(|closed| gap(closed.nodes));
        let mut walls = Self { ground, rays: pieces.chain(gaps).collect() };
        walls.sort();
        walls.join();
        walls
    }

    fn sort(&mut self) {
        sort::sort_copies_by_key(&mut self.rays, |ray| sort::float(ray.along.atan2()));
        sort::sort_copies_by_key(&mut self.rays, |ray| ray.node.into());
    }

    /// Takes nodes for one between which there is next to no piece, where lines end so close by that they may be needles.
    fn join(&mut self) {
        let feet = self.nodes().filter(|around| around.len() == 1).map(|tip| self.end_of(&tip[0])[1]);
        let is_none = |ray: &&Ray| {
            let [start, end] = [ray.node, ray.end].map(|node| self.ground.place(node));
            start.distance(end) < NO_PIECE_PX && self.at(ray.end).len() > 1
        };
        let pairs = feet.flat_map(|foot| self.at(foot).iter().filter(is_none));
        let pairs: Vec<_> = pairs.map(|ray| [ray.node, ray.end]).collect();
        if pairs.is_empty() {
            return;
        }
        let mut joined = Sets::new(self.ground.map.triangulation().points().len());
        for pair in pairs {
            let [a, b] = pair.map(|node| joined.find(node));
            joined.join(a.max(b), a.min(b));
        }
        for ray in &mut self.rays {
            [ray.node, ray.end] = [ray.node, ray.end].map(|node| joined.find(node));
        }
        self.rays.retain(|ray| ray.node != ray.end);
        self.sort();
    }

    /// The walls at each node.
    fn nodes(&self) -> impl Iterator<Item = &[Ray]> {
        self.rays.chunk_by(|a, b| a.node == b.node)
    }

    /// The walls at a node.
    fn at(&self, node: u32) -> &[Ray] {
        let from = |node| self.rays.partition_point(|ray| ray.node < node);
        &self.rays[from(node)..from(node + 1)]
    }

    pub(super) fn corners(&self) -> Vec<Corner> {
        self.nodes().flat_map(|around| self.corners_at(around)).collect()
    }

    /// The corners at a node. What lies around a needle is one, at its foot.
    fn corners_at(&self, around: &[Ray]) -> Vec<Corner> {
        let tip = self.ground.place(around[0].node);
        let needles: Vec<_> = (0..around.len()).map(|i| self.around_needle(around, i)).collect();
        let nexts = (1..around.len()).chain([0]);
        let pairs = nexts.enumerate().filter(|&(i, next)| needles[i].is_none() && needles[next].is_none());
        let corners = pairs.map(|(i, next)| Corner::between(tip, &around[i], &around[next]));
        let is_tip = around.len() == 1 && self.is_needle(&around[0]);
        corners.filter(|_| !is_tip).chain(needles.iter().flatten().copied()).collect()
    }

    /// Whether a wall is a needle, seen from its tip.
    fn is_needle(&self, tip: &Ray) -> bool {
        let [before, foot] = self.end_of(tip);
        let around = self.at(foot);
        let back = around.iter().position(|ray| ray.end == before);
        back.is_some_and(|i| self.around_needle(around, i).is_some())
    }

    /// What lies around one of the walls at a node, if it is a needle there.
    fn around_needle(&self, around: &[Ray], i: usize) -> Option<Corner> {
        let (count, needle) = (around.len(), &around[i]);
        let tip = (count > 2).then(|| self.end_of(needle)[1]).filter(|&tip| self.at(tip).len() == 1)?;
        let near = [&around[(i + count - 1) % count], needle, &around[(i + 1) % count]];
        let [foot, tip] = [needle.node, tip].map(|node| self.ground.place(node));
        Corner::around_needle(foot, near, foot.distance(tip))
    }

    /// The node at which a wall ends, or others meet it, unless it is long, and the one before.
    fn end_of(&self, wall: &Ray) -> [u32; 2] {
        let from = self.ground.place(wall.node);
        let [mut before, mut node] = [wall.node, wall.end];
        while let [one, other] = self.at(node)
            && self.ground.place(node).distance(from) < SHORT_PX
        {
            let next = if one.end == before { other.end } else { one.end };
            [before, node] = [node, next];
        }
        [before, node]
    }
}
