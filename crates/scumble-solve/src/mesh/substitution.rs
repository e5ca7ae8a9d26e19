//! Solution of systems with a factor: forwards from the first pivot on, then backwards from the last, front by front.

use scumble_core::pace::Pace;

use super::fronts::{Front, Fronts};

/// The four channels of one unknown.
pub(super) type Value = [f32; 4];

/// Rows and columns of a tile.
pub(super) const TILE: usize = 4;

/// The entries of the rows of a tile in one column.
pub(super) type TileColumn = [f32; TILE];

/// So many columns of tiles take as long as a front takes besides.
const COLUMNS: usize = 16;

/// Replaces right-hand sides by the solutions; columns of tiles are those of all fronts.
pub(super) async fn solve(list: &[TileColumn], fronts: &Fronts, values: &mut [Value]) {
    let mut local = Vec::new();
    let (mut end, mut pace) = (0, Pace::default());
    for front in &fronts.list {
        let columns = Columns::of(front, &list[end..]);
        end += columns.list.len();
        pace.work(1 + columns.list.len() / COLUMNS).await;
        columns.forwards(front, fronts.boundary(front), values, &mut local);
    }
    for front in fronts.list.iter().rev() {
        end -= column_count(front);
        let columns = Columns::of(front, &list[end..]);
        pace.work(1 + columns.list.len() / COLUMNS).await;
        columns.backwards(front, fronts.boundary(front), values, &mut local);
    }
}

/// How many columns of tiles there are of a front.
pub(super) fn column_count(front: &Front) -> usize {
    first_column(front.size().div_ceil(TILE), front.pivots.len())
}

/// Where the columns of a row of tiles begin, given the number of pivots.
fn first_column(row: usize, pivot_count: usize) -> usize {
    let whole = row.min(pivot_count / TILE);
    TILE * whole * (whole + 1) / 2 + (row - whole) * pivot_count
}

/// The columns of the pivots of a front, tile by tile: of each row of tiles one for each pivot up to the diagonal.
/// At the diagonal are the inverses.
#[derive(Clone, Copy)]
struct Columns<'a> {
    pivot_count: usize,
    list: &'a [TileColumn],
}

impl<'a> Columns<'a> {
    fn of(front: &Front, list: &'a [TileColumn]) -> Self {
        Self { pivot_count: front.pivots.len(), list: &list[..column_count(front)] }
    }

    /// Those of a row of tiles: of the pivots before it, and of its own.
    fn row(self, row: usize) -> (&'a [TileColumn], &'a [TileColumn]) {
        let ends = [row, row + 1].map(|row| first_column(row, self.pivot_count));
        self.list[ends[0]..ends[1]].split_at(self.pivot_count.min(row * TILE))
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
        local.resize(front.size().next_multiple_of(TILE), [0.0; 4]);
        for row in 0..local.len() / TILE {
            let (before, own) = self.row(row);
            let (solved, below) = local.split_at_mut(row * TILE);
            let Some(sums) = below.first_chunk_mut::<TILE>() else { return };
            for (column, value) in before.iter().zip(solved) {
                sums.iter_mut().zip(column).for_each(|(sum, &factor)| *sum = minus(*sum, factor, *value));
            }
            for (k, column) in own.iter().enumerate() {
                let value = sums[k].map(|sum| sum * column[k]);
                sums[k] = value;
                (k + 1..TILE).for_each(|i| sums[i] = minus(sums[i], column[i], value));
            }
        }
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
        local.resize(front.size().next_multiple_of(TILE), [0.0; 4]);
        for row in (0..local.len() / TILE).rev() {
            let (before, own) = self.row(row);
            let (sums, below) = local.split_at_mut(row * TILE);
            let Some(solved) = below.first_chunk_mut::<TILE>() else { return };
            for (k, column) in own.iter().enumerate().rev() {
                let sum = (k + 1..TILE).fold(solved[k], |sum, i| minus(sum, column[i], solved[i]));
                solved[k] = sum.map(|sum| sum * column[k]);
            }
            for (column, sum) in before.iter().zip(sums) {
                *sum = (0..TILE).fold(*sum, |sum, i| minus(sum, column[i], solved[i]));
            }
        }
        values[pivots].copy_from_slice(&local[..self.pivot_count]);
    }
}

fn minus(sum: Value, factor: f32, value: Value) -> Value {
    [0, 1, 2, 3].map(|i| sum[i] - factor * value[i])
}
