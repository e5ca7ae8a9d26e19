//! Paths of `usvg` as Bézier paths in drawing units, one for each subpath.

use kurbo::{Affine, BezPath, CubicBez, PathEl, Point, Rect, Shape};
use usvg::tiny_skia_path::{self, PathSegment};

/// Coordinates beyond this, in du, are a million pages away and no drawing.
const MAX_COORDINATE_DU: f64 = 1e9;

/// Areas thinner than this, in du, do not show.
const FLAT_DU: f64 = 1e-3;

/// The subpaths of a path, quadratics raised to cubics. Each has at least one segment.
pub(crate) fn subpaths(path: &tiny_skia_path::Path, du_from_path: Affine) -> Vec<BezPath> {
    let mut outlines = Outlines::default();
    for segment in path.segments() {
        outlines.push(segment, du_from_path);
    }
    outlines.finish()
}

#[derive(Default)]
struct Outlines {
    done: Vec<BezPath>,
    open: BezPath,
    /// The last point and the subpath's first.
    at: Point,
    start: Point,
}

impl Outlines {
    fn push(&mut self, segment: PathSegment, du_from_path: Affine) {
        let du = |p: tiny_skia_path::Point| du_from_path * Point::new(f64::from(p.x), f64::from(p.y));
        match segment {
            PathSegment::MoveTo(p) => {
                self.end_subpath();
                self.at = du(p);
                self.start = self.at;
            }
            PathSegment::LineTo(p) => self.append(PathEl::LineTo(du(p)), du(p)),
            PathSegment::QuadTo(a, b) => self.quadratic(du(a), du(b)),
            PathSegment::CubicTo(a, b, c) => self.append(PathEl::CurveTo(du(a), du(b), du(c)), du(c)),
            PathSegment::Close => {
                let start = self.start;
                self.append(PathEl::ClosePath, start);
                self.end_subpath();
            }
        }
    }

    fn append(&mut self, element: PathEl, to: Point) {
        if self.open.is_empty() {
            self.open.move_to(self.at);
        }
        self.open.push(element);
        self.at = to;
    }

    fn quadratic(&mut self, control: Point, to: Point) {
        let raised = [self.at.lerp(control, 2.0 / 3.0), to.lerp(control, 2.0 / 3.0)];
        self.append(PathEl::CurveTo(raised[0], raised[1], to), to);
    }

    fn end_subpath(&mut self) {
        // What was moved to and closed without a segment is left behind.
        let ended = std::mem::take(&mut self.open);
        self.done.extend((!ended.is_empty()).then_some(ended));
    }

    fn finish(mut self) -> Vec<BezPath> {
        self.end_subpath();
        self.done
    }
}

/// Whether all coordinates are numbers within reach of the page.
pub(crate) fn is_within_reach(path: &BezPath) -> bool {
    path.segments().all(|segment| {
        let c = segment.to_cubic();
        [c.p0, c.p1, c.p2, c.p3]
            .iter()
            .all(|p| p.x.abs() <= MAX_COORDINATE_DU && p.y.abs() <= MAX_COORDINATE_DU)
    })
}

/// Whether a subpath, filled, shows: whether it is more than a straight line.
pub(crate) fn has_area(path: &BezPath) -> bool {
    let points: Vec<_> =
        path.segments().map(|segment| segment.to_cubic()).flat_map(|c| [c.p0, c.p1, c.p2, c.p3]).collect();
    let Some(&start) = points.first() else { return false };
    let along = points.iter().map(|p| *p - start).find(|d| d.hypot() > FLAT_DU).unwrap_or_default();
    points.iter().any(|p| along.cross(*p - start).abs() > FLAT_DU * along.hypot())
}

/// How wide an area is in the mean, and how long, in du, if it is taken for a line: that is half as long as the outlines, as far
/// as their control points tell, and covers as much.
///
/// What lies within the largest outline of an area that is filled by turns is a hole in it.
pub(crate) fn mean_size_du(subpaths: &[BezPath], even_odd: bool) -> [f64; 2] {
    let areas: Vec<f64> = subpaths.iter().map(|path| closed(path.clone()).area()).collect();
    let covered: f64 = if even_odd {
        let largest = areas.iter().fold(0.0, |largest: f64, area| largest.max(area.abs()));
        2.0 * largest - areas.iter().map(|area| area.abs()).sum::<f64>()
    } else {
        areas.iter().sum::<f64>().abs()
    };
    let length_du = |c: CubicBez| (c.p1 - c.p0).hypot() + (c.p2 - c.p1).hypot() + (c.p3 - c.p2).hypot();
    let segments = subpaths.iter().flat_map(BezPath::segments);
    let long_du = segments.map(|segment| length_du(segment.to_cubic())).sum::<f64>() / 2.0;
    [covered / long_du, long_du]
}

pub(crate) fn is_closed(path: &BezPath) -> bool {
    path.elements().last() == Some(&PathEl::ClosePath)
}

/// The subpath with its end joined to its start.
pub(crate) fn closed(mut path: BezPath) -> BezPath {
    if !is_closed(&path) {
        path.close_path();
    }
    path
}

/// The straight lines that close open subpaths where they are filled.
pub(crate) fn gaps(subpaths: &[BezPath]) -> Vec<BezPath> {
    let ends = subpaths.iter().filter(|path| has_area(path)).filter_map(|path| match path.elements() {
        [PathEl::MoveTo(start), .., last] => last.end_point().map(|end| (end, *start)),
        _ => None,
    });
    let open = ends.filter(|(end, start)| end != start);
    open.map(|(end, start)| BezPath::from_vec(vec![PathEl::MoveTo(end), PathEl::LineTo(start)])).collect()
}

/// Whether a subpath is an upright rectangle that covers a frame.
pub(crate) fn is_rectangle_over(path: &BezPath, frame: Rect) -> bool {
    let bounds = path.control_box();
    let covers = bounds.inflate(0.5, 0.5).contains_rect(frame);
    covers && (path.area().abs() - bounds.area()).abs() <= 1e-6 * bounds.area()
}
