//! Colours as other programs have them: sRGB with straight alpha.

use scumble_core::{Blend, Srgb8};

/// Two colours that differ by less than this, of 1, are told apart by nobody: half an 8-bit level.
pub(crate) const HALF_LEVEL: f64 = 0.5 / 255.0;

/// Less alpha than this is seen by nobody, and the colour that it is of comes out of a division by next to nothing.
const CLEAR: f64 = 1.0 / 255.0;

/// sRGB and straight alpha, each 0 to 1.
pub(crate) type Rgba = [f64; 4];

/// How the colours of a field come out.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tint {
    pub(crate) blend: Blend,
    /// What shows through where a colour is not opaque; without it, the colours keep their alpha.
    pub(crate) paper: Option<Srgb8>,
}

impl Tint {
    pub(crate) fn rgba(&self, color: [f64; 4]) -> Rgba {
        let [r, g, b, alpha] = self.blend.to_srgba(color);
        let Some(Srgb8(paper)) = self.paper else { return [r, g, b, alpha] };
        let [pr, pg, pb] = paper.map(|c| f64::from(c) / 255.0 * (1.0 - alpha));
        [r * alpha + pr, g * alpha + pg, b * alpha + pb, 1.0]
    }
}

/// Colours of which those that are all but clear, and so could be any, are as the most opaque one.
pub(crate) fn settled<const N: usize>(colors: [Rgba; N]) -> [Rgba; N] {
    let most = colors.into_iter().fold([0.0; 4], |most, color| if color[3] > most[3] { color } else { most });
    let [r, g, b, _] = most;
    colors.map(|color| if color[3] < CLEAR { [r, g, b, color[3]] } else { color })
}

/// How far two colours differ to the eye, of 1: what is all but clear differs little, whatever its colour.
pub(crate) fn difference(a: Rgba, b: Rgba) -> f64 {
    let alpha = a[3].max(b[3]);
    let colors = (0..3).map(|c| alpha * (a[c] - b[c]).abs());
    colors.fold((a[3] - b[3]).abs(), f64::max)
}

/// Rounded to bytes.
pub(crate) fn bytes(color: [f64; 3]) -> [u8; 3] {
    color.map(|c| (c * 255.0).round() as u8)
}
