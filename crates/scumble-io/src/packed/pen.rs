//! Points on a lattice of 1/4 du, each told from the way so far.
//!
//! Steps are mirrored so that the step before goes right and down; then hands and shapes repeat themselves. In a cubic
//! the first handle is expected to go on from the handle or line before it, and the last one to mirror the first, as in
//! an arc.

use kurbo::{PathEl, Point};

use super::coder::Coder;
use super::{POINTS, SEGMENTS, kind};

/// Steps of the lattice in one du.
const PER_DU: f64 = 4.0;

/// Largest coordinate, in steps: a million pages away.
const FARTHEST: i64 = 4_000_000_000;

/// Coordinates that handles are foretold for, in steps; their products fit a number.
const NEAR: i64 = 1 << 18;

const START: usize = 0;
const STROKE: usize = 1;
const SEGMENT: usize = 2;
const LINE: usize = 3;
const FIRST_HANDLE: usize = 4;
const END: usize = 5;
const LAST_HANDLE: usize = 6;

/// A place or a way on the lattice.
type Steps = [i64; 2];

/// Where the last path ended, and how wide the last stroke was.
#[derive(Debug, Default)]
pub(super) struct Pen {
    at: Steps,
    pub(super) width_du: f64,
}

/// The way before a segment.
#[derive(Clone, Copy)]
struct Before {
    /// 0 at the start of a path, 1 for a line, 2 for a curve.
    kind: i64,
    /// The line, or the last handle.
    way: Steps,
    start: Steps,
    is_last: bool,
}

impl Pen {
    /// The points of a stroke; at least one.
    pub(super) fn stroke(&mut self, c: &mut Coder, points: &mut Vec<Point>) {
        let count = c.count(kind::SCRIBBLE, POINTS, points.len());
        points.resize(count, Point::ZERO);
        if count == 0 {
            c.fail();
        }
        let (mut way, mut turn) = ([0; 2], [0; 2]);
        for (i, point) in points.iter_mut().enumerate() {
            let given = minus(steps(*point), self.at);
            let step = if i == 0 { start(c, given) } else { stroke_step(c, given, way, turn) };
            if i > 0 {
                (turn, way) = (minus(step, way), step);
            }
            self.go(c, step);
            *point = to_point(self.at);
        }
    }

    /// A subpath: a start, segments, and maybe an end that closes it.
    pub(super) fn subpath(&mut self, c: &mut Coder, given: &[PathEl]) -> Vec<PathEl> {
        let is_closed = c.flag(SEGMENT, &[-1], is_closed(given));
        let segments = opened(given).get(1..).unwrap_or_default();
        let count = c.count(SEGMENT, SEGMENTS, segments.len());
        c.take(SEGMENTS, 2);
        let first = given.first().and_then(PathEl::end_point).unwrap_or_default();
        let step = start(c, minus(steps(first), self.at));
        self.go(c, step);
        let mut path = Vec::with_capacity(count + 2);
        path.push(PathEl::MoveTo(to_point(self.at)));
        let mut before = Before { kind: 0, way: [0; 2], start: self.at, is_last: false };
        for i in 0..count {
            before.is_last = is_closed && i + 1 == count;
            let given = segments.get(i).copied().unwrap_or(PathEl::ClosePath);
            path.push(self.segment(c, given, &mut before));
        }
        path.extend(is_closed.then_some(PathEl::ClosePath));
        path
    }

    fn segment(&mut self, c: &mut Coder, given: PathEl, before: &mut Before) -> PathEl {
        let from = self.at;
        let given = cubic(from, given);
        let is_curve = c.flag(SEGMENT, &[before.kind], given.is_curve);
        let to_start = minus(before.start, from);
        if !is_curve {
            let way = line(c, given.end, before, to_start);
            self.go(c, way);
            (before.kind, before.way) = (1, way);
            return PathEl::LineTo(to_point(self.at));
        }
        let first = first_handle(c, given.first, before);
        let end = end(c, given.end, first, to_start, before.is_last);
        let expected = mirrored(first, end);
        let last = plus(expected, last_handle(c, minus(given.last, expected), expected, first, end));
        self.go(c, end);
        (before.kind, before.way) = (2, last);
        let [first, last] = [plus(from, first), minus(self.at, last)].map(|at| to_point(kept_near(c, at)));
        PathEl::CurveTo(first, last, to_point(self.at))
    }

