//! The ways of curves between the nodes of a map, for a picture so close that its pieces would be seen as chords.

use kurbo::{Point, Rect, Vec2};

use crate::drawing::Drawing;
use crate::planar_map::{PlanarMap, Sampling, Step};
use crate::sample::{self, LatticePoint, Stretch};
use crate::sort;
use crate::triangulation::SideId;

/// Nodes of a map are at most so far off the place that their curve has there, in du; where they are farther, as where a
/// curve was cut, its pieces count as straight.
const MOST_OFF_DU: f64 = 0.5;

/// Knots are at multiples of this, so that they are at the same places from both sides.
const STEP: f64 = 1.0 / 1_048_576.0;

/// A knot so near an end of a piece, as a part of it, is that end by other arithmetic.
const END: f64 = 0.02;

/// How the pieces of a map bend in a part of the plane. A place on a piece is a part of the way from its start to its end; at
/// *knots* it is known how far off the chord the curve is.
#[derive(Clone, Debug, Default)]
pub struct Bends {
    /// The piece of each knot, and behind it where on the piece it is, in [`STEP`]s; in ascending order, each with its place
    /// among the distances.
    knots: Vec<(u64, u32)>,
    off_du: Vec<Vec2>,
}

impl Bends {
    /// Follows the curves of a drawing along the pieces of its map that come near a part of the page. They go straight from
    /// knot to knot, at most `chord_du` off, which is positive.
    pub fn within(drawing: &Drawing, map: &PlanarMap, part_du: Rect, chord_du: f64) -> Self {
        let sampling = Sampling { chord_du, ..map.sampling() };
        let part_du = part_du.inflate(sampling.spacing_du, sampling.spacing_du).intersect(map.frame());
        let mut bends = Self::default();
        for (i, curve) in drawing.curves.iter().enumerate() {
            let steps = map.steps(i);
            if !steps.is_empty() && curve.path.control_box().overlaps(part_du) {
                let stretches =
                    sample::sample(&curve.path, part_du, &sampling, usize::MAX).unwrap_or_default();
                for step in steps {
                    if map.pieces()[step.left.piece()].curve == Some(i as u32) {
                        bends.add(map, step, &stretches);
                    }
                }
            }
        }
        sort::sort(&mut bends.knots);
        bends
    }

    /// Adds the knots between the ends of a step.
    fn add(&mut self, map: &PlanarMap, step: &Step, stretches: &[Stretch]) {
        let [from_du, to_du] = step.arc_du;
        let first = stretches.partition_point(|stretch| stretch.arc_du[1] <= from_du);
        let behind = stretches.partition_point(|stretch| stretch.arc_du[0] < to_du);
        let Some([own @ .., last]) = stretches.get(first..behind) else { return };
        let points = map.triangulation().points();
        let nodes = map.ends(step.left).map(|node| points[node as usize]);
        let ends = [place(own.first().unwrap_or(last), from_du), place(last, to_du)];
        let is_near = |i: usize| (nodes[i] - ends[i]).hypot2() < MOST_OFF_DU * MOST_OFF_DU;
        if !is_near(0) || !is_near(1) {
            return;
        }
        for stretch in own {
            let steps = ((stretch.arc_du[1] - from_du) / (to_du - from_du) / STEP).round();
            let part = steps * STEP;
            if part > END && part < 1.0 - END {
                let steps = if step.left.is_right() { STEP.recip() - steps } else { steps };
                self.knots.push((key(step.left, steps), self.off_du.len() as u32));
                self.off_du.push(stretch.ends[1].to_point() - ends[0].lerp(ends[1], part));
            }
        }
    }

    /// How many knots a side has. None where it is straight.
    pub fn knot_count(&self, side: SideId) -> usize {
        self.of_piece(side).len()
    }

    /// Where one of its knots is, counted from the start of the side.
    pub fn knot(&self, side: SideId, i: usize) -> f64 {
        let knots = self.of_piece(side);
        if side.is_right() { 1.0 - part(knots[knots.len() - 1 - i]) } else { part(knots[i]) }
    }

    /// How far the curve is off the chord at a place of a side, in du.
    pub fn off_du(&self, side: SideId, at: f64) -> Vec2 {
        let at = if side.is_right() { 1.0 - at } else { at };
        let knots = self.of_piece(side);
        let after = knots.partition_point(|&knot| part(knot) < at);
        let (mut a, mut b) = ((0.0, Vec2::ZERO), (1.0, Vec2::ZERO));
        if after > 0 {
            a = self.place(knots[after - 1]);
        }
        if after < knots.len() {
            b = self.place(knots[after]);
        }
        a.1.lerp(b.1, (at - a.0) / (b.0 - a.0))
    }

    /// The knots of the piece that a side belongs to, from the start of the piece.
    fn of_piece(&self, side: SideId) -> &[(u64, u32)] {
        let from = |steps: f64| self.knots.partition_point(|&(other, _)| other < key(side, steps));
        &self.knots[from(0.0)..from(STEP.recip())]
    }

    fn place(&self, knot: (u64, u32)) -> (f64, Vec2) {
        (part(knot), self.off_du[knot.1 as usize])
    }
}

fn key(side: SideId, steps: f64) -> u64 {
    ((side.piece() as u64) << 32) + steps as u64
}

fn part((key, _): (u64, u32)) -> f64 {
    f64::from(key as u32) * STEP
}

/// Where on a stretch, or on its way beyond, an arc position is.
fn place(stretch: &Stretch, arc_du: f64) -> Point {
    let [from_du, to_du] = stretch.arc_du;
    let [a, b] = stretch.ends.map(LatticePoint::to_point);
    a.lerp(b, (arc_du - from_du) / (to_du - from_du))
}
