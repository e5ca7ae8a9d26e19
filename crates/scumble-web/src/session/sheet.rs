//! The drawing in work, and those that it was opened over.

use std::mem::{replace, take};

use scumble_core::work::Item;
use scumble_core::{Document, Drawing, Editor, MapError, PlanarMap, Work};
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
    /// The revision of the lines that the picture is made for; none where it is but a blank page so far.
    mapped: Option<u32>,
    /// The pieces of the largest map that it has had.
    pub(super) most_pieces: usize,
}

impl Sheet {
    pub(super) fn new(number: u32, mut work: Work, picture: Picture) -> Self {
        let blank = Drawing::new(work.document.drawing.page);
        let drawing = replace(&mut work.document.drawing, blank);
        let editor = Editor::new(Document { drawing, ..work.document.clone() });
        let most_pieces = picture.map().pieces().len();
        Self { number, kept: work, editor, picture, mapped: Some(0), most_pieces }
    }

    /// Work whose picture is to be made while it is shown.
    ///
    /// # Errors
    /// Where even a blank page has no map.
    pub(super) fn unmade(number: u32, work: Work) -> Result<Self, MapError> {
        let picture = Picture::new(&Drawing::new(work.document.drawing.page))?;
        Ok(Self { mapped: None, ..Self::new(number, work, picture) })
    }

    /// Whether the picture has ever been made.
    pub(super) fn is_made(&self) -> bool {
        self.mapped.is_some()
    }

    /// The map by which solid ink is drawn, once there is one.
    pub(super) fn ink_map(&self) -> Option<&PlanarMap> {
        self.is_made().then(|| self.picture.map())
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
        self.mapped != Some(self.editor.lines_revision())
    }

    /// Whether the picture serves the document as it is.
    pub(super) fn is_suited(&self) -> bool {
        !self.has_stale_map() && self.picture.suits(&self.editor.document().settings)
    }

    /// Another picture, for a revision of the lines.
    pub(super) fn take_picture(&mut self, picture: Picture, lines: u32) {
        self.most_pieces = self.most_pieces.max(picture.map().pieces().len());
        (self.picture, self.mapped) = (picture, Some(lines));
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
    /// Those that others were opened over: with work in them, or under one whose picture is not made yet.
    under: Vec<Sheet>,
    /// Those that undo took away, each with the revision of the one under it then.
    over: Vec<(u32, Sheet)>,
}

impl Shelf {
    /// Whether redo brings one back: not after the one under it was changed, nor while it is.
    fn has_over(&self, under: &Editor) -> bool {
        !under.is_in_hand() && self.over.last().is_some_and(|(revision, _)| *revision == under.revision())
    }

    /// Whether redo never comes to one again, as something else was done.
    fn is_cut_off(&self, under: &Editor) -> bool {
        !under.can_redo() && self.over.last().is_some_and(|(revision, _)| *revision != under.revision())
    }
}

impl Session {
    /// Shows another drawing.
    pub(super) fn lay_over(&mut self, sheet: Sheet) {
        let under = self.show(sheet);
        self.close_over();
        self.shelf.under.push(under);
        self.settle_shelf();
    }

    /// Lets go of what neither undo nor redo comes to any more.
    pub(super) fn settle_shelf(&mut self) {
        if self.shelf.is_cut_off(&self.sheet.editor) {
            self.close_over();
        }
        let mut is_over_unmade = !self.sheet.is_made();
        for i in (0..self.shelf.under.len()).rev() {
            let sheet = &self.shelf.under[i];
            // What is not made yet can be left for the one under it, whether somebody worked on that or not.
            let is_kept = sheet.editor.can_undo() || is_over_unmade;
            is_over_unmade = is_kept && !sheet.is_made();
            if !is_kept || i + SHELF_SIZE < self.shelf.under.len() {
                let sheet = self.shelf.under.remove(i);
                self.close(&sheet);
            }
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
        self.show_other();
        self.stale = Stale::ALL;
        let before = replace(&mut self.sheet, sheet);
        if self.lacks_map() {
            let settings = *self.sheet.picture.settings();
            self.sheet.picture.color(&[], &[], &settings);
        }
        before
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
            Err(error) => self.take_back(&error),
        }
        self.scribbles_changed();
        self.stale.lines = true;
    }

    /// Takes back what made too much of the lines: what was done to them, or the drawing.
    pub(super) fn take_back(&mut self, error: &MapError) {
        if self.sheet.is_made() { self.take_back_lines(error) } else { self.close_unmade(error) }
    }

    /// Takes back the lines that are too many, with all that was done since.
    fn take_back_lines(&mut self, error: &MapError) {
        let Sheet { editor, mapped, .. } = &mut self.sheet;
        let too_many = editor.lines_revision();
        *mapped = Some(too_many);
        while editor.lines_revision() == too_many && editor.undo() {}
        self.held = None;
        self.scribbles_changed();
        self.forget_missing();
        self.tell(Effect::Failed(error.to_string()));
    }

    /// Closes a drawing that is shown and has no map. It stays, without one, where there is none under it.
    fn close_unmade(&mut self, error: &MapError) {
        let Sheet { number, editor, mapped, .. } = &mut self.sheet;
        *mapped = Some(editor.lines_revision());
        let unopened = Effect::Unopened(*number, error.to_string());
        if self.take_off() {
            self.close_over();
        }
        self.tell(unopened);
    }

    /// Shows the drawing under this one, if there is any; redo comes back to this one.
    pub(super) fn take_off(&mut self) -> bool {
        let Some(under) = self.shelf.under.pop() else { return false };
        let over = self.show(under);
        self.shelf.over.push((self.sheet.editor.revision(), over));
        true
    }

    pub(super) fn undo(&mut self) {
        self.held = None;
        if self.sheet.editor.undo() {
            self.scribbles_changed();
            self.forget_missing();
        } else if !self.take_off() {
            return;
        }
        self.tell(Effect::Undone);
    }

    /// Goes to a place in the history of the drawing.
    pub(super) fn go_to(&mut self, place: usize) {
        self.held = None;
        self.commit();
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
