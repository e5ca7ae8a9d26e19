//! How large a page is where it is printed or laid out: the width and height of its SVG, with their units.
//!
//! The units are kept, as not all programs take the same number of pixels for a millimetre. Nothing that edits a drawing needs
//! to know of it, so work has it among the fields that are not known.

use kurbo::Rect;
use roxmltree::Document;
use scumble_core::Work;
use scumble_core::work::Item;
use svgtypes::{Length, LengthUnit};

use crate::json::{Fault, Json};

/// The name of its field.
const FIELD: &str = "size";

/// Sides, in pixels of 1/96 inch: about as far as PDF goes.
const SIDES_PX: std::ops::RangeInclusive<f64> = 1.0..=16384.0;

/// How much longer a side may be than the page's proportions say, in parts of it: sides are often rounded to whole units.
const MOST_OFF: f64 = 2e-3;

/// The units with a length of their own, in pixels.
const UNITS: [(LengthUnit, &str, f64); 7] = [
    (LengthUnit::None, "", 1.0),
    (LengthUnit::Px, "px", 1.0),
    (LengthUnit::Pt, "pt", 96.0 / 72.0),
    (LengthUnit::Pc, "pc", 16.0),
    (LengthUnit::Mm, "mm", 96.0 / 25.4),
    (LengthUnit::Cm, "cm", 96.0 / 2.54),
    (LengthUnit::In, "in", 96.0),
];

/// The width and height of a page, with their units.
#[derive(Clone, Debug, PartialEq)]
pub struct PageSize {
    /// As SVG writes them.
    pub sides: [String; 2],
    /// In pixels of 1/96 inch, 1 to 16384 each.
    pub sides_px: [f64; 2],
}

impl PageSize {
    /// The size that the page of some work has, if it came with one.
    pub fn of(work: &Work) -> Option<Self> {
        let text = ["{", work.unknown.of(Item::Work, 0), "}"].concat();
        let mut sides = None;
        // What a hostile file has here is no size.
        let read = Json::new(&text).members(&mut |json, member| {
            if member.name == FIELD { read_sides(json).map(|read| sides = read) } else { json.skip() }
        });
        read.ok()?;
        let [width, height] = sides?;
        Self::new([&width, &height], work.document.drawing.page)
    }

    /// The size of an SVG with a page; `None` where it is not said, or shows more than the page.
    pub(crate) fn of_svg(xml: &Document, page: Rect) -> Option<Self> {
        let side = |name| xml.root_element().attribute(name);
        Self::new([side("width")?, side("height")?], page)
    }

    fn new(texts: [&str; 2], page: Rect) -> Option<Self> {
        let [width, height] = texts.map(side);
        let [(width, width_px), (height, height_px)] = [width?, height?];
        let off = (width_px * page.height()) / (height_px * page.width()) - 1.0;
        (off.abs() <= MOST_OFF).then_some(Self { sides: [width, height], sides_px: [width_px, height_px] })
    }

    /// Gives some work this size.
    pub(crate) fn keep_in(&self, work: &mut Work) {
        let [width, height] = &self.sides;
        let field = ["\"", FIELD, "\": [\"", width, "\", \"", height, "\"]"].concat();
        work.unknown.keep(Item::Work, 0, &field);
    }

    /// The longer side in whole pixels.
    pub fn longer_px(&self) -> u32 {
        self.sides_px[0].max(self.sides_px[1]).round() as u32
    }
}

/// Two texts; `None` where there are less or more.
fn read_sides(json: &mut Json) -> Result<Option<[String; 2]>, Fault> {
    let mut sides = Vec::new();
    json.items(&mut |json| {
        sides.push(json.string()?.into_owned());
        Ok(())
    })?;
    Ok(sides.try_into().ok())
}

/// A side as SVG writes it, and in pixels.
fn side(text: &str) -> Option<(String, f64)> {
    length(text).filter(|(_, side_px)| SIDES_PX.contains(side_px))
}

/// A length as SVG writes it, and in pixels of 1/96 inch; `None` where it has no unit with a length of its own.
pub(crate) fn length(text: &str) -> Option<(String, f64)> {
    let Length { number, unit } = text.trim().parse().ok()?;
    let (_, name, unit_px) = UNITS.iter().find(|(known, ..)| *known == unit)?;
    Some((format!("{number}{name}"), number * unit_px))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn size(width: &str, height: &str) -> Option<PageSize> {
        PageSize::new([width, height], Rect::new(10.0, 10.0, 30.0, 20.0))
    }

    #[test]
    fn sides_keep_their_units() {
        for (width, height, sides, sides_px) in [
            ("200", " 100 ", ["200", "100"], [200.0, 100.0]),
            ("50.8mm", "2.54cm", ["50.8mm", "2.54cm"], [192.0, 96.0]),
            ("3in", "108pt", ["3in", "108pt"], [288.0, 144.0]),
            ("6pc", "4.8e1px", ["6pc", "48px"], [96.0, 48.0]),
            ("201", "100.4", ["201", "100.4"], [201.0, 100.4]),
        ] {
            let PageSize { sides: found, sides_px: found_px } = size(width, height).expect(width);
            assert_eq!(found, sides);
            assert!((0..2).all(|i| (found_px[i] - sides_px[i]).abs() < 1e-9), "{found_px:?}");
        }
    }

    #[test]
    fn what_is_no_size_of_the_page_is_none() {
        for (width, height) in [
            ("100%", "100%"),
            ("20em", "10em"),
            ("20q", "10q"),
            ("", ""),
            ("0.9", "0.45"),
            ("32768", "16384"),
            ("-20", "-10"),
            ("1e999", "1e999"),
            ("20", "20"),
            ("201", "100"),
            ("20\"", "10"),
        ] {
            assert_eq!(size(width, height), None, "{width} {height}");
        }
    }
}
