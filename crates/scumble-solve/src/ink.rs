//! The ink of a drawing as flat shapes: solid areas, drawn lines, scribbles.
//!
//! Lines and scribbles are loose overlapping triangles, which painters paint once per place. Solid areas are the
//! regions of the planar map that lie inside them, so that they meet the colour field without a gap.

mod areas;
mod soup;

use kurbo::{BezPath, Cap, Join, PathEl, Point, Shape as _, Stroke};
use scumble_core::{Drawing, Line, Paint, PlanarMap, Rgba8, Scribble, Srgb8};

use crate::scene::Shape;
use soup::{Pen, Soup, Stop};

/// Finer tolerances than this, in du, are taken as this; it is a tenth of a pixel at 6400%.
const LEAST_TOLERANCE_DU: f64 = 1.0 / 640.0;

/// Dashes that a line may be cut into; a line with more of them is drawn whole.
const MAX_DASHES: f64 = 10_000.0;

/// Dashes of all lines of a drawing; those that come after so many are drawn whole, too.
pub const MAX_DASHES_IN_ALL: f64 = 200_000.0;

/// The ink of a drawing, in painting order: its fills, then the lines of its curves.
///
/// Curves and round parts lie within `tolerance_du` of their true place. Fills and lines of which nothing would be
/// seen have no shape, nor have fills where there is no map yet.
pub fn line_shapes(drawing: &Drawing, map: Option<&PlanarMap>, tolerance_du: f64) -> Vec<Shape> {
    let mut left = MAX_DASHES_IN_ALL;
    let lines = drawing.curves.iter().filter_map(|curve| {
        let line = curve.line.as_ref()?;
        Some(line_shape(&curve.path, line, tolerance_du.max(LEAST_TOLERANCE_DU), &mut left))
    });
    let mut shapes = map.map_or_else(Vec::new, |map| fill_shapes(drawing, map));
    shapes.extend(lines.filter(|shape| !shape.triangles.is_empty()));
    shapes
}

/// The fills of a drawing alone, in painting order. They are the same at every tolerance, and take longer than the lines.
pub fn fill_shapes(drawing: &Drawing, map: &PlanarMap) -> Vec<Shape> {
    areas::shapes(drawing, map)
}

/// How a scribble is drawn that has no colour: mid grey.
const CLEAR: Srgb8 = Srgb8([128; 3]);

/// A scribble as it was drawn: round caps and joins, a disc for a single point. Round parts lie within
/// `tolerance_du` of their true place.
pub fn scribble_shape(scribble: &Scribble, opacity: u8, tolerance_du: f64) -> Shape {
    let stroke = Stroke::new(scribble.width_du).with_join(Join::Round).with_caps(Cap::Round);
    let stops: Vec<_> = scribble.points.iter().map(|&point| Stop { point, is_corner: true }).collect();
    let mut triangles = Soup::new();
    if let Some(pen) = pen(&stroke, tolerance_du.max(LEAST_TOLERANCE_DU)) {
        pen.draw(&stops, false, &mut triangles);
    }
    let Srgb8([r, g, b]) = match scribble.color {
        Paint::Color(color) => color,
        Paint::Clear => CLEAR,
    };
    Shape { triangles: triangles.into(), color: Rgba8([r, g, b, opacity]) }
}

/// The shape of a line, which takes its dashes from those that are left.
fn line_shape(path: &BezPath, line: &Line, tolerance_du: f64, left: &mut f64) -> Shape {
    let mut triangles = Soup::new();
    if let Some(pen) = pen(&line.stroke, tolerance_du) {
        for (stops, closed) in stretches(path, &line.stroke, tolerance_du, left) {
            pen.draw(&stops, closed, &mut triangles);
        }
    }
    Shape { triangles: triangles.into(), color: line.color }
}

/// `None` for a stroke without a width.
fn pen(stroke: &Stroke, tolerance_du: f64) -> Option<Pen> {
    (stroke.width > 0.0 && stroke.width.is_finite()).then_some(Pen {
        half_width_du: 0.5 * stroke.width,
        join: stroke.join,
        miter_limit: stroke.miter_limit,
        start_cap: stroke.start_cap,
        end_cap: stroke.end_cap,
        tolerance_du,
    })
}

/// The stops of each stretch of a path, or of each of its dashes; and whether it is closed.
fn stretches(path: &BezPath, stroke: &Stroke, tolerance_du: f64, left: &mut f64) -> Vec<(Vec<Stop>, bool)> {
    if takes_dashes(path, stroke, tolerance_du, left) {
        let dashes = kurbo::dash(path.iter(), stroke.dash_offset, &stroke.dash_pattern);
        flatten(dashes, tolerance_du)
    } else {
        flatten(path.iter(), tolerance_du)
    }
}

