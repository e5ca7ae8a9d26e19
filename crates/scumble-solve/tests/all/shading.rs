//! Shading scribbles in a picture: what they show, and what they do not depend on.

use kurbo::{Affine, BezPath, Circle, Point, Rect, Shape, Vec2};
use proptest::prelude::*;
use scumble_core::{
    Blend, Curve, Document, Drawing, Paint, PenPressure, Scribble, ScribbleKind, Shading, Srgb8,
};
use scumble_solve::{Field, FieldTriangle, Picture, Pixmap, Scene, View, paint};

const YELLOW: Srgb8 = Srgb8([255, 230, 0]);
const BLUE: Srgb8 = Srgb8([0, 0, 255]);

/// Two circles that overlap: three regions, and the page around them.
fn document(scribbles: Vec<Scribble>) -> Document {
    let circles = [(400.0, 500.0), (640.0, 500.0)].map(|at| Circle::new(at, 220.0).to_path(1e-6));
    let curves = circles.map(|path: BezPath| Curve { path, line: None }).to_vec();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
    Document { scribbles, ..Document::new(drawing) }
}

fn fill(color: Srgb8, at: (f64, f64)) -> Scribble {
    let points = vec![Point::from(at), Point::new(at.0 + 10.0, at.1)];
    Scribble { color: color.into(), kind: ScribbleKind::Fill, width_du: 8.0, points }
}

fn fills() -> Vec<Scribble> {
    vec![fill(YELLOW, (280.0, 500.0)), fill(Srgb8([200, 30, 60]), (510.0, 500.0)), fill(BLUE, (740.0, 500.0))]
}

fn shade(color: Srgb8, strength: f64, width_du: f64, points: &[(f64, f64)]) -> Scribble {
    let kind = ScribbleKind::Shade(Shading { strength, ..Shading::default() });
    Scribble {
        color: color.into(),
        kind,
        width_du,
        points: points.iter().copied().map(Point::from).collect(),
    }
}

/// A shade with what a pen made of it.
fn pressed(shade: Scribble, strength: f64, pressure: &PenPressure) -> Scribble {
    let kind = Shading { strength, pressure: pressure.clone(), ..Shading::default() };
    Scribble { kind: ScribbleKind::Shade(kind), ..shade }
}

fn field(document: &Document) -> Field {
    Picture::new(&document.drawing).expect("a map").update(document).expect("a field").clone()
}

fn pixels(field: &Field) -> Pixmap {
    let view = View { px_from_du: Affine::IDENTITY, width_px: 1024, height_px: 1024 };
    paint(&Scene { paper: Some(Srgb8([255; 3])), field, shapes: &[] }, &view)
}

fn color_at(pixels: &Pixmap, (x, y): (f64, f64)) -> [u8; 4] {
    pixels.rgba.as_chunks().0[y as usize * pixels.width_px as usize + x as usize]
}

/// The largest difference between two colours, in levels.
fn difference(a: [u8; 4], b: [u8; 4]) -> u8 {
    a.into_iter().zip(b).map(|(a, b)| a.abs_diff(b)).fold(0, u8::max)
}

fn largest_difference(a: &Pixmap, b: &Pixmap) -> u8 {
    a.rgba.iter().zip(&b.rgba).map(|(a, b)| a.abs_diff(*b)).fold(0, u8::max)
}

/// Values at points inside the triangle.
fn values(triangle: &FieldTriangle) -> impl Iterator<Item = [f64; 4]> + '_ {
    let steps = (0..=5).flat_map(|i| (0..=5 - i).map(move |j| (f64::from(i) / 5.0, f64::from(j) / 5.0)));
    steps.map(|(u, v)| {
        let w = 1.0 - u - v;
        let corner = |t: f64| t * (2.0 * t - 1.0);
        let shape = [corner(u), corner(v), corner(w), 4.0 * u * v, 4.0 * v * w, 4.0 * w * u];
        [0, 1, 2, 3].map(|i| shape.iter().zip(triangle.colors).map(|(s, c)| s * f64::from(c[i])).sum())
    })
}

