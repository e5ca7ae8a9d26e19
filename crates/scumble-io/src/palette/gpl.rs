//! GIMP's palettes: a head, then three numbers from 0 to 255 and a name on each line.

use scumble_core::Srgb8;

use super::{ReadPalette, push};
use crate::error::PaletteError;

/// The first line.
pub(super) const MARK: &str = "GIMP Palette";

pub(super) fn read(text: &str) -> Result<ReadPalette, PaletteError> {
    let mut palette = ReadPalette::default();
    let mut lines = text.lines().zip(1..).skip_while(|(line, _)| line.trim().is_empty());
    if let Some((_, number)) = lines.next().filter(|(line, _)| !line.trim_start().starts_with(MARK)) {
        return Err(PaletteError::Damaged { line: number, expected: "“GIMP Palette”" });
    }
    let has_alpha = text.lines().any(is_alpha_told);
    for (line, number) in lines.filter(|(line, _)| !is_head(line)) {
        let (color, name) = color(line, has_alpha)
            .ok_or(PaletteError::Damaged { line: number, expected: "three numbers from 0 to 255" })?;
        push(&mut palette, color, name)?;
    }
    Ok(palette)
}

/// Whether a line is no colour: the palette's name, how it is laid out, a remark, or nothing.
fn is_head(line: &str) -> bool {
    let line = line.trim();
    line.is_empty() || ["#", "Name:", "Columns:", "Channels:"].iter().any(|head| line.starts_with(head))
}

/// Whether a line of the head says that colours have a fourth number, their opacity.
fn is_alpha_told(line: &str) -> bool {
    line.trim().strip_prefix("Channels:").is_some_and(|channels| channels.trim() == "RGBA")
}

/// A colour, and what comes behind it and its opacity.
fn color(line: &str, has_alpha: bool) -> Option<(Srgb8, &str)> {
    let mut rest = line;
    let mut channel = || {
        let (word, behind) =
            rest.trim_start().split_once(char::is_whitespace).unwrap_or((rest.trim_start(), ""));
        rest = behind;
        word.parse().ok()
    };
    let color = Srgb8([channel()?, channel()?, channel()?]);
    if has_alpha {
        channel();
    }
    Some((color, rest))
}

pub(super) fn written(colors: &[(Srgb8, String)]) -> String {
    let mut text = [MARK, "\nName: Scumble\n#\n"].concat();
    for (color, name) in colors {
        let [r, g, b] = color.0;
        text.push_str(&format!("{r:3} {g:3} {b:3}\t{name}\n"));
    }
    text
}
