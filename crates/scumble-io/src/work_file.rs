//! Work as a `.scumble` file: readable JSON, one line for each curve and scribble. `docs/format.md` tells what it says.
//!
//! Lengths are in du with three digits after the point. Fields that are not known are kept as they are.

use std::borrow::Cow;

use scumble_core::work::{MAX_CURVES, MAX_PAGES, Work, are_too_long, are_too_many_shades};
use scumble_core::{Document, Scribble};

use crate::MAX_FILE_BYTES;
use crate::error::FileError;
use crate::json::{Fault, Json};
use read::Reader;

pub(crate) use later_fields::{put_by, take_up};

mod items;
mod later_fields;
mod names;
mod pressures;
mod read;
mod swatch_names;
mod write;

/// The version of these files: what is written says the least one that has all its fields. A file of a higher first
/// number is refused.
const VERSION: [u32; 2] = [1, 3];

/// The second number of the first version with a picture under the lines.
const TRACING_MINOR: u32 = 1;

/// The second number of the first version with the pressure of pens.
const PRESSURE_MINOR: u32 = 2;

/// The second number of the first version with names of swatches.
const NAMES_MINOR: u32 = 2;

/// The second number of the first version with a size of the page.
const SIZE_MINOR: u32 = 3;

/// What the picture under the lines is called by the document that is read from a file.
pub const FILE_IMAGE: u32 = 1;

/// Steps of numbers in one, and of page coordinates.
const PER_UNIT: u64 = 1000;
pub(crate) const PAGE_PER_UNIT: u64 = 1_000_000_000;

/// The file that keeps some work. The picture under the lines is in it where its file is there.
///
/// # Errors
/// When it could not be read again.
pub fn write_file(work: &Work) -> Result<Vec<u8>, FileError> {
    write_file_with(work, &work.image)
}

/// The same, with a picture under the lines if its file is not empty.
pub(crate) fn write_file_with(work: &Work, image: &[u8]) -> Result<Vec<u8>, FileError> {
    let Document { drawing, scribbles, .. } = &work.document;
    if drawing.curves.len() > MAX_CURVES {
        return Err(FileError::TooManyCurves);
    }
    check_scribbles(scribbles)?;
    let text = write::written(work, image);
    if text.len() > MAX_FILE_BYTES { Err(FileError::WouldBeTooLarge) } else { Ok(text.into_bytes()) }
}

/// Reads the work that a file keeps.
///
/// # Errors
/// When the bytes are no such file, or damaged, or of a newer version, or beyond the limits.
pub fn read_file(bytes: &[u8]) -> Result<Work, FileError> {
    if bytes.trim_ascii().is_empty() {
        return Err(FileError::Empty);
    }
    if bytes.len() > MAX_FILE_BYTES {
        return Err(FileError::TooLarge);
    }
    let text = str::from_utf8(bytes).map_err(|_| FileError::NotText)?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let damaged = |fault: Fault| {
        if fault.expected == items::NO_MORE_CURVES {
            return FileError::TooManyCurves;
        }
        let before = text.get(..fault.at).unwrap_or(text);
        FileError::Damaged { line: 1 + before.matches('\n').count(), expected: fault.expected }
    };
    let minor = minor_version(text, damaged)?;
    let work = Reader::read(text, minor).map_err(damaged)?;
    check_scribbles(&work.document.scribbles)?;
    Ok(work)
}

fn check_scribbles(scribbles: &[Scribble]) -> Result<(), FileError> {
    if are_too_long(scribbles) {
        return Err(FileError::TooLong { limit_pages: MAX_PAGES });
    }
    if are_too_many_shades(scribbles) { Err(FileError::TooManyShades) } else { Ok(()) }
}

/// The minor version of a file whose version can be read.
fn minor_version(text: &str, damaged: impl Fn(Fault) -> FileError) -> Result<u32, FileError> {
    let mut json = Json::new(text);
    let [mut format, mut version] = [const { Cow::Borrowed("") }; 2];
    let read = json.members(&mut |json, member| {
        match &*member.name {
            "format" => format = json.string()?,
            "version" => version = json.string()?,
            _ => json.skip()?,
        }
        Ok(())
    });
    if format != "scumble" {
        return Err(FileError::NotWork);
    }
    let (major, minor) = version.split_once('.').unwrap_or((&version, "0"));
    match (major.parse::<u32>(), minor.parse()) {
        (Ok(1), Ok(minor)) => read.and_then(|()| json.end()).map(|()| minor).map_err(damaged),
        (Ok(2..), _) => Err(FileError::Newer(version.chars().take(16).collect())),
        _ => Err(FileError::NotWork),
    }
}
