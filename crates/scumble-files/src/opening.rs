//! What is opened, without a browser.

use scumble_core::{Srgb8, Work, exact as exact_bytes};
use scumble_io::{
    FileError, ImportError, LinkError, PaletteError, PaletteKind, import_drawing, read_file, read_palette,
};
use thiserror::Error;

/// What a file holds.
#[derive(Clone, Debug)]
pub enum Content {
    /// Work, and what was left out of it, in words.
    Work(Box<Work>, String),
    /// Colours for the palette of a drawing, and what was left out of them.
    Palette(Vec<Srgb8>, String),
}

/// Why something cannot be opened, or kept.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum OpenError {
    /// Meant as a drawing of another program.
    #[error(transparent)]
    Drawing(#[from] ImportError),
    /// Meant as a file of ours.
    #[error(transparent)]
    File(#[from] FileError),
    /// Meant as a palette.
    #[error(transparent)]
    Palette(#[from] PaletteError),
    /// Meant as a link.
    #[error(transparent)]
    Link(#[from] LinkError),
    /// Bytes from within the page, or from the browser's storage.
    #[error("what the browser kept of the drawing is damaged; open it from a file")]
    Damaged,
}

/// What is in a file: a palette where it begins as one, our work where it begins as JSON does, and else another
/// program's drawing, or a picture that was exported.
///
/// # Errors
/// Where it is neither, damaged, or beyond the limits.
pub fn file(bytes: &[u8]) -> Result<Content, OpenError> {
    if PaletteKind::of_bytes(bytes).is_some() {
        let palette = read_palette(bytes)?;
        let notes = palette.notes();
        return Ok(Content::Palette(palette.colors, notes));
    }
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    if text.trim_ascii_start().starts_with(b"{") {
        return Ok(Content::Work(Box::new(read_file(bytes)?), String::new()));
    }
    let (work, notes) = import_drawing(bytes)?;
    Ok(Content::Work(Box::new(work), notes))
}

/// The work that some exact bytes stand for.
///
/// # Errors
/// Where they are damaged.
pub fn exact(bytes: &[u8]) -> Result<Work, OpenError> {
    exact_bytes::read(bytes).ok_or(OpenError::Damaged)
}

/// The sample that work is without the lines of.
pub fn lacking_sample(work: &Work) -> Option<String> {
    let drawing = &work.document.drawing;
    work.sample.clone().filter(|_| drawing.curves.is_empty() && drawing.fills.is_empty())
}

/// Work with the lines of a sample.
pub fn on_sample(mut work: Work, sample: Work) -> Work {
    work.document.drawing = sample.document.drawing;
    work
}
