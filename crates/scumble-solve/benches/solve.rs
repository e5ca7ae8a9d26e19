//! How long the mesh solver takes for each of its stages.

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use kurbo::{BezPath, Circle, Line, Rect, Shape};
use scumble_core::{Blend, Boundary, Curve, Drawing, PlanarMap, Sampling, Triangulation};
use scumble_solve::MeshSolver;
use std::sync::Arc;

/// Rings of circles and lines across them: about 45,000 unknowns, more than nearly all drawings of emoji have.
fn curves() -> Vec<BezPath> {
    let circles = (1..=4).map(|i| Circle::new((512.0, 512.0), 110.0 * f64::from(i)).to_path(1e-6));
    let lines =
        (1..=4).map(|i| Line::new((200.0 * f64::from(i), 80.0), (130.0, 190.0 * f64::from(i))).to_path(1e-6));
    circles.chain(lines).collect()
}

/// Waves of colour along all sides.
fn colored_mesh() -> (Arc<Triangulation>, Boundary) {
    let curves = curves().into_iter().map(|path| Curve { path, line: None }).collect();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
    let map = PlanarMap::build(&drawing, &Sampling::default()).expect("a map");
    let wave = |i: usize| {
        let i = i as f64;
        [0.5 + 0.5 * (i / 50.0).sin(), 0.5 + 0.1 * (i / 60.0).sin(), 0.5 + 0.5 * (i / 70.0).cos(), 1.0]
    };
    let sides: Vec<_> = (0..map.side_count()).map(|i| Some([wave(i), wave(i), wave(i + 1)])).collect();
    (map.refined().clone(), sides.into())
}

fn stages(c: &mut Criterion) {
    let (mesh, colors) = colored_mesh();
    let mut recolored = colors.clone();
    recolored.sides.iter_mut().flatten().flatten().for_each(|color| color[1] *= 0.5);
    let numbered = || MeshSolver::new(mesh.clone());
    let analysed = || {
        let mut solver = numbered();
        solver.analyse(&colors);
        solver
    };
    c.bench_function("number the unknowns", |b| {
        b.iter_batched(|| mesh.clone(), MeshSolver::new, BatchSize::LargeInput);
    });
    c.bench_function("analyse", |b| {
        b.iter_batched_ref(numbered, |solver| solver.analyse(&colors), BatchSize::LargeInput);
    });
    c.bench_function("factor", |b| {
        b.iter_batched_ref(analysed, MeshSolver::factor, BatchSize::LargeInput);
    });
    let mut solver = analysed();
    c.bench_function("solve for two sets of colours", |b| {
        b.iter(|| [&colors, &recolored].map(|colors| solver.solve(colors, Blend::Srgb).is_ok()));
    });
}

criterion_group! { name = solver; config = Criterion::default().sample_size(20); targets = stages }
criterion_main!(solver);
