//! The grid solver where no closed form is needed to know what is right.

use kurbo::{Affine, BezPath, Point, Rect, Shape, Vec2};
use proptest::prelude::*;
use scumble_core::{Bends, Blend, Boundary, Curve, Drawing, Gap, PlanarMap, Sampling, SideId, Srgb8};
use scumble_solve::grid::{Constraints, GridPicture, GridProblem, GridSolver, JeschkeSolver, MAX_STEPS};
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
const BESIDE: f64 = 0.1;

/// Colours sides of curves by a place beside their middle.
fn boundary(map: &PlanarMap, color: impl Fn(usize, Point) -> Option<f64>) -> Boundary {
    let mut sides = vec![None; map.side_count()];
    for curve in 0..map.curve_count() {
        for side in map.steps(curve).iter().flat_map(|step| [step.left, step.left.opposite()]) {
            sides[side.index()] =
                color(curve, beside(map, side)).map(|value| [[value, value, value, 1.0]; 3]);
        }
    }
    sides.into()
}

fn beside(map: &PlanarMap, side: SideId) -> Point {
    let [a, b] = map.ends(side).map(|node| map.triangulation().points()[node as usize]);
    a.midpoint(b) + Vec2::new(a.y - b.y, b.x - a.x) * BESIDE
}

fn solved(map: &PlanarMap, boundary: &Boundary, size_px: u32) -> (Vec<[f32; 4]>, usize) {
    let mut solver = GridSolver::new(&Constraints::new(map, boundary, &view(size_px)).expect("solved"));
    let steps = solver.solve(1e-5);
    (solver.pixels(), steps)
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

    /// Each region has one of seven colours, which no pixel of another one has any of.
    #[test]
    fn no_colour_gets_through_a_curve(path in through_pixel_centers()) {
        let map = map(std::slice::from_ref(&path));
        let (region_of, _) = map.triangulation().regions();
        let value = |triangle: usize| f64::from(region_of[triangle] % 7) / 6.0;
        let (pixels, _) = solved(&map, &by_triangle(&map, value), SIZE_PX);
        for (pixel, center) in pixels.iter().zip(centers()) {
            let mut values = triangles_at(&map, center).map(value);
            let is_pure = values.any(|value| (f64::from(pixel[0]) - value).abs() < 1e-4);
            prop_assert!(is_pure, "{pixel:?} at {center}");
        }
    }

    /// Whatever sides have which colours, or none: the picture is between them, in fewer steps than there may be.
    #[test]
    fn any_sides_of_a_curve_may_have_any_colours(
        path in through_pixel_centers(),
        colors in prop::collection::vec(prop_oneof![Just(None), (0..=4_u8).prop_map(Some)], 64),
    ) {
        let map = map(std::slice::from_ref(&path));
        let color = |side: usize| colors[side % colors.len()].map(|part| [[f64::from(part) / 4.0, 0.0, 0.0, 1.0]; 3]);
        let sides: Vec<_> = (0..map.side_count()).map(color).collect();
        let (pixels, steps) = solved(&map, &sides.into(), SIZE_PX);
        prop_assert!(steps < MAX_STEPS, "{steps} steps");
        for pixel in pixels {
            let is_between = [pixel[0], pixel[3]].into_iter().all(|c| (-1e-3..=1.0 + 1e-3).contains(&c));
            prop_assert!(is_between, "{pixel:?}");
        }
    }
}

/// Gives each side the value of the triangle that it bounds.
fn by_triangle(map: &PlanarMap, value: impl Fn(usize) -> f64) -> Boundary {
    let mesh = map.triangulation();
    let mut sides = vec![None; map.side_count()];
    for (h, side) in mesh.half_edges().filter_map(|h| Some((h, mesh.side(h)?))) {
        let value = value(h.triangle());
        sides[side.index()] = Some([[value, value, value, 1.0]; 3]);
    }
    sides.into()
}

/// The triangles that a point lies in, or on the edge of.
fn triangles_at(map: &PlanarMap, p: Point) -> impl Iterator<Item = usize> {
    let mesh = map.triangulation();
    (0..mesh.triangle_count()).filter(move |&t| {
        let [a, b, c] = mesh.corners(t);
        [(a, b), (b, c), (c, a)].into_iter().all(|(a, b)| (b - a).cross(p - a) >= 0.0)
    })
}

