//! The colour of one field triangle as a quadratic in pixel coordinates.

use super::encode::{Blended, Encoder};
use crate::field::FieldTriangle;

/// Colours of a triangle that lie closer than this, in every channel, are one colour. It is below a tenth of a level.
const FLAT: f32 = 1e-6;

/// How a triangle is coloured.
#[derive(Clone, Debug)]
pub(super) enum Shade {
    /// Of one colour, with straight alpha.
    Flat([u8; 4]),
    /// Opaque everywhere.
    Smooth(Gradient<3>),
    /// With an opacity that changes from place to place, as the transparency in the fourth channel.
    Fading(Gradient<4>),
}

impl Shade {
    /// The shade of a triangle with those corners in px.
    pub(super) fn new(triangle: &FieldTriangle, corners: &[[f64; 2]; 3], encoder: &Encoder) -> Self {
        if is_flat(&triangle.colors) {
            return Self::Flat(encoder.encode(encoder.blended(triangle.colors[0])));
        }
        let blended = triangle.colors.map(|color| encoder.blended(color));
        if triangle.colors.iter().all(|color| color[3] == 1.0) {
            Self::Smooth(Gradient::new(&blended.map(|[a, b, c, _]| [a, b, c]), corners))
        } else {
            Self::Fading(Gradient::new(&blended, corners))
        }
    }

    /// The colour at a point, or, outside the triangle, about at the nearest point of it.
    pub(super) fn at(&self, x: f64, y: f64, encoder: &Encoder) -> [u8; 4] {
        let blended: Blended = match self {
            Self::Flat(color) => return *color,
            Self::Smooth(gradient) => {
                let [a, b, c] = gradient.clamped_at(x, y);
                [a, b, c, 0.0]
            }
            Self::Fading(gradient) => gradient.clamped_at(x, y),
        };
        encoder.encode(blended)
    }
}

fn is_flat(colors: &[[f32; 4]; 6]) -> bool {
    let [first, rest @ ..] = colors;
    rest.iter().all(|color| (0..4).all(|c| (color[c] - first[c]).abs() < FLAT))
}

/// One channel as `q[0] + q[1] v + q[2] w + q[3] v² + q[4] v w + q[5] w²`, where `v` and `w` are the weights of
/// corners 1 and 2.
type Quadratic = [f64; 6];

/// A quadratic of what is blended.
#[derive(Clone, Debug)]
pub(super) struct Gradient<const N: usize> {
    channels: [Quadratic; N],
    origin: [f64; 2],
    /// Change of the weights of corners 1 and 2 for a step to the right.
    right: [f64; 2],
    /// Change of the weights of corners 1 and 2 for a step down.
    down: [f64; 2],
}

/// The colours along a row: `q[0] + q[1] t + q[2] t²` for each channel, `t` pixels from its start.
#[derive(Clone, Copy, Debug)]
pub(super) struct RowGradient<const N: usize>([[f32; 3]; N]);

/// Pixels that are painted at a time.
pub(super) const LANES: usize = 8;

/// Their places in the row, from the first of them on.
const STEPS: [f32; LANES] = [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0];

impl<const N: usize> Gradient<N> {
    fn new(colors: &[[f64; N]; 6], corners: &[[f64; 2]; 3]) -> Self {
        let [o, p, q] = corners;
        let [px, py] = [p[0] - o[0], p[1] - o[1]];
        let [qx, qy] = [q[0] - o[0], q[1] - o[1]];
        let area = px * qy - py * qx;
        Self {
            channels: std::array::from_fn(|c| quadratic(colors.map(|color| color[c]))),
            origin: *o,
            right: [qy / area, -py / area],
            down: [-qx / area, px / area],
        }
    }

    /// The weights of corners 1 and 2 at a point.
    fn weights_at(&self, x: f64, y: f64) -> [f64; 2] {
        let [dx, dy] = [x - self.origin[0], y - self.origin[1]];
        [dx * self.right[0] + dy * self.down[0], dx * self.right[1] + dy * self.down[1]]
    }

    /// What is blended at a point, with negative weights taken as zero.
    fn clamped_at(&self, x: f64, y: f64) -> [f64; N] {
        let [v, w] = self.weights_at(x, y);
        let [u, v, w] = [1.0 - v - w, v, w].map(|weight| weight.max(0.0));
        let sum = u + v + w;
        self.channels.map(|q| value(&q, v / sum, w / sum))
    }

