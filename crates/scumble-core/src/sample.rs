//! Curves as polylines on a lattice: the first step to a planar map.
//!
//! Nodes lie at most a given distance apart along the arc, and closer towards tips and corners; pieces lie at most a given
//! distance off their curve, and corners are kept. What lies outside the frame is cut off. Every node is put on a
//! lattice of 1/1024 du, so that all later decisions about crossings are exact in integers.

mod ends;
mod frame;

use kurbo::{BezPath, CubicBez, Line, ParamCurve, ParamCurveArclen, ParamCurveNearest, PathSeg, Point, Rect};

pub(crate) use frame::{add_feet, frame_path, frame_rect, lattice_frame};

use crate::clamp::nearest_in;
use crate::grading::graded;
use crate::measured_path;
use crate::planar_map::Sampling;

/// Lattice units in one du.
pub(crate) const LATTICE_PER_DU: f64 = 1024.0;

/// A point of the lattice: du × [`LATTICE_PER_DU`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) struct LatticePoint {
    pub(crate) x: i32,
    pub(crate) y: i32,
}

impl LatticePoint {
    /// The lattice point nearest to a point that lies within the frame.
    pub(crate) fn nearest(p: Point) -> Self {
        Self { x: (p.x * LATTICE_PER_DU).round() as i32, y: (p.y * LATTICE_PER_DU).round() as i32 }
    }

    pub(crate) fn to_point(self) -> Point {
        Point::new(f64::from(self.x) / LATTICE_PER_DU, f64::from(self.y) / LATTICE_PER_DU)
    }
}

/// A straight piece of a sampled curve within the frame; its ends differ.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Stretch {
    pub(crate) ends: [LatticePoint; 2],
    /// Arc positions of the ends along the whole curve, in du.
    pub(crate) arc_du: [f64; 2],
}

/// Samples one curve within a part of the frame, or gives up (`None`) above `limit` stretches.
pub(crate) fn sample(path: &BezPath, rect: Rect, sampling: &Sampling, limit: usize) -> Option<Vec<Stretch>> {
    if !within_reach(path) {
        return Some(Vec::new());
    }
    let mut sampler = Sampler { rect, sampling, limit, stretches: Vec::new(), arc_du: 0.0 };
    for (segment, ends_du) in ends::segments(path, sampling) {
        sampler.segment(segment.to_cubic(), matches!(segment, PathSeg::Line(_)), ends_du, 0)?;
    }
    Some(sampler.stretches)
}

struct Sampler<'a> {
    rect: Rect,
    sampling: &'a Sampling,
    limit: usize,
    stretches: Vec<Stretch>,
    arc_du: f64,
}

/// Curves with coordinates beyond this, or not finite, are not sampled: a million pages away.
const MAX_COORDINATE_DU: f64 = 1e9;

fn within_reach(path: &BezPath) -> bool {
    let control_points = path.segments().flat_map(|segment| {
        let c = segment.to_cubic();
        [c.p0, c.p1, c.p2, c.p3]
    });
    control_points.into_iter().all(|p| p.x.abs() <= MAX_COORDINATE_DU && p.y.abs() <= MAX_COORDINATE_DU)
}

/// Halvings after which a segment is taken as it is: [`MAX_COORDINATE_DU`] is a page by then.
const MAX_HALVINGS: usize = 24;

