//! What a painter paints, on the CPU or on the GPU: paper, a colour field, flat shapes over it.

use std::ops::Range;

use kurbo::{Affine, Point, Rect, Vec2};
use scumble_core::{Rgba8, Srgb8};

use crate::field::Field;

/// Everything in one picture, back to front.
#[derive(Clone, Debug)]
pub struct Scene<'a> {
    /// The paper's colour, or `None` for a transparent picture.
    pub paper: Option<Srgb8>,
    /// The coloured regions.
    pub field: &'a Field,
    /// Scribbles, fills, lines: later ones over earlier ones.
    pub shapes: &'a [Shape],
}

/// A flat-coloured shape as triangles in du. They may overlap; each place is painted once.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Corners, turning either way.
    pub triangles: Vec<[[f32; 2]; 3]>,
    /// Colour and opacity.
    pub color: Rgba8,
}

impl Shape {
    /// What it lies within, in du; `None` where there is nothing of it.
    pub fn bounds(&self) -> Option<Rect> {
        bounds(&self.triangles)
    }
}

/// What triangles lie within.
pub(crate) fn bounds<'a>(triangles: impl IntoIterator<Item = &'a [[f32; 2]; 3]>) -> Option<Rect> {
    let corners = triangles.into_iter().flatten().map(|&[x, y]| Point::new(x.into(), y.into()));
    corners.map(|corner| Rect::from_points(corner, corner)).reduce(|a, b| a.union(b))
}

/// Which part of the plane a picture shows, at which size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Takes du to pixels; pixel (0, 0) covers the square from (0, 0) to (1, 1).
    pub px_from_du: Affine,
    /// Picture size.
    pub width_px: u32,
    /// Picture size.
    pub height_px: u32,
}

impl View {
    /// Some rows of it, from the first one on, as a view of their own.
    #[must_use]
    pub fn rows(&self, rows: Range<u32>) -> Self {
        let up = Vec2::new(0.0, -f64::from(rows.start));
        Self { px_from_du: self.px_from_du.then_translate(up), height_px: rows.end - rows.start, ..*self }
    }
}
