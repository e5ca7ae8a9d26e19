//! A mask that is a clip path: what is within its shapes is seen as it is, but for what is within others upon them.

use kurbo::Affine;
use scumble_core::Rgba8;
use usvg::{BlendMode, Group, Mask, MaskType, Node};

use super::shape::{Placed, affine};
use crate::paint::{self, WHITE};

const BLACK: Rgba8 = Rgba8([0, 0, 0, 255]);

/// The shapes of a mask, as far as they change what is seen.
#[derive(Debug, Default)]
pub(super) struct Shapes<'a> {
    /// What is within any of these is seen.
    pub(super) shown: Vec<Placed<'a>>,
    /// But not what is within any of these.
    pub(super) hidden: Vec<Placed<'a>>,
}

/// What a mask consists of; `None` where it is more than shapes that are filled without anything shining through, white
/// ones before black ones.
///
/// Nor is one followed that hides all: `usvg` empties those whose region is told by the size of a line without height.
pub(super) fn shapes(mask: &Mask) -> Option<Shapes<'_>> {
    let mut shapes = Shapes::default();
    let is_plain = mask.mask().is_none() && shapes.add(mask.root(), Affine::IDENTITY, mask.kind());
    (is_plain && !shapes.shown.is_empty()).then_some(shapes)
}

impl<'a> Shapes<'a> {
    /// Adds those of a group, and tells whether it has none that are more.
    fn add(&mut self, group: &'a Group, mask_from_user: Affine, kind: MaskType) -> bool {
        group.children().iter().all(|child| match child {
            Node::Group(group) => {
                is_bare(group) && self.add(group, mask_from_user * affine(group.transform()), kind)
            }
            Node::Path(path) if path.is_visible() => self.add_path((path, mask_from_user), kind),
            Node::Path(_) => true,
            Node::Image(_) | Node::Text(_) => false,
        })
    }

    fn add_path(&mut self, placed: Placed<'a>, kind: MaskType) -> bool {
        let (path, _) = placed;
        let Some(fill) = path.fill().filter(|_| path.stroke().is_none()) else { return false };
        let color = match kind {
            MaskType::Alpha if paint::is_opaque(fill.paint(), fill.opacity().get()) => Some(WHITE),
            MaskType::Alpha => None,
            MaskType::Luminance => paint::color(fill.paint(), fill.opacity().get()),
        };
        match color {
            Some(WHITE) if self.hidden.is_empty() => self.shown.push(placed),
            // Black under all that is white hides nothing.
            Some(BLACK) if self.shown.is_empty() => {}
            Some(BLACK) => self.hidden.push(placed),
            _ => return false,
        }
        true
    }
}

fn is_bare(group: &Group) -> bool {
    let is_cut = group.clip_path().is_some() || group.mask().is_some() || !group.filters().is_empty();
    !is_cut && group.opacity().get() == 1.0 && group.blend_mode() == BlendMode::Normal
}
