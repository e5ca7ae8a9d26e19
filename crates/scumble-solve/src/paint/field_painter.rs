//! Paints a colour field: inner pixels from their centres, pixels on the sides of curves from their samples.

use kurbo::{Affine, Point};
use scumble_core::Srgb8;

use super::canvas::{Canvas, over};
use super::encode::Encoder;
use super::gradient::{LANES, RowGradient, Shade};
use super::pixel_set::PixelSet;
use super::raster::{SAMPLES, ScanTriangle};
use crate::field::{Field, FieldTriangle};

/// Pixels that sides pass through, and what has been painted into them.
struct RimPixels {
    set: PixelSet,
    /// For each member the sums over its covered samples of red, green and blue, times alpha, and of alpha.
    sums: Vec<[u32; 4]>,
}

/// A triangle, ready to paint.
struct Prepared {
    scan: ScanTriangle,
    shade: Shade,
}

/// Paints a field over a canvas of bare paper.
pub(super) fn paint_field(canvas: &mut Canvas, field: &Field, px_from_du: Affine, paper: Option<Srgb8>) {
    let encoder = Encoder::new(field.blend);
    let height = canvas.height();
    let is_in = |triangle: &&FieldTriangle| is_in_rows(&triangle.corners, px_from_du, height);
    let triangles: Vec<_> = field.triangles.iter().filter(is_in).collect();
    let mut rim = RimPixels::new(canvas, &triangles, px_from_du);
    for triangle in triangles {
        let corners = px_corners(&triangle.corners, px_from_du);
        let Some(scan) = ScanTriangle::new(corners, canvas.width(), canvas.height()) else { continue };
        let prepared = Prepared { scan, shade: Shade::new(triangle, &corners, &encoder) };
        prepared.paint(canvas, &mut rim, &encoder);
    }
    rim.resolve(canvas, paper);
}

/// Whether a triangle touches the rows of a picture of that height, as few do where it is one strip of many.
pub(super) fn is_in_rows(corners: &[[f32; 2]; 3], px_from_du: Affine, height: i32) -> bool {
    let [_, b, _, d, _, f] = px_from_du.as_coeffs();
    let [p, q, r] = corners.map(|[x, y]| b * f64::from(x) + d * f64::from(y) + f);
    p.min(q).min(r) < f64::from(height) && p.max(q).max(r) > 0.0
}

/// Corners in px. Equal corners stay equal to the last bit.
pub(super) fn px_corners(corners: &[[f32; 2]; 3], px_from_du: Affine) -> [[f64; 2]; 3] {
    corners.map(|[x, y]| {
        let p = px_from_du * Point::new(f64::from(x), f64::from(y));
        [p.x, p.y]
    })
}

/// The edges of a triangle that are sides of curves, in px.
fn side_edges(triangle: &FieldTriangle, px_from_du: Affine) -> impl Iterator<Item = [[f64; 2]; 2]> + use<> {
    let bits = triangle.side_edges;
    let corners = (bits != 0).then(|| px_corners(&triangle.corners, px_from_du));
    corners
        .into_iter()
        .flat_map(move |c| (0..3).filter(move |i| bits >> i & 1 == 1).map(move |i| [c[i], c[(i + 1) % 3]]))
}

impl Prepared {
    fn paint(&self, canvas: &mut Canvas, rim: &mut RimPixels, encoder: &Encoder) {
        let columns = self.scan.columns(canvas.width());
        for row in self.scan.rows(canvas.height()) {
            self.paint_centers(canvas, row, encoder);
            if rim.set.any_in(row, &columns) {
                self.add_samples(rim, row, canvas.width(), encoder);
            }
        }
    }

