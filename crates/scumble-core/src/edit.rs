//! The document that a person works on, the gestures that change it, and their undoing.
//!
//! One gesture is one transaction: begun, carried on, then committed or aborted. Undo goes back by whole gestures. A
//! change outside of a gesture is a gesture of its own.

use kurbo::Point;

use crate::color::Paint;
use crate::color_points::ColorPoint;
use crate::drawing::{Curve, Drawing};
use crate::palette::Swatch;
use crate::scribble::{Scribble, ScribbleKind};
use crate::settings::Settings;
use crate::sort;
use crate::tracing::Tracing;
use change::{Back, Change, Ids, apply};

mod change;
mod deed;

pub use deed::{Deed, Entry};

/// The source of a picture, from which everything else is derived, and what is at hand: the palette, a picture to trace.
#[derive(Clone, Debug)]
pub struct Document {
    /// The lines.
    pub drawing: Drawing,
    /// The scribbles, in drawing order.
    pub scribbles: Vec<Scribble>,
    /// The colours set by hand, in whatever order.
    pub color_points: Vec<ColorPoint>,
    /// How it is coloured.
    pub settings: Settings,
    /// The swatches of its palette.
    pub palette: Vec<Swatch>,
    /// The picture under the lines.
    pub tracing: Option<Tracing>,
}

impl Document {
    /// A drawing without colour.
    pub fn new(drawing: Drawing) -> Self {
        Self {
            drawing,
            scribbles: Vec::new(),
            color_points: Vec::new(),
            settings: Settings::default(),
            palette: Vec::new(),
            tracing: None,
        }
    }
}

/// A gesture that has been begun and not yet ended.
#[derive(Clone, Debug)]
enum Gesture {
    /// The last scribble of the document is being drawn.
    Scribble,
    /// What it does, and what takes that back.
    Changes(Deed, Back),
}

/// A document, the gesture in hand, and the way back and forth through its changes.
#[derive(Clone, Debug)]
pub struct Editor {
    document: Document,
    ids: Ids,
    in_hand: Option<Gesture>,
    /// What takes each gesture back.
    undo: Vec<Step>,
    /// What does each gesture again that was taken back.
    redo: Vec<Step>,
    /// Those of the state between gestures.
    revisions: Revisions,
    lines_revision: u32,
    /// The last ones that were given.
    last: Revisions,
}

/// What tells states from each other.
#[derive(Clone, Copy, Debug, Default)]
struct Revisions {
    document: u32,
    lines: u32,
}

/// Changes, to be applied from the last to the first, and the revisions that they lead to.
#[derive(Clone, Debug)]
struct Step {
    /// What was done, whether this does it again or takes it back.
    entry: Entry,
    changes: Vec<Change>,
    to: Revisions,
}

impl Editor {
    /// Opens a document, with nothing to undo. Here as in all gestures, numbers become those that files hold.
    pub fn new(document: Document) -> Self {
        let document = document.kept();
        Self {
            ids: Ids::of(&document),
            document,
            in_hand: None,
            undo: Vec::new(),
            redo: Vec::new(),
            revisions: Revisions::default(),
            lines_revision: 0,
            last: Revisions::default(),
        }
    }

    /// Tells the states of the document between gestures apart: 0 as it was opened, and the same again where undo has
    /// come back to it.
    pub fn revision(&self) -> u32 {
        self.revisions.document
    }

    /// Tells the states of the lines apart, also within gestures: the same again where undo has come back to them.
    pub fn lines_revision(&self) -> u32 {
        self.lines_revision
    }

    /// Whether the lines may be other ones than those that were opened.
    pub fn has_other_lines(&self) -> bool {
        let in_hand = match &self.in_hand {
            Some(Gesture::Changes(_, back)) => back.changes.as_slice(),
            _ => &[],
        };
        self.undo.iter().flat_map(|step| &step.changes).chain(in_hand).any(Change::is_of_lines)
    }

    /// The document with what the gesture in hand has made of it; a scribble in hand is its last.
    pub fn document(&self) -> &Document {
        &self.document
    }

    /// For each scribble of the document a number that stays its own, whatever becomes of it, through undo and redo.
    pub fn scribble_ids(&self) -> &[u32] {
        &self.ids.scribbles
    }