    fn go(&mut self, c: &mut Coder, step: Steps) {
        self.at = kept_near(c, plus(self.at, step));
    }
}

/// A segment as ways: the first handle from its start, its end from its start, and its end from the last handle.
struct Cubic {
    is_curve: bool,
    first: Steps,
    end: Steps,
    last: Steps,
}

fn cubic(from: Steps, segment: PathEl) -> Cubic {
    let [first, last, end] = match segment {
        PathEl::CurveTo(first, last, end) => [first, last, end].map(steps),
        PathEl::QuadTo(control, end) => {
            let raised = |end: Point| steps(end.lerp(control, 2.0 / 3.0));
            [raised(to_point(from)), raised(end), steps(end)]
        }
        PathEl::MoveTo(end) | PathEl::LineTo(end) => [from, from, steps(end)],
        PathEl::ClosePath => [from; 3],
    };
    let is_curve = matches!(segment, PathEl::CurveTo(..) | PathEl::QuadTo(..));
    Cubic { is_curve, first: minus(first, from), end: minus(end, from), last: minus(end, last) }
}

fn start(c: &mut Coder, step: Steps) -> Steps {
    let x = c.int(START, &[0], step[0]);
    [x, c.int(START, &[1], step[1])]
}

fn stroke_step(c: &mut Coder, given: Steps, way: Steps, turn: Steps) -> Steps {
    let turned = size(turn[0].abs().max(turn[1].abs()));
    let mut step = [0; 2];
    for axis in 0..2 {
        let sign = sign(way[axis]);
        let speed = way[axis].abs().min(63);
        let bend = (turn[axis] * sign).clamp(-16, 16);
        let other = if axis == 0 { -1 } else { size(step[0] - way[0]) };
        let contexts = [pair(turned, speed), pair(bend, speed), 0, pair(other, speed), speed];
        step[axis] = sign * c.int(STROKE, &contexts, sign * given[axis]);
    }
    step
}

fn line(c: &mut Coder, given: Steps, before: &Before, to_start: Steps) -> Steps {
    let mut way = [0; 2];
    for axis in 0..2 {
        let sign = sign(before.way[axis]);
        let other = if axis == 0 { -1 } else { size(way[0]) };
        let home = pair(before.kind + 4 * i64::from(before.is_last), size(to_start[axis]));
        let last = before.way[axis].abs().min(255);
        let contexts = [
            other,
            pair(size(last), other),
            last,
            home,
            pair(sign * to_start[axis], i64::from(before.is_last)),
        ];
        way[axis] = sign * c.int(LINE, &contexts, sign * given[axis]);
    }
    way
}

/// The first handle, expected to go the way before it.
fn first_handle(c: &mut Coder, given: Steps, before: &Before) -> Steps {
    let way = before.way;
    let axis = usize::from(way[0].abs() < way[1].abs());
    let sign = sign(way[axis]);
    let length = way[axis].abs();
    let sizes = pair(size(way[axis]), size(way[1 - axis]));
    let contexts = [pair(before.kind, size(length)), length.min(255), before.kind, sizes];
    let along = c.int(FIRST_HANDLE, &contexts, sign * given[axis] - length);
    let mut handle = [0; 2];
    handle[axis] = sign * (along + length);
    let expected = rounded_part(handle[axis], way[1 - axis], way[axis]);
    let kind = before.kind + 8;
    let contexts =
        [kind, pair(size(along), kind), pair(size(handle[axis]), kind), pair(along.signum(), kind)];
    handle[1 - axis] = expected + c.int(FIRST_HANDLE, &contexts, given[1 - axis] - expected);
    handle
}

