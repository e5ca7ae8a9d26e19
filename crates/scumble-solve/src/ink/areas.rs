//! Solid areas: the regions of a planar map that lie inside a fill.
//!
//! The outlines of fills are curves of the drawing, also where no line is drawn along them. A file that was written by hand may
//! have fills of which that is not so: these get a map of their own.

use std::cell::LazyCell;

use kurbo::{BezPath, PathEl, Point};
use scumble_core::sort;
use scumble_core::starts::{Starts, subpaths};
use scumble_core::{Curve, Drawing, Fill, PlanarMap, Sampling, Triangulation};

use super::flatten;
use super::soup::{Soup, Stop};
use crate::scene::Shape;

/// How far outlines are off at most where it is asked what is inside them.
const TOLERANCE_DU: f64 = 0.01;

/// The fills of a drawing. Those of which nothing would be seen have no shape.
pub(super) fn shapes(drawing: &Drawing, map: &PlanarMap) -> Vec<Shape> {
    if drawing.fills.is_empty() {
        return Vec::new();
    }
    let regions = regions(map.triangulation());
    let curves = Starts::of(drawing.curves.iter().map(|curve| curve.path.elements()));
    let shape = |fill: &Fill| {
        let own = (!are_drawn(fill, &curves)).then(|| own_regions(fill, drawing));
        Shape { triangles: filled(fill, own.as_ref().unwrap_or(&regions)).into(), color: fill.color }
    };
    let mut shapes: Vec<_> = drawing.fills.iter().map(shape).collect();
    shapes.retain(|shape| !shape.triangles.is_empty());
    shapes
}

/// Whether all outlines of a fill are among curves, with the line that closes each: where another area hides a part of that, a
/// region would run out of it.
fn are_drawn(fill: &Fill, curves: &Starts<'_>) -> bool {
    subpaths(&fill.path).map(open).all(|outline| {
        let is_closed = gap(outline).is_none_or(|gap| curves.like(&gap).any(|curve| curve == gap));
        let mut alike = curves.like(outline).filter(|curve| open(curve) == outline);
        alike.any(|curve| is_closed || curve.len() > outline.len())
    })
}

/// The straight line that closes an outline, if it has to be.
fn gap(outline: &[PathEl]) -> Option<[PathEl; 2]> {
    let [start, end] = [outline.first()?, outline.last()?].map(PathEl::end_point);
    let gap = [PathEl::MoveTo(end?), PathEl::LineTo(start?)];
    (start != end).then_some(gap)
}

fn open(path: &[PathEl]) -> &[PathEl] {
    path.strip_suffix(&[PathEl::ClosePath]).unwrap_or(path)
}

/// The regions of a map of its outlines alone; none where that cannot be had.
fn own_regions(fill: &Fill, drawing: &Drawing) -> Vec<Region> {
    let closed = |subpath: &[PathEl]| open(subpath).iter().copied().chain([PathEl::ClosePath]).collect();
    let curves = subpaths(&fill.path).map(|subpath| Curve { path: closed(subpath), line: None }).collect();
    let alone = Drawing { curves, ..Drawing::new(drawing.page) };
    PlanarMap::build(&alone, &Sampling::default()).map(|map| regions(map.triangulation())).unwrap_or_default()
}

/// A region of the map.
struct Region {
    /// A point well inside it: the centroid of its largest triangle.
    inner: Point,
    triangles: Soup,
}

/// The triangles of the regions inside a fill.
fn filled(fill: &Fill, regions: &[Region]) -> Soup {
    let bounds = fill.path.control_box();
    let outlines = LazyCell::new(|| outlines(&fill.path));
    let first = regions.partition_point(|region| region.inner.x < bounds.x0);
    let beside = regions[first..].iter().take_while(|region| region.inner.x <= bounds.x1);
    let is_inside = |p: Point| {
        let winding = winding(&outlines, p);
        if fill.even_odd { winding % 2 != 0 } else { winding != 0 }
    };
    let inside = beside.filter(|region| bounds.contains(region.inner) && is_inside(region.inner));
    inside.flat_map(|region| region.triangles.iter().copied()).collect()
}

/// A path as polygons, each from its last corner around to it.
fn outlines(path: &BezPath) -> Vec<Vec<Point>> {
    let polygon = |(stops, _): (Vec<Stop>, bool)| {
        let last = stops.last().map(|stop| stop.point);
        last.into_iter().chain(stops.iter().map(|stop| stop.point)).collect()
    };
    flatten(path.iter(), TOLERANCE_DU).into_iter().map(polygon).collect()
}

/// How often polygons go around a point to the left.
fn winding(polygons: &[Vec<Point>], p: Point) -> i32 {
    let edges = polygons.iter().flat_map(|polygon| polygon.windows(2));
    let crossing = |edge: &[Point]| {
        let (from, to) = (edge[0] - p, edge[1] - p);
        match (from.y <= 0.0, to.y <= 0.0) {
            (true, false) => i32::from(from.cross(to) > 0.0),
            (false, true) => -i32::from(from.cross(to) < 0.0),
            _ => 0,
        }
    };
    edges.map(crossing).sum()
}

/// The regions of a map, from left to right.
fn regions(mesh: &Triangulation) -> Vec<Region> {
    let (region_of, count) = mesh.regions();
    let mut regions: Vec<_> = (0..count).map(|_| (0.0, Point::ORIGIN, Soup::new())).collect();
    for (t, &region) in region_of.iter().enumerate() {
        let [a, b, c] = mesh.corners(t);
        let area = (b - a).cross(c - a);
        let (largest, inner, triangles) = &mut regions[region as usize];
        if area > *largest {
            (*largest, *inner) = (area, a + ((b - a) + (c - a)) / 3.0);
        }
        triangles.push([a, b, c].map(|p| [p.x as f32, p.y as f32]));
    }
    let mut regions: Vec<_> =
        regions.into_iter().map(|(_, inner, triangles)| Region { inner, triangles }).collect();
    sort::sort_by_key(&mut regions, |region| sort::float(region.inner.x));
    regions
}
