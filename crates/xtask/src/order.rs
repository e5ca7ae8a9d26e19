//! The order of the functions of a wasm module by likeness: `gzip` finds what is repeated within 32 KB alone.

use anyhow::{Context, Result};
use std::collections::{BTreeMap, BTreeSet, VecDeque};
use wasmparser::{Parser, Payload, TypeRef};

/// Bytes in a row that two functions are alike by. This, and what follows, is what made the page smallest of some hundred settings
/// tried, which differ by half a percent.
const RUN_BYTES: usize = 6;

/// Runs that more functions have say nothing: `gzip` has seen them wherever it is.
const MOST_HOLDERS: usize = 400;

/// What a run that a single function had would weigh. One that few have weighs more than one that many have: it takes the square
/// root of their number for that.
const WEIGHT: f64 = 1000.0;

/// So much more a function weighs, lest the smallest come first.
const HEADWAY: u64 = 10_000;

/// How many functions a module imports, and the bodies of its own, whose numbers follow.
///
/// # Errors
/// For what is no wasm module.
pub(crate) fn functions(module: &[u8]) -> Result<(u32, Vec<&[u8]>)> {
    let (mut imported, mut bodies) = (0, Vec::new());
    for payload in Parser::new(0).parse_all(module) {
        match payload.context("the functions of a wasm module")? {
            Payload::ImportSection(imports) => {
                for import in imports.into_imports() {
                    imported += u32::from(matches!(import?.ty, TypeRef::Func(_)));
                }
            }
            Payload::CodeSectionEntry(body) => bodies.push(&module[body.range()]),
            _ => {}
        }
    }
    Ok((imported, bodies))
}

/// What functions, given by their bodies, have in common.
pub(crate) struct Likeness<'a> {
    bodies: &'a [&'a [u8]],
    /// By function: those of its runs that others have, too, each once, by number; and what they weigh.
    runs: Vec<Vec<usize>>,
    weights: Vec<u64>,
    /// By run: the functions that have it.
    holders: Vec<Vec<usize>>,
}

impl<'a> Likeness<'a> {
    pub(crate) fn new(bodies: &'a [&'a [u8]]) -> Self {
        let mut by_run = BTreeMap::<&[u8], Vec<usize>>::new();
        for (i, body) in bodies.iter().enumerate() {
            let runs: BTreeSet<_> = body.windows(RUN_BYTES).collect();
            runs.into_iter().for_each(|run| by_run.entry(run).or_default().push(i));
        }
        let (mut runs, mut weights) = (vec![Vec::new(); bodies.len()], vec![HEADWAY; bodies.len()]);
        let holders: Vec<_> = by_run.into_values().filter(|functions| functions.len() > 1).collect();
        for (run, functions) in holders.iter().enumerate() {
            for &i in functions {
                runs[i].push(run);
                weights[i] += weight(functions);
            }
        }
        Self { bodies, runs, weights, holders }
    }

    /// The functions in such an order that each next one is the one of which the largest part is found in the last bytes before
    /// it, of which a window takes so many.
    pub(crate) fn order(&self, window_bytes: usize) -> Vec<usize> {
        let mut window = Window::new(self, window_bytes);
        let mut left: BTreeSet<usize> = (0..self.bodies.len()).collect();
        let mut order = Vec::with_capacity(self.bodies.len());
        while let Some(next) =
            left.iter().copied().reduce(|best, i| if window.is_more_like(i, best) { i } else { best })
        {
            left.remove(&next);
            order.push(next);
            window.push(next);
        }
        order
    }
}

/// The last functions, and how much of each other one is found there.
struct Window<'a> {
    likeness: &'a Likeness<'a>,
    /// By function what those of its runs weigh that there are in the window.
    found: Vec<u64>,
    /// By run how many functions of the window have it.
    counts: Vec<usize>,
    last: VecDeque<usize>,
    bytes: usize,
    most_bytes: usize,
}

impl<'a> Window<'a> {
    fn new(likeness: &'a Likeness<'a>, most_bytes: usize) -> Self {
        let (found, counts) = (vec![0; likeness.bodies.len()], vec![0; likeness.holders.len()]);
        Self { likeness, found, counts, last: VecDeque::new(), bytes: 0, most_bytes }
    }

