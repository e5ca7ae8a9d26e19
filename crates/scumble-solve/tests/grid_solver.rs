//! The grid solver where no closed form is needed to know what is right.

use kurbo::{Affine, BezPath, Point, Rect, Shape, Vec2};
use proptest::prelude::*;
use scumble_core::{Blend, Boundary, Curve, Drawing, PlanarMap, Sampling, SideId, Srgb8};
use scumble_solve::grid::{CutLinks, GridPicture, GridSolver, JeschkeSolver};
use scumble_solve::{MeshSolver, Scene, View, paint, paint_grid};

const SIZE_PX: u32 = 64;

/// Pixels of the small pictures per du.
const SCALE: f64 = 1.0 / 16.0;

fn map(curves: &[BezPath]) -> PlanarMap {
    let curves = curves.iter().map(|path| Curve { path: path.clone(), line: None }).collect();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
    PlanarMap::build(&drawing, &Sampling::default()).expect("a map")
}

fn view(size_px: u32) -> View {
    View { px_from_du: Affine::scale(f64::from(size_px) / 1024.0), width_px: size_px, height_px: size_px }
}

/// Where a side is asked for its colour: so far beside its middle, as a part of its length. On a circle it must be more
/// than the circle is beside its chord.
const BESIDE_ROUND: f64 = 0.1;
const BESIDE_STRAIGHT: f64 = 1e-3;

/// Colours sides of curves by a place beside their middle.
fn boundary(map: &PlanarMap, part: f64, color: impl Fn(usize, Point) -> Option<f64>) -> Boundary {
    let mut sides = vec![None; map.side_count()];
    for curve in 0..map.curve_count() {
        for side in map.steps(curve).iter().flat_map(|step| [step.left, step.left.opposite()]) {
            sides[side.index()] =
                color(curve, beside(map, side, part)).map(|value| [[value, value, value, 1.0]; 3]);
        }
    }
    sides.into()
}

fn beside(map: &PlanarMap, side: SideId, part: f64) -> Point {
    let [a, b] = map.ends(side).map(|node| map.triangulation().points()[node as usize]);
    a.midpoint(b) + Vec2::new(a.y - b.y, b.x - a.x) * part
}

fn solved(map: &PlanarMap, boundary: &Boundary, size_px: u32) -> (Vec<[f32; 4]>, usize) {
    let mut solver = GridSolver::new(&CutLinks::new(map, boundary, &view(size_px)));
    let steps = solver.solve(1e-5);
    (solver.pixels().to_vec(), steps)
}

