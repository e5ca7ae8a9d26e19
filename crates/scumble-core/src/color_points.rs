//! Colour points: the colours of the sides of curves, as diffusion curves carry them (Orzan et al. 2008).
//!
//! A *run* of equal labels along one side of a curve holds its colour; where two runs meet, the colour passes from
//! one to the other over a short transition, as in Figure 2(f) of Bao & Fu 2019, but where another line, or a closed gap,
//! parts them. Where a side has points that were set by hand, these alone give it its colours.

use crate::color::{BlendColor, Paint};
use crate::engine::Labels;
use crate::planar_map::{PlanarMap, Step};
use crate::scribble::Scribble;
use crate::sort;
use crate::triangulation::SideId;

/// A colour that was set by hand at a place along one side of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColorPoint {
    /// Index of the curve; that of none is passed over.
    pub curve: u32,
    /// Whether it is to the left of the curve's direction, where y points down.
    pub is_left: bool,
    /// Way along the curve from its start, in du.
    pub at_du: f64,
    /// The colour, or nothing.
    pub color: Paint,
}

/// The coloured stretches of all curves. A side with a colour that was set by hand is one stretch from end to end.
pub fn curve_colors(
    map: &PlanarMap,
    labels: &Labels,
    scribbles: &[Scribble],
    by_hand: &[ColorPoint],
) -> Vec<ColorSpan> {
    let by_hand = sorted(by_hand);
    let (mut by_hand, mut spans) = (spans_by_hand(map, &by_hand).peekable(), Vec::new());
    for curve in 0..map.curve_count() as u32 {
        let paints: Vec<_> = step_paints(map, curve, label_paint(labels, scribbles)).collect();
        for is_left in [false, true] {
            match by_hand.next_if(|span| (span.curve, span.is_left) == (curve, is_left)) {
                Some(span) => spans.push(span),
                None => {
                    CurveSide { map, curve, is_left }.add_spans(&paints, &labels.closed_gaps, &mut spans);
                }
            }
        }
    }
    spans
}

/// The colour that labels, which name scribbles by their indices, give a side.
pub(crate) fn label_paint(labels: &Labels, scribbles: &[Scribble]) -> impl Fn(SideId) -> Option<Paint> {
    |side| {
        let label = labels.sides.get(side.index()).copied().flatten()?;
        scribbles.get(label as usize).map(|scribble| scribble.color)
    }
}

/// The colours of a step, on the right of the curve and on its left, as [`ColorSpan::is_left`] has it.
pub(crate) type StepPaints = [Option<Paint>; 2];

/// The colours of all steps of a curve.
pub(crate) fn step_paints(
    map: &PlanarMap,
    curve: u32,
    paint_of: impl Fn(SideId) -> Option<Paint>,
) -> impl Iterator<Item = StepPaints> {
    map.steps(curve as usize).iter().map(move |step| [step.left, step.left.opposite()].map(&paint_of))
}

/// Length of the transition between two runs, in du; shorter where a run is shorter.
pub const TRANSITION_DU: f64 = 24.0;

/// A colour at a place along one side of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stop {
    /// Distance from the start of the curve along it, in du.
    pub arc_du: f64,
    /// The colour as picked, or nothing: around it the picture fades into the paper.
    pub color: Paint,
}

/// A coloured stretch of one side of a curve: linear between its stops, and from its first to its last only.
#[derive(Clone, Debug, PartialEq)]
pub struct ColorSpan {
    /// Index of the curve.
    pub curve: u32,
    /// Whether it is to the left of the curve's direction, where y points down: [`Step::left`] is where y points up.
    pub is_left: bool,
    /// At least two, in ascending order. On a closed curve the arc position may count on past the curve's end
    /// into its next round.
    pub stops: Vec<Stop>,
}

/// Points by their sides, and along each; without those at no place.
pub(crate) fn sorted(points: &[ColorPoint]) -> Vec<ColorPoint> {
    let mut points: Vec<_> = points.iter().copied().filter(|p| p.at_du.is_finite()).collect();
    let keys: [fn(&ColorPoint) -> u64; 2] = [|p| sort::float(p.at_du), side_key];
    for key in keys {
        sort::sort_copies_by_key(&mut points, key);
    }
    points
}

