//! Outlines that got a thin line because they have none of their own: where a line runs along them, they are there already.
//! Two curves that are nearly the same would part slivers between them.

use kurbo::{BezPath, ParamCurve, ParamCurveNearest, PathSeg, Point, Rect, Shape};
use scumble_core::{Curve, Drawing};

use crate::clip::{Parts, TooMuch, Work};
use crate::look;

/// What is no further from a line runs along it, in du.
const ALONG_DU: f64 = 0.25;

/// Comparisons that it takes to find how far a point is from a segment.
const NEAREST_WORK: u64 = 50;

/// Where a segment is asked how far it is from others.
const PLACES: [f64; 3] = [0.2, 0.5, 0.8];

/// A drawing without the parts of thin outlines that its lines run along.
///
/// # Errors
/// When it takes too long to find these.
pub(crate) fn without_doubles(drawing: &Drawing) -> Result<Drawing, TooMuch> {
    let (mut work, thin) = (Work::new(), look::thin());
    let has_own = |curve: &&Curve| curve.line.as_ref().is_some_and(|line| *line != thin);
    let segments = drawing.curves.iter().filter(has_own).flat_map(|curve| curve.path.segments());
    let lines: Vec<_> =
        segments.map(|line| (line.bounding_box().inflate(ALONG_DU, ALONG_DU), line)).collect();
    let mut rest = Drawing { curves: Vec::new(), ..drawing.clone() };
    for curve in &drawing.curves {
        let is_thin = curve.line.as_ref() == Some(&thin);
        let paths = if is_thin { single(&curve.path, &lines, &mut work)? } else { vec![curve.path.clone()] };
        rest.curves.extend(paths.into_iter().map(|path| Curve { path, line: curve.line.clone() }));
    }
    Ok(rest)
}

/// The parts of a path that no line runs along.
fn single(path: &BezPath, lines: &[(Rect, PathSeg)], work: &mut Work) -> Result<Vec<BezPath>, TooMuch> {
    let mut parts = Parts::default();
    for segment in path.segments() {
        parts.add(segment, !is_double(&segment, lines, work)?);
    }
    Ok(parts.finish(path))
}

fn is_double(segment: &PathSeg, lines: &[(Rect, PathSeg)], work: &mut Work) -> Result<bool, TooMuch> {
    for point in PLACES.map(|t| segment.eval(t)) {
        if !is_on_line(point, lines, work)? {
            return Ok(false);
        }
    }
    Ok(true)
}

fn is_on_line(point: Point, lines: &[(Rect, PathSeg)], work: &mut Work) -> Result<bool, TooMuch> {
    work.spend(lines.len() as u64 / 2)?;
    for (_, line) in lines.iter().filter(|(bounds, _)| bounds.contains(point)) {
        work.spend(NEAREST_WORK)?;
        if line.nearest(point, ALONG_DU / 10.0).distance_sq <= ALONG_DU * ALONG_DU {
            return Ok(true);
        }
    }
    Ok(false)
}
