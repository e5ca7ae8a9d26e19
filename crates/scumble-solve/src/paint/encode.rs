//! From blend-space colours to 8-bit sRGB, rounded exactly and without a power per pixel.

use scumble_core::Blend;
use scumble_core::color::{LEAST_OPACITY, LINEAR_FROM_LMS, LMS_FROM_OKLAB, linear_from_srgb};

/// Three channels of several colours.
pub(super) type Lanes<const N: usize> = [[f32; N]; 3];

/// What is blended: three channels times the opacity, and the transparency, which is what the opacity lacks to 1. So
/// opaque colours stay opaque to the last bit, however they are blended.
pub(super) type Blended = [f64; 4];

/// Linear light is counted in steps of 2⁻²².
const STEPS: f32 = 4_194_304.0;

/// Steps in a bucket, as a power of two.
const BUCKET_BITS: u32 = 10;

/// Buckets between linear 0 and 1: so narrow that no two 8-bit codes begin in one of them. (Near black, where codes
/// lie closest, a code spans 1 / 3,295.)
const BUCKETS: usize = 4096;

/// The 8-bit codes of linear light, to within a step.
#[derive(Clone, Debug)]
pub(super) struct CodeTable {
    /// For each bucket the code at its start, shifted left by `BUCKET_BITS`; plus, where another code begins in the
    /// bucket, what is missing to the carry there.
    entries: [u32; BUCKETS + 1],
}

/// Turns what is blended into bytes.
///
/// What is blended is linear in the blend-space colour: sRGB itself, or, for OKLab, the cube roots of the cone
/// responses; and the transparency.
#[derive(Clone, Debug)]
pub(super) enum Encoder {
    Oklab(Box<CodeTable>),
    Srgb,
}

impl Encoder {
    pub(super) fn new(blend: Blend) -> Self {
        match blend {
            Blend::Oklab => Self::Oklab(Box::new(CodeTable::new())),
            Blend::Srgb => Self::Srgb,
        }
    }

    /// What to blend for a blend-space colour.
    pub(super) fn blended(&self, color: [f32; 4]) -> Blended {
        let [l, a, b, opacity] = color.map(f64::from);
        let [l, m, s] = match self {
            Self::Oklab(_) => LMS_FROM_OKLAB.map(|row| row[0] * l + row[1] * a + row[2] * b),
            Self::Srgb => [l, a, b],
        };
        [l, m, s, 1.0 - opacity]
    }

    /// The bytes of one colour, with straight alpha.
    pub(super) fn encode(&self, blended: Blended) -> [u8; 4] {
        let mut pixel = [[0; 4]];
        self.encode_fading_to(&mut pixel, &blended.map(|c| [c as f32]));
        let [pixel] = pixel;
        pixel
    }

    /// Writes up to `N` pixels, with straight alpha, of what is blended.
    pub(super) fn encode_fading_to<const N: usize>(&self, pixels: &mut [[u8; 4]], blended: &[[f32; N]; 4]) {
        let [l, m, s, transparency] = blended;
        let mut straight = [*l, *m, *s];
        for channel in &mut straight {
            for (c, transparency) in channel.iter_mut().zip(transparency) {
                *c /= (1.0 - transparency).max(LEAST_OPACITY as f32);
            }
        }
        self.encode_to(pixels, &straight);
        for (pixel, transparency) in pixels.iter_mut().zip(transparency) {
            pixel[3] = rounded(unit(1.0 - transparency) * 255.0) as u8;
        }
    }

    /// Writes up to `N` opaque pixels of the colours given channel by channel; what lies outside sRGB is clamped.
    #[inline]
    pub(super) fn encode_to<const N: usize>(&self, pixels: &mut [[u8; 4]], blended: &Lanes<N>) {
        match self {
            Self::Oklab(table) => table.encode_to(pixels, &linear_from_lms(blended)),
            Self::Srgb => write(pixels, &scaled(blended, 255.0), |level| level as u8),
        }
    }
}

impl CodeTable {
    fn new() -> Self {
        let mut entries = [255 << BUCKET_BITS; BUCKETS + 1];
        let mut begun = 0;
        for code in 0..255_u32 {
            let threshold = linear_from_srgb((f64::from(code) + 0.5) / 255.0);
            let steps = (threshold * f64::from(STEPS)).ceil() as u32;
            let bucket = (steps >> BUCKET_BITS) as usize;
            entries[begun..=bucket].fill(code << BUCKET_BITS);
            entries[bucket] += (1 << BUCKET_BITS) - steps % (1 << BUCKET_BITS);
            begun = bucket + 1;
        }
        Self { entries }
    }

