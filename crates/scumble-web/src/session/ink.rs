//! The lines and scribbles over the colours, and the desk around the page.

use std::mem::take;

use scumble_core::Srgb8;

use super::Session;
use crate::layers::Layers;

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

    pub(super) fn refresh_ink(&mut self) {
        let px_per_du = self.px_per_du();
        if !self.layers.suit_scale(px_per_du) {
            self.layers = Layers::at_scale(px_per_du);
            (self.stale.lines, self.stale.scribbles) = (true, true);
        }
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
        if self.lines_shown {
            self.layers.add_lines(drawing, self.sheet.picture.map());
        }
        self.layers.add_desk(drawing.frame(), self.desk);
        self.changed.ink = true;
        self.stale.view = true;
    }

    fn draw_scribbles(&mut self) {
        let scribbles = if self.scribbles_shown { &*self.sheet.editor.document().scribbles } else { &[] };
        self.layers.set_scribbles(scribbles);
        self.changed.scribbles = true;
        self.stale.view = true;
    }
}
