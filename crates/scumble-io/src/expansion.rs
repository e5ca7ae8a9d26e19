//! What a tree grows to once every `use` is replaced by a copy of what it refers to.
//!
//! Counted, never built: each element is counted once, and its count is used again wherever it is referred to.

use std::collections::HashMap;

use roxmltree::{Document, Node};

use crate::error::ImportError;
use crate::geometry;
use crate::limits::MAX_DEPTH;

/// Sums over an element and all below it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Expansion {
    pub(crate) elements: u64,
    /// Bytes of all attribute values.
    pub(crate) attribute_bytes: u64,
    /// Segments of shapes, longer curves counting more.
    pub(crate) segments: u64,
    /// Bytes of class names.
    pub(crate) class_bytes: u64,
    /// Levels, a `use` counting as one more.
    pub(crate) height: u32,
    /// Elements that are masked.
    pub(crate) masked: u64,
    /// Elements that are more than shapes: texts, images, and what refers to paints, clip paths and the like.
    pub(crate) beyond_shapes: u64,
}

impl Expansion {
    fn of_element(node: Node) -> Self {
        let attribute_bytes = node.attributes().map(|a| a.value().len() as u64).sum();
        let segments = geometry::cost(node).unwrap_or(0);
        let class_bytes = node.attribute("class").map_or(0, |value| value.len() as u64);
        let masked = u64::from(node.attributes().any(|a| a.name() == "mask"));
        let beyond_shapes = u64::from(is_beyond_shapes(node));
        Self { elements: 1, attribute_bytes, segments, class_bytes, height: 1, masked, beyond_shapes }
    }

    fn add_below(&mut self, other: Self) {
        self.elements = self.elements.saturating_add(other.elements);
        self.attribute_bytes = self.attribute_bytes.saturating_add(other.attribute_bytes);
        self.segments = self.segments.saturating_add(other.segments);
        self.class_bytes = self.class_bytes.saturating_add(other.class_bytes);
        self.height = self.height.max(1 + other.height);
        self.masked = self.masked.saturating_add(other.masked);
        self.beyond_shapes = self.beyond_shapes.saturating_add(other.beyond_shapes);
    }
}

fn is_beyond_shapes(node: Node) -> bool {
    matches!(node.tag_name().name(), "text" | "image" | "foreignObject")
        || node.attributes().any(|a| a.value().contains("url("))
}

/// The expansion of each element of a tree.
#[derive(Debug)]
pub(crate) struct Expansions(Vec<Known>);

impl Expansions {
    pub(crate) fn of(&self, node: Node) -> Expansion {
        match self.0.get(node.id().get_usize()) {
            Some(Known::Counted(expansion)) => *expansion,
            _ => Expansion::default(),
        }
    }
}

/// The expansions of a tree, which is at most [`MAX_DEPTH`] deep as written.
///
/// # Errors
/// When elements refer to themselves, or the copies nest too deep.
pub(crate) fn of<'a, 'input>(
    xml: &'a Document<'input>,
    ids: &Ids<'a, 'input>,
) -> Result<Expansions, ImportError> {
    let mut counter = Counter { ids, known: vec![Known::New; xml.descendants().count()] };
    counter.count(xml.root_element(), 0)?;
    Ok(Expansions(counter.known))
}

#[derive(Clone, Copy, Debug)]
enum Known {
    New,
    Open,
    Counted(Expansion),
}

struct Counter<'i, 'a, 'input> {
    ids: &'i Ids<'a, 'input>,
    known: Vec<Known>,
}

