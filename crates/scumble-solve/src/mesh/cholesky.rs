//! Sparse Cholesky factorisation, front by front, and the solution of systems with the factor.
//!
//! Fronts are made of tiles of 4 × 4 entries, so that what is summed up stays at hand until it is complete. No sum runs along a
//! column, so vector instructions do not change the order of any.
//!
//! What is kept is of single precision: less to read at each solution, and a vector for the four channels of an unknown.
//! Along a corridor with 32 bends that is off by 0.003 of 255 levels.

use std::mem;

use scumble_core::pace::Pace;

use super::SolveError;
use super::dofs::NONE;
use super::element::{Matrix, entry};
use super::fronts::{Front, Fronts};
use super::substitution::{self, TILE, TileColumn, Value};

/// Where a part of the region hangs on the rest by triangles without area alone, the last pivot of that part is zero
/// but for rounding. Pivots up to this are taken as one, so that the part gets some value within the range.
const LEAST_PIVOT: f64 = 1e-12;

/// Largest size of a factor: 8 GB.
const MAX_COLUMNS: u64 = (1 << 31) / TILE as u64;

/// So many products take as long as a column takes besides.
const PRODUCTS: usize = 256;

/// The columns of a tile.
type Tile = [[f64; TILE]; TILE];

/// The columns of the pivots, front by front.
#[derive(Debug)]
pub(super) struct Factor {
    columns: Vec<TileColumn>,
}

impl Factor {
    /// Factors the sum of symmetric matrices of elements, each asked for once, with the places of their unknowns, as [`Fronts::new`] has them. The memory of
    /// another factor is taken where it fits: that is faster than to ask for more.
    pub(super) async fn new(
        fronts: &Fronts,
        rows: &[[u32; 6]],
        element: &mut dyn FnMut(usize) -> Matrix,
        memory: &mut Vec<TileColumn>,
    ) -> Result<Self, SolveError> {
        let count: u64 = fronts.list.iter().map(|front| front.column_count() as u64).sum();
        if count > MAX_COLUMNS {
            return Err(SolveError::TooLarge);
        }
        let count = count as usize;
        let is_fit = (count..4 * count).contains(&memory.capacity());
        let mut columns = if is_fit { mem::take(memory) } else { Vec::new() };
        columns.clear();
        columns.try_reserve_exact(count).map_err(|_| SolveError::TooLarge)?;
        let mut leftovers: Vec<Dense> = Vec::with_capacity(fronts.list.len());
        let mut places = Places { fronts, of_row: vec![NONE; fronts.row_count()], of_child: Vec::new() };
        let (mut matrix, mut pace) = (Dense::default(), Pace::default());
        for (i, front) in fronts.list.iter().enumerate() {
            matrix.clear(front)?;
            places.set(front);
            for &i in fronts.elements(i) {
                places.add_element(&rows[i as usize], &element(i as usize), &mut matrix);
            }
            for child in fronts.children(i) {
                places.add_child(&fronts.list[child], &mem::take(&mut leftovers[child]), &mut matrix);
            }
            for j in 0..matrix.size.div_ceil(TILE) {
                pace.work(TILE + matrix.eliminate(j)? / PRODUCTS).await;
            }
            matrix.append_pivots_to(&mut columns);
            leftovers.push(matrix.left()?);
            pace.work(matrix.tiles.len() / TILE).await;
        }
        Ok(Self { columns })
    }

    pub(super) fn column_count(&self) -> usize {
        self.columns.len()
    }

    pub(super) fn into_memory(self) -> Vec<TileColumn> {
        self.columns
    }

    /// Replaces the right-hand sides by the solutions.
    pub(super) async fn solve(&self, fronts: &Fronts, values: &mut [Value]) {
        substitution::solve(&self.columns, fronts, values).await;
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

    fn add_element(&self, rows: &[u32; 6], element: &Matrix, matrix: &mut Dense) {
        matrix.add(rows.map(|row| self.of_row.get(row as usize).copied()), element);
    }

    /// Adds what the elimination of a child left on its boundary.
    fn add_child(&mut self, front: &Front, child: &Dense, matrix: &mut Dense) {
        self.of_child.clear();
        let boundary = self.fronts.boundary(front).iter();
        self.of_child.extend(boundary.map(|&row| self.of_row[row as usize] as usize));
        for (i, &place) in (child.pivot_count..).zip(&self.of_child) {
            let left = &child.columns(i)[child.pivot_count..=i];
            let row = matrix.columns_mut(place);
            for (column, &place_of_column) in left.iter().zip(&self.of_child) {
                row[place_of_column][place % TILE] += column[i % TILE];
            }
        }
    }
}

/// The lower half of the matrix of a front.
#[derive(Default)]
struct Dense {
    size: usize,
    pivot_count: usize,
    /// Row by row of tiles, each up to the diagonal; the last one is filled up with zeros. What of a tile is above the diagonal
    /// means nothing.
    tiles: Vec<Tile>,
}

impl Dense {
    /// Becomes that of a front, with zeros alone.
    fn clear(&mut self, front: &Front) -> Result<(), SolveError> {
        (self.size, self.pivot_count) = (front.size(), front.pivots.len());
        let count = row_start(self.size.div_ceil(TILE));
        self.tiles.clear();
        self.tiles.try_reserve(count).map_err(|_| SolveError::TooLarge)?;
        self.tiles.resize(count, Tile::default());
        Ok(())
    }

