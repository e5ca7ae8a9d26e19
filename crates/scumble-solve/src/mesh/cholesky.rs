//! Sparse Cholesky factorisation, front by front, and the solution of systems with the factor.
//!
//! Columns of fronts are packed: each begins at the diagonal and ends with the front. No sum runs along a column, so
//! vector instructions do not change the order of any.

use std::mem;

use scumble_core::BlendColor;

use super::SolveError;
use super::element::Matrix;
use super::fronts::{Front, Fronts, NONE};

/// Where a part of the region hangs on the rest by triangles without area alone, the last pivot of that part is zero
/// but for rounding. Pivots up to this are taken as one, so that the part gets some value within the range.
const LEAST_PIVOT: f64 = 1e-12;

/// Largest number of entries of a factor: 16 GB.
const MAX_ENTRIES: u64 = i32::MAX as u64;

/// The columns of the pivots, front by front.
#[derive(Debug)]
pub(super) struct Factor {
    entries: Vec<f64>,
}

impl Factor {
    /// Factors the sum of symmetric matrices of elements, of which the rows are given, or [`NONE`].
    pub(super) fn new(fronts: &Fronts, rows: &[[u32; 6]], elements: &[Matrix]) -> Result<Self, SolveError> {
        if fronts.entry_count() > MAX_ENTRIES {
            return Err(SolveError::TooLarge);
        }
        let mut entries = Vec::new();
        entries.try_reserve_exact(fronts.entry_count() as usize).map_err(|_| SolveError::TooLarge)?;
        let mut matrices: Vec<Vec<f64>> = Vec::with_capacity(fronts.list.len());
        let mut places = Places { fronts, of_row: vec![NONE; fronts.row_count()], of_child: Vec::new() };
        for front in &fronts.list {
            let mut matrix = zeros(front.size() * (front.size() + 1) / 2)?;
            places.set(front);
            for &element in fronts.elements(front) {
                places.add_element(front, &rows[element as usize], &elements[element as usize], &mut matrix);
            }
            let mut child = front.child;
            while let Some(of_child) = fronts.list.get(child as usize) {
                places.add_child(front, of_child, &mem::take(&mut matrices[child as usize]), &mut matrix);
                child = of_child.sibling;
            }
            eliminate(&mut matrix, front.size(), front.pivots.len())?;
            entries.extend_from_slice(&matrix[..front.entry_count()]);
            matrices.push(matrix);
        }
        Ok(Self { entries })
    }

