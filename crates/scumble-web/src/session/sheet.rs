//! The drawing in work, and those that it was opened over.

use std::mem::replace;

use scumble_core::{Document, Drawing, Editor, MapError, Work, exact};
use scumble_solve::Picture;

use super::{Session, Stale};
use crate::effect::{Effect, SheetState};

/// Drawings that undo can come back to.
const SHELF_SIZE: usize = 8;

const DAMAGED: &str = "what the browser kept of the drawing is damaged; open it from a file";

/// A drawing in work, and what is derived from it.
#[derive(Debug)]
pub(super) struct Sheet {
    /// Its place among all that were opened.
    number: u32,
    /// What belongs to it without being edited here; it has no lines.
    pub(super) kept: Work,
    pub(super) editor: Editor,
    pub(super) picture: Picture,
}

impl Sheet {
    pub(super) fn new(number: u32, mut work: Work) -> Result<Self, MapError> {
        let picture = Picture::new(&work.document.drawing)?;
        let blank = Drawing::new(work.document.drawing.page);
        let drawing = replace(&mut work.document.drawing, blank);
        let editor = Editor::new(Document { drawing, ..work.document.clone() });
        Ok(Self { number, kept: work, editor, picture })
    }

    pub(super) fn state(&self) -> SheetState {
        SheetState { sheet: self.number, revision: self.editor.revision() }
    }
}

impl Session {
    pub(super) fn open(&mut self, work: &[u8], notes: String) {
        let Some(work) = exact::read(work) else {
            return self.tell(Effect::Failed(DAMAGED.into()));
        };
        match Sheet::new(self.opened + 1, work) {
            Ok(sheet) => self.lay_over(sheet),
            Err(error) => return self.tell(Effect::Failed(error.to_string())),
        }
        self.opened += 1;
        self.tell(Effect::Opened { notes });
    }

    /// Shows another drawing. The one that was there is kept if somebody worked on it.
    fn lay_over(&mut self, sheet: Sheet) {
        let under = self.show(sheet);
        if !under.editor.can_undo() {
            return self.close(&under);
        }
        self.shelf.push(under);
        if self.shelf.len() > SHELF_SIZE {
            let oldest = self.shelf.remove(0);
            self.close(&oldest);
        }
    }

    fn close(&mut self, sheet: &Sheet) {
        self.tell(Effect::Closed(sheet.number));
    }

    fn show(&mut self, sheet: Sheet) -> Sheet {
        self.held = None;
        self.viewport.show_page(sheet.editor.document().drawing.frame());
        self.stale = Stale::ALL;
        replace(&mut self.sheet, sheet)
    }

    pub(super) fn undo(&mut self) {
        self.held = None;
        if self.sheet.editor.undo() {
            self.scribbles_changed();
        } else if let Some(sheet) = self.shelf.pop() {
            let over = self.show(sheet);
            self.close(&over);
        } else {
            return;
        }
        self.tell(Effect::Undone);
    }

    pub(super) fn redo(&mut self) {
        if self.sheet.editor.redo() {
            self.tell(Effect::Redone);
            self.scribbles_changed();
        }
    }
}
