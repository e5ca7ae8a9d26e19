//! The parts of a path between its crossings with outlines.

use kurbo::common::{solve_cubic, solve_quadratic};
use kurbo::{BezPath, CubicBez, Line, ParamCurve, PathEl, PathSeg, Point, Rect, Shape, Vec2};

use super::area::Area;
use super::work::{TooMuch, Work};
use crate::outline::is_closed;

/// How far at either side of an outline it is looked, in du: several times as far as chords are from their curves.
const BESIDE_DU: f64 = 0.05;

/// Comparisons that a crossing with a chord takes.
const CROSSING_WORK: u64 = 10;

/// Comparisons that a segment takes that crosses nothing.
const SEGMENT_WORK: u64 = 500;

/// The parts of a path between its crossings with the outlines of some areas within some bounds that are kept, as is
/// told by a point at each side; those that go on from each other as one.
pub(super) fn parts(
    path: &BezPath,
    bounds: Rect,
    areas: &[&Area],
    work: &mut Work,
    mut is_kept: impl FnMut([Point; 2]) -> bool,
) -> Result<Vec<BezPath>, TooMuch> {
    let mut parts = Parts::default();
    for segment in path.segments() {
        let cuts = cuts(&segment, bounds, areas, work)?;
        work.spend(SEGMENT_WORK + areas.len() as u64)?;
        let own = segment.bounding_box();
        let size: u64 = areas.iter().filter(|area| area.bounds.overlaps(own)).map(|area| area.size()).sum();
        work.spend(2 * size * cuts.len() as u64)?;
        let part = |from: f64, to: f64| segment.subsegment(from..to);
        let asked: Vec<_> =
            cuts.windows(2).map(|ends| (ends[0], ends[1], is_kept(sides(&part(ends[0], ends[1]))))).collect();
        // A curve that was cut for nothing stays what it is.
        for alike in asked.chunk_by(|a, b| a.2 == b.2) {
            parts.add(part(alike[0].0, alike[alike.len() - 1].1), alike[0].2);
        }
    }
    Ok(parts.finish(path))
}

/// Where a segment is parted within some bounds, and its ends: parameters in their order.
fn cuts(segment: &PathSeg, bounds: Rect, areas: &[&Area], work: &mut Work) -> Result<Vec<f64>, TooMuch> {
    let own = segment.bounding_box();
    if !own.overlaps(bounds) {
        return Ok(vec![0.0, 1.0]);
    }
    let bounds = own.intersect(bounds);
    let mut cuts = Vec::new();
    for area in areas.iter().filter(|area| area.bounds.overlaps(bounds)) {
        for band in &area.bands[area.bands_of(bounds)] {
            work.spend(1 + band.len() as u64)?;
            for chord in band.iter().filter(|chord| chord.bounding_box().overlaps(bounds)) {
                work.spend(CROSSING_WORK)?;
                // Longer than it is by next to nothing, so that no crossing falls between two chords.
                let line = Line::new(chord.eval(-1e-6), chord.eval(1.0 + 1e-6));
                cuts.extend(crossings(segment, line));
            }
        }
    }
    cuts.sort_by(f64::total_cmp);
    Ok(apart(segment, &cuts))
}

/// Where a segment crosses a line, as parameters.
fn crossings(segment: &PathSeg, line: Line) -> Vec<f64> {
    let along = line.p1 - line.p0;
    let PathSeg::Cubic(CubicBez { p0, p1, p2, p3 }) = *segment else {
        return segment
            .intersect_line(line)
            .iter()
            .map(|crossing| crossing.segment_t.clamp(0.0, 1.0))
            .collect();
    };
    let across = |v: Vec2| along.cross(v);
    let (first, second) = (p1 - p0, p2 - p1);
    let coefficients = [
        across(p0 - line.p0),
        across(3.0 * first),
        across(3.0 * (second - first)),
        across(p3 - p0 - 3.0 * second),
    ];
    let is_on_line = |&t: &f64| {
        let place = along.dot(segment.eval(t) - line.p0) / along.hypot2();
        (0.0..=1.0).contains(&t) && (0.0..=1.0).contains(&place)
    };
    roots(coefficients).into_iter().filter(is_on_line).collect()
}

/// The roots of a polynomial. A cubic part that is nothing but rounding, as that of a quadratic curve that was raised, would
/// lead to wrong ones.
fn roots([c0, c1, c2, c3]: [f64; 4]) -> Vec<f64> {
    if c3.abs() < 1e-8 * c1.abs().max(c2.abs()) {
        return solve_quadratic(c0, c1, c2).to_vec();
    }
    solve_cubic(c0, c1, c2, c3).to_vec()
}

/// Cuts that are as far apart that their sides can be told, and both ends.
fn apart(segment: &PathSeg, cuts: &[f64]) -> Vec<f64> {
    let mut kept = vec![0.0];
    for &cut in cuts {
        if is_apart(segment, kept[kept.len() - 1], cut) && is_apart(segment, cut, 1.0) {
            kept.push(cut);
        }
    }
    kept.push(1.0);
    kept
}

/// Whether a segment goes away from a place before it comes to another one, which may be there again.
fn is_apart(segment: &PathSeg, a: f64, b: f64) -> bool {
    let is_away = |part: f64| segment.eval(a).distance(segment.eval(a + (b - a) * part)) > 2.0 * BESIDE_DU;
    [0.25, 0.5, 0.75, 1.0].into_iter().any(is_away)
}

/// A point at each side of the middle of a segment.
fn sides(segment: &PathSeg) -> [Point; 2] {
    let along = segment.eval(0.55) - segment.eval(0.45);
    let across = if along.hypot() > 0.0 { along.turn_90() * (BESIDE_DU / along.hypot()) } else { along };
    let middle = segment.eval(0.5);
    [middle - across, middle + across]
}

/// Parts of a path, as they are found along it.
#[derive(Debug, Default)]
pub(crate) struct Parts {
    done: Vec<BezPath>,
    begins: bool,
    goes_on: bool,
    lacks_some: bool,
}

impl Parts {
    pub(crate) fn add(&mut self, part: PathSeg, is_kept: bool) {
        self.begins |= is_kept && self.done.is_empty() && !self.lacks_some;
        self.lacks_some |= !is_kept;
        if is_kept && !self.goes_on {
            self.done.push(BezPath::from_vec(vec![PathEl::MoveTo(part.start())]));
        }
        if let Some(last) = self.done.last_mut().filter(|_| is_kept) {
            last.push(part.as_path_el());
        }
        self.goes_on = is_kept;
    }

    /// What is left of a path; a closed one begins in the middle of a part.
    pub(crate) fn finish(self, path: &BezPath) -> Vec<BezPath> {
        let Self { mut done, begins, goes_on, lacks_some } = self;
        if !lacks_some {
            return vec![path.clone()];
        }
        if let Some(mut last) = if is_closed(path) && begins && goes_on { done.pop() } else { None } {
            last.extend(done[0].elements()[1..].iter().copied());
            done[0] = last;
        }
        done
    }
}
