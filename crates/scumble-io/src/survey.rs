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
            // What one program alone can read stands beside what all can.
            "foreignObject" if is_in_switch(node) => {}
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

fn is_in_switch(node: Node) -> bool {
    node.parent_element().is_some_and(|parent| parent.tag_name().name() == "switch")
}
