//! From curves to what a scribble sees: a page of petals, about as rich as a hand-drawn picture.

use std::hint::black_box;

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use kurbo::{Affine, Ellipse, Point, Rect, Shape};
use scumble_core::{Curve, Drawing, Engine, PlanarMap, Sampling, Scribble, ScribbleKind, Sight, Srgb8};

/// Rings of overlapping petals: some 4,000 pieces with some hundred crossings.
fn petals() -> Drawing {
    let petal = |ring: i32, i: i32| {
        let turn = Affine::rotate(f64::from(i) * std::f64::consts::TAU / 8.0 + f64::from(ring) * 0.3);
        let ellipse = Ellipse::new((90.0 + 140.0 * f64::from(ring), 0.0), (80.0, 60.0), 0.0);
        Affine::translate((512.0, 512.0)) * turn * ellipse.to_path(1e-3)
    };
    let paths = (0..3).flat_map(|ring| (0..8).map(move |i| petal(ring, i)));
    let curves = paths.map(|path| Curve { path, line: None }).collect();
    Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) }
}

fn planar_map(c: &mut Criterion) {
    let drawing = petals();
    let build = || PlanarMap::build(&drawing, &Sampling::default()).expect("a map");
    let map = build();
    let points = (0..60).map(|i| Point::new(500.0 + 3.0 * f64::from(i), 480.0 + f64::from(i % 7))).collect();
    let scribble =
        [Scribble { color: Srgb8([200, 30, 40]).into(), kind: ScribbleKind::Fill, width_du: 8.0, points }];
    c.bench_function("map", |b| b.iter(|| black_box(build())));
    c.bench_function("refine", |b| {
        b.iter_batched(|| map.clone(), |map| black_box(map.refined().clone()), BatchSize::LargeInput);
    });
    c.bench_function("sight of one scribble", |b| {
        b.iter(|| black_box(Sight::default().label(&map, &scribble)));
    });
}

criterion_group!(benches, planar_map);
criterion_main!(benches);
