//! Limits that hold before a file is parsed and before its tree is given to `usvg`.
//!
//! Every part of the two parsers that takes more than linear time or memory has its limit here, so that any file
//! is answered within about a second and `usvg` never recurses deeper than a small stack allows.

use roxmltree::{Document, ParsingOptions};

use crate::MAX_FILE_BYTES;
use crate::error::ImportError;
use crate::expansion::{self, Expansion};
use crate::{masks, style_sheet};

/// Most `<` in a file: opening tags, closing tags, comments.
const MAX_TAGS: usize = 1_000_000;

/// Most elements once every `use` is replaced by a copy.
const MAX_ELEMENTS: u64 = 200_000;

/// Most elements times levels: `usvg` asks all ancestors of an element for its style and its bounds.
const MAX_ANCESTORS: u64 = 10_000_000;

/// Most bytes of attributes once every `use` is replaced by a copy.
const MAX_ATTRIBUTE_BYTES: u64 = 20_000_000;

/// Most segments of shapes once every `use` is replaced by a copy, longer curves counting more.
const MAX_SEGMENTS: u64 = 500_000;

/// Widest line, in its own units, and longest mitre; `usvg` takes ever longer for wider ones.
const MAX_WIDTH: f64 = 1e6;

/// Deepest nesting once every `use` is replaced by a copy. `usvg` needs about 2.3 kB of stack for each level.
pub(crate) const MAX_DEPTH: u32 = 200;

/// Most declared entities.
const MAX_ENTITIES: usize = 100;

/// Longest declaration of an entity.
const MAX_ENTITY_BYTES: usize = 4096;

/// Most steps in the parts of the XML parser that compare all pairs: attributes of one element, name spaces.
const MAX_PAIRS: u64 = 200_000_000;

/// Most stops or tiles to be copied: (children of the largest gradient or pattern) × elements.
const MAX_PAINT_COPIES: u64 = 2_000_000;

/// Longest list of dashes, in bytes; it is read again for each element that inherits it.
const MAX_DASHES_BYTES: usize = 400;

/// Most tests of a style rule against an element, counting a thousand elements more than there are and eight
/// bytes of class names as one.
const MAX_STYLE_TESTS: f64 = 2e8;

/// Most declarations of a style text times its bytes: `simplecss` counts lines from the beginning at the end of each.
const MAX_STYLE_STEPS: u64 = 4_000_000_000;

/// The file as text that may be parsed: within the limits, and with entities that stay small.
pub(crate) fn readable_text(bytes: &[u8]) -> Result<&str, ImportError> {
    match bytes {
        [] => return Err(ImportError::Empty),
        [0x1f, 0x8b, ..] => return Err(ImportError::Compressed),
        [0xff, 0xfe, ..] | [0xfe, 0xff, ..] => return Err(ImportError::Utf16),
        [b'%', b'P', b'D', b'F', ..] => return Err(ImportError::ForPrint("PDF")),
        [b'%', b'!', b'P', b'S', ..] | [0xc5, 0xd0, 0xd3, 0xc6, ..] => {
            return Err(ImportError::ForPrint("PostScript"));
        }
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
    Ok(text)
}

/// Parses text that [`readable_text`] let through, as an SVG.
pub(crate) fn parse_svg(text: &str) -> Result<Document<'_>, ImportError> {
    let xml = parse_xml(text)?;
    let root = xml.root_element().tag_name();
    let is_svg = root.name() == "svg" && matches!(root.namespace(), None | Some(SVG));
    if is_svg { Ok(xml) } else { Err(ImportError::NotSvg(shortened(root.name()))) }
}

/// Parses text that [`readable_text`] let through.
pub(crate) fn parse_xml(text: &str) -> Result<Document<'_>, ImportError> {
    let nodes_limit = 2 * MAX_TAGS as u32;
    let options = ParsingOptions { allow_dtd: true, nodes_limit, ..ParsingOptions::default() };
    Document::parse_with_options(text, options).map_err(|error| match error {
        roxmltree::Error::NodesLimitReached => ImportError::TooManyElements,
        error => ImportError::NotXml(error.to_string()),
    })
}

/// The name space of SVG elements.
pub(crate) const SVG: &str = "http://www.w3.org/2000/svg";

/// Whether clip paths, and masks, are such as can be followed.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Followed {
    pub(crate) clip_paths: bool,
    pub(crate) masks: bool,
}

