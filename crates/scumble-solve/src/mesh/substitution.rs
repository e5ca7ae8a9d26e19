//! Solution of systems with a factor: forwards from the first pivot on, then backwards from the last, front by front.
//!
//! A few columns go together: the values of the rows below are fetched once for all of them, and the sums of one do not
//! wait for those of another.

use std::array;

use scumble_core::pace::Pace;

use super::cholesky::start;
use super::fronts::{Front, Fronts};

/// The four channels of one unknown.
pub(super) type Value = [f32; 4];

/// So many columns go together; what is left over goes one by one.
const BLOCK: usize = 8;

/// So many entries take as long as a front takes besides.
const ENTRIES: usize = 64;

/// Replaces right-hand sides by the solutions; the entries are those of the columns of all fronts.
pub(super) async fn solve(entries: &[f32], fronts: &Fronts, values: &mut [Value]) {
    let mut local = Vec::new();
    let (mut end, mut pace) = (0, Pace::default());
    for front in &fronts.list {
        let columns = Columns::of(front, &entries[end..]);
        end += front.entry_count();
        pace.work(1 + front.entry_count() / ENTRIES).await;
        columns.forwards(front, fronts.boundary(front), values, &mut local);
    }
    for front in fronts.list.iter().rev() {
        end -= front.entry_count();
        pace.work(1 + front.entry_count() / ENTRIES).await;
        Columns::of(front, &entries[end..]).backwards(front, fronts.boundary(front), values, &mut local);
    }
}

/// The columns of the pivots of a front.
#[derive(Clone, Copy)]
struct Columns<'a> {
    size: usize,
    pivot_count: usize,
    entries: &'a [f32],
}

impl<'a> Columns<'a> {
    fn of(front: &Front, entries: &'a [f32]) -> Self {
        Self { size: front.size(), pivot_count: front.pivots.len(), entries }
    }

    /// Solves for the pivots from the first on, and takes what they add to the boundary from there.
    fn forwards(self, front: &Front, boundary: &[u32], values: &mut [Value], local: &mut Vec<Value>) {
        let pivots = front.pivots.start as usize..front.pivots.end as usize;
        // Of regions that are coloured at their sides alone, that is half of the factor.
        if values[pivots.clone()].as_flattened().iter().all(|&value| value == 0.0) {
            return;
        }
        local.clear();
        local.extend_from_slice(&values[pivots.clone()]);
        local.resize(self.size, [0.0; 4]);
        let blocked = self.pivot_count / BLOCK * BLOCK;
        (0..blocked).step_by(BLOCK).for_each(|j| self.block::<BLOCK>(j).forwards(&mut local[j..]));
        (blocked..self.pivot_count).for_each(|j| self.block::<1>(j).forwards(&mut local[j..]));
        values[pivots].copy_from_slice(&local[..self.pivot_count]);
        for (&row, sum) in boundary.iter().zip(&local[self.pivot_count..]) {
            (0..4).for_each(|i| values[row as usize][i] += sum[i]);
        }
    }

    /// Solves for the pivots from the last on; the values on the boundary are known.
    fn backwards(self, front: &Front, boundary: &[u32], values: &mut [Value], local: &mut Vec<Value>) {
        let pivots = front.pivots.start as usize..front.pivots.end as usize;
        local.clear();
        local.extend_from_slice(&values[pivots.clone()]);
        local.extend(boundary.iter().map(|&row| values[row as usize]));
        let blocked = self.pivot_count / BLOCK * BLOCK;
        (blocked..self.pivot_count).rev().for_each(|j| self.block::<1>(j).backwards(&mut local[j..]));
        (0..blocked).step_by(BLOCK).rev().for_each(|j| self.block::<BLOCK>(j).backwards(&mut local[j..]));
        values[pivots].copy_from_slice(&local[..self.pivot_count]);
    }

    /// Some columns from one on.
    fn block<const N: usize>(self, first: usize) -> Block<'a, N> {
        let column = |j: usize| &self.entries[start(self.size, j)..][..self.size - j];
        Block(array::from_fn(|k| column(first + k)))
    }
}

/// Successive columns, each from its diagonal on. The values are those of the rows of the first.
struct Block<'a, const N: usize>([&'a [f32]; N]);

impl<const N: usize> Block<'_, N> {
    fn forwards(&self, values: &mut [Value]) {
        let Some((own, below)) = values.split_first_chunk_mut::<N>() else { return };
        let mut solved = *own;
        for (k, column) in self.0.iter().enumerate() {
            solved[k] = solved[k].map(|value| value * column[0]);
            for l in k + 1..N {
                solved[l] = minus(solved[l], column[l - k], solved[k]);
            }
        }
        *own = solved;
        let columns = self.below(below.len());
        for (i, sum) in below.iter_mut().enumerate() {
            *sum = (0..N).fold(*sum, |sum, k| minus(sum, columns[k][i], solved[k]));
        }
    }

    fn backwards(&self, values: &mut [Value]) {
        let Some((own, below)) = values.split_first_chunk_mut::<N>() else { return };
        let mut sums = *own;
        let columns = self.below(below.len());
        for (i, value) in below.iter().enumerate() {
            (0..N).for_each(|k| sums[k] = minus(sums[k], columns[k][i], *value));
        }
        for (k, column) in self.0.iter().enumerate().rev() {
            let sum = (k + 1..N).fold(sums[k], |sum, l| minus(sum, column[l - k], sums[l]));
            sums[k] = sum.map(|sum| sum * column[0]);
        }
        *own = sums;
    }

    /// The columns below the block.
    fn below(&self, count: usize) -> [&[f32]; N] {
        array::from_fn(|k| &self.0[k][N - k..][..count])
    }
}

fn minus(sum: Value, factor: f32, value: Value) -> Value {
    [0, 1, 2, 3].map(|i| sum[i] - factor * value[i])
}