    fn paint_centers(&self, canvas: &mut Canvas, row: i32, encoder: &Encoder) {
        let span = self.scan.center_span(row, canvas.width());
        if span.is_empty() {
            return;
        }
        // Rows begin where the triangle does, so that a part of a picture is painted as it is in the whole.
        let before = if span.start == 0 { self.scan.before(row) } else { 0 };
        let (x, y) = (span.start as f64 - before as f64 + 0.5, f64::from(row) + 0.5);
        let pixels = canvas.span_mut(row, span);
        match &self.shade {
            Shade::Flat(color) => paint_flat(pixels, *color),
            Shade::Smooth(gradient) => paint_smooth(pixels, before, &gradient.row_from(x, y), encoder),
            Shade::Fading(gradient) => paint_fading(pixels, before, &gradient.row_from(x, y), encoder),
        }
    }

    fn add_samples(&self, rim: &mut RimPixels, row: i32, width: i32, encoder: &Encoder) {
        let spans = self.scan.sample_spans(row, width);
        rim.set.for_each_in(row, &spans.touched(), |column, member| {
            let count = spans.count_at(column);
            if count > 0 {
                let [r, g, b, alpha] = self.shade.at(column as f64 + 0.5, f64::from(row) + 0.5, encoder);
                add(&mut rim.sums[member], [r, g, b], u32::from(alpha) * count);
            }
        });
    }
}

fn paint_flat(pixels: &mut [[u8; 4]], color: [u8; 4]) {
    if color[3] == 255 {
        pixels.fill(color);
    } else {
        pixels.iter_mut().for_each(|pixel| *pixel = over(*pixel, color, SAMPLES as u32));
    }
}

fn paint_smooth(pixels: &mut [[u8; 4]], before: usize, colors: &RowGradient<3>, encoder: &Encoder) {
    for (first, chunk) in (before..).step_by(LANES).zip(pixels.chunks_mut(LANES)) {
        encoder.encode_to(chunk, &colors.lanes(first));
    }
}

fn paint_fading(pixels: &mut [[u8; 4]], before: usize, colors: &RowGradient<4>, encoder: &Encoder) {
    for (first, chunk) in (before..).step_by(LANES).zip(pixels.chunks_mut(LANES)) {
        let mut fading = [[0; 4]; LANES];
        encoder.encode_fading_to(&mut fading, &colors.lanes(first));
        for (pixel, color) in chunk.iter_mut().zip(fading) {
            *pixel = over(*pixel, color, SAMPLES as u32);
        }
    }
}

/// Adds samples of one colour, `alpha` being their alphas in all.
pub(super) fn add(sum: &mut [u32; 4], [r, g, b]: [u8; 3], alpha: u32) {
    for (sum, c) in sum.iter_mut().zip([r, g, b, 1]) {
        *sum = sum.saturating_add(u32::from(c) * alpha);
    }
}

impl RimPixels {
    fn new(canvas: &Canvas, triangles: &[&FieldTriangle], px_from_du: Affine) -> Self {
        let sides = triangles.iter().flat_map(|triangle| side_edges(triangle, px_from_du));
        let set = PixelSet::touched_by(sides, canvas.width() as u32, canvas.height() as u32);
        let sums = vec![[0; 4]; set.len()];
        Self { set, sums }
    }

    /// Writes the mean of each member's samples, those that nothing covers being paper.
    fn resolve(&self, canvas: &mut Canvas, paper: Option<Srgb8>) {
        let columns = 0..canvas.width() as usize;
        for row in 0..canvas.height() {
            self.set.for_each_in(row, &columns, |column, member| {
                canvas.span_mut(row, column..column + 1)[0] = mean(self.sums[member], paper);
            });
        }
    }
}

/// The mean of the samples of a pixel.
pub(super) fn mean(mut sum: [u32; 4], paper: Option<Srgb8>) -> [u8; 4] {
    const WHOLE: u32 = 255 * SAMPLES as u32;
    let bare = WHOLE.saturating_sub(sum[3]);
    if let Some(Srgb8(paper)) = paper {
        add(&mut sum, paper, bare);
    }
    let [r, g, b, weight] = sum;
    let alpha = (weight.min(WHOLE) + SAMPLES as u32 / 2) / SAMPLES as u32;
    let [r, g, b] = [r, g, b].map(|c| ((c + weight / 2).checked_div(weight).unwrap_or(0)) as u8);
    [r, g, b, alpha as u8]
}
