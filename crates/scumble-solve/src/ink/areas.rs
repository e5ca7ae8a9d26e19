//! Solid areas: the regions of a planar map that lie inside a fill.
//!
//! The outlines of fills are curves of the drawing, also where no line is drawn along them. A file that was written by hand may
//! have fills of which that is not so: these get a map of their own.

use kurbo::{BezPath, PathEl, Point, Rect, Shape as _};
use scumble_core::{Curve, Drawing, Fill, PlanarMap, Sampling, Triangulation};

use super::soup::Soup;
use crate::scene::Shape;

/// The fills of a drawing. Those of which nothing would be seen have no shape.
pub(super) fn shapes(drawing: &Drawing, map: &PlanarMap) -> Vec<Shape> {
    if drawing.fills.is_empty() {
        return Vec::new();
    }
    let regions = regions(map.triangulation());
    let outlines = Outlines::new(&drawing.curves);
    let shape = |fill: &Fill| {
        let own = (!outlines.have(fill)).then(|| own_regions(fill, drawing));
        Shape { triangles: filled(fill, own.as_ref().unwrap_or(&regions)).into(), color: fill.color }
    };
    let shapes = drawing.fills.iter().map(shape);
    shapes.filter(|shape| !shape.triangles.is_empty()).collect()
}

/// Curves, to be found by where they start.
struct Outlines<'a>(Vec<(Start, &'a [PathEl])>);

type Start = [u64; 2];

impl<'a> Outlines<'a> {
    fn new(curves: &'a [Curve]) -> Self {
        let mut outlines: Vec<_> =
            curves.iter().map(|curve| (start(curve.path.elements()), curve.path.elements())).collect();
        outlines.sort_by_key(|(start, _)| *start);
        Self(outlines)
    }

    /// Whether all outlines of a fill are curves; whether they are closed matters to neither.
    fn have(&self, fill: &Fill) -> bool {
        subpaths(&fill.path).all(|subpath| {
            let first = self.0.partition_point(|(at, _)| *at < start(subpath));
            let from_there = self.0[first..].iter().take_while(|(at, _)| *at == start(subpath));
            from_there.map(|(_, curve)| open(curve)).any(|curve| curve == open(subpath))
        })
    }
}

fn start(path: &[PathEl]) -> Start {
    let point = path.first().and_then(PathEl::end_point).unwrap_or_default();
    [point.x, point.y].map(f64::to_bits)
}

fn subpaths(path: &BezPath) -> impl Iterator<Item = &[PathEl]> {
    path.elements().chunk_by(|_, next| !matches!(next, PathEl::MoveTo(_)))
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
    let bounds = fill.path.bounding_box();
    let inside = regions.iter().filter(|region| is_inside(fill, bounds, region.inner));
    inside.flat_map(|region| region.triangles.iter().copied()).collect()
}

fn is_inside(fill: &Fill, bounds: Rect, p: Point) -> bool {
    bounds.contains(p) && {
        let winding = fill.path.winding(p);
        if fill.even_odd { winding % 2 != 0 } else { winding != 0 }
    }
}

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
    regions.into_iter().map(|(_, inner, triangles)| Region { inner, triangles }).collect()
}
