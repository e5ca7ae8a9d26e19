//! The linear system of one region for one set of coloured sides.
//!
//! Unknowns on coloured sides are fixed and leave the system; what couples them to the others goes to the right-
//! hand side. The rest keeps the region's order of elimination.

use scumble_core::{BlendColor, pace, sort};

use super::SolveError;
use super::cholesky::Factor;
use super::dofs::Unknowns;
use super::element::{self, Matrix};
use super::fronts::Fronts;
use super::substitution::{TileColumn, Value};

/// A system, analysed; and factored once its factor is asked for.
#[derive(Debug)]
pub(super) struct System {
    /// Where the value of each unknown of the region is: the free ones come first, in the order of their rows, the fixed
    /// ones after them.
    place_of: Vec<u32>,
    couplings: Couplings,
    fronts: Fronts,
    /// The places of each element's unknowns, which are its rows; none once they are factored.
    rows: Vec<[u32; 6]>,
    factor: Option<Factor>,
}

impl System {
    /// Finds the fronts of the factor.
    pub(super) async fn new(unknowns: &Unknowns, fixed: &[bool]) -> Self {
        let place_of = places(fixed);
        let mut rows = Vec::with_capacity(unknowns.of_element.len());
        let row = |dof: u32| place_of[dof as usize];
        pace::for_each(&unknowns.of_element, |dofs| rows.push(dofs.map(row))).await;
        let row_count = fixed.iter().filter(|fixed| !**fixed).count();
        let fronts = Fronts::new(&unknowns.pattern, &place_of, row_count, &rows);
        pace::pause_after(rows.len()).await;
        Self { place_of, couplings: Couplings::default(), fronts, rows, factor: None }
    }

    /// The size of its factor, in columns of tiles; 0 before it is factored.
    pub(super) fn column_count(&self) -> usize {
        self.factor.as_ref().map_or(0, Factor::column_count)
    }

    /// The memory of its factor.
    pub(super) fn into_memory(self) -> Option<Vec<TileColumn>> {
        self.factor.map(Factor::into_memory)
    }

    #[cfg(test)]
    pub(super) fn is_factored(&self) -> bool {
        self.factor.is_some()
    }

    /// Computes the factor, and what couples rows to fixed unknowns, if that is not done yet; the elements are those of the
    /// analysis.
    pub(super) async fn factor(
        &mut self,
        matrix: &dyn Fn(usize) -> Matrix,
        memory: &mut Vec<TileColumn>,
    ) -> Result<(), SolveError> {
        if self.factor.is_none() {
            let (rows, row_count) = (&self.rows, self.fronts.row_count());
            let mut couplings = Vec::new();
            let mut element = |i: usize| {
                let matrix = matrix(i);
                couple(&rows[i], row_count as u32, &matrix, &mut couplings);
                matrix
            };
            self.factor = Some(Factor::new(&self.fronts, rows, &mut element, memory).await?);
            self.rows = Vec::new();
            self.couplings = Couplings::new(&couplings, row_count).await;
        }
        Ok(())
    }

    /// Where the value of each unknown is among those that [`System::solve`] gives.
    pub(super) fn places(&self) -> &[u32] {
        &self.place_of
    }

    /// The right-hand sides of all rows, and the values of the fixed unknowns after them: the mean where one has two. Loads are
    /// colours, each by what an unknown has of it.
    pub(super) fn right_hand_sides<'a>(
        &self,
        fixed: impl Iterator<Item = ([u32; 3], &'a [BlendColor; 3])>,
        loads: impl Iterator<Item = ([u32; 6], [f64; 6], BlendColor)>,
    ) -> Vec<Value> {
        let mut values = vec![[0.0; 4]; self.place_of.len()];
        let (sums, fixed_values) = values.split_at_mut(self.fronts.row_count());
        let mut is_known = vec![false; fixed_values.len()];
        for (dofs, colors) in fixed {
            for (dof, color) in dofs.into_iter().zip(colors) {
                let value = color.map(|c| c as f32);
                let i = self.place_of[dof as usize] as usize - sums.len();
                fixed_values[i] = if is_known[i] { mean(fixed_values[i], value) } else { value };
                is_known[i] = true;
            }
        }
        self.couplings.subtract(fixed_values, sums);
        for (dofs, parts, color) in loads {
            for (dof, part) in dofs.into_iter().zip(parts) {
                if let Some(sum) = sums.get_mut(self.place_of[dof as usize] as usize) {
                    add(sum, part as f32, color.map(|c| c as f32));
                }
            }
        }
        values
    }

    /// The values of all unknowns from [`System::right_hand_sides`]; `None` before the system is factored.
    pub(super) async fn solve(&self, mut values: Vec<Value>) -> Option<Vec<Value>> {
        let factor = self.factor.as_ref()?;
        factor.solve(&self.fronts, &mut values[..self.fronts.row_count()]).await;
        Some(values)
    }
}

