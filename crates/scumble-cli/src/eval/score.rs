//! How much of a picture has the colours that a person would expect.
//!
//! Every pixel is classed by the nearest of the colours that the scribbles use (OKLab). White counts as uncoloured,
//! and so does what is more transparent than not.

use scumble_core::{Blend, BlendColor, Srgb8};
use scumble_solve::Pixmap;

use super::truth::{Mark, PALETTE, Truth};

/// The palette's index of a pixel, or `None` where it is uncoloured.
pub(crate) type Class = Option<u8>;

/// Parts of pixels, from 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Score {
    /// Of the pixels beside curves, those that have their true colour.
    pub(crate) side: f64,
    /// Of all scored pixels, those that have their true colour.
    pub(crate) area: f64,
    /// Of all scored pixels, those that have any colour.
    pub(crate) cover: f64,
}

impl Score {
    /// Scores a picture by the classes of its pixels, of which there are as many as in the truth. A part of no
    /// pixels is 1.
    pub(crate) fn new(truth: &Truth, classes: &[Class]) -> Self {
        let pixels = || truth.marks.iter().zip(&truth.colors).zip(classes);
        let scored = || pixels().filter(|((mark, _), _)| **mark != Mark::Unscored);
        let sides = || pixels().filter(|((mark, _), _)| **mark == Mark::Side);
        let is_true = |((_, color), class): ((&Mark, &u8), &Class)| *class == Some(*color);
        Self {
            side: part(sides().map(is_true)),
            area: part(scored().map(is_true)),
            cover: part(scored().map(|(_, class)| class.is_some())),
        }
    }

    /// The mean of each figure; zeros for none.
    pub(crate) fn mean(scores: &[Self]) -> Self {
        let mean = |of: fn(&Self) -> f64| scores.iter().map(of).sum::<f64>() / scores.len().max(1) as f64;
        Self { side: mean(|s| s.side), area: mean(|s| s.area), cover: mean(|s| s.cover) }
    }
}

/// The part that is true; 1 of none.
pub(crate) fn part(values: impl Iterator<Item = bool>) -> f64 {
    let (hits, count) =
        values.fold((0_u64, 0_u64), |(hits, count), value| (hits + u64::from(value), count + 1));
    if count == 0 { 1.0 } else { hits as f64 / count as f64 }
}

/// Classes the pixels of a picture by the colours in use, given as ascending indices into the palette.
pub(crate) fn classes(picture: &Pixmap, used: &[u8]) -> Vec<Class> {
    let targets = targets(used);
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    let mut last = ([0; 4], None);
    let class = |pixel: &[u8; 4]| {
        // Pictures are mostly flat: the next pixel is like the last.
        if *pixel != last.0 {
            last = (*pixel, class(*pixel, &targets));
        }
        last.1
    };
    pixels.iter().map(class).collect()
}

/// The colours to tell apart; of equally near ones the first counts.
fn targets(used: &[u8]) -> Vec<(BlendColor, Class)> {
    let palette = |index: &u8| (oklab(PALETTE[usize::from(*index)]), Some(*index));
    used.iter().map(palette).chain([(oklab(Srgb8([255; 3])), None)]).collect()
}

fn class([r, g, b, alpha]: [u8; 4], targets: &[(BlendColor, Class)]) -> Class {
    if alpha < 128 {
        return None;
    }
    let color = oklab(Srgb8([r, g, b]));
    let distance2 =
        |target: &BlendColor| target.iter().zip(color).map(|(t, c)| (t - c) * (t - c)).sum::<f64>();
    let nearest = targets.iter().min_by(|(a, _), (b, _)| distance2(a).total_cmp(&distance2(b)));
    nearest.and_then(|(_, class)| *class)
}

fn oklab(color: Srgb8) -> BlendColor {
    Blend::Oklab.from_srgb8(color)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two rows of five pixels: true colours 0 0 0 1 1 in each; the upper row lies beside a curve.
    fn truth() -> Truth {
        let colors = [0, 0, 0, 1, 1].repeat(2);
        let marks = [[Mark::Side; 5], [Mark::Area; 5]].concat();
        Truth { width_px: 5, height_px: 2, colors, marks }
    }

    #[test]
    fn figures_are_parts_of_the_scored_pixels() {
        let mut truth = truth();
        let classes: [Class; 10] =
            [Some(0), Some(1), None, Some(1), Some(1), Some(0), Some(0), Some(0), None, Some(1)];
        let score = Score::new(&truth, &classes);
        assert_eq!(score, Score { side: 3.0 / 5.0, area: 7.0 / 10.0, cover: 8.0 / 10.0 });
        truth.marks[1] = Mark::Unscored;
        truth.marks[8] = Mark::Unscored;
        let score = Score::new(&truth, &classes);
        assert_eq!(score, Score { side: 3.0 / 4.0, area: 7.0 / 8.0, cover: 7.0 / 8.0 });
    }

    #[test]
    fn the_mean_is_that_of_the_drawings() {
        let score = |side| Score { side, area: 1.0, cover: 0.5 };
        assert_eq!(Score::mean(&[score(0.25), score(0.75)]), score(0.5));
        assert_eq!(Score::mean(&[]), Score::default());
    }

    #[test]
    fn pixels_take_the_nearest_colour_in_use_and_white_counts_as_none() {
        let pixels = [
            [0xe6, 0x19, 0x4b, 255],
            [0xd0, 0x30, 0x40, 255],
            [250, 250, 255, 255],
            [0xe6, 0x19, 0x4b, 127],
            [0x3c, 0xb4, 0x4b, 128],
        ];
        let picture = |rgba: Vec<u8>| Pixmap { width_px: 5, height_px: 1, rgba };
        let rgba = picture(pixels.concat());
        assert_eq!(classes(&rgba, &[0, 1]), [Some(0), Some(0), None, None, Some(1)]);
        assert_eq!(classes(&rgba, &[1])[4], Some(1));
        assert_eq!(classes(&rgba, &[]), [None; 5]);
    }
}
