//! A finer mesh of one region, where sources need it.
//!
//! Sizes pass gradually into each other, and triangles away from the sources stay as they are. Nodes are none of the
//! source's: the mesh changes little where a stroke moves a little. What has to be bisected depends on no order, so that a mesh
//! which is fine enough for some sources only becomes finer for others.

use kurbo::{Point, Rect};
use scumble_core::SoftSource;
use scumble_core::pace::Pace;

use super::cells::Cells;
use crate::brush::{Brush, Place, around};

/// Triangles of the finest mesh of a region beyond those of the region itself: more detail than that is left out.
const MAX_FINER: usize = 60_000;

/// Longest edge in the middle of a stroke, in radii where it is.
const LONGEST_EDGE: f64 = 0.75;

/// Longest edge at the rim of a stroke, in radii: so much, and for a weight of one so much more, which falls with its
/// root. There the colour passes into what is around it, on a way that is the shorter the stronger it is.
const RIM_EDGE: [f64; 2] = [0.2, 1.4];

/// How far from the rim the edges begin to grow, in radii.
const RIM_WIDTH: f64 = 0.4;

/// What the longest edge grows by from there on, for each du of distance.
const GROWTH: f64 = 0.6;

/// The elements of a region, refined.
#[derive(Debug)]
pub(super) struct Refined {
    pub(super) shapes: Vec<Shape>,
    /// The unknowns of each, as those of a mesh; corners come first.
    pub(super) dofs: Vec<[u32; 6]>,
    pub(super) dof_count: usize,
    /// Around the middle of each, as far as its corners, in du.
    pub(super) circles: Vec<(Point, f64)>,
    /// What the circles of every [`CHUNK`] elements lie in.
    boxes: Vec<Rect>,
}

/// Elements that share a box.
const CHUNK: usize = 32;

impl Refined {
    pub(super) fn new(shapes: Vec<Shape>, dofs: Vec<[u32; 6]>, dof_count: usize) -> Self {
        let circles: Vec<_> = shapes.iter().map(|shape| around(shape.corners)).collect();
        let boxes = circles.chunks(CHUNK).map(box_around).collect();
        Self { shapes, dofs, dof_count, circles, boxes }
    }

    /// The elements whose circles may meet a rectangle.
    pub(super) fn near(&self, rect: Rect) -> impl Iterator<Item = usize> {
        let near = (0..).zip(&self.boxes).filter(move |(_, around)| around.overlaps(rect));
        near.flat_map(|(chunk, _)| CHUNK * chunk..(CHUNK * (chunk + 1)).min(self.shapes.len()))
    }
}

/// What some circles lie in.
fn box_around(circles: &[(Point, f64)]) -> Rect {
    let boxes = circles
        .iter()
        .map(|&(middle, radius_du)| Rect::from_center_size(middle, (2.0 * radius_du, 2.0 * radius_du)));
    boxes.reduce(|all, one| all.union(one)).unwrap_or_default()
}

/// Where an element is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    /// The triangle of the region that it is, or is a part of, by its index there.
    pub(super) parent: u32,
    /// Where in that its corners are: the weights of that one's corners.
    pub(super) weights: [[f32; 3]; 3],
    pub(super) corners: [Point; 3],
    /// Bit `i` is set where the edge from corner `i` to corner `i + 1` bounds the region.
    pub(super) side_edges: u32,
}

/// A mesh that is fine enough for some sources, whatever their colours.
#[derive(Clone, Debug)]
pub(super) struct Finer {
    sources: Vec<SoftSource>,
    /// How much coarser than they need it is, so that it is not too much.
    coarsening: f64,
    cells: Cells,
}

impl Finer {
    /// A region as it is.
    pub(super) fn new(coarse: &Cells) -> Self {
        Self { sources: Vec::new(), coarsening: 1.0, cells: coarse.clone() }
    }

    /// Whether it is for none but some sources.
    pub(super) fn is_for_some_of(&self, sources: &[&SoftSource]) -> bool {
        self.sources.iter().all(|own| sources.iter().any(|source| source.is_alike(own)))
    }

    /// Makes it fine enough for more sources of a region.
    pub(super) async fn add(&mut self, coarse: &Cells, sources: &[&SoftSource]) {
        let mut known = self.sources.len();
        for &source in sources {
            if !self.sources[..known].iter().any(|own| own.is_alike(source)) {
                self.sources.push(source.clone());
            }
        }
        if self.sources.len() == known {
            return;
        }
        let brushes: Vec<_> = self.sources.iter().map(Brush::new).collect();
        let most = coarse.cells.len() + MAX_FINER;
        while !self.cells.refine(&brushes, known, self.coarsening, most).await {
            self.coarsening *= 1.5;
            (self.cells, known) = (coarse.clone(), 0);
        }
    }

    pub(super) fn refined(&self) -> Refined {
        self.cells.refined()
    }
}

impl Cells {
    /// Bisects all that is too large for some brushes, where what there is is small enough for so many of them; `false` where
    /// that gives more than so many.
    async fn refine(&mut self, brushes: &[Brush], known: usize, coarsening: f64, most: usize) -> bool {
        let mut pace = Pace::default();
        for i in 0..self.cells.len() as u32 {
            if self.is_too_large(i, &brushes[known..], coarsening) {
                self.open.push(i);
            }
            while let Some(i) = self.open.pop() {
                if self.cells.len() > most {
                    return false;
                }
                if self.is_too_large(i, brushes, coarsening) {
                    self.bisect(i);
                    self.open.push(i);
                }
                pace.work(brushes.len()).await;
            }
            pace.work(brushes.len() - known).await;
        }
        true
    }

    fn is_too_large(&self, i: u32, brushes: &[Brush], coarsening: f64) -> bool {
        let corners = self.cells[i as usize].corners.map(|corner| self.points[corner as usize]);
        let [a, b, c] = corners.map(Point::to_vec2);
        let longest_du =
            [a - b, b - c, c - a].map(|edge| edge.hypot2()).into_iter().fold(0.0, f64::max).sqrt();
        let longest_du = longest_du / coarsening;
        let middle = ((a + b + c) / 3.0).to_point();
        brushes.iter().any(|brush| is_too_long(longest_du, middle, brush))
    }
}

/// Whether an edge is too long for a brush around a place.
fn is_too_long(longest_du: f64, middle: Point, brush: &Brush) -> bool {
    let mut is_too_long = false;
    let most_du = (1.0 + RIM_WIDTH) * brush.radii_du[1] + longest_du / GROWTH;
    brush.for_each_place(middle, most_du, &mut |place| {
        is_too_long |= longest_du > place.radius_du * longest_edge(place, brush.weight);
    });
    is_too_long
}

/// Longest edge that a place of a stroke allows where it is seen from, in radii.
fn longest_edge(Place { distance_du, radius_du }: Place, weight: f64) -> f64 {
    let from_rim = distance_du / radius_du - 1.0;
    let grown = GROWTH * (from_rim.abs() - RIM_WIDTH).max(0.0);
    let edge = (RIM_EDGE[0] + RIM_EDGE[1] / weight.sqrt()).min(LONGEST_EDGE) + grown;
    if from_rim < 0.0 { edge.min(LONGEST_EDGE) } else { edge }
}
