//! The lists of a file as they are read: swatches, curves, solid ink, scribbles, colours set by hand.

use kurbo::{BezPath, Cap, PathEl, Point, Stroke};
use scumble_core::work::{Item, MAX_CURVES, Unknown, Work};
use scumble_core::{
    ColorPoint, Curve, Fill, Line, Paint, Rgba8, Scribble, ScribbleKind, Shading, Srgb8, Swatch,
};

use super::names::{CAPS, JOINS, KINDS, RULES, SIDES, plain_stroke};
use super::pressures;
use super::swatch_names::{name_swatches, read_names};
use crate::json::{Fault, Json, Member};

/// Swatches that may have names.
const MAX_SWATCHES: usize = 1_000_000;

/// What is expected behind as many curves as there may be.
pub(super) const NO_MORE_CURVES: &str = "no more curves";

/// The lists as they are read.
#[derive(Debug, Default)]
pub(super) struct Items {
    palette: Vec<Swatch>,
    swatch_names: Vec<String>,
    curves: Vec<Curve>,
    fills: Vec<Fill>,
    scribbles: Vec<Scribble>,
    color_points: Vec<ColorPoint>,
}

impl Items {
    pub(super) fn into_work(self, mut work: Work) -> Work {
        let document = &mut work.document;
        (document.palette, document.color_points) = (self.palette, self.color_points);
        name_swatches(&mut document.palette, self.swatch_names);
        document.scribbles = self.scribbles;
        (document.drawing.curves, document.drawing.fills) = (self.curves, self.fills);
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
            "palette" => json.items(&mut |json| paint(json).map(|paint| self.palette.push(paint.into()))),
            "swatch_names" => read_names(json, MAX_SWATCHES).map(|names| self.swatch_names = names),
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
    let (mut is_shade, mut shading) = (false, Shading::default());
    json.members(&mut |json, member| {
        match &*member.name {
            "color" => color = Some(paint(json)?),
            "width" => width_du = Some(positive(json)?),
            "kind" => is_shade = named(json, &KINDS)?,
            "strength" => shading.strength = strength(json)?,
            "crosses" => shading.crosses = json.boolean()?,
            "points" => json.items(&mut |json| json.numbers().map(|[x, y]| points.push(Point::new(x, y))))?,
            name => match pressures::read(name, json)? {
                Some(pressure) => pressures::take_first(&mut shading.pressure, pressure),
                None => keeper.keep(json, &member)?,
            },
        }
        Ok(())
    })?;
    if !pressures::is_whole(&shading.pressure, points.len()) {
        return json.fault("as many radii or strengths as points in the scribble before this");
    }
    let kind = if is_shade { ScribbleKind::Shade(shading) } else { ScribbleKind::Fill };
    match (color, width_du) {
        (Some(color), Some(width_du)) if !points.is_empty() => Ok(Scribble { color, kind, width_du, points }),
        _ => json.fault("color, width and points in the scribble before this"),
    }
}

fn strength(json: &mut Json) -> Result<f64, Fault> {
    let strength = json.number()?;
    if (0.0..=1.0).contains(&strength) {
        Ok(strength)
    } else {
        json.fault("a strength from 0 to 1 before this")
    }
}

fn color_point(json: &mut Json, mut keeper: Keeper) -> Result<ColorPoint, Fault> {
    let mut point = ColorPoint { curve: 0, is_left: true, at_du: 0.0, color: Paint::Clear };
    json.members(&mut |json, member| {
        match &*member.name {
            "curve" => point.curve = curve_number(json)?,
            "side" => point.is_left = named(json, &SIDES)?,
            "at" => point.at_du = json.number()?,
            "color" => point.color = paint(json)?,
            _ => keeper.keep(json, &member)?,
        }
        Ok(())
    })?;
    Ok(point)
}

fn curve_number(json: &mut Json) -> Result<u32, Fault> {
    let number = json.number()?;
    if number >= 0.0 && number.fract() == 0.0 {
        Ok(number as u32)
    } else {
        json.fault("a curve's place, counted from 0, before this")
    }
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
            return json.fault("a path of M, L, Q, C and Z in capitals before this");
        };
        path.push(element);
    }
    Ok(BezPath::from_vec(path))
}

fn coordinate(text: &str) -> Option<f64> {
    text.parse().ok().filter(|number: &f64| number.abs() <= 1e9)
}

/// One of a few names.
pub(super) fn named<T: Copy>(json: &mut Json, names: &[(&str, T)]) -> Result<T, Fault> {
    let name = json.string()?;
    match names.iter().find(|(known, _)| *known == name) {
        Some((_, value)) => Ok(*value),
        None => {
            json.fault("a name that this version knows before this; update it to open what a newer one saved")
        }
    }
}

/// Keeps a field that is not known.
pub(super) fn keep(
    json: &mut Json,
    member: &Member,
    unknown: &mut Unknown,
    item: Item,
    index: usize,
) -> Result<(), Fault> {
    json.skip()?;
    unknown.keep(item, index, json.source(member));
    Ok(())
}