impl<'a, 'input> Counter<'_, 'a, 'input> {
    fn count(&mut self, node: Node<'a, 'input>, depth: u32) -> Result<Expansion, ImportError> {
        let index = node.id().get_usize();
        match self.known[index] {
            Known::Counted(expansion) => return Ok(expansion),
            Known::Open => return Err(ImportError::Circular),
            Known::New if depth > MAX_DEPTH => return Err(ImportError::TooDeep { limit: MAX_DEPTH }),
            Known::New => self.known[index] = Known::Open,
        }
        let mut expansion = Expansion::of_element(node);
        let target = if node.tag_name().name() == "use" { self.referred(node) } else { None };
        for child in node.children().filter(Node::is_element).chain(target) {
            expansion.add_below(self.count(child, depth + 1)?);
        }
        self.known[index] = Known::Counted(expansion);
        Ok(expansion)
    }

    fn referred(&self, node: Node) -> Option<Node<'a, 'input>> {
        href(node).and_then(|id| self.ids.get(id)).copied()
    }
}

/// Elements by name.
pub(crate) type Ids<'a, 'input> = HashMap<&'a str, Node<'a, 'input>>;

/// The named elements of a tree; the first of a name counts.
pub(crate) fn ids<'a, 'input>(xml: &'a Document<'input>) -> Ids<'a, 'input> {
    let mut ids = HashMap::new();
    for node in xml.descendants().filter(Node::is_element) {
        if let Some(id) = node.attribute("id") {
            ids.entry(id).or_insert(node);
        }
    }
    ids
}

/// The name of the element that another refers to.
fn href<'a>(node: Node<'a, '_>) -> Option<&'a str> {
    let mut links = node.attributes().filter(|a| a.name() == "href");
    let plain = links.clone().find(|a| a.namespace().is_none());
    plain.or_else(|| links.next()).and_then(|a| a.value().trim().strip_prefix('#'))
}

/// Longest chain of gradients or patterns that take what they lack from each other.
const MAX_CHAIN: usize = 32;

/// The number of elements in the largest gradient or pattern.
///
/// # Errors
/// When gradients or patterns refer to each other in too long a chain.
pub(crate) fn largest_paint_server<'a, 'input>(
    xml: &'a Document<'input>,
    ids: &Ids<'a, 'input>,
) -> Result<u64, ImportError> {
    let mut largest = 0;
    for server in xml.descendants().filter(|node| is_paint_server(*node)) {
        largest = largest.max(server.descendants().count() as u64);
        let chain =
            std::iter::successors(Some(server), |node| href(*node).and_then(|id| ids.get(id)).copied());
        if chain.take(MAX_CHAIN + 1).count() > MAX_CHAIN {
            return Err(ImportError::Circular);
        }
    }
    Ok(largest)
}

fn is_paint_server(node: Node) -> bool {
    matches!(node.tag_name().name(), "linearGradient" | "radialGradient" | "pattern")
}

/// Most elements and segments that clip paths in the units of what they clip are copied to.
const MAX_CLIP_COPIES: u64 = 2_000_000;

/// The clip paths of a tree.
pub(crate) fn clip_paths<'a, 'input>(xml: &'a Document<'input>) -> impl Iterator<Item = Node<'a, 'input>> {
    xml.descendants().filter(|node| node.tag_name().name() == "clipPath")
}

/// Whether a clip path consists of shapes alone, and is not too large to be copied for each of so many elements where its units
/// are theirs.
pub(crate) fn can_clip(clip_path: Node, ids: &Ids, elements: u64) -> bool {
    let is_shape = |node: Node| {
        let target = href(node).and_then(|id| ids.get(id));
        let is_text =
            [Some(&node), target].into_iter().flatten().any(|node| node.tag_name().name() == "text");
        !is_text && !node.has_attribute("clip-path")
    };
    let is_copied = clip_path.attribute("clipPathUnits") == Some("objectBoundingBox");
    let copied = |node: Node| match node.tag_name().name() {
        "use" => MAX_CLIP_COPIES,
        _ => 1 + geometry::cost(node).unwrap_or(0),
    };
    let size = clip_path.descendants().map(copied).fold(0, u64::saturating_add);
    clip_path.descendants().all(is_shape) && (!is_copied || size.saturating_mul(elements) <= MAX_CLIP_COPIES)
}
