//! The colours that a drawing has at hand.

use crate::color::Paint;

/// One of the colours of a palette.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Swatch {
    /// What it paints.
    pub color: Paint,
    /// What somebody has called it; empty where nobody has.
    pub name: String,
}

impl From<Paint> for Swatch {
    fn from(color: Paint) -> Self {
        Self { color, name: String::new() }
    }
}
