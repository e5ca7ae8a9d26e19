//! Both solvers against solutions of Laplace's equation that are known in closed form, through the planar map of
//! real curves.
//!
//! Values run from 0 to 1; errors are in levels, of which there are 255. Nodes on curves lie on the lattice of the
//! planar map. That alone moves values by up to some hundredths of a level, whatever the mesh, so the fall of errors
//! with the mesh width is looked at where they are larger.

mod grid;
mod problem;

use std::f64::consts::{FRAC_PI_2, PI, TAU};
use std::iter;

use kurbo::{Arc, BezPath, Circle, Line, Point, Rect, Shape, Vec2};
use problem::{Problem, at, value_at};

const CENTRE: Point = Point::new(512.0, 512.0);

/// Spacing of nodes along curves of the default mesh.
const DEFAULT_DU: f64 = 4.0;

fn circle(centre: Point, radius_du: f64) -> BezPath {
    Circle::new(centre, radius_du).to_path(1e-6)
}

fn line(a: (f64, f64), b: (f64, f64)) -> BezPath {
    Line::new(a, b).to_path(1e-6)
}

fn polar(p: Point) -> (f64, f64) {
    ((p - CENTRE).hypot(), (p - CENTRE).atan2())
}

fn centre_at(r: f64, theta: f64) -> Point {
    CENTRE + r * Vec2::from_angle(theta)
}

