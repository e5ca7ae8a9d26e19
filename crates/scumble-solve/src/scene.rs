//! What a painter paints, on the CPU or on the GPU: paper, a colour field, flat shapes over it.

use std::ops::Range;
use std::sync::Arc;

use kurbo::{Affine, Point, Rect, Vec2};
use scumble_core::{Rgba8, Srgb8, bounds};

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

/// What a triangle of a shape takes as bytes: six numbers of four.
const TRIANGLE_BYTES: usize = 4 * 6;

impl Shape {
    /// Shapes as bytes, for another module of the page: of each its colour, the number of its triangles, and these.
    pub fn all_to_bytes(shapes: &[Self]) -> Vec<u8> {
        let mut bytes = Vec::new();
        for Self { triangles, color } in shapes {
            bytes.extend(color.0);
            bytes.extend((triangles.len() as u32).to_le_bytes());
            bytes.extend_from_slice(bytemuck::cast_slice(triangles));
        }
        bytes
    }

    /// What [`Shape::all_to_bytes`] made; `None` for other bytes.
    pub fn all_from_bytes(mut bytes: &[u8]) -> Option<Vec<Self>> {
        let mut shapes = Vec::new();
        while let Some((&color, rest)) = bytes.split_first_chunk() {
            let (&count, rest) = rest.split_first_chunk()?;
            let count = u32::from_le_bytes(count) as usize;
            let (triangles, rest) = rest.split_at_checked(count.checked_mul(TRIANGLE_BYTES)?)?;
            let triangles: Vec<_> = bytemuck::pod_collect_to_vec(triangles);
            shapes.push(Self { triangles: triangles.into(), color: Rgba8(color) });
            bytes = rest;
        }
        bytes.is_empty().then_some(shapes)
    }

    /// What it lies within, in du; `None` where there is nothing of it.
    pub fn bounds(&self) -> Option<Rect> {
        bounds::of(self.triangles.as_flattened().iter().copied().map(point))
    }
}

pub(crate) fn point([x, y]: [f32; 2]) -> Point {
    Point::new(x.into(), y.into())
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

    /// The smallest upright rectangle that holds what it shows.
    pub fn seen_du(&self) -> Rect {
        let pixels = Rect::new(0.0, 0.0, self.width_px.into(), self.height_px.into());
        self.px_from_du.inverse().transform_rect_bbox(pixels)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_of_shapes_lose_nothing_and_other_bytes_are_none() {
        let shape = |count: usize, color| {
            let triangles =
                (0..count).map(|i| [[i as f32 + 0.1, -2.5], [1024.0, 3.0], [7.0, f32::MIN_POSITIVE]]);
            Shape { triangles: triangles.collect(), color: Rgba8(color) }
        };
        for shapes in [vec![], vec![shape(2, [1, 2, 3, 4]), shape(0, [255; 4]), shape(1, [0; 4])]] {
            let bytes = Shape::all_to_bytes(&shapes);
            assert_eq!(Shape::all_from_bytes(&bytes), Some(shapes));
            let longer = [&bytes[..], &[0]].concat();
            assert_eq!(Shape::all_from_bytes(&longer), None);
        }
        assert_eq!(
            Shape::all_from_bytes(&[1, 2, 3, 4, 255, 255, 255, 255]),
            None,
            "a count without its triangles"
        );
    }
}
