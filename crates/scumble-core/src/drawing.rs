//! A line drawing: curves in drawing units, and what they look like.
//!
//! One drawing unit (du) is 1/1024 of the longer side of the page. Page coordinates are those of the file that
//! the drawing came from (an SVG's viewBox).

use kurbo::{Affine, BezPath, Rect, Size, Stroke};

use crate::color::Rgba8;

/// The longer side of every drawing, in du.
pub const LONGER_SIDE_DU: f64 = 1024.0;

/// A line drawing. Source state: what is derived from it is never stored in it.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// The part of the plane that the picture shows, in page units. Finite, with positive width and height.
    pub page: Rect,
    /// The curves, in painting order.
    pub curves: Vec<Curve>,
    /// Solid ink: dark areas that belong to the lines and are shown with them.
    pub fills: Vec<Fill>,
}

/// One curve: a single open or closed Bézier path and how its line is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// One subpath (`MoveTo`, then `LineTo` and `CurveTo`, at most one `ClosePath` at the end), in du.
    pub path: BezPath,
    /// The line drawn along it, or `None` for an outline of an area that is shown as a [`Fill`].
    pub line: Option<Line>,
}

/// The drawn line of a curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// Width, caps, joins and dashes, in du.
    pub stroke: Stroke,
    /// Colour and opacity.
    pub color: Rgba8,
}

/// An area of solid ink.
#[derive(Clone, Debug, PartialEq)]
pub struct Fill {
    /// Any number of subpaths, in du.
    pub path: BezPath,
    /// Whether the even-odd rule says what is inside; otherwise the non-zero rule does.
    pub even_odd: bool,
    /// Colour and opacity.
    pub color: Rgba8,
}

impl Drawing {
    /// An empty drawing on a page.
    pub fn new(page: Rect) -> Self {
        Self { page, curves: Vec::new(), fills: Vec::new() }
    }

    /// Page size in du; the longer side is [`LONGER_SIDE_DU`].
    pub fn size_du(&self) -> Size {
        self.page.size() * self.du_per_page_unit()
    }

    /// The page in du: from the origin to [`Drawing::size_du`].
    pub fn frame(&self) -> Rect {
        self.size_du().to_rect()
    }

    /// Takes page coordinates to du.
    pub fn drawing_from_page(&self) -> Affine {
        Affine::scale(self.du_per_page_unit()) * Affine::translate(-self.page.origin().to_vec2())
    }

    /// Drawing units in one page unit.
    pub fn du_per_page_unit(&self) -> f64 {
        LONGER_SIDE_DU / self.page.size().max_side()
    }
}
