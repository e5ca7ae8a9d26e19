//! Colours as people pick them, and the spaces in which they are blended.
//!
//! OKLab after Björn Ottosson, *A perceptual color space for image processing* (2020).

use std::fmt;
use std::str::FromStr;

use thiserror::Error;

/// An opaque colour as picked: sRGB, 8 bits a channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Srgb8(pub [u8; 3]);

/// What a scribble paints: a colour, or nothing: its place stays paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Paint {
    /// An opaque colour.
    Color(Srgb8),
    /// Nothing.
    Clear,
}

/// A colour with opacity: sRGB and straight (not premultiplied) alpha, 8 bits a channel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Rgba8(pub [u8; 4]);

/// What is wrong with a text that should have been a colour.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[error("“{0}” is not a colour; write it as #rrggbb, for example #e6194b")]
pub struct ColorError(String);

impl FromStr for Srgb8 {
    type Err = ColorError;

    fn from_str(text: &str) -> Result<Self, ColorError> {
        let error = || ColorError(text.chars().take(32).collect());
        let digits = text.strip_prefix('#').ok_or_else(error)?;
        if digits.len() != 6 || !digits.bytes().all(|b| b.is_ascii_hexdigit()) {
            return Err(error());
        }
        let rgb = u32::from_str_radix(digits, 16).map_err(|_| error())?;
        let [_, r, g, b] = rgb.to_be_bytes();
        Ok(Self([r, g, b]))
    }
}

impl fmt::Display for Srgb8 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [r, g, b] = self.0;
        write!(f, "#{r:02x}{g:02x}{b:02x}")
    }
}

impl From<Srgb8> for Paint {
    fn from(color: Srgb8) -> Self {
        Self::Color(color)
    }
}

impl FromStr for Paint {
    type Err = ColorError;

    /// `none`, or `#rrggbb`.
    fn from_str(text: &str) -> Result<Self, ColorError> {
        if text == "none" { Ok(Self::Clear) } else { text.parse().map(Self::Color) }
    }
}

impl fmt::Display for Paint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Color(color) => color.fmt(f),
            Self::Clear => f.write_str("none"),
        }
    }
}

/// The space in which colours are blended from side to side of a region.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Blend {
    /// OKLab: smooth to the eye.
    #[default]
    Oklab,
    /// Gamma-encoded sRGB: what the older papers and files use.
    Srgb,
}

/// A colour in the blend space of its drawing: OKLab (L, a, b), or sRGB in 0..=1, each times the opacity; and the
/// opacity, 0 for nothing to 1 for an opaque colour. Nothing is all zeros.
pub type BlendColor = [f64; 4];

/// Opacities below this are taken as this where a colour is divided by its own: a quarter of an 8-bit level, which
/// nobody sees.
pub const LEAST_OPACITY: f64 = 1.0 / 1024.0;

impl Blend {
    /// The blend-space coordinates of what a scribble paints.
    pub fn from_paint(self, paint: Paint) -> BlendColor {
        match paint {
            Paint::Color(color) => self.from_srgb8(color),
            Paint::Clear => [0.0; 4],
        }
    }

    /// The blend-space coordinates of a picked colour.
    pub fn from_srgb8(self, color: Srgb8) -> BlendColor {
        let unit = color.0.map(|c| f64::from(c) / 255.0);
        let [a, b, c] = match self {
            Self::Srgb => unit,
            Self::Oklab => oklab_from_linear(unit.map(linear_from_srgb)),
        };
        [a, b, c, 1.0]
    }

    /// The nearest 8-bit colour; what lies outside sRGB is clamped channel by channel.
    pub fn to_rgba8(self, color: BlendColor) -> Rgba8 {
        Rgba8(self.to_srgba(color).map(|c| (c * 255.0).round() as u8))
    }

    /// The colour in sRGB and its straight alpha, not rounded, `0..=1`; what lies outside sRGB is clamped channel by
    /// channel.
    pub fn to_srgba(self, [a, b, c, opacity]: BlendColor) -> [f64; 4] {
        let straight = [a, b, c].map(|c| c / opacity.max(LEAST_OPACITY));
        let [r, g, b] = match self {
            Self::Srgb => straight,
            Self::Oklab => linear_from_oklab(straight).map(srgb_from_linear),
        };
        [r, g, b, opacity].map(|c| c.clamp(0.0, 1.0))
    }
}

