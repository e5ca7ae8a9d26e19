//! The document that a person works on, the gestures that change it, and their undoing.
//!
//! One gesture is one transaction: begun, carried on, then committed or aborted. Undo goes back by whole gestures.

use kurbo::Point;

use crate::color::Blend;
use crate::drawing::Drawing;
use crate::scribble::Scribble;

/// The source of a picture. Everything else is derived from it.
#[derive(Clone, Debug)]
pub struct Document {
    /// The lines.
    pub drawing: Drawing,
    /// The scribbles, in drawing order.
    pub scribbles: Vec<Scribble>,
    /// The space in which colours are blended.
    pub blend: Blend,
}

impl Document {
    /// A drawing without colour.
    pub fn new(drawing: Drawing) -> Self {
        Self { drawing, scribbles: Vec::new(), blend: Blend::default() }
    }
}

/// A change of a document; applying it gives the change that takes it back.
#[derive(Clone, Debug)]
enum Change {
    AddScribble(Scribble),
    RemoveLastScribble,
    SetBlend(Blend),
}

/// A document, the scribble in hand, and the way back and forth through its changes.
#[derive(Clone, Debug)]
pub struct Editor {
    document: Document,
    in_hand: bool,
    undo: Vec<Change>,
    redo: Vec<Change>,
}

impl Editor {
    /// Opens a document, with nothing to undo.
    pub fn new(document: Document) -> Self {
        Self { document, in_hand: false, undo: Vec::new(), redo: Vec::new() }
    }

    /// The document with the scribble in hand, if any, as its last.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// Begins a scribble; one that is still in hand is committed first.
    pub fn begin_scribble(&mut self, scribble: Scribble) {
        self.commit();
        self.in_hand = true;
        self.document.scribbles.push(scribble);
    }

    /// Carries the scribble in hand on, through points in du. Points that are not finite are left out.
    pub fn extend_scribble(&mut self, points: &[Point]) {
        if let (true, Some(scribble)) = (self.in_hand, self.document.scribbles.last_mut()) {
            scribble.points.extend(points.iter().copied().filter(|p| p.is_finite()));
        }
    }

    /// Whether a scribble is in hand.
    pub fn is_scribbling(&self) -> bool {
        self.in_hand
    }

    /// Ends the gesture and keeps what it did.
    pub fn commit(&mut self) {
        if std::mem::take(&mut self.in_hand) {
            self.undo.push(Change::RemoveLastScribble);
            self.redo.clear();
        }
    }

    /// Ends the gesture and leaves the document as it was before it.
    pub fn abort(&mut self) {
        if std::mem::take(&mut self.in_hand) {
            self.document.scribbles.pop();
        }
    }

    /// Sets the blend space of the drawing.
    pub fn set_blend(&mut self, blend: Blend) {
        self.commit();
        if blend != self.document.blend {
            let back = self.apply(Change::SetBlend(blend));
            self.undo.push(back);
            self.redo.clear();
        }
    }

    /// Takes the last gesture back, or drops the one in hand; `false` where there is none.
    pub fn undo(&mut self) -> bool {
        if self.in_hand {
            self.abort();
            return true;
        }
        let Some(change) = self.undo.pop() else { return false };
        let forth = self.apply(change);
        self.redo.push(forth);
        true
    }

    /// Does again what was taken back last; `false` where there is nothing.
    pub fn redo(&mut self) -> bool {
        if self.in_hand {
            return false;
        }
        let Some(change) = self.redo.pop() else { return false };
        let back = self.apply(change);
        self.undo.push(back);
        true
    }

    /// Whether [`Editor::undo`] has something to take back.
    pub fn can_undo(&self) -> bool {
        self.in_hand || !self.undo.is_empty()
    }

    /// Whether [`Editor::redo`] has something to do again.
    pub fn can_redo(&self) -> bool {
        !self.in_hand && !self.redo.is_empty()
    }

    fn apply(&mut self, change: Change) -> Change {
        match change {
            Change::AddScribble(scribble) => {
                self.document.scribbles.push(scribble);
                Change::RemoveLastScribble
            }
            Change::RemoveLastScribble => match self.document.scribbles.pop() {
                Some(scribble) => Change::AddScribble(scribble),
                None => Change::RemoveLastScribble,
            },
            Change::SetBlend(blend) => Change::SetBlend(std::mem::replace(&mut self.document.blend, blend)),
        }
    }
}
