//! What the painter promises, picture by picture.

use kurbo::{Affine, Point};
use scumble_core::{Blend, Rgba8, Srgb8};

use super::{Pixmap, Repainter, paint};
use crate::field::{Field, FieldTriangle};
use crate::scene::{Part, Scene, Shape, View};

const RED: Srgb8 = Srgb8([230, 25, 75]);
const GREEN: Srgb8 = Srgb8([60, 180, 75]);
const WHITE: Srgb8 = Srgb8([255; 3]);
const ALL_SIDES: u32 = 0b111;

fn view(px_from_du: Affine) -> View {
    View { px_from_du, width_px: 64, height_px: 48 }
}

fn flat(corners: [[f32; 2]; 3], color: Srgb8, side_edges: u32) -> FieldTriangle {
    let color = Blend::Oklab.from_srgb8(color).map(|c| c as f32);
    FieldTriangle { corners, colors: [color; 6], side_edges }
}

/// Two triangles; the border is a side, the diagonal is not.
fn rectangle(x: [f32; 2], y: [f32; 2], color: Srgb8) -> [FieldTriangle; 2] {
    let [a, b, c, d] = [[x[0], y[0]], [x[1], y[0]], [x[1], y[1]], [x[0], y[1]]];
    [flat([a, b, c], color, 0b011), flat([a, c, d], color, 0b110)]
}

fn painted(triangles: Vec<FieldTriangle>, shapes: &[Shape], paper: Option<Srgb8>, view: View) -> Pixmap {
    let field = Field { blend: Blend::Oklab, triangles };
    paint(&Scene { paper, field: &field, shapes }, &view)
}

fn pixel(picture: &Pixmap, x: usize, y: usize) -> [u8; 4] {
    picture.rgba.as_chunks().0[y * picture.width_px as usize + x]
}

fn opaque(Srgb8([r, g, b]): Srgb8) -> [u8; 4] {
    [r, g, b, 255]
}

/// Pseudo-random numbers in `0..1`, the same every time.
fn numbers(mut seed: u32) -> impl FnMut() -> f64 {
    move || {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        f64::from(seed >> 8) / f64::from(1 << 24)
    }
}

/// A grid of triangles over `0..size` du whose inner nodes are shaken; nodes on the rim stay.
fn shaken_mesh(size: f64, cells: usize, color_at: impl Fn([f64; 2]) -> [f32; 3]) -> Vec<FieldTriangle> {
    let mut number = numbers(cells as u32);
    let mut node = |i: usize, j: usize| {
        let shake = |k: usize, number: f64| if k.is_multiple_of(cells) { 0.0 } else { 0.45 * (number - 0.5) };
        let at = [i as f64 + shake(i, number()), j as f64 + shake(j, number())];
        at.map(|c| (c * size / cells as f64) as f32)
    };
    let nodes: Vec<Vec<_>> = (0..=cells).map(|j| (0..=cells).map(|i| node(i, j)).collect()).collect();
    let mut triangles = Vec::new();
    for (j, i) in (0..cells).flat_map(|j| (0..cells).map(move |i| (j, i))) {
        let [a, b, c, d] = [nodes[j][i], nodes[j][i + 1], nodes[j + 1][i + 1], nodes[j + 1][i]];
        triangles.extend([[a, b, c], [a, c, d]].map(|corners| colored(corners, 0, &color_at)));
    }
    triangles
}

/// A blend-space colour without transparency.
fn opaque_at([a, b, c]: [f32; 3]) -> [f32; 4] {
    [a, b, c, 1.0]
}

fn colored(
    corners: [[f32; 2]; 3],
    side_edges: u32,
    color_at: impl Fn([f64; 2]) -> [f32; 3],
) -> FieldTriangle {
    let [a, b, c] = corners.map(|p| p.map(f64::from));
    let middle = |a: [f64; 2], b: [f64; 2]| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
    let nodes = [a, b, c, middle(a, b), middle(b, c), middle(c, a)];
    FieldTriangle { corners, colors: nodes.map(|p| opaque_at(color_at(p))), side_edges }
}

