//! Which pixel centres and which sample points of a row a triangle covers.
//!
//! Every edge is walked from its upper to its lower end, whichever triangle it belongs to, so two triangles that
//! share an edge compute the very same crossings, and a row is cut into spans that leave no gap between them.
//! A point on a left or upper edge is inside, one on a right or lower edge is not.

use std::ops::Range;

/// Sample points in a pixel.
pub(super) const SAMPLES: usize = 16;

/// How far each sample lies from the left of its pixel: a rotated 4 × 4 grid, in which no two samples share a
/// column or a row.
pub(super) const SAMPLE_X: [f64; SAMPLES] = sample_x();

/// How far each sample lies below the top of its pixel.
pub(super) const SAMPLE_Y: [f64; SAMPLES] = sample_y();

const fn sample_x() -> [f64; SAMPLES] {
    let mut x = [0.0; SAMPLES];
    let mut k = 0;
    while k < SAMPLES {
        x[k] = (4 * (3 - k % 4) + k / 4) as f64 / 16.0 + 1.0 / 32.0;
        k += 1;
    }
    x
}

const fn sample_y() -> [f64; SAMPLES] {
    let mut y = [0.0; SAMPLES];
    let mut k = 0;
    while k < SAMPLES {
        y[k] = k as f64 / 16.0 + 1.0 / 32.0;
        k += 1;
    }
    y
}

/// A straight edge from its upper end down.
#[derive(Clone, Copy, Debug)]
pub(super) struct Edge {
    x: f64,
    y: f64,
    slope: f64,
}

impl Edge {
    /// From the upper to the lower end, in px. A level edge has no crossings; nothing asks for them.
    pub(super) fn new(top: [f64; 2], bottom: [f64; 2]) -> Self {
        Self { x: top[0], y: top[1], slope: (bottom[0] - top[0]) / (bottom[1] - top[1]) }
    }

    /// Where it crosses a height between its ends.
    pub(super) fn x_at(&self, y: f64) -> f64 {
        self.x + (y - self.y) * self.slope
    }
}

/// Whether `a` lies above `b`, or level with it and to the left.
pub(super) fn is_above(a: [f64; 2], b: [f64; 2]) -> bool {
    a[1] < b[1] || (a[1] == b[1] && a[0] < b[0])
}

/// The pixel rows that a range of heights touches, within a picture of that height.
pub(super) fn rows_between(top: f64, bottom: f64, height: i32) -> Range<i32> {
    (top.max(0.0) as i32)..(bottom.min(f64::from(height)).ceil() as i32)
}

/// A triangle cut at the height of its middle corner.
#[derive(Clone, Copy, Debug)]
pub(super) struct ScanTriangle {
    /// Heights of the upper, middle and lower corner.
    y: [f64; 3],
    /// Least and greatest x.
    x_range: [f64; 2],
    long: Edge,
    upper: Edge,
    lower: Edge,
}

/// For each sample of the pixels of one row, the pixels in which a triangle covers it.
#[derive(Clone, Copy, Debug)]
pub(super) struct SampleSpans {
    starts: [i32; SAMPLES],
    ends: [i32; SAMPLES],
}

impl ScanTriangle {
    /// `None` for a triangle that is not finite or not in a picture of that size.
    pub(super) fn new(corners: [[f64; 2]; 3], width: i32, height: i32) -> Option<Self> {
        let [a, b, c] = sorted_down(corners);
        let x_range = [a[0].min(b[0]).min(c[0]), a[0].max(b[0]).max(c[0])];
        let in_view = x_range[0] < f64::from(width) && x_range[1] > 0.0;
        let in_view = in_view && a[1] < f64::from(height) && c[1] > 0.0;
        let finite = corners.as_flattened().iter().all(|c| c.is_finite());
        (in_view && finite).then(|| Self {
            y: [a[1], b[1], c[1]],
            x_range,
            long: Edge::new(a, c),
            upper: Edge::new(a, b),
            lower: Edge::new(b, c),
        })
    }

    /// The pixel rows that it touches.
    pub(super) fn rows(&self, height: i32) -> Range<i32> {
        rows_between(self.y[0], self.y[2], height)
    }

    /// The pixel columns that it touches.
    pub(super) fn columns(&self, width: i32) -> Range<usize> {
        first_from(self.x_range[0].floor(), width) as usize..first_from(self.x_range[1], width) as usize
    }

    /// The pixels of a row whose centres it covers.
    pub(super) fn center_span(&self, row: i32, width: i32) -> Range<usize> {
        let (start, end) = self.span(f64::from(row) + 0.5, 0.5, width);
        start as usize..end.max(start) as usize
    }

    /// How many centres it covers to the left of the picture, in a row in which it covers the first one of it; as many as are
    /// worth counting.
    pub(super) fn before(&self, row: i32) -> usize {
        const MOST: i32 = 1 << 20;
        let (start, _) = self.span(f64::from(row) + 0.5, 0.5 - f64::from(MOST), MOST);
        (MOST - start) as usize
    }

    /// The pixels of a row whose samples it covers.
    pub(super) fn sample_spans(&self, row: i32, width: i32) -> SampleSpans {
        let mut spans = SampleSpans { starts: [0; SAMPLES], ends: [0; SAMPLES] };
        for k in 0..SAMPLES {
            let (start, end) = self.span(f64::from(row) + SAMPLE_Y[k], SAMPLE_X[k], width);
            spans.starts[k] = start;
            spans.ends[k] = end;
        }
        spans
    }

