//! The settings of a drawing: what else than lines and scribbles decides how it is coloured.

use crate::color::Blend;
use crate::engine::Engine;
use crate::global::Global;
use crate::progressive::Progressive;

/// Which engine labels the sides.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum EngineKind {
    /// All scribbles at once, by the widths of the passages between the lines.
    #[default]
    Global,
    /// One scribble after the other, as Bao & Fu 2019 do it. It closes the gaps at which its circuits end, and does
    /// not spread.
    Progressive,
}

/// How a drawing is coloured. Part of the document: changed by gestures that can be undone.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// The space in which colours are blended.
    pub blend: Blend,
    /// What labels the sides.
    pub engine: EngineKind,
    /// How readily gaps between lines are taken as closed: 0 for those alone where drawn lines overlap, 1 for all
    /// that could be; within `0..=1`.
    pub gap_closing: f64,
    /// Whether colours go on, through closed gaps and across lines, into areas that nobody scribbled.
    pub spread: bool,
}

impl Default for Settings {
    fn default() -> Self {
        Self { blend: Blend::default(), engine: EngineKind::default(), gap_closing: 0.5, spread: false }
    }
}

impl Settings {
    /// The same, with gap closing within its range; what is no number becomes the default.
    pub fn clamped(self) -> Self {
        let gap_closing =
            if self.gap_closing.is_nan() { Self::default().gap_closing } else { self.gap_closing };
        Self { gap_closing: gap_closing.clamp(0.0, 1.0), ..self }
    }

    /// A fresh engine with these settings, for one map.
    pub fn engine(&self) -> Box<dyn Engine> {
        match self.engine {
            EngineKind::Global => Box::new(Global::new(self.spread)),
            EngineKind::Progressive => Box::new(Progressive::default()),
        }
    }

    /// Whether an engine made for other settings serves these as well, on a map with the same gaps: other gaps are
    /// another map, which takes another engine.
    pub fn share_engine(&self, other: &Self) -> bool {
        let key = |of: &Self| (of.engine, of.engine == EngineKind::Global && of.spread);
        key(self) == key(other)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gap_closing_is_kept_within_its_range() {
        let clamped = |gap_closing| Settings { gap_closing, ..Settings::default() }.clamped().gap_closing;
        assert_eq!([-1.0, 0.25, 7.0, f64::INFINITY].map(clamped), [0.0, 0.25, 1.0, 1.0]);
        assert_eq!(clamped(f64::NAN), 0.5);
    }

    #[test]
    fn an_engine_serves_settings_that_differ_in_what_it_does_not_know() {
        let global = Settings::default();
        let progressive = Settings { engine: EngineKind::Progressive, ..global };
        assert!(global.share_engine(&Settings { blend: Blend::Srgb, ..global }));
        assert!(!global.share_engine(&Settings { spread: true, ..global }));
        assert!(!global.share_engine(&progressive));
        assert!(progressive.share_engine(&Settings { spread: true, ..progressive }));
        assert!(global.share_engine(&Settings { gap_closing: 0.6, ..global }));
    }
}
