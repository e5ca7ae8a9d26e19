//! Clearance: how much room the drawn lines leave to what passes between them.
//!
//! The nodes of the map are samples of its curves, so the Delaunay triangulation tells the width of each passage: from
//! one triangle to the next, along the Voronoi edge between their circumcentres, the narrowest place is the common
//! edge where it lies between the centres (a Gabriel edge), and the nearer centre's own place otherwise. Widths are
//! clear widths: what is left beside the drawn lines.
//!
//! A passage at the tip of a line is more of a gap in an outline than one between two curves that go on, all the more
//! so where the line points across it: such widths are scaled down. But an end that nearly meets another line, or the
//! other end of its own, is no tip to wider passages: an outline was closed there, not quite. Nor is the end of a short line
//! one to passages that are much wider than it is long. The border of the page is no line; passages along it count as wide.

use kurbo::{Line, ParamCurveNearest, Point, Vec2};

use crate::pace;
use crate::planar_map::PlanarMap;
use crate::triangulation::{HalfEdge, SideId, Triangulation};
use crate::visibility::turn;

/// What a passage beside the tip of a line counts, as a part of its width, where the line points along it.
const BESIDE_TIP: f64 = 0.7;

/// The same where the line points across it.
const AHEAD_OF_TIP: f64 = 0.3;

/// The end of a line closes passages as wide as the line is long, and none that are this many times as wide: the farther it is,
/// the less does it point at anything.
const FAR: f64 = 2.0;

/// A line that comes this many times closer to another one than a passage is wide does not end in that passage.
const LOOSE: f64 = 4.0;

/// How much wider a passage between a line and the border of the page counts.
const BORDER_FACTOR: f64 = 4.0;

/// The width of a passage along the border with no line beside it, in du.
pub(crate) const OPEN_DU: f64 = 4096.0;

/// Distance along a line, in du, from its tip to the place that its direction is taken from, or more, up to a node.
const TIP_DU: f64 = 9.0;

/// The widths of all passages of a map.
#[derive(Clone, Debug)]
pub(crate) struct Clearance {
    /// Per half-edge, in du; negative where drawn lines overlap, and without meaning on sides of curves.
    pub(crate) widths_du: Vec<f64>,
    /// Where lines end.
    pub(crate) tips: Tips,
    /// Per triangle the width of its widest place, in du, as it counts.
    pub(crate) place_widths_du: Vec<f64>,
}

impl Clearance {
    /// Measures all passages, in slices.
    pub(crate) async fn measuring(map: &PlanarMap) -> Self {
        let mesh = map.triangulation();
        let beside_du = beside_du(map).await;
        pace::pause().await;
        let tips = Tips::new(map, &beside_du);
        pace::pause().await;
        let mut circle_widths_du = Vec::with_capacity(mesh.triangle_count());
        pace::for_each(0..mesh.triangle_count(), |t| {
            circle_widths_du.push(circle_width_du(map, t, BORDER_FACTOR));
        })
        .await;
        let width_du = |h| match mesh.passage(h) {
            Some(_) if is_gabriel(mesh, h) => edge_width_du(map, &tips, h),
            Some(twin) => circle_widths_du[h.triangle()].min(circle_widths_du[twin.triangle()]),
            None => f64::NEG_INFINITY,
        };
        let mut widths_du = Vec::with_capacity(3 * mesh.triangle_count());
        pace::for_each(mesh.half_edges(), |h| widths_du.push(width_du(h))).await;
        let place_width_du = |t| {
            let circle_du = circle_widths_du[t] * circle_factor(map, &tips, t);
            (0..3).map(|i| widths_du[HalfEdge::of(t, i).index()]).fold(circle_du, f64::max)
        };
        let mut place_widths_du = Vec::with_capacity(mesh.triangle_count());
        pace::for_each(0..mesh.triangle_count(), |t| place_widths_du.push(place_width_du(t))).await;
        Self { widths_du, tips, place_widths_du }
    }

    /// The width of the widest place of a triangle, in du, with the border of the page as a wall.
    pub(crate) fn walled_width_du(&self, map: &PlanarMap, triangle: usize) -> f64 {
        let mesh = map.triangulation();
        if !map.is_at_border(&mesh.nodes(triangle)) {
            return self.place_widths_du[triangle];
        }
        let circle_du = circle_width_du(map, triangle, 1.0) * circle_factor(map, &self.tips, triangle);
        let edges = (0..3).map(|i| HalfEdge::of(triangle, i));
        let within = edges.filter(|&h| !map.is_at_border(&mesh.ends(h)));
        within.map(|h| self.widths_du[h.index()]).fold(circle_du, f64::max)
    }