fn end(c: &mut Coder, given: Steps, first: Steps, to_start: Steps, is_last: bool) -> Steps {
    let main = usize::from(first[0].abs() < first[1].abs());
    let mut end = [0; 2];
    for axis in [main, 1 - main] {
        let sign = sign(first[axis]);
        let (other, is_home) = if axis == main {
            (-1, 2)
        } else {
            (pair(size(end[main]), size(first[main])), i64::from(end[main] == to_start[main]))
        };
        let home = pair(pair(i64::from(is_last), size(to_start[axis])), is_home);
        let contexts = [
            pair(size(first[axis]), other),
            first[axis].abs().min(255),
            home,
            other,
            pair(to_start[axis] * sign, is_home),
        ];
        end[axis] = sign * c.int(END, &contexts, sign * given[axis]);
    }
    end
}

/// How far the last handle is from where it was expected.
fn last_handle(c: &mut Coder, given: Steps, expected: Steps, first: Steps, end: Steps) -> Steps {
    let [first, end] = [first, end].map(|way| size(way[0].abs().max(way[1].abs())));
    let mut off = [0; 2];
    for axis in 0..2 {
        let other = if axis == 0 { -1 } else { size(off[0]) };
        let own = size(expected[axis]);
        let contexts = [pair(first, other), other, pair(own, other), end, pair(own, end)];
        off[axis] = c.int(LAST_HANDLE, &contexts, given[axis]);
    }
    off
}

/// A way mirrored at the perpendicular bisector of a chord, turned around: where an arc ends that begins this way.
fn mirrored(way: Steps, chord: Steps) -> Steps {
    if [way, chord].iter().flatten().any(|x| x.abs() >= NEAR) {
        return way;
    }
    let square = chord[0] * chord[0] + chord[1] * chord[1];
    let along = 2 * (way[0] * chord[0] + way[1] * chord[1]);
    [0, 1].map(|axis| rounded_part(along, chord[axis], square) - way[axis])
}

/// `whole · part / of`, rounded; 0 where there is no telling.
fn rounded_part(whole: i64, part: i64, of: i64) -> i64 {
    let product = whole.checked_mul(part).filter(|product| product.abs() < 1 << 60);
    let (Some(product), true) = (product, of != 0) else { return 0 };
    let rounded = (2 * product * of.signum() + of.abs()).div_euclid(2 * of.abs());
    if rounded.abs() <= FARTHEST { rounded } else { 0 }
}

/// Each subpath of a path.
pub(super) fn subpaths(path: &[PathEl]) -> impl Iterator<Item = &[PathEl]> {
    path.chunk_by(|_, next| !matches!(next, PathEl::MoveTo(_)))
}

/// A subpath without the end that closes it.
pub(super) fn opened(subpath: &[PathEl]) -> &[PathEl] {
    subpath.strip_suffix(&[PathEl::ClosePath]).unwrap_or(subpath)
}

pub(super) fn is_closed(subpath: &[PathEl]) -> bool {
    opened(subpath).len() < subpath.len()
}

fn steps(p: Point) -> Steps {
    [p.x, p.y].map(|x| ((x * PER_DU).round() as i64).clamp(-FARTHEST, FARTHEST))
}

fn to_point(at: Steps) -> Point {
    Point::new(at[0] as f64 / PER_DU, at[1] as f64 / PER_DU)
}

/// The place itself; what lies too far away is no drawing.
fn kept_near(c: &mut Coder, at: Steps) -> Steps {
    if at.iter().all(|x| x.abs() <= FARTHEST) {
        return at;
    }
    c.fail();
    [0; 2]
}

fn plus(a: Steps, b: Steps) -> Steps {
    [a[0] + b[0], a[1] + b[1]]
}

fn minus(a: Steps, b: Steps) -> Steps {
    [a[0] - b[0], a[1] - b[1]]
}

/// Length in bits.
fn size(x: i64) -> i64 {
    i64::from(64 - x.unsigned_abs().leading_zeros())
}

fn sign(x: i64) -> i64 {
    if x < 0 { -1 } else { 1 }
}

/// Two contexts as one.
fn pair(a: i64, b: i64) -> i64 {
    a << 10 ^ b
}
