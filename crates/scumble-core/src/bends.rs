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

/// How the pieces of a map bend in a part of the plane. A place on a piece is a part of the way from its start to its end.
#[derive(Clone, Debug, Default)]
pub struct Bends {
    /// Pieces that bend, in ascending order, each with where its knots begin; and one more that says where the last ends.
    pieces: Vec<(u32, usize)>,
    knots: Vec<Knot>,
}

/// A place between the ends of a piece, and how far off the chord its curve is there.
#[derive(Clone, Copy, Debug)]
struct Knot {
    part: f64,
    off_du: Vec2,
}

impl Bends {
    /// Follows the curves of a drawing along the pieces of its map that come near a part of the page. They go straight from
    /// knot to knot, at most `chord_du` off, which is positive.
    pub fn within(drawing: &Drawing, map: &PlanarMap, part_du: Rect, chord_du: f64) -> Self {
        let sampling = map.sampling();
        let part_du = part_du.inflate(sampling.spacing_du, sampling.spacing_du).intersect(map.frame());
        let finer = Sampling { chord_du, ..sampling };
        let mut bent = Vec::new();
        for (i, curve) in drawing.curves.iter().enumerate() {
            let near = || curve.path.control_box().overlaps(part_du);
            if !map.steps(i).is_empty() && near() {
                let stretches = sample::sample(&curve.path, part_du, &finer, usize::MAX).unwrap_or_default();
                let own = |step: &&Step| map.pieces()[step.left.piece()].curve == Some(i as u32);
                let steps = map.steps(i).iter().filter(own);
                bent.extend(steps.filter_map(|step| bend(map, step, &stretches)));
            }
        }
        Self::new(bent)
    }

    fn new(mut bent: Vec<(u32, Vec<Knot>)>) -> Self {
        sort::sort_by_key(&mut bent, |(piece, _)| (*piece).into());
        bent.dedup_by_key(|(piece, _)| *piece);
        let mut bends = Self::default();
        for (piece, knots) in bent {
            bends.pieces.push((piece, bends.knots.len()));
            bends.knots.extend(knots);
        }
        bends.pieces.push((u32::MAX, bends.knots.len()));
        bends
    }

    /// Those of the piece that a side belongs to, from the start of the piece.
    fn of_piece(&self, side: SideId) -> &[Knot] {
        match self.pieces.binary_search_by_key(&(side.piece() as u32), |(piece, _)| *piece) {
            Ok(i) => &self.knots[self.pieces[i].1..self.pieces[i + 1].1],
            Err(_) => &[],
        }
    }

    /// The knots of a side, from its start to its end: where each is. None where it is straight.
    pub fn knots(&self, side: SideId) -> impl Iterator<Item = f64> {
        let knots = self.of_piece(side);
        (0..knots.len()).map(move |i| match side.is_right() {
            true => 1.0 - knots[knots.len() - 1 - i].part,
            false => knots[i].part,
        })
    }

    /// How far the curve is off the chord at a place of a side, in du.
    pub fn off_du(&self, side: SideId, part: f64) -> Vec2 {
        let part = if side.is_right() { 1.0 - part } else { part };
        let knots = self.of_piece(side);
        let after = knots.partition_point(|knot| knot.part < part);
        let end = |part| Knot { part, off_du: Vec2::ZERO };
        let a = after.checked_sub(1).map_or(end(0.0), |i| knots[i]);
        let b = knots.get(after).copied().unwrap_or(end(1.0));
        a.off_du.lerp(b.off_du, (part - a.part) / (b.part - a.part))
    }
}

/// The piece of a step and its knots; `None` where it is straight.
fn bend(map: &PlanarMap, step: &Step, stretches: &[Stretch]) -> Option<(u32, Vec<Knot>)> {
    let points = map.triangulation().points();
    let [from_du, to_du] = step.arc_du;
    let nodes = map.ends(step.left).map(|node| points[node as usize]);
    let first = stretches.partition_point(|stretch| stretch.arc_du[1] <= from_du);
    let last = stretches.partition_point(|stretch| stretch.arc_du[0] < to_du);
    let ends = [place(stretches.get(first)?, from_du)?, place(stretches.get(last.checked_sub(1)?)?, to_du)?];
    if (0..2).any(|i| (nodes[i] - ends[i]).hypot() > MOST_OFF_DU) {
        return None;
    }
    let knots = stretches.get(first..last - 1)?.iter().map(|stretch| {
        let part = (stretch.arc_du[1] - from_du) / (to_du - from_du);
        let part = (part / STEP).round() * STEP;
        Knot { part, off_du: stretch.ends[1].to_point() - ends[0].lerp(ends[1], part) }
    });
    let is_within = |knot: &Knot| knot.part > END && knot.part < 1.0 - END;
    let mut knots: Vec<_> = knots.filter(is_within).collect();
    if step.left.is_right() {
        knots.reverse();
        knots.iter_mut().for_each(|knot| knot.part = 1.0 - knot.part);
    }
    (!knots.is_empty()).then_some((step.left.piece() as u32, knots))
}

/// Where on a stretch an arc position is; `None` where it is on none, as behind the border of what was sampled.
fn place(stretch: &Stretch, arc_du: f64) -> Option<Point> {
    let [from_du, to_du] = stretch.arc_du;
    let [a, b] = stretch.ends.map(LatticePoint::to_point);
    let part = (arc_du - from_du) / (to_du - from_du);
    (-0.5..1.5).contains(&part).then(|| a.lerp(b, part))
}
