//! Paints flat shapes: the union of a shape's triangles, sample by sample, then its colour over what is there.

use std::ops::Range;

use kurbo::Affine;

use super::canvas::{Canvas, over};
use super::field_painter::px_corners;
use super::raster::{SAMPLES, SampleSpans, ScanTriangle};
use crate::scene::Shape;

/// The samples of every pixel that a shape covers.
pub(super) struct Coverage {
    width: usize,
    /// One bit a sample, for each pixel.
    masks: Vec<u16>,
    /// The columns of each row in which bits may be set.
    touched: Vec<Range<usize>>,
    /// The rows in which bits may be set.
    rows: Range<usize>,
}

impl Coverage {
    /// Of nothing.
    pub(super) fn new(canvas: &Canvas) -> Self {
        let (width, height) = (canvas.width() as usize, canvas.height() as usize);
        Self { width, masks: vec![0; width * height], touched: vec![0..0; height], rows: 0..0 }
    }

    /// Paints a shape and forgets it.
    pub(super) fn paint(&mut self, canvas: &mut Canvas, shape: &Shape, px_from_du: Affine) {
        for triangle in &shape.triangles {
            let corners = px_corners(triangle, px_from_du);
            if let Some(scan) = ScanTriangle::new(corners, canvas.width(), canvas.height()) {
                self.add(&scan, canvas);
            }
        }
        self.paint_covered(canvas, shape.color.0);
    }

    fn add(&mut self, scan: &ScanTriangle, canvas: &Canvas) {
        for row in scan.rows(canvas.height()) {
            let spans = scan.sample_spans(row, canvas.width());
            let touched = spans.touched();
            if !touched.is_empty() {
                let y = row as usize;
                self.touched[y] = hull(&self.touched[y], &touched);
                self.rows = hull(&self.rows, &(y..y + 1));
                add_row(&mut self.masks[y * self.width..][..self.width], &spans);
            }
        }
    }

    fn paint_covered(&mut self, canvas: &mut Canvas, color: [u8; 4]) {
        for y in std::mem::take(&mut self.rows) {
            let columns = std::mem::take(&mut self.touched[y]);
            let masks = &mut self.masks[y * self.width..][columns.clone()];
            for (mask, pixel) in masks.iter_mut().zip(canvas.span_mut(y as i32, columns)) {
                if *mask != 0 {
                    *pixel = over(*pixel, color, mask.count_ones());
                    *mask = 0;
                }
            }
        }
    }
}

/// The least range that holds both.
fn hull(a: &Range<usize>, b: &Range<usize>) -> Range<usize> {
    if a.is_empty() { b.clone() } else { a.start.min(b.start)..a.end.max(b.end) }
}

/// Sets the samples that a triangle covers in a row.
fn add_row(masks: &mut [u16], spans: &SampleSpans) {
    let full = spans.full();
    if !full.is_empty() {
        masks[full.clone()].fill(u16::MAX);
    }
    for k in 0..SAMPLES {
        let span = spans.of_sample(k);
        if full.is_empty() {
            set(masks, span, k);
        } else {
            set(masks, span.start..full.start, k);
            set(masks, full.end..span.end, k);
        }
    }
}

fn set(masks: &mut [u16], columns: Range<usize>, sample: usize) {
    for mask in masks.get_mut(columns).into_iter().flatten() {
        *mask |= 1 << sample;
    }
}
