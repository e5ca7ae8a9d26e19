//! What is opened, without a browser.

use scumble_core::{Swatch, Work, exact as exact_bytes};
use scumble_io::{
    FileError, ImageError, ImportError, LinkError, PaletteError, PaletteKind, check_image, import_drawing,
    is_image, other_kind, read_file, read_palette, write_file,
};
use thiserror::Error;

/// What a file holds.
#[derive(Clone, Debug)]
pub enum Content {
    /// Work, and what was left out of it, in words.
    Work(Box<Work>, String),
    /// Swatches for the palette of a drawing, and what was left out of them.
    Palette(Vec<Swatch>, String),
    /// A picture to trace.
    Image,
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
    /// Meant as a picture to trace.
    #[error(transparent)]
    Image(#[from] ImageError),
    /// Meant as a link.
    #[error(transparent)]
    Link(#[from] LinkError),
    /// Bytes from within the page, or from the browser's storage.
    #[error("what the browser kept of the drawing is damaged; open it from a file")]
    Damaged,
}

/// Kinds of files that are told by how they begin, or else by what they are called. All others are drawings of other
/// programs, or pictures that were exported.
enum Kind {
    Palette(Option<PaletteKind>),
    Work,
    Image,
    Drawing,
}

impl Kind {
    fn of(bytes: &[u8], name: &str) -> Self {
        let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start();
        if PaletteKind::of_bytes(bytes).is_some() {
            Self::Palette(None)
        } else if text.starts_with(b"{") {
            Self::Work
        } else if is_image(bytes) || other_kind(bytes).is_some() {
            Self::Image
        } else if text.starts_with(b"<") {
            Self::Drawing
        } else {
            Self::of_name(name)
        }
    }

    fn of_name(name: &str) -> Self {
        let extension = name.rsplit_once('.').map_or("", |(_, extension)| extension).to_ascii_lowercase();
        match &*extension {
            "scumble" => Self::Work,
            "png" | "jpg" | "jpeg" => Self::Image,
            _ => {
                PaletteKind::of_extension(&extension).map_or(Self::Drawing, |kind| Self::Palette(Some(kind)))
            }
        }
    }
}

/// What is in a file.
///
/// # Errors
/// Where it is damaged, or beyond the limits, or not what it is meant as.
pub fn file(bytes: &[u8], name: &str) -> Result<Content, OpenError> {
    Ok(match Kind::of(bytes, name) {
        Kind::Palette(meant) => {
            let palette = read_palette(bytes, meant)?;
            let notes = palette.notes();
            Content::Palette(palette.swatches, notes)
        }
        Kind::Work => Content::Work(Box::new(read_file(bytes)?), String::new()),
        Kind::Image => check_image(bytes).map(|()| Content::Image)?,
        Kind::Drawing => {
            let (work, notes) = import_drawing(bytes)?;
            Content::Work(Box::new(work), notes)
        }
    })
}

/// The work that some exact bytes stand for.
///
/// # Errors
/// Where they are damaged.
pub fn exact(bytes: &[u8]) -> Result<Work, OpenError> {
    exact_bytes::read(bytes).ok_or(OpenError::Damaged)
}

/// The `.scumble` file of work, with the picture under its lines if its file is not empty.
///
/// # Errors
/// Where it could not be read again, as with a picture that the browser's storage has damaged.
pub fn file_of(work: Work, image: Vec<u8>) -> Result<Vec<u8>, OpenError> {
    if !image.is_empty() {
        check_image(&image)?;
    }
    Ok(write_file(&Work { image, ..work })?)
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