    /// The same for its curves; no scribble has the number of a curve.
    pub fn curve_ids(&self) -> &[u32] {
        &self.ids.curves
    }

    /// Begins a scribble; a gesture that is still in hand is committed first.
    pub fn begin_scribble(&mut self, scribble: Scribble) {
        self.commit();
        self.in_hand = Some(Gesture::Scribble);
        let id = self.ids.fresh();
        self.ids.scribbles.push(id);
        self.document.scribbles.push(scribble.kept());
    }

    /// Gives the scribble in hand another way, through points in du, and a kind, as a pen does by how hard it presses.
    /// Nothing happens where there are no points, or one is not finite.
    pub fn draw_scribble(&mut self, points: Vec<Point>, kind: ScribbleKind) {
        let is_way = !points.is_empty() && points.iter().all(|p| p.is_finite());
        if let (true, true, Some(scribble)) =
            (is_way, self.is_scribbling(), self.document.scribbles.last_mut())
        {
            *scribble = Scribble { points, kind, ..*scribble }.kept();
        }
    }

    /// Whether a scribble is in hand.
    pub fn is_scribbling(&self) -> bool {
        matches!(self.in_hand, Some(Gesture::Scribble))
    }

    /// Whether a gesture of any kind is in hand.
    pub fn is_in_hand(&self) -> bool {
        self.in_hand.is_some()
    }

    /// Begins a gesture of any changes, as of a slider that is dragged; one that is still in hand is committed first.
    pub fn begin(&mut self, deed: Deed) {
        self.commit();
        self.in_hand = Some(Gesture::Changes(deed, Back::default()));
    }

    /// Whether a gesture of any changes is in hand.
    pub fn is_changing(&self) -> bool {
        matches!(self.in_hand, Some(Gesture::Changes(..)))
    }

    /// Whether such a gesture has given the drawing other lines.
    pub fn is_changing_lines(&self) -> bool {
        matches!(&self.in_hand, Some(Gesture::Changes(_, back)) if back.changes.iter().any(Change::is_of_lines))
    }

    /// What such a gesture does that is in hand.
    pub fn deed_in_hand(&self) -> Option<Deed> {
        match self.in_hand {
            Some(Gesture::Changes(deed, _)) => Some(deed),
            _ => None,
        }
    }

    /// Takes back what a gesture of any changes has done so far; it goes on from where it began.
    pub fn restart(&mut self) {
        if let Some(Gesture::Changes(_, back)) = &mut self.in_hand {
            let back = std::mem::take(back);
            self.take_back(back.changes);
        }
    }

    /// Ends the gesture and keeps what it did.
    pub fn commit(&mut self) {
        match self.in_hand.take() {
            None => {}
            Some(Gesture::Scribble) => {
                let last = self.document.scribbles.len() - 1;
                let deed = Deed::of_scribble(&self.document.scribbles[last]);
                self.keep(deed, vec![Change::RemoveScribble(last)]);
            }
            Some(Gesture::Changes(deed, Back { mut changes, .. })) => {
                // A slider that was dragged to and fro has changed nothing in the end.
                changes.retain(|change| !change.is_so(&self.document));
                self.keep(deed, changes);
            }
        }
    }

    /// Ends the gesture and leaves the document as it was before it.
    pub fn abort(&mut self) {
        match self.in_hand.take() {
            None => {}
            Some(Gesture::Scribble) => {
                drop(self.apply(Change::RemoveScribble(self.document.scribbles.len() - 1)));
            }
            Some(Gesture::Changes(_, back)) => self.take_back(back.changes),
        }
    }

    /// Sets how the drawing is coloured; numbers out of range are clamped.
    pub fn set_settings(&mut self, settings: Settings) {
        let settings = settings.clamped();
        self.commit_scribble();
        let before = self.document.settings;
        if settings != before {
            self.change(Deed::of_settings(before, settings), Change::SetSettings(settings));
        }
    }

    /// Puts another palette in the place of the one at hand.
    pub fn set_palette(&mut self, palette: Vec<Swatch>) {
        self.commit_scribble();
        if palette != self.document.palette {
            let deed = Deed::of_palette(&self.document.palette, &palette);
            self.change(deed, Change::SetPalette(palette));
        }
    }

