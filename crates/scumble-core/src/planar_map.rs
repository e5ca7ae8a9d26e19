//! The planar map of a drawing: its curves as straight pieces that meet only at nodes.
//!
//! Curves are sampled onto a lattice, snap-rounded so that no two pieces cross, and triangulated together with the
//! frame of the page (constrained Delaunay). Everything that asks what lies where walks this triangulation.

use std::sync::{Arc, OnceLock};

use kurbo::Rect;
use thiserror::Error;

use crate::clearance::Clearance;
use crate::delaunay::{self, Cdt};
use crate::drawing::Drawing;
use crate::pace::{self, Pace, Slices, now};
use crate::refinement;
use crate::sample::{self, LatticePoint, Stretch};
use crate::snap::{self, Snapped};
use crate::sort;
use crate::triangulation::{HalfEdge, SideId, Triangulation};

/// How finely curves are sampled into pieces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Largest distance of neighbouring nodes along a curve, in du; positive.
    pub spacing_du: f64,
    /// Length of the piece at the tip of an open curve, in du, where that is less; positive. From there on pieces grow. At
    /// corners it is twice as much; both are more on curves of less than 48 du.
    pub tip_du: f64,
    /// Largest distance of a piece from its curve, in du; positive.
    pub chord_du: f64,
}

