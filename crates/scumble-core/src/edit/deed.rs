//! What a gesture did, for a list of what can be undone.

use std::cmp::Ordering;

use crate::color::Paint;
use crate::palette::Swatch;
use crate::scribble::Scribble;
use crate::settings::Settings;
use crate::tracing::Tracing;

/// A gesture as the list has it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Entry {
    /// What it did.
    pub deed: Deed,
    /// The colour of the only scribble that came, went or took another one, or of a swatch that did.
    pub paint: Option<Paint>,
}

/// What a gesture did.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Deed {
    /// A scribble that fills was drawn.
    Added,
    /// One that shades was.
    Shaded,
    /// Scribbles were erased.
    Erased,
    /// Parts of scribbles were.
    Rubbed,
    /// Something is elsewhere.
    Moved,
    /// Something is larger or smaller.
    Resized,
    /// Scribbles are wider or narrower.
    Widened,
    /// Scribbles shade otherwise: more or less, up to the lines or beyond, by another pen.
    Reshaded,
    /// Scribbles have another colour.
    Recolored,
    /// There is more of something.
    Duplicated,
    /// Scribbles lie further up.
    Forward,
    /// Scribbles lie further down.
    Backward,
    /// Something was taken away.
    Deleted,
    /// Lines are not drawn.
    Hidden,
    /// Lines are drawn again.
    Shown,
    /// Gaps count as closed otherwise.
    GapClosing,
    /// Another engine reads the scribbles.
    Engine,
    /// Colours are blended otherwise.
    Blend,
    /// Colours spread, or no longer do.
    Spread,
    /// The palette has more swatches.
    SwatchAdded,
    /// It has fewer.
    SwatchRemoved,
    /// Swatches have other names.
    SwatchNamed,
    /// Swatches are in another order.
    SwatchesOrdered,
    /// There is another palette.
    Palette,
    /// A swatch has another colour, and all that was painted with it.
    Repainted,
    /// A picture to trace lies under the lines.
    Traced,
    /// There is none any more.
    Untraced,
    /// It is more faded, or less.
    Faded,
}

impl Deed {
    /// What put a scribble into the drawing.
    pub(super) fn of_scribble(scribble: &Scribble) -> Self {
        if scribble.is_fill() { Self::Added } else { Self::Shaded }
    }

    /// What made one of these settings the other.
    pub(super) fn of_settings(before: Settings, after: Settings) -> Self {
        if before.engine != after.engine {
            Self::Engine
        } else if before.blend != after.blend {
            Self::Blend
        } else if before.spread != after.spread {
            Self::Spread
        } else {
            Self::GapClosing
        }
    }

    /// What made one palette the other.
    pub(super) fn of_palette(before: &[Swatch], after: &[Swatch]) -> Self {
        let has_all = |palette: &[Swatch], of: &[Swatch]| of.iter().all(|swatch| palette.contains(swatch));
        let has_same_colors = || before.iter().zip(after).all(|(a, b)| a.color == b.color);
        match before.len().cmp(&after.len()) {
            Ordering::Less if has_all(after, before) => Self::SwatchAdded,
            Ordering::Greater if has_all(before, after) => Self::SwatchRemoved,
            Ordering::Equal if has_same_colors() => Self::SwatchNamed,
            Ordering::Equal if has_all(after, before) => Self::SwatchesOrdered,
            _ => Self::Palette,
        }
    }

    /// What put one picture to trace in the place of the other.
    pub(super) fn of_tracing(before: Option<Tracing>, after: Option<Tracing>) -> Self {
        match (before, after) {
            (_, None) => Self::Untraced,
            (Some(before), Some(after)) if before.image == after.image => Self::Faded,
            _ => Self::Traced,
        }
    }
}