    /// The width of the narrowest passage that a way leads through, in du; on a way within one triangle that of its
    /// widest place. The way begins in a triangle of the map and crosses no line.
    pub(crate) fn narrowest_du(&self, map: &PlanarMap, way: [Point; 3], triangle: usize) -> f64 {
        let mesh = map.triangulation();
        let mut narrowest_du = f64::INFINITY;
        let mut at = triangle;
        for ends in [[way[0], way[1]], [way[1], way[2]]] {
            let mut from = None;
            while let Some((h, twin)) = exit(mesh, at, from, ends) {
                narrowest_du = narrowest_du.min(self.widths_du[h.index()]);
                (at, from) = (twin.triangle(), Some(twin));
            }
        }
        if narrowest_du < f64::INFINITY { narrowest_du } else { self.place_widths_du[triangle] }
    }
}

/// The passage through which a segment leaves a triangle that it came into by the half-edge `entry`.
fn exit(
    mesh: &Triangulation,
    triangle: usize,
    entry: Option<HalfEdge>,
    [from, to]: [Point; 2],
) -> Option<(HalfEdge, HalfEdge)> {
    let leaves = |h: &HalfEdge| {
        let [a, b] = mesh.segment(*h);
        turn(a, b, to) < 0.0 && turn(from, to, a) <= 0.0 && turn(from, to, b) >= 0.0
    };
    let h = (0..3).map(|i| HalfEdge::of(triangle, i)).filter(|h| Some(*h) != entry).find(leaves)?;
    Some((h, mesh.passage(h)?))
}

/// Distance of a point from the nearest drawn line that is seen from the triangle that it lies in, in du; negative on a
/// line, [`OPEN_DU`] where there is none.
pub(crate) fn distance_to_lines_du(map: &PlanarMap, p: Point, triangle: usize) -> f64 {
    let mut nearest_du = OPEN_DU;
    look_around(map, p, triangle, |h| {
        nearest_du = nearest_du.min(distance_to_line_du(map, p, h));
        nearest_du
    });
    nearest_du
}

/// The sides, those that face the point, of the pieces of curve whose ink it lies on, at most so far from the middle of the
/// line, in du; seen from the triangle that it lies in.
pub(crate) fn lines_under(map: &PlanarMap, p: Point, triangle: usize, within_du: f64) -> Vec<SideId> {
    let mesh = map.triangulation();
    let mut under = Vec::new();
    look_around(map, p, triangle, |h| {
        let is_near = distance_du(p, mesh.segment(h)) <= within_du && distance_to_line_du(map, p, h) <= 0.0;
        under.extend(mesh.side(h).filter(|_| is_near));
        within_du
    });
    under
}

/// Shows the half-edges that are seen from a point in a triangle to `look`, which says how far there is still something
/// to look for, in du.
fn look_around(map: &PlanarMap, p: Point, triangle: usize, mut look: impl FnMut(HalfEdge) -> f64) {
    let mesh = map.triangulation();
    let (mut around, mut at) = (vec![triangle], 0);
    while let Some(&triangle) = around.get(at) {
        for h in (0..3).map(|i| HalfEdge::of(triangle, i)) {
            let is_near = distance_du(p, mesh.segment(h)) < look(h);
            let next = mesh.passage(h).filter(|_| is_near).map(HalfEdge::triangle);
            around.extend(next.filter(|next| !around.contains(next)));
        }
        at += 1;
    }
}

/// Distance from what is drawn of a half-edge: its origin, and all of it if it is a piece of curve.
fn distance_to_line_du(map: &PlanarMap, p: Point, h: HalfEdge) -> f64 {
    let mesh = map.triangulation();
    let [a, b] = mesh.ends(h).map(|node| map.half_width_du(node));
    let to_corner_du = a.map_or(OPEN_DU, |half_du| (p - mesh.segment(h)[0]).hypot() - half_du);
    match (mesh.side(h), a, b) {
        (Some(_), Some(a), Some(b)) => to_corner_du.min(distance_du(p, mesh.segment(h)) - a.min(b)),
        _ => to_corner_du,
    }
}

