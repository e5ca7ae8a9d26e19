//! What is in view, for the grid solver, where pixels of the whole page would be seen.

use kurbo::Rect;
use scumble_core::Bends;
use scumble_core::drawing::LONGER_SIDE_DU;
use scumble_solve::grid::{AROUND_PX, GridProblem};

use super::Session;
use super::close::{ahead, holds};
use crate::painting::part_px;
use crate::solver::{HALF_STEP, WHOLE_PX};

/// What is seen is followed so much farther on each side, as a part of its size, for the next steps of a pan.
const AHEAD: f64 = 0.125;

/// A part of the page.
#[derive(Debug)]
pub(super) struct Sharp {
    pub(super) problem: GridProblem,
    px_per_du: f64,
    /// It serves while what is seen lies within.
    within_du: Rect,
}

impl Session {
    /// Pixels of one du: of the grid of the whole page, and of that of a part in view where its pixels are smaller by so much
    /// that it is solved, too; the whole may have fewer then.
    pub(super) fn grid_scales(&self) -> (f64, Option<f64>) {
        let (moment, haste) = (self.moment(), self.haste());
        let whole = moment.grid_scale(self.solver) / haste;
        let few = whole.min(WHOLE_PX / LONGER_SIDE_DU / haste);
        let ahead_du = ahead(self.viewport.view().seen_du(), AHEAD);
        let side_du = ahead_du.width().max(ahead_du.height()) + 2.0 * AROUND_PX / few;
        let part = moment.part_scale(self.solver, side_du) / haste;
        if part > HALF_STEP * whole { (few, Some(part)) } else { (whole, None) }
    }

    /// Follows the view with a part at a scale. It stays as long as it serves, and all parts have the same pixels, so that
    /// nothing that is seen shifts under a pan.
    pub(super) fn refresh_sharp(&mut self, px_per_du: Option<f64>) {
        let page_du = self.document().drawing.frame();
        let seen_du = self.viewport.view().seen_du();
        let within_du = ahead(seen_du, AHEAD).intersect(page_du);
        let serves =
            |it: &Sharp| Some(it.px_per_du) == px_per_du && holds(it.within_du, seen_du.intersect(page_du));
        if self.sharp.as_ref().map_or(px_per_du.is_none(), serves) {
            return;
        }
        let sharp = px_per_du.and_then(|px_per_du| self.made_sharp(within_du, px_per_du));
        if sharp.is_some() || self.sharp.is_some() {
            self.changed.part = true;
            self.changed.add_everywhere();
            self.stale.view = true;
        }
        self.sharp = sharp;
    }

    fn made_sharp(&self, within_du: Rect, px_per_du: f64) -> Option<Sharp> {
        let (whole, page) = (self.problem.as_ref()?, self.page(px_per_du));
        let around_du = AROUND_PX / whole.view.px_from_du.as_coeffs()[0];
        let part_du = within_du.inflate(around_du, around_du);
        let (view, picture) = (page.part(&part_px(part_du, &page)?), &self.sheet.picture);
        // Lines that have gone on from their map bend elsewhere. Edges are as sharp as the canvas', however wide the pixels are.
        let bends = if self.sheet.has_stale_map() {
            Bends::default()
        } else {
            picture.bends(&self.document().drawing, part_du, self.moment().px_per_du)
        };
        let problem = whole.part(picture.map(), &bends, picture.boundary(), &view);
        Some(Sharp { problem, px_per_du, within_du })
    }
}