/// Circles of radius `r` (value 0) and `big` (value 1) around the centre: the logarithm of the radius.
fn annulus(r: f64, big: f64, check: impl Fn(&Problem<'_>)) {
    check(&Problem {
        curves: vec![circle(CENTRE, r), circle(CENTRE, big)],
        side: &|curve, _, beside| (r..big).contains(&polar(beside).0).then_some(curve as f64),
        exact: &|p, _| (polar(p).0 / r).ln() / (big / r).ln(),
    });
}

#[test]
fn annulus_is_the_logarithm_of_the_radius() {
    for (r, big) in [(100.0, 400.0), (200.0, 400.0), (30.0, 400.0)] {
        annulus(r, big, |problem| assert_level(problem.largest_error(DEFAULT_DU), 0.3));
    }
    annulus(100.0, 400.0, |problem| problem.assert_falls(&[3.0, 1.5], 0.25));
    // Below 1 du the lattice that nodes are put on counts for more.
    annulus(100.0, 400.0, |problem| problem.assert_falls(&[6.0, 1.5], 1.0 / 16.0));
}

/// A circle with the colour of a wave with `k` crests along it.
fn disk(radius: f64, k: i32, check: impl Fn(&Problem<'_>)) {
    let wave = |theta: f64| (f64::from(k) * theta).cos();
    check(&Problem {
        curves: vec![circle(CENTRE, radius)],
        side: &|_, p, beside| (polar(beside).0 < radius).then(|| 0.5 + 0.5 * wave(polar(p).1)),
        exact: &|p, _| 0.5 + 0.5 * (polar(p).0 / radius).powi(k) * wave(polar(p).1),
    });
}

#[test]
fn waves_along_a_circle_fade_inwards_as_powers_of_the_radius() {
    for k in 1..=5 {
        for radius in [200.0, 300.0, 450.0] {
            disk(radius, k, |problem| assert_level(problem.largest_error(DEFAULT_DU), 0.3));
        }
    }
    for k in 4..=5 {
        disk(450.0, k, |problem| problem.assert_falls(&[12.0, 6.0, 3.0], 0.25));
    }
}

fn parallel_lines(check: impl Fn(&Problem<'_>)) {
    check(&Problem {
        curves: vec![line((0.0, 300.0), (1024.0, 300.0)), line((0.0, 700.0), (1024.0, 700.0))],
        side: &|curve, _, beside| (300.0..700.0).contains(&beside.y).then_some(curve as f64),
        exact: &|p, _| (p.y - 300.0) / 400.0,
    });
}

#[test]
fn between_two_parallel_lines_is_linear() {
    parallel_lines(|problem| assert_level(problem.largest_error(DEFAULT_DU), 1e-3));
}

/// Circles around (0, 0) and (d, 0). A Möbius map that takes the two points that are inverse to each other in
/// both circles to zero and infinity makes the circles concentric.
fn eccentric_annuli(check: impl Fn(&Problem<'_>)) {
    for (big, r, d) in [(400.0_f64, 100.0_f64, 150.0_f64), (450.0, 200.0, 200.0), (300.0, 100.0, 150.0)] {
        let sum = (big * big - r * r + d * d) / d;
        let root = (sum * sum - 4.0 * big * big).sqrt();
        let inverse = [0.5 * (sum - root), 0.5 * (sum + root)].map(|x| CENTRE + Vec2::new(x, 0.0));
        let log = |p: Point| (p.distance(inverse[0]) / p.distance(inverse[1])).ln();
        let inner = CENTRE + Vec2::new(d, 0.0);
        let [outside, inside] = [log(CENTRE + Vec2::new(big, 0.0)), log(inner + Vec2::new(r, 0.0))];
        let within = |p: Point| p.distance(CENTRE) < big && p.distance(inner) > r;
        check(&Problem {
            curves: vec![circle(CENTRE, big), circle(inner, r)],
            side: &|curve, _, beside| within(beside).then_some(curve as f64),
            exact: &|p, _| (log(p) - outside) / (inside - outside),
        });
    }
}

#[test]
fn eccentric_annulus_is_a_mobius_image_of_a_concentric_one() {
    eccentric_annuli(|problem| assert_level(problem.largest_error(DEFAULT_DU), 0.3));
}

#[test]
fn errors_fall_faster_where_sides_are_straight() {
    let exact = |p: Point| 0.5 + 0.5 * ((p.y - 1000.0) / 150.0).exp() * (p.x / 150.0).cos();
    let problem = Problem {
        curves: vec![Rect::new(100.0, 100.0, 900.0, 900.0).to_path(1e-6)],
        side: &|_, p, beside| Rect::new(100.0, 100.0, 900.0, 900.0).contains(beside).then(|| exact(p)),
        exact: &|p, _| exact(p),
    };
    problem.assert_falls(&[6.0, 3.0, 1.5], 0.2);
}

/// A sector of the disk with edges of value 0. At an angle above π the slope at the apex is infinite.
fn wedge(angle: f64, check: impl Fn(&Problem<'_>)) {
    let radius = 400.0;
    let turn = |p: Point| polar(p).1.rem_euclid(TAU);
    let exact = |p: Point| {
        let theta = if turn(p) > 0.5 * (TAU + angle) { 0.0 } else { turn(p).min(angle) };
        (polar(p).0 / radius).powf(PI / angle) * (PI * theta / angle).sin()
    };
    let arc = Arc::new(CENTRE, (radius, radius), 0.0, angle, 0.0).to_path(1e-6);
    let edge = |theta: f64| line(CENTRE.into(), centre_at(radius, theta).into());
    let within = |p: Point| polar(p).0 < radius && turn(p) < angle;
    check(&Problem {
        curves: vec![arc, edge(0.0), edge(angle)],
        side: &|_, p, beside| within(beside).then(|| exact(p)),
        exact: &|p, _| exact(p),
    });
}

#[test]
fn wedge_is_a_power_of_the_radius() {
    for (angle, levels) in [(FRAC_PI_2, 0.05), (2.0 * FRAC_PI_2 / 1.5, 0.1), (1.5 * PI, 0.4)] {
        wedge(angle, |problem| assert_level(problem.largest_error(DEFAULT_DU), levels));
    }
}

/// The angle of a point in `−π..=π`; on the cut, of the side that is meant.
fn angle_beside(p: Point, beside: Point) -> f64 {
    polar(p).1.abs().copysign(if p.y == CENTRE.y { beside.y - CENTRE.y } else { p.y - CENTRE.y })
}

/// A disk cut from its centre to the left. The slope at the tip of the cut is infinite: between the nodes of the triangles there the
/// error falls slowly.
fn slit(exact: impl Fn(f64, f64) -> f64, is_colored: impl Fn(f64) -> bool, check: impl Fn(&Problem<'_>)) {
    let radius = 400.0;
    let exact = |p: Point, beside: Point| exact((polar(p).0 / radius).sqrt(), angle_beside(p, beside));
    let colored =
        |curve: usize, beside: Point| polar(beside).0 < radius && (curve == 0 || is_colored(polar(beside).1));
    check(&Problem {
        curves: vec![circle(CENTRE, radius), line(CENTRE.into(), centre_at(radius, PI).into())],
        side: &|curve, p, beside| colored(curve, beside).then(|| exact(p, beside)),
        exact: &exact,
    });
}

/// Checks the errors at a tip, and more than 60 du from it.
fn assert_levels_at_tip(problem: &Problem<'_>, tip: Point, at_levels: f64, beyond_levels: f64) {
    assert_level(problem.largest_error(DEFAULT_DU), at_levels);
    assert_level(problem.largest_error_where(DEFAULT_DU, |p| p.distance(tip) > 60.0), beyond_levels);
}

fn coloured_slit(check: impl Fn(&Problem<'_>)) {
    slit(|root, angle| root * (0.5 * angle).cos().max(0.0), |_| true, check);
}

fn barrier_slit(check: impl Fn(&Problem<'_>)) {
    slit(|root, angle| 0.5 + 0.5 * root * (0.5 * angle).sin(), |_| false, check);
}

/// The upper side of the cut has a colour, the lower one has none: the fourth root is the worst that two sides can make.
fn half_coloured_slit(check: impl Fn(&Problem<'_>)) {
    slit(|root, angle| root.sqrt() * (0.25 * (angle + PI)).sin(), |angle| angle < 0.0, check);
}

#[test]
fn tip_of_a_coloured_slit_is_the_real_part_of_a_root() {
    coloured_slit(|problem| assert_levels_at_tip(problem, CENTRE, 2.5, 0.1));
}

#[test]
fn tip_of_a_barrier_is_the_imaginary_part_of_a_root() {
    barrier_slit(|problem| assert_levels_at_tip(problem, CENTRE, 1.0, 0.05));
}

#[test]
fn tip_of_a_slit_with_one_coloured_side_is_the_imaginary_part_of_a_fourth_root() {
    half_coloured_slit(|problem| assert_levels_at_tip(problem, CENTRE, 15.0, 0.5));
}

/// Flow along a wall, over a barrier of height h that stands on it: the real part of √(z² + h²).
fn half_plane_with_a_barrier(check: impl Fn(&Problem<'_>, Point)) {
    let (foot, h) = (Point::new(512.0, 900.0), 300.0);
    let half_plane = Rect::new(112.0, 100.0, 912.0, foot.y);
    let exact = |p: Point, beside: Point| {
        let (x, y) = (p.x - foot.x, p.y - foot.y);
        let (re, im) = (x * x - y * y + h * h, 2.0 * x * y);
        let root = (0.5 * (re.hypot(im) + re)).max(0.0).sqrt();
        0.5 + root.copysign(if x == 0.0 { beside.x - foot.x } else { x }) / 1800.0
    };
    let problem = Problem {
        curves: vec![
            line((half_plane.x0, foot.y), (half_plane.x1, foot.y)),
            line(foot.into(), (foot.x, foot.y - h)),
            BezPath::from_svg("M112 900V100H912V900").expect("a path"),
        ],
        side: &|curve, p, beside| (curve == 2 && half_plane.contains(beside)).then(|| exact(p, beside)),
        exact: &exact,
    };
    check(&problem, Point::new(foot.x, foot.y - h));
}

#[test]
fn half_plane_with_a_barrier_is_a_root() {
    half_plane_with_a_barrier(|problem, tip| assert_levels_at_tip(problem, tip, 0.5, 0.03));
}

/// A corridor to and fro across the page, with colours at its ends alone: nowhere else does rounding add up as much.
#[test]
fn along_a_corridor_of_thirty_two_bends_values_rise_evenly() {
    let width_du = 1024.0 / 33.0;
    let wall = |k: usize| {
        let (y, start) = (k as f64 * width_du, if k.is_multiple_of(2) { width_du } else { 0.0 });
        line((start, y), (start + 1024.0 - width_du, y))
    };
    let problem = Problem {
        curves: iter::once(Rect::new(0.0, 0.0, 1024.0, 1024.0).to_path(1e-6))
            .chain((1..33).map(wall))
            .collect(),
        side: &|curve, at, _| match curve {
            0 if at.x == 0.0 && at.y < width_du => Some(0.0),
            0 if at.x == 1024.0 && at.y > 1024.0 - width_du => Some(1.0),
            _ => None,
        },
        exact: &|_, _| f64::NAN,
    };
    let field = problem.solve(DEFAULT_DU);
    let middle = |k: usize| value_at(&field, Point::new(512.0, (k as f64 + 0.5) * width_du));
    let step = (middle(31) - middle(1)) / 30.0;
    for k in 1..32 {
        let error = middle(k) - (0.5 + (k as f64 - 16.0) * step);
        assert_level(255.0 * error.abs(), 0.02);
    }
}

/// The colours of a diagonal's sides at a place: its lower left and its upper right one.
fn diagonal_color(beside: Point) -> f64 {
    [0.123_456_789, 0.987_654_321][usize::from(beside.x > beside.y)]
}

fn diagonal(check: impl Fn(&Problem<'_>)) {
    check(&Problem {
        curves: vec![line((0.0, 0.0), (1024.0, 1024.0))],
        side: &|_, _, beside| Some(diagonal_color(beside)),
        exact: &|_, beside| f64::from(diagonal_color(beside) as f32),
    });
}

#[test]
fn a_diagonal_with_two_colours_leaks_nothing_at_all() {
    diagonal(|problem| {
        for triangle in &problem.solve(DEFAULT_DU).triangles {
            let color = diagonal_color(at(triangle, [1.0 / 3.0; 3])) as f32;
            assert_eq!(triangle.colors, [[color, color, color, 1.0]; 6]);
        }
    });
}

#[track_caller]
fn assert_level(error: f64, bound: f64) {
    assert!(error <= bound, "{error} levels, {bound} allowed");
}
