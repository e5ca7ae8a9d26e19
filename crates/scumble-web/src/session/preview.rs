//! Pictures that are shown until the right one is made: a rough one of the whole page, and from close by, the right one of what
//! is in view.

use std::cell::Cell;
use std::mem::replace;
use std::sync::Arc;

use kurbo::Rect;
use scumble_core::Editor;
use scumble_solve::{EVERYWHERE, Field, FieldChange};

use super::Session;
use super::close::{AHEAD, ahead, holds};
use super::making::has_colors;
use crate::solver::Source;

/// What is in view, and ahead of it, is made first where it is a smaller part of the page.
const SMALL_PART: f64 = 0.5;

/// The revision of a document. In a gesture, whose states have none, it is that before it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct State {
    pub(super) revision: u32,
    pub(super) is_in_hand: bool,
}

impl State {
    pub(super) fn of(editor: &Editor) -> Self {
        Self { revision: editor.revision(), is_in_hand: editor.is_in_hand() }
    }
}

/// The part of the plane that is to be made first, if any is.
pub(super) type Part = Cell<Option<Rect>>;

/// The colours of a part of the plane.
#[derive(Debug)]
pub(super) struct Preview {
    pub(super) state: State,
    pub(super) part_du: Rect,
    pub(super) field: Arc<Field>,
}

impl Session {
    /// What is in view, and ahead of it, where that is a small part of the page; but once alone.
    pub(super) fn part_first(&self) -> Option<Rect> {
        let part_du = ahead(self.viewport.view().seen_du(), AHEAD);
        let is_small = part_du.area() < SMALL_PART * self.document().drawing.frame().area();
        let is_there = self.previews.iter().any(|it| it.part_du != EVERYWHERE);
        (self.source == Source::Mesh && is_small && !is_there).then_some(part_du)
    }

    /// Follows the view and what there is to be seen.
    pub(super) fn refresh_preview(&mut self) {
        let preview = self.best_preview();
        if replace(&mut self.preview, preview) != preview {
            self.changed.field = FieldChange::ALL;
            self.stale.view = true;
        }
    }

    /// Whether it is as good as what else there is: a picture that was made before is the one that scribbles colour meanwhile.
    fn is_of_use(&self, preview: &Preview) -> bool {
        let is_same = preview.state == State::of(&self.sheet.editor);
        if self.sheet.is_made() { is_same } else { has_colors(self.document()) }
    }

    /// The preview that is to be shown, if any is.
    pub(super) fn preview_shown(&self) -> Option<&Field> {
        self.best_preview().map(|i| &*self.previews[i].field)
    }

    fn best_preview(&self) -> Option<usize> {
        let seen_du = self.viewport.view().seen_du();
        self.previews.iter().rposition(|it| holds(it.part_du, seen_du) && self.is_of_use(it))
    }
}
