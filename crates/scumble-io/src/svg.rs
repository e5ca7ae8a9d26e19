//! An SVG drawing as curves: strokes along their centre line, areas by their outline.
//!
//! `usvg` resolves styles, units, shapes, transforms and references; what it gives is turned into curves in drawing
//! units here. Filters, markers, what patterns show, and masks that are more than shapes, are ignored, text and images left
//! out; all are counted.
//!
//! | noun | file |
//! |---|---|
//! | the walk through a tree | `importer` |
//! | a shape, as ink or as an area | `shape` |
//! | a mask that is a clip path | `mask` |

mod importer;
mod mask;
mod shape;

use roxmltree::Document;
use scumble_core::Drawing;
use usvg::Options;

use crate::css::{self, Mends};
use crate::error::ImportError;
use crate::notes::ImportNotes;
use crate::page_size::PageSize;
use crate::survey::{self, Survey};
use crate::{limits, masks, page};
use importer::Importer;

/// A drawing, and what was left out of its file.
#[derive(Clone, Debug)]
pub struct Import {
    /// The drawing; it has at least one curve.
    pub drawing: Drawing,
    /// How large its page is, if that is said.
    pub size: Option<PageSize>,
    /// What was left out or ignored.
    pub notes: ImportNotes,
}

/// Keeps `usvg` from everything that is ignored anyway, from the colours of an exported picture, and from patterns
/// within patterns; and what a file has of [`css::UNSCALED`] from being taken for that. What has a filter, or a mask that is not
/// followed, is taken for what others can be seen through.
const IGNORED: &str = "* { filter: none !important;
    marker-start: none !important; marker-mid: none !important; marker-end: none !important }
    text, image, .scumble-colors { display: none !important }
    [shape-rendering] { shape-rendering: auto }
    pattern * { fill: #808080 !important; stroke: none !important }
    [mask=\"url()\"], [filter] { mix-blend-mode: multiply !important }
    clipPath, clipPath * { clip-path: none !important }";

/// Keeps it from clip paths.
const UNCLIPPED: &str = "* { clip-path: none !important }";

/// Keeps it from masks.
const UNMASKED: &str = "* { mask: none !important } [mask] { mix-blend-mode: multiply !important }";

/// Reads an SVG drawing.
///
/// The page is the `viewBox` of the outermost element in its own units, or its width and height in pixels, or
/// what its shapes span. Answers within about a second, whatever the bytes.
///
/// # Errors
/// When the bytes are no SVG drawing, or one without anything to colour, or beyond the limits.
pub fn import_svg(bytes: &[u8]) -> Result<Import, ImportError> {
    let text = limits::readable_text(bytes)?;
    let xml = limits::parse_svg(text)?;
    let Survey { mut notes, broken } = survey::of(&xml);
    let Mends { mut edits, unreadable, lost_transforms } = css::of(&xml);
    notes.bad_colors = unreadable;
    notes.transforms = lost_transforms;
    edits.extend(broken.into_iter().map(|shape| (shape, String::new())));
    edits.extend(masks::edits(&xml));
    if edits.is_empty() {
        return import_tree(&xml, notes);
    }
    let sound = css::edited(text, edits);
    import_tree(&limits::parse_svg(&sound)?, notes)
}

/// Imports a tree of which every shape has usable coordinates.
fn import_tree(xml: &Document, mut notes: ImportNotes) -> Result<Import, ImportError> {
    let followed = limits::check_tree(xml)?;
    if followed.masks {
        // What is wrong with others is known when they are met.
        notes.masks = masks::replaced(xml);
    }
    let unscaled = ["[vector-effect=non-scaling-stroke] {", css::UNSCALED, "}"].concat();
    let clip_paths = if followed.clip_paths { "" } else { UNCLIPPED };
    let masks = if followed.masks { "" } else { UNMASKED };
    let style_sheet = [IGNORED, clip_paths, masks, &unscaled].concat();
    let options = Options { style_sheet: Some(style_sheet), ..Options::default() };
    let tree = usvg::Tree::from_xmltree(xml, &options).map_err(import_error)?;
    let size_px = [tree.size().width(), tree.size().height()].map(f64::from);
    let page = page::of(xml, size_px)?;
    let size = PageSize::of_svg(xml, page.rect);
    let mut importer = Importer::new(page, notes, followed.clip_paths);
    importer.walk(tree.root());
    importer.finish().map(|(drawing, notes)| Import { drawing, size, notes })
}

fn import_error(error: usvg::Error) -> ImportError {
    match error {
        usvg::Error::InvalidSize => ImportError::NoPage,
        usvg::Error::ElementsLimitReached => ImportError::TooManyElements,
        error => ImportError::NotXml(error.to_string()),
    }
}
