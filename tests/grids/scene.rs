//! What every grid solver must find alike: one drawing, every backend.

use kurbo::{Affine, BezPath, Circle, Point, Rect, Shape};
use scumble_core::{BlendColor, Boundary, Curve, Drawing, PlanarMap, Sampling, SoftSource};
use scumble_solve::View;
use scumble_solve::grid::Constraints;

/// The strokes that shade, as far as they have colours.
const STROKES: [[(f64, f64); 2]; 2] = [[(250.0, 300.0), (700.0, 650.0)], [(420.0, 180.0), (560.0, 800.0)]];

/// Colours of shades: of none, of one that covers what is under it, and of one more that takes away what it covers. So there is
/// no layer over the picture, one, and two.
pub(crate) const SHADES: [&[BlendColor]; 3] = [&[], &[OPAQUE], &[OPAQUE, CLEAR]];

const OPAQUE: BlendColor = [0.9, 0.2, 0.4, 1.0];
const CLEAR: BlendColor = [0.0; 4];

/// Circles that overlap, a barrier across them, colours on every other side, and shades of some colours: links of all
/// kinds, cells of several parts, and unknowns that nothing holds.
pub(crate) fn constraints(width_px: u32, height_px: u32, shades: &[BlendColor]) -> Constraints {
    let mut barrier = BezPath::new();
    barrier.move_to((100.0, 130.0));
    barrier.curve_to((400.0, 900.0), (600.0, 100.0), (930.0, 700.0));
    let circles = [(400.0, 400.0, 230.0), (600.0, 500.0, 250.0), (610.0, 520.0, 243.0), (150.0, 850.0, 60.0)];
    let circles = circles.map(|(x, y, radius)| Circle::new((x, y), radius).to_path(1e-3));
    let map = map(circles.into_iter().chain([barrier]));
    let colors = boundary(&map, &[[0.2, 0.9], [0.7, 0.4], [0.1, 1.0]]);
    let sources = STROKES.into_iter().zip(shades).map(|(stroke, color)| source(stroke, *color));
    let boundary = Boundary { sources: sources.collect(), ..colors };
    Constraints::new(&map, &boundary, &view(width_px, height_px)).expect("solved")
}

fn source(stroke: [(f64, f64); 2], color: BlendColor) -> SoftSource {
    let points = stroke.map(Point::from).to_vec();
    SoftSource { points, radius_du: 60.0, weight: 20.0, color, crosses: true, parts: Vec::new() }
}

/// The map of a page of 1024 du.
pub(crate) fn map(paths: impl Iterator<Item = BezPath>) -> PlanarMap {
    let curves = paths.map(|path| Curve { path, line: None }).collect();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
    PlanarMap::build(&drawing, &Sampling::default()).expect("a map")
}

/// Of the whole width of that page.
pub(crate) fn view(width_px: u32, height_px: u32) -> View {
    View { px_from_du: Affine::scale(f64::from(width_px) / 1024.0), width_px, height_px }
}

/// Colours for both sides of the first curves.
pub(crate) fn boundary(map: &PlanarMap, colors: &[[f64; 2]]) -> Boundary {
    let mut sides = vec![None; map.side_count()];
    for (curve, colors) in colors.iter().enumerate() {
        for step in map.steps(curve) {
            for (side, value) in [step.left, step.left.opposite()].into_iter().zip(colors) {
                sides[side.index()] = Some([[*value, 1.0 - value, 0.5 * value, 1.0]; 3]);
            }
        }
    }
    sides.into()
}
