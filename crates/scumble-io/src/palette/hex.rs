//! Colours in hexadecimal digits, `rrggbb` or `rgb`, with `#` before them or without, apart by spaces, commas or lines.
//! What comes after `;` or `//` on a line is a remark.

use scumble_core::Srgb8;

use super::{ReadPalette, push};
use crate::error::PaletteError;

/// Whether a text begins as such a list, with a line of colours alone: three digits without `#` may be any word, six are hardly
/// one. All files are asked: of what is none, however large, only the beginning is read.
pub(super) fn begins(text: &[u8]) -> bool {
    let mut lines = text.split(|byte| *byte == b'\n').map(String::from_utf8_lossy);
    let is_meant = |word: &str| word.starts_with('#') || word.len() == 6;
    let first = lines.find(|line| words(line).next().is_some()).unwrap_or_default();
    words(&first).next().is_some_and(is_meant) && words(&first).all(|word| color(word).is_some())
}

pub(super) fn read(text: &str) -> Result<ReadPalette, PaletteError> {
    let mut palette = ReadPalette::default();
    for (line, number) in text.lines().zip(1..) {
        for word in words(line) {
            let color =
                color(word).ok_or(PaletteError::Damaged { line: number, expected: "a colour #rrggbb" })?;
            push(&mut palette, color, "")?;
        }
    }
    Ok(palette)
}

fn words(line: &str) -> impl Iterator<Item = &str> {
    let end = [line.find(';'), line.find("//")].into_iter().flatten().min().unwrap_or(line.len());
    line[..end].split(|c: char| c.is_whitespace() || c == ',').filter(|word| !word.is_empty())
}

fn color(word: &str) -> Option<Srgb8> {
    let digits: Option<Vec<u8>> = word
        .strip_prefix('#')
        .unwrap_or(word)
        .chars()
        .take(7)
        .map(|digit| digit.to_digit(16).map(|digit| digit as u8))
        .collect();
    match digits?[..] {
        [a, b, c, d, e, f] => Some(Srgb8([16 * a + b, 16 * c + d, 16 * e + f])),
        [r, g, b] => Some(Srgb8([17 * r, 17 * g, 17 * b])),
        _ => None,
    }
}

/// Without `#`, as most programs that read such lists expect.
pub(super) fn written(colors: &[(Srgb8, String)]) -> String {
    colors.iter().map(|(color, _)| [color.to_string().trim_start_matches('#'), "\n"].concat()).collect()
}
