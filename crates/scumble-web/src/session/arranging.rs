//! What is done with what is selected.

use kurbo::{Affine, Vec2};
use scumble_core::work::{are_too_long, are_too_many_shades};
use scumble_core::{Curve, Deed, Paint, Scribble, ScribbleKind, Tone};

use super::Session;
use crate::brush::{Ink, Mode, ModeChange, within_sizes};
use crate::command::Arranging;
use crate::effect::{Edit, Effect};
use crate::selection::{Selection, way_to_page};

/// An arrow key moves the view by this much, in CSS pixels, and what is selected by one du; with Shift ten times as far.
const STEP_CSS: f64 = 48.0;
const FAR: f64 = 10.0;

/// A copy lies so far beside what it is of, each way, in CSS pixels.
const BESIDE_CSS: f64 = 16.0;

impl Session {
    pub(super) fn arrange(&mut self, arranging: Arranging) {
        if self.selection.is_empty() {
            return;
        }
        self.commit();
        match arranging {
            Arranging::Forward => self.reorder(true),
            Arranging::Backward => self.reorder(false),
            Arranging::Duplicate => self.duplicate(),
            Arranging::Delete => self.delete(),
            Arranging::Hide => self.hide(),
        }
    }

    /// An arrow key: moves what is selected, as it is seen, or the view where nothing is; nothing under a pen that is down.
    pub(super) fn arrow(&mut self, direction: Vec2, is_far: bool) {
        let way = direction * if is_far { FAR } else { 1.0 };
        if self.is_pen_down() {
            return;
        }
        if self.selection.is_empty() {
            self.viewport.pan(-way * STEP_CSS);
            self.stale.view = true;
        } else {
            self.slide(Deed::Moved);
            let way_du = self.viewport.way_du(way * self.viewport.zoom());
            self.transform_selected(Affine::translate(way_du));
            self.tell_edited(Edit::Moved);
        }
    }

    pub(super) fn end_placing(&mut self, edit: Edit) {
        if self.drops_too_long() {
            return;
        }
        let before = self.sheet.editor.revision();
        self.sheet.editor.commit();
        self.scribbles_changed();
        if self.sheet.editor.revision() != before {
            self.tell_edited(edit);
        }
    }

    /// Moves and stretches what is selected; some of it stays on the page.
    pub(super) fn transform_selected(&mut self, place: Affine) {
        let page = self.document().drawing.frame();
        let Some(bounds) = self.selected_bounds(Affine::IDENTITY) else { return };
        let back = way_to_page(place.transform_rect_bbox(bounds), page);
        let place = Affine::translate(back) * place;
        for i in self.selected_scribbles() {
            self.change_scribble(i, |scribble| scribble.points.iter_mut().for_each(|p| *p = place * *p));
        }
        for i in self.selected_curves() {
            let Curve { path, line } = self.document().drawing.curves[i].clone();
            self.sheet.editor.replace_curve(i, Curve { path: place * path, line });
        }
        self.scribbles_changed();
    }

    fn change_scribble(&mut self, index: usize, change: impl FnOnce(&mut Scribble)) {
        let mut scribble = self.document().scribbles[index].clone();
        change(&mut scribble);
        self.sheet.editor.replace_scribble(index, scribble);
    }

    /// Gives the selected scribbles a colour.
    pub(super) fn recolor_selected(&mut self, ink: Ink) {
        match ink {
            Ink::Paint(color) => self
                .selected_scribbles()
                .into_iter()
                .for_each(|i| self.sheet.editor.recolor_scribble(i, color)),
            Ink::Tone(tone) => self.tone_selected(tone),
        }
        self.scribbles_changed();
    }

    /// Gives them a step from their colours or, where they shade, from those under their first points without them.
    fn tone_selected(&mut self, tone: Tone) {
        let shades = self.selected_shades();
        let mut colors = self.colors_under(&shades);
        let mut fills = self.selected_scribbles();
        fills.retain(|i| self.document().scribbles[*i].is_fill());
        let fills = fills.into_iter();
        colors.extend(fills.filter_map(|i| match self.document().scribbles[i].color {
            Paint::Color(color) => Some((i, color)),
            Paint::Clear => None,
        }));
        for (i, color) in colors {
            self.sheet.editor.recolor_scribble(i, tone.step(color).into());
        }
    }

    /// Those of the selected scribbles that shade.
    pub(super) fn selected_shades(&self) -> Vec<usize> {
        let mut selected = self.selected_scribbles();
        selected.retain(|i| !self.document().scribbles[*i].is_fill());
        selected
    }

    /// Shades otherwise with those that are selected.
    pub(super) fn reshade_selected(&mut self, change: ModeChange) {
        for i in self.selected_shades() {
            self.change_scribble(i, |scribble| {
                if let ScribbleKind::Shade(shading) = &mut scribble.kind {
                    change.apply_to(shading);
                }
            });
        }
        self.scribbles_changed();
    }

    /// That of the first of the selected scribbles that shades, or of the next scribble.
    pub(super) fn mode_shown(&self) -> Mode {
        let first =
            self.selected_scribbles().into_iter().find_map(|i| self.document().scribbles[i].shading());
        first.map_or(self.brush.mode, |shading| Mode::of_shade(shading, self.brush.mode.pressure))
    }