impl Sampler<'_> {
    /// Halves a segment until its parts lie inside the frame or outside, and samples those inside.
    fn segment(&mut self, c: CubicBez, straight: bool, ends_du: [f64; 2], halvings: usize) -> Option<()> {
        let hull = Rect::from_points(c.p0, c.p1).union(Rect::from_points(c.p2, c.p3));
        let frame_size = self.rect.size().max_side();
        if hull.x1 < self.rect.x0
            || hull.y1 < self.rect.y0
            || hull.x0 > self.rect.x1
            || hull.y0 > self.rect.y1
        {
            self.arc_du += if straight { (c.p3 - c.p0).hypot() } else { measured_path::length_du(&c) };
            return Some(());
        }
        if hull.size().max_side() > 2.0 * frame_size && halvings < MAX_HALVINGS {
            let (first, second) = c.subdivide();
            let middle_du = self.sampling.spacing_du;
            self.segment(first, straight, [ends_du[0], middle_du], halvings + 1)?;
            return self.segment(second, straight, [middle_du, ends_du[1]], halvings + 1);
        }
        self.inside(c, straight, ends_du)
    }

    /// Nodes at equal distances along the arc, closer towards its ends and where the chord would leave the curve.
    fn inside(&mut self, c: CubicBez, straight: bool, ends_du: [f64; 2]) -> Option<()> {
        let line = Line::new(c.p0, c.p3);
        let length_du = if straight { line.arclen(1e-3) } else { measured_path::length_du(&c) };
        let arcs = graded(length_du, ends_du, self.sampling.spacing_du);
        if self.stretches.len() + arcs.len() > self.limit {
            return None;
        }
        if straight {
            for pair in arcs.windows(2) {
                self.push([pair[0], pair[1]].map(|t| line.eval(t)));
            }
            return Some(());
        }
        let (first, start_du) = (self.stretches.len(), self.arc_du);
        for t in parameters(&c, &arcs).windows(2) {
            self.flat_enough(&c, [t[0], t[1]], 0);
        }
        self.stretch_arc(first, start_du, length_du);
        Some(())
    }

    /// Chords are shorter than their curve: makes the arc positions from a stretch and a position on as long as it is.
    fn stretch_arc(&mut self, first: usize, start_du: f64, length_du: f64) {
        let scale = length_du / (self.arc_du - start_du);
        if !scale.is_finite() {
            return;
        }
        for arc_du in self.stretches[first..].iter_mut().flat_map(|stretch| &mut stretch.arc_du) {
            // What begins in the segment before begins where that ends.
            *arc_du += (scale - 1.0) * (*arc_du - start_du).max(0.0);
        }
        self.arc_du = start_du + length_du;
    }

    fn flat_enough(&mut self, c: &CubicBez, t: [f64; 2], halvings: usize) {
        let ends = t.map(|t| c.eval(t));
        let at = |part: f64| t[0] + part * (t[1] - t[0]);
        let middle = at(0.5);
        // An S goes through the middle of its chord.
        let off_du = [0.25, 0.5, 0.75].map(|part| distance_to_chord(c.eval(at(part)), ends));
        let off_du = off_du.into_iter().fold(0.0, f64::max);
        if off_du > self.sampling.chord_du && halvings < 8 {
            self.flat_enough(c, [t[0], middle], halvings + 1);
            self.flat_enough(c, [middle, t[1]], halvings + 1);
        } else {
            self.push(ends);
        }
    }

    fn push(&mut self, ends: [Point; 2]) {
        let (start_du, length_du) = (self.arc_du, (ends[1] - ends[0]).hypot());
        self.arc_du += length_du;
        let Some(inside) = clip(ends, self.rect) else { return };
        let [a, b] = inside.map(|t| LatticePoint::nearest(nearest_in(self.rect, ends[0].lerp(ends[1], t))));
        if a != b {
            // Segments within one lattice point are passed over, and tear no hole into the arc.
            let before = self.stretches.last().filter(|before| inside[0] == 0.0 && before.ends[1] == a);
            let from_du = before.map_or(start_du + inside[0] * length_du, |before| before.arc_du[1]);
            let to_du = if inside[1] == 1.0 { self.arc_du } else { start_du + inside[1] * length_du };
            self.stretches.push(Stretch { ends: [a, b], arc_du: [from_du, to_du] });
        }
    }
}

/// Distance to the chord as a segment: a curve that turns back on itself goes beyond its ends.
fn distance_to_chord(p: Point, [a, b]: [Point; 2]) -> f64 {
    Line::new(a, b).nearest(p, 1e-6).distance_sq.sqrt()
}

/// The parameters at parts of the arc, in ascending order from 0 to 1, by inverting a table of chords.
fn parameters(c: &CubicBez, parts: &[f64]) -> Vec<f64> {
    let table_len = (2 * parts.len()).clamp(8, 1024);
    let parameter = |i: usize| i as f64 / table_len as f64;
    let mut arc = vec![0.0];
    let mut last = c.p0;
    for i in 1..=table_len {
        let p = c.eval(parameter(i));
        arc.push(arc[i - 1] + (p - last).hypot());
        last = p;
    }
    let mut at = 0;
    let mut nodes: Vec<f64> = parts[..parts.len() - 1]
        .iter()
        .map(|part| {
            let target = arc[table_len] * part;
            while arc[at + 1] < target {
                at += 1;
            }
            let step = arc[at + 1] - arc[at];
            let part = if step > 0.0 { (target - arc[at]) / step } else { 0.0 };
            (at as f64 + part) / table_len as f64
        })
        .collect();
    nodes.push(1.0);
    nodes
}