/// A closed path through the centres of pixels, and nearly so.
fn through_pixel_centers() -> impl Strategy<Value = BezPath> {
    let corner = (2..SIZE_PX - 2, 2..SIZE_PX - 2, prop_oneof![Just(0.0), Just(0.5), -0.5..0.5]);
    prop::collection::vec(corner, 3..9).prop_map(|corners| {
        let at = |(x, y, d): (u32, u32, f64)| {
            (Vec2::new(f64::from(x) + 0.5 + d, f64::from(y) + 0.5) / SCALE).to_point()
        };
        let points: Vec<_> = corners.into_iter().map(at).collect();
        let mut path = BezPath::new();
        path.move_to(points[0]);
        points[1..].iter().for_each(|&p| path.line_to(p));
        path.close_path();
        path
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    /// Both sides of a path that crosses itself, by winding number: a colour each, which no pixel mixes.
    #[test]
    fn no_colour_gets_through_a_curve(path in through_pixel_centers()) {
        let map = map(std::slice::from_ref(&path));
        let color = |p: Point| if path.winding(p) % 2 == 0 { 0.0 } else { 1.0 };
        let boundary = boundary(&map, BESIDE_STRAIGHT, |_, beside| Some(color(beside)));
        let (pixels, _) = solved(&map, &boundary, SIZE_PX);
        for pixel in pixels {
            let is_pure = pixel[3] == 0.0 || pixel[0].abs().min((1.0 - pixel[0]).abs()) < 1e-4;
            prop_assert!(is_pure, "{pixel:?}");
        }
    }
}

#[test]
fn a_region_without_a_colour_stays_paper() {
    let circles = [300.0, 700.0].map(|x| kurbo::Circle::new((x, 500.0), 150.0).to_path(1e-6));
    let map = map(&circles);
    let is_inside = |p: Point| p.distance(Point::new(300.0, 500.0)) < 150.0;
    let boundary =
        boundary(&map, BESIDE_ROUND, |curve, beside| (curve == 0 && is_inside(beside)).then_some(0.5));
    let (pixels, _) = solved(&map, &boundary, SIZE_PX);
    for (i, pixel) in (0..SIZE_PX * SIZE_PX).zip(pixels) {
        let center = Point::new(f64::from(i % SIZE_PX) + 0.5, f64::from(i / SIZE_PX) + 0.5);
        let is_colored = is_inside((center.to_vec2() / SCALE).to_point());
        assert!((pixel[3] - f32::from(u8::from(is_colored))).abs() < 1e-4, "{pixel:?} at {i}");
        assert!(is_colored || pixel == [0.0; 4], "{pixel:?} at {i}");
    }
}

/// A channel of walls without colour that winds inwards, with a colour at either end: as coarse cells become wider than
/// the channel, many of its turns lie in one cell.
#[test]
fn a_spiral_of_barriers_is_solved_in_few_steps() {
    let turns = 6_u32;
    let center = Vec2::new(512.0, 512.0);
    let at = |i: u32| {
        let angle = f64::from(i) * std::f64::consts::TAU / 96.0;
        (center + (20.0 + 460.0 * f64::from(i) / f64::from(96 * turns)) * Vec2::from_angle(angle)).to_point()
    };
    let mut spiral = BezPath::new();
    spiral.move_to(at(0));
    (1..=96 * turns).for_each(|i| spiral.line_to(at(i)));
    let ends = [kurbo::Circle::new((512.0, 512.0), 10.0), kurbo::Circle::new((512.0, 512.0), 500.0)];
    let map = map(&[spiral, ends[0].to_path(1e-6), ends[1].to_path(1e-6)]);
    let colors = [None, Some(0.0), Some(1.0)];
    let (pixels, steps) = solved(&map, &boundary(&map, BESIDE_ROUND, |curve, _| colors[curve]), 256);
    assert!(steps <= 14, "{steps} steps");
    let value = |radius_px: usize| pixels[128 * 256 + 128 + radius_px][0];
    let along: Vec<_> = (10..112).step_by(10).map(value).collect();
    assert!(along.windows(2).all(|pair| pair[0] < pair[1]), "{along:?}");
    assert!(along[0] > 0.0 && along[10] < 1.0, "{along:?}");
}

/// A disk of two colours that blend along its edge.
fn shaded_disk() -> (PlanarMap, Boundary) {
    let map = map(&[kurbo::Circle::new((512.0, 512.0), 400.0).to_path(1e-6)]);
    let boundary = boundary(&map, BESIDE_ROUND, |_, p| {
        Some(if p.distance(Point::new(512.0, 512.0)) < 400.0 { p.x / 1024.0 } else { 1.0 })
    });
    (map, boundary)
}

#[test]
fn the_same_boundary_gives_the_same_bits() {
    let (map, boundary) = shaded_disk();
    let bits =
        || solved(&map, &boundary, 100).0.into_flattened().into_iter().map(f32::to_bits).collect::<Vec<_>>();
    assert_eq!(bits(), bits());
}

#[test]
fn a_painted_grid_looks_like_the_painted_mesh_at_its_edges_too() {
    let (map, boundary) = shaded_disk();
    let view = view(128);
    let (pixels, _) = solved(&map, &boundary, 128);
    let paper = Some(Srgb8([255; 3]));
    let grid = paint_grid(&GridPicture::new(&map, &view, Blend::Srgb, pixels), &[], &view, paper);
    let mut solver = MeshSolver::new(map.refined().clone());
    let field = solver.solve(&boundary, Blend::Srgb).expect("a field");
    let mesh = paint(&Scene { paper, field, shapes: &[] }, &view);
    let worst = grid.rgba.iter().zip(&mesh.rgba).map(|(a, b)| a.abs_diff(*b)).max();
    assert!(worst <= Some(12), "{worst:?} levels");
}

#[test]
fn jeschkes_solver_comes_near_with_many_steps() {
    let (map, boundary) = shaded_disk();
    let links = CutLinks::new(&map, &boundary, &view(128));
    let error_after = |steps: usize| {
        let mut solver = JeschkeSolver::new(&links);
        (0..steps).for_each(|_| solver.step());
        let exact = solved(&map, &boundary, 128).0;
        let errors = solver.pixels().iter().zip(&exact).map(|(a, b)| f64::from((a[0] - b[0]).abs()));
        255.0 * errors.sum::<f64>() / exact.len() as f64
    };
    let errors = [0, 8, 64].map(error_after);
    assert!(errors[1] < 0.5 * errors[0] && errors[2] < errors[1] && errors[2] < 2.0, "{errors:?}");
}

#[test]
fn odd_pictures_are_solved() {
    let (map, boundary) = shaded_disk();
    for (width_px, height_px) in [(1, 1), (1, 7), (33, 2), (5, 64)] {
        let view = View { px_from_du: Affine::scale(1.0 / 16.0), width_px, height_px };
        let links = CutLinks::new(&map, &boundary, &view);
        let mut solver = GridSolver::new(&links);
        solver.solve(1e-4);
        assert!(solver.pixels().as_flattened().iter().all(|c| c.is_finite()));
        assert_eq!(JeschkeSolver::new(&links).pixels().len(), (width_px * height_px) as usize);
    }
}
