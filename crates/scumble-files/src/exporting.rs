//! Pictures for other programs, without a browser.

use scumble_core::Srgb8;
use scumble_export::{Export, Look};
use scumble_solve::Field;

use crate::opening::{self, OpenError};

const WHITE: Srgb8 = Srgb8([255; 3]);

/// A picture, as the page asks for it.
#[derive(Clone, Copy, Debug)]
pub struct Wanted<'a> {
    /// Exact bytes of the work.
    pub work: &'a [u8],
    /// Bytes of its field.
    pub field: &'a [u8],
    /// The longer side of the page, in pixels.
    pub size_px: u32,
    /// Whether lines are drawn.
    pub lines: bool,
    /// Whether there is no paper.
    pub transparent: bool,
}

impl Wanted<'_> {
    /// The SVG, with the pixels of a PNG where it needs some.
    ///
    /// # Errors
    /// Where the bytes are damaged, or the work is too much for a file.
    pub fn svg(&self, raster: &[u8]) -> Result<Vec<u8>, OpenError> {
        let (work, field) = self.source()?;
        Ok(Export::new(&work, &field, self.look()).svg(Some(raster))?.into_bytes())
    }

    /// The PDF.
    ///
    /// # Errors
    /// Where the bytes are damaged.
    pub fn pdf(&self) -> Result<Vec<u8>, OpenError> {
        let (work, field) = self.source()?;
        Ok(Export::new(&work, &field, self.look()).pdf())
    }

    fn source(&self) -> Result<(scumble_core::Work, Field), OpenError> {
        let field = Field::from_bytes(self.field).ok_or(OpenError::Damaged)?;
        Ok((opening::exact(self.work)?, field))
    }

    fn look(&self) -> Look {
        Look { size_px: self.size_px, lines: self.lines, paper: (!self.transparent).then_some(WHITE) }
    }
}
