//! What a pen's pressure made of a stroke, as a field of its scribble.

use scumble_core::{PenPressure, Scribble, ScribbleKind, Shading};

use super::write::push_numbers;
use crate::json::{Fault, Json};

/// The names of the fields.
pub(super) const RADII: &str = "radii";
pub(super) const STRENGTHS: &str = "strengths";

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

/// Reads a field of this name into its scribble, where there is one that shades.
pub(super) fn press(json: &mut Json, name: &str, scribble: Option<&mut Scribble>) -> Result<(), Fault> {
    let given = read(name, json)?.unwrap_or_default();
    let Some(scribble) = scribble.filter(|scribble| is_whole(&given, scribble.points.len())) else {
        return json.fault("as many parts as points");
    };
    if let ScribbleKind::Shade(Shading { pressure, .. }) = &mut scribble.kind {
        take_first(pressure, given);
    }
    Ok(())
}

/// Of several fields the first one counts: what a page of an older version kept as unknown comes behind what was made since.
pub(super) fn take_first(pressure: &mut PenPressure, given: PenPressure) {
    if *pressure == PenPressure::Even {
        *pressure = given;
    }
}