    /// The colours of a row from a point in the triangle on.
    pub(super) fn row_from(&self, x: f64, y: f64) -> RowGradient<N> {
        // In a triangle that is all but a line, the least rounding of the point would throw the weights far out.
        let [v, w] = self.weights_at(x, y).map(|weight| weight.clamp(0.0, 1.0));
        let [dv, dw] = self.right;
        let mut row = [[0.0; 3]; N];
        for (row, q) in row.iter_mut().zip(&self.channels) {
            let slope_v = q[1] + 2.0 * q[3] * v + q[4] * w;
            let slope_w = q[2] + 2.0 * q[5] * w + q[4] * v;
            let bend = q[3] * dv * dv + q[4] * dv * dw + q[5] * dw * dw;
            *row = [value(q, v, w) as f32, (slope_v * dv + slope_w * dw) as f32, bend as f32];
        }
        RowGradient(row)
    }
}

impl<const N: usize> RowGradient<N> {
    /// What is blended at some pixels in a row, the first of them `first` pixels from the start.
    #[inline]
    pub(super) fn lanes(&self, first: usize) -> [[f32; LANES]; N] {
        let first = first as f32;
        let mut lanes = [[0.0; LANES]; N];
        for (channel, q) in lanes.iter_mut().zip(&self.0) {
            for (value, step) in channel.iter_mut().zip(STEPS) {
                let t = first + step;
                *value = q[0] + t * (q[1] + t * q[2]);
            }
        }
        lanes
    }
}

fn value(q: &Quadratic, v: f64, w: f64) -> f64 {
    q[0] + v * (q[1] + q[3] * v + q[4] * w) + w * (q[2] + q[5] * w)
}

/// From the values at corners 0, 1, 2 and in the middle of edges 01, 12, 20.
fn quadratic([c0, c1, c2, m01, m12, m20]: [f64; 6]) -> Quadratic {
    [
        c0,
        4.0 * m01 - 3.0 * c0 - c1,
        4.0 * m20 - 3.0 * c0 - c2,
        2.0 * (c0 + c1 - 2.0 * m01),
        4.0 * (c0 - m01 + m12 - m20),
        2.0 * (c0 + c2 - 2.0 * m20),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;

    const CORNERS: [[f64; 2]; 3] = [[1.0, 2.0], [9.0, 3.0], [4.0, 8.0]];

    fn middle(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
        [(a[0] + b[0]) / 2.0, (a[1] + b[1]) / 2.0]
    }

    /// A gradient whose channels are a constant, a linear and a quadratic function of the place.
    fn known(x: f64, y: f64) -> [f64; 3] {
        [0.25, 0.1 * x - 0.2 * y, 0.3 - 0.01 * x * x + 0.02 * x * y + 0.03 * y * y]
    }

    fn gradient() -> Gradient<3> {
        let [a, b, c] = CORNERS;
        let nodes = [a, b, c, middle(a, b), middle(b, c), middle(c, a)];
        Gradient::new(&nodes.map(|[x, y]| known(x, y)), &CORNERS)
    }

    fn assert_close(a: [f64; 3], b: [f64; 3]) {
        assert!((0..3).all(|c| (a[c] - b[c]).abs() < 1e-5), "{a:?} {b:?}");
    }

    #[test]
    fn a_quadratic_is_met_everywhere() {
        for (x, y) in [(1.0, 2.0), (3.5, 3.5), (6.0, 4.5), (4.0, 8.0)] {
            assert_close(gradient().clamped_at(x, y), known(x, y));
            for (i, t) in (3..3 + LANES).enumerate() {
                let lanes = gradient().row_from(x, y).lanes(3);
                assert_close(lanes.map(|c| f64::from(c[i])), known(x + t as f64, y));
            }
        }
    }

    #[test]
    fn outside_the_triangle_its_rim_is_continued() {
        for (far, near) in
            [([-90.0, -99.0], CORNERS[0]), ([200.0, 3.0], CORNERS[1]), ([4.0, 500.0], CORNERS[2])]
        {
            assert_close(gradient().clamped_at(far[0], far[1]), known(near[0], near[1]));
        }
    }
}
