//! The picture as it is shown from close by: what is in view of it, and a little around that.

use kurbo::Rect;
use scumble_solve::{Field, View};

use super::Session;
use crate::solver::Source;

/// What is around the view is shown as far as this part of its size, so that not each frame of a pan makes it anew.
const AROUND: f64 = 0.25;

/// A part of the field.
#[derive(Debug)]
pub(super) struct CloseUp {
    part_du: Rect,
    /// A power of two.
    px_per_du: f64,
    field: Field,
}

impl Session {
    /// The field, as it is to be seen at the zoom of the moment.
    pub(super) fn field_shown(&self) -> &Field {
        self.close_up.as_ref().map_or(&self.field, |close_up| &close_up.field)
    }

    /// Makes what is shown anew where it is of another field, or not of all that is in view.
    pub(super) fn refresh_close_up(&mut self) {
        let seen_du = seen_du(&self.viewport.view());
        let px_per_du = self.px_per_du().log2().ceil().exp2();
        let suits = |known: &CloseUp| known.px_per_du == px_per_du && known.part_du.contains_rect(seen_du);
        if self.changed.field || !self.close_up.as_ref().is_some_and(suits) {
            let part_du = seen_du.inflate(AROUND * seen_du.width(), AROUND * seen_du.height());
            let close_up = self.field_in(part_du, px_per_du);
            self.changed.field |= self.close_up.is_some() || close_up.is_some();
            self.close_up = close_up;
        }
    }

    fn field_in(&self, part_du: Rect, px_per_du: f64) -> Option<CloseUp> {
        if self.source == Source::Grid {
            return None;
        }
        let drawing = &self.sheet.editor.document().drawing;
        let field = self.sheet.picture.close_up(drawing, part_du, px_per_du)?;
        Some(CloseUp { part_du, px_per_du, field })
    }
}

/// What a view shows of the plane.
fn seen_du(view: &View) -> Rect {
    let all_px = Rect::new(0.0, 0.0, view.width_px.into(), view.height_px.into());
    view.px_from_du.inverse().transform_rect_bbox(all_px)
}
