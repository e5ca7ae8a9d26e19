//! Fields that came after version 1.0, in a link: there they are among those that a reader need not know. Older ones keep
//! them as such.

use std::mem;

use scumble_core::Document;
use scumble_core::work::{Item, Work};

use super::items::keep;
use super::pressures::{self, RADII, STRENGTHS};
use super::swatch_names::{are_named, name_swatches, push_names, read_names};
use super::{NAMES_MINOR, PRESSURE_MINOR, SIZE_MINOR, VERSION};
use crate::json::{Fault, Json, Member};
use crate::page_size::PageSize;

/// The other fields that the schema has, for each kind of item; but for the page's size, which stays among those that are not
/// known.
const KNOWN: [&[&str]; Item::KINDS] = [
    &[
        "format",
        "version",
        "sample",
        "canvas",
        "settings",
        "palette",
        "curves",
        "fills",
        "scribbles",
        "color_points",
        "tracing_image",
        "tracing_opacity",
    ],
    &["blend", "engine", "gap_closing", "spread"],
    &["path", "width", "color", "caps", "join", "miter_limit", "dashes", "dash_offset"],
    &["path", "rule", "color"],
    &["color", "width", "kind", "strength", "crosses", "points"],
    &["curve", "side", "at", "color"],
];

/// The same work with these fields among those that are not known.
pub(crate) fn put_by(work: &Work) -> Work {
    let mut work = work.clone();
    put_pressures_by(&mut work);
    if are_named(&work.document.palette) {
        let mut field = String::new();
        push_names(&mut field, &work.document.palette);
        work.unknown.keep(Item::Work, 0, &field);
        work.unknown.minor = work.unknown.minor.max(NAMES_MINOR);
    }
    if PageSize::of(&work).is_some() {
        work.unknown.minor = work.unknown.minor.max(SIZE_MINOR);
    }
    work
}

fn put_pressures_by(work: &mut Work) {
    let before = mem::take(&mut work.unknown.fields[Item::Scribble as usize]);
    let mut before = before.into_iter().peekable();
    for (index, scribble) in work.document.scribbles.iter().enumerate() {
        if let Some(field) = pressures::field(scribble) {
            work.unknown.keep(Item::Scribble, index, &field);
            work.unknown.minor = work.unknown.minor.max(PRESSURE_MINOR);
        }
        if let Some((_, text)) = before.next_if(|(place, _)| *place as usize == index) {
            work.unknown.keep(Item::Scribble, index, &text);
        }
    }
}

/// Takes them from there again; `None` where something is damaged. What else has the name of a known field is left out: a file
/// would be read as if it were that field.
pub(crate) fn take_up(work: &mut Work) -> Option<()> {
    let fields = mem::take(&mut work.unknown.fields);
    for (item, fields) in Item::ALL.into_iter().zip(fields) {
        fields.iter().try_for_each(|(index, text)| take_members(work, item, *index as usize, text))?;
    }
    // Of fields that it has, nobody needs to be told again.
    if work.unknown.minor <= VERSION[1] {
        work.unknown.minor = 0;
    }
    Some(())
}

fn take_members(work: &mut Work, item: Item, index: usize, text: &str) -> Option<()> {
    let text = ["{", text, "}"].concat();
    let mut json = Json::within(&text, depth(item));
    json.members(&mut |json, member| take_member(work, item, index, json, &member)).ok()?;
    json.end().ok()
}

fn take_member(
    work: &mut Work,
    item: Item,
    index: usize,
    json: &mut Json,
    member: &Member,
) -> Result<(), Fault> {
    let Document { scribbles, palette, .. } = &mut work.document;
    match (item, &*member.name) {
        (Item::Work, "swatch_names") => {
            read_names(json, palette.len()).map(|names| name_swatches(palette, names))
        }
        (Item::Scribble, name @ (RADII | STRENGTHS)) => {
            pressures::press(json, name, scribbles.get_mut(index))
        }
        (_, name) if KNOWN[item as usize].contains(&name) => json.skip(),
        _ => keep(json, member, &mut work.unknown, item, index),
    }
}

/// How deep an item lies in a file.
fn depth(item: Item) -> u32 {
    match item {
        Item::Work => 0,
        Item::Settings => 1,
        Item::Curve | Item::Fill | Item::Scribble | Item::ColorPoint => 2,
    }
}
