//! What is exported, and how it is to look.

use std::ops::RangeInclusive;

use kurbo::Affine;
use scumble_core::drawing::LONGER_SIDE_DU;
use scumble_core::{Srgb8, Work};
use scumble_io::{FileError, PageSize};
use scumble_solve::{Field, View};

use crate::regions::Regions;
use crate::sheet::Sheet;
use crate::tint::Tint;
use crate::{pdf, svg};

/// The longer side of the shades in an SVG, in pixels: as long as the picture's, within this range. An SVG is for looking
/// closer, too; but shades need no more pixels, and a file with more of them could not be opened again.
pub const RASTER_PX: RangeInclusive<u32> = 2048..=4096;

/// The scale of the field that a picture is made of: its edges bend as curves do that are seen at so many pixels of a du.
pub const PX_PER_DU: f64 = 16.0;

/// How a picture is to look.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// The longer side of the page, in pixels of 1/96 inch. Where it is that of the drawing's own size, rounded, the page is
    /// exactly as large as that.
    pub size_px: u32,
    /// Whether lines and solid ink are drawn over the colours.
    pub lines: bool,
    /// The colour behind everything, or `None` for a page that is transparent.
    pub paper: Option<Srgb8>,
}

/// A picture to be written.
#[derive(Debug)]
pub struct Export<'a> {
    pub(crate) work: &'a Work,
    pub(crate) look: Look,
    pub(crate) tint: Tint,
    pub(crate) regions: Regions,
}

impl<'a> Export<'a> {
    /// The picture of some work, of which this is the field, as it is seen at [`PX_PER_DU`].
    pub fn new(work: &'a Work, field: &Field, look: Look) -> Self {
        let tint = Tint { blend: field.blend, paper: look.paper };
        Self { work, look, tint, regions: Regions::new(field, &tint) }
    }

    /// The pixels that an SVG of it needs, of the field alone, on its paper; `None` where all regions are of one colour.
    pub fn raster_view(&self) -> Option<View> {
        let size_px = self.look.size_px.clamp(*RASTER_PX.start(), *RASTER_PX.end());
        (!self.regions.smooth.is_empty()).then(|| self.view(size_px))
    }

    /// The picture as SVG, with the work in it, which can be opened again.
    ///
    /// `raster` is a PNG of [`Export::raster_view`], which the caller paints.
    ///
    /// # Errors
    /// When the work is too much for a file.
    pub fn svg(&self, raster: Option<&[u8]>) -> Result<String, FileError> {
        svg::written(self, raster)
    }

    /// The picture as PDF.
    pub fn pdf(&self) -> Vec<u8> {
        pdf::written(self)
    }

    /// How it is to look.
    pub fn look(&self) -> Look {
        self.look
    }

    /// The page as it is written.
    pub(crate) fn sheet(&self) -> Sheet {
        let own = PageSize::of(self.work).filter(|own| own.longer_px() == self.look.size_px);
        own.map_or_else(|| Sheet::of_view(&self.view(self.look.size_px)), Sheet::of_size)
    }

    /// The whole page with a longer side of so many pixels.
    pub(crate) fn view(&self, size_px: u32) -> View {
        let px_per_du = f64::from(size_px) / LONGER_SIDE_DU;
        let size = self.work.document.drawing.size_du() * px_per_du;
        let [width_px, height_px] = [size.width, size.height].map(|side| (side.round() as u32).max(1));
        View { px_from_du: Affine::scale(px_per_du), width_px, height_px }
    }
}
