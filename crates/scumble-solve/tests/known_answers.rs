//! The mesh solver against solutions of Laplace's equation that are known in closed form, through the planar map of
//! real curves.
//!
//! Values run from 0 to 1; errors are in levels, of which there are 255. Nodes on curves lie on the lattice of the
//! planar map. That alone moves values by up to some hundredths of a level, whatever the mesh, so the fall of errors
//! with the mesh width is looked at where they are larger.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use kurbo::{Arc, BezPath, Circle, Line, Point, Rect, Shape, Vec2};
use scumble_core::{Blend, Boundary, Curve, Drawing, PlanarMap, Sampling};
use scumble_solve::{Field, FieldTriangle, MeshSolver};

const CENTRE: Point = Point::new(512.0, 512.0);

/// Spacing of nodes along curves of the default mesh.
const DEFAULT_DU: f64 = 3.0;

/// Curves on a page, the colours of their sides, and the values in between.
///
/// Both functions take a point and another one to the side of it that is meant, for points on a curve where the
/// value jumps.
struct Problem<'a> {
    curves: Vec<BezPath>,
    /// The value along a side of a curve (0, 1, …); `None` for no colour.
    side: &'a dyn Fn(usize, Point, Point) -> Option<f64>,
    exact: &'a dyn Fn(Point, Point) -> f64,
}

impl Problem<'_> {
    fn solve(&self, spacing_du: f64) -> Field {
        let curves = self.curves.iter().map(|path| Curve { path: path.clone(), line: None }).collect();
        let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
        let chord_du = Sampling::default().chord_du * spacing_du / DEFAULT_DU;
        let map = PlanarMap::build(&drawing, &Sampling { spacing_du, chord_du }).expect("a map");
        let mut solver = MeshSolver::new(map.refined().clone());
        solver.solve(&self.boundary(&map), Blend::Srgb).expect("a field").clone()
    }

    fn boundary(&self, map: &PlanarMap) -> Boundary {
        let mut colors = vec![None; map.side_count()];
        for curve in 0..map.curve_count() {
            for side in map.steps(curve).iter().flat_map(|step| [step.left, step.left.opposite()]) {
                let [a, b] = map.ends(side).map(|node| map.triangulation().points()[node as usize]);
                let left = a.midpoint(b) + Vec2::new(a.y - b.y, b.x - a.x) * 0.1;
                let [start, middle, end] = [a, a.midpoint(b), b].map(|at| (self.side)(curve, at, left));
                colors[side.index()] = start
                    .zip(middle)
                    .zip(end)
                    .map(|((start, middle), end)| [start, middle, end].map(|v| [v, v, v, 1.0]));
            }
        }
        colors.into()
    }

    /// The largest error at the nodes of the field and at points within its triangles.
    fn largest_error(&self, spacing_du: f64) -> f64 {
        self.largest_error_where(spacing_du, |_| true)
    }

    fn largest_error_where(&self, spacing_du: f64, place: impl Fn(Point) -> bool) -> f64 {
        let field = self.solve(spacing_du);
        assert!(!field.triangles.is_empty());
        let error = |triangle: &FieldTriangle| {
            let inside = at(triangle, [1.0 / 3.0; 3]);
            let samples = samples(triangle).into_iter().filter(|(p, _)| place(*p));
            samples.map(|(p, value)| 255.0 * (value - (self.exact)(p, inside)).abs()).fold(0.0, f64::max)
        };
        field.triangles.iter().map(error).fold(0.0, f64::max)
    }

    /// Checks that the error falls to this part of itself, or less, each time the mesh width is halved.
    fn assert_falls(&self, spacings_du: &[f64], part: f64) {
        let errors: Vec<_> = spacings_du.iter().map(|&spacing_du| self.largest_error(spacing_du)).collect();
        assert!(errors.windows(2).all(|pair| pair[1] <= part * pair[0]), "{errors:?}");
    }
}

/// The value of a triangle at its corners, in the middle of its edges, and at ten points between.
fn samples(triangle: &FieldTriangle) -> Vec<(Point, f64)> {
    let mut weights = vec![[1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0]];
    for [a, b, c] in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
        for (wa, wb, wc) in [(1.0, 0.0, 0.0), (0.5, 0.5, 0.0), (0.75, 0.125, 0.125), (0.625, 0.375, 0.0)] {
            let mut weight = [0.0; 3];
            (weight[a], weight[b], weight[c]) = (wa, wb, wc);
            weights.push(weight);
        }
    }
    weights.into_iter().map(|weight| (at(triangle, weight), value(triangle, weight))).collect()
}

fn at(triangle: &FieldTriangle, weight: [f64; 3]) -> Point {
    let corners = triangle.corners.map(|[x, y]| Vec2::new(x.into(), y.into()));
    (weight[0] * corners[0] + weight[1] * corners[1] + weight[2] * corners[2]).to_point()
}

fn value(triangle: &FieldTriangle, [a, b, c]: [f64; 3]) -> f64 {
    let shape = [
        a * (2.0 * a - 1.0),
        b * (2.0 * b - 1.0),
        c * (2.0 * c - 1.0),
        4.0 * a * b,
        4.0 * b * c,
        4.0 * c * a,
    ];
    shape.iter().zip(triangle.colors).map(|(shape, color)| shape * f64::from(color[0])).sum()
}

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
    annulus(100.0, 400.0, |problem| problem.assert_falls(&[3.0, 0.75], 1.0 / 16.0));
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

