//! Work as text, one line for each curve and scribble.

use kurbo::{BezPath, PathEl, Point, Stroke};
use scumble_core::work::{Item, Work};
use scumble_core::{
    ColorPoint, Curve, Document, Fill, Line, Paint, Rgba8, Scribble, Settings, Shading, Srgb8, Tracing,
};

use super::names::{BLENDS, CAPS, ENGINES, JOINS, KINDS, RULES, SIDES, name, plain_stroke};
use super::pressures::{self, has_pressures};
use super::swatch_names::{are_named, push_names};
use super::{NAMES_MINOR, PAGE_PER_UNIT, PER_UNIT, PRESSURE_MINOR, SIZE_MINOR, TRACING_MINOR, VERSION};
use crate::base64;
use crate::json::{push_number, push_string};
use crate::page_size::PageSize;

/// The text of some work, with the picture under its lines where there is one.
pub(super) fn written(work: &Work, image: &[u8]) -> String {
    let mut text = String::from("{\n\"format\": \"scumble\",\n\"version\": \"");
    let tracing = work.document.tracing.filter(|_| !image.is_empty());
    let Document { drawing, settings, scribbles, palette, .. } = &work.document;
    let minors = [
        work.unknown.minor,
        if tracing.is_some() { TRACING_MINOR } else { 0 },
        if has_pressures(scribbles) { PRESSURE_MINOR } else { 0 },
        if are_named(palette) { NAMES_MINOR } else { 0 },
        if PageSize::of(work).is_some() { SIZE_MINOR } else { 0 },
    ];
    let minor = minors.into_iter().fold(0, u32::max);
    text.extend([&VERSION[0].to_string(), ".", &minor.to_string(), "\""]);
    if let Some(name) = &work.sample {
        text.push_str(",\n\"sample\": ");
        push_string(&mut text, name);
    }
    text.push_str(",\n\"canvas\": [");
    let page = drawing.page;
    for (i, number) in [page.x0, page.y0, page.width(), page.height()].into_iter().enumerate() {
        text.push_str(if i > 0 { ", " } else { "" });
        push_number(&mut text, number, PAGE_PER_UNIT);
    }
    text.push_str("],\n\"settings\": ");
    push_settings(&mut text, settings, work.unknown.of(Item::Settings, 0));
    push_lists(&mut text, work);
    push_unknown(&mut text, ",\n", work.unknown.of(Item::Work, 0));
    // Last, as the last field of a name counts: a page of an older version may have kept others as unknown.
    if are_named(palette) {
        text.push_str(",\n");
        push_names(&mut text, &work.document.palette);
    }
    if let Some(tracing) = tracing {
        push_tracing(&mut text, tracing, image);
    }
    text.push_str("\n}\n");
    text
}

fn push_settings(text: &mut String, settings: &Settings, unknown: &str) {
    let [blend, engine] = [name(&BLENDS, settings.blend), name(&ENGINES, settings.engine)];
    text.extend(["{\"blend\": \"", blend, "\", \"engine\": \"", engine, "\", \"gap_closing\": "]);
    push_number(text, settings.gap_closing, PER_UNIT);
    text.extend([", \"spread\": ", if settings.spread { "true" } else { "false" }]);
    push_unknown(text, ", ", unknown);
    text.push('}');
}

fn push_unknown(text: &mut String, comma: &str, unknown: &str) {
    if !unknown.is_empty() {
        text.extend([comma, unknown]);
    }
}

fn push_lists(text: &mut String, work: &Work) {
    let Document { drawing, scribbles, color_points, palette, .. } = &work.document;
    push_list(text, "palette", palette.len(), &mut |text, i| push_paint(text, palette[i].color));
    push_list(text, "curves", drawing.curves.len(), &mut |text, i| {
        push_curve(text, &drawing.curves[i]);
        push_unknown(text, ", ", work.unknown.of(Item::Curve, i));
        text.push('}');
    });
    push_list(text, "fills", drawing.fills.len(), &mut |text, i| {
        push_fill(text, &drawing.fills[i]);
        push_unknown(text, ", ", work.unknown.of(Item::Fill, i));
        text.push('}');
    });
    push_list(text, "scribbles", scribbles.len(), &mut |text, i| {
        push_scribble(text, &scribbles[i]);
        push_unknown(text, ", ", work.unknown.of(Item::Scribble, i));
        text.push('}');
    });
    push_list(text, "color_points", color_points.len(), &mut |text, i| {
        push_color_point(text, &color_points[i]);
        push_unknown(text, ", ", work.unknown.of(Item::ColorPoint, i));
        text.push('}');
    });
}

/// A list with one line for each item; none where there are no items.
fn push_list(text: &mut String, name: &str, count: usize, push: &mut dyn FnMut(&mut String, usize)) {
    if count == 0 {
        return;
    }
    text.extend([",\n\"", name, "\": ["]);
    for i in 0..count {
        text.push_str(if i > 0 { ",\n" } else { "\n" });
        push(text, i);
    }
    text.push_str("\n]");
}

