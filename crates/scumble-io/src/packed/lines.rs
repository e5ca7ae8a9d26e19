//! Curves with their styles, and areas of solid ink, which mostly have the outlines of curves.

use kurbo::{BezPath, Cap, Join, PathEl, Stroke};
use scumble_core::{Curve, Drawing, Fill, Line, Rgba8};

use super::coder::Coder;
use super::pen::{self, Pen};
use super::{CURVES, DASHES, FILLS, MAX_SEEN, SEGMENTS, SUBPATHS, Seen, kind, list, positive, rgba, unit};

/// The curves and the solid ink of a drawing.
pub(super) fn lines(c: &mut Coder, drawing: &mut Drawing, seen: &mut Seen) {
    let mut pen = Pen::default();
    let blank = Curve { path: BezPath::new(), line: None };
    list(c, CURVES, &mut drawing.curves, &blank, |c, curve| {
        style(c, &mut curve.line, seen);
        curve.path = BezPath::from_vec(pen.subpath(c, curve.path.elements()));
    });
    let curves = &drawing.curves;
    let mut next = 0;
    let blank = Fill { path: BezPath::new(), even_odd: false, color: Rgba8([0; 4]) };
    list(c, FILLS, &mut drawing.fills, &blank, |c, fill| {
        fill.even_odd = c.flag(kind::FILL, &[0], fill.even_odd);
        rgba(c, &mut fill.color, kind::FILL);
        fill.path = area(c, &fill.path, curves, &mut next, &mut pen);
    });
}

/// An area, of which each subpath may be that of a curve.
fn area(c: &mut Coder, given: &BezPath, curves: &[Curve], next: &mut usize, pen: &mut Pen) -> BezPath {
    let given: Vec<_> = pen::subpaths(given.elements()).collect();
    let count = c.count(kind::LENGTH, SUBPATHS, given.len());
    let mut path = Vec::new();
    for i in 0..count {
        let subpath = given.get(i).copied().unwrap_or_default();
        path.append(&mut area_part(c, subpath, curves, next, pen));
    }
    BezPath::from_vec(path)
}

/// Curves among which that of an area's subpath is looked for.
const NEIGHBOURS: usize = 256;

fn area_part(
    c: &mut Coder,
    given: &[PathEl],
    curves: &[Curve],
    next: &mut usize,
    pen: &mut Pen,
) -> Vec<PathEl> {
    let ahead = curves.iter().skip(*next).take(NEIGHBOURS);
    let found =
        ahead.map(|curve| pen::opened(curve.path.elements())).position(|path| path == pen::opened(given));
    let steps = c.int(kind::FILL, &[1], found.map_or(0, |steps| steps as i64 + 1));
    let last = usize::try_from(steps - 1).ok().and_then(|steps| next.checked_add(steps));
    let Some((last, curve)) = last.and_then(|last| Some((last, curves.get(last)?))) else {
        return pen.subpath(c, given);
    };
    *next = last + 1;
    let path = pen::opened(curve.path.elements());
    if !c.take(SEGMENTS, path.len()) {
        return Vec::new();
    }
    let is_closed = c.flag(kind::FILL, &[2], pen::is_closed(given));
    path.iter().copied().chain(is_closed.then_some(PathEl::ClosePath)).collect()
}

fn style(c: &mut Coder, line: &mut Option<Line>, seen: &mut Seen) {
    let known = seen.lines.iter().position(|[given, _]| given == line).map_or(0, |i| i as i64 + 1);
    let number = c.int(kind::SEEN, &[0, seen.last_line], known);
    seen.last_line = number;
    if let Some([_, known]) = usize::try_from(number - 1).ok().and_then(|number| seen.lines.get(number)) {
        line.clone_from(known);
        return;
    }
    let given = line.clone();
    if c.flag(kind::STYLE, &[0], line.is_some()) {
        let line = line.get_or_insert_with(|| Line { stroke: Stroke::new(1.0), color: Rgba8([0; 4]) });
        stroke(c, &mut line.stroke);
        rgba(c, &mut line.color, kind::STYLE);
    }
    if seen.lines.len() < MAX_SEEN {
        seen.last_line = seen.lines.len() as i64 + 1;
        seen.lines.push([given, line.clone()]);
    }
}

fn stroke(c: &mut Coder, stroke: &mut Stroke) {
    positive(c, kind::STYLE, &[1], &mut stroke.width);
    stroke.join = one_of(c, 2, [Join::Miter, Join::Round, Join::Bevel], stroke.join);
    stroke.start_cap = one_of(c, 3, CAPS, stroke.start_cap);
    stroke.end_cap = one_of(c, 4, CAPS, stroke.end_cap);
    unit(c, kind::STYLE, &[5], &mut stroke.miter_limit);
    let mut dashes = stroke.dash_pattern.to_vec();
    list(c, DASHES, &mut dashes, &0.0, |c, dash| unit(c, kind::STYLE, &[6], dash));
    stroke.dash_pattern = dashes.into();
    unit(c, kind::STYLE, &[7], &mut stroke.dash_offset);
}

const CAPS: [Cap; 3] = [Cap::Butt, Cap::Round, Cap::Square];

fn one_of<T: Copy + PartialEq>(c: &mut Coder, context: i64, all: [T; 3], value: T) -> T {
    let number = all.iter().position(|one| *one == value).unwrap_or_default();
    let read = usize::try_from(c.int(kind::STYLE, &[context], number as i64));
    read.ok().and_then(|number| all.get(number).copied()).unwrap_or_else(|| {
        c.fail();
        value
    })
}