impl Default for Sampling {
    /// 4 du apart, 0.5 du at tips, at most 0.1 du off the curve.
    fn default() -> Self {
        Self { spacing_du: 4.0, tip_du: 0.5, chord_du: 0.1 }
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
    /// Whether it is hardly narrower than the places it joins: the end of a shape where one side of it has a colour
    /// and the other has none, but two colours meet in it softly, as they do within one place.
    pub is_wide: bool,
    /// Whether it is so even as far as widths count beside the tips of lines.
    pub is_plain: bool,
    /// Whether it is hardly wider than the lines at its ends, so that a person does not see it as a hole.
    pub is_slight: bool,
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

/// Curves as pieces, triangulated within the frame. A copy shares what does not depend on the gaps.
#[derive(Clone, Debug)]
pub struct PlanarMap {
    base: Arc<Base>,
    triangulation: Triangulation,
    gaps: Vec<Gap>,
    is_rough: bool,
    refined: OnceLock<Arc<Triangulation>>,
}

/// What is the same whichever gaps there are.
#[derive(Debug)]
struct Base {
    frame: Rect,
    cdt: Cdt,
    pieces: Vec<Piece>,
    steps: Vec<Vec<Step>>,
    half_widths_du: Vec<f64>,
    sampling: Sampling,
    half_edges_of_sides: OnceLock<Vec<Option<HalfEdge>>>,
    clearance: OnceLock<Clearance>,
}

impl PlanarMap {
    /// Builds the map of a drawing's curves. What lies outside the page is cut off; curves with coordinates that
    /// are not finite, or further away than 1e9 du, have no steps.
    ///
    /// # Errors
    /// When the drawing has too many pieces (see [`MapError`]).
    pub fn build(drawing: &Drawing, sampling: &Sampling) -> Result<Self, MapError> {
        now(Self::building(drawing, sampling))
    }

    /// The same in slices.
    ///
    /// # Errors
    /// See [`PlanarMap::build`].
    pub fn building<'a>(drawing: &'a Drawing, sampling: &'a Sampling) -> Slices<'a, Result<Self, MapError>> {
        Slices::new(Self::built(drawing, sampling))
    }

    async fn built(drawing: &Drawing, sampling: &Sampling) -> Result<Self, MapError> {
        let too_many = MapError::TooManyPieces { limit: MAX_PIECES };
        let frame = sample::lattice_frame(drawing.size_du());
        let polylines = polylines(drawing, frame, sampling).await.ok_or(too_many.clone())?;
        pace::pause().await;
        let segments: Vec<_> = polylines.iter().flatten().map(|stretch| stretch.ends).collect();
        pace::pause().await;
        let snapped = snap::snap(&segments, frame, MAX_PIECES).await.ok_or(too_many)?;
        pace::pause().await;
        let (pieces, steps) = pieces_and_steps(&polylines, &snapped).await;
        pace::pause().await;
        let half_widths_du = half_widths_du(drawing, &steps, &pieces, snapped.nodes.len());
        pace::pause().await;
        let cdt = delaunay::triangulate(&snapped.nodes, &pieces).await?;
        let triangulation = Slices::new(delaunay::flatten(&cdt, &pieces)).await;
        let base = Base {
            frame: sample::frame_rect(frame),
            cdt,
            pieces,
            steps,
            half_widths_du,
            sampling: *sampling,
            half_edges_of_sides: OnceLock::new(),
            clearance: OnceLock::new(),
        };
        Ok(Self {
            base: base.into(),
            triangulation,
            gaps: Vec::new(),
            is_rough: false,
            refined: OnceLock::new(),
        })
    }

    /// The constrained Delaunay triangulation of the pieces and the frame.
    pub fn triangulation(&self) -> &Triangulation {
        &self.triangulation
    }

    /// The part of the plane that the map covers, in du: the page.
    pub fn frame(&self) -> Rect {
        self.base.frame
    }

    /// How finely its curves are sampled.
    pub(crate) fn sampling(&self) -> Sampling {
        self.base.sampling
    }

    /// All pieces; piece `i` has the sides `2 i` and `2 i + 1`.
    pub fn pieces(&self) -> &[Piece] {
        &self.base.pieces
    }

    /// Number of sides: twice the number of pieces.
    pub fn side_count(&self) -> usize {
        2 * self.base.pieces.len()
    }

    /// The half-edge of the triangulation that a side is.
    pub fn half_edge(&self, side: SideId) -> Option<HalfEdge> {
        let half_edges = self.base.half_edges_of_sides.get_or_init(|| {
            let mut half_edges = vec![None; self.side_count()];
            for h in self.triangulation.half_edges() {
                if let Some(side) = self.triangulation.side(h) {
                    half_edges[side.index()] = Some(h);
                }
            }
            half_edges
        });
        half_edges[side.index()]
    }

    /// Number of curves.
    pub fn curve_count(&self) -> usize {
        self.base.steps.len()
    }

    /// The way of one curve along the map, in its direction; empty where it is a point, off the page or none of the map's.
    pub fn steps(&self, curve: usize) -> &[Step] {
        self.base.steps.get(curve).map_or(&[], Vec::as_slice)
    }

    /// The passages that may be closed to colours, in a fixed order.
    pub fn gaps(&self) -> &[Gap] {
        &self.gaps
    }

    /// Half the width of the widest line that is drawn through a node, in du; `None` where nothing but the frame
    /// passes through it.
    pub fn half_width_du(&self, node: u32) -> Option<f64> {
        self.base.half_widths_du.get(node as usize).copied().filter(|half_width_du| *half_width_du >= 0.0)
    }

    /// Whether only the frame passes through one of some nodes.
    pub(crate) fn is_at_border(&self, nodes: &[u32]) -> bool {
        nodes.iter().any(|&node| self.half_width_du(node).is_none())
    }

    /// Whether a curve ends where it starts, without a gap where it leaves the page.
    pub fn is_closed(&self, curve: usize) -> bool {
        let steps = &self.base.steps[curve];
        let gapless = steps.windows(2).all(|pair| pair[0].arc_du[1] == pair[1].arc_du[0]);
        match (steps.first(), steps.last()) {
            (Some(first), Some(last)) => gapless && self.ends(first.left)[0] == self.ends(last.left)[1],
            _ => false,
        }
    }

    /// The nodes at the start and the end of a side, in the direction that has it on the left.
    pub fn ends(&self, side: SideId) -> [u32; 2] {
        let [a, b] = self.base.pieces[side.piece()].nodes;
        if side.is_right() { [b, a] } else { [a, b] }
    }

    /// The gaps that are closed, by what is said of each; gaps beyond the end of that are open.
    pub fn closed_gaps<'a>(&'a self, is_closed: &'a [bool]) -> impl Iterator<Item = &'a Gap> + use<'a> {
        self.gaps.iter().zip(is_closed).filter(|(_, is_closed)| **is_closed).map(|(gap, _)| gap)
    }

    /// The same map with other gaps. A gap counts where its nodes are joined by an edge that is no piece; one that is
    /// given twice, or anywhere else, can be closed without effect on a mesh.
    pub fn with_gaps(mut self, gaps: Vec<Gap>) -> Self {
        self.set_gaps(gaps);
        self
    }

    pub(crate) fn set_gaps(&mut self, gaps: Vec<Gap>) {
        self.triangulation.mark_gaps(gaps.iter().map(|gap| gap.nodes));
        self.gaps = gaps;
        self.refined = OnceLock::new();
    }

    /// How wide all passages are, whichever gaps there are. Worked out at the first call.
    pub(crate) fn clearance(&self) -> &Clearance {
        self.base.clearance.get_or_init(|| now(Slices::new(Clearance::measuring(self))))
    }

    /// Works [`PlanarMap::clearance`] out, in slices.
    pub(crate) async fn measuring(&self) {
        if self.base.clearance.get().is_none() {
            let _ = self.base.clearance.set(Slices::new(Clearance::measuring(self)).await);
        }
    }

    /// The same pieces with further nodes between them, so that angles are at least 20° where the pieces allow it, and 29°
    /// in larger triangles, and no triangle is larger than the sampling asks for: the mesh of the solver. Pieces are never
    /// split; gaps are chains of edges. Worked out at the first call, and anew with other gaps. Of a rough map it is the
    /// triangulation as it is.
    pub fn refined(&self) -> &Arc<Triangulation> {
        self.refined.get_or_init(|| Arc::new(now(Slices::new(self.finer()))))
    }

    /// Works [`PlanarMap::refined`] out, in slices.
    pub fn refining(&self) -> Slices<'_, ()> {
        Slices::new(async {
            if self.refined.get().is_none() {
                let _ = self.refined.set(Arc::new(Slices::new(self.finer()).await));
            }
        })
    }