#[test]
fn at_full_strength_the_middle_of_a_stroke_has_its_colour() {
    for (color, below) in [(BLUE, YELLOW), (YELLOW, BLUE), (Srgb8([255; 3]), Srgb8([0; 3]))] {
        for width_du in [12.0, 48.0, 120.0] {
            let way = [(300.0, 440.0), (330.0, 500.0), (300.0, 560.0)];
            let strokes = [&way[..], &way[1..2]];
            for points in strokes {
                let scribbles = vec![fill(below, (280.0, 500.0)), shade(color, 1.0, width_du, points)];
                let pixels = pixels(&field(&document(scribbles)));
                let Srgb8([r, g, b]) = color;
                for &point in points {
                    let found = color_at(&pixels, point);
                    assert!(difference(found, [r, g, b, 255]) <= 2, "{found:?} {color} {width_du} {point:?}");
                }
            }
        }
    }
}

#[test]
fn without_strength_the_picture_is_as_without_the_stroke() {
    let mut scribbles = fills();
    let without = field(&document(scribbles.clone()));
    scribbles.insert(1, shade(BLUE, 0.0, 60.0, &[(280.0, 480.0), (320.0, 500.0)]));
    assert_eq!(field(&document(scribbles)), without);
}

#[test]
fn along_a_stroke_a_pen_changes_how_wide_or_how_strong_it_is() {
    let way = [(300.0, 380.0), (300.0, 620.0)];
    let colors = |pressure: &PenPressure| {
        let stroke = pressed(shade(BLUE, 1.0, 60.0, &way), 1.0, pressure);
        let pixels = pixels(&field(&document(vec![fill(YELLOW, (280.0, 500.0)), stroke])));
        [(300.0, 385.0), (330.0, 385.0), (300.0, 610.0), (330.0, 610.0)]
            .map(|at| i32::from(color_at(&pixels, at)[2]))
    };
    let rising = vec![0.2, 1.0];
    let even = colors(&PenPressure::Even);
    let wide = colors(&PenPressure::Radius(rising.clone()));
    assert!(wide[0] > 250 && wide[1] + 15 < even[1], "thin at first: {wide:?} {even:?}");
    assert!(wide[2] > 250 && (even[3] - wide[3]).abs() < 10, "as wide as it can be: {wide:?} {even:?}");
    let strong = colors(&PenPressure::Strength(rising));
    assert!(strong[0] + 30 < even[0] && strong[2] > 250, "{strong:?} {even:?}");
}

#[test]
fn where_a_pen_leaves_no_strength_there_is_none_and_where_it_leaves_all_it_is_a_mouse() {
    let with = |pressure: &PenPressure| {
        let way = [(300.0, 400.0), (320.0, 600.0)];
        let scribbles = [fills(), vec![pressed(shade(BLUE, 0.8, 60.0, &way), 0.8, pressure)]].concat();
        field(&document(scribbles))
    };
    assert_eq!(with(&PenPressure::Strength(vec![0.0, 0.0])), field(&document(fills())));
    for all in [PenPressure::Radius(vec![1.0, 1.0]), PenPressure::Strength(vec![1.0, 1.0])] {
        assert_eq!(with(&all), with(&PenPressure::Even));
    }
}

#[test]
fn a_stroke_stays_in_the_region_that_it_begins_in_unless_it_crosses() {
    let way = [(300.0, 500.0), (510.0, 500.0)];
    let differs = |crosses: bool, at: (f64, f64)| {
        let mut scribbles = fills();
        let without = pixels(&field(&document(scribbles.clone())));
        let mut stroke = shade(Srgb8([0, 255, 0]), 0.8, 40.0, &way);
        stroke.kind = ScribbleKind::Shade(Shading { strength: 0.8, crosses, ..Shading::default() });
        scribbles.push(stroke);
        let with = pixels(&field(&document(scribbles)));
        difference(color_at(&with, at), color_at(&without, at)) > 8
    };
    assert_eq!(
        [(330.0, 500.0), (500.0, 500.0), (740.0, 500.0)].map(|at| differs(false, at)),
        [true, false, false]
    );
    assert_eq!(
        [(330.0, 500.0), (500.0, 500.0), (740.0, 500.0)].map(|at| differs(true, at)),
        [true, true, false]
    );
}

