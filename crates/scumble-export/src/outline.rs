//! Edges of triangles as outlines with as few points as they need.

use kurbo::{BezPath, Point};

/// Outlines lie within this of the edges that they are made of: a pixel at 5000%.
const TOLERANCE_DU: f64 = 0.02;

/// Most points that are left out in a row, so that leaving them out takes linear time.
const MOST_LEFT_OUT: usize = 64;

/// An edge on the rim of a region.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edge {
    /// From the first to the second the region is on the same hand for all edges.
    pub(crate) points: [[f32; 2]; 2],
    /// Whether another region is drawn on its other hand.
    pub(crate) is_seam: bool,
}

/// The rim of a region.
#[derive(Debug, Default)]
pub(crate) struct Outline {
    /// Closed subpaths.
    pub(crate) path: BezPath,
    /// Open ones: the parts that are seams.
    pub(crate) seams: BezPath,
}

/// The outline that some edges make.
pub(crate) fn outline(mut edges: Vec<Edge>) -> Outline {
    edges.sort_unstable_by_key(|edge| edge.points.map(bits));
    let mut used = vec![false; edges.len()];
    let mut outline = Outline::default();
    for start in 0..edges.len() {
        if !used[start] {
            let ring = ring(&edges, start, &mut used);
            outline.push(&ring);
        }
    }
    outline
}

/// Edges from one on, each beginning where the one before ends, until there are no more.
fn ring(edges: &[Edge], start: usize, used: &mut [bool]) -> Vec<Edge> {
    let mut ring = Vec::new();
    let mut next = Some(start);
    while let Some(i) = next {
        used[i] = true;
        ring.push(edges[i]);
        let end = edges[i].points[1];
        let first = edges.partition_point(|edge| bits(edge.points[0]) < bits(end));
        let going_on = edges[first..].iter().take_while(|edge| edge.points[0] == end).count();
        next = (first..first + going_on).find(|i| !used[*i]);
    }
    ring
}

fn bits([x, y]: [f32; 2]) -> [u32; 2] {
    [x.to_bits(), y.to_bits()]
}

impl Outline {
    /// Adds a ring, which is turned so that it begins where a seam does, if it can.
    fn push(&mut self, ring: &[Edge]) {
        let count = ring.len();
        let turns = |i: &usize| ring[*i].is_seam != ring[(i + count - 1) % count].is_seam;
        let first = (0..count).find(turns).unwrap_or(0);
        let turned: Vec<_> = ring[first..].iter().chain(&ring[..first]).copied().collect();
        for (r, run) in turned.chunk_by(|a, b| a.is_seam == b.is_seam).enumerate() {
            let points = straightened(run);
            if run[0].is_seam {
                push_open(&mut self.seams, &points);
            }
            let whole = if r == 0 { &points[..] } else { &points[1..] };
            whole.iter().enumerate().for_each(|(i, &point)| {
                if r == 0 && i == 0 { self.path.move_to(point) } else { self.path.line_to(point) }
            });
        }
        self.path.close_path();
    }
}

fn push_open(path: &mut BezPath, points: &[Point]) {
    for (i, &point) in points.iter().enumerate() {
        if i == 0 { path.move_to(point) } else { path.line_to(point) }
    }
}

/// The points of some edges in a row, without those that lie all but straight between others.
fn straightened(edges: &[Edge]) -> Vec<Point> {
    let point = |[x, y]: [f32; 2]| Point::new(x.into(), y.into());
    let all: Vec<_> = edges
        .iter()
        .take(1)
        .map(|e| e.points[0])
        .chain(edges.iter().map(|e| e.points[1]))
        .map(point)
        .collect();
    let mut kept = all[..1].to_vec();
    let mut at = 0;
    while at + 1 < all.len() {
        let furthest = (at + 2..all.len()).take(MOST_LEFT_OUT);
        at = furthest.take_while(|&end| is_straight(&all[at..=end])).last().unwrap_or(at + 1);
        kept.push(all[at]);
    }
    kept
}

/// Whether the points between the first and the last lie on the way between these.
fn is_straight(points: &[Point]) -> bool {
    let [start, between @ .., end] = points else { return true };
    let way = *end - *start;
    let length = way.hypot();
    between.iter().all(|p| {
        let to = *p - *start;
        let [along, across] = [way.dot(to), way.cross(to)];
        across.abs() <= TOLERANCE_DU * length && (0.0..=length * length).contains(&along)
    })
}
