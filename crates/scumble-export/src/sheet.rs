//! The page of a file: what it measures outside, and in du.

use scumble_core::drawing::LONGER_SIDE_DU;
use scumble_io::PageSize;
use scumble_solve::View;

/// A page as it is written.
pub(crate) struct Sheet {
    /// Width and height, as SVG writes them.
    pub(crate) sides: [String; 2],
    /// The same in pixels of 1/96 inch.
    pub(crate) sides_px: [f64; 2],
    pub(crate) px_per_du: f64,
}

impl Sheet {
    /// A page as large as its drawing was.
    pub(crate) fn of_size(PageSize { sides, sides_px }: PageSize) -> Self {
        let px_per_du = sides_px[0].max(sides_px[1]) / LONGER_SIDE_DU;
        Self { sides, sides_px, px_per_du }
    }

    /// What a view shows, to the last pixel.
    pub(crate) fn of_view(view: &View) -> Self {
        let sides = [view.width_px, view.height_px];
        let [px_per_du, ..] = view.px_from_du.as_coeffs();
        Self { sides: sides.map(|side| side.to_string()), sides_px: sides.map(f64::from), px_per_du }
    }

    pub(crate) fn sides_du(&self) -> [f64; 2] {
        self.sides_px.map(|side| side / self.px_per_du)
    }
}