/// Where a stroke of some width shades, of the left crescent and the lens beside it.
fn shaded(width_du: f64, points: &[(f64, f64)]) -> [bool; 2] {
    let without = pixels(&field(&document(fills())));
    let with = pixels(&field(&document([fills(), vec![shade(BLUE, 1.0, width_du, points)]].concat())));
    // On either side of the line between them, which goes through (420, 500).
    [414.0, 426.0].map(|x| difference(color_at(&with, (x, 500.0)), color_at(&without, (x, 500.0))) > 8)
}

#[test]
fn a_stroke_that_begins_just_across_a_line_is_where_it_goes_on() {
    let [crescent, lens] = [[true, false], [false, true]];
    let across = |from: f64, to: f64| shaded(40.0, &[(from, 500.0), (to, 500.0)]);
    assert_eq!(
        [across(416.0, 422.0), across(424.0, 418.0)],
        [crescent, lens],
        "most of it is before the line"
    );
    assert_eq!(
        [across(416.0, 426.0), across(424.0, 414.0)],
        [lens, crescent],
        "most of it is beyond the line"
    );
    assert_eq!([across(416.0, 560.0), across(424.0, 300.0)], [lens, crescent], "it goes on and on");
    assert_eq!(
        [across(396.0, 560.0), across(444.0, 300.0)],
        [crescent, lens],
        "it begins well before the line"
    );
    assert_eq!([shaded(40.0, &[(416.0, 500.0)]), shaded(40.0, &[(424.0, 500.0)])], [crescent, lens], "a dab");
}

#[test]
fn a_stroke_that_grows_changes_its_region_no_more_once_it_has_gone_a_radius() {
    // Over the line and back, along it on either side.
    let way =
        [(400.0, 500.0), (424.0, 500.0), (424.0, 540.0), (412.0, 490.0), (424.0, 450.0), (424.0, 300.0)];
    let regions: Vec<_> = (2..=way.len()).map(|count| shaded(36.0, &way[..count])).collect();
    assert!(regions.iter().all(|region| *region == [true, false]), "{regions:?}");
}

#[test]
fn a_stroke_from_off_the_page_stays_where_it_comes_in() {
    let drawing = Drawing {
        curves: vec![Curve { path: Circle::new((0.0, 500.0), 200.0).to_path(1e-6), line: None }],
        ..document(vec![]).drawing
    };
    let stroke = shade(BLUE, 1.0, 30.0, &[(-900.0, 500.0), (400.0, 500.0)]);
    let scribbles = vec![fill(YELLOW, (100.0, 450.0)), stroke];
    let pixels = pixels(&field(&Document { scribbles, ..Document::new(drawing) }));
    assert_eq!([(100.0, 500.0), (300.0, 500.0)].map(|at| color_at(&pixels, at)[2] > 200), [true, true]);
    assert!(difference(color_at(&pixels, (100.0, 500.0)), [0, 0, 255, 255]) <= 2);
    assert_eq!(color_at(&pixels, (300.0, 500.0)), [255; 4]);
}

#[test]
fn a_small_move_makes_a_small_difference() {
    let at = |way: &[(f64, f64)], width_du: f64, pressure: &PenPressure, away_du: f64| {
        let way: Vec<_> = way.iter().map(|&(x, y)| (x + away_du, y + 0.6 * away_du)).collect();
        let stroke = pressed(shade(Srgb8([0; 3]), 1.0, width_du, &way), 1.0, pressure);
        pixels(&field(&document(vec![fill(Srgb8([255; 3]), (280.0, 500.0)), stroke])))
    };
    let parts = vec![0.25, 1.0, 0.5];
    let bent = &[(300.0, 450.0), (330.0, 520.0), (290.0, 600.0)][..];
    for (way, width_du, pressure) in [
        (bent, 48.0, PenPressure::Even),
        (&[(310.0, 500.0)], 20.0, PenPressure::Even),
        (&[(250.0, 400.0), (400.0, 330.0)], 90.0, PenPressure::Even),
        (bent, 64.0, PenPressure::Radius(parts.clone())),
        (bent, 64.0, PenPressure::Strength(parts)),
    ] {
        for step in 0..8 {
            let start_du = 0.7 * f64::from(step);
            let at = |away_du: f64| at(way, width_du, &pressure, away_du);
            let moved = largest_difference(&at(start_du), &at(start_du + 0.01));
            assert!(moved <= 1, "{moved} levels, {width_du} {start_du}");
        }
    }
}

