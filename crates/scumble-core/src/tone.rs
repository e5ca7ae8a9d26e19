//! Colours for highlights and shadows: a step from the colour that is there, in OKLab.

use crate::color::{Blend, Rgba8, Srgb8};

/// A step from a colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tone {
    /// Towards white.
    Lighter,
    /// Towards black.
    Darker,
    /// Towards orange, equally light.
    Warmer,
    /// Towards blue, equally light.
    Cooler,
}

/// How much of the way to white a lighter colour has gone.
const LIGHTEN: f64 = 0.6;

/// How much of the way to black a darker colour has gone.
const DARKEN: f64 = 0.45;

/// What a warmer colour has more of, along OKLab's `a` and `b`.
const WARM: [f64; 2] = [0.025, 0.05];

impl Tone {
    /// The colour a step away from one; channels that leave sRGB are clamped.
    pub fn step(self, from: Srgb8) -> Srgb8 {
        let [l, a, b, _] = Blend::Oklab.from_srgb8(from);
        let turned = |sign: f64| [l, a + sign * WARM[0], b + sign * WARM[1], 1.0];
        let towards = |[rest, white]: [f64; 2]| [rest * l + white, rest * a, rest * b, 1.0];
        let to = match self {
            Self::Lighter => towards([1.0 - LIGHTEN, LIGHTEN]),
            Self::Darker => towards([1.0 - DARKEN, 0.0]),
            Self::Warmer => turned(1.0),
            Self::Cooler => turned(-1.0),
        };
        let Rgba8([r, g, b, _]) = Blend::Oklab.to_rgba8(to);
        Srgb8([r, g, b])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_steps() {
        let skin = Srgb8([224, 172, 140]);
        let steps = [Tone::Lighter, Tone::Darker, Tone::Warmer, Tone::Cooler].map(|tone| tone.step(skin));
        assert_eq!(steps.map(|color| color.to_string()), ["#f4ded1", "#634a3b", "#f7a260", "#c7b4b1"]);
    }

    #[test]
    fn a_step_goes_the_way_that_it_is_called() {
        let lightness = |color| Blend::Oklab.from_srgb8(color)[0];
        let warmth = |color| {
            let [_, a, b, _] = Blend::Oklab.from_srgb8(color);
            a * WARM[0] + b * WARM[1]
        };
        for rgb in (0..=0xff_ffff_u32).step_by(9973) {
            let [_, r, g, b] = rgb.to_be_bytes();
            let color = Srgb8([r, g, b]);
            assert!(lightness(Tone::Lighter.step(color)) > lightness(color), "{color}");
            assert!(lightness(Tone::Darker.step(color)) <= lightness(color), "{color}");
            // A colour at the rim of sRGB has nowhere to go, and clamping turns it a little.
            assert!(warmth(Tone::Warmer.step(color)) > warmth(color) - 5e-4, "{color}");
            assert!(warmth(Tone::Cooler.step(color)) < warmth(color) + 5e-4, "{color}");
        }
        let white = Srgb8([255; 3]);
        assert_eq!(Tone::Lighter.step(white), white);
        assert!(warmth(Tone::Warmer.step(white)) > warmth(white) + 1e-3);
        assert!(warmth(Tone::Cooler.step(white)) < warmth(white) - 1e-3);
    }
}
