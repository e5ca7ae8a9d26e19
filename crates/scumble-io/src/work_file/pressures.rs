//! What a pen's pressure made of a stroke, as a field of its scribble.
//!
//! In a link it is among the fields that a reader need not know: older ones keep it there.

use scumble_core::work::{Item, Work};
use scumble_core::{PenPressure, Scribble, ScribbleKind, Shading};

use super::write::push_numbers;
use super::{PRESSURE_MINOR, VERSION};
use crate::json::{Fault, Json};

/// The names of the fields.
const RADII: &str = "radii";
const STRENGTHS: &str = "strengths";

/// Whether any scribble has the field.
pub(super) fn has_pressures(scribbles: &[Scribble]) -> bool {
    scribbles.iter().any(|scribble| field(scribble).is_some())
}

/// The field of a scribble as a member of an object.
pub(super) fn field(scribble: &Scribble) -> Option<String> {
    let (name, parts) = match &scribble.shading()?.pressure {
        PenPressure::Even => return None,
        PenPressure::Radius(parts) => (RADII, parts),
        PenPressure::Strength(parts) => (STRENGTHS, parts),
    };
    let mut text = ["\"", name, "\": "].concat();
    push_numbers(&mut text, parts);
    Some(text)
}

/// The value of a field of this name, or `None` where the name is another.
pub(super) fn read(name: &str, json: &mut Json) -> Result<Option<PenPressure>, Fault> {
    let pressure = match name {
        RADII => PenPressure::Radius,
        STRENGTHS => PenPressure::Strength,
        _ => return Ok(None),
    };
    let mut parts = Vec::new();
    json.items(&mut |json| {
        let part = json.number()?;
        parts.push(part);
        if (0.0..=1.0).contains(&part) { Ok(()) } else { json.fault("a part from 0 to 1 before this") }
    })?;
    Ok(Some(pressure(parts)))
}

/// Whether there are as many parts as points.
pub(super) fn is_whole(pressure: &PenPressure, point_count: usize) -> bool {
    match pressure {
        PenPressure::Even => true,
        PenPressure::Radius(parts) | PenPressure::Strength(parts) => parts.len() == point_count,
    }
}

/// Puts the fields of all scribbles to those that a reader need not know.
pub(crate) fn put_by(work: &mut Work) {
    let before = std::mem::take(&mut work.unknown.fields[Item::Scribble as usize]);
    let mut before = before.into_iter().peekable();
    for (index, scribble) in work.document.scribbles.iter().enumerate() {
        if let Some(field) = field(scribble) {
            work.unknown.keep(Item::Scribble, index, &field);
            work.unknown.minor = work.unknown.minor.max(PRESSURE_MINOR);
        }
        if let Some((_, text)) = before.next_if(|(place, _)| *place as usize == index) {
            work.unknown.keep(Item::Scribble, index, &text);
        }
    }
}

/// Takes them from there again; `None` where one is damaged.
pub(crate) fn take_up(work: &mut Work) -> Option<()> {
    for (index, text) in std::mem::take(&mut work.unknown.fields[Item::Scribble as usize]) {
        let text = ["{", &text, "}"].concat();
        let mut json = Json::new(&text);
        let members = json.members(&mut |json, member| match read(&member.name, json)? {
            Some(pressure) => press(&mut work.document.scribbles, index, pressure)
                .map_or_else(|| json.fault("as many parts as points"), Ok),
            None => super::items::keep(json, &member, &mut work.unknown, Item::Scribble, index as usize),
        });
        members.ok()?;
    }
    if work.unknown.minor <= VERSION[1] {
        work.unknown.minor = 0;
    }
    Some(())
}

fn press(scribbles: &mut [Scribble], index: u32, given: PenPressure) -> Option<()> {
    let scribble = scribbles.get_mut(index as usize)?;
    let is_whole = is_whole(&given, scribble.points.len());
    if let ScribbleKind::Shade(Shading { pressure, .. }) = &mut scribble.kind {
        *pressure = given;
    }
    is_whole.then_some(())
}
