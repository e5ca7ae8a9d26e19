//! Gaps and labels of the engine that takes all scribbles at once, on a made drawing of some 6,000 pieces.

use std::hint::black_box;

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use scumble_core::{Engine, Global, PlanarMap, Sampling};

#[path = "../../scumble-cli/src/made.rs"]
mod made;

/// Cells in a row of the drawing.
const CELLS: u32 = 5;

/// The default gap closing.
const GAP_CLOSING: f64 = 0.5;

fn map() -> PlanarMap {
    PlanarMap::build(&made::drawing(CELLS), &Sampling::default()).expect("a map")
}

fn gaps(c: &mut Criterion) {
    let map = map();
    c.bench_function("gaps, with clearance", |b| {
        b.iter_batched(
            || map.clone(),
            |map| black_box(map.with_gaps_closed(GAP_CLOSING)),
            BatchSize::LargeInput,
        );
    });
}

fn labels(c: &mut Criterion) {
    let map = map().with_gaps_closed(GAP_CLOSING);
    let scribbles = made::scribbles();
    let others = &scribbles[..scribbles.len() - 1];
    for spread in [false, true] {
        let engine = |scribbles| {
            let mut engine = Global::new(spread);
            engine.label(&map, scribbles);
            engine
        };
        let (ready, warm) = (engine(&[]), engine(others));
        let name = if spread { "global, spread" } else { "global" };
        for (what, engine) in [("from nothing", &ready), ("one more scribble", &warm)] {
            c.bench_function(&format!("{name}: {what}"), |b| {
                let label = |mut engine: Global| (engine.label(&map, &scribbles), engine);
                b.iter_batched(|| engine.clone(), label, BatchSize::LargeInput);
            });
        }
        c.bench_function(&format!("{name}: before the first scribble"), |b| b.iter(|| engine(&[])));
    }
}

criterion_group!(benches, gaps, labels);
criterion_main!(benches);
