//! Which tool is at hand, and what it works with; what is set for it goes to what is selected, if that is what it is for.

use scumble_core::{Deed, Paint};

use super::Session;
use super::gestures::Held;
use crate::brush::{Brush, Ink, ModeChange};
use crate::command::Tool;
use crate::effect::{Edit, Effect};
use crate::selection::Selection;

impl Session {
    /// What the pen does from here on. What is selected stays so for those who only look around or pick a colour for it.
    pub(super) fn set_tool(&mut self, tool: Tool) {
        if let Some(Held::Grip(_)) = self.held {
            self.end(&[]);
        }
        if matches!(tool, Tool::Scribble | Tool::Erase) {
            self.select(Selection::default());
        }
        self.tool = tool;
    }

    pub(super) fn turn_eraser(&mut self) {
        self.set_tool(Tool::Erase);
        self.erases_parts = !self.erases_parts;
        self.tell(Effect::EraserTurned { parts: self.erases_parts });
    }

    /// Who picks a colour or a kind wants to scribble with it.
    pub(super) fn change_brush(&mut self, change: impl FnOnce(&mut Brush)) {
        self.set_tool(Tool::Scribble);
        change(&mut self.brush);
    }

    /// … unless there are scribbles selected, which it is for.
    pub(super) fn take_ink(&mut self, ink: Ink, is_sought: bool) {
        if self.selected_scribbles().is_empty() {
            return self.change_brush(|brush| brush.set_ink(ink));
        }
        if let Ink::Paint(_) = ink {
            self.brush.set_ink(ink);
        }
        self.set_tool(Tool::Select);
        let deed = (Deed::Recolored, Edit::Recolored);
        self.change_selected(deed, is_sought, |session| session.recolor_selected(ink));
    }

    /// A colour in the place of the one that was sought last.
    pub(super) fn tune_color(&mut self, color: Paint) {
        if self.selected_scribbles().is_empty() {
            self.change_brush(|brush| brush.tune_color(color));
        } else {
            self.take_ink(Ink::Paint(color), true);
        }
    }

    /// How the next scribble colours or, but for its kind, those that are selected and shade.
    pub(super) fn change_mode(&mut self, change: ModeChange) {
        match change {
            ModeChange::OtherKind => self.change_mode(ModeChange::Kind(self.mode_shown().kind.other())),
            ModeChange::Strength(_) | ModeChange::Crosses(_) | ModeChange::Pressure(_)
                if !self.selected_shades().is_empty() =>
            {
                self.reshade(change);
            }
            _ => self.change_brush(|brush| change.apply(&mut brush.mode)),
        }
    }

    fn reshade(&mut self, change: ModeChange) {
        // A shade that a pen pressed evenly shows no pen of its own.
        if let ModeChange::Pressure(_) = change {
            change.apply(&mut self.brush.mode);
        }
        let is_slid = matches!(change, ModeChange::Strength(_));
        let deed = (Deed::Reshaded, Edit::Reshaded);
        self.change_selected(deed, is_slid, |session| session.reshade_selected(change));
    }

    /// Another size, which depends on the one that there is.
    pub(super) fn set_size(&mut self, is_slid: bool, size_du: impl Fn(f64) -> f64) {
        if self.selected_scribbles().is_empty() {
            self.brush.set_size(size_du(self.brush.size_du()));
        } else {
            let deed = (Deed::Widened, Edit::Widened);
            self.change_selected(deed, is_slid, |session| session.resize_selected(size_du));
        }
    }

    /// A change of what is selected, as it is called in the history and told. It is a gesture of its own unless a slider makes
    /// it.
    fn change_selected(&mut self, (deed, edit): (Deed, Edit), is_slid: bool, change: impl FnOnce(&mut Self)) {
        // What the pen has hold of is a gesture in hand.
        if self.held.is_some() {
            return;
        }
        if is_slid {
            self.slide(deed);
            self.sheet.editor.restart();
        } else {
            self.sheet.editor.begin(deed);
        }
        change(self);
        if !is_slid {
            self.sheet.editor.commit();
        }
        self.tell_edited(edit);
    }
}
