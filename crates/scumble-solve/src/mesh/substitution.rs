//! Solution of systems with a factor: forwards from the first pivot on, then backwards from the last, front by front.

use scumble_core::pace::Pace;

use super::fronts::{Front, Fronts};

/// The four channels of one unknown.
pub(super) type Value = [f32; 4];

/// Rows and columns of a tile.
pub(super) const TILE: usize = 4;

/// The entries of the rows of a tile in one column.
pub(super) type TileColumn = [f32; TILE];

/// A front counts as much as so many columns of tiles, between pauses.
const COLUMNS: usize = 16;

/// Replaces right-hand sides by the solutions; columns of tiles are those of all fronts.
pub(super) async fn solve(list: &[TileColumn], fronts: &Fronts, values: &mut [Value]) {
    let size = |front: &Front| front.size().next_multiple_of(TILE);
    let mut local = vec![[0.0; 4]; fronts.list.iter().map(size).max().unwrap_or(0)];
    let (mut left, mut pace) = (list, Pace::default());
    for front in &fronts.list {
        let (columns, others) = left.split_at(front.column_count());
        left = others;
        pace.work(1 + columns.len() / COLUMNS).await;
        forwards(front, columns, fronts.boundary(front), values, &mut local[..size(front)]);
    }
    let mut left = list;
    for front in fronts.list.iter().rev() {
        let (others, columns) = left.split_at(left.len() - front.column_count());
        left = others;
        pace.work(1 + columns.len() / COLUMNS).await;
        backwards(front, columns, fronts.boundary(front), values, &mut local[..size(front)]);
    }
}

/// How many columns of tiles so many pivots have, on a boundary of so many rows: in each row of tiles one for each pivot up to
/// the diagonal. At the diagonal are the inverses.
pub(super) fn column_count(pivots: usize, boundary: usize) -> usize {
    let (rows, whole) = ((pivots + boundary).div_ceil(TILE), pivots / TILE);
    TILE * whole * (whole + 1) / 2 + (rows - whole) * pivots
}

/// Solves for the pivots from the first on, and takes what they add to the boundary from there; with room for the values of the
/// front, up to the end of its last tile.
fn forwards(
    front: &Front,
    mut columns: &[TileColumn],
    boundary: &[u32],
    values: &mut [Value],
    local: &mut [Value],
) {
    let (pivots, count) = (front.pivots.start as usize..front.pivots.end as usize, front.pivots.len());
    let pivots = &mut values[pivots];
    // Of regions that are coloured at their sides alone, that is half of the factor.
    if are_zero(pivots) {
        return;
    }
    local[..count].copy_from_slice(pivots);
    local[count..].fill([0.0; 4]);
    for row in (0..local.len()).step_by(TILE) {
        let (before, others) = columns.split_at(count.min(row));
        let (own, others) = others.split_at(TILE.min(count - before.len()));
        columns = others;
        let (solved, below) = local.split_at_mut(row);
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
    pivots.copy_from_slice(&local[..count]);
    for (&row, sum) in boundary.iter().zip(&local[count..]) {
        (0..4).for_each(|i| values[row as usize][i] += sum[i]);
    }
}

/// Solves for the pivots from the last on, with the same room; the values on the boundary are known.
fn backwards(
    front: &Front,
    mut columns: &[TileColumn],
    boundary: &[u32],
    values: &mut [Value],
    local: &mut [Value],
) {
    let (pivots, count) = (front.pivots.start as usize..front.pivots.end as usize, front.pivots.len());
    local[..count].copy_from_slice(&values[pivots.clone()]);
    local[count..].fill([0.0; 4]);
    local[count..].iter_mut().zip(boundary).for_each(|(value, &row)| *value = values[row as usize]);
    for row in (0..local.len()).step_by(TILE).rev() {
        let before = count.min(row);
        let (others, own) = columns.split_at(columns.len() - TILE.min(count - before));
        let (others, before) = others.split_at(others.len() - before);
        columns = others;
        let (sums, below) = local.split_at_mut(row);
        let Some(solved) = below.first_chunk_mut::<TILE>() else { return };
        for (k, column) in own.iter().enumerate().rev() {
            // The value that was found last comes last, so that as little as possible waits for it.
            let sum = (k + 1..TILE).rev().fold(solved[k], |sum, i| minus(sum, column[i], solved[i]));
            solved[k] = sum.map(|sum| sum * column[k]);
        }
        for (column, sum) in before.iter().zip(sums) {
            let product = product(column, solved);
            (0..4).for_each(|i| sum[i] -= product[i]);
        }
    }
    values[pivots].copy_from_slice(&local[..count]);
}

/// Whether all values are zeros: all at once, without a branch for each.
fn are_zero(values: &[Value]) -> bool {
    values.as_flattened().iter().fold(0, |bits, value| bits | value.to_bits()) == 0
}

/// The product of a column of a tile and the values of its rows: sums of two, so that no product waits for another.
fn product(column: &TileColumn, values: &[Value; TILE]) -> Value {
    let product = |k: usize, i: usize| column[k] * values[k][i];
    [0, 1, 2, 3].map(|i| (product(0, i) + product(1, i)) + (product(2, i) + product(3, i)))
}

fn minus(sum: Value, factor: f32, value: Value) -> Value {
    [0, 1, 2, 3].map(|i| sum[i] - factor * value[i])
}
