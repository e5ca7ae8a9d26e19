//! Paints flat shapes: the union of a shape's triangles, sample by sample, then its colour over what is there.

use std::ops::Range;
use std::sync::Arc;

use super::canvas::{Canvas, over};
use super::field_painter::{is_in_rows, px_corners};
use super::raster::{SAMPLES, SampleSpans, ScanTriangle};
use crate::scene::{Part, Shape, View};

/// What shapes cover of a view, kept for as long as they are painted there.
#[derive(Debug, Default)]
pub(super) struct Stencils {
    coverage: Option<Coverage>,
    /// Those of the shapes that were painted last, in their order.
    known: Vec<Stencil>,
}

/// What a shape covers of the pixels of a view, row by row from the left.
#[derive(Debug)]
struct Stencil {
    triangles: Arc<[[[f32; 2]; 3]]>,
    runs: Vec<Run>,
}

/// Pixels beside each other of which as many samples are covered.
#[derive(Clone, Copy, Debug)]
struct Run {
    row: u32,
    first: u32,
    end: u32,
    samples: u32,
}

impl Stencils {
    /// Paints shapes over a canvas, which is a part of a view.
    pub(super) fn paint(&mut self, canvas: &mut Canvas, shapes: &[Shape], view: &View, part: &Part) {
        self.follow(shapes, view);
        for (stencil, shape) in self.known.iter().zip(shapes) {
            stencil.paint(canvas, shape.color.0, part);
        }
    }

    /// Knows these shapes: what is between the first and the last ones that it knew is new.
    fn follow(&mut self, shapes: &[Shape], view: &View) {
        if self.coverage.as_ref().is_some_and(|coverage| coverage.view != *view) {
            *self = Self::default();
        }
        let coverage = self.coverage.get_or_insert_with(|| Coverage::new(view));
        let first = count_known(self.known.iter().zip(shapes));
        let last = count_known(self.known[first..].iter().rev().zip(shapes[first..].iter().rev()));
        let after = self.known.split_off(self.known.len() - last);
        self.known.truncate(first);
        self.known.extend(shapes[first..shapes.len() - last].iter().map(|shape| coverage.stencil(shape)));
        self.known.extend(after);
    }
}

/// Paints shapes over a canvas, which is all of a view, and keeps nothing of them.
pub(super) fn paint_once(canvas: &mut Canvas, shapes: &[Shape], view: &View) {
    if !shapes.is_empty() {
        let (mut coverage, whole) = (Coverage::new(view), view.whole());
        shapes.iter().for_each(|shape| coverage.stencil(shape).paint(canvas, shape.color.0, &whole));
    }
}

/// How many shapes the stencils beside them are of, until one is not.
fn count_known<'a>(pairs: impl Iterator<Item = (&'a Stencil, &'a Shape)>) -> usize {
    pairs.take_while(|(stencil, shape)| Arc::ptr_eq(&stencil.triangles, &shape.triangles)).count()
}

impl Stencil {
    fn paint(&self, canvas: &mut Canvas, color: [u8; 4], Part { columns, rows }: &Part) {
        let from = self.runs.partition_point(|run| run.row < rows.start);
        for run in self.runs[from..].iter().take_while(|run| run.row < rows.end) {
            let span = run.first.max(columns.start)..run.end.min(columns.end);
            if !span.is_empty() {
                let within = (span.start - columns.start) as usize..(span.end - columns.start) as usize;
                let pixels = canvas.span_mut((run.row - rows.start) as i32, within);
                if run.samples == SAMPLES as u32 && color[3] == 255 {
                    pixels.fill(color);
                } else {
                    pixels.iter_mut().for_each(|pixel| *pixel = over(*pixel, color, run.samples));
                }
            }
        }
    }
}

/// The samples of every pixel of a view that a shape covers.
#[derive(Debug)]
struct Coverage {
    view: View,
    /// One bit a sample, for each pixel.
    masks: Vec<u16>,
    /// The columns of each row in which bits may be set.
    touched: Vec<Range<usize>>,
    /// The rows in which bits may be set.
    rows: Range<usize>,
}

impl Coverage {
    /// Of nothing.
    fn new(view: &View) -> Self {
        let (width, height) = (view.width_px as usize, view.height_px as usize);
        Self { view: *view, masks: vec![0; width * height], touched: vec![0..0; height], rows: 0..0 }
    }

    /// Of a shape, which is forgotten again.
    // The page is small first: one copy of it serves both callers.
    #[inline(never)]
    fn stencil(&mut self, shape: &Shape) -> Stencil {
        let View { px_from_du, width_px, height_px } = self.view;
        let is_in = |triangle: &&_| is_in_rows(triangle, px_from_du, height_px as i32);
        for triangle in shape.triangles.iter().filter(is_in) {
            let corners = px_corners(triangle, px_from_du);
            if let Some(scan) = ScanTriangle::new(corners, width_px as i32, height_px as i32) {
                self.add(&scan);
            }
        }
        let mut runs = Vec::new();
        for row in std::mem::take(&mut self.rows) {
            self.take_row(row, &mut runs);
        }
        Stencil { triangles: Arc::clone(&shape.triangles), runs }
    }

    fn add(&mut self, scan: &ScanTriangle) {
        let width = self.view.width_px;
        for row in scan.rows(self.view.height_px as i32) {
            let spans = scan.sample_spans(row, width as i32);
            let touched = spans.touched();
            if !touched.is_empty() {
                let y = row as usize;
                self.touched[y] = hull(&self.touched[y], &touched);
                self.rows = hull(&self.rows, &(y..y + 1));
                add_row(&mut self.masks[y * width as usize..][..width as usize], &spans);
            }
        }
    }

    /// What is covered of a row, which is cleared.
    fn take_row(&mut self, row: usize, runs: &mut Vec<Run>) {
        let columns = std::mem::take(&mut self.touched[row]);
        let masks = &mut self.masks[row * self.view.width_px as usize..][columns.clone()];
        let mut first = columns.start as u32;
        for equal in masks.chunk_by(|a, b| a.count_ones() == b.count_ones()) {
            let end = first + equal.len() as u32;
            if equal[0] != 0 {
                runs.push(Run { row: row as u32, first, end, samples: equal[0].count_ones() });
            }
            first = end;
        }
        masks.fill(0);
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
