//! Colours as the eye gets them, and how far pictures of them lie apart.

use std::fmt;

use scumble_core::Blend;
use scumble_core::color::{LEAST_OPACITY, LINEAR_FROM_LMS, LMS_FROM_OKLAB, srgb_from_linear};

/// Red, green and blue over white paper, in 255 levels, not rounded.
pub(super) type Levels = [f32; 3];

/// Bins of a level: differences are counted that finely.
const BINS_PER_LEVEL: f64 = 100.0;

/// What is seen of blend-space colours.
pub(super) fn levels(pixels: &[[f32; 4]], blend: Blend) -> Vec<Levels> {
    pixels.iter().map(|&pixel| seen(pixel, blend)).collect()
}

fn seen(pixel: [f32; 4], blend: Blend) -> Levels {
    let [a, b, c, opacity] = pixel.map(f64::from);
    let straight = [a, b, c].map(|c| c / opacity.max(LEAST_OPACITY));
    let unit = match blend {
        Blend::Srgb => straight,
        Blend::Oklab => apply(&LINEAR_FROM_LMS, apply(&LMS_FROM_OKLAB, straight).map(|c| c * c * c))
            .map(|c| srgb_from_linear(c.max(0.0))),
    };
    let opacity = opacity.clamp(0.0, 1.0);
    unit.map(|c| (255.0 * (opacity * c.clamp(0.0, 1.0) + 1.0 - opacity)) as f32)
}

fn apply(m: &[[f64; 3]; 3], v: [f64; 3]) -> [f64; 3] {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

/// Differences of two pictures, counted.
#[derive(Clone, Debug, Default)]
pub(crate) struct Spread {
    counts: Vec<u64>,
    sum: f64,
    largest: f64,
}

impl Spread {
    /// The differences at the pixels that count, each by its worst channel.
    pub(super) fn of(a: &[Levels], b: &[Levels], counts: impl Fn(usize) -> bool) -> Self {
        let mut spread = Self::default();
        for (_, (a, b)) in a.iter().zip(b).enumerate().filter(|(i, _)| counts(*i)) {
            spread.push((0..3).map(|c| f64::from((a[c] - b[c]).abs())).fold(0.0, f64::max));
        }
        spread
    }

    fn push(&mut self, difference: f64) {
        let bin = (difference * BINS_PER_LEVEL) as usize;
        if self.counts.len() <= bin {
            self.counts.resize(bin + 1, 0);
        }
        self.counts[bin] += 1;
        self.sum += difference;
        self.largest = self.largest.max(difference);
    }

    /// Takes in the differences of other pictures.
    pub(crate) fn add(&mut self, other: &Self) {
        self.counts.resize(self.counts.len().max(other.counts.len()), 0);
        self.counts.iter_mut().zip(&other.counts).for_each(|(sum, count)| *sum += count);
        self.sum += other.sum;
        self.largest = self.largest.max(other.largest);
    }

    fn count(&self) -> u64 {
        self.counts.iter().sum()
    }

    pub(super) fn mean(&self) -> f64 {
        self.sum / self.count().max(1) as f64
    }

    pub(super) fn largest(&self) -> f64 {
        self.largest
    }

    /// The difference that a part of all, from 0 to 1, stays below, to a bin.
    pub(super) fn percentile(&self, part: f64) -> f64 {
        let rank = (part * self.count() as f64).ceil() as u64;
        let mut seen = 0;
        let bin = self.counts.iter().position(|count| {
            seen += count;
            seen >= rank
        });
        bin.map_or(0.0, |bin| (bin + 1) as f64 / BINS_PER_LEVEL)
    }
}

impl fmt::Display for Spread {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:6.3} {:6.2} {:6.1}", self.mean(), self.percentile(0.99), self.largest)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn levels_are_those_of_the_painter() {
        for color in [[0.7, 0.1, -0.05, 1.0], [0.3, 0.0, 0.1, 0.5], [0.0; 4]] {
            let [r, g, b, alpha] = Blend::Oklab.to_rgba8(color).0.map(f32::from);
            let painted = [r, g, b].map(|c| c * alpha / 255.0 + 255.0 - alpha);
            let ours = seen(color.map(|c| c as f32), Blend::Oklab);
            assert!((0..3).all(|c| (ours[c] - painted[c]).abs() < 1.01), "{ours:?} {painted:?}");
        }
    }

    #[test]
    fn differences_are_counted() {
        let picture = |red: f32| vec![[red, 0.0, 0.0]; 50];
        let mut spread = Spread::of(&picture(1.0), &picture(1.5), |i| i < 49);
        spread.add(&Spread::of(&picture(1.0), &picture(9.0), |i| i == 0));
        assert_eq!((spread.count(), spread.largest), (50, 8.0));
        assert_eq!([0.5, 0.98, 0.99].map(|part| spread.percentile(part)), [0.51, 0.51, 8.01]);
        assert!((spread.mean() - (49.0 * 0.5 + 8.0) / 50.0).abs() < 1e-9);
    }
}
