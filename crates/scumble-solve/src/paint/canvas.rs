//! The pixels of a picture while it is painted.

use std::ops::Range;

use scumble_core::Srgb8;

use super::Pixmap;
use super::raster::SAMPLES;
use crate::scene::View;

/// Rows of pixels: red, green, blue and straight alpha.
pub(super) struct Canvas {
    width: u32,
    height: u32,
    pixels: Vec<[u8; 4]>,
}

impl Canvas {
    /// Bare paper.
    pub(super) fn new(view: &View, paper: Option<Srgb8>) -> Self {
        let View { width_px: width, height_px: height, .. } = *view;
        let color = paper.map_or([0; 4], |Srgb8([r, g, b])| [r, g, b, 255]);
        Self { width, height, pixels: vec![color; width as usize * height as usize] }
    }

    /// In px, signed like the coordinates of what is painted.
    pub(super) fn width(&self) -> i32 {
        self.width as i32
    }

    /// In px, signed like the coordinates of what is painted.
    pub(super) fn height(&self) -> i32 {
        self.height as i32
    }

    /// Some pixels of a row.
    pub(super) fn span_mut(&mut self, row: i32, columns: Range<usize>) -> &mut [[u8; 4]] {
        &mut self.pixels[row as usize * self.width as usize..][columns]
    }

    /// The finished picture.
    pub(super) fn into_pixmap(self) -> Pixmap {
        Pixmap { width_px: self.width, height_px: self.height, rgba: self.pixels.into_flattened() }
    }
}

/// A colour over a pixel of which it covers some samples; both with straight alpha.
// The page is small first: one copy of it serves all painters.
#[inline(never)]
pub(super) fn over(below: [u8; 4], color: [u8; 4], samples: u32) -> [u8; 4] {
    const WHOLE: u32 = 255 * SAMPLES as u32;
    let alpha = u32::from(color[3]) * samples;
    if alpha == WHOLE {
        return color;
    }
    let weight = 255 * alpha;
    let weight_below = u32::from(below[3]) * (WHOLE - alpha);
    let sum = weight + weight_below;
    let mix = |c: usize| {
        let mixed = u32::from(color[c]) * weight + u32::from(below[c]) * weight_below + sum / 2;
        mixed.checked_div(sum).unwrap_or(0) as u8
    };
    [mix(0), mix(1), mix(2), ((sum + WHOLE / 2) / WHOLE) as u8]
}
