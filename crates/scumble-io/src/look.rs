//! What the lines of a drawing look like.

use kurbo::{Affine, Cap, Join, Stroke};
use scumble_core::{Line, Rgba8};
use usvg::{LineCap, LineJoin};

use crate::paint;

/// Width of the line drawn around an area that is not ink and has no stroke of its own, in du.
const OUTLINE_WIDTH_DU: f64 = 1.0;

/// The drawn line of a stroke. Under a transform that is no similarity its width is scaled as areas are, by the
/// square root of the determinant.
pub(crate) fn line(stroke: &usvg::Stroke, opacity: f32, du_from_line: Affine) -> Option<Line> {
    let color = paint::color(stroke.paint(), opacity * stroke.opacity().get())?;
    let scale = du_from_line.determinant().abs().sqrt();
    let width_du = f64::from(stroke.width().get()) * scale;
    if !width_du.is_finite() || width_du <= 0.0 {
        return None;
    }
    let dashes = stroke.dasharray().unwrap_or_default().iter().map(|dash| f64::from(*dash) * scale);
    let stroke = Stroke::new(width_du)
        .with_join(join(stroke.linejoin()))
        .with_miter_limit(f64::from(stroke.miterlimit().get()))
        .with_caps(cap(stroke.linecap()))
        .with_dashes(f64::from(stroke.dashoffset()) * scale, dashes);
    Some(Line { stroke, color })
}

/// A line upon white paper that was drawn upon another: black where it showed upon that alone. Upon dark paper lines are light.
pub(crate) fn upon_white(mut line: Line, paper: Rgba8) -> Line {
    let is_light =
        if paint::is_ink(paper) { !paint::is_dark(line.color) } else { paint::is_pale(line.color) };
    if is_light && !paint::is_light(paper) {
        line.color = Rgba8([0, 0, 0, line.color.0[3]]);
    }
    line
}

/// A line of which an area hides the inner half: as wide as what is seen of it, though not moved out.
pub(crate) fn halved(mut line: Line) -> Line {
    line.stroke.width /= 2.0;
    line
}

/// The line around an area that is not ink.
pub(crate) fn thin() -> Line {
    Line { stroke: Stroke::new(OUTLINE_WIDTH_DU), color: Rgba8([0, 0, 0, 255]) }
}

fn join(join: LineJoin) -> Join {
    match join {
        LineJoin::Miter | LineJoin::MiterClip => Join::Miter,
        LineJoin::Round => Join::Round,
        LineJoin::Bevel => Join::Bevel,
    }
}

fn cap(cap: LineCap) -> Cap {
    match cap {
        LineCap::Butt => Cap::Butt,
        LineCap::Round => Cap::Round,
        LineCap::Square => Cap::Square,
    }
}