/// The part of a segment inside a rectangle, as parameters in `0..=1` (Y.-D. Liang, B. Barsky, *A new concept and method for line
/// clipping*, 1984).
pub fn clip([a, b]: [Point; 2], rect: Rect) -> Option<[f64; 2]> {
    let d = b - a;
    let (mut t0, mut t1) = (0.0_f64, 1.0_f64);
    for (from, step, lo, hi) in [(a.x, d.x, rect.x0, rect.x1), (a.y, d.y, rect.y0, rect.y1)] {
        if step == 0.0 {
            if from < lo || from > hi {
                return None;
            }
            continue;
        }
        let (u, v) = ((lo - from) / step, (hi - from) / step);
        t0 = t0.max(u.min(v));
        t1 = t1.min(u.max(v));
    }
    (t0 <= t1).then_some([t0, t1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::{Circle, Shape};

    const FRAME: LatticePoint = LatticePoint { x: 1024 * 1024, y: 1024 * 1024 };

    fn sampled(path: &BezPath) -> Vec<Stretch> {
        sample(path, frame_rect(FRAME), &Sampling::default(), 1_000_000).expect("below the limit")
    }

    #[test]
    fn nodes_of_a_circle_are_close_and_on_it() {
        let path = Circle::new((500.0, 500.0), 300.0).to_path(1e-6);
        let stretches = sampled(&path);
        assert!((465..500).contains(&stretches.len()), "{}", stretches.len());
        for s in &stretches {
            let [a, b] = s.ends.map(LatticePoint::to_point);
            assert!((b - a).hypot() <= 4.02);
            assert!(((a - Point::new(500.0, 500.0)).hypot() - 300.0).abs() < 0.02);
        }
        let total = stretches.last().map(|s| s.arc_du[1]).unwrap_or_default();
        assert!((total - 600.0 * std::f64::consts::PI).abs() < 1e-3);
    }

    #[test]
    fn tight_bends_are_sampled_by_their_chord() {
        let stretches = sampled(&Circle::new((5.0, 5.0), 1.0).to_path(1e-6));
        assert!(stretches.len() >= 8, "{}", stretches.len());
    }

    #[test]
    fn a_small_s_is_no_straight_line() {
        let mut path = BezPath::new();
        path.move_to((100.0, 100.0));
        path.curve_to((100.0, 102.0), (101.0, 98.0), (101.0, 100.0));
        assert!(sampled(&path).len() > 2);
    }

    #[test]
    fn a_segment_within_one_lattice_point_tears_no_hole_into_the_arc() {
        let path = BezPath::from_svg("M 300 300 H 700 V 700 H 300.0002 L 300 700 Z").expect("a path");
        assert!(sampled(&path).windows(2).all(|pair| pair[0].arc_du[1] == pair[1].arc_du[0]));
    }

    #[test]
    fn a_straight_curve_that_turns_back_reaches_its_tip() {
        let mut path = BezPath::new();
        path.move_to((100.0, 100.0));
        path.curve_to((100.0, 200.0), (100.0, 200.0), (100.0, 101.0));
        let lowest = sampled(&path).iter().flat_map(|s| s.ends).map(|p| p.y).max();
        assert!((f64::from(lowest.unwrap_or_default()) / LATTICE_PER_DU - 175.125).abs() < 0.12);
    }

    #[test]
    fn what_leaves_the_frame_is_cut_on_its_border() {
        let line = BezPath::from_vec(vec![
            kurbo::PathEl::MoveTo(Point::new(-1e6, 512.0)),
            kurbo::PathEl::LineTo(Point::new(1e6, 512.0)),
        ]);
        let stretches = sampled(&line);
        assert_eq!(stretches.first().map(|s| s.ends[0]), Some(LatticePoint { x: 0, y: 512 * 1024 }));
        assert_eq!(stretches.last().map(|s| s.ends[1]), Some(LatticePoint { x: 1024 * 1024, y: 512 * 1024 }));
        assert!(stretches.windows(2).all(|w| w[0].ends[1] == w[1].ends[0]));
    }

    #[test]
    fn a_bend_off_the_page_counts_in_full() {
        let path = BezPath::from_svg("M 500 10 V -50 C 500 -300 800 -300 800 -50 V 500").expect("a path");
        let length_du = measured_path::MeasuredPath::new(&path).length_du();
        let end_du = sampled(&path).last().map(|s| s.arc_du[1]).unwrap_or_default();
        assert!((end_du - length_du).abs() < 1e-3, "{end_du} of {length_du}");
    }

    #[test]
    fn endless_curves_end() {
        for far in [1e6, 1e9, 1e12, 1e300] {
            let mut path = BezPath::new();
            path.move_to((-far, -far));
            path.curve_to((far, 3.0), (-far, 7.0), (far, far));
            let _ = sample(&path, frame_rect(FRAME), &Sampling::default(), 10_000);
        }
    }
}
