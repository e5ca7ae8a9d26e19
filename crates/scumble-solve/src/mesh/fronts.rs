//! The fronts of a sparse factor: what is eliminated together where some unknowns are fixed.
//!
//! The multifrontal method (I. Duff, J. Reid, *The multifrontal solution of indefinite sparse symmetric linear
//! equations*, 1983): a *front* is a small dense matrix of a few successive rows, its *pivots*, and of its *boundary*, the
//! later ones that those are coupled to. What the elimination of the pivots leaves on the boundary is added to the parent, the
//! front that eliminates the first of these.

use std::ops::Range;

use super::pattern::{self, ByGroup, Children, Pattern};
use super::substitution::column_count;

/// The fronts of a factor, children before parents.
#[derive(Debug)]
pub(super) struct Fronts {
    pub(super) list: Vec<Front>,
    boundaries: Vec<u32>,
    children: Children,
    elements: ByGroup,
}

/// One of them.
#[derive(Debug)]
pub(super) struct Front {
    /// The rows that it eliminates.
    pub(super) pivots: Range<u32>,
    boundary: Range<u32>,
}

impl Front {
    /// Number of its rows.
    pub(super) fn size(&self) -> usize {
        self.pivots.len() + self.boundary.len()
    }

    /// Number of columns of tiles of its pivots.
    pub(super) fn column_count(&self) -> usize {
        column_count(self.pivots.len(), self.boundary.len())
    }
}

impl Fronts {
    /// Those of a pattern, given the places of its unknowns: the free ones have so many rows, in the order of the pattern, the
    /// places of fixed ones are beyond these. Elements have places in place of unknowns.
    pub(super) fn new(pattern: &Pattern, place_of: &[u32], row_count: usize, elements: &[[u32; 6]]) -> Self {
        let (mut list, mut ends, mut boundaries) = (Vec::new(), Vec::new(), Vec::new());
        let mut row = 0;
        for (unknowns, boundary) in pattern.groups() {
            let places = &place_of[unknowns.start as usize..unknowns.end as usize];
            let pivots = row..row + places.iter().filter(|&&place| place < row_count as u32).count() as u32;
            if pivots.is_empty() {
                continue;
            }
            row = pivots.end;
            let start = boundaries.len() as u32;
            let places = boundary.iter().map(|&unknown| place_of[unknown as usize]);
            boundaries.extend(places.filter(|&place| place < row_count as u32));
            ends.push(pivots.end);
            list.push(Front { pivots, boundary: start..boundaries.len() as u32 });
        }
        let front_of = pattern::group_of(&ends);
        let elements = ByGroup::new(elements, &front_of, list.len());
        let mut children = Children::of(list.len());
        for front in &list {
            let next = boundaries[front.boundary.start as usize..front.boundary.end as usize].first();
            children.add(next.map(|&row| front_of[row as usize]));
        }
        Self { list, boundaries, children, elements }
    }

    pub(super) fn boundary(&self, front: &Front) -> &[u32] {
        &self.boundaries[front.boundary.start as usize..front.boundary.end as usize]
    }

    /// The children of a front in the list, the last one first.
    pub(super) fn children(&self, front: usize) -> impl Iterator<Item = usize> {
        self.children.of_parent(front)
    }

    /// The elements of which the first row is a pivot of a front.
    pub(super) fn elements(&self, front: usize) -> &[u32] {
        self.elements.of(front)
    }

    /// Number of rows of all of them.
    pub(super) fn row_count(&self) -> usize {
        self.list.last().map_or(0, |front| front.pivots.end as usize)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// The fronts of elements with so many unknowns each, of which none is fixed.
    pub(in super::super) fn fronts(elements: &[[u32; 6]], ends: &[u32]) -> Fronts {
        let count = ends.last().copied().unwrap_or_default();
        let places: Vec<_> = (0..count).collect();
        Fronts::new(&Pattern::new(elements, ends), &places, count as usize, elements)
    }

    #[test]
    fn whichever_unknowns_are_fixed_fronts_have_all_rows_that_go_into_them() {
        let side: u32 = 8;
        let quad = |i: u32| {
            let [x, y] = [i % side, i / side];
            [[x, y], [x + 1, y], [x, y + 1], [x + 1, y + 1]].map(|[x, y]| (x * 9 + y * 37) % 81)
        };
        let elements: Vec<_> = (0..side * side)
            .map(|i| {
                let [a, b, c, d] = quad(i);
                [a, b, c, d, a, d]
            })
            .collect();
        let ends: Vec<_> = (1..=81).collect();
        let pattern = Pattern::new(&elements, &ends);
        for step in [2, 3, 7, 81] {
            assert_has_all_rows(&pattern, 81, &elements, |unknown| unknown % step == 1);
        }
    }

    /// Every front has all rows of its elements and its children, where some of so many unknowns are fixed.
    pub(in super::super) fn assert_has_all_rows(
        pattern: &Pattern,
        count: u32,
        elements: &[[u32; 6]],
        is_fixed: impl Fn(u32) -> bool,
    ) {
        let row_count = (0..count).filter(|&unknown| !is_fixed(unknown)).count();
        let mut next = [0, row_count as u32];
        let places: Vec<_> = (0..count)
            .map(|unknown| {
                let next = &mut next[usize::from(is_fixed(unknown))];
                *next += 1;
                *next - 1
            })
            .collect();
        let rows: Vec<_> = elements.iter().map(|own| own.map(|unknown| places[unknown as usize])).collect();
        let fronts = Fronts::new(pattern, &places, row_count, &rows);
        assert_eq!(fronts.row_count(), row_count);
        let mut element_count = 0;
        for (i, front) in fronts.list.iter().enumerate() {
            let has = |row: &u32| front.pivots.contains(row) || fronts.boundary(front).contains(row);
            let free = |row: &&u32| (**row as usize) < row_count;
            for &element in fronts.elements(i) {
                assert!(rows[element as usize].iter().filter(free).all(has), "front {i}");
                element_count += 1;
            }
            for child in fronts.children(i) {
                assert!(fronts.boundary(&fronts.list[child]).iter().all(has), "front {i}");
            }
        }
        let is_free = |rows: &&[u32; 6]| rows.iter().any(|&row| (row as usize) < row_count);
        assert_eq!(element_count, rows.iter().filter(is_free).count());
    }
}
