//! One curve's colours, and the parts into which they cut it.

use kurbo::{BezPath, CubicBez, ParamCurve};
use scumble_core::color_points::{ColorSpan, Knot, color_at};
use scumble_core::measured_path::MeasuredPath;
use scumble_core::{Blend, BlendColor, Paint};

use super::{PAPER, Part};

/// The arc positions of the map that colours were found on may be that far off, in du. Colours end by so much sooner, so
/// that none looks around the corner of a crossing into what has none.
const INSET_DU: f64 = 0.05;

/// A round is that much longer or shorter than the curve at most, in du, where all of the curve is on the page.
const SAME_LENGTH_DU: f64 = 0.5;

/// Places that are this close to each other are one, in cubics or in du.
const SAME_PLACE: f64 = 1e-9;

/// A curve with the coloured stretches of its left and its right side.
pub(super) struct Stretches {
    path: MeasuredPath,
    sides: [Vec<Stretch>; 2],
    blend: Blend,
}

/// The colours of a stretch from its first knot to its last.
type Stretch = Vec<Knot>;

impl Stretches {
    /// The stretches of spans that are all of one curve, of which one round is so long.
    pub(super) fn new(path: &BezPath, spans: &[&ColorSpan], round_du: f64, blend: Blend) -> Self {
        let mut this = Self { path: MeasuredPath::new(path), sides: [vec![], vec![]], blend };
        for span in spans {
            let knots: Stretch =
                span.stops.iter().map(|stop| (stop.arc_du, color_of(stop.color, blend))).collect();
            let side = &mut this.sides[usize::from(!span.is_left)];
            let end_du = this.path.length_du();
            let last_du = if (round_du - end_du).abs() < SAME_LENGTH_DU { round_du } else { end_du };
            let is_around = ends_du(&knots)[1] - ends_du(&knots)[0] > last_du - SAME_PLACE;
            let inset_du = if is_around { 0.0 } else { INSET_DU };
            // A span may go on into the next round; one that has all of the first needs no second.
            for ahead_du in [0.0, round_du] {
                side.extend(clipped(&knots, [ahead_du, ahead_du + last_du]).map(|mut stretch| {
                    stretch.iter_mut().for_each(|knot| knot.0 -= ahead_du);
                    inset(&mut stretch, inset_du, [last_du, end_du]);
                    stretch
                }));
                let has_all = |stretch: &Stretch| ends_du(stretch) == [0.0, end_du];
                if round_du <= 0.0 || side.last().is_some_and(has_all) {
                    break;
                }
            }
        }
        this
    }

    /// The curve in parts, of which each side has colours from end to end or none.
    pub(super) fn parts(&self) -> impl Iterator<Item = Part> {
        let ends = self.sides.iter().flatten().flat_map(|stretch| ends_du(stretch));
        let mut cuts: Vec<_> = ends.chain([0.0, self.path.length_du()]).collect();
        cuts.sort_by(f64::total_cmp);
        cuts.dedup();
        let parts: Vec<_> = cuts.windows(2).map(|ends| self.part([ends[0], ends[1]])).collect();
        parts.into_iter().filter(|part| !part.cubics.is_empty())
    }

    fn part(&self, ends: [f64; 2]) -> Part {
        let middle_du = 0.5 * (ends[0] + ends[1]);
        let is_here = |stretch: &&Stretch| (ends_du(stretch)[0]..=ends_du(stretch)[1]).contains(&middle_du);
        let colors = self.sides.each_ref().map(|stretches| {
            let here = stretches.iter().find(is_here);
            let knots = here.and_then(|stretch| clipped(stretch, ends)).unwrap_or_default();
            knots.into_iter().map(|(at_du, color)| (self.path.place(at_du), color)).collect::<Vec<_>>()
        });
        let places = self.places(ends, colors.iter().flatten().map(|(place, _)| *place));
        let cubics = places.windows(2).filter_map(|pair| self.cubic([pair[0], pair[1]])).collect();
        let colors = colors.map(|colors| {
            let cubic = |place: f64| places.partition_point(|known| *known < place - SAME_PLACE);
            colors.into_iter().map(|(place, color)| (cubic(place), self.blend.to_rgba8(color))).collect()
        });
        Part { cubics, colors }
    }

    /// Where one cubic ends and the next one begins: at the ends, at colours, and where it is so in the curve.
    fn places(&self, ends: [f64; 2], colors: impl Iterator<Item = f64>) -> Vec<f64> {
        let [first, last] = ends.map(|at_du| self.path.place(at_du));
        let joints = (first.ceil() as usize..=last as usize).map(|joint| joint as f64);
        let mut places: Vec<_> = joints.chain(colors).chain([first, last]).collect();
        places.sort_by(f64::total_cmp);
        places.dedup_by(|b, a| *b - *a < SAME_PLACE);
        places
    }

    fn cubic(&self, [from, to]: [f64; 2]) -> Option<CubicBez> {
        let segment = (0.5 * (from + to)).floor();
        let cubic = self.path.segments().get(segment as usize)?;
        Some(cubic.subsegment((from - segment).max(0.0)..(to - segment).min(1.0)))
    }
}

fn color_of(paint: Paint, blend: Blend) -> BlendColor {
    match paint {
        Paint::Color(color) => blend.from_srgb8(color),
        Paint::Clear => blend.from_srgb8(PAPER),
    }
}

fn ends_du(stretch: &[Knot]) -> [f64; 2] {
    [stretch.first(), stretch.last()].map(|knot| knot.map_or(0.0, |knot| knot.0))
}

/// The part of a stretch that is between two places, if there is any.
fn clipped(knots: &[Knot], [from_du, to_du]: [f64; 2]) -> Option<Stretch> {
    let [first_du, last_du] = ends_du(knots);
    let [from_du, to_du] = [from_du.max(first_du), to_du.min(last_du)];
    if to_du <= from_du {
        return None;
    }
    let knot = |at_du| (at_du, color_at(knots, at_du));
    let within = knots.iter().copied().filter(|(at_du, _)| from_du < *at_du && *at_du < to_du);
    Some([knot(from_du)].into_iter().chain(within).chain([knot(to_du)]).collect())
}

/// Moves the ends of a stretch inwards, but for one at an end of the curve, of which the map knew the last one's place.
fn inset(stretch: &mut Stretch, inset_du: f64, [last_du, end_du]: [f64; 2]) {
    let [from_du, to_du] = ends_du(stretch);
    let inset_du = inset_du.min(0.25 * (to_du - from_du));
    let from_du = if from_du > 0.0 { from_du + inset_du } else { 0.0 };
    let to_du = if to_du < last_du { to_du - inset_du } else { end_du };
    if let (Some(first), Some(last)) = (stretch.first().copied(), stretch.last().copied()) {
        stretch.retain(|(at_du, _)| from_du < *at_du && *at_du < to_du);
        stretch.insert(0, (from_du, first.1));
        stretch.push((to_du, last.1));
    }
}
