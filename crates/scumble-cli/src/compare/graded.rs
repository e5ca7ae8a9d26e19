//! A picture that is nearly without error: the mesh solver's on a mesh of half the width, whose triangles become smaller and
//! smaller towards every place where the solution may be singular.

use std::collections::BTreeMap;

use kurbo::{Point, Vec2};
use scumble_core::{Blend, BlendColor, Boundary, HalfEdge, PlanarMap, SideColors, SideId, Triangulation};
use scumble_solve::{Field, MeshSolver, SolveError, quadratic};

use super::finer::halved;

/// How many times triangles at such a place are halved.
const LEVELS: usize = 14;

/// The cosine of the least turn of a curve that makes it such a place: 10°.
const TURN_COSINE: f64 = 0.985;

/// The colours of a side at its start, middle and end.
type Colors = [BlendColor; 3];

/// Solves for a boundary.
///
/// # Errors
/// When the solver fails.
pub(super) fn field(map: &PlanarMap, boundary: &Boundary, blend: Blend) -> Result<Field, SolveError> {
    let mesh = map.refined().halved();
    let walls = Walls { mesh: &mesh, colors: halved(&boundary.sides), closed_gaps: &boundary.closed_gaps };
    let mut graded = Graded { points: mesh.points().to_vec(), ..Graded::default() };
    let is_special = walls.special_nodes();
    (0..mesh.triangle_count()).for_each(|t| graded.triangle(&walls, &is_special, t));
    let mesh = graded.mesh();
    let boundary = Boundary { sides: graded.colors, closed_gaps: Vec::new(), ..boundary.clone() };
    MeshSolver::new(mesh).solve(&boundary, blend).cloned()
}

/// What bounds regions of a mesh.
struct Walls<'a> {
    mesh: &'a Triangulation,
    colors: SideColors,
    closed_gaps: &'a [bool],
}

impl Walls<'_> {
    /// The colours of a half-edge that is a wall.
    fn wall(&self, h: HalfEdge) -> Option<Option<Colors>> {
        if let Some(side) = self.mesh.side(h) {
            return Some(self.colors.get(side.index()).copied().flatten());
        }
        let is_closed = |gap: u32| self.closed_gaps.get(gap as usize).copied().unwrap_or(false);
        (self.mesh.gap(h).is_some_and(is_closed)).then_some(None)
    }

    /// Which nodes the solution may be singular at.
    fn special_nodes(&self) -> Vec<bool> {
        let mut around = vec![[Vec::new(), Vec::new()]; self.mesh.points().len()];
        for (h, colors) in self.mesh.half_edges().filter_map(|h| Some((h, self.wall(h)?))) {
            let ([a, b], [from, to]) = (self.mesh.ends(h), self.mesh.segment(h));
            around[a as usize][0].push((to - from, colors.map(|colors| colors[0])));
            around[b as usize][1].push((from - to, colors.map(|colors| colors[2])));
        }
        around
            .iter()
            .map(|[out, into]| !(out.is_empty() && into.is_empty() || is_smooth(out, into)))
            .collect()
    }
}

/// Walls at a node, as they leave it: where they lead, and their colour there.
type Ways = [(Vec2, Option<BlendColor>)];

/// Whether walls that begin and that end at a node are one that goes on straight and in the same colours.
fn is_smooth(out: &Ways, into: &Ways) -> bool {
    let goes_on = |&(from, color): &(Vec2, _)| {
        let is_on = |&(to, other): &(Vec2, _)| {
            -from.dot(to) >= TURN_COSINE * from.hypot() * to.hypot() && color == other
        };
        into.iter().any(is_on)
    };
    out.len() == into.len() && out.len() <= 2 && out.iter().all(goes_on)
}

/// A mesh in the making.
#[derive(Default)]
struct Graded {
    points: Vec<Point>,
    triangles: Vec<[u32; 3]>,
    /// The nodes between a place and a node next to it, from that one on.
    ways: BTreeMap<[u32; 2], Vec<u32>>,
    /// The half-edges that are walls.
    sides: BTreeMap<[u32; 2], SideId>,
    colors: SideColors,
}

impl Graded {
    fn mesh(&mut self) -> Triangulation {
        let points = std::mem::take(&mut self.points);
        Triangulation::new(points, &self.triangles, |a, b| self.sides.get(&[a, b]).copied())
    }

    fn triangle(&mut self, walls: &Walls<'_>, is_special: &[bool], t: usize) {
        let nodes = walls.mesh.nodes(t);
        let colors = [0, 1, 2].map(|i| walls.wall(HalfEdge::of(t, i)));
        let Some(k) = nodes.iter().position(|&node| is_special[node as usize]) else {
            self.triangles.push(nodes);
            return (0..3).for_each(|i| self.wall(&[nodes[i], nodes[(i + 1) % 3]], colors[i]));
        };
        let [tip, a, b] = [0, 1, 2].map(|i| nodes[(k + i) % 3]);
        let [along_a, across, along_b] = [0, 1, 2].map(|i| colors[(k + i) % 3]);
        let [to_a, to_b] = [a, b].map(|end| self.way(tip, end));
        for (outer, inner) in to_a.windows(2).zip(to_b.windows(2)) {
            let ([a, next_a], [b, next_b]) = ([outer[0], outer[1]], [inner[0], inner[1]]);
            self.triangles.extend([[a, b, next_b], [a, next_b, next_a]]);
        }
        let last = [to_a, to_b.clone()].map(|way| way[LEVELS]);
        self.triangles.push([tip, last[0], last[1]]);
        self.wall(&[a, b], across);
        let from_tip: Vec<_> = self.way(tip, a).into_iter().chain([tip]).rev().collect();
        self.wall(&from_tip, along_a);
        self.wall(&to_b.into_iter().chain([tip]).collect::<Vec<_>>(), along_b);
    }

    /// Nodes towards a tip, from a node next to it on.
    fn way(&mut self, tip: u32, end: u32) -> Vec<u32> {
        let points = &mut self.points;
        let way = self.ways.entry([tip, end]).or_insert_with(|| {
            let mut way = vec![end];
            for level in 1..=LEVELS {
                way.push(points.len() as u32);
                points.push(points[tip as usize].lerp(points[end as usize], 0.5_f64.powi(level as i32)));
            }
            way
        });
        way.clone()
    }

    /// Makes the edges along some nodes walls, if they are any: of equal length, or each twice or half as long as the one before.
    fn wall(&mut self, nodes: &[u32], colors: Option<Option<Colors>>) {
        let Some(colors) = colors else { return };
        let [start, end] = [nodes[0], nodes[nodes.len() - 1]].map(|node| self.points[node as usize]);
        let place = |node: u32| (self.points[node as usize] - start).hypot() / (end - start).hypot();
        for pair in nodes.windows(2) {
            let [from, to] = [pair[0], pair[1]].map(place);
            self.sides.insert([pair[0], pair[1]], SideId(self.colors.len() as u32));
            self.colors.push(colors.map(|colors| [from, 0.5 * (from + to), to].map(|t| mixed(colors, t))));
        }
    }
}

fn mixed(colors: Colors, t: f64) -> BlendColor {
    let weights = quadratic::edge(t);
    [0, 1, 2, 3].map(|c| (0..3).map(|i| weights[i] * colors[i][c]).sum())
}
