//! Limits that hold before a file is parsed and before its tree is given to `usvg`.
//!
//! Every part of the two parsers that takes more than linear time or memory has its limit here, so that any file
//! is answered within about a second and `usvg` never recurses deeper than a small stack allows.

use roxmltree::{Document, ParsingOptions};

use crate::MAX_FILE_BYTES;
use crate::error::ImportError;
use crate::expansion::{self, Expansion};
use crate::style_sheet;

/// Most `<` in a file: opening tags, closing tags, comments.
const MAX_TAGS: usize = 1_000_000;

/// Most elements once every `use` is replaced by a copy.
const MAX_ELEMENTS: u64 = 200_000;

/// Most elements times levels: `usvg` asks all ancestors of an element for its style and its bounds.
const MAX_ANCESTORS: u64 = 10_000_000;

/// Most bytes of attributes once every `use` is replaced by a copy.
const MAX_ATTRIBUTE_BYTES: u64 = 20_000_000;

/// Most bytes of path data and point lists once every `use` is replaced by a copy.
const MAX_GEOMETRY_BYTES: u64 = 4_000_000;

/// Deepest nesting once every `use` is replaced by a copy. `usvg` needs about 2.3 kB of stack for each level.
pub(crate) const MAX_DEPTH: u32 = 200;

/// Most declared entities.
const MAX_ENTITIES: usize = 100;

/// Longest declaration of an entity.
const MAX_ENTITY_BYTES: usize = 4096;

/// Most steps in the parts of the XML parser that compare all pairs: attributes of one element, name spaces.
const MAX_PAIRS: usize = 200_000_000;

/// Most stops or tiles to be copied: (children of the largest gradient or pattern) × elements.
const MAX_PAINT_COPIES: u64 = 2_000_000;

/// Longest list of dashes, in bytes; it is read again for each element that inherits it.
const MAX_DASHES_BYTES: usize = 400;

/// Most tests of a style rule against an element, counting a thousand elements more than there are and eight
/// bytes of class names as one.
const MAX_STYLE_TESTS: f64 = 2e8;

/// The file as text that may be parsed: within the limits, and with entities that stay small.
pub(crate) fn readable_text(bytes: &[u8]) -> Result<&str, ImportError> {
    match bytes {
        [] => return Err(ImportError::Empty),
        [0x1f, 0x8b, ..] => return Err(ImportError::Compressed),
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => return Err(ImportError::Utf16),
        _ if bytes.len() > MAX_FILE_BYTES => return Err(ImportError::TooLarge),
        _ => {}
    }
    let text = std::str::from_utf8(bytes).map_err(|_| ImportError::NotText)?;
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    if text.trim().is_empty() {
        return Err(ImportError::Empty);
    }
    if text.bytes().filter(|&b| b == b'<').count() > MAX_TAGS {
        return Err(ImportError::TooManyElements);
    }
    check_pairs(text)?;
    check_entities(text)?;
    check_dashes(text)?;
    Ok(text)
}

/// Parses text that [`readable_text`] let through.
pub(crate) fn parse_xml(text: &str) -> Result<Document<'_>, ImportError> {
    let nodes_limit = 2 * MAX_TAGS as u32;
    let options = ParsingOptions { allow_dtd: true, nodes_limit, ..ParsingOptions::default() };
    let xml = Document::parse_with_options(text, options).map_err(|error| match error {
        roxmltree::Error::NodesLimitReached => ImportError::TooManyElements,
        error => ImportError::NotXml(error.to_string()),
    })?;
    let root = xml.root_element();
    let is_svg = root.tag_name().name() == "svg" && matches!(root.tag_name().namespace(), None | Some(SVG));
    if is_svg { Ok(xml) } else { Err(ImportError::NotSvg(shortened(root.tag_name().name()))) }
}

/// The name space of SVG elements.
pub(crate) const SVG: &str = "http://www.w3.org/2000/svg";

/// Checks what `usvg` would make of a tree.
pub(crate) fn check_tree(xml: &Document) -> Result<(), ImportError> {
    let ids = expansion::ids(xml);
    let Expansion { elements, attribute_bytes, geometry_bytes, class_bytes, height } =
        expansion::of(xml, &ids)?;
    if height > MAX_DEPTH {
        return Err(ImportError::TooDeep { limit: MAX_DEPTH });
    }
    if elements > MAX_ELEMENTS {
        return Err(ImportError::TooManyElements);
    }
    if u64::from(height) * elements > MAX_ANCESTORS {
        return Err(ImportError::TooDeep { limit: MAX_DEPTH });
    }
    if attribute_bytes > MAX_ATTRIBUTE_BYTES || geometry_bytes > MAX_GEOMETRY_BYTES {
        return Err(ImportError::TooDetailed);
    }
    if expansion::largest_paint_server(xml, &ids)?.saturating_mul(elements) > MAX_PAINT_COPIES {
        return Err(ImportError::TooManyStops);
    }
    let tests = style_sheet::tests_per_element(xml, height) * (1000 + elements + class_bytes / 8) as f64;
    if tests > MAX_STYLE_TESTS { Err(ImportError::TooManyStyles) } else { Ok(()) }
}

/// The XML parser compares each attribute with all others of its element, and name spaces with those of the parent.
fn check_pairs(text: &str) -> Result<(), ImportError> {
    let square = |count: usize| count * count;
    let attributes = text.split('<').map(|tag| square(tag.bytes().filter(|&b| b == b'=').count()));
    let name_spaces = square(text.matches("xmlns:").count());
    let too_many = attributes.sum::<usize>() + name_spaces > MAX_PAIRS;
    if too_many { Err(ImportError::TooManyAttributes) } else { Ok(()) }
}

/// Entities may stand for short texts, as Adobe Illustrator writes them; none may grow the file beyond its limit.
fn check_entities(text: &str) -> Result<(), ImportError> {
    let mut longest = 0;
    for (count, (at, _)) in text.match_indices("<!ENTITY").enumerate() {
        let value = entity_value(&text.as_bytes()[at..]).ok_or(ImportError::Entities)?;
        if count == MAX_ENTITIES || value.contains(&b'&') {
            return Err(ImportError::Entities);
        }
        longest = longest.max(value.len());
    }
    let references = text.bytes().filter(|&b| b == b'&').count();
    if references * longest > MAX_FILE_BYTES { Err(ImportError::Entities) } else { Ok(()) }
}

/// The text between the quotes of an entity's declaration, where it is short.
fn entity_value(declaration: &[u8]) -> Option<&[u8]> {
    let declaration = declaration.get(..MAX_ENTITY_BYTES).unwrap_or(declaration);
    let open = declaration.iter().position(|b| matches!(b, b'"' | b'\''))?;
    let (quote, value) = declaration[open..].split_first()?;
    let close = value.iter().position(|b| b == quote)?;
    value.get(..close)
}

/// Lists of dashes, in attributes and in style sheets alike.
fn check_dashes(text: &str) -> Result<(), ImportError> {
    let too_long = text.split("stroke-dasharray").skip(1).any(|after| {
        let list =
            after.trim_start_matches(|c: char| matches!(c, '=' | ':' | '"' | '\'') || c.is_whitespace());
        list.find(['"', '\'', ';', '}', '<']).unwrap_or(list.len()) > MAX_DASHES_BYTES
    });
    if too_long { Err(ImportError::TooManyDashes) } else { Ok(()) }
}

/// The start of a text, for a message.
pub(crate) fn shortened(text: &str) -> String {
    text.chars().take(40).collect()
}