/// Whether a line is to be cut into dashes: as in SVG, not if one of them is negative or all are zero; and not into
/// very many, nor into more than are `left` for a drawing, of which it takes them.
pub fn takes_dashes(path: &BezPath, stroke: &Stroke, tolerance_du: f64, left: &mut f64) -> bool {
    let dashes = &stroke.dash_pattern;
    let period: f64 = dashes.iter().sum();
    let sound = period > 0.0 && period.is_finite() && dashes.iter().all(|&d| d >= 0.0);
    if !(sound && stroke.dash_offset.is_finite()) {
        return false;
    }
    let count = path.perimeter(tolerance_du) * dashes.len() as f64 / period;
    let takes = count <= left.min(MAX_DASHES);
    *left -= if takes { count } else { 0.0 };
    takes
}

fn flatten(path: impl Iterator<Item = PathEl>, tolerance_du: f64) -> Vec<(Vec<Stop>, bool)> {
    let mut stretches: Vec<(Vec<Stop>, bool)> = Vec::new();
    let mut end = Point::ORIGIN;
    for element in path {
        match (element, stretches.last_mut()) {
            (PathEl::MoveTo(p), _) => stretches.push((vec![corner(p)], false)),
            (PathEl::ClosePath, Some((_, closed))) => *closed = true,
            (_, Some((stops, _))) => flatten_element(end, element, tolerance_du, stops),
            (_, None) => {}
        }
        end = element.end_point().unwrap_or(end);
    }
    stretches.retain(|(stops, closed)| stops.len() > 1 || *closed);
    stretches
}

/// Adds the stops of one element; the last of them is a corner.
fn flatten_element(start: Point, element: PathEl, tolerance_du: f64, stops: &mut Vec<Stop>) {
    kurbo::flatten([PathEl::MoveTo(start), element], tolerance_du, |flat| {
        if let PathEl::LineTo(point) = flat {
            stops.push(Stop { point, is_corner: false });
        }
    });
    if let Some(last) = stops.last_mut() {
        last.is_corner = true;
    }
}

