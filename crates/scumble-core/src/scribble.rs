//! A scribble: a stroke of colour that a person drew over the lines.

use kurbo::Point;

use crate::color::Paint;

/// A stroke of colour. A single point is a dab.
#[derive(Clone, Debug, PartialEq)]
pub struct Scribble {
    /// The colour as picked, or nothing.
    pub color: Paint,
    /// Width of the drawn stroke in du; positive.
    pub width_du: f64,
    /// The pen's way, in du; at least one point, all finite.
    pub points: Vec<Point>,
}
