//! The colours of the picture: those of the sides, and what a solver makes of them.

use std::mem::take;

use scumble_core::Document;
use scumble_solve::FieldChange;
use scumble_solve::grid::GridProblem;

use super::Session;
use super::close::CHORDS_OFF_DU;
use super::gestures::Held;
use crate::effect::Effect;
use crate::regions::Regions;
use crate::solver::{Grids, Moment, Source};

/// While a gesture is on its way, pixels of the grid are so many times wider: then it keeps up with the pen.
const IN_HASTE: f64 = 2.0;

/// The colours of so many scribbles follow while they are dragged.
const SCRIBBLES_IN_HAND: usize = 500;

impl Session {
    /// What the picture on the canvas is made of.
    pub(super) fn refresh_colors(&mut self) {
        if self.are_many_dragged() {
            // What is in view may be another part by now, and its colours are not known.
            return self.refresh_sharp(None);
        }
        self.refresh_boundary();
        let source = self.choice();
        if source != std::mem::replace(&mut self.source, source) {
            self.changed.add_colors();
            self.stale.view = true;
        }
        if source == Source::Grid { self.refresh_problem() } else { self.refresh_field() }
    }

    /// Whether the pen has hold of so many scribbles that their colours are found once it has let go.
    fn are_many_dragged(&self) -> bool {
        let is_dragged = matches!(self.held, Some(Held::Grip(_))) && self.sheet.editor.is_changing();
        is_dragged && self.selected_scribbles().len() > SCRIBBLES_IN_HAND
    }

    pub(super) fn show_result(&mut self, shown: bool) {
        self.result_shown = shown;
        self.changed.add_colors();
        self.stale.view = true;
    }

    /// Instead of the result or none.
    pub(super) fn show_regions(&mut self, shown: bool) {
        self.regions = shown.then(Regions::default);
        self.changed.add_colors();
        (self.stale.view, self.stale.lines) = (true, true);
    }

    pub(super) fn refresh_regions(&mut self) {
        if let Some(regions) = &mut self.regions
            && regions.follow(self.sheet.map_key(), self.sheet.picture.map())
        {
            self.changed.add_colors();
            (self.stale.view, self.stale.lines) = (true, true);
        }
    }

    /// Where the picture is to come from. A rough one comes from a mesh; one on pixels stays until the mesh is made.
    pub(super) fn choice(&self) -> Source {
        if !self.sheet.is_made() {
            return Source::Mesh;
        }
        let stays = self.source == Source::Grid && self.grids != Grids::No && self.lacks_mesh();
        if stays { Source::Grid } else { self.solver.source(&self.moment()) }
    }

    pub(super) fn moment(&self) -> Moment {
        let picture = &self.sheet.picture;
        Moment {
            grids: self.grids,
            px_per_du: self.px_per_du(),
            pieces: picture.map().pieces().len(),
            has_mesh: picture.has_mesh(),
            is_in_motion: self.sheet.editor.is_changing_lines(),
        }
    }

    fn refresh_boundary(&mut self) {
        self.refresh_map();
        if !self.lacks_map() && take(&mut self.stale.boundary) {
            let settings = self.settings_shown();
            let Document { scribbles, color_points, .. } = self.sheet.editor.document();
            self.sheet.picture.color(scribbles, color_points, &settings);
        }
    }

    /// The picture of the mesh solver; where it has never been made, what is shown meanwhile stays.
    pub(super) fn refresh_field(&mut self) {
        self.refresh_boundary();
        if self.sheet.is_made() && take(&mut self.stale.field) {
            self.solve();
        }
    }

    /// Another picture is shown.
    pub(super) fn show_other(&mut self) {
        self.previews.clear();
        self.changed.field = FieldChange::ALL;
        self.stale.view = true;
    }

    fn solve(&mut self) {
        let picture = &mut self.sheet.picture;
        if !picture.has_mesh() {
            self.changed.field = FieldChange::ALL;
        }
        if let Err(error) = picture.solve() {
            self.effects.push(Effect::Failed(error.to_string()));
        }
        let mut change = picture.take_change();
        change.within_du = change.within_du.map(|rect| rect.inflate(CHORDS_OFF_DU, CHORDS_OFF_DU));
        self.changed.field.add(change);
        self.stale.view = true;
    }

    fn refresh_problem(&mut self) {
        let (whole, part) = self.grid_scales();
        let view = self.page(whole);
        let is_other_view = self.problem.as_ref().is_none_or(|problem| problem.view != view);
        if take(&mut self.stale.problem) || is_other_view {
            let picture = &self.sheet.picture;
            match GridProblem::new(picture.map(), picture.boundary(), &view, picture.settings().blend) {
                Ok(problem) => self.problem = Some(problem),
                Err(error) => return self.effects.push(Effect::Failed(error.to_string())),
            }
            self.sharp = None;
            self.changed.problem = true;
            self.changed.add_everywhere();
            self.stale.view = true;
        }
        self.refresh_sharp(part);
    }

    /// By how much pixels of grids are wider for now.
    pub(super) fn haste(&self) -> f64 {
        if self.sheet.editor.is_in_hand() { IN_HASTE } else { 1.0 }
    }
}