    /// Puts one colour in the place of another wherever it was painted, by a scribble or by hand.
    pub fn repaint(&mut self, from: Paint, to: Paint) {
        self.commit_scribble();
        if from == to {
            return;
        }
        let Document { scribbles, color_points, .. } = &self.document;
        let scribbles = scribbles.iter().zip(0..).filter(|(scribble, _)| scribble.color == from);
        let points = color_points.iter().zip(0..).filter(|(point, _)| point.color == from);
        let scribbles = scribbles.map(|(_, i)| Change::RecolorScribble(i, to));
        let changes: Vec<_> = scribbles.chain(points.map(|(_, i)| Change::RecolorPoint(i, to))).collect();
        let back = changes.into_iter().map(|change| self.apply(change)).collect();
        self.done(Deed::Repainted, back);
    }

    /// Lays another picture under the lines, or the same one otherwise, or takes it away; an opacity out of range is
    /// clamped.
    pub fn set_tracing(&mut self, tracing: Option<Tracing>) {
        let tracing = tracing.map(Tracing::clamped);
        self.commit_scribble();
        let before = self.document.tracing;
        if tracing != before {
            self.change(Deed::of_tracing(before, tracing), Change::SetTracing(tracing));
        }
    }

    /// Erases scribbles by their indices, in whatever order; returns how many there were of them.
    pub fn erase_scribbles(&mut self, indices: &[usize]) -> usize {
        self.commit_scribble();
        let mut indices: Vec<_> =
            indices.iter().copied().filter(|i| *i < self.document.scribbles.len()).collect();
        sort::sort_copies_by_key(&mut indices, |index| *index as u64);
        indices.dedup();
        let back: Vec<_> = indices.iter().rev().map(|i| self.apply(Change::RemoveScribble(*i))).collect();
        self.done(Deed::Erased, back);
        indices.len()
    }

    /// Gives a scribble another colour, or none; nothing happens where there is no scribble of this index.
    pub fn recolor_scribble(&mut self, index: usize, color: Paint) {
        self.commit_scribble();
        if self.document.scribbles.get(index).is_some_and(|scribble| scribble.color != color) {
            self.change(Deed::Recolored, Change::RecolorScribble(index, color));
        }
    }

    /// Puts a scribble into the order, at an index, after which those behind it come; at the end where that is none.
    pub fn insert_scribble(&mut self, index: usize, scribble: Scribble) {
        self.commit_scribble();
        let id = self.ids.fresh();
        let (index, scribble) = (index.min(self.document.scribbles.len()), scribble.kept());
        self.change(Deed::of_scribble(&scribble), Change::InsertScribble(index, id, scribble));
    }

    /// Puts another scribble in the place of one, which takes over its number; nothing happens where there is none of this
    /// index, or it is the same.
    pub fn replace_scribble(&mut self, index: usize, scribble: Scribble) {
        self.commit_scribble();
        let scribble = scribble.kept();
        if self.document.scribbles.get(index).is_some_and(|before| *before != scribble) {
            self.change(Deed::Moved, Change::ReplaceScribble(index, scribble));
        }
    }

    /// Puts another curve in the place of one, as [`Editor::replace_scribble`] does. Colours set by hand stay where they
    /// are along it.
    pub fn replace_curve(&mut self, index: usize, curve: Curve) {
        self.commit_scribble();
        let curve = curve.kept();
        if self.document.drawing.curves.get(index).is_some_and(|before| *before != curve) {
            self.change(Deed::Moved, Change::ReplaceCurve(index, curve));
        }
    }

    /// Takes a curve away, with the colours that were set by hand along it; nothing happens where there is none of this
    /// index.
    pub fn remove_curve(&mut self, index: usize) {
        self.commit_scribble();
        if index < self.document.drawing.curves.len() {
            self.change(Deed::Deleted, Change::RemoveCurve(index));
        }
    }

    /// Takes a scribble out of the order and puts it back in at an index, after which those behind it come; nothing
    /// happens where either index is that of no scribble.
    pub fn move_scribble(&mut self, from: usize, to: usize) {
        self.commit_scribble();
        if from != to && from.max(to) < self.document.scribbles.len() {
            let deed = if to > from { Deed::Forward } else { Deed::Backward };
            self.change(deed, Change::MoveScribble { from, to });
        }
    }

