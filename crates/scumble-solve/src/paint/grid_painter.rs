//! Paints a picture that was solved on pixels: as it is, save in pixels that a curve passes through. There each of the
//! samples has the colour of the nearest pixel from whose centre no curve keeps it.

use scumble_core::{Srgb8, clamped};

use super::canvas::{Canvas, over};
use super::encode::Encoder;
use super::field_painter::{add, mean};
use super::pixel_set::PixelSet;
use super::raster::{SAMPLE_X, SAMPLE_Y, SAMPLES};
use crate::grid::GridPicture;

/// Paints a picture over a canvas of bare paper, which has its size.
pub(super) fn paint_grid(canvas: &mut Canvas, picture: &GridPicture, paper: Option<Srgb8>) {
    let encoder = Encoder::new(picture.blend);
    let bytes: Vec<_> = picture.pixels.iter().map(|&pixel| encoder.encode(encoder.blended(pixel))).collect();
    let rim = Rim::new(picture);
    let columns = 0..picture.width_px as usize;
    for row in 0..canvas.height() {
        let start = row as usize * columns.len();
        for (pixel, color) in canvas.span_mut(row, columns.clone()).iter_mut().zip(&bytes[start..]) {
            *pixel = over(*pixel, *color, SAMPLES as u32);
        }
        rim.set.for_each_in(row, &columns, |column, _| {
            canvas.span_mut(row, column..column + 1)[0] = rim.color(&bytes, column as i32, row, paper);
        });
    }
}

/// The pixels that curves pass through, and which pieces of curves are near each of them.
struct Rim<'a> {
    picture: &'a GridPicture,
    set: PixelSet,
    edges: Vec<Vec<u32>>,
}

impl<'a> Rim<'a> {
    fn new(picture: &'a GridPicture) -> Self {
        let set = PixelSet::touched_by(picture.edges.iter().copied(), picture.width_px, picture.height_px);
        let mut edges = vec![Vec::new(); set.len()];
        for (i, &edge) in (0..).zip(&picture.edges) {
            let of_edge = PixelRange::around(edge, picture);
            for row in of_edge.rows {
                set.for_each_in(row, &of_edge.columns, |_, member| edges[member].push(i));
            }
        }
        Self { picture, set, edges }
    }

    /// The mean of the samples of a pixel.
    fn color(&self, bytes: &[[u8; 4]], column: i32, row: i32, paper: Option<Srgb8>) -> [u8; 4] {
        let mut sum = [0; 4];
        for (x, y) in SAMPLE_X.into_iter().zip(SAMPLE_Y) {
            let sample = [f64::from(column) + x, f64::from(row) + y];
            let [r, g, b, alpha] = bytes[self.source(sample, column, row)];
            add(&mut sum, [r, g, b], u32::from(alpha));
        }
        mean(sum, paper)
    }

    /// The pixel that gives a sample of a pixel its colour.
    fn source(&self, sample: [f64; 2], column: i32, row: i32) -> usize {
        let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (column + dx, row + dy)));
        let seen = around.filter(|&(x, y)| self.is_within(x, y) && self.sees(sample, [column, row], [x, y]));
        let distance2 = |&(x, y): &(i32, i32)| {
            let [dx, dy] = [f64::from(x) + 0.5 - sample[0], f64::from(y) + 0.5 - sample[1]];
            dx * dx + dy * dy
        };
        let (x, y) = seen.min_by(|a, b| distance2(a).total_cmp(&distance2(b))).unwrap_or((column, row));
        y as usize * self.picture.width_px as usize + x as usize
    }

    fn is_within(&self, x: i32, y: i32) -> bool {
        (0..self.picture.width_px as i32).contains(&x) && (0..self.picture.height_px as i32).contains(&y)
    }

    /// Whether no curve passes between a sample of one pixel and the centre of another, or the same.
    fn sees(&self, sample: [f64; 2], own: [i32; 2], other: [i32; 2]) -> bool {
        let center = other.map(|i| f64::from(i) + 0.5);
        let mut is_free = true;
        for [x, y] in [own, other] {
            self.set.for_each_in(y, &(x as usize..x as usize + 1), |_, member| {
                let mut edges = self.edges[member].iter().map(|&edge| self.picture.edges[edge as usize]);
                is_free &= !edges.any(|edge| is_crossed(edge, [sample, center]));
            });
        }
        is_free
    }
}

/// The pixels of a rectangle.
struct PixelRange {
    columns: std::ops::Range<usize>,
    rows: std::ops::Range<i32>,
}

impl PixelRange {
    /// The pixels that a line's bounding box touches.
    fn around([a, b]: [[f64; 2]; 2], picture: &GridPicture) -> Self {
        let range = |i: usize, count: u32| {
            let first = clamped(a[i].min(b[i]).floor(), [0.0, f64::from(count)]);
            first..clamped(a[i].max(b[i]).floor() + 1.0, [first, f64::from(count)])
        };
        let (columns, rows) = (range(0, picture.width_px), range(1, picture.height_px));
        Self {
            columns: columns.start as usize..columns.end as usize,
            rows: rows.start as i32..rows.end as i32,
        }
    }
}

/// Whether two lines cross.
fn is_crossed([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let turn = |a: [f64; 2], b: [f64; 2], p: [f64; 2]| {
        ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) > 0.0
    };
    turn(a, b, c) != turn(a, b, d) && turn(c, d, a) != turn(c, d, b)
}