fn distance_du(p: Point, [a, b]: [Point; 2]) -> f64 {
    Line::new(a, b).nearest(p, 0.0).distance_sq.sqrt()
}

/// Whether no corner opposite to an edge lies in the circle over it, so that it crosses its passage at the narrowest.
pub(crate) fn is_gabriel(mesh: &Triangulation, h: HalfEdge) -> bool {
    let is_acute = |h: HalfEdge| {
        let [a, b] = mesh.segment(h);
        let opposite = mesh.segment(h.prev())[0];
        (a - opposite).dot(b - opposite) > 0.0
    };
    is_acute(h) && mesh.twin(h).is_none_or(is_acute)
}

/// Twice the circumradius without the lines; at the border of the page so many times as much.
fn circle_width_du(map: &PlanarMap, triangle: usize, border_factor: f64) -> f64 {
    let mesh = map.triangulation();
    let corners = mesh.corners(triangle);
    let halves_du = mesh.nodes(triangle).map(|node| map.half_width_du(node));
    let lines_du = 2.0 * halves_du.iter().flatten().copied().fold(0.0, f64::max);
    let factor = if halves_du.contains(&None) { border_factor } else { 1.0 };
    circumcenter(corners)
        .map_or(OPEN_DU, |center| (factor * 2.0 * (center - corners[0]).hypot() - lines_du).min(OPEN_DU))
}

/// What the circle through the corners of a triangle counts where these are tips.
fn circle_factor(map: &PlanarMap, tips: &Tips, triangle: usize) -> f64 {
    let mesh = map.triangulation();
    let corners = mesh.corners(triangle);
    let Some(center) = circumcenter(corners) else { return 1.0 };
    let radius_du = (center - corners[0]).hypot();
    let pairs = mesh.nodes(triangle).into_iter().zip(corners);
    pairs.map(|(node, corner)| tips.factor(node, (center - corner) / radius_du, 2.0 * radius_du)).product()
}

/// `None` where the corners lie on a line.
fn circumcenter([a, b, c]: [Point; 3]) -> Option<Point> {
    let (u, v) = (b - a, c - a);
    let double_area = u.cross(v);
    let offset = Vec2::new(v.y * u.hypot2() - u.y * v.hypot2(), u.x * v.hypot2() - v.x * u.hypot2());
    (double_area > 0.0).then(|| a + offset / (2.0 * double_area))
}

/// What the lines drawn through the ends of an edge leave of it, in du; negative where they overlap.
pub(crate) fn clear_width_du(map: &PlanarMap, h: HalfEdge) -> f64 {
    let [a, b] = map.triangulation().segment(h);
    (b - a).hypot() - lines_du(map, h)
}

/// What the lines drawn through the ends of an edge take of it, in du.
pub(crate) fn lines_du(map: &PlanarMap, h: HalfEdge) -> f64 {
    map.triangulation().ends(h).iter().filter_map(|&node| map.half_width_du(node)).sum()
}

/// The length of an edge without the lines at its ends, as far as it counts.
fn edge_width_du(map: &PlanarMap, tips: &Tips, h: HalfEdge) -> f64 {
    let mesh = map.triangulation();
    let [a, b] = mesh.segment(h);
    let length_du = (b - a).hypot();
    let across = (b - a) / length_du;
    match mesh.ends(h).map(|node| map.half_width_du(node)) {
        [None, None] => OPEN_DU,
        [Some(half_du), None] | [None, Some(half_du)] => (BORDER_FACTOR * length_du - half_du).min(OPEN_DU),
        [Some(_), Some(_)] => {
            let width_du = clear_width_du(map, h);
            let [left, right] = mesh.ends(h);
            let factor = tips.factor(left, across, width_du) * tips.factor(right, -across, width_du);
            if width_du > 0.0 { width_du * factor } else { width_du }
        }
    }
}

/// The ends of lines.
#[derive(Clone, Debug)]
pub(crate) struct Tips {
    /// Per node at which a single piece ends what is known of it.
    tips: Vec<Option<Tip>>,
}

/// The end of a line.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tip {
    direction: Vec2,
    /// How long the line is, with those that go on from it, in du.
    length_du: f64,
    /// How far it is, from the end of the line or by way of what leads there, to the nearest drawn line beside it, in du.
    beside_du: f64,
}

