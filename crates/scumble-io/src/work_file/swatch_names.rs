//! Names of swatches, which are a field of their own: what reads version 1.0 keeps them as a field that it does not know.
//! In a link they are written as one for the same reason.

use scumble_core::Swatch;
use scumble_core::work::{Item, Work};

use super::items::keep;
use super::{NAMES_MINOR, VERSION};
use crate::json::{Fault, Json, push_string};
use crate::page_size::{self, PageSize};

pub(super) fn are_named(palette: &[Swatch]) -> bool {
    palette.iter().any(|swatch| !swatch.name.is_empty())
}

/// The field: a name for each swatch.
pub(super) fn push_names(text: &mut String, palette: &[Swatch]) {
    text.push_str("\"swatch_names\": [");
    for (i, swatch) in palette.iter().enumerate() {
        text.push_str(if i > 0 { ", " } else { "" });
        push_string(text, &swatch.name);
    }
    text.push(']');
}

/// As many names as there may be of use.
pub(super) fn read_names(json: &mut Json, limit: usize) -> Result<Vec<String>, Fault> {
    let mut names = Vec::new();
    json.items(&mut |json| {
        let name = json.string()?;
        if names.len() < limit {
            names.push(name.into_owned());
        }
        Ok(())
    })?;
    Ok(names)
}

/// Gives swatches their names, as many as there are of both.
pub(super) fn name_swatches(palette: &mut [Swatch], names: Vec<String>) {
    for (swatch, name) in palette.iter_mut().zip(names) {
        swatch.name = name;
    }
}

/// The same work with the names of its swatches among the fields that are not known.
pub(crate) fn with_names_as_unknown(work: &Work) -> Work {
    let mut work = work.clone();
    if are_named(&work.document.palette) {
        let mut field = String::new();
        push_names(&mut field, &work.document.palette);
        work.unknown.keep(Item::Work, 0, &field);
        work.unknown.minor = work.unknown.minor.max(NAMES_MINOR);
    }
    if PageSize::of(&work).is_some() {
        work.unknown.minor = work.unknown.minor.max(page_size::MINOR);
    }
    work
}

/// Takes names of swatches out of the fields that are not known; `None` where they are damaged.
pub(crate) fn take_names(work: &mut Work) -> Option<()> {
    let text = ["{", work.unknown.of(Item::Work, 0), "}"].concat();
    let limit = work.document.palette.len();
    let mut names = Vec::new();
    let unknown = &mut work.unknown;
    unknown.fields[Item::Work as usize].clear();
    let mut json = Json::new(&text);
    let read = json.members(&mut |json, member| match &*member.name {
        "swatch_names" => read_names(json, limit).map(|read| names = read),
        _ => keep(json, &member, unknown, Item::Work, 0),
    });
    read.ok()?;
    // Of fields that it has, nobody needs to be told again.
    unknown.minor = if unknown.minor > VERSION[1] { unknown.minor } else { 0 };
    name_swatches(&mut work.document.palette, names);
    Some(())
}
