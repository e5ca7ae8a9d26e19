//! Colours by the numbers that people turn to find them.

use crate::angle::unit_vector;
use crate::color::{Blend, Srgb8, linear_from_oklab, srgb_from_linear};

/// What three numbers say about a colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ColorModel {
    /// OKLab in polar form: lightness in `0..=1`, chroma from 0 on, hue in degrees.
    Oklch,
    /// Alvy Ray Smith's hexcone, *Color gamut transform pairs* (1978): hue in degrees, saturation and value in `0..=1`.
    Hsv,
}

/// A colour of this chroma or less has no hue to be seen: 8-bit grays come out below it.
const NO_CHROMA: f64 = 1e-4;

/// Linear channels that leave `0..=1` by no more than this are in sRGB: 8-bit colours come back so.
const RIM: f64 = 1e-6;

/// Halvings that find a chroma: to less than a millionth.
const HALVINGS: u32 = 20;

impl ColorModel {
    /// The numbers of a colour; a hue that it does not have is 0.
    pub fn numbers(self, color: Srgb8) -> [f64; 3] {
        match self {
            Self::Oklch => oklch(color),
            Self::Hsv => hsv(color),
        }
    }

    /// The colour of some numbers, and whether sRGB has it. Of one that it does not have, it is that of the same lightness
    /// and hue with as much chroma as there is.
    pub fn color(self, numbers: [f64; 3]) -> (Srgb8, bool) {
        match self {
            Self::Oklch => from_oklch(numbers),
            Self::Hsv => (from_hsv(numbers), true),
        }
    }
}

fn oklch(color: Srgb8) -> [f64; 3] {
    let [l, a, b, _] = Blend::Oklab.from_srgb8(color);
    let chroma = a.hypot(b);
    if chroma <= NO_CHROMA { [l, 0.0, 0.0] } else { [l, chroma, b.atan2(a).to_degrees().rem_euclid(360.0)] }
}

fn from_oklch([l, chroma, hue]: [f64; 3]) -> (Srgb8, bool) {
    let way = unit_vector(hue);
    let linear = |chroma: f64| linear_from_oklab([l, chroma * way.x, chroma * way.y]);
    let is_there = is_srgb(linear(chroma));
    let chroma = if is_there { chroma } else { greatest(chroma, &|chroma| is_srgb(linear(chroma))) };
    (nearest(linear(chroma).map(srgb_from_linear)), is_there)
}

/// The greatest chroma up to a limit that fits, where smaller ones do.
fn greatest(limit: f64, fits: &dyn Fn(f64) -> bool) -> f64 {
    let (mut low, mut high) = (0.0, limit);
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if fits(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

fn is_srgb(linear: [f64; 3]) -> bool {
    linear.iter().all(|channel| (-RIM..=1.0 + RIM).contains(channel))
}

fn nearest(rgb: [f64; 3]) -> Srgb8 {
    Srgb8(rgb.map(|channel| (channel.clamp(0.0, 1.0) * 255.0).round() as u8))
}

fn hsv(Srgb8(rgb): Srgb8) -> [f64; 3] {
    let [r, g, b] = rgb.map(|channel| f64::from(channel) / 255.0);
    let value = r.max(g).max(b);
    let range = value - r.min(g).min(b);
    if range == 0.0 {
        return [0.0, 0.0, value];
    }
    let sextant = if value == r {
        (g - b) / range
    } else if value == g {
        2.0 + (b - r) / range
    } else {
        4.0 + (r - g) / range
    };
    [60.0 * sextant.rem_euclid(6.0), range / value, value]
}

fn from_hsv([hue, saturation, value]: [f64; 3]) -> Srgb8 {
    // How far each channel lies from its own hue, in sextants.
    let channel = |hue_of: f64| {
        let away = (hue / 60.0 - hue_of).rem_euclid(6.0);
        let share = (2.0 - away.min(6.0 - away)).clamp(0.0, 1.0);
        value * (1.0 - saturation * (1.0 - share))
    };
    nearest([0.0, 2.0, 4.0].map(channel))
}

#[cfg(test)]
mod tests {
    use super::*;

    const MODELS: [ColorModel; 2] = [ColorModel::Oklch, ColorModel::Hsv];

    #[test]
    fn every_colour_comes_back_and_is_in_srgb() {
        for model in MODELS {
            for rgb in (0..=0xff_ffff_u32).step_by(41).chain([0xff_ffff, 0xff_0000, 0x00_00ff]) {
                let [_, r, g, b] = rgb.to_be_bytes();
                let color = Srgb8([r, g, b]);
                assert_eq!(model.color(model.numbers(color)), (color, true), "{model:?}");
            }
        }
    }

    #[test]
    fn known_colours_have_their_numbers() {
        // As CSS Color 4 gives them for oklch().
        for (color, [l, chroma, hue]) in [
            ("#ff0000", [0.628, 0.2577, 29.23]),
            ("#00ff00", [0.8664, 0.2948, 142.5]),
            ("#0000ff", [0.452, 0.3132, 264.05]),
            ("#663399", [0.4403, 0.1603, 303.37]),
        ] {
            let numbers = ColorModel::Oklch.numbers(color.parse().unwrap());
            assert!(
                (numbers[0] - l).abs() < 5e-4 && (numbers[1] - chroma).abs() < 5e-4,
                "{color}: {numbers:?}"
            );
            assert!((numbers[2] - hue).abs() < 0.05, "{color}: {numbers:?}");
        }
        for (color, numbers) in [
            ("#ff0000", [0.0, 1.0, 1.0]),
            ("#008080", [180.0, 1.0, 128.0 / 255.0]),
            ("#ff00ff", [300.0, 1.0, 1.0]),
        ] {
            assert_eq!(ColorModel::Hsv.numbers(color.parse().unwrap()), numbers, "{color}");
        }
    }

    #[test]
    fn grays_have_no_hue() {
        for model in MODELS {
            for level in 0..=255 {
                let numbers = model.numbers(Srgb8([level; 3]));
                assert!(
                    numbers.iter().filter(|number| **number == 0.0).count() >= 2,
                    "{model:?}: {numbers:?}"
                );
            }
        }
    }

    #[test]
    fn what_srgb_does_not_have_keeps_its_lightness_and_hue() {
        for hue in (0..360).step_by(15).map(f64::from) {
            for l in [0.2, 0.5, 0.8] {
                let (color, is_there) = ColorModel::Oklch.color([l, 0.4, hue]);
                assert!(!is_there, "{l} {hue}");
                let [near_l, chroma, near_hue] = ColorModel::Oklch.numbers(color);
                let turn = (near_hue - hue + 180.0).rem_euclid(360.0) - 180.0;
                assert!((near_l - l).abs() < 0.01 && turn.abs() < 4.0, "{l} {hue}: {near_l} {near_hue}");
                let (_, has_more) = ColorModel::Oklch.color([l, chroma + 0.02, hue]);
                assert!(!has_more, "{l} {hue}: {color} could have more chroma");
            }
        }
    }

    #[test]
    fn numbers_that_are_none_give_some_colour() {
        for model in MODELS {
            for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, 1e300] {
                for at in 0..3 {
                    let mut numbers = [0.5, 0.1, 0.5];
                    numbers[at] = bad;
                    model.color(numbers);
                }
            }
        }
    }
}
