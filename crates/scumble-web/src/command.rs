//! What the page can ask for.

use kurbo::{Point, Vec2};
use scumble_core::{Blend, Paint, Srgb8};

use crate::view::Viewport;

/// Where a gesture of the pen is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// It begins.
    Down,
    /// It goes on.
    Move,
    /// It ends, and is kept.
    Up,
    /// It is abandoned, and leaves nothing.
    Cancel,
}

impl Phase {
    /// The phase of a name that the page uses.
    pub fn from_name(name: &str) -> Option<Self> {
        match name {
            "down" => Some(Self::Down),
            "move" => Some(Self::Move),
            "up" => Some(Self::Up),
            "cancel" => Some(Self::Cancel),
            _ => None,
        }
    }
}

/// One wish of the page.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Work on another drawing.
    Open {
        /// What to call it.
        name: String,
        /// An SVG file.
        bytes: Vec<u8>,
    },
    /// The colour of the next scribbles, or none.
    Color(Paint),
    /// Back to the colour before.
    SwapColors,
    /// The width of the next scribbles, in du.
    BrushSize(f64),
    /// A step wider.
    BrushLarger,
    /// A step narrower.
    BrushSmaller,
    /// Take the last gesture back.
    Undo,
    /// Do it again.
    Redo,
    /// The space in which colours are blended.
    Blend(Blend),
    /// Whether lines are shown.
    Lines(bool),
    /// Whether scribbles are shown.
    Scribbles(bool),
    /// The colour around the page.
    Desk(Srgb8),
    /// Another view.
    View(ViewChange),
}

/// One change of what the canvas shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ViewChange {
    /// A step closer.
    ZoomIn,
    /// A step away.
    ZoomOut,
    /// One du is one CSS pixel.
    ZoomReset,
    /// All of the page.
    Fit,
    /// By a way in CSS pixels.
    Pan(Vec2),
    /// Closer by a factor, about a place in CSS pixels.
    ZoomAt(Point, f64),
    /// The canvas' size in device pixels, and the device pixels of one CSS pixel.
    Resize([u32; 2], f64),
}

impl ViewChange {
    pub(crate) fn apply(self, viewport: &mut Viewport) {
        match self {
            Self::ZoomIn => viewport.zoom_in(),
            Self::ZoomOut => viewport.zoom_out(),
            Self::ZoomReset => viewport.zoom_to(1.0),
            Self::Fit => viewport.fit(),
            Self::Pan(way_css) => viewport.pan(way_css),
            Self::ZoomAt(at_css, factor) => viewport.zoom_at(at_css, factor),
            Self::Resize([width_px, height_px], px_per_css) => {
                viewport.resize(width_px, height_px, px_per_css);
            }
        }
    }
}
