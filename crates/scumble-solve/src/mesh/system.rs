//! The linear system of one region for one set of coloured sides: sparse Cholesky, one right-hand side a channel.
//!
//! Unknowns on coloured sides are fixed and leave the system; what couples them to the others goes to the right-
//! hand side. The rest keeps the region's order of elimination, so the matrix needs no permutation.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::sparse::linalg::cholesky::simplicial::{self, SimplicialLltRef, SymbolicSimplicialCholesky};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par};
use kurbo::Point;
use scumble_core::BlendColor;

use super::SolveError;
use super::element;

/// Row of an unknown that is fixed.
const FIXED: u32 = u32::MAX;

/// Where a part of the region hangs on the rest by triangles without area alone, the last pivot of that part is zero
/// but for rounding. Pivots up to this are taken as one, so that the part gets some value within the range.
const LEAST_PIVOT: f64 = 1e-12;

/// Largest number of entries of a factor: what signed 32-bit indices reach.
const MAX_ENTRIES: u64 = i32::MAX as u64;

/// What one element adds to the matrix.
#[derive(Clone, Copy, Debug)]
pub(super) struct Element<'a> {
    pub(super) corners: [Point; 3],
    /// Its unknowns at corners 0, 1, 2 and in the middle of edges 01, 12, 20.
    pub(super) dofs: [u32; 6],
    /// What sources add.
    pub(super) mass: Option<&'a element::Matrix>,
}

/// A system, analysed; and factored once its factor is asked for.
#[derive(Debug)]
pub(super) struct System {
    /// The row of each unknown of the region, or [`FIXED`].
    row_of: Vec<u32>,
    matrix: Upper,
    /// A row, a fixed unknown, and the entry between them.
    couplings: Vec<(u32, u32, f64)>,
    symbolic: SymbolicSimplicialCholesky<u32>,
    /// Values of the factor; empty until it is computed.
    factor: Vec<f64>,
}

impl System {
    /// Sets up the matrix and finds the pattern of its factor.
    pub(super) fn new<'a>(
        elements: &mut dyn Iterator<Item = Element<'a>>,
        fixed: &[bool],
    ) -> Result<Self, SolveError> {
        let row_of = rows(fixed);
        let size = fixed.iter().filter(|&&fixed| !fixed).count();
        let (matrix, couplings) = assemble(elements, &row_of, size);
        let symbolic = matrix.analyse()?;
        Ok(Self { row_of, matrix, couplings, symbolic, factor: Vec::new() })
    }

    #[cfg(test)]
    pub(super) fn is_factored(&self) -> bool {
        !self.factor.is_empty()
    }

    /// Computes the factor if that is not done yet.
    pub(super) fn factor(&mut self) -> Result<(), SolveError> {
        if self.factor.is_empty() {
            self.factor = self.matrix.factor(&self.symbolic)?;
        }
        Ok(())
    }

    /// Computes some channels of the free values of a factored system from the fixed ones and from loads on unknowns.
    pub(super) fn solve(
        &self,
        values: &mut [BlendColor],
        channels: &[usize],
        loads: &mut dyn Iterator<Item = (u32, BlendColor)>,
    ) {
        let size = self.matrix.size();
        let mut columns = vec![0.0; channels.len() * size];
        for &(row, fixed, entry) in &self.couplings {
            for (i, &channel) in channels.iter().enumerate() {
                columns[i * size + row as usize] -= entry * values[fixed as usize][channel];
            }
        }
        for (dof, load) in loads {
            let row = self.row_of[dof as usize];
            for (i, &channel) in channels.iter().enumerate().filter(|_| row != FIXED) {
                columns[i * size + row as usize] += load[channel];
            }
        }
        SimplicialLltRef::new(&self.symbolic, &self.factor).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(&mut columns, size, channels.len()),
            Par::Seq,
            MemStack::new(&mut []),
        );
        for (value, &row) in values.iter_mut().zip(&self.row_of).filter(|(_, row)| **row != FIXED) {
            for (i, &channel) in channels.iter().enumerate() {
                value[channel] = columns[i * size + row as usize];
            }
        }
    }
}

fn rows(fixed: &[bool]) -> Vec<u32> {
    let mut next = 0;
    let row = |&fixed: &bool| {
        if fixed {
            return FIXED;
        }
        next += 1;
        next - 1
    };
    fixed.iter().map(row).collect()
}

/// The upper triangle of a symmetric matrix, column by column. Rows are in no order, and entries of the same row
/// and column add up: the simplicial routines scatter a column before they use it.
#[derive(Debug)]
struct Upper {
    column_starts: Vec<u32>,
    rows: Vec<u32>,
    entries: Vec<f64>,
}