    /// The colour of the selected scribbles, if they share one, or that of the next.
    pub(super) fn ink_shown(&self) -> Ink {
        let selected = self.selected_scribbles();
        let mut colors = selected.into_iter().map(|i| self.document().scribbles[i].color);
        let first = colors.next();
        let is_shared = colors.all(|color| Some(color) == first);
        first.filter(|_| is_shared).map_or(self.brush.ink(), Ink::Paint)
    }

    /// The width of the first of the selected scribbles, or of the next, in du.
    pub(super) fn size_shown_du(&self) -> f64 {
        let first = self.selected_scribbles().first().map(|i| self.document().scribbles[*i].width_du);
        first.unwrap_or(self.brush.size_du())
    }

    /// Gives the selected scribbles other widths, which depend on those that they have, in du.
    pub(super) fn resize_selected(&mut self, width_du: impl Fn(f64) -> f64) {
        for i in self.selected_scribbles() {
            let scribble = &self.document().scribbles[i];
            let after_du = within_sizes(width_du(scribble.width_du), &scribble.kind);
            if after_du.is_finite() {
                self.change_scribble(i, |scribble| scribble.width_du = after_du);
            }
        }
        self.scribbles_changed();
    }

    fn reorder(&mut self, is_forward: bool) {
        let last = self.document().scribbles.len().saturating_sub(1);
        let mut selected = self.selected_scribbles();
        if is_forward {
            selected.reverse();
        }
        let before = self.sheet.editor.revision();
        self.sheet.editor.begin(if is_forward { Deed::Forward } else { Deed::Backward });
        for i in selected {
            let to = if is_forward { i + 1 } else { i.saturating_sub(1) };
            let is_free = self.sheet.editor.scribble_ids().get(to).is_some_and(|id| !self.selection.has(*id));
            if to <= last && is_free {
                self.sheet.editor.move_scribble(i, to);
            }
        }
        self.sheet.editor.commit();
        self.scribbles_changed();
        self.tell_edited(match (self.sheet.editor.revision() != before, is_forward) {
            (true, true) => Edit::Forward,
            (true, false) => Edit::Backward,
            (false, true) => Edit::Foremost,
            (false, false) => Edit::Hindmost,
        });
    }

    /// Copies lie over everything, and are what is selected then.
    fn duplicate(&mut self) {
        let (count, selected) = (self.document().scribbles.len(), self.selected_scribbles());
        if selected.is_empty() {
            return;
        }
        self.sheet.editor.begin(Deed::Duplicated);
        for i in selected {
            let copy = self.document().scribbles[i].clone();
            self.sheet.editor.insert_scribble(usize::MAX, copy);
        }
        let ids = self.sheet.editor.scribble_ids().get(count..).unwrap_or_default().to_vec();
        if !self.drops_too_long() {
            self.select(Selection::of(ids));
            let beside_du = self.viewport.way_du(Vec2::new(BESIDE_CSS, BESIDE_CSS));
            self.transform_selected(Affine::translate(beside_du));
            self.sheet.editor.commit();
            self.tell_edited(Edit::Duplicated);
        }
    }

    /// Drops the gesture in hand where it makes scribbles longer in all than a file may have them, or too many shades, and says
    /// so.
    pub(super) fn drops_too_long(&mut self) -> bool {
        let editor = &mut self.sheet.editor;
        let may_lengthen =
            editor.is_scribbling() || matches!(editor.deed_in_hand(), Some(Deed::Resized | Deed::Duplicated));
        let scribbles = &editor.document().scribbles;
        let is_dropped = may_lengthen && (are_too_long(scribbles) || are_too_many_shades(scribbles));
        if is_dropped {
            editor.abort();
            self.scribbles_changed();
            self.tell(Effect::Failed("the scribbles are too long in all; erase some of them".into()));
        }
        is_dropped
    }

    fn delete(&mut self) {
        let [scribbles, curves] = [self.selected_scribbles(), self.selected_curves()];
        self.sheet.editor.begin(Deed::Deleted);
        for &i in curves.iter().rev() {
            self.sheet.editor.remove_curve(i);
        }
        let erased = self.sheet.editor.erase_scribbles(&scribbles);
        self.sheet.editor.commit();
        self.scribbles_changed();
        self.tell(if erased > 0 {
            Effect::ScribblesErased { erased, count: self.document().scribbles.len() }
        } else {
            Effect::Edited { edit: Edit::Deleted, scribbles: 0, lines: curves.len() }
        });
        self.select(Selection::default());
    }

    /// Lines that are hidden part colours as they do; they are shown again where all are hidden.
    fn hide(&mut self) {
        let opacity = if self.selection_state().are_hidden { u8::MAX } else { 0 };
        let curves = self.selected_curves();
        if curves.is_empty() {
            return;
        }
        self.sheet.editor.begin(if opacity == 0 { Deed::Hidden } else { Deed::Shown });
        for i in curves {
            let mut curve = self.document().drawing.curves[i].clone();
            if let Some(line) = &mut curve.line {
                line.color.0[3] = opacity;
            }
            self.sheet.editor.replace_curve(i, curve);
        }
        self.sheet.editor.commit();
        self.scribbles_changed();
        self.tell_edited(if opacity == 0 { Edit::Hidden } else { Edit::Shown });
    }

    pub(super) fn tell_edited(&mut self, edit: Edit) {
        let scribbles = match edit {
            Edit::Reshaded => self.selected_shades().len(),
            _ => self.selected_scribbles().len(),
        };
        let lines = self.selected_curves().len();
        self.tell(Effect::Edited { edit, scribbles, lines });
    }
}