fn corner(point: Point) -> Stop {
    Stop { point, is_corner: true }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Field, Scene, View, paint};
    use kurbo::{Affine, Circle, Dashes, Rect};
    use scumble_core::{Curve, Fill, Sampling, ScribbleKind};

    const INK: Rgba8 = Rgba8([10, 20, 30, 200]);

    fn curve(svg_path: &str, stroke: Stroke) -> Curve {
        let path = BezPath::from_svg(svg_path).expect("a sound path");
        Curve { path, line: Some(Line { stroke, color: INK }) }
    }

    /// The shapes of a drawing on a page of 1024 × 1024 du.
    fn shapes(curves: Vec<Curve>, fills: Vec<Fill>) -> Vec<Shape> {
        let drawing = Drawing { page: Rect::new(0.0, 0.0, 1024.0, 1024.0), curves, fills };
        let map = PlanarMap::build(&drawing, &Sampling::default()).expect("a map");
        line_shapes(&drawing, Some(&map), 0.1)
    }

    fn line(svg_path: &str, stroke: Stroke) -> Soup {
        shapes(vec![curve(svg_path, stroke)], vec![])
            .pop()
            .map(|shape| shape.triangles.to_vec())
            .unwrap_or_default()
    }

    /// Least and greatest x and y.
    fn bounds(soup: &[[[f32; 2]; 3]]) -> Rect {
        let points = soup.as_flattened().iter().map(|&[x, y]| Point::new(x.into(), y.into()));
        points.map(|p| Rect::from_points(p, p)).reduce(|a, b| a.union(b)).expect("not empty")
    }

    fn area(soup: &[[[f32; 2]; 3]]) -> f64 {
        let corners = |t: &[[f32; 2]; 3]| t.map(|[x, y]| Point::new(x.into(), y.into()));
        soup.iter().map(corners).map(|[a, b, c]| 0.5 * (b - a).cross(c - a).abs()).sum()
    }

    fn assert_bounds(soup: &[[[f32; 2]; 3]], x0: f64, y0: f64, x1: f64, y1: f64) {
        let found = bounds(soup);
        let difference = [found.x0 - x0, found.y0 - y0, found.x1 - x1, found.y1 - y1];
        assert!(difference.iter().all(|d| d.abs() < 0.11), "{found:?}");
    }

    #[test]
    fn a_line_has_its_width_and_its_caps() {
        let wide = Stroke::new(8.0);
        let path = "M 100 100 L 200 100";
        assert_bounds(&line(path, wide.clone().with_caps(Cap::Butt)), 100.0, 96.0, 200.0, 104.0);
        assert_bounds(&line(path, wide.clone().with_caps(Cap::Square)), 96.0, 96.0, 204.0, 104.0);
        assert_bounds(&line(path, wide.with_caps(Cap::Round)), 96.0, 96.0, 204.0, 104.0);
    }

    #[test]
    fn curves_are_flattened_to_the_tolerance_whatever_the_width() {
        let stroke = Stroke::new(60.0).with_join(Join::Bevel).with_caps(Cap::Butt);
        let ring = line("M 500 400 A 100 100 0 1 1 499.999 400 Z", stroke);
        assert_bounds(&ring, 370.0, 370.0, 630.0, 630.0);
        for [x, y] in ring.as_flattened() {
            let radius = Point::new(500.0, 500.0).distance(Point::new((*x).into(), (*y).into()));
            assert!((69.0..130.1).contains(&radius), "{radius}");
        }
    }

    #[test]
    fn dashes_cut_a_line_and_an_offset_shifts_them() {
        let stroke = Stroke::new(2.0).with_caps(Cap::Butt).with_dashes(5.0, [10.0, 20.0]);
        let dashed = line("M 100 100 L 200 100", stroke);
        assert!((area(&dashed) - 2.0 * (5.0 + 10.0 * 3.0)).abs() < 1e-3);
        assert_bounds(&dashed, 100.0, 99.0, 195.0, 101.0);
    }

    #[test]
    fn dashes_that_make_no_sense_leave_a_line_whole() {
        let patterns: [&[f64]; 5] =
            [&[0.0, 0.0], &[-1.0, 5.0], &[f64::NAN], &[1e-9, 1e-9], &[f64::INFINITY, 1.0]];
        for pattern in patterns {
            let mut stroke = Stroke::new(2.0).with_caps(Cap::Butt);
            stroke.dash_pattern = Dashes::from_slice(pattern);
            assert!((area(&line("M 100 100 L 200 100", stroke)) - 200.0).abs() < 1e-3, "{pattern:?}");
        }
    }

    #[test]
    fn lines_after_very_many_dashes_are_whole() {
        let line =
            |i: f64| curve(&format!("M 0 {i} H 1000"), Stroke::new(2.0).with_dashes(0.0, [0.125, 0.125]));
        let curves = (0..26).map(|i| line(f64::from(i))).collect();
        let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
        let counts: Vec<_> =
            line_shapes(&drawing, None, 0.1).iter().map(|shape| shape.triangles.len()).collect();
        assert!(counts[..25].iter().all(|&count| count > 4000) && counts[25] < 100, "{counts:?}");
    }

    #[test]
    fn a_curve_of_no_length_is_a_dot_of_its_cap() {
        let dot = |cap| line("M 50 50 L 50 50", Stroke::new(10.0).with_caps(cap));
        assert!(dot(Cap::Butt).is_empty());
        assert_bounds(&dot(Cap::Square), 45.0, 45.0, 55.0, 55.0);
        assert_bounds(&dot(Cap::Round), 45.0, 45.0, 55.0, 55.0);
    }

    #[test]
    fn lines_come_in_painting_order_after_the_fills_and_invisible_ones_not_at_all() {
        let outline = Curve { path: Circle::new((300.0, 300.0), 50.0).to_path(0.01), line: None };
        let fill = Fill { path: outline.path.clone(), even_odd: false, color: Rgba8([1, 1, 1, 255]) };
        let thin = curve("M 0 0 L 9 9", Stroke::new(0.0));
        let curves = vec![
            outline,
            curve("M 0 9 L 99 9", Stroke::new(1.0)),
            thin,
            curve("M 0 0 L 9 0", Stroke::new(2.0)),
        ];
        let shapes = shapes(curves, vec![fill]);
        assert_eq!(shapes.iter().map(|s| s.color.0[0]).collect::<Vec<_>>(), [1, 10, 10]);
        assert!(bounds(&shapes[2].triangles).x1 < 11.0);
    }

    #[test]
    fn a_fill_is_the_regions_inside_it_by_its_rule() {
        let path =
            BezPath::from_svg("M 100 100 H 300 V 300 H 100 Z M 150 150 H 250 V 250 H 150 Z").expect("sound");
        let outlines = ["M 100 100 H 300 V 300 H 100 Z", "M 150 150 H 250 V 250 H 150 Z", "M 0 200 H 1024"];
        let curves = || outlines.map(|o| Curve { line: None, ..curve(o, Stroke::default()) }).to_vec();
        for (even_odd, expected) in [(false, 40_000.0), (true, 30_000.0)] {
            for present in 0..=outlines.len() {
                let curves = curves().into_iter().take(present).collect();
                let shapes = shapes(curves, vec![Fill { path: path.clone(), even_odd, color: INK }]);
                assert!((area(&shapes[0].triangles) - expected).abs() < 1.0, "{present} of its outlines");
            }
        }
    }

    #[test]
    fn a_fill_that_is_left_open_is_closed_by_a_straight_line() {
        for svg in ["M 100 100 H 300 V 300", "M 100 100 L 300 300 V 100"] {
            let path = BezPath::from_svg(svg).expect("sound");
            let shapes = shapes(vec![], vec![Fill { path, even_odd: false, color: INK }]);
            assert!((area(&shapes[0].triangles) - 20_000.0).abs() < 1.0, "{svg}");
        }
    }

    #[test]
    fn a_fill_does_not_run_out_where_the_line_that_closes_it_is_hidden() {
        let open = "M 300 100 V 300 H 100 V 100";
        let fill =
            |path: &str| Fill { path: BezPath::from_svg(path).expect("sound"), even_odd: false, color: INK };
        for closing in [&["M 100 100 L 300 100"][..], &["M 100 100 L 180 100", "M 220 100 L 300 100"], &[]] {
            for path in [open, "M 300 100 V 300 H 100 V 100 Z"] {
                let curves = [&[open][..], closing].concat();
                let curves = curves.into_iter().map(|path| curve(path, Stroke::new(2.0))).collect();
                let shapes = shapes(curves, vec![fill(path)]);
                assert!((area(&shapes[0].triangles) - 40_000.0).abs() < 1.0, "{closing:?}, {path}");
            }
        }
    }

    #[test]
    fn a_scribble_is_round_and_a_single_point_a_disc() {
        let scribble = |points| Scribble {
            color: Srgb8([9, 8, 7]).into(),
            kind: ScribbleKind::Fill,
            width_du: 20.0,
            points,
        };
        let disc = scribble_shape(&scribble(vec![Point::new(40.0, 40.0)]), 128, 0.1);
        assert_eq!(disc.color, Rgba8([9, 8, 7, 128]));
        let clear = Scribble { color: Paint::Clear, ..scribble(vec![Point::new(40.0, 40.0)]) };
        assert_eq!(
            scribble_shape(&clear, 77, 0.1),
            Shape { color: Rgba8([128, 128, 128, 77]), ..disc.clone() }
        );
        assert_bounds(&disc.triangles, 30.0, 30.0, 50.0, 50.0);
        let hook = scribble(vec![Point::new(40.0, 40.0), Point::new(90.0, 40.0), Point::new(60.0, 40.0)]);
        assert_bounds(&scribble_shape(&hook, 255, 0.1).triangles, 30.0, 30.0, 100.0, 50.0);
    }

    #[test]
    fn joins_and_caps_leave_no_hairline_however_far_one_zooms_in() {
        let way: Vec<_> = (0..40)
            .map(f64::from)
            .map(|i| Point::new(300.0 + 9.1 * i, 500.0 + 30.0 * (i / 3.0).sin()))
            .collect();
        let scribble = Scribble {
            color: Srgb8([9, 8, 7]).into(),
            kind: ScribbleKind::Fill,
            width_du: 20.0,
            points: way.clone(),
        };
        let shapes = [scribble_shape(&scribble, 255, 0.1)];
        let scene = Scene { paper: None, field: &Field::default(), shapes: &shapes };
        for (point, zoom) in way.iter().flat_map(|point| [64.0, 2000.0].map(|zoom| (point, zoom))) {
            let px_from_du =
                Affine::translate((32.0, 32.0)) * Affine::scale(zoom) * Affine::translate(-point.to_vec2());
            let picture = paint(&scene, &View { px_from_du, width_px: 64, height_px: 64 });
            assert!(
                picture.rgba.as_chunks().0.iter().all(|pixel| *pixel == [9, 8, 7, 255]),
                "{point} {zoom}"
            );
        }
    }

    #[test]
    fn tolerances_of_any_kind_give_bounded_output() {
        let scribble = Scribble {
            color: Srgb8([0; 3]).into(),
            kind: ScribbleKind::Fill,
            width_du: 500.0,
            points: vec![Point::ORIGIN],
        };
        for tolerance_du in [0.0, -1.0, f64::NAN, 1e9] {
            let count = scribble_shape(&scribble, 255, tolerance_du).triangles.len();
            assert!((4..=256).contains(&count), "{count}");
        }
    }
}
