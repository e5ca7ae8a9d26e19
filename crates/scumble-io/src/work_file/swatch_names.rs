//! Names of swatches, which are a field of their own: what reads version 1.0 keeps them as a field that it does not know.

use std::iter;

use scumble_core::Swatch;

use crate::json::{Fault, Json, push_string};

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

/// Gives swatches their names; none to those for which there are too few.
pub(super) fn name_swatches(palette: &mut [Swatch], names: Vec<String>) {
    for (swatch, name) in palette.iter_mut().zip(names.into_iter().chain(iter::repeat_with(String::new))) {
        swatch.name = name;
    }
}
