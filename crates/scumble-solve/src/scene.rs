//! What a painter paints, on the CPU or on the GPU: paper, a colour field, flat shapes over it.

use std::ops::Range;
use std::sync::Arc;

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
    /// Corners, turning either way. Copies of a shape share them, which tells a painter that it knows them.
    pub triangles: Arc<[[[f32; 2]; 3]]>,
    /// Colour and opacity.
    pub color: Rgba8,
}

impl Shape {
    /// What it lies within, in du; `None` where there is nothing of it.
    pub fn bounds(&self) -> Option<Rect> {
        bounds(&*self.triangles)
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

/// Some pixels of a picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part {
    /// From the left.
    pub columns: Range<u32>,
    /// From the top.
    pub rows: Range<u32>,
}

impl View {
    /// All pixels of it.
    pub fn whole(&self) -> Part {
        Part { columns: 0..self.width_px, rows: 0..self.height_px }
    }

    /// Some pixels of it, as a view of their own.
    #[must_use]
    pub fn part(&self, Part { columns, rows }: &Part) -> Self {
        let corner = Vec2::new(columns.start.into(), rows.start.into());
        Self {
            px_from_du: self.px_from_du.then_translate(-corner),
            width_px: columns.end - columns.start,
            height_px: rows.end - rows.start,
        }
    }
}