/// The sRGB transfer function's inverse, `0..=1` to `0..=1`.
pub fn linear_from_srgb(c: f64) -> f64 {
    if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
}

/// The sRGB transfer function, `0..=1` to `0..=1`.
pub fn srgb_from_linear(c: f64) -> f64 {
    if c <= 0.003_130_8 { c * 12.92 } else { 1.055 * c.powf(1.0 / 2.4) - 0.055 }
}

fn oklab_from_linear(rgb: [f64; 3]) -> [f64; 3] {
    let lms = apply(&LMS_FROM_LINEAR, rgb).map(f64::cbrt);
    apply(&OKLAB_FROM_LMS, lms)
}

/// Linear sRGB of an opaque OKLab colour; channels may lie outside `0..=1`.
pub(crate) fn linear_from_oklab(lab: [f64; 3]) -> [f64; 3] {
    let lms = apply(&LMS_FROM_OKLAB, lab).map(|c| c * c * c);
    apply(&LINEAR_FROM_LMS, lms)
}

fn apply(m: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

const LMS_FROM_LINEAR: [[f64; 3]; 3] = [
    [0.412_221_470_8, 0.536_332_536_3, 0.051_445_992_9],
    [0.211_903_498_2, 0.680_699_545_1, 0.107_396_956_6],
    [0.088_302_461_9, 0.281_718_837_6, 0.629_978_700_5],
];
const OKLAB_FROM_LMS: [[f64; 3]; 3] = [
    [0.210_454_255_3, 0.793_617_785_0, -0.004_072_046_8],
    [1.977_998_495_1, -2.428_592_205_0, 0.450_593_709_9],
    [0.025_904_037_1, 0.782_771_766_2, -0.808_675_766_0],
];

/// OKLab to the cube roots of the cone responses.
pub const LMS_FROM_OKLAB: [[f64; 3]; 3] = [
    [1.0, 0.396_337_777_4, 0.215_803_757_3],
    [1.0, -0.105_561_345_8, -0.063_854_172_8],
    [1.0, -0.089_484_177_5, -1.291_485_548_0],
];
/// Cone responses to linear sRGB.
pub const LINEAR_FROM_LMS: [[f64; 3]; 3] = [
    [4.076_741_662_1, -3.307_711_591_3, 0.230_969_929_2],
    [-1.268_438_004_6, 2.609_757_401_1, -0.341_319_396_5],
    [-0.004_196_086_3, -0.703_418_614_7, 1.707_614_701_0],
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_colour_survives_either_blend_space() {
        for blend in [Blend::Oklab, Blend::Srgb] {
            for rgb in (0..=0xff_ffff_u32).step_by(97) {
                let [_, r, g, b] = rgb.to_be_bytes();
                let color = blend.from_srgb8(Srgb8([r, g, b]));
                assert_eq!(blend.to_rgba8(color), Rgba8([r, g, b, 255]));
                let faint = blend.to_rgba8(color.map(|c| 0.2 * c));
                assert_eq!(faint, Rgba8([r, g, b, 51]));
            }
        }
    }

    #[test]
    fn colours_are_read_as_they_are_written() {
        assert_eq!("#E6194b".parse(), Ok(Srgb8([0xe6, 0x19, 0x4b])));
        assert_eq!(Srgb8([1, 2, 255]).to_string(), "#0102ff");
        assert_eq!("#E6194b".parse(), Ok(Paint::Color(Srgb8([0xe6, 0x19, 0x4b]))));
        assert_eq!("none".parse(), Ok(Paint::Clear));
        assert_eq!([Paint::Clear, Srgb8([1, 2, 255]).into()].map(|p| p.to_string()), ["none", "#0102ff"]);
        assert!(["None", "clear", "none ", ""].iter().all(|bad| bad.parse::<Paint>().is_err()));
        for bad in ["", "#", "e6194b", "#e6194", "#e6194b0", "#+12345", "#ééé", "red"] {
            assert!(bad.parse::<Srgb8>().is_err(), "{bad}");
        }
    }
}
