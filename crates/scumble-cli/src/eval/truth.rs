//! The colours that a person would expect: the `truth.png` of a quality set.

use std::io::Cursor;

use anyhow::{Context, ensure};
use png::{BitDepth, ColorType, Decoder};
use scumble_core::{Paint, Scribble, Srgb8};

use crate::rivals::neighbors;

/// The colours of a quality set's scribbles; the red of a truth picture is an index into it.
pub(crate) const PALETTE: [Srgb8; 12] = [
    Srgb8([0xe6, 0x19, 0x4b]),
    Srgb8([0x3c, 0xb4, 0x4b]),
    Srgb8([0x43, 0x63, 0xd8]),
    Srgb8([0xf5, 0x82, 0x31]),
    Srgb8([0x91, 0x1e, 0xb4]),
    Srgb8([0x42, 0xd4, 0xf4]),
    Srgb8([0x9a, 0x63, 0x24]),
    Srgb8([0xf0, 0x32, 0xe6]),
    Srgb8([0xbf, 0xef, 0x45]),
    Srgb8([0x80, 0x00, 0x00]),
    Srgb8([0x00, 0x00, 0x75]),
    Srgb8([0x80, 0x80, 0x00]),
];

/// Largest width and height of a truth picture, in pixels.
const MAX_SIDE_PX: u32 = 4096;

/// What a pixel's colour counts for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    /// Nothing.
    Unscored,
    /// Area.
    Area,
    /// Area, and it lies beside a curve.
    Side,
}

/// A truth picture, row by row from the top left.
#[derive(Clone, Debug)]
pub(crate) struct Truth {
    /// Picture size.
    pub(crate) width_px: u32,
    /// Picture size.
    pub(crate) height_px: u32,
    /// For each pixel the index of its colour; what is unscored may have none.
    pub(crate) colors: Vec<u8>,
    /// What each pixel counts for.
    pub(crate) marks: Vec<Mark>,
}

impl Truth {
    /// Reads a PNG file: red is the index of the colour, green 0 (not scored), 128 (scored) or 255 (scored, and
    /// beside a curve).
    ///
    /// # Errors
    /// When the bytes are no PNG with three channels of 8 bits, or the picture is larger than 4096 × 4096 pixels.
    pub(crate) fn read(file: &[u8]) -> anyhow::Result<Self> {
        let mut reader = Decoder::new(Cursor::new(file)).read_info().context("not a PNG file")?;
        let (width_px, height_px) = reader.info().size();
        ensure!(width_px.max(height_px) <= MAX_SIDE_PX, "the picture is larger than {MAX_SIDE_PX} pixels");
        let is_rgb = reader.output_color_type() == (ColorType::Rgb, BitDepth::Eight);
        ensure!(is_rgb, "the picture has not three channels of 8 bits");
        let mut rgb = vec![0; 3 * width_px as usize * height_px as usize];
        reader.next_frame(&mut rgb).context("the PNG file is damaged")?;
        let (pixels, _) = rgb.as_chunks::<3>();
        let colors = pixels.iter().map(|[red, _, _]| *red).collect();
        let marks = pixels.iter().map(|[_, green, _]| mark(*green)).collect();
        Ok(Self { width_px, height_px, colors, marks })
    }

    /// The pixels that share an edge with a pixel.
    pub(crate) fn neighbors(&self, pixel: usize) -> impl Iterator<Item = usize> + use<> {
        neighbors(pixel, self.width_px as usize, self.height_px as usize)
    }

    /// The larger of width and height.
    pub(crate) fn longer_side_px(&self) -> u32 {
        self.width_px.max(self.height_px)
    }
}

fn mark(green: u8) -> Mark {
    match green {
        0 => Mark::Unscored,
        255 => Mark::Side,
        _ => Mark::Area,
    }
}

/// The index of a scribble's colour in the palette.
///
/// # Errors
/// When it is not in the palette, so that no pixel of a truth picture can have it.
pub(crate) fn palette_index(scribble: &Scribble) -> anyhow::Result<u8> {
    let index = PALETTE.iter().position(|color| Paint::Color(*color) == scribble.color);
    let index = index.with_context(|| {
        format!("the colour {} of a scribble is not in the palette of quality sets", scribble.color)
    })?;
    Ok(index as u8)
}