    /// Adds the matrix of an element, of which the unknowns that are in it have these places.
    fn add(&mut self, places: [Option<u32>; 6], element: &Matrix) {
        let mut entries = element.iter();
        for j in 0..6 {
            for (k, entry) in (j..6).zip(entries.by_ref()) {
                if let (Some(a), Some(b)) = (places[j], places[k]) {
                    let row = a.max(b) as usize;
                    self.columns_mut(row)[a.min(b) as usize][row % TILE] += entry;
                }
            }
        }
    }

    /// Its tiles from the first on that has a part of the boundary.
    fn left(&self) -> Result<Self, SolveError> {
        let first = self.pivot_count / TILE;
        let (size, pivot_count) = (self.size - first * TILE, self.pivot_count % TILE);
        let (rows, mut tiles) = (first..self.size.div_ceil(TILE), Vec::new());
        tiles.try_reserve_exact(row_start(rows.len())).map_err(|_| SolveError::TooLarge)?;
        for row in rows {
            tiles.extend_from_slice(&self.tiles[row_start(row)..][first..=row]);
        }
        Ok(Self { size, pivot_count, tiles })
    }

    /// The columns of the tiles that a row of the matrix is in.
    fn columns(&self, row: usize) -> &[[f64; TILE]] {
        let row = row / TILE;
        self.tiles[row_start(row)..][..=row].as_flattened()
    }

    fn columns_mut(&mut self, row: usize) -> &mut [[f64; TILE]] {
        let row = row / TILE;
        self.tiles[row_start(row)..][..=row].as_flattened_mut()
    }

    /// Takes what the columns before it add to a column of tiles, and turns those of pivots in it into columns of the factor.
    /// They come in order. Gives the number of products.
    fn eliminate(&mut self, j: usize) -> Result<usize, SolveError> {
        let known = self.pivot_count.min(j * TILE);
        let pivots = TILE.min(self.pivot_count - known);
        let (before, below) = self.tiles.split_at_mut(row_start(j + 1));
        let (before, diagonal) = before[row_start(j)..].split_at_mut(j);
        let (before, diagonal) = (&before.as_flattened()[..known], &mut diagonal[0]);
        subtract(diagonal, before, before);
        factor(diagonal, pivots)?;
        let rows = self.size.div_ceil(TILE);
        for i in j + 1..rows {
            let row = &mut below[row_start(i) - row_start(j + 1)..];
            let (own, tiles) = row.split_at_mut(j);
            subtract(&mut tiles[0], &own.as_flattened()[..known], before);
            divide(&mut tiles[0], diagonal, pivots);
        }
        Ok(known * TILE * TILE * (rows - j))
    }

