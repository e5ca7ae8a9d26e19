//! Pictures that are shown until the right one is made: a rough one of the whole page, and from close by, the right one of what
//! is in view.

use std::mem::{replace, take};
use std::sync::Arc;

use kurbo::Rect;
use scumble_solve::{EVERYWHERE, Field, FieldChange, Picture};

use super::Session;
use super::close::{AHEAD, ahead, holds};
use super::making::has_colors;
use crate::effect::Wanted;
use crate::solver::Source;

/// What is in view, and ahead of it, is made first where it is a smaller part of the page.
const SMALL_PART: f64 = 0.5;

/// The colours of a part of the plane.
#[derive(Debug)]
pub(super) struct Preview {
    /// How often colours had changed until it was begun.
    colorings: u32,
    part_du: Rect,
    field: Arc<Field>,
}

impl Session {
    /// What is in view, and ahead of it, where that is a small part of the page and has not been made yet. The picture that is
    /// made must be for the colours as they are: else the next one may end as this one, and the whole never comes.
    pub(super) fn part_first(&self) -> Option<Rect> {
        let is_current = self.making.as_ref()?.colorings == self.colorings;
        let part_du = ahead(self.viewport.view().seen_du(), AHEAD);
        let is_small = part_du.area() < SMALL_PART * self.document().drawing.frame().area();
        let is_there = self.previews.iter().any(|it| it.part_du != EVERYWHERE);
        (is_current && is_small && !is_there && self.source != Source::Grid).then_some(part_du)
    }

    /// Takes a preview out of a picture. From close by, curves bend in it as they will.
    pub(super) fn take_preview(&mut self, picture: &mut Picture, colorings: u32) {
        let part_du = picture.part_du().filter(|_| !picture.map().is_rough());
        let close_up = part_du.and_then(|part_du| self.close_up_of(picture, part_du));
        if let Some((part_du, field)) = picture.complete() {
            let field = close_up.map_or(field, Arc::new);
            self.previews.push(Preview { colorings, part_du, field });
        }
    }

    /// Follows the view, and what colours the picture; lets go of what is not made, or shown, any more.
    pub(super) fn refresh_previews(&mut self) {
        if self.wanted() == Wanted::Nothing {
            self.making = None;
        }
        let mut previews = take(&mut self.previews);
        let count = previews.len();
        previews.retain(|preview| self.is_of_use(preview));
        let is_any_gone = previews.len() < count;
        self.previews = previews;
        let best = self.best_preview();
        if replace(&mut self.preview, best) != best || is_any_gone {
            self.changed.field = FieldChange::ALL;
            self.stale.view = true;
        }
    }

    /// Whether it is as good as what else there is: a picture that was made before is the one that scribbles colour meanwhile.
    fn is_of_use(&self, preview: &Preview) -> bool {
        if self.sheet.is_made() { preview.colorings == self.colorings } else { has_colors(self.document()) }
    }

    /// The preview that is to be shown, if any is.
    pub(super) fn preview_shown(&self) -> Option<&Field> {
        self.best_preview().map(|i| &*self.previews[i].field)
    }

    fn best_preview(&self) -> Option<usize> {
        let seen_du = self.viewport.view().seen_du();
        let serves = |it: &Preview| self.source != Source::Grid && holds(it.part_du, seen_du);
        self.previews.iter().rposition(serves)
    }
}
