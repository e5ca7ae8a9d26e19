//! What is in view, for the grid solver, where pixels of the whole page would be seen.

use kurbo::Rect;
use scumble_solve::grid::GridProblem;

use super::Session;
use super::close::{ahead, holds, seen_du};
use crate::painting::part_px;
use crate::solver::HALF_STEP;

/// A part is solved with so many pixels of the whole around it: what borders get wrong has faded away then.
const AROUND_PX: f64 = 8.0;

/// A part of the page.
#[derive(Debug)]
pub(super) struct Sharp {
    pub(super) problem: GridProblem,
    px_per_du: f64,
    /// It serves while what is seen lies within.
    within_du: Rect,
}

impl Session {
    /// Follows the view. The part stays as long as it serves, and all parts have the same
    /// pixels, so that nothing that is seen shifts under a pan.
    pub(super) fn refresh_sharp(&mut self) {
        let Some(whole) = self.problem.as_ref() else { return };
        let whole_px_per_du = whole.view.px_from_du.as_coeffs()[0];
        let page_du = self.document().drawing.frame();
        let seen_du = seen_du(&self.viewport.view());
        let (ahead_du, around_du) = (ahead(seen_du), AROUND_PX / whole_px_per_du);
        // A pan does not change the side, but how it is rounded.
        let side_du = (ahead_du.width().max(ahead_du.height()) + 2.0 * around_du) as f32;
        let px_per_du = self.sharp_scale(side_du.into());
        let is_wanted = px_per_du > HALF_STEP * whole_px_per_du;
        let (seen_du, within_du) = (seen_du.intersect(page_du), ahead_du.intersect(page_du));
        let serves = |it: &Sharp| it.px_per_du == px_per_du && holds(it.within_du, seen_du);
        if self.sharp.as_ref().map_or(!is_wanted, |it| is_wanted && serves(it)) {
            return;
        }
        let page = self.page(px_per_du);
        let part = part_px(within_du.inflate(around_du, around_du), &page).filter(|_| is_wanted);
        let problem = part
            .and_then(|part| whole.part(self.sheet.picture.map(), &self.boundary, &page.part(&part)).ok());
        if problem.is_none() && self.sharp.is_none() {
            return;
        }
        self.sharp = problem.map(|problem| Sharp { problem, px_per_du, within_du });
        self.changed.part = true;
        self.changed.add_everywhere();
        self.stale.view = true;
    }
}
