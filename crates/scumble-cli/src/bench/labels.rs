//! How long an engine takes to label the sides of a drawing as scribbles come, grow and go.

use scumble_core::{Engine, EngineKind, PlanarMap, Scribble, Settings, Sight};

use crate::clock::{Times, timed};

/// Everything is timed so often, and the least counts: the rest is what else the machine had to do.
const RUNS: usize = 3;

/// Scribbles that are each in turn the last one.
const TURNS: usize = 12;

/// An engine by its name.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Candidate {
    pub(crate) name: &'static str,
    fresh: fn() -> Box<dyn Engine>,
}

/// All that are timed; the first is what the others are compared with.
pub(crate) const CANDIDATES: [Candidate; 4] = [
    Candidate { name: "sight", fresh: || Box::new(Sight::default()) },
    Candidate { name: "global", fresh: || engine(EngineKind::Global, false) },
    Candidate { name: "global, spread", fresh: || engine(EngineKind::Global, true) },
    Candidate { name: "progressive", fresh: || engine(EngineKind::Progressive, false) },
];

fn engine(engine: EngineKind, spread: bool) -> Box<dyn Engine> {
    Settings { engine, spread, ..Settings::default() }.engine()
}

/// What is timed, in the order of [`LabelTimes::rows`].
pub(crate) const ROWS: [&str; 5] = [
    "before the first scribble",
    "all scribbles at once, from nothing",
    "one more scribble, all others there",
    "undo of it",
    "one more point on the last scribble",
];

/// The row that the others of an engine are compared with.
pub(crate) const FROM_NOTHING: usize = 1;

/// Times of one engine, on one drawing or on many.
#[derive(Clone, Debug, Default)]
pub(crate) struct LabelTimes {
    pub(crate) rows: [Times; ROWS.len()],
}

impl LabelTimes {
    /// Times an engine on one drawing.
    pub(crate) fn take(&mut self, candidate: Candidate, map: &PlanarMap, scribbles: &[Scribble]) {
        let mut engine = (candidate.fresh)();
        let from_nothing = least(|| {
            engine = (candidate.fresh)();
            let (_, before_ms) = timed(|| engine.label(map, &[]));
            [before_ms, timed(|| engine.label(map, scribbles)).1]
        });
        self.push([0, 1], from_nothing);
        let mut scribbles = scribbles.to_vec();
        for _ in 0..scribbles.len().min(TURNS) {
            scribbles.rotate_left(1);
            self.push([2, 3], last_scribble(&mut *engine, map, &scribbles));
        }
        growing_stroke(&mut *engine, map, &mut scribbles).into_iter().for_each(|ms| self.rows[4].push(ms));
    }

    fn push(&mut self, rows: [usize; 2], times_ms: [f64; 2]) {
        rows.into_iter().zip(times_ms).for_each(|(row, ms)| self.rows[row].push(ms));
    }
}

/// The last scribble comes, and goes again.
fn last_scribble(engine: &mut dyn Engine, map: &PlanarMap, scribbles: &[Scribble]) -> [f64; 2] {
    let others = &scribbles[..scribbles.len().saturating_sub(1)];
    engine.label(map, others);
    least(|| [timed(|| engine.label(map, scribbles)).1, timed(|| engine.label(map, others)).1])
}

/// The last scribble grows from its first point on; a time for each further point.
fn growing_stroke(engine: &mut dyn Engine, map: &PlanarMap, scribbles: &mut [Scribble]) -> Vec<f64> {
    let points = scribbles.last().map(|scribble| scribble.points.clone()).unwrap_or_default();
    let mut label = |count: usize| {
        if let Some(last) = scribbles.last_mut() {
            last.points = points[..count].to_vec();
        }
        timed(|| engine.label(map, scribbles)).1
    };
    let mut least_ms = vec![f64::INFINITY; points.len().saturating_sub(1)];
    for _ in 0..RUNS {
        label(points.len().min(1));
        (2..).zip(&mut least_ms).for_each(|(count, ms)| *ms = ms.min(label(count)));
    }
    least_ms
}

/// The least of some runs.
fn least<const N: usize>(mut run: impl FnMut() -> [f64; N]) -> [f64; N] {
    (0..RUNS).fold([f64::INFINITY; N], |least, _| {
        let ms = run();
        std::array::from_fn(|i| least[i].min(ms[i]))
    })
}

/// Prints the times of all engines: each row beside that of sight, and beside labelling everything from nothing.
pub(crate) fn print(title: &str, all: &[LabelTimes; CANDIDATES.len()]) {
    println!();
    println!(
        "{title:<40} {:>9} {:>9} {:>9} {:>9} {:>14}",
        "median ms", "95 %", "largest", "/ sight", "/ from nothing"
    );
    for (candidate, times) in CANDIDATES.iter().zip(all) {
        println!("{}", candidate.name);
        for ((name, row), of_sight) in ROWS.iter().zip(&times.rows).zip(&all[0].rows) {
            let [p50, p95, max] = [0.5, 0.95, 1.0].map(|part| row.percentile(part));
            let to_sight = p50 / of_sight.median();
            let to_all = p50 / times.rows[FROM_NOTHING].median();
            println!("  {name:<38} {p50:9.3} {p95:9.3} {max:9.3} {to_sight:9.2} {to_all:14.3}");
        }
    }
}
