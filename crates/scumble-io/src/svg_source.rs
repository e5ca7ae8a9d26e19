//! The work that an SVG was made of, within it: its file, as the text of an element of our own among the metadata.

use std::borrow::Cow;

use scumble_core::{Document, Work};

use crate::MAX_FILE_BYTES;
use crate::error::{FileError, ImportError};
use crate::limits;
use crate::svg::{Import, import_svg};
use crate::work_file::{read_file, write_file_with};

/// The name space of the element `work`. It leads nowhere.
const NAMESPACE: &str = "urn:scumble:1";

/// What follows the text of the element.
const END: &str = "</work></metadata>\n";

/// The class of the group that shows the colours: not part of the drawing where the lines alone are read.
pub const COLORS_CLASS: &str = "scumble-colors";

/// The element `metadata` of an SVG that keeps some work, without the picture under its lines.
///
/// # Errors
/// When it could not be read again.
pub fn write_svg_source(work: &Work) -> Result<String, FileError> {
    let file = write_file_with(work, &[])?;
    let mut text = ["<metadata><work xmlns=\"", NAMESPACE, "\">\n"].concat();
    for character in String::from_utf8_lossy(&file).chars() {
        match character {
            '&' => text.push_str("&amp;"),
            '<' => text.push_str("&lt;"),
            '>' => text.push_str("&gt;"),
            // XML has no place for these, but JSON, whose strings they can only be in, has another way to write them.
            '\u{fffe}' => text.push_str("\\ufffe"),
            '\u{ffff}' => text.push_str("\\uffff"),
            other => text.push(other),
        }
    }
    text.push_str(END);
    Ok(text)
}

/// Opens an SVG: the work that it keeps, or else its lines; and what was left out, in words.
///
/// # Errors
/// When it keeps no work that can be read, and is no drawing either; see [`import_svg`].
pub(crate) fn open_svg(bytes: &[u8]) -> Result<(Work, String), ImportError> {
    let fault = match source(bytes) {
        Some(Ok(work)) => return Ok((work, String::new())),
        Some(Err(fault)) => Some(fault),
        None => None,
    };
    let Import { drawing, size, notes } = import_svg(bytes)?;
    let mut work = Work::new(Document::new(drawing));
    if let Some(size) = size {
        size.keep_in(&mut work);
    }
    let notes = match fault {
        Some(fault) => format!("its lines alone, without the scribbles: {fault}"),
        None => notes.to_string(),
    };
    Ok((work, notes))
}

/// Whether an SVG keeps work that can be read.
pub fn keeps_work(bytes: &[u8]) -> bool {
    matches!(source(bytes), Some(Ok(_)))
}

/// The work that an SVG keeps; `None` where it keeps none, or is no SVG.
fn source(bytes: &[u8]) -> Option<Result<Work, FileError>> {
    let text = openable(bytes);
    let text = limits::readable_text(&text).ok().filter(|text| text.contains(NAMESPACE))?;
    let xml = limits::parse_xml(text).ok()?;
    text_of(&xml).map(|text| read_file(text.as_bytes()))
}

/// As much of an SVG as can be opened: one of ours has the work at its beginning, however large the picture of it is.
fn openable(bytes: &[u8]) -> Cow<'_, [u8]> {
    let is_end = |part: &[u8]| part == END.as_bytes();
    let first = bytes.get(..MAX_FILE_BYTES).filter(|first| first.len() < bytes.len());
    match first.and_then(|first| first.windows(END.len()).position(is_end)) {
        Some(end) => Cow::Owned([&bytes[..end + END.len()], b"</svg>"].concat()),
        None => Cow::Borrowed(bytes),
    }
}

/// The text of the element, which a program that has written the SVG anew may have put into other groups.
fn text_of(xml: &roxmltree::Document) -> Option<String> {
    let work = xml.descendants().find(|node| node.has_tag_name((NAMESPACE, "work")))?;
    Some(work.children().filter_map(|node| node.text()).collect())
}