#[test]
fn a_move_that_leaves_the_number_of_triangles_moves_their_corners() {
    let mut document = document(fills());
    document.scribbles.push(shade(BLUE, 0.8, 40.0, &[(300.0, 450.0)]));
    let mut picture = Picture::new(&document.drawing).expect("a map");
    let mut moved = 0;
    for _ in 0..30 {
        let before = picture.update(&document).expect("a field").clone();
        document.scribbles[3].points[0] += Vec2::new(2.0, 1.5);
        let after = picture.update(&document).expect("a field");
        assert!(after == &field(&document), "as if it had been there from the first");
        let pairs = || before.triangles.iter().zip(&after.triangles);
        let is_as_many = before.triangles.len() == after.triangles.len();
        moved += usize::from(is_as_many && pairs().any(|(a, b)| a.corners != b.corners));
    }
    assert!(moved > 0, "some move is one of those");
}

/// Also where there is more detail than the mesh has room for.
#[test]
fn what_a_pen_draws_among_other_shades_is_as_if_it_had_been_there_from_the_first() {
    for (width_du, count) in [(30.0, 8), (1.0, 24)] {
        let place = |i: usize| (350.0 + 40.0 * (i % 3) as f64, 380.0 + 30.0 * (i / 3) as f64);
        let across = |(x, y): (f64, f64)| shade(BLUE, 0.8, width_du, &[(x, y), (x + 240.0, y + 130.0)]);
        let mut document = document(fills());
        document.scribbles.extend((0..count).map(|i| across(place(i))));
        let mut picture = Picture::new(&document.drawing).expect("a map");
        let first = picture.update(&document).expect("a field");
        assert!(first == &field(&document));
        assert!((width_du > 10.0) != (first.triangles.len() > 60_000), "{}", first.triangles.len());
        let hand = document.scribbles.len();
        document.scribbles.push(shade(YELLOW, 0.5, width_du, &[(520.0, 400.0)]));
        for step in 1..4 {
            document.scribbles[hand].points.push(Point::new(520.0 - 20.0 * f64::from(step), 450.0));
            assert!(picture.update(&document).expect("a field") == &field(&document), "step {step}");
        }
        document.scribbles.remove(hand - 2);
        assert!(picture.update(&document).expect("a field") == &field(&document), "one is erased");
    }
}

fn any_shade() -> impl Strategy<Value = Scribble> {
    let points = prop::collection::vec((150.0..900.0_f64, 250.0..750.0_f64), 1..4);
    (any::<[u8; 3]>(), 0.05..=1.0_f64, 6.0..150.0_f64, points, any::<bool>(), any_pressure()).prop_map(
        |(rgb, strength, width_du, points, crosses, pressure)| Scribble {
            kind: ScribbleKind::Shade(Shading { strength, crosses, pressure }),
            ..shade(Srgb8(rgb), strength, width_du, &points)
        },
    )
}