fn mean(a: Value, b: Value) -> Value {
    [0, 1, 2, 3].map(|i| 0.5 * (a[i] + b[i]))
}

fn add(sum: &mut Value, factor: f32, value: Value) {
    sum.iter_mut().zip(value).for_each(|(sum, value)| *sum += factor * value);
}

/// The place of each unknown.
fn places(fixed: &[bool]) -> Vec<u32> {
    let mut next = [0, fixed.iter().filter(|fixed| !**fixed).count() as u32];
    let place = |&fixed: &bool| {
        let next = &mut next[usize::from(fixed)];
        *next += 1;
        *next - 1
    };
    fixed.iter().map(place).collect()
}

/// What couples rows to fixed unknowns, row by row: so what is added to is always at hand.
#[derive(Debug, Default)]
struct Couplings {
    /// How many couplings a row has, and the row, where it has any. Rows with as many come one after another: a processor
    /// foresees the end of a loop that is as long as the last one.
    rows: Vec<(u64, u32)>,
    /// Which of the fixed unknowns, and the entry.
    list: Vec<(u32, f32)>,
}

impl Couplings {
    /// Sorts rows, places of fixed unknowns and entries: by how many each row has, then by rows.
    async fn new(unsorted: &[(u32, u32, f32)], row_count: usize) -> Self {
        let mut next = vec![0; row_count];
        unsorted.iter().for_each(|&(row, ..)| next[row as usize] += 1);
        let mut rows: Vec<_> = next.iter().copied().zip(0..).filter(|&(count, _)| count > 0).collect();
        sort::sort(&mut rows);
        pace::pause_after(rows.len()).await;
        let mut end = 0;
        for &(count, row) in &rows {
            next[row as usize] = end;
            end += count;
        }
        let mut list = vec![(0, 0.0); unsorted.len()];
        pace::for_each(unsorted, |&(row, place, entry)| {
            list[next[row as usize] as usize] = (place - row_count as u32, entry);
            next[row as usize] += 1;
        })
        .await;
        Self { rows, list }
    }

    fn subtract(&self, fixed_values: &[Value], sums: &mut [Value]) {
        let mut left = &self.list[..];
        for &(count, row) in &self.rows {
            let (own, others) = left.split_at(count as usize);
            left = others;
            let sum = &mut sums[row as usize];
            own.iter().for_each(|&(fixed, entry)| add(sum, -entry, fixed_values[fixed as usize]));
        }
    }
}

/// Collects the entries between rows and fixed unknowns, which come after them, of an element.
fn couple(places: &[u32; 6], row_count: u32, matrix: &Matrix, couplings: &mut Vec<(u32, u32, f32)>) {
    if places.iter().all(|&place| place < row_count) {
        return;
    }
    for i in (0..6).filter(|&i| places[i] < row_count) {
        for j in (0..6).filter(|&j| places[j] >= row_count) {
            couplings.push((places[i], places[j], matrix[element::entry(i, j)] as f32));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scumble_core::pace::{Slices, now};

    #[test]
    fn couplings_take_the_fixed_values_off_the_rows_that_have_any() {
        // Rows, places beyond the four rows, and entries, in the order of no row.
        let unsorted = [(3, 5, 1.0), (0, 4, 2.0), (2, 5, 0.5), (3, 4, 3.0), (2, 5, 0.25), (0, 5, -1.0)];
        let fixed_values = [[1.0, 0.0, 2.0, 4.0], [8.0, 16.0, 0.0, 1.0]];
        let couplings = now(Slices::new(Couplings::new(&unsorted, 4)));
        assert_eq!(couplings.rows, [(2, 0), (2, 2), (2, 3)]);
        let mut sums = [[100.0; 4]; 4];
        couplings.subtract(&fixed_values, &mut sums);
        let mut expected = [[100.0; 4]; 4];
        for (row, place, entry) in unsorted {
            add(&mut expected[row as usize], -entry, fixed_values[place as usize - 4]);
        }
        assert_eq!(sums, expected);
        for row_count in [0, 4] {
            let none = now(Slices::new(Couplings::new(&[], row_count)));
            let mut sums = vec![[1.0; 4]; row_count];
            none.subtract(&fixed_values, &mut sums);
            assert_eq!(sums, vec![[1.0; 4]; row_count]);
        }
    }

    #[test]
    fn rows_with_fewer_couplings_come_first() {
        let unsorted = [(0, 3, 1.0), (2, 3, 1.0), (0, 4, 1.0), (1, 3, 1.0), (0, 5, 1.0)];
        let couplings = now(Slices::new(Couplings::new(&unsorted, 3)));
        assert_eq!(couplings.rows, [(1, 1), (1, 2), (3, 0)]);
        assert_eq!(couplings.list, [(0, 1.0), (0, 1.0), (0, 1.0), (1, 1.0), (2, 1.0)]);
    }
}