/// A number for the side of the curve that a point is on.
fn side_key(point: &ColorPoint) -> u64 {
    u64::from(point.curve) << 1 | u64::from(point.is_left)
}

/// The spans of the sides with points that were set by hand, which are [`sorted`].
pub(crate) fn spans_by_hand(map: &PlanarMap, points: &[ColorPoint]) -> impl Iterator<Item = ColorSpan> {
    points.chunk_by(|a, b| side_key(a) == side_key(b)).filter_map(|own| span_by_hand(map, own))
}

/// The span of one side's points: before the first and after the last the colour stays.
fn span_by_hand(map: &PlanarMap, points: &[ColorPoint]) -> Option<ColorSpan> {
    let [first, last] = [points.first()?, points.last()?];
    let end_du = map.steps(first.curve as usize).last()?.arc_du[1];
    let stop = |arc_du, p: &ColorPoint| Stop { arc_du, color: p.color };
    let mut stops = vec![stop(first.at_du.min(0.0), first)];
    stops.extend(points.iter().map(|p| stop(p.at_du, p)));
    stops.push(stop(last.at_du.max(end_du), last));
    Some(ColorSpan { curve: first.curve, is_left: first.is_left, stops })
}

/// One side of a curve, from end to end.
#[derive(Debug)]
pub(crate) struct CurveSide<'a> {
    pub(crate) map: &'a PlanarMap,
    pub(crate) curve: u32,
    pub(crate) is_left: bool,
}

impl<'a> CurveSide<'a> {
    fn steps(&self) -> &'a [Step] {
        self.map.steps(self.curve as usize)
    }

    /// Appends its coloured stretches to a list, the steps of the curve having these colours.
    pub(crate) fn add_spans(&self, paints: &[StepPaints], closed_gaps: &[bool], spans: &mut Vec<ColorSpan>) {
        let colors: Vec<_> = paints.iter().map(|both| both[usize::from(self.is_left)]).collect();
        if !colors.iter().any(Option::is_some) {
            return;
        }
        let seam = if self.map.is_closed(self.curve as usize) { seam(&colors) } else { 0 };
        let runs = runs(self.steps(), &colors, seam);
        let parts = runs.chunk_by(|a, b| a.end_du == b.start_du && !self.is_parted(b.first, closed_gaps));
        let span = |runs| ColorSpan { curve: self.curve, is_left: self.is_left, stops: stops(runs) };
        spans.extend(parts.map(span));
    }

    /// Whether another line, or a closed gap, parts it where a step begins.
    fn is_parted(&self, step: usize, closed_gaps: &[bool]) -> bool {
        let steps = self.steps();
        let before = (step + steps.len() - 1) % steps.len();
        let [before, after] = [before, step].map(|i| side(&steps[i], self.is_left));
        let (from, to) = if self.is_left { (after, before) } else { (before, after) };
        let mesh = self.map.triangulation();
        let is_open = |h| mesh.gap(h).is_none_or(|gap| closed_gaps.get(gap as usize) != Some(&true));
        self.map.half_edge(from).and_then(|h| mesh.side_after(h, is_open)) != Some(to)
    }
}

/// The side of a step that is on one side of the curve.
pub(crate) fn side(step: &Step, is_left: bool) -> SideId {
    if is_left { step.left.opposite() } else { step.left }
}

/// The step of a closed curve at which its sides are cut open: the middle of the longest run, where no transition
/// is lost; 0 where all are alike.
fn seam(colors: &[Option<Paint>]) -> usize {
    let len = colors.len();
    let is_start = |i: &usize| colors[*i] != colors[(i + len - 1) % len];
    let starts: Vec<usize> = (0..len).filter(is_start).collect();
    let next = starts.iter().skip(1).copied().chain(starts.first().map(|first| first + len));
    let longest = starts.iter().zip(next).max_by_key(|(start, next)| next - *start);
    longest.map_or(0, |(start, next)| (start + next) / 2 % len)
}

/// A stretch of one colour.
#[derive(Clone, Copy, Debug)]
struct Run {
    start_du: f64,
    end_du: f64,
    color: Paint,
    /// Its first step.
    first: usize,
}