    /// Takes the last gesture back, or drops the one in hand; `false` where there is none.
    pub fn undo(&mut self) -> bool {
        let has_done = self.has_done();
        self.abort();
        if has_done {
            return true;
        }
        let Some(back) = self.undo.pop() else { return false };
        let forth = self.step(back);
        self.redo.push(forth);
        true
    }

    /// Does again what was taken back last; `false` where there is nothing.
    pub fn redo(&mut self) -> bool {
        if self.in_hand.is_some() {
            return false;
        }
        let Some(forth) = self.redo.pop() else { return false };
        let back = self.step(forth);
        self.undo.push(back);
        true
    }

    /// The gestures that were kept, the first one first, also those that were taken back and can be done again.
    pub fn history(&self) -> impl Iterator<Item = Entry> {
        self.undo.iter().chain(self.redo.iter().rev()).map(|step| step.entry)
    }

    /// How many of [`Editor::history`] are not taken back.
    pub fn place(&self) -> usize {
        self.undo.len()
    }

    /// Takes back and does again, until so many of [`Editor::history`] are not taken back; as many as there are, if they are
    /// fewer. A gesture in hand is committed first. Returns whether it has come to another place.
    pub fn go_to(&mut self, place: usize) -> bool {
        self.commit();
        let before = self.place();
        while self.place() > place && self.undo() {}
        while self.place() < place && self.redo() {}
        self.place() != before
    }

    /// Whether [`Editor::undo`] has something to take back.
    pub fn can_undo(&self) -> bool {
        self.has_done() || !self.undo.is_empty()
    }

    /// Whether [`Editor::redo`] has something to do again.
    pub fn can_redo(&self) -> bool {
        self.in_hand.is_none() && !self.redo.is_empty()
    }

    /// Whether there is a gesture in hand that has left its mark.
    fn has_done(&self) -> bool {
        match &self.in_hand {
            None => false,
            Some(Gesture::Scribble) => true,
            Some(Gesture::Changes(_, back)) => {
                back.changes.iter().any(|change| !change.is_so(&self.document))
            }
        }
    }

    fn commit_scribble(&mut self) {
        if self.is_scribbling() {
            self.commit();
        }
    }

    /// Makes a change, in the gesture in hand or as one of its own, which does what is said.
    fn change(&mut self, deed: Deed, change: Change) {
        let back = self.apply(change);
        self.done(deed, vec![back]);
    }

    /// Notes what takes back that which has just been done.
    fn done(&mut self, deed: Deed, back: Vec<Change>) {
        match &mut self.in_hand {
            Some(Gesture::Changes(_, before)) => back.into_iter().for_each(|change| before.push(change)),
            _ => self.keep(deed, back),
        }
    }

    /// Ends a gesture that can be taken back; one that did nothing leaves no trace.
    fn keep(&mut self, deed: Deed, back: Vec<Change>) {
        if !back.is_empty() {
            let entry = Entry { deed, paint: change::paint(&back, &self.document) };
            self.undo.push(Step { entry, changes: back, to: self.revisions });
            self.redo.clear();
            self.last.document += 1;
            self.revisions = Revisions { document: self.last.document, lines: self.lines_revision };
        }
    }

    /// Takes back what the gesture in hand has done.
    fn take_back(&mut self, back: Vec<Change>) {
        self.apply_all(back);
        self.lines_revision = self.revisions.lines;
    }

    /// Takes a step; returns the one back.
    fn step(&mut self, Step { entry, changes, to }: Step) -> Step {
        let changes = self.apply_all(changes);
        self.lines_revision = to.lines;
        Step { entry, changes, to: std::mem::replace(&mut self.revisions, to) }
    }

    /// Applies changes from the last to the first; returns those that take them back, to be applied likewise.
    fn apply_all(&mut self, changes: Vec<Change>) -> Vec<Change> {
        changes.into_iter().rev().map(|change| self.apply(change)).collect()
    }

    fn apply(&mut self, change: Change) -> Change {
        if change.is_of_lines() {
            self.last.lines += 1;
            self.lines_revision = self.last.lines;
        }
        apply(&mut self.document, &mut self.ids, change)
    }
}