/// Checks what `usvg` would make of a tree, and tells what of it can be followed.
pub(crate) fn check_tree(xml: &Document) -> Result<Followed, ImportError> {
    check_lines(xml)?;
    let ids = expansion::ids(xml);
    let expansions = expansion::of(xml, &ids)?;
    let Expansion { elements, attribute_bytes, segments, class_bytes, height, .. } =
        expansions.of(xml.root_element());
    if height > MAX_DEPTH {
        return Err(ImportError::TooDeep { limit: MAX_DEPTH });
    }
    if elements > MAX_ELEMENTS {
        return Err(ImportError::TooManyElements);
    }
    if u64::from(height) * elements > MAX_ANCESTORS {
        return Err(ImportError::TooDeep { limit: MAX_DEPTH });
    }
    if attribute_bytes > MAX_ATTRIBUTE_BYTES || segments > MAX_SEGMENTS {
        return Err(ImportError::TooDetailed);
    }
    let paint_server = expansion::largest_paint_server(xml, &ids)?;
    if paint_server.saturating_mul(elements) > MAX_PAINT_COPIES {
        return Err(ImportError::TooManyStops);
    }
    let tests = style_sheet::tests_per_element(xml, height) * (1000 + elements + class_bytes / 8) as f64;
    if tests > MAX_STYLE_TESTS {
        return Err(ImportError::TooManyStyles);
    }
    let clip_paths =
        expansion::clip_paths(xml).all(|clip_path| expansion::can_clip(clip_path, &ids, elements));
    Ok(Followed { clip_paths, masks: masks::are_followed(xml, &expansions, paint_server) })
}

/// The XML parser compares each attribute with all others of its element, and name spaces with those of the parent.
fn check_pairs(text: &str) -> Result<(), ImportError> {
    let square = |count: usize| (count as u64).saturating_mul(count as u64);
    let attributes = text.split('<').map(|tag| square(tag.bytes().filter(|&b| b == b'=').count()));
    let name_spaces = square(text.matches("xmlns:").count());
    let too_many = attributes.sum::<u64>() + name_spaces > MAX_PAIRS;
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
    if references as u64 * longest as u64 > MAX_FILE_BYTES as u64 {
        Err(ImportError::Entities)
    } else {
        Ok(())
    }
}

/// The text between the quotes of an entity's declaration, where it is short.
fn entity_value(declaration: &[u8]) -> Option<&[u8]> {
    let declaration = declaration.get(..MAX_ENTITY_BYTES).unwrap_or(declaration);
    let open = declaration.iter().position(|b| matches!(b, b'"' | b'\''))?;
    let (quote, value) = declaration[open..].split_first()?;
    let close = value.iter().position(|b| b == quote)?;
    value.get(..close)
}

/// Widths and lists of dashes, in attributes and in style sheets alike, with all entities in their places.
fn check_lines(xml: &Document) -> Result<(), ImportError> {
    for attribute in xml.descendants().flat_map(|node| node.attributes()) {
        match attribute.name() {
            "style" => check_style(attribute.value())?,
            name => check_property(name, attribute.value())?,
        }
    }
    style_sheet::texts(xml).try_for_each(check_style)
}

fn check_style(css: &str) -> Result<(), ImportError> {
    let declarations = css.bytes().filter(|&byte| byte == b':').count();
    if declarations as u64 * css.len() as u64 > MAX_STYLE_STEPS {
        return Err(ImportError::TooManyStyles);
    }
    let css = style_sheet::without_comments(css);
    for property in ["stroke-dasharray", "stroke-width", "stroke-miterlimit"] {
        values(&css, property).try_for_each(|value| check_property(property, value))?;
    }
    Ok(())
}

fn check_property(name: &str, value: &str) -> Result<(), ImportError> {
    match name {
        "stroke-dasharray" if value.len() > MAX_DASHES_BYTES => Err(ImportError::TooManyDashes),
        "stroke-width" | "stroke-miterlimit" if number(value).is_some_and(|width| width > MAX_WIDTH) => {
            Err(ImportError::TooWide)
        }
        _ => Ok(()),
    }
}

/// A number, whatever its unit.
fn number(text: &str) -> Option<f64> {
    text.trim().trim_end_matches(|c: char| c.is_ascii_alphabetic() || c == '%').parse().ok()
}

/// What follows each mention of a property.
fn values<'a>(text: &'a str, property: &'a str) -> impl Iterator<Item = &'a str> {
    text.split(property).skip(1).map(|after| {
        let value =
            after.trim_start_matches(|c: char| matches!(c, '=' | ':' | '"' | '\'') || c.is_whitespace());
        value.split(['"', '\'', ';', '}', '<']).next().unwrap_or_default()
    })
}

/// The start of a text, for a message.
pub(crate) fn shortened(text: &str) -> String {
    text.chars().take(40).collect()
}