#[test]
fn an_empty_scene_is_bare_paper() {
    let empty = |paper| painted(vec![], &[], paper, view(Affine::IDENTITY));
    assert!(empty(Some(RED)).rgba.as_chunks().0.iter().all(|p| *p == opaque(RED)));
    assert!(empty(None).rgba.iter().all(|&c| c == 0));
    assert_eq!(empty(None).rgba.len(), 4 * 64 * 48);
}

#[test]
fn a_mesh_of_one_colour_shows_no_seam_and_no_gap_at_any_angle_and_zoom() {
    let [r, g, b, _] = Blend::Oklab.from_srgb8(RED).map(|c| c as f32);
    for (cells, turn, zoom) in
        [(7, 0.0, 1.0), (40, 0.3, 1.0), (150, 1.1, 1.7), (90, 2.0, 40.0), (5, 0.7, 3e4)]
    {
        let mesh = shaken_mesh(1024.0, cells, |_| [r, g, b]);
        let px_from_du = Affine::translate((32.0, 24.0))
            * Affine::rotate(turn)
            * Affine::scale(zoom)
            * Affine::translate((-517.3, -498.7));
        let picture = painted(mesh, &[], None, view(px_from_du));
        let wrong = picture.rgba.as_chunks().0.iter().filter(|p| **p != opaque(RED)).count();
        assert_eq!(wrong, 0, "{cells} cells, turned by {turn}, zoom {zoom}");
    }
}

#[test]
fn corners_on_pixel_centres_leave_no_gap_and_paint_nothing_beyond() {
    let triangles = vec![
        flat([[10.5, 10.5], [20.5, 10.5], [20.5, 20.5]], RED, 0),
        flat([[10.5, 10.5], [20.5, 20.5], [10.5, 20.5]], GREEN, 0),
    ];
    let picture = painted(triangles, &[], None, view(Affine::IDENTITY));
    let painted = picture.rgba.as_chunks().0.iter().filter(|p| **p != [0; 4]).count();
    assert_eq!(painted, 100);
    assert_eq!(pixel(&picture, 10, 10), opaque(RED));
    assert_eq!(pixel(&picture, 20, 20), [0; 4]);
}

#[test]
fn half_a_pixel_is_half_covered() {
    let picture =
        painted(rectangle([10.5, 20.0], [8.0, 30.25], RED).to_vec(), &[], None, view(Affine::IDENTITY));
    let [r, g, b] = RED.0;
    assert_eq!(pixel(&picture, 9, 20), [0; 4]);
    assert_eq!(pixel(&picture, 10, 20), [r, g, b, 128]);
    assert_eq!(pixel(&picture, 11, 20), opaque(RED));
    assert_eq!(pixel(&picture, 15, 30), [r, g, b, 64]);
    assert_eq!(pixel(&picture, 10, 30)[3], 32);
    assert_eq!(pixel(&picture, 20, 20), [0; 4]);
}

#[test]
fn an_edge_over_paper_is_the_mean_of_both() {
    let picture =
        painted(rectangle([10.5, 20.0], [8.0, 30.0], RED).to_vec(), &[], Some(WHITE), view(Affine::IDENTITY));
    let mean = RED.0.map(|c| (u16::from(c) + 255).div_ceil(2) as u8);
    assert_eq!(pixel(&picture, 10, 20)[..3], mean);
    assert_eq!(pixel(&picture, 10, 20)[3], 255);
}

#[test]
fn coverage_of_a_slanted_edge_is_right_to_a_tenth_of_a_pixel() {
    let slanted = flat([[5.0, 3.0], [60.0, 3.0], [5.0, 40.0]], RED, ALL_SIDES);
    let picture = painted(vec![slanted], &[], None, view(Affine::IDENTITY));
    for x in 5..60 {
        let edge_y = |x: f64| 3.0 + 37.0 * (60.0 - x) / 55.0;
        let column: f64 = (0..48).map(|y| f64::from(pixel(&picture, x, y)[3]) / 255.0).sum();
        let exact = edge_y(x as f64 + 0.5) - 3.0;
        assert!((column - exact).abs() <= 0.1, "{x}: {column}, exact {exact}");
    }
}