fn any_pressure() -> impl Strategy<Value = PenPressure> {
    let parts = || prop::collection::vec(0.0..=1.0_f64, 1..4);
    prop_oneof![
        Just(PenPressure::Even),
        parts().prop_map(PenPressure::Radius),
        parts().prop_map(PenPressure::Strength),
    ]
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_order_of_shades_makes_no_difference(shades in prop::collection::vec(any_shade(), 2..4)) {
        let forth = [fills(), shades.clone()].concat();
        let back: Vec<_> = shades.into_iter().rev().chain(fills()).collect();
        prop_assert!(field(&document(forth)) == field(&document(back)));
    }

    #[test]
    fn what_is_erased_moved_or_recoloured_leaves_no_trace(shades in prop::collection::vec(any_shade(), 1..4)) {
        let mut document = document(fills());
        let mut picture = Picture::new(&document.drawing).expect("a map");
        let without = picture.update(&document).expect("a field").clone();
        for shade in &shades {
            document.scribbles.push(shade.clone());
            let fresh = field(&document);
            prop_assert!(picture.update(&document).expect("a field") == &fresh, "drawn");
            document.scribbles[3].color = Paint::Color(BLUE);
            let fresh = field(&document);
            prop_assert!(picture.update(&document).expect("a field") == &fresh, "recoloured");
        }
        document.scribbles.truncate(3);
        prop_assert!(picture.update(&document).expect("a field") == &without, "erased");
    }

    #[test]
    fn no_value_leaves_the_range_of_the_colours(shades in prop::collection::vec(any_shade(), 1..4)) {
        // One colour for the sides: where two meet in a point, the picture of the sides alone is rough.
        let fill = fill(YELLOW, (280.0, 500.0));
        let circle = Circle::new((500.0, 500.0), 250.0).to_path(1e-6);
        let drawing = Drawing { curves: vec![Curve { path: circle, line: None }], ..document(vec![]).drawing };
        let scribbles = [vec![fill], shades].concat();
        let given: Vec<_> = scribbles.iter().map(|scribble| Blend::Oklab.from_paint(scribble.color)).collect();
        for value in field(&Document { scribbles, ..Document::new(drawing) }).triangles.iter().flat_map(values) {
            for i in 0..3 {
                // Around the circle there is paper.
                let channel = || given.iter().map(|color| color[i]).chain([0.0]);
                let [least, most] = [channel().fold(0.0, f64::min), channel().fold(0.0, f64::max)];
                let beyond = (least - value[i]).max(value[i] - most);
                // Nodes stay in the range; between them a quadratic may leave it a little.
                prop_assert!(beyond <= 1.0 / 255.0, "{} levels", beyond * 255.0);
            }
        }
    }
}

#[test]
fn a_shade_on_paper_fades_into_it() {
    let shades = vec![shade(Srgb8([200, 0, 0]), 1.0, 60.0, &[(280.0, 500.0)])];
    let pixels = pixels(&field(&document(shades)));
    let paper = [255; 4];
    assert!(difference(color_at(&pixels, (280.0, 500.0)), [200, 0, 0, 255]) <= 2);
    assert_eq!(color_at(&pixels, (170.0, 500.0)), paper);
    assert_eq!(color_at(&pixels, (740.0, 500.0)), paper);
}

#[test]
fn where_nothing_has_a_colour_a_shade_stays_around_its_stroke() {
    let bare = Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0));
    for drawing in [bare, document(vec![]).drawing] {
        for (strength, width_du) in [(0.2, 16.0), (0.6, 60.0), (1.0, 70.0), (1.0, 80.0)] {
            let scribbles = vec![shade(Srgb8([200, 0, 0]), strength, width_du, &[(130.5, 130.5)])];
            let pixels = pixels(&field(&Document { scribbles, ..Document::new(drawing.clone()) }));
            let green = |along: Vec2, radii: f64| {
                let p = Point::new(130.5, 130.5) + 0.5 * radii * width_du * along;
                color_at(&pixels, p.into())[1]
            };
            let profile =
                [0.0, 0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 10.0].map(|radii| green(Vec2::new(1.0, 0.0), radii));
            assert!(profile.is_sorted() && profile[6] >= 235 && profile[8] >= 254, "{profile:?}");
            assert!(strength < 1.0 || profile[0] <= 2, "{profile:?}");
            for radii in [0.5, 1.0, 1.5, 2.0, 3.0] {
                let around = (0..8).map(|i| green(Vec2::from_angle(0.8 * f64::from(i)), radii));
                let [least, most] = around.fold([255, 0], |[least, most], g| [g.min(least), g.max(most)]);
                assert!(most - least <= 16, "{least} to {most} at {radii} radii of {width_du} du");
            }
        }
    }
}
