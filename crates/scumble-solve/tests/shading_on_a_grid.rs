//! Shading against a solution of the same equation on a fine grid of pixels, half a du wide as those of a page of 2048².

use kurbo::{Line, ParamCurveNearest, Point, Rect, Shape, Vec2};
use scumble_core::{Blend, Boundary, Curve, Drawing, PlanarMap, Sampling, SoftSource};
use scumble_solve::{Field, MeshSolver};

/// The room that is coloured.
const ROOM: Rect = Rect::new(384.0, 384.0, 544.0, 544.0);

/// Distance of the nodes of the grid, in du.
const STEP_DU: f64 = 0.5;

/// Steps along a side of the room.
const STEPS: usize = 320;

/// The colour of the walls.
fn wall(p: Point) -> f64 {
    0.3 + 0.6 * (p.x - ROOM.x0) / ROOM.width()
}

fn place(column: usize, row: usize) -> Point {
    ROOM.origin() + STEP_DU * Vec2::new(column as f64, row as f64)
}

/// The factor of `u − c` by the definition, without any of the solver's short cuts.
fn strength(source: &SoftSource, p: Point) -> f64 {
    if !source.parts.is_empty() {
        return strength_of_dabs(source, p);
    }
    let dab = source.points.first().map(|&p| Line::new(p, p + Vec2::new(1e-9, 0.0)));
    let segments = source.points.windows(2).map(|ends| Line::new(ends[0], ends[1])).chain(dab);
    let distance_sq = segments.map(|line| line.nearest(p, 0.0).distance_sq).fold(f64::INFINITY, f64::min);
    strength_of_dab(source.weight, source.radius_du, distance_sq)
}

/// Dabs that a segment is taken for where a pen varied it.
const DABS: usize = 100;

/// The strongest of many dabs along the way.
fn strength_of_dabs(source: &SoftSource, p: Point) -> f64 {
    let segments = source.points.windows(2).zip(source.parts.windows(2));
    let dabs = segments.flat_map(|(ends, parts)| {
        (0..=DABS).map(move |i| {
            let t = i as f64 / DABS as f64;
            let [radius, strength] = [0, 1].map(|k| (1.0 - t) * parts[0][k] + t * parts[1][k]);
            let distance_sq = ends[0].lerp(ends[1], t).distance_squared(p);
            strength_of_dab(source.weight * strength.powi(3), source.radius_du * radius, distance_sq)
        })
    });
    dabs.fold(0.0, f64::max)
}

fn strength_of_dab(weight: f64, radius_du: f64, distance_sq: f64) -> f64 {
    let radius_sq = radius_du * radius_du;
    weight / radius_sq * (1.0 - distance_sq / radius_sq).max(0.0).powi(2)
}

/// The values at the nodes, row by row: five-point differences, by successive over-relaxation until nothing changes by
/// more than a thousandth of a level.
fn on_grid(sources: &[SoftSource]) -> Vec<f64> {
    let width = STEPS + 1;
    let mut values: Vec<_> = (0..width * width).map(|i| wall(place(i % width, i / width))).collect();
    let terms: Vec<_> = (0..width * width)
        .map(|i| {
            let strengths =
                sources.iter().map(|source| (strength(source, place(i % width, i / width)), source));
            let step_sq = STEP_DU * STEP_DU;
            strengths.fold([0.0, 0.0], |[sum, load], (s, source)| {
                [sum + step_sq * s, load + step_sq * s * source.color[0]]
            })
        })
        .collect();
    let omega = 2.0 / (1.0 + (std::f64::consts::PI / STEPS as f64).sin());
    loop {
        let mut largest = 0.0_f64;
        for row in 1..STEPS {
            for i in row * width + 1..row * width + STEPS {
                let around = values[i - 1] + values[i + 1] + values[i - width] + values[i + width];
                let change = omega * ((around + terms[i][1]) / (4.0 + terms[i][0]) - values[i]);
                values[i] += change;
                largest = largest.max(change.abs());
            }
        }
        if largest < 1e-3 / 255.0 / STEPS as f64 {
            return values;
        }
    }
}

fn on_mesh(sources: &[SoftSource]) -> Field {
    let curves = vec![Curve { path: ROOM.to_path(1e-6), line: None }];
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
    let map = PlanarMap::build(&drawing, &Sampling::default()).expect("a map");
    let mut sides = vec![None; map.side_count()];
    for step in map.steps(0) {
        let [a, b] = map.ends(step.left).map(|node| map.triangulation().points()[node as usize]);
        let opaque = |p: Point| [wall(p), 0.0, 0.0, 1.0];
        let colors = [a, a.midpoint(b), b].map(opaque);
        sides[step.left.index()] = Some(colors);
        sides[step.left.opposite().index()] = Some([colors[2], colors[1], colors[0]]);
    }
    let boundary = Boundary { sides, sources: sources.to_vec(), ..Boundary::default() };
    MeshSolver::new(map.refined().clone()).solve(&boundary, Blend::Srgb).expect("a field").clone()
}