#[test]
fn two_colours_that_meet_let_no_paper_through_and_stay_apart() {
    let (upper, lower) =
        ([[-9.0, -9.0], [99.0, -9.0], [99.0, 61.0]], [[-9.0, -9.0], [99.0, 61.0], [-9.0, 61.0]]);
    let triangles = vec![flat(upper, RED, 0b100), flat(lower, GREEN, 0b001)];
    let picture = painted(triangles, &[], None, view(Affine::IDENTITY));
    for (y, x) in (0..48).flat_map(|y| (0..64).map(move |x| (y, x))) {
        let [r, g, b, a] = pixel(&picture, x, y);
        assert_eq!(a, 255, "{x} {y}");
        let edge_y = -9.0 + (x as f64 + 9.5) * 70.0 / 108.0;
        let distance = y as f64 + 0.5 - edge_y;
        if distance.abs() > 1.0 {
            assert_eq!(Srgb8([r, g, b]), if distance < 0.0 { RED } else { GREEN }, "{x} {y}");
        }
        assert!((GREEN.0[0]..=RED.0[0]).contains(&r) && (RED.0[1]..=GREEN.0[1]).contains(&g) && b == 75);
    }
}

#[test]
fn inner_pixels_are_the_quadratic_at_their_centre() {
    let hills = |[x, y]: [f64; 2]| {
        [0.6 + 0.2 * (x / 9.0).sin(), 0.1 * (y / 7.0).cos(), 0.08 * ((x + y) / 11.0).sin()].map(|c| c as f32)
    };
    for blend in [Blend::Oklab, Blend::Srgb] {
        let field = Field { blend, triangles: shaken_mesh(64.0, 9, hills) };
        let picture = paint(&Scene { paper: None, field: &field, shapes: &[] }, &view(Affine::IDENTITY));
        for (y, x) in (0..48).flat_map(|y| (0..64).map(move |x| (y, x))) {
            let Rgba8(exact) = blend.to_rgba8(value_at(&field, Point::new(x as f64 + 0.5, y as f64 + 0.5)));
            let found = pixel(&picture, x, y);
            let difference = (0..4).map(|c| found[c].abs_diff(exact[c])).max();
            assert!(difference <= Some(1), "{blend:?} {x} {y}: {found:?} {exact:?}");
        }
    }
}

/// The field's colour at a point, straight from the definition.
fn value_at(field: &Field, p: Point) -> [f64; 4] {
    let weights = |t: &FieldTriangle| {
        let [a, b, c] = t.corners.map(|[x, y]| Point::new(x.into(), y.into()));
        let area = (b - a).cross(c - a);
        [(c - b).cross(p - b) / area, (a - c).cross(p - c) / area, (b - a).cross(p - a) / area]
    };
    let holds = |t: &&FieldTriangle| weights(t).iter().all(|&w| w >= -1e-9);
    let triangle = field.triangles.iter().find(holds).expect("the mesh covers the picture");
    let [u, v, w] = weights(triangle);
    let shares = [
        u * (2.0 * u - 1.0),
        v * (2.0 * v - 1.0),
        w * (2.0 * w - 1.0),
        4.0 * u * v,
        4.0 * v * w,
        4.0 * w * u,
    ];
    [0, 1, 2, 3].map(|c| triangle.colors.iter().zip(shares).map(|(color, s)| f64::from(color[c]) * s).sum())
}

#[test]
fn solver_noise_does_not_move_a_picked_colour() {
    let [l, a, b, _] = Blend::Oklab.from_srgb8(GREEN);
    let noisy = |[x, y]: [f64; 2]| [l, a, b].map(|c| (c + 3e-6 * (x * 1.7 + y * 2.3).sin()) as f32);
    let picture = painted(shaken_mesh(64.0, 20, noisy), &[], None, view(Affine::IDENTITY));
    assert!(picture.rgba.as_chunks().0.iter().all(|p| *p == opaque(GREEN)));
}

