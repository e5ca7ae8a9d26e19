//! What a circuit pays for a jump: equation 4, and charges for what the jump leaves out.

use kurbo::{Point, Vec2};

use super::outline::Outline;
use super::survey::Part;
use super::view::{Glimpse, JumpKind, Sample, View};
use super::{CUT, ETA, MU, SKIP};
use crate::angle::angle_part;
use crate::planar_map::PlanarMap;
use crate::sort;

/// Samples whose view is looked at, evenly spaced along the scribble, one of them at its middle.
const WATCHES: usize = 3;

/// Samples that jumps are tested against.
const MOST_SAMPLES: usize = 128;

/// Places along a jump at which it is looked for.
const MARKS: [f64; 4] = [0.125, 0.375, 0.625, 0.875];

/// What jumps cost around one scribble.
#[derive(Debug)]
pub(super) struct Costs {
    watches: Vec<Watch>,
    /// The samples of the scribble in order, not more than [`MOST_SAMPLES`].
    stroke: Vec<Point>,
}

impl Costs {
    pub(super) fn new(map: &PlanarMap, outline: &Outline, part: &Part) -> Self {
        let len = part.samples.len();
        let count = len.min(WATCHES);
        let watched = (0..count).map(|i| (2 * i + 1) * len / (2 * count));
        let step = len.div_ceil(MOST_SAMPLES).max(1);
        Self {
            watches: watched.map(|i| Watch::new(map, outline, part.samples[i])).collect(),
            stroke: part.samples.iter().map(|sample| sample.eye).step_by(step).collect(),
        }
    }

    /// What the sample half-way along the scribble sees.
    pub(super) fn middle(&self) -> Option<&View> {
        self.watches.get(self.watches.len() / 2).map(|watch| &watch.view)
    }

    /// The cost of a jump along a line that arrives and leaves in the given directions; the longest of all jumps is
    /// `longest_du` long.
    pub(super) fn jump(
        &self,
        kind: JumpKind,
        line: [Point; 2],
        [arriving, leaving]: [Vec2; 2],
        longest_du: f64,
    ) -> f64 {
        let gap = line[1] - line[0];
        if gap.hypot2() == 0.0 {
            return 0.0;
        }
        let turn = 0.5 * (angle_part(arriving, gap) + angle_part(gap, leaving));
        let v = ETA * gap.hypot() / longest_du + (1.0 - ETA) * turn * turn;
        let skip = if kind == JumpKind::Across { MU } else { SKIP };
        (1.0 - MU) * v + skip * self.skipped(line) + CUT * self.cut_off(line)
    }

    /// The part of the view that lies behind a line.
    fn skipped(&self, line: [Point; 2]) -> f64 {
        let sum: f64 = self.watches.iter().map(|watch| watch.behind(line)).sum();
        sum / self.watches.len().max(1) as f64
    }

    /// The part of the scribble beyond the places at which a line crosses it.
    fn cut_off(&self, [from, to]: [Point; 2]) -> f64 {
        let is_left = |[a, b]: [Point; 2], p: Point| (b - a).cross(p - a) > 0.0;
        let len = self.stroke.len();
        let is_crossed = |&i: &usize| {
            let [p, q] = [self.stroke[i - 1], self.stroke[i]];
            is_left([from, to], p) != is_left([from, to], q) && is_left([p, q], from) != is_left([p, q], to)
        };
        (1..len).filter(is_crossed).map(|i| i.min(len - i) as f64 / len as f64).sum()
    }
}

/// What one sample sees, made to look up places.
#[derive(Debug)]
struct Watch {
    view: View,
    /// The sides that it sees, by the direction in which each begins.
    sides: Vec<(f64, [Point; 2])>,
}

impl Watch {
    fn new(map: &PlanarMap, outline: &Outline, sample: Sample) -> Self {
        let view = View::new(map, outline, sample);
        let direction = |glimpse: &Glimpse| direction(glimpse.entry() - view.eye);
        let mut sides: Vec<_> =
            view.glimpses.iter().map(|glimpse| (direction(glimpse), glimpse.line)).collect();
        sort::sort_copies_by_key(&mut sides, |side| sort::float(side.0));
        Self { view, sides }
    }

    /// The angle, as a part of the full turn, in which a line is seen before anything else; 0 for one that has the eye
    /// on its right, where the outside of the circuit is.
    fn behind(&self, [from, to]: [Point; 2]) -> f64 {
        if (to - from).cross(self.view.eye - from) <= 0.0 {
            return 0.0;
        }
        let seen = MARKS.iter().filter(|&&mark| self.sees(from.lerp(to, mark))).count();
        let angle = if seen > 0 { 0.5 * angle_part(from - self.view.eye, to - self.view.eye) } else { 0.0 };
        angle * seen as f64 / MARKS.len() as f64
    }

    /// Whether nothing lies before a place.
    fn sees(&self, place: Point) -> bool {
        let after = self.sides.partition_point(|&(start, _)| start <= direction(place - self.view.eye));
        let side = self.sides.get(after.wrapping_sub(1)).or(self.sides.last());
        side.is_some_and(|&(_, [a, b])| (b - a).cross(place - a) > 0.0)
    }
}

/// The direction of a vector from −1 to 1, in half turns.
fn direction(v: Vec2) -> f64 {
    angle_part(Vec2::new(1.0, 0.0), v) * if v.y < 0.0 { -1.0 } else { 1.0 }
}
