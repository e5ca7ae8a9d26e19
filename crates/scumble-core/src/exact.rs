//! Work as bytes that lose nothing: what goes from one part of the page to another, and into the browser's storage.
//! Only of the picture under the lines the file is not among them: it is large, and goes beside them.
//!
//! Numbers that are whole thousandths, as those of files are, take as few bytes as they need; all others take nine.
//! Writing and reading are one walk over the work. What reads trusts nothing: bytes that no work was written to stand
//! for none, and lists grow only as their items are read.

use std::mem;

use kurbo::{BezPath, Cap, Join, PathEl, Point, Rect, Stroke};

use crate::color::{Blend, Paint, Rgba8, Srgb8};
use crate::color_points::ColorPoint;
use crate::drawing::{Curve, Drawing, Fill, Line};
use crate::edit::Document;
use crate::palette::Swatch;
use crate::scribble::{PenPressure, Scribble, ScribbleKind, Shading};
use crate::settings::{EngineKind, Settings};
use crate::tracing::Tracing;
use crate::work::{MAX_CURVES, Unknown, Work, is_page, is_sample_name};
use tape::Tape;

mod tape;

/// The first byte. A storage may hold what an older version wrote, which is to be read as long as there are browsers
/// that have it. Version 1 has no picture under the lines, version 2 no pressure of pens and no names of swatches.
const VERSION: u8 = 3;

/// The bytes of some work.
pub fn write(work: &Work) -> Vec<u8> {
    let mut tape = Tape::blank();
    walk(&mut tape, &mut work.clone());
    tape.into_bytes()
}

/// The work that was written, or `None` where the bytes are damaged, of a newer version, or beyond the limits of files; but
/// scribbles may be longer in all than there, so that whoever has such can erase some.
pub fn read(bytes: &[u8]) -> Option<Work> {
    let mut tape = Tape::of(bytes);
    let mut work = Work::blank();
    walk(&mut tape, &mut work);
    tape.is_read_to_its_end().then_some(work)
}

fn walk(tape: &mut Tape, work: &mut Work) {
    let version = tape.byte(VERSION);
    tape.check((1..=VERSION).contains(&version));
    sample(tape, &mut work.sample);
    let Document { drawing, scribbles, color_points, settings, palette, tracing } = &mut work.document;
    lines(tape, drawing);
    self::settings(tape, settings);
    tape.list(scribbles, &BLANK_SCRIBBLE, &mut scribble);
    tape.list(palette, &Paint::Clear.into(), &mut |tape, swatch: &mut Swatch| paint(tape, &mut swatch.color));
    tape.list(color_points, &BLANK_COLOR_POINT, &mut color_point);
    unknown(tape, &mut work.unknown);
    if version > 1 {
        self::tracing(tape, tracing);
    }
    if version > 2 {
        scribbles.iter_mut().for_each(|scribble| pressure(tape, scribble));
        palette.iter_mut().for_each(|swatch| tape.text(&mut swatch.name));
    }
}

fn sample(tape: &mut Tape, sample: &mut Option<String>) {
    let has_sample = tape.flag(sample.is_some());
    let mut name = sample.take().unwrap_or_default();
    if has_sample {
        tape.text(&mut name);
        tape.check(is_sample_name(&name));
        *sample = Some(name);
    }
}

fn lines(tape: &mut Tape, drawing: &mut Drawing) {
    let page = drawing.page;
    let mut sides = [page.x0, page.y0, page.x1, page.y1];
    sides.iter_mut().for_each(|side| tape.number(side));
    let [x0, y0, x1, y1] = sides;
    tape.check(is_page([x0, y0, x1 - x0, y1 - y0]));
    drawing.page = Rect::new(x0, y0, x1, y1);
    tape.list(&mut drawing.curves, &Curve { path: BezPath::new(), line: None }, &mut curve);
    tape.check(drawing.curves.len() <= MAX_CURVES);
    let blank = Fill { path: BezPath::new(), even_odd: false, color: Rgba8([0; 4]) };
    tape.list(&mut drawing.fills, &blank, &mut |tape, fill| {
        path(tape, &mut fill.path);
        fill.even_odd = tape.flag(fill.even_odd);
        tape.bytes(&mut fill.color.0);
    });
}

fn curve(tape: &mut Tape, curve: &mut Curve) {
    path(tape, &mut curve.path);
    let starts = curve.path.iter().filter(|element| matches!(element, PathEl::MoveTo(_))).count();
    tape.check(starts == 1);
    if !tape.flag(curve.line.is_some()) {
        return;
    }
    let mut line = curve.line.take().unwrap_or(Line { stroke: Stroke::default(), color: Rgba8([0; 4]) });
    stroke(tape, &mut line.stroke);
    tape.bytes(&mut line.color.0);
    curve.line = Some(line);
}

fn stroke(tape: &mut Tape, stroke: &mut Stroke) {
    tape.number(&mut stroke.width);
    tape.check(stroke.width > 0.0);
    tape.one_of(&mut stroke.start_cap, &[Cap::Butt, Cap::Square, Cap::Round]);
    tape.one_of(&mut stroke.end_cap, &[Cap::Butt, Cap::Square, Cap::Round]);
    tape.one_of(&mut stroke.join, &[Join::Bevel, Join::Miter, Join::Round]);
    tape.number(&mut stroke.miter_limit);
    let mut dashes = stroke.dash_pattern.to_vec();
    tape.list(&mut dashes, &0.0, &mut Tape::number);
    stroke.dash_pattern = dashes.into();
    tape.number(&mut stroke.dash_offset);
}

