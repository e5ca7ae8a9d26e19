//! Labels by the `Progressive` engine, with one more scribble, and while the pen goes on.

use std::hint::black_box;

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use kurbo::{Affine, Ellipse, Point, Rect, Shape, Vec2};
use scumble_core::{Curve, Drawing, Engine, Paint, PlanarMap, Progressive, Sampling, Scribble, ScribbleKind};

/// Two rings of overlapping petals: some 2,400 pieces.
fn petals() -> PlanarMap {
    let petal = |ring: i32, i: i32| {
        let turn = Affine::rotate(f64::from(i) * std::f64::consts::TAU / 8.0 + f64::from(ring) * 0.3);
        let ellipse = Ellipse::new((90.0 + 190.0 * f64::from(ring), 0.0), (80.0, 60.0), 0.0);
        Affine::translate((512.0, 512.0)) * turn * ellipse.to_path(1e-3)
    };
    let paths = (0..2).flat_map(|ring| (0..8).map(move |i| petal(ring, i)));
    let curves = paths.map(|path| Curve { path, line: None }).collect();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
    PlanarMap::build(&drawing, &Sampling::default()).expect("a map")
}

/// Strokes of 60 du, all over the flower.
fn scribbles() -> Vec<Scribble> {
    let stroke = |i: i32| {
        let at = Point::new(512.0, 512.0) + Vec2::from_angle(f64::from(i)) * f64::from(20 + 17 * (i % 20));
        let points = (0..20).map(|k| at + 3.0 * f64::from(k) * Vec2::from_angle(f64::from(2 * i))).collect();
        Scribble { color: Paint::Clear, kind: ScribbleKind::Fill, width_du: 8.0, points }
    };
    (0..20).map(stroke).collect()
}

fn progressive(c: &mut Criterion) {
    let map = petals();
    let all = scribbles();
    let mut before = Progressive::default();
    before.label(&map, &all[..all.len() - 1]);
    let bench = |c: &mut Criterion, name: &str, before: &Progressive, all: &[Scribble]| {
        c.bench_function(name, |b| {
            let label = |mut engine: Progressive| black_box(engine.label(&map, all));
            b.iter_batched(|| before.clone(), label, BatchSize::LargeInput);
        });
    };
    bench(c, "progressive: one more scribble of 20", &before, &all);
    bench(c, "progressive: 20 scribbles", &Progressive::default(), &all);
    let mut longer = all.clone();
    before.label(&map, &all);
    if let Some(last) = longer.last_mut() {
        last.points.push(last.points[19] + Vec2::new(6.0, 2.0));
    }
    bench(c, "progressive: the pen goes on by 6 du", &before, &longer);
}

criterion_group!(benches, progressive);
criterion_main!(benches);