/// The runs of a curve's side, from step `seam` on and around.
fn runs(steps: &[Step], colors: &[Option<Paint>], seam: usize) -> Vec<Run> {
    let round_du = steps.last().map_or(0.0, |last| last.arc_du[1]);
    let mut runs: Vec<Run> = Vec::new();
    for i in (seam..steps.len()).chain(0..seam) {
        let Some(color) = colors[i] else { continue };
        let before_du = if i < seam { round_du } else { 0.0 };
        let [start_du, end_du] = steps[i].arc_du.map(|arc_du| arc_du + before_du);
        match runs.last_mut() {
            Some(run) if run.color == color && run.end_du == start_du => run.end_du = end_du,
            _ => runs.push(Run { start_du, end_du, color, first: i }),
        }
    }
    runs
}

/// The stops of runs that follow one another without a gap.
fn stops(runs: &[Run]) -> Vec<Stop> {
    let inset = |i: usize, j: Option<usize>| {
        let length_du = |run: &Run| run.end_du - run.start_du;
        j.and_then(|j| runs.get(j))
            .map_or(0.0, |other| 0.5 * TRANSITION_DU.min(length_du(&runs[i])).min(length_du(other)))
    };
    let of_run = |(i, run): (usize, &Run)| {
        let start_du = run.start_du + inset(i, i.checked_sub(1));
        let end_du = run.end_du - inset(i, Some(i + 1));
        [start_du, end_du].map(|arc_du| Stop { arc_du, color: run.color })
    };
    runs.iter().enumerate().flat_map(of_run).collect()
}

/// A place along a curve in du and its colour.
pub type Knot = (f64, BlendColor);

