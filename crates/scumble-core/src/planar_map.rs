//! The planar map of a drawing: its curves as straight pieces that meet only at nodes.
//!
//! Curves are sampled onto a lattice, snap-rounded so that no two pieces cross, and triangulated together with the
//! frame of the page (constrained Delaunay). Everything that asks what lies where walks this triangulation.

use kurbo::Rect;
use spade::{ConstrainedDelaunayTriangulation, Point2, RefinementParameters, Triangulation as _};
use thiserror::Error;

use crate::drawing::Drawing;
use crate::sample::{self, LatticePoint, Stretch};
use crate::snap::{self, Snapped};
use crate::triangulation::{SideId, Triangulation};

/// How finely curves are sampled into pieces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Largest distance of neighbouring nodes along a curve, in du; positive.
    pub spacing_du: f64,
    /// Largest distance of a piece from its curve, in du; positive.
    pub chord_du: f64,
}

impl Default for Sampling {
    /// 3 du apart, at most 0.1 du off the curve.
    fn default() -> Self {
        Self { spacing_du: 3.0, chord_du: 0.1 }
    }
}

/// A straight piece of a curve, or of the frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Piece {
    /// Its nodes. Its left side is that of the half-edge from the first to the second.
    pub nodes: [u32; 2],
    /// The first curve that runs along it; `None` for the frame.
    pub curve: Option<u32>,
}

/// One step of a curve along the map.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// The side to the left of the direction of travel.
    pub left: SideId,
    /// Arc position at which the step starts and ends, in du from the start of the curve.
    pub arc_du: [f64; 2],
}

/// A narrow passage between two curves, or between two places of one: an edge of the triangulation across it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gap {
    /// The nodes on either side of the passage.
    pub nodes: [u32; 2],
    /// What the drawn lines leave free of the way between them, in du; negative where they overlap.
    pub width_du: f64,
}

/// Why a drawing has no planar map.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum MapError {
    /// More than fits into the memory of a page.
    #[error(
        "the drawing has more than {limit} pieces of line, or too many on one spot; simplify it or split it"
    )]
    TooManyPieces {
        /// The number of pieces allowed.
        limit: usize,
    },
    /// The triangulation failed.
    #[error("the lines of the drawing could not be triangulated; please report this drawing")]
    Triangulation,
}

/// Pieces that a map may have.
const MAX_PIECES: usize = 1_000_000;

/// Smallest angle, in degrees, that refinement aims at.
const REFINED_ANGLE_DEG: f64 = 20.0;

/// Largest triangle of the refined mesh, in squares of the spacing of nodes along curves: 25 du from corner to corner
/// at the default spacing. Angles alone let triangles grow with their distance from the curves, whatever the
/// spacing, and the solver's error with them.
const REFINED_AREA: f64 = 30.0;

/// `spade` refuses coordinates within 1e-43 of zero: it works on du + 1024, which is exact on the lattice.
const SHIFT_DU: f64 = 1024.0;

type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>, (), EdgeTag>;

/// The piece that an edge is, plus one; 0 where it is none.
#[derive(Clone, Copy, Debug, Default)]
struct EdgeTag(u32);

/// Curves as pieces, triangulated within the frame.
#[derive(Clone, Debug)]
pub struct PlanarMap {
    frame: Rect,
    cdt: Cdt,
    triangulation: Triangulation,
    pieces: Vec<Piece>,
    steps: Vec<Vec<Step>>,
    gaps: Vec<Gap>,
    spacing_du: f64,
}

impl PlanarMap {
    /// Builds the map of a drawing's curves. What lies outside the page is cut off; curves with coordinates that
    /// are not finite, or further away than 1e9 du, have no steps.
    ///
    /// # Errors
    /// When the drawing has too many pieces (see [`MapError`]).
    pub fn build(drawing: &Drawing, sampling: &Sampling) -> Result<Self, MapError> {
        let too_many = MapError::TooManyPieces { limit: MAX_PIECES };
        let frame = sample::lattice_frame(drawing.size_du());
        let polylines = polylines(drawing, frame, sampling).ok_or(too_many.clone())?;
        let segments: Vec<_> = polylines.iter().flatten().map(|stretch| stretch.ends).collect();
        let snapped = snap::snap(&segments, frame, MAX_PIECES).ok_or(too_many)?;
        let (pieces, steps) = pieces_and_steps(&polylines, &snapped);
        let cdt = triangulate(&snapped.nodes, &pieces)?;
        let triangulation = flatten(&cdt, &pieces);
        Ok(Self {
            frame: sample::frame_rect(frame),
            cdt,
            triangulation,
            pieces,
            steps,
            gaps: Vec::new(),
            spacing_du: sampling.spacing_du,
        })
    }