#[test]
fn slivers_stay_within_their_colours() {
    let ramp = |[x, y]: [f64; 2]| [(0.5 + 0.004 * x) as f32, (0.001 * y) as f32, 0.0];
    let mut triangles = shaken_mesh(64.0, 4, ramp);
    for i in 0..40 {
        let y = 1.0 + i as f32;
        let colors = |[x, _]: [f64; 2]| [if x > 30.0 { 1.0 } else { 0.0 }, 0.0, 0.0];
        triangles.push(colored([[0.0, y], [64.0, y + 0.7], [31.0, y + 0.35 + 1e-5]], ALL_SIDES, colors));
    }
    let picture = painted(triangles, &[], Some(WHITE), view(Affine::IDENTITY));
    for pixel in picture.rgba.as_chunks::<4>().0 {
        let spread = pixel[0].abs_diff(pixel[2]);
        assert!(spread < 40 && pixel[3] == 255, "{pixel:?}");
    }
}

#[test]
fn an_edge_is_at_most_two_pixels_wide_at_any_zoom() {
    for zoom in [1.0, 8.0, 64.0, 1e4] {
        let px_from_du =
            Affine::translate((30.3, 20.0)) * Affine::scale(zoom) * Affine::translate((-500.0, -500.0));
        let picture =
            painted(rectangle([500.0, 900.0], [100.0, 900.0], RED).to_vec(), &[], None, view(px_from_du));
        let soft = (0..64).filter(|&x| !matches!(pixel(&picture, x, 20)[3], 0 | 255)).count();
        assert!(soft <= 2, "{soft} at {zoom}");
        assert_eq!(pixel(&picture, 29, 20), [0; 4], "{zoom}");
        assert_eq!(pixel(&picture, 31, 20), opaque(RED), "{zoom}");
    }
}

#[test]
fn enormous_zoom_and_corners_far_outside_are_harmless() {
    for zoom in [1e6, 1e12, 1e30] {
        let px_from_du = Affine::scale(zoom) * Affine::translate((-500.0, -500.0));
        let square = rectangle([400.0, 600.0], [400.0, 600.0], RED).to_vec();
        let picture = painted(square, &[], None, view(px_from_du));
        assert!(picture.rgba.as_chunks().0.iter().all(|p| *p == opaque(RED)), "{zoom}");
    }
    for far in [f32::MAX, f32::INFINITY, f32::NAN] {
        let broken = flat([[far, -far], [3.0, 4.0], [-far, 9.0]], RED, ALL_SIDES);
        let shape = Shape { triangles: [broken.corners].into(), color: Rgba8([0, 0, 0, 255]) };
        painted(vec![broken], &[shape], None, view(Affine::scale(3.0)));
    }
}

#[test]
fn a_picture_without_pixels_is_empty() {
    let shape =
        Shape { triangles: [[[-9.0, -9.0], [9.0, -9.0], [0.0, 9.0]]].into(), color: Rgba8([0, 0, 0, 255]) };
    for (width_px, height_px) in [(0, 0), (0, 9), (9, 0)] {
        let view = View { px_from_du: Affine::IDENTITY, width_px, height_px };
        let square = rectangle([-5.0, 5.0], [-5.0, 5.0], RED).to_vec();
        assert!(painted(square, std::slice::from_ref(&shape), None, view).rgba.is_empty());
    }
}

fn square_shape(x: f32, y: f32, size: f32, color: [u8; 4]) -> Shape {
    let [a, b, c, d] = [[x, y], [x + size, y], [x + size, y + size], [x, y + size]];
    Shape { triangles: [[a, b, c], [d, c, a]].into(), color: Rgba8(color) }
}

#[test]
fn the_triangles_of_a_shape_are_painted_once_where_they_overlap() {
    let [small, large] = [(4.0, 20.5), (10.0, 30.0)].map(|(at, size)| square_shape(at, at, size, [0; 4]));
    let triangles = [&*small.triangles, &large.triangles].concat().into();
    let shape = Shape { triangles, color: Rgba8([0, 0, 0, 128]) };
    let picture = painted(vec![], &[shape], Some(WHITE), view(Affine::IDENTITY));
    for (x, y) in [(5, 5), (15, 15), (23, 23), (30, 30)] {
        assert_eq!(pixel(&picture, x, y), [127, 127, 127, 255], "{x} {y}");
    }
    assert_eq!(pixel(&picture, 24, 5), [191, 191, 191, 255]);
    assert_eq!(pixel(&picture, 30, 5), [255; 4]);
}