/// The mean and the largest difference at the nodes of the grid, in levels.
fn differences(field: &Field, grid: &[f64]) -> [f64; 2] {
    let (mut sum, mut count, mut most) = (0.0, 0.0, 0.0);
    for triangle in &field.triangles {
        let [a, b, c] = triangle.corners.map(|[x, y]| Point::new(x.into(), y.into()));
        let bounds = Rect::from_points(a, b).union_pt(c).intersect(ROOM);
        let steps = |from: f64, to: f64| {
            ((from - ROOM.x0) / STEP_DU).ceil() as usize..=((to - ROOM.x0) / STEP_DU).floor() as usize
        };
        for (column, row) in steps(bounds.x0, bounds.x1)
            .flat_map(|column| steps(bounds.y0, bounds.y1).map(move |row| (column, row)))
        {
            let p = place(column, row);
            let area = (b - a).cross(c - a);
            let [u, v] = [(b - p).cross(c - p) / area, (c - p).cross(a - p) / area];
            let w = 1.0 - u - v;
            if u.min(v).min(w) < 0.0 {
                continue;
            }
            let corner = |t: f64| t * (2.0 * t - 1.0);
            let shape = [corner(u), corner(v), corner(w), 4.0 * u * v, 4.0 * v * w, 4.0 * w * u];
            let value: f64 =
                shape.iter().zip(triangle.colors).map(|(s, color)| s * f64::from(color[0])).sum();
            let difference = 255.0 * (value - grid[row * (STEPS + 1) + column]).abs();
            (sum, count, most) = (sum + difference, count + 1.0, f64::max(most, difference));
        }
    }
    assert!(count >= (STEPS * STEPS) as f64, "all nodes are looked at");
    [sum / count, most]
}

fn source(points: &[(f64, f64)], radius_du: f64, weight: f64, value: f64) -> SoftSource {
    let points = points.iter().copied().map(Point::from).collect();
    SoftSource { points, radius_du, weight, color: [value, 0.0, 0.0, 1.0], crosses: false, parts: Vec::new() }
}

#[test]
fn strokes_and_dabs_are_those_of_the_grid() {
    let bent = [(410.0, 500.0), (440.0, 440.0), (470.0, 430.0), (510.0, 460.0)];
    let over_walls = source(&[(380.0, 420.0), (450.0, 400.0), (550.0, 500.0)], 30.0, 80.0, 0.0);
    for sources in [
        vec![source(&bent, 20.0, 160.0, 1.0), source(&[(510.0, 510.0)], 24.0, 40.0, 0.0)],
        vec![source(&bent, 40.0, 8.0, 1.0), source(&[(400.0, 520.0), (520.0, 410.0)], 12.0, 80.0, 0.0)],
        vec![SoftSource { crosses: true, ..over_walls }],
    ] {
        let [mean, most] = differences(&on_mesh(&sources), &on_grid(&sources));
        println!("{mean:.3} in the mean, {most:.3} at most");
        assert!(mean <= 0.4 && most <= 3.0, "{mean:.3} in the mean, {most:.3} at most");
    }
}

/// A pen's radii or strengths at the points of a stroke.
fn pressed(source: SoftSource, parts: &[[f64; 2]]) -> SoftSource {
    SoftSource { parts: parts.to_vec(), ..source }
}

#[test]
fn strokes_of_a_pen_that_presses_more_or_less_are_those_of_the_grid() {
    let bent = [(410.0, 500.0), (440.0, 440.0), (470.0, 430.0), (510.0, 460.0)];
    let jerk = [(410.0, 470.0), (450.0, 450.0), (452.0, 449.0), (500.0, 470.0)];
    let radii = |parts: [f64; 4]| parts.map(|part| [part, 1.0]);
    let strengths = |parts: [f64; 4]| parts.map(|part| [1.0, part]);
    let stroke = |way: &[(f64, f64)]| source(way, 40.0, 160.0, 1.0);
    for source in [
        pressed(stroke(&bent), &radii([0.2, 1.0, 0.6, 0.2])),
        pressed(stroke(&bent), &strengths([0.0, 1.0, 0.5, 0.0])),
        pressed(stroke(&jerk), &radii([0.3, 0.3, 1.0, 0.5])),
        pressed(stroke(&jerk), &strengths([0.2, 0.2, 1.0, 0.0])),
    ] {
        let parts = source.parts.clone();
        let [mean, most] = differences(&on_mesh(std::slice::from_ref(&source)), &on_grid(&[source]));
        println!("{mean:.3} in the mean, {most:.3} at most: {parts:?}");
        assert!(mean <= 0.4 && most <= 3.0, "{mean:.3} in the mean, {most:.3} at most: {parts:?}");
    }
}
