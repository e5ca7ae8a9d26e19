//! The boundary: what the solver is given to spread, and what it is made from.

use std::mem;

use crate::color::{Blend, BlendColor, Paint};
use crate::color_points::{
    ColorPoint, ColorSpan, CurveSide, Knot, StepPaints, color_at, label_paint, side, sorted, spans_by_hand,
    step_paints,
};
use crate::engine::Labels;
use crate::pace::{self, Pace, Slices, now};
use crate::planar_map::{PlanarMap, Step};
use crate::scribble::Scribble;
use crate::source::{SoftSource, soft_sources};

/// The colour of a side at the start, the middle and the end of its half-edge in the triangulation; `None` where
/// the side has no colour and is a no-flux barrier. Indexed by [`crate::SideId`].
pub type SideColors = Vec<Option<[BlendColor; 3]>>;

/// What bounds and feeds the spreading of colours: the input of the solver.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Boundary {
    /// The colours of the sides of curves; sides beyond its end have none.
    pub sides: SideColors,
    /// For each gap of the map whether it lets no colour through; gaps beyond its end are open.
    pub closed_gaps: Vec<bool>,
    /// What shades; in whatever order, but the picture may depend on that in its last bits.
    pub sources: Vec<SoftSource>,
}

impl From<SideColors> for Boundary {
    /// With all gaps open, and no sources.
    fn from(sides: SideColors) -> Self {
        Self { sides, ..Self::default() }
    }
}

/// The boundary that labels, which name scribbles by their indices, the scribbles, and colours set by hand give the
/// solver, in a blend space. It does not depend on the order of the scribbles that shade.
pub fn boundary(
    map: &PlanarMap,
    labels: &Labels,
    scribbles: &[Scribble],
    by_hand: &[ColorPoint],
    blend: Blend,
) -> Boundary {
    let mut known = KnownBoundary::default();
    now(known.following(map, labels, scribbles, by_hand, blend));
    known.boundary
}

/// The last [`boundary`] of one map, kept: only the curves that have other colours than then are coloured anew.
#[derive(Clone, Debug, Default)]
pub struct KnownBoundary {
    boundary: Boundary,
    /// The colours that labels gave the steps of all curves, curve after curve.
    paints: Vec<StepPaints>,
    by_hand: Vec<ColorPoint>,
    blend: Blend,
}

impl KnownBoundary {
    /// The last one; of no map at first.
    pub fn get(&self) -> &Boundary {
        &self.boundary
    }

    /// The space that its colours are in.
    pub fn blend(&self) -> Blend {
        self.blend
    }

    /// Makes it the [`boundary`] of these, in slices; the map is the same each time. What is left of one that was not let
    /// finish is of no use.
    pub fn following<'a>(
        &'a mut self,
        map: &'a PlanarMap,
        labels: &'a Labels,
        scribbles: &'a [Scribble],
        by_hand: &'a [ColorPoint],
        blend: Blend,
    ) -> Slices<'a, ()> {
        Slices::new(async move {
            self.begin(map, sorted(by_hand), blend);
            pace::pause_after(map.side_count()).await;
            self.color(map, labels, scribbles).await;
            self.boundary.sources = soft_sources(scribbles, blend);
        })
    }

    /// Forgets what is known where that is of no use.
    fn begin(&mut self, map: &PlanarMap, by_hand: Vec<ColorPoint>, blend: Blend) {
        if self.by_hand != by_hand || self.blend != blend || self.paints.is_empty() {
            let sides = vec![None; map.side_count()];
            *self = Self { boundary: sides.into(), paints: Vec::new(), by_hand, blend };
        }
        debug_assert_eq!(self.boundary.sides.len(), map.side_count());
    }

    /// Colours the sides of all curves, or of those alone on which something changed.
    async fn color(&mut self, map: &PlanarMap, labels: &Labels, scribbles: &[Scribble]) {
        let boundary = &mut self.boundary;
        let are_gaps_known = boundary.closed_gaps == labels.closed_gaps;
        boundary.closed_gaps.clone_from(&labels.closed_gaps);
        let (paint_of, mut color_of) = (label_paint(labels, scribbles), colors_in(self.blend));
        let known = mem::take(&mut self.paints);
        self.paints.reserve(known.len());
        let (mut spans, mut pace) = (Vec::new(), Pace::default());
        for curve in 0..map.curve_count() as u32 {
            let start = self.paints.len();
            self.paints.extend(step_paints(map, curve, &paint_of));
            let paints = &self.paints[start..];
            pace.work(paints.len()).await;
            // Where there are several colours, a closed gap parts them.
            let are_plain = || paints.windows(2).all(|both| both[0] == both[1]);
            if known.get(start..self.paints.len()) != Some(paints) || !are_gaps_known && !are_plain() {
                uncolor(map, curve, &mut boundary.sides);
                for is_left in [false, true] {
                    CurveSide { map, curve, is_left }.add_spans(paints, &labels.closed_gaps, &mut spans);
                }
                spans.drain(..).for_each(|span| color_span(map, &span, &mut color_of, &mut boundary.sides));
            }
        }
        for span in spans_by_hand(map, &self.by_hand) {
            color_span(map, &span, &mut color_of, &mut boundary.sides);
        }
    }
}

