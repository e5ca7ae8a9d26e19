//! The lines and scribbles over the colours, and the desk around the page.

use std::mem::{replace, take};

use kurbo::Stroke;
use scumble_core::{Curve, Drawing, Line, Rgba8, Scribble, Srgb8};

use super::Session;
use crate::layers::{Layers, MARK, MARK_PX};
use crate::regions::Regions;

impl Session {
    pub(super) fn show_lines(&mut self, shown: bool) {
        self.lines_shown = shown;
        self.stale.lines = true;
    }

    pub(super) fn show_scribbles(&mut self, shown: bool) {
        self.scribbles_shown = shown;
        self.stale.scribbles = true;
    }

    pub(super) fn set_desk(&mut self, desk: Srgb8) {
        self.desk = desk;
        self.stale.lines = true;
    }

    /// The drawing as it was before it was coloured, or what else is to be shown.
    pub(super) fn show_before(&mut self, shown: bool) {
        self.is_before = shown;
        self.changed.add_colors();
        (self.stale.view, self.stale.lines, self.stale.scribbles) = (true, true, true);
    }

    pub(super) fn regions_shown(&self) -> Option<&Regions> {
        self.regions.as_ref().filter(|_| !self.is_before)
    }

    pub(super) fn refresh_ink(&mut self) {
        let px_per_du = self.px_per_du();
        if !self.layers.suit_scale(px_per_du) {
            self.layers = Layers::at_scale(px_per_du);
            (self.stale.lines, self.stale.scribbles) = (true, true);
        }
        self.refresh_map();
        let lines = self.sheet.editor.lines_revision();
        self.stale.lines |= replace(&mut self.inked, lines) != lines;
        if take(&mut self.stale.lines) {
            self.draw_ink();
        }
        if take(&mut self.stale.scribbles) {
            self.draw_scribbles();
        }
    }

    fn draw_ink(&mut self) {
        let drawing = &self.sheet.editor.document().drawing;
        self.layers.clear_ink();
        if self.lines_shown || self.is_before {
            let key = (self.sheet.map_key(), self.sheet.editor.lines_revision());
            self.layers.add_ink(key, drawing, self.sheet.ink_map(), &mut self.ink);
        }
        if let Some(regions) = self.regions_shown() {
            self.layers.add_lines(&regions.marked_gaps(drawing, self.px_per_du()), None);
        }
        let selected = self.selected_curves().into_iter().map(|i| &drawing.curves[i]);
        self.layers.add_lines(&marked(drawing, selected, self.px_per_du()), None);
        self.layers.add_desk(drawing.frame(), self.desk);
        self.changed.ink = true;
        self.changed.add_everywhere();
        self.stale.view = true;
    }

    fn draw_scribbles(&mut self) {
        let are_shown = self.scribbles_shown && !self.is_before;
        let in_hand = self.scribble_in_hand();
        let editor = &self.sheet.editor;
        let all = editor.document().scribbles.iter().zip(editor.scribble_ids());
        let marked = all.map(|(scribble, id)| (scribble, self.selection.has(*id)));
        let mut scribbles: Vec<_> = marked.filter(|_| are_shown).collect();
        if let (Some((last, _)), Some(in_hand)) = (scribbles.last_mut(), &in_hand) {
            *last = in_hand;
        }
        self.changed.add_within(self.layers.set_scribbles(&scribbles));
        self.changed.scribbles = true;
        self.stale.view = true;
    }

    /// The scribble that the pen draws, as it looks.
    fn scribble_in_hand(&self) -> Option<Scribble> {
        let scribble = self.document().scribbles.last().filter(|_| self.sheet.editor.is_scribbling())?;
        let (points, kind) = self.stroke.drawn(self.du_from_css());
        let Scribble { color, width_du, .. } = *scribble;
        Some(Scribble { color, kind, width_du, points })
    }
}

/// Lines that mark curves as selected.
fn marked<'a>(drawing: &Drawing, curves: impl Iterator<Item = &'a Curve>, px_per_du: f64) -> Drawing {
    let mut marks = Drawing::new(drawing.page);
    for Curve { path, line } in curves {
        let least_du = MARK_PX / px_per_du;
        let width_du = line.as_ref().map_or(0.0, |line| line.stroke.width) + least_du;
        let [r, g, b] = MARK.0;
        let mark = Line { stroke: Stroke::new(width_du), color: Rgba8([r, g, b, 255]) };
        marks.curves.push(Curve { path: path.clone(), line: Some(mark) });
    }
    marks
}
