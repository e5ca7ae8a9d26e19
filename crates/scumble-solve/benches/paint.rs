//! How long the painter takes for a picture of 1024 × 1024.

use criterion::{Criterion, criterion_group, criterion_main};
use kurbo::{Affine, Point};
use scumble_core::{Blend, Scribble, ScribbleKind, Srgb8};
use scumble_solve::{Field, FieldTriangle, Scene, Shape, View, paint, scribble_shape};

const SIZE: u32 = 1024;
/// Cells along each side of the mesh; two triangles each.
const CELLS: usize = 100;
/// Every so many columns and rows of the mesh are the side of a curve.
const CELLS_BETWEEN_SIDES: usize = 10;

/// A mesh over the whole picture, in the shape of waves so that its edges lie at every angle.
fn waves(color_at: impl Fn([f32; 2]) -> [f32; 4]) -> Field {
    let at = |i: usize, j: usize| {
        let [x, y] = [i, j].map(|k| (k as f32 / CELLS as f32 - 0.02) * 1.04 * SIZE as f32);
        [x + 4.0 * (y / 20.0).sin(), y + 4.0 * (x / 20.0).sin()]
    };
    let is_side = |k: usize| u32::from(k.is_multiple_of(CELLS_BETWEEN_SIDES));
    let middle = |a: [f32; 2], b: [f32; 2]| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
    let triangle = |corners: [[f32; 2]; 3], side_edges: u32| {
        let [a, b, c] = corners;
        let nodes = [a, b, c, middle(a, b), middle(b, c), middle(c, a)];
        let colors = nodes.map(&color_at);
        FieldTriangle { corners, colors, side_edges }
    };
    let cell = |(i, j): (usize, usize)| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        let upper = is_side(j) | is_side(i + 1) << 1;
        let lower = is_side(j + 1) << 1 | is_side(i) << 2;
        [triangle([a, b, c], upper), triangle([a, c, d], lower)]
    };
    let cells = (0..CELLS).flat_map(|j| (0..CELLS).map(move |i| (i, j)));
    Field { blend: Blend::Oklab, triangles: cells.flat_map(cell).collect() }
}

/// Strokes to and fro over the picture.
fn scribbles() -> Vec<Shape> {
    let stroke = |k: usize| Scribble {
        color: Srgb8([200, 40, 90]).into(),
        kind: ScribbleKind::Fill,
        width_du: 12.0,
        points: (0..500)
            .map(|i| f64::from(i) * 2.0)
            .map(|x| Point::new(x, 60.0 * k as f64 + 40.0 * (x / 50.0).sin()))
            .collect(),
    };
    (0..16).map(|k| scribble_shape(&stroke(k), 160, 0.1)).collect()
}

fn benches(criterion: &mut Criterion) {
    let smooth = waves(|[x, y]| [0.6 + 0.2 * (x / 90.0).sin(), 0.1 * (y / 70.0).cos(), 0.0001 * x, 1.0]);
    let flat = waves(|_| [0.6, 0.1, 0.05, 1.0]);
    let fading = waves(|[x, y]| {
        let opacity = 0.5 + 0.5 * (y / 90.0).sin();
        [0.6 * opacity, 0.1 * opacity, 0.0001 * x * opacity, opacity]
    });
    let empty = Field::default();
    let scribbles = scribbles();
    let view = View { px_from_du: Affine::IDENTITY, width_px: SIZE, height_px: SIZE };
    for (name, field, shapes) in [
        ("smooth field", &smooth, &[][..]),
        ("flat field", &flat, &[]),
        ("fading field", &fading, &[]),
        ("scribbles", &empty, &scribbles),
    ] {
        let scene = Scene { paper: Some(Srgb8([255; 3])), field, shapes };
        criterion.bench_function(name, |bencher| bencher.iter(|| paint(&scene, &view)));
    }
}

criterion_group!(paint_benches, benches);
criterion_main!(paint_benches);
