//! Diffusion curves out: the curves of a drawing with the colours that the picture has along them.
//!
//! Colours are whole numbers of `globalID` from the start, so curves are cut into a cubic wherever a colour is; and into
//! curves where the colour of a side begins or ends, since a side has one from end to end or none.

use kurbo::{CubicBez, Point, Size};
use scumble_core::color_points::{ColorSpan, curve_colors};
use scumble_core::{Blend, Document, Labels, Paint, PlanarMap, Rgba8, Srgb8};

use super::{BARRIER, IDS_PER_CUBIC, OKLAB, ROOT};
use crate::json::push_number;
use crate::notes::CurveSetNotes;
use stretches::Stretches;

mod stretches;

/// Steps of coordinates in one du.
const PER_DU: u64 = 1_000_000;

/// What stands for no colour: the colour of the paper.
const PAPER: Srgb8 = Srgb8([255; 3]);

/// What rounding may have left of a side of a page, in du.
const ROUNDING_DU: f64 = 1e-6;

/// A barrier across a gap goes on by this much at both ends, in du: readers may sample curves a little beside it.
const OVERSHOOT_DU: f64 = 0.25;

/// The diffusion curves of a picture, which are its colours without lines and shades; and what they leave out.
///
/// The labels are those of the document's scribbles on its map. A pixel of the file is a du. Gaps that are closed become
/// curves without colours.
pub fn write_curve_set(document: &Document, map: &PlanarMap, labels: &Labels) -> (String, CurveSetNotes) {
    let Document { drawing, scribbles, color_points, settings, .. } = document;
    let spans = curve_colors(map, labels, scribbles, color_points);
    let mut spans_of = vec![Vec::new(); drawing.curves.len()];
    spans.iter().for_each(|span| spans_of[span.curve as usize].push(span));
    let mut parts = Vec::new();
    for (i, (curve, spans)) in drawing.curves.iter().zip(&spans_of).enumerate() {
        let round_du = map.steps(i).last().map_or(0.0, |step| step.arc_du[1]);
        parts.extend(Stretches::new(&curve.path, spans, round_du, settings.blend).parts());
    }
    parts.extend(barriers(map, labels));
    let is_clear = |span: &ColorSpan| span.stops.iter().any(|stop| stop.color == Paint::Clear);
    let notes = CurveSetNotes {
        shades: scribbles.iter().filter(|scribble| !scribble.is_fill()).count(),
        clear: spans.iter().filter(|span| is_clear(span)).count(),
    };
    (written(drawing.size_du(), settings.blend, &parts), notes)
}

/// A curve of the file.
struct Part {
    cubics: Vec<CubicBez>,
    /// The colours of the left side and of the right one: in front of which cubic, and which.
    colors: [Vec<(usize, Rgba8)>; 2],
}

/// Straight curves without colours across the gaps that are closed.
fn barriers<'a>(map: &'a PlanarMap, labels: &'a Labels) -> impl Iterator<Item = Part> + use<'a> {
    map.closed_gaps(&labels.closed_gaps).map(|gap| {
        let [a, b] = gap.nodes.map(|node| map.triangulation().points()[node as usize]);
        let over = (b - a) * (OVERSHOOT_DU / (b - a).hypot());
        let line = |a: Point, b: Point| CubicBez::new(a, a.lerp(b, 1.0 / 3.0), a.lerp(b, 2.0 / 3.0), b);
        Part { cubics: vec![line(a - over, a), line(a, b), line(b, b + over)], colors: [vec![], vec![]] }
    })
}

fn written(size_du: Size, blend: Blend, parts: &[Part]) -> String {
    // Whole pixels, all of them on the page: beyond it, what ends at its border would end before that of the file.
    let [width, height] =
        [size_du.width, size_du.height].map(|side| ((side + ROUNDING_DU) as u32).max(1).to_string());
    let mut text = String::from("<!DOCTYPE CurveSetXML>\n");
    text.extend(["<", ROOT, " image_width=\"", &width, "\" image_height=\"", &height, "\" nb_curves=\""]);
    text.extend([&parts.len().to_string(), "\""]);
    if blend == Blend::Oklab {
        text.extend([" blend=\"", OKLAB, "\""]);
    }
    text.push_str(" >\n");
    parts.iter().for_each(|part| push_part(&mut text, part));
    text.extend(["</", ROOT, ">\n"]);
    text
}

fn push_part(text: &mut String, Part { cubics, colors: [left, right] }: &Part) {
    let [points, lefts, rights] = [3 * cubics.len() + 1, left.len(), right.len()].map(|n| n.to_string());
    text.extend([" <curve nb_control_points=\"", &points, "\" nb_left_colors=\"", &lefts]);
    text.extend(["\" nb_right_colors=\"", &rights, "\" nb_blur_points=\"2\" lifetime=\"32\" >\n"]);
    text.push_str("  <control_points_set>\n");
    let start = cubics.first().map(|cubic| cubic.p0);
    for point in start.into_iter().chain(cubics.iter().flat_map(|c| [c.p1, c.p2, c.p3])) {
        text.push_str("   <control_point x=\"");
        push_number(text, point.y, PER_DU);
        text.push_str("\" y=\"");
        push_number(text, point.x, PER_DU);
        text.push_str("\" />\n");
    }
    text.push_str("  </control_points_set>\n");
    push_colors(text, "left", left);
    push_colors(text, "right", right);
    text.push_str("  <blur_points_set>\n");
    for cubic in [0, cubics.len()] {
        text.extend(["   <best_scale value=\"0\" globalID=\"", &id(cubic), "\" />\n"]);
    }
    text.push_str("  </blur_points_set>\n </curve>\n");
}

fn push_colors(text: &mut String, side: &str, colors: &[(usize, Rgba8)]) {
    text.extend(["  <", side, "_colors_set"]);
    if colors.is_empty() {
        text.extend([" boundary=\"", BARRIER, "\""]);
    }
    text.push_str(">\n");
    for (cubic, Rgba8([r, g, b, _])) in colors {
        let [red, green, blue] = [r, g, b].map(|channel| channel.to_string());
        text.extend(["   <", side, "_color G=\"", &green, "\" R=\"", &blue, "\" globalID=\"", &id(*cubic)]);
        text.extend(["\" B=\"", &red, "\" />\n"]);
    }
    text.extend(["  </", side, "_colors_set>\n"]);
}

fn id(cubic: usize) -> String {
    (IDS_PER_CUBIC as usize * cubic).to_string()
}
