//! Palettes of other programs: GIMP's (`.gpl`), Adobe Swatch Exchange (`.ase`), and lists of hexadecimal colours (`.hex`).
//!
//! Colours and their names are read: groups and columns have no place in a drawing's palette.

use scumble_core::{Paint, Srgb8, Swatch};

use crate::MAX_FILE_BYTES;
use crate::error::PaletteError;

mod ase;
mod gpl;
mod hex;

/// Most colours of a palette.
const MAX_COLORS: usize = 1000;

/// What is left of a longer name.
const MAX_NAME_CHARS: usize = 80;

/// A form that palettes have in files.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PaletteKind {
    /// GIMP's.
    Gpl,
    /// Adobe Swatch Exchange.
    Ase,
    /// A colour in hexadecimal digits on each line.
    Hex,
}

impl PaletteKind {
    /// The kind of files with an extension in lower case.
    pub fn of_extension(extension: &str) -> Option<Self> {
        match extension {
            "gpl" => Some(Self::Gpl),
            "ase" => Some(Self::Ase),
            "hex" => Some(Self::Hex),
            _ => None,
        }
    }

    /// The kind of a palette's bytes, by their beginning; `None` for what is meant as something else.
    pub fn of_bytes(bytes: &[u8]) -> Option<Self> {
        let text = without_mark(bytes).trim_ascii_start();
        if bytes.starts_with(ase::MARK) {
            Some(Self::Ase)
        } else if text.starts_with(gpl::MARK.as_bytes()) {
            Some(Self::Gpl)
        } else {
            hex::begins(text).then_some(Self::Hex)
        }
    }
}

/// The swatches of a palette, and how many colours were left out since they are of a kind that nobody knows.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ReadPalette {
    /// In their order; at least one. What is called as its colour is written has no name.
    pub swatches: Vec<Swatch>,
    /// How many were left out.
    pub unknown: usize,
}

impl ReadPalette {
    /// What was left out, in one line without a full stop; empty if nothing was.
    pub fn notes(&self) -> String {
        match self.unknown {
            0 => String::new(),
            1 => "left out: 1 colour of an unknown kind".into(),
            count => format!("left out: {count} colours of an unknown kind"),
        }
    }
}

/// Reads a palette of any kind: the one that its beginning tells, or else the one that it is meant as.
///
/// # Errors
/// When the bytes are none, or damaged, or hold no colour or too many.
pub fn read_palette(bytes: &[u8], meant: Option<PaletteKind>) -> Result<ReadPalette, PaletteError> {
    if bytes.len() > MAX_FILE_BYTES {
        return Err(PaletteError::TooLarge);
    }
    let text = || String::from_utf8_lossy(without_mark(bytes));
    let palette = match PaletteKind::of_bytes(bytes).or(meant).ok_or(PaletteError::NoPalette)? {
        PaletteKind::Ase => ase::read(bytes)?,
        PaletteKind::Gpl => gpl::read(&text())?,
        PaletteKind::Hex => hex::read(&text())?,
    };
    match (palette.swatches.len(), palette.unknown) {
        (0, 0) => Err(PaletteError::NoColors),
        (0, count) => Err(PaletteError::NoKnownColors { count }),
        _ => Ok(palette),
    }
}

/// Writes the swatches of a palette. What is no colour is left out.
///
/// # Errors
/// When there is no colour, or more than could be read again.
pub fn write_palette(palette: &[Swatch], kind: PaletteKind) -> Result<Vec<u8>, PaletteError> {
    let named = |swatch: &Swatch| match swatch.color {
        Paint::Color(color) => Some((color, written_name(color, &swatch.name))),
        Paint::Clear => None,
    };
    let colors: Vec<_> = palette.iter().filter_map(named).collect();
    if colors.is_empty() {
        return Err(PaletteError::NoColors);
    }
    if colors.len() > MAX_COLORS {
        return Err(PaletteError::TooManyColors { limit: MAX_COLORS });
    }
    Ok(match kind {
        PaletteKind::Ase => ase::written(&colors),
        PaletteKind::Gpl => gpl::written(&colors).into_bytes(),
        PaletteKind::Hex => hex::written(&colors).into_bytes(),
    })
}

/// Adds a colour that is read, unless there are too many.
fn push(palette: &mut ReadPalette, color: Srgb8, name: &str) -> Result<(), PaletteError> {
    if palette.swatches.len() == MAX_COLORS {
        return Err(PaletteError::TooManyColors { limit: MAX_COLORS });
    }
    palette.swatches.push(Swatch { color: color.into(), name: read_name(color, name) });
    Ok(())
}

/// Names that say nothing: GIMP's, and the colours themselves.
fn read_name(color: Srgb8, name: &str) -> String {
    let spaced = |c: char| if c.is_control() { ' ' } else { c };
    let name: String = name.trim().chars().map(spaced).take(MAX_NAME_CHARS).collect();
    let name = name.trim();
    let says_nothing = name == "Untitled" || name.eq_ignore_ascii_case(&color.to_string());
    if says_nothing { String::new() } else { name.to_owned() }
}

/// In one line; what has no name is called as its colour is written.
fn written_name(color: Srgb8, name: &str) -> String {
    let name = read_name(color, name);
    if name.is_empty() { color.to_string() } else { name }
}

fn without_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes)
}
