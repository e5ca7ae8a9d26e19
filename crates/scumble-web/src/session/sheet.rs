//! The drawing in work, and those that it was opened over.

use std::mem::{replace, take};

use scumble_core::work::Item;
use scumble_core::{Document, Drawing, Editor, MapError, Work};
use scumble_solve::Picture;

use super::{Session, Stale};
use crate::effect::{Effect, SheetState};
use crate::regions::MapKey;
use crate::selection::Selection;

/// Drawings that undo can come back to.
const SHELF_SIZE: usize = 8;

/// A drawing in work, and what is derived from it.
#[derive(Debug)]
pub(super) struct Sheet {
    /// Its place among all that were opened.
    number: u32,
    /// What belongs to it without being edited here; it has no lines.
    kept: Work,
    pub(super) editor: Editor,
    pub(super) picture: Picture,
    /// The revision of the lines that the picture is made for.
    mapped: u32,
}

impl Sheet {
    pub(super) fn new(number: u32, mut work: Work) -> Result<Self, MapError> {
        let blank = Drawing::new(work.document.drawing.page);
        let drawing = replace(&mut work.document.drawing, blank);
        let editor = Editor::new(Document { drawing, ..work.document.clone() });
        let picture = Picture::new(&editor.document().drawing)?;
        Ok(Self { number, kept: work, editor, picture, mapped: 0 })
    }

    /// The work as it is. With other lines, what belongs to those that were opened is left out: their name, and what a
    /// newer version wrote for each.
    pub(super) fn work(&self) -> Work {
        let mut work = self.kept.edited(self.editor.document().clone());
        if self.editor.has_other_lines() {
            work.sample = None;
            work.unknown.forget(Item::Curve);
            work.unknown.forget(Item::ColorPoint);
        }
        work
    }

    /// Whether there are other lines than the picture is made for.
    pub(super) fn has_stale_map(&self) -> bool {
        self.mapped != self.editor.lines_revision()
    }

    /// Whether the picture serves the document as it is.
    pub(super) fn is_suited(&self) -> bool {
        !self.has_stale_map() && self.picture.suits(&self.editor.document().settings)
    }

    /// Another picture, for a revision of the lines.
    pub(super) fn take_picture(&mut self, picture: Picture, lines: u32) {
        (self.picture, self.mapped) = (picture, lines);
    }

    pub(super) fn map_key(&self) -> MapKey {
        (self.number, self.mapped, self.picture.settings().gap_closing)
    }

    pub(super) fn state(&self) -> SheetState {
        SheetState { sheet: self.number, revision: self.editor.revision() }
    }
}

/// The drawings that undo and redo come back to.
#[derive(Debug, Default)]
pub(super) struct Shelf {
    /// Those with work in them that others were opened over.
    under: Vec<Sheet>,
    /// Those that undo took away, each with the revision of the one under it then.
    over: Vec<(u32, Sheet)>,
}

impl Shelf {
    /// Whether redo brings one back: not after the one under it was changed, nor while it is.
    fn has_over(&self, under: &Editor) -> bool {
        let is_in_hand = under.is_scribbling() || under.is_changing();
        !is_in_hand && self.over.last().is_some_and(|(revision, _)| *revision == under.revision())
    }

    /// Whether redo never comes to one again, as something else was done.
    fn is_cut_off(&self, under: &Editor) -> bool {
        !under.can_redo() && self.over.last().is_some_and(|(revision, _)| *revision != under.revision())
    }
}

impl Session {
    /// Shows another drawing. The one that was there is kept if somebody worked on it.
    pub(super) fn lay_over(&mut self, sheet: Sheet) {
        let under = self.show(sheet);
        self.close_over();
        if !under.editor.can_undo() {
            return self.close(&under);
        }
        self.shelf.under.push(under);
        if self.shelf.under.len() > SHELF_SIZE {
            let oldest = self.shelf.under.remove(0);
            self.close(&oldest);
        }
    }

    /// Lets go of what redo does not come to any more.
    pub(super) fn settle_shelf(&mut self) {
        if self.shelf.is_cut_off(&self.sheet.editor) {
            self.close_over();
        }
    }

    fn close_over(&mut self) {
        for (_, sheet) in take(&mut self.shelf.over) {
            self.close(&sheet);
        }
    }

    pub(super) fn can_undo(&self) -> bool {
        self.sheet.editor.can_undo() || !self.shelf.under.is_empty()
    }

    pub(super) fn can_redo(&self) -> bool {
        self.sheet.editor.can_redo() || self.shelf.has_over(&self.sheet.editor)
    }

    fn close(&mut self, sheet: &Sheet) {
        self.tell(Effect::Closed(sheet.number));
    }

    fn show(&mut self, sheet: Sheet) -> Sheet {
        (self.held, self.making) = (None, None);
        self.select(Selection::default());
        self.viewport.show_page(sheet.editor.document().drawing.frame());
        self.stale = Stale::ALL;
        replace(&mut self.sheet, sheet)
    }

    /// Makes the picture anew where the lines are other ones; where that takes too long for a frame, once they have come to
    /// rest, step by step.
    pub(super) fn refresh_map(&mut self) {
        let is_live = self.moment().is_live(self.solver);
        let is_slow = self.sheet.editor.is_changing() && !is_live;
        if !self.sheet.has_stale_map() || is_slow || self.lacks_map() {
            return;
        }
        let Sheet { editor, .. } = &self.sheet;
        match Picture::new(&editor.document().drawing) {
            Ok(picture) => self.sheet.take_picture(picture, editor.lines_revision()),
            Err(error) => self.take_back_lines(&error),
        }
        self.scribbles_changed();
        self.stale.lines = true;
    }

    /// Takes back what makes too much of the lines.
    pub(super) fn take_back_lines(&mut self, error: &MapError) {
        let Sheet { editor, mapped, .. } = &mut self.sheet;
        *mapped = editor.lines_revision();
        editor.undo();
        self.held = None;
        self.scribbles_changed();
        self.tell(Effect::Failed(error.to_string()));
    }

    pub(super) fn undo(&mut self) {
        self.held = None;
        if self.sheet.editor.undo() {
            self.scribbles_changed();
            self.forget_missing();
        } else if let Some(sheet) = self.shelf.under.pop() {
            let over = self.show(sheet);
            self.shelf.over.push((self.sheet.editor.revision(), over));
        } else {
            return;
        }
        self.tell(Effect::Undone);
    }

    /// Goes to a place in the history of the drawing.
    pub(super) fn go_to(&mut self, place: usize) {
        self.held = None;
        if self.sheet.editor.go_to(place) {
            self.scribbles_changed();
            self.forget_missing();
        }
    }

    pub(super) fn redo(&mut self) {
        self.settle();
        // What was taken back before another drawing was opened is not done again after it.
        if self.shelf.has_over(&self.sheet.editor)
            && let Some((_, sheet)) = self.shelf.over.pop()
        {
            let under = self.show(sheet);
            self.shelf.under.push(under);
        } else if self.sheet.editor.redo() {
            self.scribbles_changed();
            self.forget_missing();
        } else {
            return;
        }
        self.tell(Effect::Redone);
    }
}
