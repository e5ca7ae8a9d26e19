//! What is opened, without a browser.

use scumble_core::{Work, exact as exact_bytes};
use scumble_io::{FileError, ImportError, LinkError, open_svg, read_file};
use thiserror::Error;

/// Why something cannot be opened, or kept.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum OpenError {
    /// Meant as an SVG drawing.
    #[error(transparent)]
    Svg(#[from] ImportError),
    /// Meant as a file of ours.
    #[error(transparent)]
    File(#[from] FileError),
    /// Meant as a link.
    #[error(transparent)]
    Link(#[from] LinkError),
    /// Bytes from within the page, or from the browser's storage.
    #[error("what the browser kept of the drawing is damaged; open it from a file")]
    Damaged,
}

/// The work in a file, which is one of ours where it begins as JSON does, and else an SVG, which may be a picture that
/// was exported; and what was left out.
///
/// # Errors
/// Where it is neither, damaged, or beyond the limits.
pub fn file(bytes: &[u8]) -> Result<(Work, String), OpenError> {
    let text = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    if text.trim_ascii_start().starts_with(b"{") {
        return Ok((read_file(bytes)?, String::new()));
    }
    Ok(open_svg(bytes)?)
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