    /// The constrained Delaunay triangulation of the pieces and the frame.
    pub fn triangulation(&self) -> &Triangulation {
        &self.triangulation
    }

    /// The part of the plane that the map covers, in du: the page.
    pub fn frame(&self) -> Rect {
        self.frame
    }

    /// All pieces; piece `i` has the sides `2 i` and `2 i + 1`.
    pub fn pieces(&self) -> &[Piece] {
        &self.pieces
    }

    /// Number of sides: twice the number of pieces.
    pub fn side_count(&self) -> usize {
        2 * self.pieces.len()
    }

    /// Number of curves.
    pub fn curve_count(&self) -> usize {
        self.steps.len()
    }

    /// The way of one curve along the map, in its direction; empty where it is a point or off the page.
    pub fn steps(&self, curve: usize) -> &[Step] {
        &self.steps[curve]
    }

    /// The passages that may be closed to colours, in a fixed order.
    pub fn gaps(&self) -> &[Gap] {
        &self.gaps
    }

    /// Whether a curve ends where it starts, without a gap where it leaves the page.
    pub fn is_closed(&self, curve: usize) -> bool {
        let steps = &self.steps[curve];
        let gapless = steps.windows(2).all(|pair| pair[0].arc_du[1] == pair[1].arc_du[0]);
        match (steps.first(), steps.last()) {
            (Some(first), Some(last)) => gapless && self.ends(first.left)[0] == self.ends(last.left)[1],
            _ => false,
        }
    }

    /// The nodes at the start and the end of a side, in the direction that has it on the left.
    pub fn ends(&self, side: SideId) -> [u32; 2] {
        let [a, b] = self.pieces[side.piece()].nodes;
        if side.is_right() { [b, a] } else { [a, b] }
    }

    /// The same pieces with further nodes between them, so that angles are at least 20° where the pieces allow
    /// it, and no triangle is larger than the sampling asks for: the mesh of the solver. Pieces are never split.
    ///
    /// Ruppert's refinement would split the pieces at acute corners without end; it is told to keep them.
    pub fn refined(&self) -> Triangulation {
        let mut cdt = self.cdt.clone();
        let largest_du2 = REFINED_AREA * self.spacing_du * self.spacing_du;
        let empty_page = 4.0 * self.frame.area() / largest_du2;
        let parameters = RefinementParameters::new()
            .keep_constraint_edges()
            .with_max_additional_vertices(10 * cdt.num_vertices() + empty_page as usize)
            .with_max_allowed_area(largest_du2)
            .with_angle_limit(spade::AngleLimit::from_deg(REFINED_ANGLE_DEG));
        cdt.refine(parameters);
        flatten(&cdt, &self.pieces)
    }
}

/// The frame is sampled this many times as coarsely as the curves: no colour sits on it, but as four long edges
/// it would spoil the triangles of the background.
const FRAME_COARSENING: f64 = 4.0;

/// The curves as stretches, and the frame after them; `None` where there are too many.
fn polylines(drawing: &Drawing, frame: LatticePoint, sampling: &Sampling) -> Option<Vec<Vec<Stretch>>> {
    let mut left = MAX_PIECES;
    let frame_path = sample::frame_path(frame);
    let frame_sampling = Sampling { spacing_du: FRAME_COARSENING * sampling.spacing_du, ..*sampling };
    let curves = drawing.curves.iter().map(|curve| (&curve.path, sampling));
    curves
        .chain([(&frame_path, &frame_sampling)])
        .map(|(path, sampling)| {
            let polyline = sample::sample(path, frame, sampling, left)?;
            left = left.checked_sub(polyline.len())?;
            Some(polyline)
        })
        .collect()
}