impl Tips {
    fn new(map: &PlanarMap, beside_du: &[f64]) -> Self {
        let points = map.triangulation().points();
        let neighbours = Neighbours::new(map);
        let lengths_du = map.line_lengths_du();
        let tip = |node: usize| {
            let way = neighbours.way_back(points, node as u32);
            let length_du = lengths_du[node].max(way.last()?.1);
            let near = &way[..=way.iter().position(|&(_, way_du)| way_du >= TIP_DU).unwrap_or(way.len() - 1)];
            let along = points[node] - points[near.last()?.0 as usize];
            let to_line_du = near.iter().map(|&(node, way_du)| way_du + beside_du[node as usize]);
            let beside_du = to_line_du.fold(beside_du[node], f64::min);
            Some(Tip { direction: along / along.hypot(), length_du, beside_du })
        };
        Self { tips: (0..points.len()).map(tip).collect() }
    }

    /// The direction in which the line points that ends at a node.
    pub(crate) fn direction(&self, node: u32) -> Option<Vec2> {
        self.tips[node as usize].map(|tip| tip.direction)
    }

    /// The end of a line at a node, loosely beside a passage of a clear width, and not far from its other side. One that comes much
    /// closer to another line, or to its own beginning, goes on there.
    pub(crate) fn loose(&self, node: u32, width_du: f64) -> Option<Tip> {
        let is_loose = |tip: &Tip| width_du <= LOOSE * tip.beside_du && width_du < FAR * tip.length_du;
        self.tips[node as usize].filter(is_loose)
    }

    fn factor(&self, node: u32, across: Vec2, width_du: f64) -> f64 {
        let part = |tip: Tip| {
            let nearness = (FAR - width_du / tip.length_du) / (FAR - 1.0);
            let ahead = tip.direction.dot(across).max(0.0);
            let near_part = BESIDE_TIP + (AHEAD_OF_TIP - BESIDE_TIP) * ahead;
            1.0 + (near_part - 1.0) * nearness.min(1.0)
        };
        self.loose(node, width_du).map_or(1.0, part)
    }
}

/// Per node the clear width of the narrowest passage at it between drawn lines, in du; not less than none.
async fn beside_du(map: &PlanarMap) -> Vec<f64> {
    let mesh = map.triangulation();
    let mut beside_du = vec![OPEN_DU; mesh.points().len()];
    let is_drawn = |node: &u32| map.half_width_du(*node).is_some();
    pace::for_each(mesh.half_edges(), |h| {
        if mesh.passage(h).is_some() && is_gabriel(mesh, h) && mesh.ends(h).iter().all(is_drawn) {
            let beside_du = &mut beside_du[mesh.ends(h)[0] as usize];
            *beside_du = beside_du.min(clear_width_du(map, h).max(0.0));
        }
    })
    .await;
    beside_du
}

/// The nodes that pieces join to each node, where there are one or two.
struct Neighbours {
    of: Vec<[u32; 2]>,
    count: Vec<u32>,
}

impl Neighbours {
    fn new(map: &PlanarMap) -> Self {
        let nodes = map.triangulation().points().len();
        let mut this = Self { of: vec![[0; 2]; nodes], count: vec![0; nodes] };
        for [a, b] in map.pieces().iter().map(|piece| piece.nodes) {
            this.join(a, b);
            this.join(b, a);
        }
        this
    }

    fn join(&mut self, a: u32, b: u32) {
        let count = &mut self.count[a as usize];
        if let Some(place) = self.of[a as usize].get_mut(*count as usize) {
            *place = b;
        }
        *count += 1;
    }

    /// The nodes back from a tip, up to a junction or another tip, with their ways, in du; none if the node is no tip.
    fn way_back(&self, points: &[Point], tip: u32) -> Vec<(u32, f64)> {
        let mut way = Vec::new();
        let (mut from, mut at, mut way_du) = (tip, self.of[tip as usize][0], 0.0);
        let mut goes_on = self.count[tip as usize] == 1;
        while goes_on {
            way_du += points[from as usize].distance(points[at as usize]);
            way.push((at, way_du));
            goes_on = self.count[at as usize] == 2;
            let [a, b] = self.of[at as usize];
            (from, at) = (at, if a == from { b } else { a });
        }
        way
    }
}