    #[inline]
    fn encode_to<const N: usize>(&self, pixels: &mut [[u8; 4]], linear: &Lanes<N>) {
        write(pixels, &scaled(linear, STEPS), |steps| self.code(steps));
    }

    #[inline]
    fn code(&self, steps: u32) -> u8 {
        let entry = self.entries[((steps >> BUCKET_BITS) as usize).min(BUCKETS)];
        ((entry + steps % (1 << BUCKET_BITS)) >> BUCKET_BITS) as u8
    }
}

#[inline]
fn write<const N: usize>(pixels: &mut [[u8; 4]], [r, g, b]: &[[u32; N]; 3], code: impl Fn(u32) -> u8) {
    for (pixel, ((&r, &g), &b)) in pixels.iter_mut().zip(r.iter().zip(g).zip(b)) {
        *pixel = [code(r), code(g), code(b), 255];
    }
}

/// Linear sRGB of cube roots of cone responses.
#[inline]
fn linear_from_lms<const N: usize>(roots: &Lanes<N>) -> Lanes<N> {
    let mut lms = *roots;
    for root in lms.as_flattened_mut() {
        *root = *root * *root * *root;
    }
    let mut linear = [[0.0; N]; 3];
    for (channel, row) in linear.iter_mut().zip(&LINEAR_FROM_LMS) {
        let [wl, wm, ws] = row.map(|w| w as f32);
        for i in 0..N {
            channel[i] = wl * lms[0][i] + wm * lms[1][i] + ws * lms[2][i];
        }
    }
    linear
}

/// What lies in `0..=1` as a whole number of so many steps.
#[inline]
fn scaled<const N: usize>(channels: &Lanes<N>, steps: f32) -> [[u32; N]; 3] {
    let mut scaled = [[0; N]; 3];
    for (scaled, c) in scaled.as_flattened_mut().iter_mut().zip(channels.as_flattened()) {
        *scaled = rounded(unit(*c) * steps);
    }
    scaled
}

/// Clamped to `0..=1`; 0 for what is not a number.
#[inline]
fn unit(c: f32) -> f32 {
    let c = if c > 0.0 { c } else { 0.0 };
    if c < 1.0 { c } else { 1.0 }
}

/// The nearest whole number, for 0 up to 2²².
///
/// From 2²³ on, consecutive floats are consecutive whole numbers; adding that much is far cheaper than a cast that
/// minds every case.
#[inline]
fn rounded(x: f32) -> u32 {
    const SHIFT: f32 = 8_388_608.0;
    (x + SHIFT).to_bits() - SHIFT.to_bits()
}

#[cfg(test)]
mod tests {
    use super::*;
    use scumble_core::Srgb8;
    use scumble_core::color::srgb_from_linear;

    #[test]
    fn every_picked_colour_comes_back_to_the_last_bit() {
        for blend in [Blend::Oklab, Blend::Srgb] {
            let encoder = Encoder::new(blend);
            for rgb in (0..=0xff_ffff_u32).step_by(7) {
                let [_, r, g, b] = rgb.to_be_bytes();
                let field_color = blend.from_srgb8(Srgb8([r, g, b])).map(|c| c as f32);
                assert_eq!(encoder.encode(encoder.blended(field_color)), [r, g, b, 255], "{blend:?}");
                let half = encoder.encode(encoder.blended(field_color.map(|c| 0.5 * c)));
                assert_eq!(half, [r, g, b, 128], "{blend:?}");
            }
        }
    }

    #[test]
    fn codes_are_the_nearest_ones() {
        let table = CodeTable::new();
        for i in 0..=1_000_000 {
            let linear = i as f32 * 1e-6;
            let exact = srgb_from_linear(f64::from(linear)) * 255.0;
            assert!((f64::from(table.code(rounded(linear * STEPS))) - exact).abs() <= 0.5 + 1e-3, "{linear}");
        }
    }

    #[test]
    fn what_lies_outside_srgb_is_clamped() {
        let oklab = Encoder::new(Blend::Oklab);
        assert_eq!(oklab.encode(oklab.blended([1.7, 0.0, 0.0, 1.0])), [255; 4]);
        assert_eq!(oklab.encode(oklab.blended([-0.3, 0.0, 0.0, 1.0])), [0, 0, 0, 255]);
        assert_eq!(oklab.encode([f64::NAN; 4]), [0; 4]);
        let srgb = Encoder::new(Blend::Srgb);
        assert_eq!(srgb.encode([-1.0, 2.0, 0.5, 0.0]), [0, 255, 128, 255]);
        assert_eq!(srgb.encode([0.1, 0.1, 0.1, 7.0])[3], 0);
        assert_eq!(srgb.encode([0.1, 0.1, 0.1, -7.0])[3], 255);
    }
}