/// Colours in a blend space.
fn colors_in(blend: Blend) -> impl FnMut(Paint) -> BlendColor {
    let mut last = (Paint::Clear, blend.from_paint(Paint::Clear));
    move |paint| {
        // Most stops have the colour of the one before, and roots take their time.
        if paint != last.0 {
            last = (paint, blend.from_paint(paint));
        }
        last.1
    }
}

/// Takes the colours off the sides of a curve.
fn uncolor(map: &PlanarMap, curve: u32, colors: &mut SideColors) {
    for step in map.steps(curve as usize).iter().filter(|step| is_own(map, step, curve)) {
        for side in [step.left, step.left.opposite()] {
            colors[side.index()] = None;
        }
    }
}

/// Gives the sides along a span its colours.
pub(crate) fn color_span(
    map: &PlanarMap,
    span: &ColorSpan,
    color_of: &mut impl FnMut(Paint) -> BlendColor,
    colors: &mut SideColors,
) {
    let knots: Vec<_> = span.stops.iter().map(|p| (p.arc_du, color_of(p.color))).collect();
    let round_du = map.steps(span.curve as usize).last().map_or(0.0, |last| last.arc_du[1]);
    // Last without a round ahead: what was set by hand past the end is of no account.
    for before_du in [round_du, 0.0] {
        color_steps(map, span, &knots, before_du, colors);
    }
}

/// Colours the steps that lie within a span, `before_du` being what its arc positions are ahead of theirs.
fn color_steps(map: &PlanarMap, span: &ColorSpan, knots: &[Knot], before_du: f64, colors: &mut SideColors) {
    let [Some(first), Some(last)] = [knots.first(), knots.last()] else { return };
    let is_plain = knots.iter().all(|knot| knot.1 == first.1);
    let steps = map.steps(span.curve as usize);
    let begin = steps.partition_point(|step| step.arc_du[0] + before_du < first.0);
    let within = steps[begin..].iter().take_while(|step| step.arc_du[1] + before_du <= last.0);
    for step in within.filter(|step| is_own(map, step, span.curve)) {
        let [a, b] = step.arc_du.map(|arc_du| arc_du + before_du);
        let along = if is_plain { [first.1; 3] } else { [a, 0.5 * (a + b), b].map(|at| color_at(knots, at)) };
        let [start, middle, end] = along;
        let side = side(step, span.is_left);
        colors[side.index()] = Some(if span.is_left { [end, middle, start] } else { along });
    }
}

/// Whether no earlier curve runs along a step of a curve.
fn is_own(map: &PlanarMap, step: &Step, curve: u32) -> bool {
    map.pieces()[step.left.piece()].curve == Some(curve)
}
