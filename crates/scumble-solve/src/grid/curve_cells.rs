//! Which curves pass between which pixels: all that a painter needs to cut a solved picture at them, at any zoom. Closed gaps
//! count as curves.
//!
//! A *cell* is the square between the centres of four neighbouring pixels, at the border what there is of one. From a
//! place in it to the centres at its corners no way leaves it: the pieces of curves that hide one from the other are
//! those in the cell.

use std::ops::Range;

use kurbo::{Line, Vec2};
use scumble_core::{Bends, Boundary, PlanarMap, clamped, sort};

use super::straights::jumps;
use crate::scene::View;

/// Pieces are listed also where they pass this close by, in px: more than a place is rounded by on a GPU.
const CLOSE_PX: f64 = 0.01;

/// The pieces of curves, and the closed gaps, in each cell.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveCells {
    /// Cells of a row: one more than pixels.
    pub columns: u32,
    /// Rows of cells.
    pub rows: u32,
    /// Row by row: the first of a cell's pieces, and their number.
    pub cells: Vec<[u32; 2]>,
    /// Ends of pieces in px from the top left of the picture: x and y of one, then of the other.
    pub pieces: Vec<[f32; 4]>,
}

impl CurveCells {
    /// Those of the curves of a map, as they bend, and its closed gaps, in what a view shows.
    pub fn new(map: &PlanarMap, bends: &Bends, boundary: &Boundary, view: &View) -> Self {
        let jumps = jumps(map, bends, boundary, view.px_from_du);
        let [columns, rows] = [view.width_px + 1, view.height_px + 1];
        let mut entries = Vec::new();
        for (line, i) in jumps.iter().zip(0..) {
            each_cell(*line, [columns, rows], |cell| entries.push((u64::from(cell), i)));
        }
        sort::sort(&mut entries);
        let mut cells = vec![[0; 2]; columns as usize * rows as usize];
        for (&(cell, _), i) in entries.iter().zip(0..) {
            let [first, count] = &mut cells[cell as usize];
            (*first, *count) = (i - *count, *count + 1);
        }
        let pieces = entries.iter().map(|&(_, i)| ends(jumps[i as usize])).collect();
        Self { columns, rows, cells, pieces }
    }

    /// Those in a cell.
    pub(super) fn pieces_of(&self, column: u32, row: u32) -> &[[f32; 4]] {
        let [first, count] = self.cells[(row * self.columns + column) as usize];
        &self.pieces[first as usize..(first + count) as usize]
    }
}

fn ends(Line { p0, p1 }: Line) -> [f32; 4] {
    [p0.x, p0.y, p1.x, p1.y].map(|c| c as f32)
}

/// Visits the cells that a line passes through or close by.
fn each_cell(line: Line, [columns, rows]: [u32; 2], mut visit: impl FnMut(u32)) {
    // Cells begin at centres of pixels.
    let line = line + Vec2::new(0.5, 0.5);
    for row in numbers([line.p0.y, line.p1.y], rows) {
        for column in numbers(ends_in_row(line, row), columns) {
            visit(row * columns + column);
        }
    }
}

/// Between which x a line is in a row or close by.
fn ends_in_row(Line { p0, p1 }: Line, row: u32) -> [f64; 2] {
    let height = p1.y - p0.y;
    let borders = [f64::from(row) - CLOSE_PX, f64::from(row + 1) + CLOSE_PX];
    let ends =
        if height == 0.0 { [0.0, 1.0] } else { borders.map(|y| ((y - p0.y) / height).clamp(0.0, 1.0)) };
    ends.map(|t| p0.x + t * (p1.x - p0.x))
}

/// The whole numbers below a count whose unit intervals something between two numbers is in or close to.
fn numbers([a, b]: [f64; 2], count: u32) -> Range<u32> {
    let first = clamped((a.min(b) - CLOSE_PX).floor(), [0.0, f64::from(count)]);
    let end = (a.max(b) + CLOSE_PX).floor() + 1.0;
    first as u32..clamped(end, [first, f64::from(count)]) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Cells of a row of three, in three rows.
    fn cells(p0: (f64, f64), p1: (f64, f64)) -> Vec<u32> {
        let mut cells = Vec::new();
        each_cell(Line::new(p0, p1), [3, 3], |cell| cells.push(cell));
        cells
    }

    #[test]
    fn a_line_is_in_the_cells_that_it_passes_through() {
        assert_eq!(cells((0.1, 0.2), (0.3, 0.1)), [0]);
        assert_eq!(cells((0.1, 1.0), (1.9, 1.0)), [3, 4, 5]);
        assert_eq!(cells((1.0, 1.9), (1.0, 0.1)), [1, 4, 7]);
        assert_eq!(cells((0.0, 0.3), (1.3, 1.6)), [0, 3, 4, 7]);
    }

    #[test]
    fn a_line_close_to_a_cell_is_in_it_too() {
        assert_eq!(cells((0.495, 0.2), (0.495, 0.3)), [0, 1]);
        assert_eq!(cells((0.2, 0.505), (0.3, 0.505)), [0, 3]);
    }

    #[test]
    fn what_is_beyond_the_picture_is_in_no_cell() {
        assert_eq!(cells((-9.0, 1.0), (-2.0, 1.0)), [0; 0]);
        assert_eq!(cells((1.0, 7.0), (1.0, 1e9)), [0; 0]);
        assert_eq!(cells((-1e9, 1.0), (1e9, 1.0)), [3, 4, 5]);
    }
}