    /// Replaces the right-hand sides by the solutions.
    pub(super) fn solve(&self, fronts: &Fronts, values: &mut [BlendColor]) {
        let mut local = Vec::new();
        let mut start = 0;
        for front in &fronts.list {
            let columns = &self.entries[start..start + front.entry_count()];
            forwards(columns, front, fronts.boundary(front), values, &mut local);
            start += front.entry_count();
        }
        for front in fronts.list.iter().rev() {
            start -= front.entry_count();
            let columns = &self.entries[start..start + front.entry_count()];
            backwards(columns, front, fronts.boundary(front), values, &mut local);
        }
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

    fn add_element(&self, front: &Front, rows: &[u32; 6], element: &Matrix, matrix: &mut [f64]) {
        let places = rows.map(|row| self.of_row.get(row as usize).map(|&place| place as usize));
        for (j, entries) in places.into_iter().zip(element) {
            let Some(j) = j else { continue };
            let start = column(front.size(), j);
            for (i, entry) in places.into_iter().zip(entries) {
                if let Some(i) = i.filter(|&i| i >= j) {
                    matrix[start + i] += entry;
                }
            }
        }
    }

    /// Adds what the elimination of a child left on its boundary.
    fn add_child(&mut self, front: &Front, child: &Front, left: &[f64], matrix: &mut [f64]) {
        self.of_child.clear();
        let boundary = self.fronts.boundary(child).iter();
        self.of_child.extend(boundary.map(|&row| self.of_row[row as usize] as usize));
        let mut left = &left[child.entry_count()..];
        for (j, &place) in self.of_child.iter().enumerate() {
            let places = &self.of_child[j..];
            let (entries, rest) = left.split_at(places.len());
            let column = &mut matrix[column(front.size(), place)..][..front.size()];
            places.iter().zip(entries).for_each(|(&place, entry)| column[place] += entry);
            left = rest;
        }
    }
}

/// What a place in a column adds to, to make the place in a packed matrix.
fn column(size: usize, j: usize) -> usize {
    j * size - j * (j + 1) / 2
}

fn zeros(count: usize) -> Result<Vec<f64>, SolveError> {
    let mut zeros = Vec::new();
    zeros.try_reserve_exact(count).map_err(|_| SolveError::TooLarge)?;
    zeros.resize(count, 0.0);
    Ok(zeros)
}

/// Turns the first columns of a packed matrix into those of its factor, and takes what they add to the others from them.
fn eliminate(matrix: &mut [f64], size: usize, pivot_count: usize) -> Result<(), SolveError> {
    for j in 0..size {
        let (before, from) = matrix.split_at_mut(column(size, j) + j);
        let target = &mut from[..size - j];
        subtract(before, target, size, j.min(pivot_count));
        if j < pivot_count {
            let pivot = target[0];
            if pivot.is_nan() {
                return Err(SolveError::NotPositive);
            }
            let root = if pivot > LEAST_PIVOT { pivot.sqrt() } else { 1.0 };
            target[0] = root;
            target[1..].iter_mut().for_each(|entry| *entry /= root);
        }
    }
    Ok(())
}

/// Subtracts from the end of a column what some columns of the factor add to it.
fn subtract(before: &[f64], target: &mut [f64], size: usize, count: usize) {
    let length = target.len();
    let end = |p: usize| &before[column(size, p) + size - length..][..length];
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

/// Solves for the pivots of a front from the first on, and takes what they add to its boundary from there.
fn forwards(
    columns: &[f64],
    front: &Front,
    boundary: &[u32],
    values: &mut [BlendColor],
    local: &mut Vec<BlendColor>,
) {
    let pivots = front.pivots.start as usize..front.pivots.end as usize;
    local.clear();
    local.extend_from_slice(&values[pivots.clone()]);
    local.resize(front.size(), [0.0; 4]);
    let mut columns = columns;
    for j in 0..pivots.len() {
        let (column, rest) = columns.split_at(front.size() - j);
        let value = local[j].map(|value| value / column[0]);
        local[j] = value;
        for (sum, entry) in local[j + 1..].iter_mut().zip(&column[1..]) {
            (0..4).for_each(|i| sum[i] -= entry * value[i]);
        }
        columns = rest;
    }
    values[pivots.clone()].copy_from_slice(&local[..pivots.len()]);
    for (&row, sum) in boundary.iter().zip(&local[pivots.len()..]) {
        (0..4).for_each(|i| values[row as usize][i] += sum[i]);
    }
}

/// Solves for the pivots of a front from the last on; the values on its boundary are known.
fn backwards(
    columns: &[f64],
    front: &Front,
    boundary: &[u32],
    values: &mut [BlendColor],
    local: &mut Vec<BlendColor>,
) {
    let pivots = front.pivots.start as usize..front.pivots.end as usize;
    local.clear();
    local.extend_from_slice(&values[pivots.clone()]);
    local.extend(boundary.iter().map(|&row| values[row as usize]));
    for j in (0..pivots.len()).rev() {
        let column = &columns[column(front.size(), j) + j..][..front.size() - j];
        let mut sum = local[j];
        for (value, entry) in local[j + 1..].iter().zip(&column[1..]) {
            (0..4).for_each(|i| sum[i] -= entry * value[i]);
        }
        local[j] = sum.map(|sum| sum / column[0]);
    }
    values[pivots.clone()].copy_from_slice(&local[..pivots.len()]);
}

#[cfg(test)]
mod tests {
    use super::*;

    const SIZE: u32 = 90;

    /// Elements between rows here and there, each of which pulls its rows to their mean and a little to zero.
    fn elements() -> (Vec<[u32; 6]>, Vec<Matrix>) {
        let row =
            |i: u32, k: u32| if (i + k).is_multiple_of(11) { NONE } else { (i + k * (1 + i % 7)) % SIZE };
        let rows = (0..SIZE).map(|i| [0, 1, 2, 3, 4, 5].map(|k| row(i, k))).collect();
        let matrix = |i: u32| {
            let pull = 1.0 + f64::from(i % 5);
            [0, 1, 2, 3, 4, 5].map(|j| [0, 1, 2, 3, 4, 5].map(|k| if j == k { 5.1 * pull } else { -pull }))
        };
        (rows, (0..SIZE).map(matrix).collect())
    }

    #[test]
    fn solutions_solve_the_sum_of_the_elements_whatever_the_groups() {
        let (rows, matrices) = elements();
        let right: Vec<BlendColor> = (0..SIZE).map(|i| [1.0, -2.0, 0.0, f64::from(i)]).collect();
        for step in [1, 4, 13, SIZE] {
            let ends: Vec<_> = (1..SIZE).filter(|end| end.is_multiple_of(step)).chain([SIZE]).collect();
            let fronts = Fronts::new(&rows, &ends);
            let mut values = right.clone();
            Factor::new(&fronts, &rows, &matrices).expect("a factor").solve(&fronts, &mut values);
            let mut left = vec![[0.0; 4]; SIZE as usize];
            for (rows, matrix) in rows.iter().zip(&matrices) {
                for (&i, entries) in rows.iter().zip(matrix).filter(|(row, _)| **row != NONE) {
                    for (&j, entry) in rows.iter().zip(entries).filter(|(row, _)| **row != NONE) {
                        (0..4).for_each(|c| left[i as usize][c] += entry * values[j as usize][c]);
                    }
                }
            }
            for (left, right) in left.as_flattened().iter().zip(right.as_flattened()) {
                assert!((left - right).abs() < 1e-9, "{left} {right} in groups of {step}");
            }
        }
    }

    #[test]
    fn a_part_that_nothing_holds_gets_some_value_and_what_is_no_number_none() {
        let rows = [[0, 1, NONE, NONE, NONE, NONE]];
        let mut matrix = [[0.0; 6]; 6];
        (matrix[0][0], matrix[0][1], matrix[1][0], matrix[1][1]) = (1.0, -1.0, -1.0, 1.0);
        let fronts = Fronts::new(&rows, &[1, 2]);
        let mut values = [[0.5; 4], [-0.5; 4]];
        Factor::new(&fronts, &rows, &[matrix]).expect("a factor").solve(&fronts, &mut values);
        assert_eq!(values, [[0.5; 4], [0.0; 4]]);
        matrix[1][1] = f64::NAN;
        let error = Factor::new(&fronts, &rows, &[matrix]).err();
        assert_eq!(error, Some(SolveError::NotPositive));
    }
}
