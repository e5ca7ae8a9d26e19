//! The linear system of one region for one set of coloured sides.
//!
//! Unknowns on coloured sides are fixed and leave the system; what couples them to the others goes to the right-
//! hand side. The rest keeps the region's order of elimination.

use scumble_core::BlendColor;

use super::SolveError;
use super::cholesky::Factor;
use super::dofs::Dofs;
use super::element::{self, Matrix};
use super::fronts::{Fronts, NONE};

/// A system, analysed; and factored once its factor is asked for.
#[derive(Debug)]
pub(super) struct System {
    /// The row of each unknown of the region, or [`NONE`] where it is fixed.
    row_of: Vec<u32>,
    /// A row, a fixed unknown, and the entry between them.
    couplings: Vec<(u32, u32, f64)>,
    fronts: Fronts,
    /// The rows of each element; none once they are factored.
    rows: Vec<[u32; 6]>,
    factor: Option<Factor>,
}

impl System {
    /// Finds what couples the unknowns of elements, and the pattern of the factor.
    pub(super) fn new(dofs: &Dofs, matrix: &dyn Fn(usize) -> Matrix, fixed: &[bool]) -> Self {
        let row_of = rows(fixed);
        let mut couplings = Vec::new();
        let couple = |(i, dofs): (usize, &[u32; 6])| {
            let rows = dofs.map(|dof| row_of[dof as usize]);
            if rows.contains(&NONE) && rows != [NONE; 6] {
                couple(dofs, &rows, &matrix(i), &mut couplings);
            }
            rows
        };
        let rows: Vec<_> = dofs.of_triangle.iter().enumerate().map(couple).collect();
        let fronts = Fronts::new(&rows, &group_ends(&row_of, &dofs.group_ends));
        Self { row_of, couplings, fronts, rows, factor: None }
    }

    /// The memory of its factor.
    pub(super) fn into_memory(self) -> Option<Vec<f64>> {
        self.factor.map(Factor::into_memory)
    }

    #[cfg(test)]
    pub(super) fn is_factored(&self) -> bool {
        self.factor.is_some()
    }

    /// Computes the factor if that is not done yet; the elements are those of the analysis.
    pub(super) fn factor(
        &mut self,
        matrix: &dyn Fn(usize) -> Matrix,
        memory: &mut Vec<f64>,
    ) -> Result<(), SolveError> {
        if self.factor.is_none() {
            self.factor = Some(Factor::new(&self.fronts, &self.rows, matrix, memory)?);
            self.rows = Vec::new();
        }
        Ok(())
    }

    /// Computes the free values of a factored system from the fixed ones and from loads on unknowns.
    pub(super) fn solve(
        &self,
        values: &mut [BlendColor],
        loads: &mut dyn Iterator<Item = (u32, BlendColor)>,
    ) {
        let Some(factor) = &self.factor else { return };
        let mut sums = vec![[0.0; 4]; self.fronts.row_count()];
        for &(row, fixed, entry) in &self.couplings {
            add(&mut sums[row as usize], -entry, values[fixed as usize]);
        }
        for (dof, load) in loads {
            if let Some(sum) = sums.get_mut(self.row_of[dof as usize] as usize) {
                add(sum, 1.0, load);
            }
        }
        factor.solve(&self.fronts, &mut sums);
        for (value, &row) in values.iter_mut().zip(&self.row_of).filter(|(_, row)| **row != NONE) {
            *value = sums[row as usize];
        }
    }
}

fn add(sum: &mut BlendColor, factor: f64, color: BlendColor) {
    sum.iter_mut().zip(color).for_each(|(sum, value)| *sum += factor * value);
}

fn rows(fixed: &[bool]) -> Vec<u32> {
    let mut next = 0;
    let row = |&fixed: &bool| {
        if fixed {
            return NONE;
        }
        next += 1;
        next - 1
    };
    fixed.iter().map(row).collect()
}

/// Where the rows of groups of unknowns end.
fn group_ends(row_of: &[u32], ends: &[u32]) -> Vec<u32> {
    let (mut row_ends, mut row_end, mut start) = (Vec::with_capacity(ends.len()), 0, 0);
    for &end in ends {
        let rows = row_of[start..end as usize].iter().filter(|row| **row != NONE).count();
        start = end as usize;
        if rows > 0 {
            row_end += rows as u32;
            row_ends.push(row_end);
        }
    }
    row_ends
}

/// Collects the entries between free and fixed unknowns of an element.
fn couple(dofs: &[u32; 6], rows: &[u32; 6], matrix: &Matrix, couplings: &mut Vec<(u32, u32, f64)>) {
    for i in (0..6).filter(|&i| rows[i] != NONE) {
        for j in (0..6).filter(|&j| rows[j] == NONE) {
            couplings.push((rows[i], dofs[j], matrix[element::entry(i, j)]));
        }
    }
}
