//! The lists of a file: swatches, curves, solid ink, scribbles, colours set by hand.

use kurbo::{BezPath, Cap, Join, PathEl, Point, Stroke};
use scumble_core::{Curve, Fill, Line, Paint, Rgba8, Scribble, Srgb8};

use crate::json::{Fault, Json, Member, push_number};
use crate::work::{ColorPoint, Item, Unknown, Work};

use super::{MAX_CURVES, PER_UNIT, keep, named, push_unknown};

const CAPS: [(&str, Cap); 3] = [("butt", Cap::Butt), ("round", Cap::Round), ("square", Cap::Square)];

const JOINS: [(&str, Join); 3] = [("miter", Join::Miter), ("round", Join::Round), ("bevel", Join::Bevel)];

const RULES: [(&str, bool); 2] = [("nonzero", false), ("evenodd", true)];

const SIDES: [(&str, bool); 2] = [("left", true), ("right", false)];

/// What is expected behind as many curves as there may be.
pub(super) const NO_MORE_CURVES: &str = "no more curves";

/// What a line is where nothing else is said, as in SVG.
fn plain_stroke() -> Stroke {
    Stroke::new(1.0).with_caps(Cap::Butt).with_join(Join::Miter).with_miter_limit(4.0)
}

pub(super) fn push_all(text: &mut String, work: &Work) {
    let drawing = &work.document.drawing;
    push_list(text, "palette", work.palette.len(), &mut |text, i| push_paint(text, work.palette[i]));
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
    push_list(text, "scribbles", work.document.scribbles.len(), &mut |text, i| {
        push_scribble(text, &work.document.scribbles[i]);
        push_unknown(text, ", ", work.unknown.of(Item::Scribble, i));
        text.push('}');
    });
    push_list(text, "color_points", work.color_points.len(), &mut |text, i| {
        push_color_point(text, &work.color_points[i]);
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
    text.push_str(", \"points\": [");
    for (i, point) in scribble.points.iter().enumerate() {
        text.push_str(if i > 0 { ", " } else { "" });
        push_numbers(text, &[point.x, point.y]);
    }
    text.push(']');
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

fn push_length(text: &mut String, name: &str, length: f64) {
    text.extend([", \"", name, "\": "]);
    push_number(text, length, PER_UNIT);
}

fn push_numbers(text: &mut String, numbers: &[f64]) {
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

fn name<T: PartialEq + Copy, const N: usize>(names: &[(&'static str, T); N], value: T) -> &'static str {
    names.iter().find(|(_, known)| *known == value).map_or("", |(name, _)| name)
}

/// The lists as they are read.
#[derive(Debug, Default)]
pub(super) struct Items {
    palette: Vec<Paint>,
    curves: Vec<Curve>,
    fills: Vec<Fill>,
    scribbles: Vec<Scribble>,
    color_points: Vec<ColorPoint>,
}

impl Items {
    pub(super) fn into_work(self, mut work: Work) -> Work {
        (work.palette, work.color_points) = (self.palette, self.color_points);
        work.document.scribbles = self.scribbles;
        (work.document.drawing.curves, work.document.drawing.fills) = (self.curves, self.fills);
        work
    }

    /// Reads a list, or keeps what is none of them.
    pub(super) fn member(
        &mut self,
        json: &mut Json,
        member: &Member,
        unknown: &mut Unknown,
    ) -> Result<(), Fault> {
        match &*member.name {
            "palette" => json.items(&mut |json| paint(json).map(|paint| self.palette.push(paint))),
            "curves" => json.items(&mut |json| {
                if self.curves.len() == MAX_CURVES {
                    return json.fault(NO_MORE_CURVES);
                }
                let item = Keeper { unknown, item: Item::Curve, index: self.curves.len() };
                curve(json, item).map(|curve| self.curves.push(curve))
            }),
            "fills" => json.items(&mut |json| {
                let item = Keeper { unknown, item: Item::Fill, index: self.fills.len() };
                fill(json, item).map(|fill| self.fills.push(fill))
            }),
            "scribbles" => json.items(&mut |json| {
                let item = Keeper { unknown, item: Item::Scribble, index: self.scribbles.len() };
                scribble(json, item).map(|scribble| self.scribbles.push(scribble))
            }),
            "color_points" => json.items(&mut |json| {
                let item = Keeper { unknown, item: Item::ColorPoint, index: self.color_points.len() };
                color_point(json, item).map(|point| self.color_points.push(point))
            }),
            _ => keep(json, member, unknown, Item::Work, 0),
        }
    }
}

/// Keeps the unknown fields of one item.
struct Keeper<'a> {
    unknown: &'a mut Unknown,
    item: Item,
    index: usize,
}

impl Keeper<'_> {
    fn keep(&mut self, json: &mut Json, member: &Member) -> Result<(), Fault> {
        keep(json, member, self.unknown, self.item, self.index)
    }
}

fn curve(json: &mut Json, mut keeper: Keeper) -> Result<Curve, Fault> {
    let (mut path, mut width, mut color, mut stroke) = (None, None, Rgba8([0, 0, 0, 255]), plain_stroke());
    json.members(&mut |json, member| {
        match &*member.name {
            "path" => path = Some(one_path(json)?),
            "width" => width = Some(positive(json)?),
            "color" => color = rgba(json)?,
            "caps" => [stroke.start_cap, stroke.end_cap] = caps(json)?,
            "join" => stroke.join = named(json, &JOINS)?,
            "miter_limit" => stroke.miter_limit = json.number()?,
            "dashes" => json.items(&mut |json| json.number().map(|dash| stroke.dash_pattern.push(dash)))?,
            "dash_offset" => stroke.dash_offset = json.number()?,
            _ => keeper.keep(json, &member)?,
        }
        Ok(())
    })?;
    let line = width.map(|width| Line { stroke: Stroke { width, ..stroke }, color });
    match path {
        Some(path) => Ok(Curve { path, line }),
        None => json.fault("a path in the curve before this"),
    }
}

fn caps(json: &mut Json) -> Result<[Cap; 2], Fault> {
    let (mut caps, mut count) = ([Cap::Butt; 2], 0);
    json.items(&mut |json| {
        let Some(place) = caps.get_mut(count) else { return json.fault("two caps") };
        *place = named(json, &CAPS)?;
        count += 1;
        Ok(())
    })?;
    if count == 2 { Ok(caps) } else { json.fault("two caps before this") }
}

fn fill(json: &mut Json, mut keeper: Keeper) -> Result<Fill, Fault> {
    let (mut path, mut even_odd, mut color) = (None, false, Rgba8([0, 0, 0, 255]));
    json.members(&mut |json, member| {
        match &*member.name {
            "path" => path = Some(read_path(json)?),
            "rule" => even_odd = named(json, &RULES)?,
            "color" => color = rgba(json)?,
            _ => keeper.keep(json, &member)?,
        }
        Ok(())
    })?;
    match path {
        Some(path) => Ok(Fill { path, even_odd, color }),
        None => json.fault("a path in the fill before this"),
    }
}

fn scribble(json: &mut Json, mut keeper: Keeper) -> Result<Scribble, Fault> {
    let (mut color, mut width_du, mut points) = (None, None, Vec::new());
    json.members(&mut |json, member| {
        match &*member.name {
            "color" => color = Some(paint(json)?),
            "width" => width_du = Some(positive(json)?),
            "points" => json.items(&mut |json| json.numbers().map(|[x, y]| points.push(Point::new(x, y))))?,
            _ => keeper.keep(json, &member)?,
        }
        Ok(())
    })?;
    match (color, width_du) {
        (Some(color), Some(width_du)) if !points.is_empty() => Ok(Scribble { color, width_du, points }),
        _ => json.fault("color, width and points in the scribble before this"),
    }
}

fn color_point(json: &mut Json, mut keeper: Keeper) -> Result<ColorPoint, Fault> {
    let mut point = ColorPoint { curve: 0, is_left: true, at_du: 0.0, color: Paint::Clear };
    json.members(&mut |json, member| {
        match &*member.name {
            "curve" => point.curve = json.number()? as u32,
            "side" => point.is_left = named(json, &SIDES)?,
            "at" => point.at_du = json.number()?,
            "color" => point.color = paint(json)?,
            _ => keeper.keep(json, &member)?,
        }
        Ok(())
    })?;
    Ok(point)
}

fn positive(json: &mut Json) -> Result<f64, Fault> {
    let number = json.number()?;
    if number > 0.0 { Ok(number) } else { json.fault("a width above zero before this") }
}

fn paint(json: &mut Json) -> Result<Paint, Fault> {
    let text = json.string()?;
    text.parse().or_else(|_| json.fault("a colour #rrggbb or none before this"))
}

fn rgba(json: &mut Json) -> Result<Rgba8, Fault> {
    let text = json.string()?;
    let is_long = text.len() == 9 && text.is_ascii();
    let (rgb, alpha) = text.split_at(if is_long { 7 } else { text.len() });
    let alpha = if is_long { hex(alpha) } else { Some(255) };
    match (rgb.parse(), alpha) {
        (Ok(Srgb8([r, g, b])), Some(alpha)) => Ok(Rgba8([r, g, b, alpha])),
        _ => json.fault("a colour #rrggbb or #rrggbbaa before this"),
    }
}

fn hex(text: &str) -> Option<u8> {
    text.chars().try_fold(0, |value, digit| Some(value << 4 | digit.to_digit(16)? as u8))
}

fn one_path(json: &mut Json) -> Result<BezPath, Fault> {
    let path = read_path(json)?;
    let starts = path.iter().filter(|element| matches!(element, PathEl::MoveTo(_))).count();
    if starts == 1 { Ok(path) } else { json.fault("one path for each curve before this") }
}

/// `M x y`, then `L x y` and `C x y x y x y`, and maybe `Z`; again for further parts.
fn read_path(json: &mut Json) -> Result<BezPath, Fault> {
    let text = json.string()?;
    let mut words = text.split_ascii_whitespace();
    let mut path = Vec::new();
    while let Some(command) = words.next() {
        let is_in_part = !matches!(path.last(), None | Some(PathEl::ClosePath));
        let mut point = || Some(Point::new(coordinate(words.next()?)?, coordinate(words.next()?)?));
        let element = match command {
            "M" => point().map(PathEl::MoveTo),
            "L" if is_in_part => point().map(PathEl::LineTo),
            "Q" if is_in_part => point().zip(point()).map(|(a, p)| PathEl::QuadTo(a, p)),
            "C" if is_in_part => {
                point().zip(point()).zip(point()).map(|((a, b), p)| PathEl::CurveTo(a, b, p))
            }
            "Z" if is_in_part => Some(PathEl::ClosePath),
            _ => None,
        };
        let Some(element) = element else {
            return json.fault("a path of M, L, C and Z in capitals before this");
        };
        path.push(element);
    }
    Ok(BezPath::from_vec(path))
}

fn coordinate(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.abs() <= 1e9)
}