impl Upper {
    /// Puts triplets of row, column, entry into columns.
    fn new(size: usize, triplets: &[(u32, u32, f64)]) -> Self {
        let mut column_starts = vec![0; size + 1];
        for &(_, column, _) in triplets {
            column_starts[column as usize + 1] += 1;
        }
        for column in 0..size {
            column_starts[column + 1] += column_starts[column];
        }
        let mut next = column_starts.clone();
        let (mut rows, mut entries) = (vec![0; triplets.len()], vec![0.0; triplets.len()]);
        for &(row, column, entry) in triplets {
            let place = &mut next[column as usize];
            (rows[*place as usize], entries[*place as usize]) = (row, entry);
            *place += 1;
        }
        Self { column_starts, rows, entries }
    }

    fn size(&self) -> usize {
        self.column_starts.len() - 1
    }

    fn pattern(&self) -> SymbolicSparseColMatRef<'_, u32> {
        let size = self.size();
        SymbolicSparseColMatRef::new_unsorted_checked(size, size, &self.column_starts, None, &self.rows)
    }

    fn analyse(&self) -> Result<SymbolicSimplicialCholesky<u32>, SolveError> {
        let size = self.size();
        let scratch = simplicial::prefactorize_symbolic_cholesky_scratch::<u32>(size, self.rows.len())
            .or(simplicial::factorize_simplicial_symbolic_cholesky_scratch::<u32>(size));
        let mut memory = MemBuffer::try_new(scratch).map_err(|_| SolveError::TooLarge)?;
        let stack = MemStack::new(&mut memory);
        let (mut tree, mut counts) = (vec![0; size], vec![0; size]);
        let tree = simplicial::prefactorize_symbolic_cholesky(&mut tree, &mut counts, self.pattern(), stack);
        if counts.iter().map(|&count| u64::from(count)).sum::<u64>() > MAX_ENTRIES {
            return Err(SolveError::TooLarge);
        }
        simplicial::factorize_simplicial_symbolic_cholesky(self.pattern(), tree, &counts, stack)
            .map_err(|_| SolveError::TooLarge)
    }

    fn factor(&self, symbolic: &SymbolicSimplicialCholesky<u32>) -> Result<Vec<f64>, SolveError> {
        let scratch = simplicial::factorize_simplicial_numeric_llt_scratch::<u32, f64>(self.size());
        let mut memory = MemBuffer::try_new(scratch).map_err(|_| SolveError::TooLarge)?;
        let mut factor = Vec::new();
        factor.try_reserve_exact(symbolic.len_val()).map_err(|_| SolveError::TooLarge)?;
        factor.resize(symbolic.len_val(), 0.0);
        simplicial::factorize_simplicial_numeric_llt(
            &mut factor,
            SparseColMatRef::new(self.pattern(), &self.entries),
            LltRegularization {
                dynamic_regularization_delta: 1.0,
                dynamic_regularization_epsilon: LEAST_PIVOT,
            },
            symbolic,
            MemStack::new(&mut memory),
        )
        .map_err(|_| SolveError::NotPositive)?;
        Ok(factor)
    }
}

/// The matrix of the free unknowns, and the entries between them and the fixed ones.
fn assemble<'a>(
    elements: &mut dyn Iterator<Item = Element<'a>>,
    row_of: &[u32],
    size: usize,
) -> (Upper, Vec<(u32, u32, f64)>) {
    let mut parts = Parts { row_of, diagonal: vec![0.0; size], triplets: Vec::new(), to_fixed: Vec::new() };
    parts.triplets.reserve(12 * elements.size_hint().0 + size);
    for Element { corners, dofs, mass } in elements {
        let weights = element::weights(corners);
        let mass_of = |i: usize, j: usize| mass.map_or(0.0, |mass| mass[i][j]);
        for (i, entry) in (0..6).zip(element::diagonal(weights)) {
            parts.add(dofs[i], dofs[i], entry + mass_of(i, i));
        }
        for (i, j, entry) in element::couplings(weights) {
            parts.add(dofs[i], dofs[j], entry + mass_of(i, j));
        }
        if mass.is_some() {
            // A corner and the middle of the opposite edge.
            (0..3).for_each(|i| parts.add(dofs[i], dofs[3 + (i + 1) % 3], mass_of(i, 3 + (i + 1) % 3)));
        }
    }
    parts.triplets.extend((0..).zip(parts.diagonal).map(|(row, entry)| (row, row, entry)));
    (Upper::new(size, &parts.triplets), parts.to_fixed)
}

/// The entries of a matrix so far.
struct Parts<'a> {
    row_of: &'a [u32],
    diagonal: Vec<f64>,
    triplets: Vec<(u32, u32, f64)>,
    to_fixed: Vec<(u32, u32, f64)>,
}

impl Parts<'_> {
    /// Adds an entry on the diagonal, or two equal ones on either side of it.
    fn add(&mut self, a: u32, b: u32, entry: f64) {
        match (self.row_of[a as usize], self.row_of[b as usize]) {
            (FIXED, FIXED) => {}
            (FIXED, row) => self.to_fixed.push((row, a, entry)),
            (row, FIXED) => self.to_fixed.push((row, b, entry)),
            (row, other) if row == other => self.diagonal[row as usize] += entry,
            (row, other) => self.triplets.push((row.min(other), row.max(other), entry)),
        }
    }
}
