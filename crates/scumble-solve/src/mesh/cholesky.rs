//! Sparse Cholesky factorisation, front by front, and the solution of systems with the factor.
//!
//! Columns of fronts are packed: each begins at the diagonal, of which it has the inverse, and ends with the front. No
//! sum runs along a column, so vector instructions do not change the order of any.
//!
//! What is kept is of single precision: less to read at each solution, and a vector for the four channels of an unknown.
//! Along a corridor with 32 bends that is off by 0.003 of 255 levels.

use std::mem;

use scumble_core::pace::Pace;

use super::SolveError;
use super::element::Matrix;
use super::fronts::{Front, Fronts, NONE};
use super::substitution::{self, Value};

/// Where a part of the region hangs on the rest by triangles without area alone, the last pivot of that part is zero
/// but for rounding. Pivots up to this are taken as one, so that the part gets some value within the range.
const LEAST_PIVOT: f64 = 1e-12;

/// Largest number of entries of a factor: 8 GB.
const MAX_ENTRIES: u64 = i32::MAX as u64;

/// So many products take as long as a column takes besides.
const PRODUCTS: usize = 256;

/// The columns of the pivots, front by front.
#[derive(Debug)]
pub(super) struct Factor {
    entries: Vec<f32>,
}

impl Factor {
    /// Factors the sum of symmetric matrices of elements, of which the rows are given, or [`NONE`]. The memory of another
    /// factor is taken where it fits: that is faster than to ask for more.
    pub(super) async fn new(
        fronts: &Fronts,
        rows: &[[u32; 6]],
        element: &dyn Fn(usize) -> Matrix,
        memory: &mut Vec<f32>,
    ) -> Result<Self, SolveError> {
        let count = fronts.entry_count();
        if count > MAX_ENTRIES {
            return Err(SolveError::TooLarge);
        }
        let is_fit = (count..4 * count).contains(&(memory.capacity() as u64));
        let mut entries = if is_fit { mem::take(memory) } else { Vec::new() };
        entries.clear();
        entries.try_reserve_exact(count as usize).map_err(|_| SolveError::TooLarge)?;
        let mut leftovers: Vec<Vec<f64>> = Vec::with_capacity(fronts.list.len());
        let mut places = Places { fronts, of_row: vec![NONE; fronts.row_count()], of_child: Vec::new() };
        let (mut pivots, mut pace) = (Vec::new(), Pace::default());
        for front in &fronts.list {
            pivots.clear();
            pivots.resize(front.entry_count(), 0.0);
            let mut left = zeros(front.left_count())?;
            let mut matrix = Dense::new(front, &mut pivots, &mut left);
            places.set(front);
            for &i in fronts.elements(front) {
                places.add_element(&rows[i as usize], &element(i as usize), &mut matrix);
            }
            let mut child = front.child;
            while let Some(of_child) = fronts.list.get(child as usize) {
                places.add_child(of_child, &mem::take(&mut leftovers[child as usize]), &mut matrix);
                child = of_child.sibling;
            }
            for j in 0..matrix.size {
                pace.work(1 + matrix.eliminate(j)? / PRODUCTS).await;
            }
            leftovers.push(left);
            entries.extend(pivots.iter().map(|&entry| entry as f32));
        }
        Ok(Self { entries })
    }

    pub(super) fn into_memory(self) -> Vec<f32> {
        self.entries
    }

    /// Replaces the right-hand sides by the solutions.
    pub(super) async fn solve(&self, fronts: &Fronts, values: &mut [Value]) {
        substitution::solve(&self.entries, fronts, values).await;
    }
}

/// Where rows are in the front at hand.
struct Places<'a> {
    fronts: &'a Fronts,
    of_row: Vec<u32>,
    of_child: Vec<usize>,
}

