//! Which centres of pixels are seen past curves; closed gaps count as curves. `shaders/seen.wgsl` has the same.

use kurbo::{Line, Point};

/// A curve that passes through the centre of a pixel, to so many px, hides it: which side it is on is rounding.
const BEYOND_PX: f64 = 0.01;

/// The way from a place to the centre of a pixel, in px, and a little on.
#[derive(Clone, Copy)]
pub(crate) struct Sight(Line);

impl Sight {
    pub(crate) fn new(place: Point, center: Point) -> Self {
        let way = center - place;
        Self(Line::new(place, center + BEYOND_PX * way / way.length().max(BEYOND_PX)))
    }

    /// Whether a line hides the centre.
    pub(crate) fn is_crossed_by(self, line: Line) -> bool {
        are_apart(line, self.0) && are_apart(self.0, line)
    }
}

/// Whether the ends of a line are on different sides of another one, however long that is.
fn are_apart(other: Line, ends: Line) -> bool {
    let is_left = |p: Point| (other.p1 - other.p0).cross(p - other.p0) > 0.0;
    is_left(ends.p0) != is_left(ends.p1)
}