#[test]
fn between_two_parallel_lines_is_linear() {
    let problem = Problem {
        curves: vec![line((0.0, 300.0), (1024.0, 300.0)), line((0.0, 700.0), (1024.0, 700.0))],
        side: &|curve, _, beside| (300.0..700.0).contains(&beside.y).then_some(curve as f64),
        exact: &|p, _| (p.y - 300.0) / 400.0,
    };
    assert_level(problem.largest_error(DEFAULT_DU), 1e-4);
}

/// Circles around (0, 0) and (d, 0). A Möbius map that takes the two points that are inverse to each other in
/// both circles to zero and infinity makes the circles concentric.
#[test]
fn eccentric_annulus_is_a_mobius_image_of_a_concentric_one() {
    for (big, r, d) in [(400.0_f64, 100.0_f64, 150.0_f64), (450.0, 200.0, 200.0), (300.0, 100.0, 150.0)] {
        let sum = (big * big - r * r + d * d) / d;
        let root = (sum * sum - 4.0 * big * big).sqrt();
        let inverse = [0.5 * (sum - root), 0.5 * (sum + root)].map(|x| CENTRE + Vec2::new(x, 0.0));
        let log = |p: Point| (p.distance(inverse[0]) / p.distance(inverse[1])).ln();
        let inner = CENTRE + Vec2::new(d, 0.0);
        let [outside, inside] = [log(CENTRE + Vec2::new(big, 0.0)), log(inner + Vec2::new(r, 0.0))];
        let within = |p: Point| p.distance(CENTRE) < big && p.distance(inner) > r;
        let problem = Problem {
            curves: vec![circle(CENTRE, big), circle(inner, r)],
            side: &|curve, _, beside| within(beside).then_some(curve as f64),
            exact: &|p, _| (log(p) - outside) / (inside - outside),
        };
        assert_level(problem.largest_error(DEFAULT_DU), 0.3);
    }
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
#[test]
fn wedge_is_a_power_of_the_radius() {
    let radius = 400.0;
    for (angle, levels) in [(FRAC_PI_2, 0.05), (2.0 * FRAC_PI_2 / 1.5, 0.1), (1.5 * PI, 1.5)] {
        let turn = |p: Point| polar(p).1.rem_euclid(TAU);
        let exact = |p: Point| {
            let theta = if turn(p) > 0.5 * (TAU + angle) { 0.0 } else { turn(p).min(angle) };
            (polar(p).0 / radius).powf(PI / angle) * (PI * theta / angle).sin()
        };
        let arc = Arc::new(CENTRE, (radius, radius), 0.0, angle, 0.0).to_path(1e-6);
        let edge = |theta: f64| line(CENTRE.into(), centre_at(radius, theta).into());
        let within = |p: Point| polar(p).0 < radius && turn(p) < angle;
        let problem = Problem {
            curves: vec![arc, edge(0.0), edge(angle)],
            side: &|_, p, beside| within(beside).then(|| exact(p)),
            exact: &|p, _| exact(p),
        };
        assert_level(problem.largest_error(DEFAULT_DU), levels);
    }
}

/// The angle of a point in `−π..=π`; on the cut, of the side that is meant.
fn angle_beside(p: Point, beside: Point) -> f64 {
    polar(p).1.abs().copysign(if p.y == CENTRE.y { beside.y - CENTRE.y } else { p.y - CENTRE.y })
}

/// A disk cut from its centre to the left. The slope at the tip of the cut is infinite: the error falls slowly.
fn slit(exact: impl Fn(f64, f64) -> f64, colored_slit: bool, check: impl Fn(&Problem<'_>)) {
    let radius = 400.0;
    let exact = |p: Point, beside: Point| exact((polar(p).0 / radius).sqrt(), angle_beside(p, beside));
    let colored = |curve: usize, beside: Point| polar(beside).0 < radius && (curve == 0 || colored_slit);
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

#[test]
fn tip_of_a_coloured_slit_is_the_real_part_of_a_root() {
    let exact = |root: f64, angle: f64| root * (0.5 * angle).cos().max(0.0);
    slit(exact, true, |problem| assert_levels_at_tip(problem, CENTRE, 8.0, 1.0));
}

#[test]
fn tip_of_a_barrier_is_the_imaginary_part_of_a_root() {
    let exact = |root: f64, angle: f64| 0.5 + 0.5 * root * (0.5 * angle).sin();
    slit(exact, false, |problem| assert_levels_at_tip(problem, CENTRE, 4.0, 0.5));
}

/// Flow along a wall, over a barrier of height h that stands on it: the real part of √(z² + h²).
#[test]
fn half_plane_with_a_barrier_is_a_root() {
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
    assert_levels_at_tip(&problem, Point::new(foot.x, foot.y - h), 2.0, 0.25);
}

#[test]
fn a_diagonal_with_two_colours_leaks_nothing_at_all() {
    let above = |p: Point| p.x > p.y;
    let colors = [0.123_456_789, 0.987_654_321];
    let problem = Problem {
        curves: vec![line((0.0, 0.0), (1024.0, 1024.0))],
        side: &|_, _, beside| Some(colors[usize::from(above(beside))]),
        exact: &|_, beside| f64::from(colors[usize::from(above(beside))] as f32),
    };
    for triangle in &problem.solve(DEFAULT_DU).triangles {
        let color = colors[usize::from(above(at(triangle, [1.0 / 3.0; 3])))] as f32;
        assert_eq!(triangle.colors, [[color, color, color, 1.0]; 6]);
    }
}

#[track_caller]
fn assert_level(error: f64, bound: f64) {
    assert!(error <= bound, "{error} levels, {bound} allowed");
}