/// Pieces without repeats, and each curve's steps along them. The last polyline is the frame.
fn pieces_and_steps(polylines: &[Vec<Stretch>], snapped: &Snapped) -> (Vec<Piece>, Vec<Vec<Step>>) {
    let mut ends: Vec<[u32; 2]> = snapped
        .chains
        .iter()
        .flat_map(|chain| chain.windows(2).map(|w| [w[0].min(w[1]), w[0].max(w[1])]))
        .collect();
    ends.sort_unstable();
    ends.dedup();
    let mut pieces: Vec<_> = ends.iter().map(|&nodes| Piece { nodes, curve: None }).collect();
    let mut chains = snapped.chains.iter();
    let mut steps = Vec::with_capacity(polylines.len());
    for (curve, polyline) in polylines.iter().enumerate() {
        let way: Vec<Step> = polyline
            .iter()
            .zip(&mut chains)
            .flat_map(|(stretch, chain)| steps_of(stretch, chain, &snapped.nodes, &ends))
            .collect();
        if curve + 1 < polylines.len() {
            for step in &way {
                pieces[step.left.piece()].curve.get_or_insert(curve as u32);
            }
            steps.push(way);
        }
    }
    (pieces, steps)
}

/// The steps that replace one stretch.
fn steps_of<'a>(
    stretch: &'a Stretch,
    chain: &'a [u32],
    nodes: &'a [LatticePoint],
    ends: &'a [[u32; 2]],
) -> impl Iterator<Item = Step> + use<'a> {
    let [a, b] = stretch.ends.map(LatticePoint::to_point);
    let [from_du, to_du] = stretch.arc_du;
    let along = (b - a) / (b - a).hypot2();
    let arc_du = move |i: usize| {
        if i + 1 == chain.len() {
            return to_du;
        }
        let part = along.dot(nodes[chain[i] as usize].to_point() - a);
        from_du + (to_du - from_du) * part.clamp(0.0, 1.0)
    };
    chain.windows(2).enumerate().filter_map(move |(i, w)| {
        let piece = ends.binary_search(&[w[0].min(w[1]), w[0].max(w[1])]).ok()?;
        Some(Step { left: SideId::of(piece, w[0] > w[1]), arc_du: [arc_du(i), arc_du(i + 1)] })
    })
}

fn triangulate(nodes: &[LatticePoint], pieces: &[Piece]) -> Result<Cdt, MapError> {
    let vertices =
        nodes.iter().map(|node| node.to_point()).map(|p| Point2::new(p.x + SHIFT_DU, p.y + SHIFT_DU));
    let edges = pieces.iter().map(|piece| piece.nodes.map(|node| node as usize)).collect();
    let mut conflicts = 0;
    let mut cdt = Cdt::try_bulk_load_cdt(vertices.collect(), edges, |_| conflicts += 1)
        .map_err(|_| MapError::Triangulation)?;
    for (i, piece) in pieces.iter().enumerate() {
        let [a, b] = piece.nodes.map(|node| spade::handles::FixedVertexHandle::from_index(node as usize));
        let edge = cdt.get_edge_from_neighbors(a, b).ok_or(MapError::Triangulation)?;
        let edge = edge.as_undirected().fix();
        *cdt.undirected_edge_data_mut(edge).data_mut() = EdgeTag(i as u32 + 1);
    }
    let complete =
        conflicts == 0 && cdt.num_constraints() == pieces.len() && cdt.num_vertices() == nodes.len();
    complete.then_some(cdt).ok_or(MapError::Triangulation)
}

/// The triangles of `spade`'s structure as flat arrays, in its order.
fn flatten(cdt: &Cdt, pieces: &[Piece]) -> Triangulation {
    let points = cdt.vertices().map(|v| v.position());
    let points = points.map(|p| kurbo::Point::new(p.x - SHIFT_DU, p.y - SHIFT_DU)).collect();
    let mut half_edge_of = vec![u32::MAX; cdt.num_directed_edges()];
    let edges = || cdt.inner_faces().flat_map(|face| face.adjacent_edges());
    for (h, edge) in edges().enumerate() {
        half_edge_of[edge.fix().index()] = h as u32;
    }
    Triangulation::from_half_edges(
        points,
        edges().map(|edge| {
            let side = edge.as_undirected().data().data().0.checked_sub(1).map(|piece| {
                let from = edge.from().fix().index() as u32;
                SideId::of(piece as usize, pieces[piece as usize].nodes[0] != from)
            });
            (edge.from().fix().index() as u32, half_edge_of[edge.rev().fix().index()], side)
        }),
    )
}