    /// First and end of the columns `i` for which it covers the point `(i + offset, y)`; both 0 for a height that
    /// it does not reach.
    #[inline(always)]
    fn span(&self, y: f64, offset: f64, width: i32) -> (i32, i32) {
        let a = self.long.x_at(y);
        let b = if y < self.y[1] { self.upper.x_at(y) } else { self.lower.x_at(y) };
        let left = if a < b { a } else { b };
        let right = if a > b { a } else { b };
        let inside = i32::from(self.y[0] <= y && y < self.y[2]);
        (inside * first_from(left - offset, width), inside * first_from(right - offset, width))
    }
}

impl SampleSpans {
    /// The pixels of which it covers any sample.
    pub(super) fn touched(&self) -> Range<usize> {
        let (mut start, mut end) = (i32::MAX, 0);
        for k in 0..SAMPLES {
            let used = self.starts[k] < self.ends[k];
            start = start.min(if used { self.starts[k] } else { i32::MAX });
            end = end.max(if used { self.ends[k] } else { 0 });
        }
        start.min(end) as usize..end as usize
    }

    /// The pixels of which it covers every sample; may be reversed where there are none.
    pub(super) fn full(&self) -> Range<usize> {
        let start = self.starts.iter().fold(0, |a, &b| a.max(b));
        let end = self.ends.iter().fold(i32::MAX, |a, &b| a.min(b));
        start as usize..end as usize
    }

    /// The pixels in which it covers sample `k`; may be reversed where there are none.
    pub(super) fn of_sample(&self, k: usize) -> Range<usize> {
        self.starts[k] as usize..self.ends[k] as usize
    }

    /// How many samples of a pixel it covers.
    pub(super) fn count_at(&self, column: usize) -> u32 {
        let column = column as i32;
        let mut count = 0;
        for k in 0..SAMPLES {
            count += i32::from(self.starts[k] <= column) & i32::from(column < self.ends[k]);
        }
        count as u32
    }
}

fn sorted_down([mut a, mut b, mut c]: [[f64; 2]; 3]) -> [[f64; 2]; 3] {
    if is_above(b, a) {
        (a, b) = (b, a);
    }
    if is_above(c, b) {
        (b, c) = (c, b);
    }
    if is_above(b, a) {
        (a, b) = (b, a);
    }
    [a, b, c]
}

/// The least whole number from `x` on, kept within `0..=width`; what lies less than 2⁻²⁰ above a number counts as it.
#[inline(always)]
fn first_from(x: f64, width: i32) -> i32 {
    // From 2⁵² on, consecutive floats are consecutive whole numbers: adding that much rounds, and is far cheaper
    // than a cast that minds every case.
    const SHIFT: f64 = 4_503_599_627_370_496.0;
    const UP: f64 = 0.5 - 1.0 / 1_048_576.0;
    let limit = f64::from(width);
    let x = if x > 0.0 { x } else { 0.0 };
    let x = if x < limit { x } else { limit };
    (x + UP + SHIFT).to_bits() as i32
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scan(corners: [[f64; 2]; 3]) -> ScanTriangle {
        ScanTriangle::new(corners, 100, 100).expect("in view")
    }

    #[test]
    fn samples_lie_in_distinct_rows_and_columns_around_the_centre() {
        for offsets in [SAMPLE_X, SAMPLE_Y] {
            let mut sixteenths = offsets.map(|o| (16.0 * o - 0.5) as usize);
            sixteenths.sort_unstable();
            assert!(sixteenths.iter().copied().eq(0..SAMPLES));
        }
    }

    #[test]
    fn a_centre_on_an_edge_belongs_to_the_left_and_upper_edges() {
        let upper_left = scan([[2.5, 3.5], [8.5, 3.5], [2.5, 9.5]]);
        assert_eq!(upper_left.center_span(3, 100), 2..8);
        let lower_right = scan([[8.5, 3.5], [8.5, 9.5], [2.5, 9.5]]);
        assert_eq!(lower_right.center_span(3, 100), 8..8);
        assert!(lower_right.center_span(9, 100).is_empty());
    }

    #[test]
    fn what_lies_to_the_left_of_the_picture_is_counted() {
        let (across, beside) =
            ([[-7.5, 0.0], [9.0, 0.0], [-7.5, 90.0]], [[0.5, 0.0], [9.0, 0.0], [0.5, 90.0]]);
        assert_eq!([across, beside].map(|corners| scan(corners).before(3)), [8, 0]);
        assert_eq!(scan([[-3e12, -1e12], [4e12, -1e12], [0.0, 5e12]]).before(50), 1 << 20);
    }

    #[test]
    fn spans_stay_in_the_picture_however_large_the_triangle() {
        let huge = scan([[-3e12, -1e12], [4e12, -1e12], [0.0, 5e12]]);
        assert_eq!(huge.rows(100), 0..100);
        assert_eq!(huge.center_span(50, 100), 0..100);
        assert_eq!(huge.sample_spans(50, 100).full(), 0..100);
    }

    #[test]
    fn a_triangle_out_of_view_or_not_finite_is_dropped() {
        for corner in [[-1.0, 5.0], [f64::NAN, 5.0], [f64::INFINITY, 5.0]] {
            let beside = [[-9.0, 0.0], [-2.0, 9.0], corner];
            assert!(ScanTriangle::new(beside, 100, 100).is_none(), "{corner:?}");
        }
    }

    #[test]
    fn sample_counts_are_the_covered_area() {
        let left_half = [[0.0, 0.0], [10.5, 0.0], [10.5, 100.0]];
        let right_half = [[10.5, 0.0], [20.0, 0.0], [10.5, 100.0]];
        assert_eq!(scan(left_half).sample_spans(0, 100).count_at(10), 8);
        assert_eq!(scan(right_half).sample_spans(0, 100).count_at(10), 8);
    }
}