fn push_curve(text: &mut String, curve: &Curve) {
    text.push_str("{\"path\": ");
    push_path(text, &curve.path);
    if let Some(Line { stroke, color }) = &curve.line {
        push_length(text, "width", stroke.width.max(1.0 / PER_UNIT as f64));
        push_rgba(text, *color);
        push_stroke(text, stroke, &plain_stroke());
    }
}

/// What is not plain about a stroke.
fn push_stroke(text: &mut String, stroke: &Stroke, plain: &Stroke) {
    if [stroke.start_cap, stroke.end_cap] != [plain.start_cap, plain.end_cap] {
        let [start, end] = [stroke.start_cap, stroke.end_cap].map(|cap| name(&CAPS, cap));
        text.extend([", \"caps\": [\"", start, "\", \"", end, "\"]"]);
    }
    if stroke.join != plain.join {
        text.extend([", \"join\": \"", name(&JOINS, stroke.join), "\""]);
    }
    if stroke.miter_limit != plain.miter_limit {
        push_length(text, "miter_limit", stroke.miter_limit);
    }
    if !stroke.dash_pattern.is_empty() {
        text.push_str(", \"dashes\": ");
        push_numbers(text, &stroke.dash_pattern);
        push_length(text, "dash_offset", stroke.dash_offset);
    }
}

fn push_fill(text: &mut String, fill: &Fill) {
    text.push_str("{\"path\": ");
    push_path(text, &fill.path);
    text.extend([", \"rule\": \"", name(&RULES, fill.even_odd), "\""]);
    push_rgba(text, fill.color);
}

fn push_scribble(text: &mut String, scribble: &Scribble) {
    text.push_str("{\"color\": ");
    push_paint(text, scribble.color);
    push_length(text, "width", scribble.width_du.max(1.0 / PER_UNIT as f64));
    if let Some(Shading { strength, crosses, .. }) = scribble.shading() {
        text.extend([", \"kind\": \"", name(&KINDS, true), "\", \"strength\": "]);
        push_number(text, *strength, PER_UNIT);
        text.extend([", \"crosses\": ", if *crosses { "true" } else { "false" }]);
    }
    text.push_str(", \"points\": [");
    for (i, point) in scribble.points.iter().enumerate() {
        text.push_str(if i > 0 { ", " } else { "" });
        push_numbers(text, &[point.x, point.y]);
    }
    text.push(']');
    if let Some(field) = pressures::field(scribble) {
        text.extend([", ", &field]);
    }
}

fn push_color_point(text: &mut String, point: &ColorPoint) {
    text.extend([
        "{\"curve\": ",
        &point.curve.to_string(),
        ", \"side\": \"",
        name(&SIDES, point.is_left),
        "\"",
    ]);
    push_length(text, "at", point.at_du);
    text.push_str(", \"color\": ");
    push_paint(text, point.color);
}

fn push_tracing(text: &mut String, tracing: Tracing, image: &[u8]) {
    text.push_str(",\n\"tracing_opacity\": ");
    push_number(text, tracing.opacity, PER_UNIT);
    text.extend([",\n\"tracing_image\": \"", &base64::padded(image), "\""]);
}

fn push_length(text: &mut String, name: &str, length: f64) {
    text.extend([", \"", name, "\": "]);
    push_number(text, length, PER_UNIT);
}

pub(super) fn push_numbers(text: &mut String, numbers: &[f64]) {
    text.push('[');
    for (i, number) in numbers.iter().enumerate() {
        text.push_str(if i > 0 { "," } else { "" });
        push_number(text, *number, PER_UNIT);
    }
    text.push(']');
}

fn push_paint(text: &mut String, paint: Paint) {
    match paint {
        Paint::Clear => text.push_str("\"none\""),
        Paint::Color(Srgb8(rgb)) => push_hex(text, &rgb),
    }
}

fn push_rgba(text: &mut String, Rgba8(rgba): Rgba8) {
    text.push_str(", \"color\": ");
    push_hex(text, if rgba[3] == 255 { &rgba[..3] } else { &rgba });
}

fn push_hex(text: &mut String, bytes: &[u8]) {
    text.push_str("\"#");
    for digit in bytes.iter().flat_map(|byte| [byte >> 4, byte & 15]) {
        text.push(char::from_digit(u32::from(digit), 16).unwrap_or_default());
    }
    text.push('"');
}

fn push_path(text: &mut String, path: &BezPath) {
    text.push('"');
    for (i, element) in path.elements().iter().enumerate() {
        text.push_str(if i > 0 { " " } else { "" });
        let (command, points): (_, &[Point]) = match element {
            PathEl::MoveTo(p) => ('M', &[*p]),
            PathEl::LineTo(p) => ('L', &[*p]),
            PathEl::QuadTo(a, p) => ('Q', &[*a, *p]),
            PathEl::CurveTo(a, b, p) => ('C', &[*a, *b, *p]),
            PathEl::ClosePath => ('Z', &[]),
        };
        text.push(command);
        for number in points.iter().flat_map(|p| [p.x, p.y]) {
            text.push(' ');
            push_number(text, number, PER_UNIT);
        }
    }
    text.push('"');
}
