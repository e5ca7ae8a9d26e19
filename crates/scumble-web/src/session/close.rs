//! The picture from close by, where the pieces of curves would be seen as chords.

use kurbo::Rect;
use scumble_solve::{EVERYWHERE, Field, FieldChange, Picture};

use super::Session;
use crate::solver::Source;

/// Pieces are less than this off their curves, in du.
pub(super) const CHORDS_OFF_DU: f64 = 1.0;

/// What is seen is followed so much farther on each side, as a part of its size, for the next steps of a pan.
pub(super) const AHEAD: f64 = 0.25;

/// The colour field of a part of the page, for views up to a scale.
#[derive(Debug)]
pub(super) struct CloseUp {
    part_du: Rect,
    px_per_du: f64,
    field: Field,
}

impl Session {
    /// The colours as they are seen at the scale of the canvas, or until they are made, a preview of them.
    pub(super) fn field_shown(&self) -> Option<&Field> {
        let close_up = || self.close_up.as_ref().map(|close_up| &close_up.field);
        let whole = || self.sheet.picture.field().map(|field| &**field);
        self.preview_shown().or_else(close_up).or_else(whole)
    }

    /// Follows the colours and the view. The part stays as long as it serves, so that what is seen does not change under a
    /// pan.
    pub(super) fn refresh_close_up(&mut self) {
        let (seen_du, px_per_du) = (self.viewport.view().seen_du(), self.close_scale());
        let serves = |it: &CloseUp| it.px_per_du == px_per_du && holds(it.part_du, seen_du);
        let part_du = self.close_up.as_ref().filter(|it| serves(it)).map(|it| it.part_du);
        let is_wanted = self.source == Source::Mesh && !self.sheet.has_stale_map();
        if is_wanted && part_du.is_some() && !self.changed.field.is_any() {
            return;
        }
        let ahead_du = ahead(seen_du, AHEAD);
        let close_up = is_wanted.then(|| self.made_close_up(part_du.unwrap_or(ahead_du))).flatten();
        let is_same_part = close_up.is_some() && part_du.is_some();
        if close_up.is_some() || self.close_up.is_some() {
            let within_du = (!is_same_part).then_some(EVERYWHERE);
            self.changed.field.add(FieldChange { within_du, ..FieldChange::ALL });
            self.stale.view = true;
        }
        self.close_up = close_up;
    }

    fn made_close_up(&self, part_du: Rect) -> Option<CloseUp> {
        let field = self.close_up_of(&self.sheet.picture, part_du)?;
        Some(CloseUp { part_du, px_per_du: self.close_scale(), field })
    }

    /// A part of a picture of the drawing, where it is seen from close by.
    pub(super) fn close_up_of(&self, picture: &Picture, part_du: Rect) -> Option<Field> {
        picture.close_up(&self.document().drawing, part_du, self.close_scale())
    }

    /// Close-ups are made for so many device pixels of one du.
    fn close_scale(&self) -> f64 {
        next_double(self.px_per_du())
    }
}

/// What is seen, and so much around it, as a part of its size.
pub(super) fn ahead(seen_du: Rect, by: f64) -> Rect {
    seen_du.inflate(by * seen_du.width(), by * seen_du.height())
}

/// Whether one part of the plane lies within another.
pub(super) fn holds(all_du: Rect, part_du: Rect) -> bool {
    all_du.union(part_du) == all_du
}

/// The least power of two that a scale does not exceed: what is made at it serves all scales down to half of it.
fn next_double(scale: f64) -> f64 {
    scale.log2().ceil().exp2()
}