#[test]
fn later_shapes_lie_over_earlier_ones_and_over_the_field() {
    let shapes =
        [square_shape(10.0, 10.0, 20.0, [0, 0, 255, 255]), square_shape(20.0, 20.0, 20.0, [0, 0, 0, 51])];
    let field = rectangle([0.0, 40.0], [0.0, 40.0], RED).to_vec();
    let picture = painted(field, &shapes, None, view(Affine::IDENTITY));
    assert_eq!(pixel(&picture, 5, 5), opaque(RED));
    assert_eq!(pixel(&picture, 15, 15), [0, 0, 255, 255]);
    assert_eq!(pixel(&picture, 25, 25), [0, 0, 204, 255]);
    assert_eq!(pixel(&picture, 35, 35), [184, 20, 60, 255]);
}

#[test]
fn shapes_on_a_transparent_picture_keep_their_colour() {
    let shapes =
        [square_shape(10.5, 10.0, 20.0, [200, 100, 50, 102]), square_shape(20.0, 10.0, 20.0, [0, 0, 0, 0])];
    let picture = painted(vec![], &shapes, None, view(Affine::IDENTITY));
    assert_eq!(pixel(&picture, 10, 15), [200, 100, 50, 51]);
    assert_eq!(pixel(&picture, 15, 15), [200, 100, 50, 102]);
    assert_eq!(pixel(&picture, 25, 15), [200, 100, 50, 102]);
    assert_eq!(pixel(&picture, 35, 15), [0; 4]);
}

/// The pixels of a part of a picture.
fn cut(picture: &Pixmap, part: &Part) -> Vec<u8> {
    let columns =
        |row: u32| part.columns.clone().map(move |column| pixel(picture, column as usize, row as usize));
    part.rows.clone().flat_map(columns).flatten().collect()
}

#[test]
fn what_is_painted_again_is_as_what_is_painted_once() {
    let [a, b, c] =
        [(4.0, 30), (10.5, 200), (17.2, 99)].map(|(x, c)| square_shape(x, 9.3, 21.0, [c, 7, 0, 150]));
    let x = Shape { color: Rgba8([9; 4]), ..a.clone() };
    let field = Field { blend: Blend::Srgb, triangles: rectangle([5.3, 30.0], [2.0, 28.6], RED).to_vec() };
    let (upright, turned) = (view(Affine::IDENTITY), view(Affine::rotate(0.3)));
    let part = Part { columns: 11..40, rows: 7..19 };
    let mut painter = Repainter::default();
    for (shapes, view) in [
        (vec![a.clone(), b.clone(), c.clone()], upright),
        (vec![a.clone(), c.clone(), c.clone()], upright),
        (vec![x.clone(), c.clone()], upright),
        (vec![], upright),
        (vec![b.clone(), x, a], turned),
        (vec![c, b], turned),
    ] {
        let scene = Scene { paper: None, field: &field, shapes: &shapes };
        let whole = paint(&scene, &view);
        assert_eq!(painter.paint(&scene, &view, &part).rgba, cut(&whole, &part));
        assert_eq!(painter.paint(&scene, &view, &view.whole()), whole);
    }
}

#[test]
fn half_covered_twice_is_three_quarters() {
    let shape = square_shape(10.5, 10.0, 20.0, [200, 100, 50, 255]);
    let picture = painted(vec![], &[shape.clone(), shape], None, view(Affine::IDENTITY));
    assert_eq!(pixel(&picture, 10, 15), [200, 100, 50, 192]);
}

