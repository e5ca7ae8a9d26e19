//! Colours that were set by hand, as they show in a picture.

use kurbo::{Affine, BezPath, Circle, Point, Rect, Shape};
use scumble_core::{Blend, ColorPoint, Curve, Document, Drawing, Paint, Scribble, Settings, Srgb8};
use scumble_solve::{Picture, Scene, View, paint};

const RED: Srgb8 = Srgb8([200, 20, 20]);
const BLUE: Srgb8 = Srgb8([20, 20, 200]);
const GREEN: Srgb8 = Srgb8([20, 200, 20]);
const PAPER: Srgb8 = Srgb8([255; 3]);

fn document(paths: &[BezPath], color_points: Vec<ColorPoint>) -> Document {
    let mut drawing = Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0));
    drawing.curves.extend(paths.iter().map(|path| Curve { path: path.clone(), line: None }));
    let settings = Settings { blend: Blend::Srgb, ..Settings::default() };
    Document { color_points, settings, ..Document::new(drawing) }
}

fn path(data: &str) -> BezPath {
    BezPath::from_svg(data).expect("a path")
}

fn point(is_left: bool, at_du: f64, color: impl Into<Paint>) -> ColorPoint {
    ColorPoint { curve: 0, is_left, at_du, color: color.into() }
}

/// The colours of the picture at places in du.
fn colors<const N: usize>(document: &Document, places: [(f64, f64); N]) -> [Srgb8; N] {
    let mut picture = Picture::new(&document.drawing).expect("a map");
    let field = picture.update(document).expect("a field");
    places.map(|(x, y)| {
        let px_from_du = Affine::translate((0.5 - x, 0.5 - y));
        let scene = Scene { paper: Some(PAPER), field, shapes: &[] };
        let pixel = paint(&scene, &View { px_from_du, width_px: 1, height_px: 1 });
        Srgb8([pixel.rgba[0], pixel.rgba[1], pixel.rgba[2]])
    })
}

#[track_caller]
fn assert_near(color: Srgb8, expected: Srgb8, levels: u8) {
    let apart = color.0.iter().zip(expected.0).map(|(a, b)| a.abs_diff(b)).max();
    assert!(apart <= Some(levels), "{color} is not {expected}");
}

#[test]
fn left_is_above_a_line_to_the_right() {
    let across = path("M 0 500 H 1024");
    let document = document(&[across], vec![point(true, 100.0, RED), point(false, 900.0, BLUE)]);
    let [above, below] = colors(&document, [(300.0, 200.0), (300.0, 800.0)]);
    assert_near(above, RED, 1);
    assert_near(below, BLUE, 1);
}

#[test]
fn between_two_points_colours_change_evenly_and_stay_beyond_them() {
    let across = path("M 0 500 H 1024");
    let points = vec![point(true, 700.0, BLUE), point(true, 300.0, RED)];
    let document = document(&[across], points);
    let beside = [100.0, 300.0, 400.0, 500.0, 700.0, 900.0].map(|x| (x, 499.5));
    let expected = [RED, RED, Srgb8([155, 20, 65]), Srgb8([110, 20, 110]), BLUE, BLUE];
    for (color, expected) in colors(&document, beside).into_iter().zip(expected) {
        assert_near(color, expected, 2);
    }
}

#[test]
fn what_was_set_by_hand_wins_over_a_scribble_on_its_side_alone() {
    let circle = Circle::new((512.0, 512.0), 300.0).to_path(1e-6);
    let inside = Point::new(512.0, 512.0);
    let mut document = document(&[circle], vec![point(true, 0.0, RED)]);
    document.scribbles = [inside, Point::new(60.0, 60.0)]
        .map(|p| Scribble { color: GREEN.into(), kind: Default::default(), width_du: 10.0, points: vec![p] })
        .to_vec();
    let places = [(512.0, 512.0), (100.0, 100.0)];
    let both = colors(&document, places);
    document.color_points[0].is_left = false;
    let other = colors(&document, places);
    for (on_left, on_right) in both.into_iter().zip(other) {
        let mut sides = [on_left, on_right];
        sides.sort_unstable();
        assert_near(sides[0], GREEN, 1);
        assert_near(sides[1], RED, 1);
    }
}

#[test]
fn no_colour_set_by_hand_is_paper() {
    let across = path("M 0 500 H 1024");
    let document = document(&[across], vec![point(true, 0.0, Paint::Clear), point(false, 0.0, BLUE)]);
    let [above, below] = colors(&document, [(300.0, 200.0), (300.0, 800.0)]);
    assert_near(above, PAPER, 0);
    assert_near(below, BLUE, 1);
}

#[test]
fn points_that_belong_nowhere_change_nothing() {
    let circle = Circle::new((512.0, 512.0), 300.0).to_path(1e-6);
    let sound = vec![point(true, 100.0, RED), point(true, 500.0, BLUE)];
    let odd = [
        ColorPoint { curve: 7, ..sound[0] },
        ColorPoint { at_du: f64::NAN, ..sound[0] },
        ColorPoint { curve: u32::MAX, at_du: f64::INFINITY, ..sound[0] },
    ];
    let places = [(512.0, 512.0), (500.0, 250.0), (100.0, 100.0)];
    let expected = colors(&document(std::slice::from_ref(&circle), sound.clone()), places);
    let with_odd = document(&[circle], [&sound[..], &odd].concat());
    assert_eq!(colors(&with_odd, places), expected);
}

#[test]
fn a_point_past_the_end_is_on_the_way_there() {
    let circle = Circle::new((512.0, 512.0), 300.0).to_path(1e-6);
    let length_du = 600.0 * std::f64::consts::PI;
    let points = vec![point(false, 0.0, RED), point(false, 2.0 * length_du, BLUE)];
    let document = document(&[circle], points);
    let half_way = Srgb8([155, 20, 65]);
    // The circle begins at the right.
    let [left_of_it, right_of_it] = colors(&document, [(213.0, 512.0), (211.0, 512.0)]);
    let color = if left_of_it == PAPER { right_of_it } else { left_of_it };
    assert_near(color, half_way, 3);
}
