//! Counts, on the tree as written, what an import leaves out or ignores, and finds the shapes that are faulty.

use std::ops::Range;

use roxmltree::{Document, Node};

use crate::geometry;
use crate::limits::SVG;
use crate::notes::ImportNotes;

/// What was found.
#[derive(Debug, Default)]
pub(crate) struct Survey {
    pub(crate) notes: ImportNotes,
    /// Where in the text the elements with unusable coordinates are, in order; they may hold each other.
    pub(crate) broken: Vec<Range<usize>>,
}

/// Looks through all elements.
pub(crate) fn of(xml: &Document) -> Survey {
    let mut survey = Survey::default();
    let elements = xml.root_element().descendants().skip(1).filter(Node::is_element);
    for node in elements.filter(|node| matches!(node.tag_name().namespace(), None | Some(SVG))) {
        survey.count(node);
    }
    survey.notes.broken = survey.broken.len();
    survey
}

impl Survey {
    fn count(&mut self, node: Node) {
        let notes = &mut self.notes;
        match node.tag_name().name() {
            "text" | "foreignObject" => notes.texts += 1,
            "image" => notes.images += 1,
            "clipPath" => notes.clip_paths += 1,
            "mask" => notes.masks += 1,
            "filter" => notes.filters += 1,
            "marker" => notes.markers += 1,
            _ if geometry::cost(node).is_none() => self.broken.push(node.range()),
            _ => {}
        }
    }
}

/// A text without some parts of it, which are in the order of their starts.
pub(crate) fn without(text: &str, parts: &[Range<usize>]) -> String {
    let mut kept = String::with_capacity(text.len());
    let mut at = 0;
    for part in parts {
        kept.push_str(text.get(at..part.start).unwrap_or_default());
        at = at.max(part.end);
    }
    kept.push_str(text.get(at..).unwrap_or_default());
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_cut_out_also_where_one_holds_another() {
        assert_eq!(without("0123456789", &[1..3, 4..8, 5..6, 9..10]), "038");
        assert_eq!(without("0123", &[]), "0123");
    }
}
