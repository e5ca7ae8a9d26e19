//! Which masks are followed, as far as the tree as written tells.
//!
//! A mask of nothing but shapes may cut as a clip path does; whether these are filled plainly is told once styles are resolved.
//! `usvg` copies a mask for each element that it masks, and goes round in circles where masks mask each other: it is kept from
//! all other masks, and from these too where that makes too many copies.

use std::collections::HashMap;
use std::ops::Range;

use roxmltree::{Attribute, Document, Node};
use svgtypes::FuncIRI;

use crate::css::is_quoted;
use crate::expansion::{self, Expansion, Expansions};
use crate::limits::MAX_DEPTH;
use crate::style_sheet;

/// Stands in the place of a mask that is not followed.
const UNFOLLOWED: &str = "url()";

/// Most elements and segments of masks, and children of paint servers in them, that are copied to what they mask.
const MAX_COPIES: u64 = 2_000_000;

/// Most elements that are masked: `usvg` compares the mask of each with all others.
const MAX_MASKED: u64 = 20_000;

/// Where a mask is to be taken from its element, and what is to stand there.
pub(crate) fn edits(xml: &Document) -> Vec<(Range<usize>, String)> {
    if mask_attributes(xml).next().is_none() {
        return Vec::new();
    }
    // What cannot be counted is refused later.
    let Ok(expansions) = expansion::of(xml, &expansion::ids(xml)) else { return Vec::new() };
    let places = unfollowed(xml, &expansions).map(|mask| mask.range_value());
    let places = places.filter(|place| is_quoted(xml.input_text(), place));
    places.map(|place| (place, UNFOLLOWED.to_owned())).collect()
}

/// How many masks were taken from their elements.
pub(crate) fn replaced(xml: &Document) -> usize {
    mask_attributes(xml).filter(|mask| mask.value() == UNFOLLOWED).count()
}

/// Whether all masks that there still are can be followed, together with gradients and patterns of so many children.
pub(crate) fn are_followed(xml: &Document, expansions: &Expansions, paint_server: u64) -> bool {
    let whole = expansions.of(xml.root_element());
    let masks = elements(xml, "mask").map(|mask| expansions.of(mask));
    let masks: Vec<_> = masks.filter(|mask| mask.beyond_shapes == 0).collect();
    let size =
        |mask: &Expansion| mask.elements.saturating_mul(1 + paint_server).saturating_add(mask.segments);
    let largest = masks.iter().map(size).max().unwrap_or(0);
    let highest = masks.iter().map(|mask| mask.height).max().unwrap_or(0);
    whole.masked <= MAX_MASKED
        && whole.masked.saturating_mul(largest) <= MAX_COPIES
        && whole.height + highest <= MAX_DEPTH
        && elements(xml, "pattern").all(|pattern| expansions.of(pattern).masked == 0)
        && unfollowed(xml, expansions).next().is_none()
        && mask_attributes(xml).all(|mask| is_known(mask.value()))
        && !are_in_styles(xml)
}

/// Whether it is known what a value refers to, as it is not where it is inherited.
fn is_known(value: &str) -> bool {
    matches!(value, "none" | UNFOLLOWED) || FuncIRI::from_str(value).is_ok()
}

/// Whether a style may mask something: then it is not known what.
fn are_in_styles(xml: &Document) -> bool {
    let names_mask = |css: &str| css.matches("mask").count() > css.matches("mask-type").count();
    let mut styles = xml.descendants().filter_map(|node| node.attribute("style"));
    style_sheet::texts(xml).any(|css| css.contains("url(") || names_mask(css)) || styles.any(names_mask)
}

/// The attributes that refer to something else than masks of nothing but shapes.
fn unfollowed<'a>(xml: &'a Document, expansions: &Expansions) -> impl Iterator<Item = Attribute<'a, 'a>> {
    let mut plain = HashMap::new();
    for node in xml.descendants() {
        let is_plain = node.tag_name().name() == "mask" && is_plain(node, expansions.of(node));
        for id in node.attributes().filter(|attribute| attribute.name() == "id") {
            // Of several of a name it is not known which counts.
            *plain.entry(id.value()).or_insert(true) &= is_plain;
        }
    }
    mask_attributes(xml).filter(move |mask| {
        FuncIRI::from_str(mask.value()).is_ok_and(|FuncIRI(id)| plain.get(id) == Some(&false))
    })
}

/// Whether a mask has shapes alone. One in units of what it masks is not followed: `usvg` shows nothing of a line without height
/// then, and knows no size of a text or an image.
fn is_plain(mask: Node, Expansion { beyond_shapes, segments, .. }: Expansion) -> bool {
    beyond_shapes == 0 && segments > 0 && mask.attribute("maskContentUnits") != Some("objectBoundingBox")
}

fn mask_attributes<'a>(xml: &'a Document) -> impl Iterator<Item = Attribute<'a, 'a>> {
    xml.descendants().flat_map(|node| node.attributes()).filter(|attribute| attribute.name() == "mask")
}

fn elements<'a>(xml: &'a Document, name: &str) -> impl Iterator<Item = Node<'a, 'a>> {
    xml.descendants().filter(move |node| node.tag_name().name() == name)
}
