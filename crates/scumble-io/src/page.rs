//! The part of a drawing that is shown: the rectangle of its `viewBox`, in the units of that `viewBox`.
//!
//! `usvg` gives everything in pixels of the outermost `width` and `height`; this is undone here.

use kurbo::{Affine, Rect, Vec2};
use roxmltree::Document;
use svgtypes::{Align, AspectRatio, ViewBox};

use crate::error::ImportError;
use crate::work_file::PAGE_PER_UNIT;

/// A page and the way to it from `usvg`'s pixels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Page {
    /// In page units; finite, with positive width and height.
    pub(crate) rect: Rect,
    pub(crate) page_from_px: Affine,
}

/// Pages smaller or larger than this, in page units, leave `usvg` no digits to work with.
const SIDE_RANGE: std::ops::RangeInclusive<f64> = 1e-6..=1e8;

/// The page of a tree whose `usvg` picture has a given size in pixels.
///
/// # Errors
/// When the page has no area.
pub(crate) fn of(xml: &Document, [width_px, height_px]: [f64; 2]) -> Result<Page, ImportError> {
    let svg = xml.root_element();
    let Some(text) = svg.attribute("viewBox") else {
        return checked(Rect::new(0.0, 0.0, width_px, height_px), Affine::IDENTITY);
    };
    let view_box: ViewBox = text.parse().map_err(|_| ImportError::NoPage)?;
    let rect = Rect::from_origin_size((view_box.x, view_box.y), (view_box.w, view_box.h));
    let aspect = svg.attribute("preserveAspectRatio").and_then(|text| text.parse().ok());
    let px_from_page = px_from_page(rect, Vec2::new(width_px, height_px), aspect.unwrap_or_default());
    checked(rect, px_from_page.inverse())
}

fn checked(rect: Rect, page_from_px: Affine) -> Result<Page, ImportError> {
    let rect = kept(rect);
    let sides = [rect.width(), rect.height()];
    let usable =
        sides.iter().all(|side| SIDE_RANGE.contains(side)) && page_from_px.is_finite() && rect.is_finite();
    if usable { Ok(Page { rect, page_from_px }) } else { Err(ImportError::NoPage) }
}

/// The page as files hold it, so that it is the same when it is opened again.
pub(crate) fn kept(rect: Rect) -> Rect {
    let steps = PAGE_PER_UNIT as f64;
    let [x, y, width, height] =
        [rect.x0, rect.y0, rect.width(), rect.height()].map(|number| (number * steps).round() / steps);
    Rect::new(x, y, x + width, y + height)
}

/// The `viewBox` fitted into the picture as `preserveAspectRatio` says.
fn px_from_page(rect: Rect, size_px: Vec2, aspect: AspectRatio) -> Affine {
    let fit = Vec2::new(size_px.x / rect.width(), size_px.y / rect.height());
    let scale = match (aspect.align, aspect.slice) {
        (Align::None, _) => fit,
        (_, true) => Vec2::new(fit.x.max(fit.y), fit.x.max(fit.y)),
        (_, false) => Vec2::new(fit.x.min(fit.y), fit.x.min(fit.y)),
    };
    let room = size_px - Vec2::new(rect.width() * scale.x, rect.height() * scale.y);
    let (x, y) = alignment(aspect.align);
    Affine::translate((room.x * x, room.y * y))
        * Affine::scale_non_uniform(scale.x, scale.y)
        * Affine::translate(-rect.origin().to_vec2())
}

/// How much of the spare room is to the left and above.
fn alignment(align: Align) -> (f64, f64) {
    match align {
        Align::None | Align::XMinYMin => (0.0, 0.0),
        Align::XMidYMin => (0.5, 0.0),
        Align::XMaxYMin => (1.0, 0.0),
        Align::XMinYMid => (0.0, 0.5),
        Align::XMidYMid => (0.5, 0.5),
        Align::XMaxYMid => (1.0, 0.5),
        Align::XMinYMax => (0.0, 1.0),
        Align::XMidYMax => (0.5, 1.0),
        Align::XMaxYMax => (1.0, 1.0),
    }
}