    /// Whether a larger part of one function is found here than of another.
    fn is_more_like(&self, one: usize, other: usize) -> bool {
        self.found[one] * self.likeness.weights[other] > self.found[other] * self.likeness.weights[one]
    }

    /// Takes a function in, and lets go of those that have become too far away.
    fn push(&mut self, function: usize) {
        self.bytes += self.likeness.bodies[function].len();
        self.last.push_back(function);
        for &run in &self.likeness.runs[function] {
            if self.counts[run] == 0 {
                let functions = &self.likeness.holders[run];
                telling(functions).iter().for_each(|&i| self.found[i] += weight(functions));
            }
            self.counts[run] += 1;
        }
        while self.bytes > self.most_bytes && self.last.len() > 1 {
            self.let_go();
        }
    }

    fn let_go(&mut self) {
        let Some(function) = self.last.pop_front() else { return };
        self.bytes -= self.likeness.bodies[function].len();
        for &run in &self.likeness.runs[function] {
            self.counts[run] -= 1;
            if self.counts[run] == 0 {
                let functions = &self.likeness.holders[run];
                telling(functions).iter().for_each(|&i| self.found[i] -= weight(functions));
            }
        }
    }
}

/// What a run weighs that some functions have.
fn weight(holders: &[usize]) -> u64 {
    (WEIGHT / (holders.len() as f64).sqrt()) as u64
}

/// The functions that a run tells something of.
fn telling(holders: &[usize]) -> &[usize] {
    if holders.len() <= MOST_HOLDERS { holders } else { &[] }
}

#[cfg(test)]
mod tests {
    use super::*;

    const WINDOW_BYTES: usize = 1000;

    /// A body of its own kind: the same seven bytes over and over.
    fn body(kind: u8, length: usize) -> Vec<u8> {
        (0..length).map(|i| kind.wrapping_mul(31) ^ (i % 7) as u8).collect()
    }

    #[test]
    fn what_is_alike_comes_together() {
        let bodies =
            [(1, 90), (2, 80), (3, 70), (1, 60), (3, 50), (2, 40)].map(|(kind, length)| body(kind, length));
        let bodies: Vec<&[u8]> = bodies.iter().map(Vec::as_slice).collect();
        assert_eq!(Likeness::new(&bodies).order(WINDOW_BYTES), [0, 3, 1, 5, 2, 4]);
        assert!(Likeness::new(&[]).order(WINDOW_BYTES).is_empty());
    }

    #[test]
    fn what_is_far_away_counts_no_more() {
        let mut bodies = vec![body(1, 90), body(1, 80)];
        bodies.extend((0..2).map(|_| body(2, WINDOW_BYTES)));
        let bodies: Vec<&[u8]> = bodies.iter().map(Vec::as_slice).collect();
        let likeness = Likeness::new(&bodies);
        let mut window = Window::new(&likeness, WINDOW_BYTES);
        window.push(0);
        assert!(window.found[1] > 0);
        window.push(2);
        assert_eq!((window.found[1], window.found[3]), (0, 7 * weight(&[2, 3])));
    }

    #[test]
    fn of_two_that_are_as_alike_the_larger_comes_first() {
        let bodies = [body(1, 90), body(1, 13), body(1, 9)];
        let bodies: Vec<&[u8]> = bodies.iter().map(Vec::as_slice).collect();
        let likeness = Likeness::new(&bodies);
        let mut window = Window::new(&likeness, WINDOW_BYTES);
        window.push(0);
        assert!(window.is_more_like(1, 2) && !window.is_more_like(2, 1));
    }

    #[test]
    fn what_nearly_all_have_makes_nothing_alike() {
        let bodies = vec![body(1, 90); MOST_HOLDERS + 1];
        let bodies: Vec<&[u8]> = bodies.iter().map(Vec::as_slice).collect();
        let likeness = Likeness::new(&bodies);
        let mut window = Window::new(&likeness, WINDOW_BYTES);
        window.push(0);
        assert_eq!(window.found[1], 0);
    }
}
