//! Shading against solutions of its equation that are worked out along a radius or across a strip, to far below a level.
//!
//! Values run from 0 to 1; errors are in levels, of which there are 255.

use kurbo::{BezPath, Circle, Line, Point, Rect, Shape, Vec2};
use scumble_core::source::weight;
use scumble_core::{Blend, Boundary, Curve, Drawing, PlanarMap, Sampling, SoftSource};
use scumble_solve::{Field, FieldTriangle, MeshSolver};

const CENTRE: Point = Point::new(510.37, 513.71);

fn map(curves: impl IntoIterator<Item = BezPath>) -> PlanarMap {
    let curves = curves.into_iter().map(|path| Curve { path, line: None }).collect();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
    PlanarMap::build(&drawing, &Sampling::default()).expect("a map")
}

/// All sides of curves are white, all sources black.
fn solve(map: &PlanarMap, sources: &[SoftSource]) -> Field {
    let white = |piece: &scumble_core::Piece| piece.curve.map(|_| [[1.0; 4]; 3]);
    let sides = map.pieces().iter().flat_map(|piece| [white(piece); 2]).collect();
    let boundary = Boundary { sides, sources: sources.to_vec(), ..Boundary::default() };
    MeshSolver::new(map.refined().clone()).solve(&boundary, Blend::Srgb).expect("a field").clone()
}

fn source(points: &[Point], radius_du: f64, weight: f64) -> SoftSource {
    SoftSource {
        points: points.to_vec(),
        radius_du,
        weight,
        color: [0.0, 0.0, 0.0, 1.0],
        crosses: false,
        parts: Vec::new(),
    }
}

/// What a source leaves of the white, from the middle outwards: around a dab (two dimensions) or across a stroke (one), `R`
/// wide and with a line at a distance, both in du. By differences of the equation.
fn profile(dimensions: i32, radius_du: f64, line_du: f64, weight: f64) -> impl Fn(f64) -> f64 {
    const STEPS: usize = 20_000;
    let end_du = line_du.min(2.0 * radius_du);
    let step_du = end_du / STEPS as f64;
    let at = |i: usize| (i as f64 + 0.5) * step_du;
    let face = |i: usize| (i as f64 * step_du).powi(dimensions - 1);
    // Nothing at the end of the layer, no flux through a line.
    let last = if line_du < 2.0 * radius_du { 0.0 } else { 2.0 * face(STEPS) };
    let (mut ahead, mut sums) = (vec![0.0; STEPS], vec![0.0; STEPS]);
    for i in 0..STEPS {
        let length = (1.0 - 0.5 * at(i) / radius_du).max(0.125) * radius_du;
        let pull = weight * (1.0 - (at(i) / radius_du).powi(2)).max(0.0).powi(2) / radius_du.powi(2);
        let volume = step_du * step_du * at(i).powi(dimensions - 1);
        let [before, after] = [face(i), if i + 1 == STEPS { last } else { face(i + 1) }];
        let before = if i == 0 { 0.0 } else { before };
        let (came, sum) = if i == 0 { (0.0, 0.0) } else { (ahead[i - 1], sums[i - 1]) };
        let pivot = before + after + volume * (pull + length.powi(-2)) - before * came;
        ahead[i] = if i + 1 == STEPS { 0.0 } else { after / pivot };
        sums[i] = (volume * pull + before * sum) / pivot;
    }
    for i in (0..STEPS - 1).rev() {
        sums[i] += ahead[i] * sums[i + 1];
    }
    move |r| {
        let i = r / step_du - 0.5;
        if i >= STEPS as f64 - 1.0 {
            return if last > 0.0 { 1.0 } else { 1.0 - sums[STEPS - 1] };
        }
        let (i, t) = (i.max(0.0) as usize, i.max(0.0).fract());
        1.0 - (1.0 - t) * sums[i] - t * sums[i + 1]
    }
}

/// The least value at a corner of a triangle where a place is.
fn value_at(field: &Field, p: Point) -> f32 {
    let corners = field.triangles.iter().flat_map(|t| t.corners.into_iter().zip(t.colors));
    let here = corners.filter(|([x, y], _)| p.distance(Point::new((*x).into(), (*y).into())) < 1e-3);
    here.map(|(_, color)| color[0]).fold(1.0, f32::min)
}

