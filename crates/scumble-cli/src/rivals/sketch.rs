//! A drawing with scribbles as pixels.

use kurbo::{Affine, Line, ParamCurveNearest, Point, Rect};
use scumble_core::Scribble;

/// What lies on a pixel: the label of the last scribble over it, if any.
pub(crate) type SketchPixel = Option<u8>;

/// Lines and scribbles at the size of the picture to make, row by row from the top left.
#[derive(Clone, Debug)]
pub(crate) struct Sketch {
    /// Pixels in a row.
    pub(crate) width_px: usize,
    /// Rows.
    pub(crate) height_px: usize,
    /// How dark the lines make each pixel: 0 white, 255 black.
    pub(crate) darkness: Vec<u8>,
    /// The scribbles' labels.
    pub(crate) seeds: Vec<SketchPixel>,
}

/// Smallest radius of a drawn scribble: so that even a hairline makes a chain of pixels without gaps.
const MIN_RADIUS_PX: f64 = 0.75;

/// Accuracy of distances to a line, in px.
const ACCURACY_PX: f64 = 1e-3;

impl Sketch {
    /// Bare paper; the darkness has one entry for each pixel.
    pub(crate) fn new(width_px: usize, height_px: usize, darkness: Vec<u8>) -> Self {
        Self { width_px, height_px, seeds: vec![None; darkness.len()], darkness }
    }

    /// Draws a scribble over what is there.
    pub(crate) fn draw(&mut self, scribble: &Scribble, label: u8, px_from_du: Affine) {
        let radius_px = (0.5 * scribble.width_du * px_from_du.as_coeffs()[0]).max(MIN_RADIUS_PX);
        let points: Vec<Point> = scribble.points.iter().map(|p| px_from_du * *p).collect();
        let first = points.first().map(|p| Line::new(*p, *p));
        for line in first.into_iter().chain(points.windows(2).map(|w| Line::new(w[0], w[1]))) {
            self.draw_line(line, radius_px, label);
        }
    }

    /// Marks the pixels whose centres are so close to a line.
    fn draw_line(&mut self, line: Line, radius_px: f64, label: u8) {
        let bounds = Rect::from_points(line.p0, line.p1).inflate(radius_px, radius_px);
        for row in pixels(bounds.y0, bounds.y1, self.height_px) {
            for column in pixels(bounds.x0, bounds.x1, self.width_px) {
                let center = Point::new(column as f64 + 0.5, row as f64 + 0.5);
                if line.nearest(center, ACCURACY_PX).distance_sq <= radius_px * radius_px {
                    self.seeds[row * self.width_px + column] = Some(label);
                }
            }
        }
    }

    /// The pixels that share an edge with a pixel, in a fixed order.
    pub(super) fn neighbors(&self, pixel: usize) -> impl Iterator<Item = usize> + use<> {
        neighbors(pixel, self.width_px, self.height_px)
    }
}

/// The pixels of a picture of that size that share an edge with a pixel, in a fixed order.
pub(crate) fn neighbors(
    pixel: usize,
    width_px: usize,
    height_px: usize,
) -> impl Iterator<Item = usize> + use<> {
    let (column, row) = (pixel % width_px, pixel / width_px);
    let there = [row > 0, column > 0, column + 1 < width_px, row + 1 < height_px];
    let beside = [pixel.wrapping_sub(width_px), pixel.wrapping_sub(1), pixel + 1, pixel + width_px];
    beside.into_iter().zip(there).filter_map(|(neighbor, there)| there.then_some(neighbor))
}

/// Indices of the pixels that an interval touches, of so many.
fn pixels(from: f64, to: f64, count: usize) -> std::ops::Range<usize> {
    from.max(0.0) as usize..((to.max(0.0) + 1.0) as usize).min(count)
}

#[cfg(test)]
mod tests {
    use super::*;
    use scumble_core::{ScribbleKind, Srgb8};

    fn scribble(width_du: f64, points: &[(f64, f64)]) -> Scribble {
        let points = points.iter().map(|&p| p.into()).collect();
        Scribble { color: Srgb8([0; 3]).into(), kind: ScribbleKind::Fill, width_du, points }
    }

    #[test]
    fn a_scribble_covers_the_pixels_whose_centres_it_covers() {
        let mut sketch = Sketch::new(6, 4, vec![0; 24]);
        sketch.draw(&scribble(4.0, &[(4.0, 4.0), (8.0, 4.0)]), 2, Affine::scale(0.5));
        sketch.draw(&scribble(1e-3, &[(11.0, 7.0)]), 3, Affine::scale(0.5));
        sketch.draw(&scribble(9.0, &[(-90.0, 90.0)]), 4, Affine::scale(0.5));
        let rows: Vec<String> = sketch
            .seeds
            .chunks(6)
            .map(|row| row.iter().map(|seed| seed.map_or('.', |seed| (b'0' + seed) as char)).collect())
            .collect();
        assert_eq!(rows, ["......", ".2222.", ".2222.", ".....3"]);
    }

    #[test]
    fn neighbours_are_those_within_the_picture() {
        let of = |pixel| neighbors(pixel, 3, 2).collect::<Vec<_>>();
        assert_eq!((of(0), of(4), of(5)), (vec![1, 3], vec![1, 3, 5], vec![2, 4]));
        assert_eq!(neighbors(0, 1, 1).count(), 0);
    }
}