impl Places<'_> {
    fn set(&mut self, front: &Front) {
        let rows = front.pivots.clone().chain(self.fronts.boundary(front).iter().copied());
        for (place, row) in (0..).zip(rows) {
            self.of_row[row as usize] = place;
        }
    }

    fn add_element(&self, rows: &[u32; 6], element: &Matrix, matrix: &mut Dense<'_>) {
        let places = rows.map(|row| self.of_row.get(row as usize).copied());
        let mut entries = element.iter();
        for j in 0..6 {
            for (k, entry) in (j..6).zip(entries.by_ref()) {
                if let (Some(a), Some(b)) = (places[j], places[k]) {
                    *matrix.entry(a.min(b) as usize, a.max(b) as usize) += entry;
                }
            }
        }
    }

    /// Adds what the elimination of a child left on its boundary.
    fn add_child(&mut self, child: &Front, left: &[f64], matrix: &mut Dense<'_>) {
        self.of_child.clear();
        let boundary = self.fronts.boundary(child).iter();
        self.of_child.extend(boundary.map(|&row| self.of_row[row as usize] as usize));
        let mut left = left;
        for (j, &first) in self.of_child.iter().enumerate() {
            let places = &self.of_child[j..];
            let (entries, rest) = left.split_at(places.len());
            let column = matrix.column(first);
            places.iter().zip(entries).for_each(|(&place, entry)| column[place - first] += entry);
            left = rest;
        }
    }
}

/// The lower half of the matrix of a front, column by column, each from the diagonal on.
struct Dense<'a> {
    size: usize,
    pivot_count: usize,
    /// The columns of the pivots, which become those of the factor.
    pivots: &'a mut [f64],
    /// Those of the boundary.
    left: &'a mut [f64],
}

impl<'a> Dense<'a> {
    fn new(front: &Front, pivots: &'a mut [f64], left: &'a mut [f64]) -> Self {
        Self { size: front.size(), pivot_count: front.pivots.len(), pivots, left }
    }

    fn entry(&mut self, first: usize, last: usize) -> &mut f64 {
        match first.checked_sub(self.pivot_count) {
            None => &mut self.pivots[start(self.size, first) + last - first],
            Some(k) => &mut self.left[start(self.size - self.pivot_count, k) + last - first],
        }
    }

    fn column(&mut self, j: usize) -> &mut [f64] {
        match j.checked_sub(self.pivot_count) {
            None => &mut self.pivots[start(self.size, j)..][..self.size - j],
            Some(k) => &mut self.left[start(self.size - self.pivot_count, k)..][..self.size - j],
        }
    }

    /// Takes what the columns before it add to a column from it, and turns it into one of the factor if it is that of a pivot.
    /// Columns come in order. Gives the number of products.
    fn eliminate(&mut self, j: usize) -> Result<usize, SolveError> {
        let (size, pivot_count) = (self.size, self.pivot_count);
        if j >= pivot_count {
            let column = &mut self.left[start(size - pivot_count, j - pivot_count)..][..size - j];
            subtract(self.pivots, column, size, pivot_count);
            return Ok(pivot_count * (size - j));
        }
        let (before, from) = self.pivots.split_at_mut(start(size, j));
        let column = &mut from[..size - j];
        subtract(before, column, size, j);
        let pivot = column[0];
        if pivot.is_nan() {
            return Err(SolveError::NotPositive);
        }
        let root = if pivot > LEAST_PIVOT { pivot.sqrt() } else { 1.0 };
        let per_root = root.recip();
        column[0] = per_root;
        column[1..].iter_mut().for_each(|entry| *entry *= per_root);
        Ok(j * (size - j))
    }
}

/// Where a column begins in the lower half of a matrix.
pub(super) fn start(size: usize, j: usize) -> usize {
    j * (2 * size + 1 - j) / 2
}

fn zeros(count: usize) -> Result<Vec<f64>, SolveError> {
    let mut zeros = Vec::new();
    zeros.try_reserve_exact(count).map_err(|_| SolveError::TooLarge)?;
    zeros.resize(count, 0.0);
    Ok(zeros)
}

