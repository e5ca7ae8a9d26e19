//! A picture under the lines, to trace or to colour by: a help, and no part of what is made of a drawing.

/// How a picture lies under the lines: as large as fits into the page, in its middle. Part of the document: changed by
/// gestures that can be undone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tracing {
    /// Which of a drawing's pictures it is. Whoever keeps their files tells them apart by these numbers.
    pub image: u32,
    /// How little of the paper is seen through it, in `0..=1`.
    pub opacity: f64,
}

impl Tracing {
    /// A picture, faded so that lines stand out from it.
    pub fn faded(image: u32) -> Self {
        Self { image, opacity: 0.5 }
    }

    /// The same, with its opacity within its range; what is no number becomes the default.
    pub fn clamped(self) -> Self {
        if self.opacity.is_nan() {
            return Self::faded(self.image);
        }
        Self { opacity: self.opacity.clamp(0.0, 1.0), ..self }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn opacity_is_kept_within_its_range() {
        let clamped = |opacity| Tracing { image: 3, opacity }.clamped();
        assert_eq!([-1.0, 0.25, f64::INFINITY].map(|opacity| clamped(opacity).opacity), [0.0, 0.25, 1.0]);
        assert_eq!(clamped(f64::NAN), Tracing::faded(3));
    }
}