/// The centres of the pixels of a small picture, in du.
fn centers() -> impl Iterator<Item = Point> {
    let place = |i: u32| (f64::from(i) + 0.5) / SCALE;
    (0..SIZE_PX).flat_map(move |y| (0..SIZE_PX).map(move |x| Point::new(place(x), place(y))))
}

#[test]
fn a_region_without_a_colour_stays_paper() {
    let circles = [300.0, 700.0].map(|x| kurbo::Circle::new((x, 500.0), 150.0).to_path(1e-6));
    let map = map(&circles);
    let is_inside = |p: Point| p.distance(Point::new(300.0, 500.0)) < 150.0;
    let boundary = boundary(&map, |curve, beside| (curve == 0 && is_inside(beside)).then_some(0.5));
    let (pixels, _) = solved(&map, &boundary, SIZE_PX);
    for (pixel, center) in pixels.into_iter().zip(centers()) {
        let is_colored = is_inside(center);
        assert!((pixel[3] - f32::from(u8::from(is_colored))).abs() < 1e-4, "{pixel:?} at {center}");
        assert!(is_colored || pixel == [0.0; 4], "{pixel:?} at {center}");
    }
}

/// A line between pixels, in a niche of a room whose walls have no colour.
#[test]
fn a_colour_fills_its_region_also_where_no_link_leads_to_it() {
    let room = BezPath::from_svg("M210,210 H790 V590 H786 V596 H782 V590 H210 Z").expect("a path");
    let line = BezPath::from_svg("M783,594 h2").expect("a path");
    let map = map(&[room, line]);
    let colors = [None, Some(0.5)];
    let (pixels, _) = solved(&map, &boundary(&map, |curve, _| colors[curve]), SIZE_PX);
    for (pixel, center) in pixels.into_iter().zip(centers()) {
        let is_inside = Rect::new(210.0, 210.0, 790.0, 590.0).contains(center);
        let expected = if is_inside { [0.5, 0.5, 0.5, 1.0] } else { [0.0; 4] };
        assert!((0..4).all(|c| (pixel[c] - expected[c]).abs() < 1e-4), "{pixel:?} at {center}");
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
    let (pixels, steps) = solved(&map, &boundary(&map, |curve, _| colors[curve]), 256);
    assert!(steps <= 14, "{steps} steps");
    let value = |radius_px: usize| pixels[128 * 256 + 128 + radius_px][0];
    let along: Vec<_> = (10..112).step_by(10).map(value).collect();
    assert!(along.windows(2).all(|pair| pair[0] < pair[1]), "{along:?}");
    assert!(along[0] > 0.0 && along[10] < 1.0, "{along:?}");
}

/// A disk of two colours that blend along its edge.
fn shaded_disk() -> (PlanarMap, Boundary) {
    let map = map(&[kurbo::Circle::new((512.0, 512.0), 400.0).to_path(1e-6)]);
    let boundary = boundary(&map, |_, p| {
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

/// The opacity is right at once, but for a rounding error that the first step takes away: what is left to correct is
/// smaller than numbers near one can tell.
#[test]
fn a_channel_that_is_right_stays_right_while_others_are_solved() {
    for triangle in ["M296,232 L952,984 L184,136 Z", "M424,792 L792,72 L600,744 Z"] {
        let map = map(&[BezPath::from_svg(triangle).expect("a path")]);
        let color = |i: usize| (i % 2 == 1).then_some([[(i / 2 % 2) as f64, 0.0, 0.0, 1.0]; 3]);
        let boundary = (0..map.side_count()).map(color).collect::<Vec<_>>().into();
        let mut solver = GridSolver::new(&Constraints::new(&map, &boundary, &view(SIZE_PX)).expect("solved"));
        (0..MAX_STEPS).for_each(|_| solver.step());
        for pixel in &solver.pixels() {
            assert!(pixel[3] == 0.0 || (pixel[3] - 1.0).abs() < 1e-4, "{triangle}: {pixel:?}");
        }
    }
}

/// By how many levels a painted grid of 128 px differs most from the painted mesh.
fn worst_beside_the_mesh(map: &PlanarMap, boundary: &Boundary) -> u8 {
    let view = view(128);
    let (pixels, _) = solved(map, boundary, 128);
    let paper = Some(Srgb8([255; 3]));
    let found = GridPicture::new(map, &Bends::default(), boundary, &view, Blend::Srgb, pixels);
    let grid = paint_grid(&found, &[], &view, paper);
    let mut solver = MeshSolver::new(map.refined().clone());
    let field = solver.solve(boundary, Blend::Srgb).expect("a field");
    let mesh = paint(&Scene { paper, field, shapes: &[] }, &view);
    grid.rgba.iter().zip(&mesh.rgba).map(|(a, b)| a.abs_diff(*b)).max().unwrap_or(0)
}

#[test]
fn a_painted_grid_looks_like_the_painted_mesh_at_its_edges_too() {
    let (map, boundary) = shaded_disk();
    let worst = worst_beside_the_mesh(&map, &boundary);
    assert!(worst <= 12, "{worst} levels");
}

/// A frame that a slanted wall divides, but for a gap in its middle that is closed, and passes through the centre of a pixel.
#[test]
fn a_painted_grid_has_no_stairs_at_a_closed_gap() {
    let at = |x: f64| Point::new(x, 350.0 + 0.3 * x);
    let line = |[start, end]: [f64; 2]| {
        let mut path = BezPath::new();
        path.move_to(at(start));
        path.line_to(at(end));
        path
    };
    let frame = Rect::new(101.0, 101.0, 923.0, 923.0);
    let (walls, gap) = ([[101.0, 470.0], [550.0, 923.0]].map(line), [at(470.0), at(550.0)]);
    let map = map(&[&walls[..], &[frame.to_path(1e-3)]].concat());
    let is_at = |tip: Point| move |p: &Point| p.distance(tip) < 1e-6;
    let nodes =
        gap.map(|tip| map.triangulation().points().iter().position(is_at(tip)).expect("a tip") as u32);
    let map = map.with_gaps(vec![Gap { nodes, is_wide: false, is_plain: false, is_slight: false }]);
    let sides = boundary(&map, |_, place| {
        let is_below = place.y > at(place.x).y;
        frame.contains(place).then_some(if is_below { 0.9 } else { 0.2 })
    });
    let worst = worst_beside_the_mesh(&map, &Boundary { closed_gaps: vec![true], ..sides });
    assert!(worst <= 12, "{worst} levels");
}

#[test]
fn jeschkes_solver_comes_near_with_many_steps() {
    let (map, boundary) = shaded_disk();
    let constraints = Constraints::new(&map, &boundary, &view(128)).expect("solved");
    let error_after = |steps: usize| {
        let mut solver = JeschkeSolver::new(&constraints);
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
        let constraints = Constraints::new(&map, &boundary, &view).expect("solved");
        let mut solver = GridSolver::new(&constraints);
        solver.solve(1e-4);
        assert!(solver.pixels().as_flattened().iter().all(|c| c.is_finite()));
        assert_eq!(JeschkeSolver::new(&constraints).pixels().len(), (width_px * height_px) as usize);
    }
}

/// A channel without colours that is narrower than a pixel of the whole, and passes through a part: the whole has nothing for
/// what is in it, and much for what is beside it.
#[test]
fn a_part_takes_nothing_from_where_nothing_is_seen_of_the_whole() {
    let line = |y: f64| {
        let mut path = BezPath::new();
        path.move_to((100.0, y));
        path.line_to((900.0, y));
        path
    };
    let map = map(&[line(503.0), line(505.0)]);
    let boundary = Boundary::from(vec![None; map.side_count()]);
    let whole = GridProblem::new(&map, &boundary, &view(256), Blend::Oklab).expect("a whole");
    let px_from_du = Affine::scale(8.0) * Affine::translate((-492.0, -492.0));
    let part_view = View { px_from_du, width_px: 160, height_px: 160 };
    let part = whole.part(&map, &Bends::default(), &boundary, &part_view);
    let rows: Vec<_> = part.constraints.exits.iter().map(|exits| exits.pixel / 160).collect();
    let in_channel = 88..104;
    assert!(rows.iter().all(|row| !in_channel.contains(row)), "{rows:?}");
    assert!(rows.len() > 2 * 160 + 2 * 100, "the rest of the border has its links");
}
