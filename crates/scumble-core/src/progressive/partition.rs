//! Two scribbles that want the same sides: where along them one colour passes into the other (section 4.2).

use super::sighting::Evidence;
use super::{OMEGA, TAU};

/// The largest number of pieces: the penalty has its pole at 13.9.
const MOST_PIECES: usize = 13;

/// A side that two scribbles want.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Contested {
    /// What speaks for either scribble.
    pub(super) evidence: [Evidence; 2],
    /// Its share in the mean: its length in du; not negative.
    pub(super) length_du: f64,
}

impl Contested {
    /// Equation 5 as a cost: what speaks against either label.
    fn costs(&self) -> [f64; 2] {
        let [first, second] = self.evidence;
        let hits = first.hits + second.hits;
        let distance_du = first.distance_du + second.distance_du;
        let cost = |own: Evidence, other: Evidence| other.hits / hits + own.distance_du / distance_du;
        [cost(first, second), cost(second, first)]
    }
}

/// The second part of equation 6: H(x) = 1 / (2 − e^(x/τ)), for x up to [`MOST_PIECES`].
fn penalty(pieces: usize) -> f64 {
    // e^(1/τ) by its series: the library's exponential may differ from machine to machine.
    let factor = (1..10).rev().fold(1.0, |sum, i| 1.0 + sum / (TAU * f64::from(i)));
    1.0 / (2.0 - (0..pieces).fold(1.0, |power, _| power * factor))
}

/// Labels each side of a chain 0 or 1 so that equation 6 is least: the exact optimum over (side, label, pieces so far).
/// Of equal ones it takes the one with fewer pieces. In a closed chain the last side is next to the first.
pub(super) fn split(chain: &[Contested], is_closed: bool) -> Vec<bool> {
    let total_du: f64 = chain.iter().map(|side| side.length_du).sum();
    let scale = if total_du > 0.0 { total_du.recip() } else { 0.0 };
    let costs: Vec<_> =
        chain.iter().map(|side| side.costs().map(|cost| cost * side.length_du * scale)).collect();
    // In a closed chain a last label unlike the first is one more border.
    let [best, other] = [0, 1].map(|first| Table::new(&costs, first).best(is_closed.then_some(first)));
    if other.0 < best.0 { other.1 } else { best.1 }
}

/// What the cheapest labelling of the sides so far costs, by label of the last and number of pieces less one.
type Row = [[f64; MOST_PIECES]; 2];

/// The rows of the dynamic programme, and whether the label changed on the way to each entry.
struct Table {
    last: Row,
    changed: Vec<[u16; 2]>,
}

impl Table {
    fn new(costs: &[[f64; 2]], first: usize) -> Self {
        let mut table =
            Self { last: [[f64::INFINITY; MOST_PIECES]; 2], changed: Vec::with_capacity(costs.len()) };
        for (i, cost) in costs.iter().enumerate() {
            if i == 0 {
                table.last[first][0] = cost[first];
                table.changed.push([0; 2]);
            } else {
                table.step(cost);
            }
        }
        table
    }

    fn step(&mut self, cost: &[f64; 2]) {
        let before = self.last;
        let mut changed = [0; 2];
        for label in 0..2 {
            for x in 0..MOST_PIECES {
                let stay = before[label][x];
                let change = if x > 0 { before[1 - label][x - 1] } else { f64::INFINITY };
                changed[label] |= u16::from(change < stay) << x;
                self.last[label][x] = stay.min(change) + cost[label];
            }
        }
        self.changed.push(changed);
    }

    /// The least energy and its labels; in a closed chain that began with label `first`.
    fn best(&self, first: Option<usize>) -> (f64, Vec<bool>) {
        let mut best = (f64::INFINITY, 0, 0);
        for x in 0..MOST_PIECES {
            for label in 0..2 {
                // Around a closed chain, the last piece goes on into the first where their labels are alike.
                let is_one = first == Some(label) && x > 0;
                let energy = self.last[label][x] + OMEGA * penalty(if is_one { x } else { x + 1 });
                if energy < best.0 {
                    best = (energy, label, x);
                }
            }
        }
        let (energy, mut label, mut x) = best;
        let mut labels = vec![false; self.changed.len()];
        for (changed, labels) in self.changed.iter().zip(&mut labels).rev() {
            *labels = label == 1;
            if changed[label] >> x & 1 == 1 {
                (label, x) = (1 - label, x - 1);
            }
        }
        (energy, labels)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn energy(chain: &[Contested], labels: &[bool], is_closed: bool) -> f64 {
        let total_du: f64 = chain.iter().map(|side| side.length_du).sum();
        let cost = |(side, &label): (&Contested, &bool)| side.costs()[usize::from(label)] * side.length_du;
        let mean = chain.iter().zip(labels).map(cost).sum::<f64>() / total_du;
        let mut borders = labels.windows(2).filter(|pair| pair[0] != pair[1]).count();
        borders += usize::from(is_closed && labels.first() != labels.last());
        let pieces = if is_closed { borders.max(1) } else { borders + 1 };
        if pieces > MOST_PIECES { f64::INFINITY } else { mean + OMEGA / (2.0 - (pieces as f64 / TAU).exp()) }
    }

    fn contested() -> impl Strategy<Value = Contested> {
        let evidence = || {
            (1..36_u32, 1.0..100.0_f64)
                .prop_map(|(hits, distance_du)| Evidence { hits: f64::from(hits), distance_du })
        };
        (evidence(), evidence(), 0.1..3.0_f64)
            .prop_map(|(a, b, length_du)| Contested { evidence: [a, b], length_du })
    }

    proptest! {
        #[test]
        fn no_labelling_of_a_chain_is_better(
            chain in proptest::collection::vec(contested(), 1..12), is_closed: bool,
        ) {
            let found = energy(&chain, &split(&chain, is_closed), is_closed);
            for bits in 0..1_u32 << chain.len() {
                let labels: Vec<_> = (0..chain.len()).map(|i| bits >> i & 1 == 1).collect();
                prop_assert!(found <= energy(&chain, &labels, is_closed) + 1e-12);
            }
        }
    }

    #[test]
    fn the_penalty_is_the_papers() {
        for x in 1..=MOST_PIECES {
            let expected = 1.0 / (2.0 - (x as f64 / TAU).exp());
            assert!((penalty(x) - expected).abs() < 1e-9 * expected);
        }
    }

    #[test]
    fn each_end_goes_to_the_scribble_that_is_nearer() {
        let near = Evidence { hits: 20.0, distance_du: 10.0 };
        let far = Evidence { hits: 4.0, distance_du: 90.0 };
        let side =
            |i: usize| Contested { evidence: if i < 7 { [near, far] } else { [far, near] }, length_du: 3.0 };
        let chain: Vec<_> = (0..20).map(side).collect();
        assert_eq!(split(&chain, false), (0..20).map(|i| i >= 7).collect::<Vec<_>>());
    }
}