/// From a colour on the left to nothing on the right.
fn fading(color: Srgb8) -> Vec<FieldTriangle> {
    let color = Blend::Oklab.from_srgb8(color);
    let mut triangles = shaken_mesh(64.0, 9, |_| [0.0; 3]);
    for triangle in &mut triangles {
        let [a, b, c] = triangle.corners;
        let middle = |a: [f32; 2], b: [f32; 2]| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        let nodes = [a, b, c, middle(a, b), middle(b, c), middle(c, a)];
        triangle.colors = nodes.map(|[x, _]| color.map(|c| (c * (1.0 - f64::from(x) / 64.0)) as f32));
    }
    triangles
}

#[test]
fn a_colour_that_fades_keeps_its_hue_and_lets_the_paper_through() {
    let without = painted(fading(RED), &[], None, view(Affine::IDENTITY));
    let with = painted(fading(RED), &[], Some(WHITE), view(Affine::IDENTITY));
    for (y, x) in (0..48).flat_map(|y| (0..64).map(move |x| (y, x))) {
        let opacity = 1.0 - (x as f64 + 0.5) / 64.0;
        let [r, g, b, a] = pixel(&without, x, y);
        assert!((f64::from(a) - 255.0 * opacity).abs() <= 1.0, "{x} {y}: {a}");
        assert!([r, g, b].iter().zip(RED.0).all(|(c, red)| c.abs_diff(red) <= 1), "{x} {y}: {r} {g} {b}");
        let over_white = RED.0.map(|c| opacity * f64::from(c) + (1.0 - opacity) * 255.0);
        let found = pixel(&with, x, y);
        assert!((0..3).all(|c| (f64::from(found[c]) - over_white[c]).abs() <= 2.0), "{x} {y}: {found:?}");
        assert_eq!(found[3], 255);
    }
}

#[test]
fn the_rim_of_something_faint_is_fainter_still() {
    let faint = |color: Srgb8| Blend::Oklab.from_srgb8(color).map(|c| 0.4 * c as f32);
    let mut square = rectangle([10.5, 20.0], [8.0, 30.0], RED);
    square.iter_mut().for_each(|triangle| triangle.colors = [faint(RED); 6]);
    let [r, g, b] = RED.0;
    let picture = painted(square.to_vec(), &[], None, view(Affine::IDENTITY));
    assert_eq!(pixel(&picture, 15, 20), [r, g, b, 102]);
    assert_eq!(pixel(&picture, 10, 20), [r, g, b, 51]);
    let picture = painted(square.to_vec(), &[], Some(WHITE), view(Affine::IDENTITY));
    let mixed =
        |opacity: f64| RED.0.map(|c| (f64::from(c) * opacity + 255.0 * (1.0 - opacity)).round() as u8);
    assert_eq!(pixel(&picture, 15, 20)[..3], mixed(0.4));
    assert_eq!(pixel(&picture, 10, 20)[..3], mixed(0.2));
}

#[test]
fn colours_of_a_part_are_those_of_the_whole_wherever_it_begins() {
    let at = |[x, y]: [f64; 2]| {
        [0.3 + x * y / 90_000.0, 0.1 - x * x / 400_000.0, y / 3_000.0 - 0.05].map(|c| c as f32)
    };
    let mesh = |is_clear: bool| {
        let mut triangles = shaken_mesh(200.0, 2, at);
        let colors = triangles.iter_mut().flat_map(|triangle| &mut triangle.colors);
        colors.filter(|_| is_clear).for_each(|color| *color = color.map(|c| 0.6 * c));
        triangles
    };
    let view = View { px_from_du: Affine::scale(3.7), width_px: 700, height_px: 700 };
    for triangles in [mesh(false), mesh(true)] {
        let whole = painted(triangles.clone(), &[], Some(WHITE), view);
        for first in (1..700).step_by(13) {
            let part = view.part(&Part { columns: first..700, rows: 0..700 });
            let part = painted(triangles.clone(), &[], Some(WHITE), part);
            let rows = whole.rgba.chunks(4 * 700).zip(part.rgba.chunks(4 * (700 - first as usize)));
            assert!(
                rows.into_iter().all(|(all, some)| &all[4 * first as usize..] == some),
                "from column {first}"
            );
        }
    }
}