/// The colour at a place along a curve: linear between knots, of which there is at least one, in ascending order;
/// that of the nearer end beyond them.
pub fn color_at(knots: &[Knot], arc_du: f64) -> BlendColor {
    let after = knots.partition_point(|knot| knot.0 <= arc_du);
    let [before, after] = [after.saturating_sub(1), after.min(knots.len() - 1)];
    let ((a, from), (b, to)) = (knots[before], knots[after]);
    let t = if b > a { ((arc_du - a) / (b - a)).clamp(0.0, 1.0) } else { 0.0 };
    if from == to { from } else { [0, 1, 2, 3].map(|i| from[i] + t * (to[i] - from[i])) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::boundary::{SideColors, color_span};
    use crate::color::{Blend, Srgb8};
    use crate::drawing::{Curve, Drawing};
    use crate::planar_map::Sampling;
    use kurbo::{Circle, Rect, Shape};

    const RED: Paint = Paint::Color(Srgb8([200, 0, 0]));
    const BLUE: Paint = Paint::Color(Srgb8([0, 0, 200]));

    fn circle_map() -> PlanarMap {
        let mut drawing = Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0));
        let path = Circle::new((500.0, 500.0), 200.0).to_path(1e-6);
        drawing.curves.push(Curve { path, line: None });
        PlanarMap::build(&drawing, &Sampling::default()).expect("a map")
    }

    fn color_spans(
        map: &PlanarMap,
        color_of: impl Fn(SideId) -> Option<Paint>,
        closed_gaps: &[bool],
    ) -> Vec<ColorSpan> {
        let mut spans = Vec::new();
        for curve in 0..map.curve_count() as u32 {
            let paints: Vec<_> = step_paints(map, curve, &color_of).collect();
            for is_left in [false, true] {
                CurveSide { map, curve, is_left }.add_spans(&paints, closed_gaps, &mut spans);
            }
        }
        spans
    }

    fn inner(map: &PlanarMap, color: impl Fn(usize) -> Option<Paint>) -> Vec<ColorSpan> {
        let index_of = |side: SideId| map.steps(0).iter().position(|step| step.left == side);
        color_spans(map, |side| index_of(side).and_then(&color), &[])
    }

    fn side_colors(map: &PlanarMap, spans: &[ColorSpan], blend: Blend) -> SideColors {
        let mut sides = vec![None; map.side_count()];
        spans.iter().for_each(|span| color_span(map, span, &mut |paint| blend.from_paint(paint), &mut sides));
        sides
    }

    #[test]
    fn one_colour_around_is_one_span_of_two_points() {
        let map = circle_map();
        let spans = inner(&map, |_| Some(RED));
        assert_eq!(spans.len(), 1);
        assert_eq!(spans[0].stops.len(), 2);
        let colors = side_colors(&map, &spans, Blend::Srgb);
        let red = Blend::Srgb.from_paint(RED);
        for step in map.steps(0) {
            assert_eq!(colors[step.left.index()], Some([red; 3]));
            assert_eq!(colors[step.left.opposite().index()], None);
        }
    }

    #[test]
    fn two_colours_pass_into_one_another_at_both_of_their_borders() {
        let map = circle_map();
        let count = map.steps(0).len();
        let spans = inner(&map, |i| Some(if i < count / 3 { RED } else { BLUE }));
        let colors = side_colors(&map, &spans, Blend::Srgb);
        let blue_at =
            |i: usize, k: usize| colors[map.steps(0)[i % count].left.index()].expect("a colour")[k][2];
        let full = 200.0 / 255.0;
        for border in [0, count / 3] {
            assert!((blue_at(border, 0) - 0.5 * full).abs() < 0.1, "half-way at the border");
        }
        for i in 0..count {
            assert!((blue_at(i, 2) - blue_at(i + 1, 0)).abs() < 1e-9, "continuous around");
            assert!((blue_at(i, 2) - blue_at(i, 0)).abs() < 0.2 * full, "no jump at step {i}");
        }
        assert_eq!(blue_at(count / 6, 1), 0.0);
        assert_eq!(blue_at(2 * count / 3, 1), full);
    }

    /// A line that ends on the upper side of another parts the colours there, not those below it, and so does a gap that is
    /// closed, where it falls short of it.
    #[test]
    fn what_lies_between_two_colours_parts_them_on_its_own_side() {
        let transitions = |foot_du: f64, is_closed: bool| {
            let mut drawing = Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0));
            for path in ["M 100 500 H 900", &format!("M 500 100 V {foot_du}")] {
                let path = kurbo::BezPath::from_svg(path).expect("a path");
                drawing.curves.push(Curve { path, line: None });
            }
            let map = PlanarMap::build(&drawing, &Sampling::default()).expect("a map").with_gaps_closed(1.0);
            let at = |side: SideId| map.triangulation().points()[map.ends(side)[0] as usize];
            let is_west = |side: SideId| 0.5 * (at(side) + at(side.opposite()).to_vec2()).x < 500.0;
            let color = |side| Some(if is_west(side) { RED } else { BLUE });
            let spans = color_spans(&map, color, &vec![is_closed; map.gaps().len()]);
            [false, true].map(|is_left| {
                spans.iter().filter(|span| (span.curve, span.is_left) == (0, is_left)).count() == 1
            })
        };
        assert_eq!(transitions(500.0, false), [true, false]);
        assert_eq!(transitions(490.0, false), [true, true]);
        assert_eq!(transitions(490.0, true), [true, false]);
    }

    #[test]
    fn towards_a_clear_run_the_colour_fades_and_keeps_its_hue() {
        let map = circle_map();
        let count = map.steps(0).len();
        let spans = inner(&map, |i| Some(if i < count / 3 { RED } else { Paint::Clear }));
        let colors = side_colors(&map, &spans, Blend::Oklab);
        let at = |i: usize| colors[map.steps(0)[i].left.index()].expect("a colour")[0];
        assert_eq!(at(count / 6), Blend::Oklab.from_paint(RED));
        assert_eq!(at(2 * count / 3), [0.0; 4]);
        let border = Blend::Oklab.to_rgba8(at(count / 3)).0;
        assert!(border[..3] == [200, 0, 0] && border[3].abs_diff(128) < 26, "{border:?}");
    }

    #[test]
    fn a_span_of_one_point_colours_what_is_there() {
        let red = Blend::Srgb.from_paint(RED);
        for arc_du in [0.0, 5.0, 9.0] {
            assert_eq!(color_at(&[(5.0, red)], arc_du), red);
        }
    }

    #[test]
    fn sides_without_a_colour_stay_without() {
        let map = circle_map();
        let spans = inner(&map, |i| (10..20).contains(&i).then_some(RED));
        let colors = side_colors(&map, &spans, Blend::Oklab);
        let colored = map.steps(0).iter().filter(|step| colors[step.left.index()].is_some()).count();
        assert_eq!(colored, 10);
    }
}
