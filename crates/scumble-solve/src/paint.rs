//! The painter on the CPU: turns a scene into pixels, for files and where there is no GPU.
//!
//! What a pixel is, so that every painter makes the same picture:
//!
//! - **Inner pixels** of the field, which no side of a curve passes through, take the colour of the triangle that
//!   holds the pixel's centre, at that centre. The quadratic is evaluated in the blend space; for OKLab its cone
//!   responses are cubed and taken to linear sRGB; each channel is clamped to `0..=1`, given the sRGB transfer
//!   function and rounded to the nearest of 255 levels. A triangle whose colours differ by less than 1e-6 has one
//!   colour. Colours are blended times their opacity, and divided by the opacity that comes out; where it is below 1,
//!   the paper shows through in straight sRGB values.
//! - **Rim pixels**, which a side passes through, are the mean of 16 samples on a rotated grid. All samples that one
//!   triangle covers have the 8-bit colour that it has at the pixel's centre, its negative corner weights taken as
//!   zero (and the others scaled to a sum of 1); samples without a triangle are paper. The mean is of 8-bit sRGB
//!   values, weighted by opacity; over transparent paper the mean opacity is the alpha.
//! - **Shapes** cover the samples that any of their triangles covers, and are mixed in with straight sRGB values,
//!   opacity times coverage, in order.
//!
//! A point on the left or upper edge of a triangle belongs to it, one on the right or lower edge does not. Edges of
//! the field that are not sides of curves are never smoothed, so its outer border is cut at pixel centres there.

mod canvas;
mod encode;
mod field_painter;
mod gradient;
mod grid_painter;
mod pixel_set;
mod raster;
mod stencil;
#[cfg(test)]
mod tests;

use canvas::Canvas;
use scumble_core::Srgb8;
use stencil::Stencils;

use crate::grid::GridPicture;
use crate::scene::{Part, Scene, Shape, View};

/// A picture in sRGB with straight alpha.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pixmap {
    /// Picture size.
    pub width_px: u32,
    /// Picture size.
    pub height_px: u32,
    /// Red, green, blue and alpha of each pixel, row by row from the top left.
    pub rgba: Vec<u8>,
}

/// Paints what a view shows of a scene. Without paper, what nothing covers is transparent black.
///
/// Time and memory grow with the size of the picture, whatever the zoom; the caller bounds the size.
pub fn paint(scene: &Scene<'_>, view: &View) -> Pixmap {
    let mut canvas = Canvas::new(view, scene.paper);
    field_painter::paint_field(&mut canvas, scene.field, view.px_from_du, scene.paper);
    stencil::paint_once(&mut canvas, scene.shapes, view);
    canvas.into_pixmap()
}

/// Paints what the grid solver found for a view, and shapes over it, as [`paint`] does.
pub fn paint_grid(picture: &GridPicture, shapes: &[Shape], view: &View, paper: Option<Srgb8>) -> Pixmap {
    let mut canvas = Canvas::new(view, paper);
    grid_painter::paint_grid(&mut canvas, picture, paper);
    stencil::paint_once(&mut canvas, shapes, view);
    canvas.into_pixmap()
}

/// Paints a picture again and again: what shapes cover is found once for as long as they and the view stay.
#[derive(Debug, Default)]
pub struct Repainter(Stencils);

impl Repainter {
    /// Paints a part of what [`paint`] paints, which lies within the view.
    pub fn paint(&mut self, scene: &Scene<'_>, view: &View, part: &Part) -> Pixmap {
        let of_part = view.part(part);
        let mut canvas = Canvas::new(&of_part, scene.paper);
        field_painter::paint_field(&mut canvas, scene.field, of_part.px_from_du, scene.paper);
        self.0.paint(&mut canvas, scene.shapes, view, part);
        canvas.into_pixmap()
    }
}
