//! The paint of a stroke or a fill as one colour.

use scumble_core::{Blend, Rgba8, Srgb8};
use usvg::{Fill, Opacity, Paint, Path, Stop, Stroke};

pub(crate) const WHITE: Rgba8 = Rgba8([255; 4]);

/// Stands for a pattern: neither ink nor paper.
const PATTERN_COLOR: [u8; 3] = [0x80; 3];

/// Lightness in OKLab below which a fill is ink.
const INK_LIGHTNESS: f64 = 0.5;

/// Lightness in OKLab above which a grey hardly shows on white.
const PALE_LIGHTNESS: f64 = 0.9;

/// Chroma in OKLab from which on a colour has a hue.
const HUE_CHROMA: f64 = 0.06;

/// Opacity from which on a dark fill is ink.
const INK_ALPHA: u8 = 128;

/// The colour of a paint under an opacity; a gradient has the mean of its stops. `None` where nothing shows.
pub(crate) fn color(paint: &Paint, opacity: f32) -> Option<Rgba8> {
    let (rgb, own_opacity) = match paint {
        Paint::Color(c) => ([c.red, c.green, c.blue], 1.0),
        Paint::LinearGradient(gradient) => mean(gradient.stops()),
        Paint::RadialGradient(gradient) => mean(gradient.stops()),
        Paint::Pattern(_) => (PATTERN_COLOR, 1.0),
    };
    let alpha = (opacity * own_opacity * 255.0).round() as u8;
    let [r, g, b] = rgb;
    (alpha > 0).then_some(Rgba8([r, g, b, alpha]))
}

fn mean(stops: &[Stop]) -> ([u8; 3], f32) {
    let count = stops.len().max(1);
    let channel = |of: fn(usvg::Color) -> u8| {
        (stops.iter().map(|stop| usize::from(of(stop.color()))).sum::<usize>() / count) as u8
    };
    let opacity = stops.iter().map(|stop| stop.opacity()).map(Opacity::get).sum::<f32>() / count as f32;
    ([channel(|c| c.red), channel(|c| c.green), channel(|c| c.blue)], opacity)
}

/// Whether a shape has a pattern that no colour can stand for: hatching, dots.
pub(crate) fn has_pattern(path: &Path) -> bool {
    let paints = [path.fill().map(Fill::paint), path.stroke().map(Stroke::paint)];
    paints.into_iter().flatten().any(|paint| matches!(paint, Paint::Pattern(_)))
}

/// Whether nothing can be seen through a paint; of a pattern that is not known.
pub(crate) fn is_opaque(paint: &Paint, opacity: f32) -> bool {
    !matches!(paint, Paint::Pattern(_))
        && color(paint, opacity).is_some_and(|Rgba8([.., alpha])| alpha == 255)
}

/// Whether an area of this colour belongs to the lines of a drawing.
pub(crate) fn is_ink(color: Rgba8) -> bool {
    color.0[3] >= INK_ALPHA && is_dark(color)
}

/// Whether an area of this colour shows on ink.
pub(crate) fn is_light(color: Rgba8) -> bool {
    color.0[3] >= INK_ALPHA && lightness(color) > PALE_LIGHTNESS
}

/// Whether a colour is darker than the middle.
pub(crate) fn is_dark(color: Rgba8) -> bool {
    lightness(color) < INK_LIGHTNESS
}

/// Whether a colour is more than light or dark.
pub(crate) fn has_hue(Rgba8([r, g, b, _]): Rgba8) -> bool {
    let [_, green_red, blue_yellow, _] = Blend::Oklab.from_srgb8(Srgb8([r, g, b]));
    green_red.hypot(blue_yellow) >= HUE_CHROMA
}

/// Whether a colour hardly shows on white.
pub(crate) fn is_pale(color: Rgba8) -> bool {
    lightness(color) > PALE_LIGHTNESS && !has_hue(color)
}

/// How a colour looks upon white.
pub(crate) fn over_white(Rgba8([r, g, b, alpha]): Rgba8) -> Rgba8 {
    let over = |c: u8| 255 - ((255 - u32::from(c)) * u32::from(alpha) / 255) as u8;
    Rgba8([over(r), over(g), over(b), 255])
}

fn lightness(Rgba8([r, g, b, _]): Rgba8) -> f64 {
    Blend::Oklab.from_srgb8(Srgb8([r, g, b]))[0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_nearly_gray_has_no_hue() {
        for color in [[0, 0, 0], [0x80; 3], [0x22, 0x26, 0x2b], [0x3b, 0x33, 0x30]] {
            assert!(!has_hue(Rgba8([color[0], color[1], color[2], 255])), "{color:?}");
        }
        for color in [[0, 0, 0x80], [0xa5, 0x2a, 0x2a], [0x33, 0x55, 0x99], [0x80, 0, 0]] {
            assert!(has_hue(Rgba8([color[0], color[1], color[2], 255])), "{color:?}");
        }
    }

    #[test]
    fn dark_and_opaque_is_ink() {
        assert!(is_ink(Rgba8([0, 0, 0, 255])));
        assert!(is_ink(Rgba8([0x3f, 0x3f, 0x3f, 200])));
        assert!(!is_ink(Rgba8([0, 0, 0, 40])));
        assert!(!is_ink(Rgba8([0xff, 0xff, 0xff, 255])));
        assert!(!is_ink(Rgba8([0x80, 0x80, 0x80, 255])));
    }
}