fn path(tape: &mut Tape, path: &mut BezPath) {
    let mut elements = path.elements().to_vec();
    let mut is_in_part = false;
    tape.list(&mut elements, &PathEl::ClosePath, &mut |tape, element| {
        path_element(tape, element);
        let is_start = matches!(element, PathEl::MoveTo(_));
        tape.check(is_in_part || is_start);
        is_in_part = !matches!(element, PathEl::ClosePath);
    });
    if matches!(elements.first(), None | Some(PathEl::MoveTo(_))) {
        *path = BezPath::from_vec(elements);
    }
}

/// Points of each kind of path element, in the order of their numbers.
const POINTS: [usize; 5] = [0, 1, 1, 2, 3];

fn path_element(tape: &mut Tape, element: &mut PathEl) {
    let (kind, [mut a, mut b, mut p]) = match *element {
        PathEl::ClosePath => (0, [Point::ZERO; 3]),
        PathEl::MoveTo(p) => (1, [p; 3]),
        PathEl::LineTo(p) => (2, [p; 3]),
        PathEl::QuadTo(b, p) => (3, [p, b, p]),
        PathEl::CurveTo(a, b, p) => (4, [a, b, p]),
    };
    let kind = tape.byte(kind);
    let given = POINTS.get(usize::from(kind)).copied().unwrap_or_default();
    for point in [&mut a, &mut b, &mut p].into_iter().skip(3 - given) {
        self::point(tape, point);
    }
    tape.check(usize::from(kind) < POINTS.len());
    *element = match kind {
        1 => PathEl::MoveTo(p),
        2 => PathEl::LineTo(p),
        3 => PathEl::QuadTo(b, p),
        4 => PathEl::CurveTo(a, b, p),
        _ => PathEl::ClosePath,
    };
}

fn point(tape: &mut Tape, point: &mut Point) {
    tape.number(&mut point.x);
    tape.number(&mut point.y);
}

fn settings(tape: &mut Tape, settings: &mut Settings) {
    tape.one_of(&mut settings.blend, &[Blend::Oklab, Blend::Srgb]);
    tape.one_of(&mut settings.engine, &[EngineKind::Global, EngineKind::Progressive]);
    tape.number(&mut settings.gap_closing);
    settings.spread = tape.flag(settings.spread);
    *settings = settings.clamped();
}

const BLANK_SCRIBBLE: Scribble =
    Scribble { color: Paint::Clear, kind: ScribbleKind::Fill, width_du: 1.0, points: Vec::new() };

fn scribble(tape: &mut Tape, scribble: &mut Scribble) {
    paint(tape, &mut scribble.color);
    let mut shading = scribble.shading().cloned().unwrap_or_default();
    if tape.flag(!scribble.is_fill()) {
        tape.number(&mut shading.strength);
        tape.check((0.0..=1.0).contains(&shading.strength));
        shading.crosses = tape.flag(shading.crosses);
        scribble.kind = ScribbleKind::Shade(shading);
    }
    tape.number(&mut scribble.width_du);
    tape.list(&mut scribble.points, &Point::ZERO, &mut point);
    tape.check(scribble.width_du > 0.0 && !scribble.points.is_empty());
}

fn pressure(tape: &mut Tape, scribble: &mut Scribble) {
    let ScribbleKind::Shade(Shading { pressure, .. }) = &mut scribble.kind else { return };
    let (kind, mut parts) = match mem::take(pressure) {
        PenPressure::Even => (0, Vec::new()),
        PenPressure::Radius(parts) => (1, parts),
        PenPressure::Strength(parts) => (2, parts),
    };
    let kind = tape.byte(kind);
    if kind == 0 {
        return;
    }
    tape.list(&mut parts, &1.0, &mut Tape::number);
    tape.check(kind <= 2 && parts.len() == scribble.points.len());
    tape.check(parts.iter().all(|part| (0.0..=1.0).contains(part)));
    *pressure = if kind == 1 { PenPressure::Radius(parts) } else { PenPressure::Strength(parts) };
}

const BLANK_COLOR_POINT: ColorPoint =
    ColorPoint { curve: 0, is_left: false, at_du: 0.0, color: Paint::Clear };

fn color_point(tape: &mut Tape, point: &mut ColorPoint) {
    point.curve = tape.int(point.curve.into()) as u32;
    point.is_left = tape.flag(point.is_left);
    tape.number(&mut point.at_du);
    paint(tape, &mut point.color);
}

fn paint(tape: &mut Tape, paint: &mut Paint) {
    let mut rgb = if let Paint::Color(Srgb8(rgb)) = *paint { rgb } else { [0; 3] };
    let is_color = tape.flag(*paint != Paint::Clear);
    if is_color {
        tape.bytes(&mut rgb);
    }
    *paint = if is_color { Paint::Color(Srgb8(rgb)) } else { Paint::Clear };
}

fn tracing(tape: &mut Tape, tracing: &mut Option<Tracing>) {
    if !tape.flag(tracing.is_some()) {
        return;
    }
    let Tracing { mut image, mut opacity } = tracing.unwrap_or(Tracing::faded(0));
    image = tape.int(image.into()) as u32;
    tape.number(&mut opacity);
    *tracing = Some(Tracing { image, opacity }.clamped());
}

fn unknown(tape: &mut Tape, unknown: &mut Unknown) {
    unknown.minor = tape.int(unknown.minor.into()) as u32;
    for fields in &mut unknown.fields {
        tape.list(fields, &(0, String::new()), &mut |tape, (index, text)| {
            *index = tape.int((*index).into()) as u32;
            tape.text(text);
        });
        tape.check(fields.is_sorted_by(|a, b| a.0 < b.0));
    }
}