/// Points of a triangle and the values there.
fn samples(triangle: &FieldTriangle) -> impl Iterator<Item = (Point, f64)> + '_ {
    let steps = (0..=6).flat_map(|i| (0..=6 - i).map(move |j| (f64::from(i) / 6.0, f64::from(j) / 6.0)));
    steps.map(|(u, v)| {
        let w = 1.0 - u - v;
        let [a, b, c] = triangle.corners.map(|[x, y]| Vec2::new(x.into(), y.into()));
        let shape = [
            u * (2.0 * u - 1.0),
            v * (2.0 * v - 1.0),
            w * (2.0 * w - 1.0),
            4.0 * u * v,
            4.0 * v * w,
            4.0 * w * u,
        ];
        let value = shape.iter().zip(triangle.colors).map(|(shape, color)| shape * f64::from(color[0])).sum();
        ((u * a + v * b + w * c).to_point(), value)
    })
}

/// The mean and the largest error, in levels.
fn errors(field: &Field, exact: impl Fn(Point) -> Option<f64>) -> [f64; 2] {
    let (mut sum, mut count, mut most) = (0.0, 0.0, 0.0);
    let is_inside = |t: &&FieldTriangle| {
        let [a, b, c] = t.corners.map(|[x, y]| Vec2::new(x.into(), y.into()));
        exact(((a + b + c) / 3.0).to_point()).is_some()
    };
    for (p, value) in field.triangles.iter().filter(is_inside).flat_map(samples) {
        if let Some(exact) = exact(p) {
            let error = 255.0 * (value - exact).abs();
            (sum, count, most) = (sum + error, count + 1.0, f64::max(most, error));
        }
    }
    [sum / count, most]
}

/// Errors in the mean and at most, in levels.
const BOUND: [f64; 2] = [0.2, 2.7];

fn check(what: &str, [mean, most]: [f64; 2]) {
    println!("{what}: {mean:.3} in the mean, {most:.3} at most");
    assert!(mean <= BOUND[0] && most <= BOUND[1], "{what}: {mean:.3} in the mean, {most:.3} at most");
}

#[test]
fn a_dab_is_that_of_the_radial_equation() {
    let map = map([Circle::new(CENTRE, 200.0).to_path(1e-6)]);
    for radius_du in [2.0, 12.0, 60.0, 190.0, 400.0] {
        for weight in [0.05, 0.2, 0.5, 0.8, 0.95, 1.0].map(weight) {
            let field = solve(&map, &[source(&[CENTRE], radius_du, weight)]);
            let exact = profile(2, radius_du, 200.0, weight);
            let inside = |p: Point| Some(p.distance(CENTRE)).filter(|&r| r < 200.0).map(&exact);
            check(&format!("radius {radius_du}, weight {weight}"), errors(&field, inside));
        }
    }
}

#[test]
fn a_stroke_along_a_strip_is_that_of_the_equation_across() {
    for (radius_du, half_du) in [(8.0, 40.0), (12.0, 40.0), (60.0, 70.0), (60.0, 30.0), (60.0, 10.0)] {
        let line = |y: f64| Line::new((0.0, 512.0 + y), (1024.0, 512.0 + y)).to_path(1e-6);
        let map = map([-half_du, half_du].map(line));
        for weight in [0.05, 0.2, 0.5, 0.8, 0.95, 1.0].map(weight) {
            let ends = [Point::new(-500.0, 512.0), Point::new(1500.0, 512.0)];
            let field = solve(&map, &[source(&ends, radius_du, weight)]);
            let exact = profile(1, radius_du, half_du, weight);
            let inside = |p: Point| Some((p.y - 512.0).abs()).filter(|&y| y <= half_du).map(&exact);
            check(&format!("radius {radius_du} of {half_du}, weight {weight}"), errors(&field, inside));
        }
    }
}

#[test]
fn a_dab_far_smaller_than_the_triangles_shows_at_any_of_their_corners() {
    let map = map([Circle::new(CENTRE, 400.0).to_path(1e-6)]);
    let nodes = map.refined().points().iter().filter(|p| p.distance(CENTRE) < 380.0).step_by(20);
    for &node in nodes {
        let value = value_at(&solve(&map, &[source(&[node], 0.5, weight(1.0))]), node);
        assert!(value < 0.02, "{value} at {node}");
    }
}