    /// Appends the columns of its pivots, as [`substitution`] has them.
    fn append_pivots_to(&self, list: &mut Vec<TileColumn>) {
        for row in (0..self.size).step_by(TILE) {
            let columns = &self.columns(row)[..self.pivot_count.min(row + TILE)];
            list.extend(columns.iter().map(|column| column.map(|entry| entry as f32)));
        }
    }
}

/// What the elimination of the first three of nine unknowns leaves of the sum of two elements. Where their entries are no numbers,
/// neither are its own, as whoever factors it finds.
pub(super) fn joined(halves: [([u32; 6], Matrix); 2]) -> Matrix {
    let mut sum = Dense { size: 9, pivot_count: 3, tiles: vec![Tile::default(); row_start(3)] };
    halves.iter().for_each(|(places, half)| sum.add(places.map(Some), half));
    for j in 0..3 {
        let _ = sum.eliminate(j);
    }
    let mut left = [0.0; 21];
    for j in 0..6 {
        (j..6).for_each(|k| left[entry(k, j)] = sum.columns(3 + k)[3 + j][(3 + k) % TILE]);
    }
    left
}

/// Where a row of tiles begins.
fn row_start(row: usize) -> usize {
    row * (row + 1) / 2
}

/// Subtracts the product of two rows of tiles.
fn subtract(tile: &mut Tile, row: &[[f64; TILE]], other: &[[f64; TILE]]) {
    if row.is_empty() {
        return;
    }
    let mut sums = Tile::default();
    for (row, other) in row.iter().zip(other) {
        for (sums, factor) in sums.iter_mut().zip(other) {
            sums.iter_mut().zip(row).for_each(|(sum, entry)| *sum += factor * entry);
        }
    }
    tile.as_flattened_mut().iter_mut().zip(sums.as_flattened()).for_each(|(entry, sum)| *entry -= sum);
}

/// Takes what the pivots of a tile at the diagonal add to another tile in the same column of tiles, and divides by them.
fn divide(tile: &mut Tile, diagonal: &Tile, pivots: usize) {
    for k in 0..TILE {
        for q in 0..pivots.min(k) {
            let (factor, from) = (diagonal[q][k], tile[q]);
            tile[k].iter_mut().zip(from).for_each(|(entry, from)| *entry -= factor * from);
        }
        if k < pivots {
            tile[k] = tile[k].map(|entry| entry * diagonal[k][k]);
        }
    }
}

/// Factors a tile at the diagonal of which so many columns are those of pivots.
fn factor(tile: &mut Tile, pivots: usize) -> Result<(), SolveError> {
    for k in 0..TILE {
        for q in 0..pivots.min(k) {
            let from = tile[q];
            tile[k].iter_mut().zip(from).for_each(|(entry, a)| *entry -= from[k] * a);
        }
        if k < pivots {
            let pivot = tile[k][k];
            if pivot.is_nan() {
                return Err(SolveError::NotPositive);
            }
            let per_root = if pivot > LEAST_PIVOT { pivot.sqrt().recip() } else { 1.0 };
            tile[k] = tile[k].map(|entry| entry * per_root);
            tile[k][k] = per_root;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::fronts::tests::fronts;
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
        element: &mut dyn FnMut(usize) -> Matrix,
    ) -> Result<Factor, SolveError> {
        now(Slices::new(Factor::new(fronts, rows, element, &mut Vec::new())))
    }

    #[test]
    fn solutions_solve_the_sum_of_the_elements_whatever_the_groups() {
        let (rows, matrices) = elements();
        let right: Vec<Value> = (0..SIZE).map(|i| [1.0, -2.0, 0.0, i as f32]).collect();
        let mut zeros = vec![[0.0; 4]; right.len()];
        *zeros.last_mut().expect("a row") = [0.0, 1.0, 0.0, -2.0];
        for (right, step) in
            [&right, &zeros].into_iter().flat_map(|right| [1, 4, 13, SIZE].map(|step| (right, step)))
        {
            let ends: Vec<_> = (1..SIZE).filter(|end| end.is_multiple_of(step)).chain([SIZE]).collect();
            let fronts = fronts(&rows, &ends);
            let mut values = right.clone();
            let factor = factor(&fronts, &rows, &mut |i| matrices[i]).expect("a factor");
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
    fn memory_of_another_factor_changes_nothing() {
        let (rows, matrices) = elements();
        let fronts = fronts(&rows, &[SIZE / 2, SIZE]);
        let columns = |mut memory: Vec<TileColumn>| {
            let mut element = |i: usize| matrices[i];
            let factor = Factor::new(&fronts, &rows, &mut element, &mut memory);
            now(Slices::new(factor)).expect("a factor").into_memory()
        };
        let fresh = columns(Vec::new());
        for count in [fresh.len() / 2, 2 * fresh.len(), 5 * fresh.len()] {
            assert_eq!(columns(vec![[f32::NAN; TILE]; count]), fresh);
        }
    }

    #[test]
    fn a_part_that_nothing_holds_gets_some_value_and_what_is_no_number_none() {
        let rows = [[0, 1, NONE, NONE, NONE, NONE]];
        let mut matrix = [0.0; 21];
        (matrix[entry(0, 0)], matrix[entry(0, 1)], matrix[entry(1, 1)]) = (1.0, -1.0, 1.0);
        let fronts = fronts(&rows, &[1, 2]);
        let mut values = [[0.5; 4], [-0.5; 4]];
        let whole = factor(&fronts, &rows, &mut |_| matrix).expect("a factor");
        now(Slices::new(whole.solve(&fronts, &mut values)));
        assert_eq!(values, [[0.5; 4], [0.0; 4]]);
        matrix[entry(1, 1)] = f64::NAN;
        let error = factor(&fronts, &rows, &mut |_| matrix).err();
        assert_eq!(error, Some(SolveError::NotPositive));
    }
}
