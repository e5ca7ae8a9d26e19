//! A set of pixels, one bit each, that also numbers its members.

use std::ops::Range;

use super::raster::{Edge, is_above, rows_between};

const BITS: usize = u64::BITS as usize;

/// A set of pixels of a picture.
#[derive(Clone, Debug)]
pub(super) struct PixelSet {
    width: i32,
    height: i32,
    words_per_row: usize,
    words: Vec<u64>,
    /// Members before each word.
    ranks: Vec<u32>,
}

impl PixelSet {
    /// The pixels that a set of edges touches, given by their ends in px.
    pub(super) fn touched_by(edges: impl Iterator<Item = [[f64; 2]; 2]>, width: u32, height: u32) -> Self {
        let words_per_row = (width as usize).div_ceil(BITS);
        let words = vec![0; words_per_row * height as usize];
        let (width, height) = (width as i32, height as i32);
        let mut set = Self { width, height, words_per_row, words, ranks: Vec::new() };
        edges.for_each(|[a, b]| set.insert_edge(a, b));
        set.number();
        set
    }

    /// Number of members.
    pub(super) fn len(&self) -> usize {
        self.words.iter().map(|word| word.count_ones() as usize).sum()
    }

    /// Whether any pixel among those columns of a row is in the set.
    pub(super) fn any_in(&self, row: i32, columns: &Range<usize>) -> bool {
        words_of(columns).any(|w| self.bits(row, w, columns) != 0)
    }

    /// Visits the members among those columns of a row, left to right: column, and number in the set.
    #[inline]
    pub(super) fn for_each_in(&self, row: i32, columns: &Range<usize>, mut visit: impl FnMut(usize, usize)) {
        for w in words_of(columns) {
            let index = row as usize * self.words_per_row + w;
            let (word, rank) = (self.words[index], self.ranks[index]);
            let mut bits = self.bits(row, w, columns);
            while bits != 0 {
                let bit = bits.trailing_zeros() as usize;
                let before = (word & ((1 << bit) - 1)).count_ones();
                visit(w * BITS + bit, (rank + before) as usize);
                bits &= bits - 1;
            }
        }
    }

    /// A word of a row with the bits of other columns cleared.
    #[inline]
    fn bits(&self, row: i32, w: usize, columns: &Range<usize>) -> u64 {
        let from = u64::MAX << columns.start.saturating_sub(w * BITS).min(BITS - 1);
        let to = u64::MAX >> ((w + 1) * BITS).saturating_sub(columns.end).min(BITS - 1);
        self.words[row as usize * self.words_per_row + w] & from & to
    }

    fn insert_edge(&mut self, a: [f64; 2], b: [f64; 2]) {
        let [top, bottom] = if is_above(a, b) { [a, b] } else { [b, a] };
        if ![a, b].as_flattened().iter().all(|c| c.is_finite()) {
            return;
        }
        if top[1] == bottom[1] {
            return self.insert_level(top[1], top[0], bottom[0]);
        }
        let edge = Edge::new(top, bottom);
        for row in rows_between(top[1], bottom[1], self.height) {
            let x0 = edge.x_at(f64::from(row).max(top[1]));
            let x1 = edge.x_at(f64::from(row + 1).min(bottom[1]));
            self.insert_span(row, x0.min(x1), x0.max(x1));
        }
    }

    fn insert_level(&mut self, y: f64, left: f64, right: f64) {
        if (0.0..f64::from(self.height)).contains(&y) {
            self.insert_span(y as i32, left, right);
        }
    }

    fn insert_span(&mut self, row: i32, left: f64, right: f64) {
        if right < 0.0 {
            return;
        }
        let first_word = row as usize * self.words_per_row;
        let end = (right as usize).saturating_add(1).min(self.width as usize);
        for column in left.max(0.0) as usize..end {
            self.words[first_word + column / BITS] |= 1 << (column % BITS);
        }
    }

    fn number(&mut self) {
        let mut members = 0;
        self.ranks = Vec::with_capacity(self.words.len());
        for word in &self.words {
            self.ranks.push(members);
            members += word.count_ones();
        }
    }
}

/// The words of a row that hold those columns.
fn words_of(columns: &Range<usize>) -> Range<usize> {
    columns.start / BITS..columns.end.div_ceil(BITS)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn members(edges: &[[[f64; 2]; 2]]) -> Vec<(i32, usize, usize)> {
        let set = PixelSet::touched_by(edges.iter().copied(), 200, 3);
        let mut found = Vec::new();
        (0..3).for_each(|row| set.for_each_in(row, &(0..200), |x, i| found.push((row, x, i))));
        assert_eq!(found.len(), set.len());
        found
    }

    #[test]
    fn an_edge_touches_the_pixels_that_it_passes_through() {
        assert_eq!(members(&[[[1.5, 1.5], [1.5, 0.5]]]), [(0, 1, 0), (1, 1, 1)]);
        assert_eq!(
            members(&[[[66.2, 1.5], [62.5, 1.5]]]),
            [(1, 62, 0), (1, 63, 1), (1, 64, 2), (1, 65, 3), (1, 66, 4)]
        );
        assert_eq!(members(&[[[0.5, 0.5], [2.5, 1.5]]]), [(0, 0, 0), (0, 1, 1), (1, 1, 2), (1, 2, 3)]);
    }

    #[test]
    fn an_edge_beyond_the_picture_touches_what_of_it_is_in_view() {
        assert_eq!(members(&[[[-1e9, 0.5], [0.5, 0.5]]]), [(0, 0, 0)]);
        assert_eq!(members(&[[[199.5, -1e9], [199.5, 1e9]]]), [(0, 199, 0), (1, 199, 1), (2, 199, 2)]);
        assert_eq!(members(&[[[-5.0, -5.0], [-1.0, 9.0]], [[201.0, 0.0], [999.0, 3.0]]]), []);
        assert_eq!(members(&[[[0.0, -1.0], [200.0, -1.0]], [[0.0, 3.0], [200.0, 3.0]]]), []);
    }

    #[test]
    fn only_the_columns_asked_for_are_listed() {
        let set = PixelSet::touched_by([[[0.5, 1.5], [199.5, 1.5]]].into_iter(), 200, 3);
        for columns in [0..200, 63..65, 64..128, 100..101, 128..200, 70..70] {
            let mut listed = Vec::new();
            set.for_each_in(1, &columns, |x, i| listed.push((x, i)));
            assert!(listed.iter().copied().eq(columns.clone().map(|x| (x, x))), "{columns:?}");
            assert_eq!(set.any_in(1, &columns), !columns.is_empty());
            assert!(!set.any_in(0, &columns));
        }
    }
}
