//! Shading against a solution of the same equation on a fine grid of pixels, half a du wide as those of a page of 2048².

use kurbo::{Point, Rect, Shape, Vec2};
use scumble_core::source::weight;
use scumble_core::{Blend, Boundary, Curve, Drawing, PlanarMap, Sampling, SoftSource};
use scumble_solve::{Field, MeshSolver};

/// The room that is coloured.
const ROOM: Rect = Rect::new(384.0, 384.0, 544.0, 544.0);

/// Distance of the nodes of the grid, in du.
const STEP_DU: f64 = 0.5;

/// Steps along a side of the room.
const STEPS: usize = 320;

/// The colour of the walls, and without a layer over it, of all between them.
fn wall(p: Point) -> f64 {
    0.3 + 0.6 * (p.x - ROOM.x0) / ROOM.width()
}

fn place(column: usize, row: usize) -> Point {
    ROOM.origin() + STEP_DU * Vec2::new(column as f64, row as f64)
}

/// Dabs that a segment is taken for.
const DABS: usize = 100;

/// What a source does at a place, by the definition, without any of the solver's short cuts: the factor of `u − c`, and
/// the length in which the layer fades.
fn pull(source: &SoftSource, p: Point) -> [f64; 2] {
    let part = |i: usize| source.parts.get(i).copied().unwrap_or([1.0; 2]);
    let segments = (1..source.points.len()).map(|i| [i - 1, i]).chain([[0, 0]]);
    let dabs = segments.flat_map(|[a, b]| {
        (0..=DABS).map(move |i| {
            let t = i as f64 / DABS as f64;
            let [radius, root] = [0, 1].map(|k| (1.0 - t) * part(a)[k] + t * part(b)[k]);
            let distance_du = source.points[a].lerp(source.points[b], t).distance(p);
            let (radius_du, weight) = (source.radius_du * radius, source.weight * root * root);
            let inside = (1.0 - (distance_du / radius_du).powi(2)).max(0.0);
            [weight / radius_du.powi(2) * inside * inside, radius_du - 0.5 * distance_du]
        })
    });
    dabs.fold([0.0, f64::NEG_INFINITY], |most, dab| [0, 1].map(|k| f64::max(most[k], dab[k])))
}

/// The least radius along a source, in du.
fn least_radius_du(source: &SoftSource) -> f64 {
    source.parts.iter().fold(source.radius_du, |least, [radius, _]| least.min(radius * source.radius_du))
}

/// At a node: the factor of `u` in the equation, and what there is on its right side.
fn term(source: &SoftSource, p: Point) -> [f64; 2] {
    let [strength, length_du] = pull(source, p);
    let length_du = length_du.max(0.125 * least_radius_du(source));
    [strength + length_du.powi(-2), strength]
}

/// How much a source covers at the nodes, row by row: five-point differences without flux through the walls, by successive
/// over-relaxation until nothing changes by more than a thousandth of a level.
fn covers(source: &SoftSource) -> Vec<f64> {
    let width = STEPS + 1;
    let terms: Vec<_> = (0..width * width).map(|i| term(source, place(i % width, i / width))).collect();
    let mirrored = |i: usize| if i < width { i } else { 2 * STEPS - i };
    let beside = |i: usize| [if i == 0 { 1 } else { i - 1 }, mirrored(i + 1)];
    let mut values = vec![0.0; width * width];
    loop {
        let mut largest = 0.0_f64;
        for (row, column) in (0..width).flat_map(|row| (0..width).map(move |column| (row, column))) {
            let i = row * width + column;
            let [left, right] = beside(column).map(|column| values[row * width + column]);
            let [above, below] = beside(row).map(|row| values[row * width + column]);
            let sum = left + right + above + below + STEP_DU * STEP_DU * terms[i][1];
            let change = 1.95 * (sum / (4.0 + STEP_DU * STEP_DU * terms[i][0]) - values[i]);
            values[i] += change;
            largest = largest.max(change.abs());
        }
        if largest < 1e-3 / 255.0 / STEPS as f64 {
            return values;
        }
    }
}

/// What is seen at the nodes, row by row: the colours of the sources and of the walls, mixed by how much each covers against what
/// it leaves.
fn on_grid(sources: &[SoftSource]) -> Vec<f64> {
    let width = STEPS + 1;
    let layers: Vec<_> = sources.iter().map(covers).collect();
    let seen = |i: usize| {
        let parts = layers.iter().zip(sources).map(|(covers, source)| {
            let weight = covers[i] / (1.0 - covers[i]);
            [weight * source.color[0], weight]
        });
        let [color, weight] =
            parts.fold([wall(place(i % width, i / width)), 1.0], |[c, w], [d, v]| [c + d, w + v]);
        color / weight
    };
    (0..width * width).map(seen).collect()
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
        let middle = ((a.to_vec2() + b.to_vec2() + c.to_vec2()) / 3.0).to_point();
        if !ROOM.contains(middle) {
            continue;
        }
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

fn source(points: &[(f64, f64)], radius_du: f64, strength: f64, value: f64) -> SoftSource {
    let points = points.iter().copied().map(Point::from).collect();
    let weight = weight(strength);
    SoftSource { points, radius_du, weight, color: [value, 0.0, 0.0, 1.0], crosses: false, parts: Vec::new() }
}

#[test]
fn strokes_and_dabs_are_those_of_the_grid() {
    let bent = [(410.0, 500.0), (440.0, 440.0), (470.0, 430.0), (510.0, 460.0)];
    let over_walls = source(&[(380.0, 420.0), (450.0, 400.0), (550.0, 500.0)], 30.0, 0.9, 0.0);
    for sources in [
        vec![source(&bent, 20.0, 1.0, 1.0), source(&[(510.0, 510.0)], 24.0, 0.9, 0.0)],
        vec![source(&bent, 40.0, 0.6, 1.0), source(&[(400.0, 520.0), (520.0, 410.0)], 12.0, 0.95, 0.0)],
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
    let stroke = |way: &[(f64, f64)]| source(way, 40.0, 1.0, 1.0);
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
