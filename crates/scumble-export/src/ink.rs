//! Lines and solid ink as paths, as the editor paints them.

use std::borrow::Cow;

use kurbo::{BezPath, Stroke, StrokeOpts};
use scumble_core::{Curve, Drawing, Line, Rgba8};
use scumble_solve::ink::{MAX_DASHES_IN_ALL, takes_dashes};

/// Largest distance of a line that is written as an area from its true place, in du: a tenth of a pixel at 400%.
const TOLERANCE_DU: f64 = 0.025;

/// A path with how it is painted.
#[derive(Debug)]
pub(crate) struct Ink<'a> {
    pub(crate) path: Cow<'a, BezPath>,
    pub(crate) color: Rgba8,
    pub(crate) manner: Manner,
}

#[derive(Debug)]
pub(crate) enum Manner {
    Fill {
        even_odd: bool,
    },
    /// With dashes only where they make sense, and the same cap at both ends.
    Line(Stroke),
}

/// The ink of a drawing, in painting order.
pub(crate) fn ink(drawing: &Drawing) -> impl Iterator<Item = Ink<'_>> {
    let fills = drawing.fills.iter().map(|fill| Ink {
        path: Cow::Borrowed(&fill.path),
        color: fill.color,
        manner: Manner::Fill { even_odd: fill.even_odd },
    });
    let mut left = MAX_DASHES_IN_ALL;
    let lines = drawing.curves.iter().filter_map(move |curve| line(curve, curve.line.as_ref()?, &mut left));
    fills.chain(lines).filter(|ink| ink.color.0[3] > 0)
}

/// What is drawn of a line, whose dashes are of those that are left.
fn line<'a>(curve: &'a Curve, Line { stroke, color }: &Line, left: &mut f64) -> Option<Ink<'a>> {
    if !(stroke.width > 0.0 && stroke.width.is_finite()) {
        return None;
    }
    let mut stroke = stroke.clone();
    if !takes_dashes(&curve.path, &stroke, TOLERANCE_DU, left) {
        stroke.dash_pattern.clear();
    }
    if stroke.start_cap == stroke.end_cap {
        return Some(Ink { path: Cow::Borrowed(&curve.path), color: *color, manner: Manner::Line(stroke) });
    }
    // Neither SVG nor PDF has a line with two caps.
    let area = kurbo::stroke(&curve.path, &stroke, &StrokeOpts::default(), TOLERANCE_DU);
    Some(Ink { path: Cow::Owned(area), color: *color, manner: Manner::Fill { even_odd: false } })
}