/// Subtracts from the end of a column what some columns of the factor add to it.
fn subtract(before: &[f64], target: &mut [f64], size: usize, count: usize) {
    let length = target.len();
    let end = |p: usize| &before[start(size, p + 1) - length..][..length];
    let fours = count / 4 * 4;
    for p in (0..fours).step_by(4) {
        let [a, b, c, d] = [end(p), end(p + 1), end(p + 2), end(p + 3)];
        let factors = [a[0], b[0], c[0], d[0]];
        for i in 0..length {
            target[i] -= factors[0] * a[i] + factors[1] * b[i] + (factors[2] * c[i] + factors[3] * d[i]);
        }
    }
    for a in (fours..count).map(end) {
        let factor = a[0];
        target.iter_mut().zip(a).for_each(|(entry, a)| *entry -= factor * a);
    }
}

#[cfg(test)]
mod tests {
    use super::super::element::entry;
    use super::*;
    use scumble_core::pace::{Slices, now};

    const SIZE: u32 = 90;

    /// Elements between rows here and there, each of which pulls its rows to their mean and a little to zero.
    fn elements() -> (Vec<[u32; 6]>, Vec<Matrix>) {
        let row =
            |i: u32, k: u32| if (i + k).is_multiple_of(11) { NONE } else { (i + k * (1 + i % 7)) % SIZE };
        let rows = (0..SIZE).map(|i| [0, 1, 2, 3, 4, 5].map(|k| row(i, k))).collect();
        let matrix = |i: u32| {
            let pull = 1.0 + f64::from(i % 5);
            let mut matrix = [-pull; 21];
            (0..6).for_each(|k| matrix[entry(k, k)] = 5.1 * pull);
            matrix
        };
        (rows, (0..SIZE).map(matrix).collect())
    }

    fn factor(
        fronts: &Fronts,
        rows: &[[u32; 6]],
        element: &dyn Fn(usize) -> Matrix,
    ) -> Result<Factor, SolveError> {
        now(Slices::new(Factor::new(fronts, rows, element, &mut Vec::new())))
    }

    #[test]
    fn solutions_solve_the_sum_of_the_elements_whatever_the_groups() {
        let (rows, matrices) = elements();
        let right: Vec<Value> = (0..SIZE).map(|i| [1.0, -2.0, 0.0, i as f32]).collect();
        for step in [1, 4, 13, SIZE] {
            let ends: Vec<_> = (1..SIZE).filter(|end| end.is_multiple_of(step)).chain([SIZE]).collect();
            let fronts = now(Slices::new(Fronts::new(&rows, &ends)));
            let mut values = right.clone();
            let factor = factor(&fronts, &rows, &|i| matrices[i]).expect("a factor");
            now(Slices::new(factor.solve(&fronts, &mut values)));
            let mut left = vec![[0.0_f64; 4]; SIZE as usize];
            for (rows, matrix) in rows.iter().zip(&matrices) {
                let pairs = (0..6).flat_map(|i| (0..6).map(move |j| (i, j)));
                for (i, j) in pairs.filter(|&(i, j)| rows[i] != NONE && rows[j] != NONE) {
                    let value = values[rows[j] as usize];
                    (0..4)
                        .for_each(|c| left[rows[i] as usize][c] += matrix[entry(i, j)] * f64::from(value[c]));
                }
            }
            for (left, right) in left.as_flattened().iter().zip(right.as_flattened()) {
                assert!((left - f64::from(*right)).abs() < 1e-3, "{left} {right} in groups of {step}");
            }
        }
    }

    #[test]
    fn a_part_that_nothing_holds_gets_some_value_and_what_is_no_number_none() {
        let rows = [[0, 1, NONE, NONE, NONE, NONE]];
        let mut matrix = [0.0; 21];
        (matrix[entry(0, 0)], matrix[entry(0, 1)], matrix[entry(1, 1)]) = (1.0, -1.0, 1.0);
        let fronts = now(Slices::new(Fronts::new(&rows, &[1, 2])));
        let mut values = [[0.5; 4], [-0.5; 4]];
        let whole = factor(&fronts, &rows, &|_| matrix).expect("a factor");
        now(Slices::new(whole.solve(&fronts, &mut values)));
        assert_eq!(values, [[0.5; 4], [0.0; 4]]);
        matrix[entry(1, 1)] = f64::NAN;
        let error = factor(&fronts, &rows, &|_| matrix).err();
        assert_eq!(error, Some(SolveError::NotPositive));
    }
}
