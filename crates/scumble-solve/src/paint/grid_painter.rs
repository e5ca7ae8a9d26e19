//! Paints a picture that was solved on pixels: as it is, save in pixels that a curve passes through; closed gaps count as
//! curves. There each of the samples has the colour of the nearest pixel from whose centre no curve keeps it.

use kurbo::{Line, Point};
use scumble_core::{Srgb8, clamped};

use super::canvas::{Canvas, over};
use super::encode::Encoder;
use super::field_painter::{add, mean};
use super::pixel_set::PixelSet;
use super::raster::{SAMPLE_X, SAMPLE_Y, SAMPLES};
use crate::grid::{GridPicture, Sight};

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
        let edges = picture.jumps.iter().map(|Line { p0, p1 }| [p0, p1].map(|p| [p.x, p.y]));
        let set = PixelSet::touched_by(edges, picture.width_px, picture.height_px);
        let mut edges = vec![Vec::new(); set.len()];
        for (i, &edge) in (0..).zip(&picture.jumps) {
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
            let sample = Point::new(f64::from(column) + x, f64::from(row) + y);
            let [r, g, b, alpha] = bytes[self.source(sample, column, row)];
            add(&mut sum, [r, g, b], u32::from(alpha));
        }
        mean(sum, paper)
    }

    /// The pixel that gives a sample of a pixel its colour.
    fn source(&self, sample: Point, column: i32, row: i32) -> usize {
        let around = (-1..=1).flat_map(|dy| (-1..=1).map(move |dx| (column + dx, row + dy)));
        let seen = around.filter(|&(x, y)| self.is_within(x, y) && self.sees(sample, [column, row], [x, y]));
        let distance2 = |&(x, y): &(i32, i32)| center([x, y]).distance_squared(sample);
        let (x, y) = seen.min_by(|a, b| distance2(a).total_cmp(&distance2(b))).unwrap_or((column, row));
        y as usize * self.picture.width_px as usize + x as usize
    }

    fn is_within(&self, x: i32, y: i32) -> bool {
        (0..self.picture.width_px as i32).contains(&x) && (0..self.picture.height_px as i32).contains(&y)
    }

    /// Whether no curve passes between a sample of one pixel and the centre of another, or the same.
    fn sees(&self, sample: Point, own: [i32; 2], other: [i32; 2]) -> bool {
        let sight = Sight::new(sample, center(other));
        let mut is_free = true;
        for [x, y] in [own, other] {
            self.set.for_each_in(y, &(x as usize..x as usize + 1), |_, member| {
                let mut edges = self.edges[member].iter().map(|&edge| self.picture.jumps[edge as usize]);
                is_free &= !edges.any(|edge| sight.is_crossed_by(edge));
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
    fn around(Line { p0, p1 }: Line, picture: &GridPicture) -> Self {
        let range = |a: f64, b: f64, count: u32| {
            let first = clamped(a.min(b).floor(), [0.0, f64::from(count)]);
            first..clamped(a.max(b).floor() + 1.0, [first, f64::from(count)])
        };
        let (columns, rows) = (range(p0.x, p1.x, picture.width_px), range(p0.y, p1.y, picture.height_px));
        Self {
            columns: columns.start as usize..columns.end as usize,
            rows: rows.start as i32..rows.end as i32,
        }
    }
}

fn center([column, row]: [i32; 2]) -> Point {
    Point::new(f64::from(column) + 0.5, f64::from(row) + 0.5)
}