    /// Whether [`PlanarMap::refined`] is the triangulation as it is: at once, and rough.
    pub fn is_rough(&self) -> bool {
        self.is_rough
    }

    /// Has [`PlanarMap::refined`] be the triangulation as it is, or be worked out.
    pub fn set_rough(&mut self, is_rough: bool) {
        self.is_rough = is_rough;
        self.refined = OnceLock::new();
    }

    async fn finer(&self) -> Triangulation {
        if self.is_rough {
            return self.triangulation.clone();
        }
        let mut cdt = self.base.cdt.clone();
        pace::pause().await;
        delaunay::keep_gaps(&mut cdt, &self.triangulation, &self.base.sampling).await;
        refinement::refine(&mut cdt, self.base.frame, self.base.sampling.spacing_du).await;
        Slices::new(delaunay::flatten(&cdt, &self.base.pieces)).await
    }
}

/// The frame is sampled this many times as coarsely as the curves: no colour sits on it, but as four long edges
/// it would spoil the triangles of the background.
const FRAME_COARSENING: f64 = 4.0;

/// The curves as stretches, and the frame after them; `None` where there are too many.
async fn polylines(drawing: &Drawing, frame: LatticePoint, sampling: &Sampling) -> Option<Vec<Vec<Stretch>>> {
    let (mut left, mut pace) = (MAX_PIECES, Pace::default());
    let page = sample::frame_rect(frame);
    let mut feet = Vec::new();
    let mut polylines = Vec::with_capacity(drawing.curves.len() + 1);
    for curve in &drawing.curves {
        let polyline = sample::sample(&curve.path, page, sampling, left)?;
        left = left.checked_sub(polyline.len())?;
        pace.work(1 + polyline.len()).await;
        sample::add_feet(frame, &polyline, &mut feet);
        polylines.push(polyline);
    }
    let frame_sampling = Sampling { spacing_du: FRAME_COARSENING * sampling.spacing_du, ..*sampling };
    polylines.push(sample::sample(&sample::frame_path(frame, feet), page, &frame_sampling, left)?);
    Some(polylines)
}

/// Pieces without repeats, and each curve's steps along them. The last polyline is the frame.
async fn pieces_and_steps(polylines: &[Vec<Stretch>], snapped: &Snapped) -> (Vec<Piece>, Vec<Vec<Step>>) {
    let mut ends: Vec<[u32; 2]> = snapped
        .chains
        .iter()
        .flat_map(|chain| chain.windows(2).map(|w| [w[0].min(w[1]), w[0].max(w[1])]))
        .collect();
    sort::sort_copies_by_key(&mut ends, |&ends| sort::pair(ends));
    ends.dedup();
    let mut pieces: Vec<_> = ends.iter().map(|&nodes| Piece { nodes, curve: None }).collect();
    let mut chains = snapped.chains.iter();
    let (mut steps, mut pace) = (Vec::with_capacity(polylines.len()), Pace::default());
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
            pace.work(1 + way.len()).await;
            steps.push(way);
        }
    }
    (pieces, steps)
}

/// Half the line width at each node, negative where there is no curve.
fn half_widths_du(drawing: &Drawing, steps: &[Vec<Step>], pieces: &[Piece], nodes: usize) -> Vec<f64> {
    let mut half_widths_du = vec![-1.0_f64; nodes];
    for (curve, steps) in drawing.curves.iter().zip(steps) {
        let width_du = curve.line.as_ref().map_or(0.0, |line| line.stroke.width);
        let half_width_du = if width_du.is_finite() { 0.5 * width_du.max(0.0) } else { 0.0 };
        for node in steps.iter().flat_map(|step| pieces[step.left.piece()].nodes) {
            let at_node = &mut half_widths_du[node as usize];
            *at_node = at_node.max(half_width_du);
        }
    }
    half_widths_du
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
