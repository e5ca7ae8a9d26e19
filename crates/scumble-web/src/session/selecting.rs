//! What the pen does with the tool that selects: a click chooses, a drag moves what is chosen, resizes it by a handle of
//! its frame, or chooses all that lies in a rectangle.

use std::mem::replace;

use kurbo::common::solve_quadratic;
use kurbo::{Affine, BezPath, CubicBez, ParamCurve as _, Point, Rect, Vec2};
use scumble_core::{Curve, Deed, Document, bounds};

use super::Session;
use super::gestures::{CLICK_CSS, Held};
use super::pointing::{Hold, is_line, is_touched, outlines};
use crate::command::{Selecting, Tool};
use crate::effect::{Edit, Effect, SelectionState};
use crate::layers::drawn_width_du;
use crate::selection::{HANDLES, Handle, Selection, way_to_page};

/// The frame keeps this distance from what it is around, in CSS pixels.
const RIM_CSS: f64 = 4.0;

/// A frame has handles if its longer side is so long, in CSS pixels, and those of a side if that is.
const LEAST_FRAME_CSS: f64 = 24.0;
const LEAST_SIDE_CSS: f64 = 64.0;

/// What is chosen by a key is brought so far into sight, in CSS pixels.
const MARGIN_CSS: f64 = 48.0;

/// What the pen has hold of.
#[derive(Debug)]
pub(super) struct Grip {
    hold: Hold,
    /// Where it came down and where it is, in du.
    from: Point,
    to: Point,
    is_dragged: bool,
    /// Whether it adds to what was selected.
    adds: bool,
    before: Selection,
}

impl Session {
    pub(super) fn begin_selecting(&mut self, points: &[Point], adds: bool) {
        let Some(&from) = points.first() else { return };
        self.sheet.editor.commit();
        // Lines are found by their map; without one scribbles are.
        if self.sheet.is_made() {
            self.finish_making();
        }
        self.refresh_map();
        let before = self.selection.clone();
        let hold = self.hold_at(from, adds);
        if let Hold::Thing(id) = hold {
            if adds {
                self.select(before.toggled(id));
            } else if !before.has(id) && self.sheet.editor.scribble_ids().contains(&id) {
                self.select(Selection::of(vec![id]));
            }
        }
        self.held = Some(Held::Grip(Grip { hold, from, to: from, is_dragged: false, adds, before }));
    }

    pub(super) fn follow_grip(&mut self, points: &[Point]) {
        let (zoom, Some(&to)) = (self.viewport.zoom(), points.last()) else { return };
        let Some(Held::Grip(grip)) = &mut self.held else { return };
        let begins = !grip.is_dragged && (to - grip.from).hypot() * zoom >= CLICK_CSS;
        grip.is_dragged |= begins;
        grip.to = to;
        if grip.is_dragged {
            let (hold, way) = (grip.hold, to - grip.from);
            match hold {
                Hold::Handle(handle) => self.resize(begins, handle, way),
                Hold::Frame => self.carry(begins, way),
                Hold::Thing(id) if self.selection.has(id) => self.carry(begins, way),
                _ => self.select_in_marquee(),
            }
        }
    }

    /// Its frame lies along the sides of the canvas, and so does what a handle of it does.
    fn resize(&mut self, begins: bool, handle: Handle, way: Vec2) {
        let turned_from_du = self.viewport.turned_from_du();
        let way = (turned_from_du * way.to_point()).to_vec2();
        self.place(begins, Deed::Resized, |frame| {
            turned_from_du.inverse() * handle.resize(frame, way) * turned_from_du
        });
    }

    fn carry(&mut self, begins: bool, way: Vec2) {
        self.place(begins, Deed::Moved, |_| Affine::translate(way));
    }

    /// Puts what is selected to a place that depends on the turned frame around its middle lines, as the gesture found it.
    fn place(&mut self, begins: bool, deed: Deed, place: impl Fn(Rect) -> Affine) {
        if begins {
            self.sheet.editor.begin(deed);
        } else if self.sheet.editor.deed_in_hand() != Some(deed) {
            // A command has ended it.
            self.held = None;
            return;
        }
        self.sheet.editor.restart();
        if let Some(frame) = self.selected_bounds(self.viewport.turned_from_du()) {
            self.transform_selected(place(frame));
        }
    }

    pub(super) fn end_selecting(&mut self, grip: &Grip) {
        if self.sheet.editor.is_changing() {
            let is_handle = matches!(grip.hold, Hold::Handle(_));
            return self.end_placing(if is_handle { Edit::Resized } else { Edit::Moved });
        }
        match grip.hold {
            _ if self.is_marquee(grip) => self.select_lines_in_marquee(grip),
            _ if grip.is_dragged => {}
            Hold::Thing(id) if !grip.adds => self.select(Selection::of(vec![id])),
            Hold::Frame | Hold::Page if !grip.adds => self.select(Selection::default()),
            _ => {}
        }
        if self.selection != grip.before {
            self.tell_selected();
        }
    }

    /// Leaves everything as it was before the pen came down.
    pub(super) fn drop_grip(&mut self, grip: Grip) {
        self.sheet.editor.abort();
        self.select(grip.before);
        self.scribbles_changed();
    }

    pub(super) fn choose(&mut self, selecting: Selecting) {
        self.commit();
        let editor = &self.sheet.editor;
        let selection = match selecting {
            Selecting::None => Selection::default(),
            Selecting::All => Selection::of(editor.scribble_ids().to_vec()),
            Selecting::Next => Selection::of(self.neighbour(1)),
            Selecting::Previous => Selection::of(self.neighbour(-1)),
        };
        if selecting != Selecting::None {
            self.set_tool(Tool::Select);
            self.show_scribbles(true);
        }
        let was_empty = self.selection.is_empty() && selection.is_empty();
        self.select(selection);
        if matches!(selecting, Selecting::Next | Selecting::Previous) {
            self.reveal();
        }
        if !was_empty || selecting != Selecting::None {
            self.tell_selected();
        }
    }

    /// What comes next, one way or the other: scribbles from the uppermost down, then lines likewise.
    fn neighbour(&self, step: isize) -> Vec<u32> {
        let (editor, Document { drawing, .. }) = (&self.sheet.editor, self.document());
        let [scribbles, curves] = [editor.scribble_ids(), editor.curve_ids()];
        let all: Vec<u32> = scribbles.iter().rev().chain(curves.iter().rev()).copied().collect();
        let count = all.len() as isize;
        let now = all.iter().position(|id| self.selection.has(*id)).map(|now| now as isize);
        let before = now.unwrap_or(if step > 0 { -1 } else { 0 });
        let places = (1..=count).map(|i| (before + i * step).rem_euclid(count) as usize);
        let outlines = outlines(drawing);
        let is_one = |place: &usize| {
            let from_end = all.len() - 1 - *place;
            *place < scribbles.len() || is_line(&drawing.curves[from_end], &outlines)
        };
        let mut found = places.filter(is_one);
        found.next().map(|place| all[place]).into_iter().collect()
    }

    /// Moves the view so that the middle of what is selected is in sight.
    fn reveal(&mut self) {
        let canvas = self.viewport.canvas_css();
        let margin_css = MARGIN_CSS.min(0.25 * canvas.size().min_side());
        if let Some(frame) = self.selection_state().frame_css {
            let middle = Rect::from_points(frame.center(), frame.center());
            self.viewport.pan(way_to_page(middle, canvas.inflate(-margin_css, -margin_css)));
            self.stale.view = true;
        }
    }

    pub(super) fn select(&mut self, selection: Selection) {
        let before = replace(&mut self.selection, selection);
        let is_other = |ids: &[u32]| before.places_in(ids) != self.selection.places_in(ids);
        self.stale.scribbles |= is_other(self.sheet.editor.scribble_ids());
        self.stale.lines |= is_other(self.sheet.editor.curve_ids());
    }

    /// What is no longer there is not selected.
    pub(super) fn forget_missing(&mut self) {
        let editor = &self.sheet.editor;
        let ids = editor.scribble_ids().iter().chain(editor.curve_ids());
        let known = ids.copied().filter(|id| self.selection.has(*id)).collect();
        self.select(Selection::of(known));
    }

    fn tell_selected(&mut self) {
        let [scribbles, curves] = [self.selected_scribbles(), self.selected_curves()];
        let total = self.document().scribbles.len();
        let place = scribbles.first().map_or(0, |index| index + 1);
        self.tell(Effect::Selected { scribbles: scribbles.len(), lines: curves.len(), place, total });
    }

    pub(super) fn selected_scribbles(&self) -> Vec<usize> {
        self.selection.places_in(self.sheet.editor.scribble_ids())
    }

    pub(super) fn selected_curves(&self) -> Vec<usize> {
        self.selection.places_in(self.sheet.editor.curve_ids())
    }

    /// The bounds of the middle lines of what is selected, taken from du to elsewhere.
    pub(super) fn selected_bounds(&self, from_du: Affine) -> Option<Rect> {
        let Document { drawing, scribbles, .. } = self.document();
        let points = self.selected_scribbles().into_iter().flat_map(|i| &scribbles[i].points);
        let curves = self.selected_curves().into_iter().map(|i| &drawing.curves[i].path);
        let all = bounds::of(points.map(|&point| from_du * point));
        curves.fold(all, |all, path| bounds::union(all, bounds_of(path, from_du)))
    }

    /// The frame around what is selected as it is drawn, in turned du.
    pub(super) fn frame_turned(&self) -> Option<Rect> {
        let Document { drawing, scribbles, .. } = self.document();
        let scribbles = self.selected_scribbles().into_iter().map(|i| drawn_width_du(&scribbles[i]));
        let lines = self.selected_curves().into_iter().filter_map(|i| drawing.curves[i].line.as_ref());
        let widest_du = scribbles.chain(lines.map(|line| line.stroke.width)).fold(0.0, f64::max);
        let rim_du = 0.5 * widest_du + RIM_CSS / self.viewport.zoom();
        let bounds = self.selected_bounds(self.viewport.turned_from_du());
        bounds.map(|bounds| bounds.inflate(rim_du, rim_du))
    }

    pub(super) fn selection_state(&self) -> SelectionState {
        let [scribbles, curves] = [self.selected_scribbles(), self.selected_curves()];
        let css_from_turned = self.viewport.css_from_du() * self.viewport.turned_from_du().inverse();
        let css = |rect: Rect| css_from_turned.transform_rect_bbox(rect);
        let drawing = &self.document().drawing;
        let frame = self.frame_turned();
        let is_hidden = |i: &usize| drawing.curves[*i].line.as_ref().is_some_and(|line| line.color.0[3] == 0);
        SelectionState {
            scribbles: scribbles.len(),
            lines: curves.len(),
            are_hidden: !curves.is_empty() && curves.iter().all(is_hidden),
            frame_css: frame.map(css),
            handles: self.handles(frame).len(),
            marquee_css: self.marquee().map(css),
        }
    }

    /// The handles that the frame around what is selected has: those of corners, then those of sides.
    pub(super) fn handles(&self, frame: Option<Rect>) -> &'static [Handle] {
        let size_css = frame.unwrap_or_default().size() * self.viewport.zoom();
        let are_lines = self.selected_scribbles().is_empty();
        let is_stretchy = || {
            let bounds = self.selected_bounds(Affine::IDENTITY);
            bounds.is_some_and(|bounds| bounds.width() + bounds.height() > 0.0)
        };
        if are_lines || size_css.max_side() < LEAST_FRAME_CSS || !is_stretchy() {
            &HANDLES[..0]
        } else if size_css.min_side() < LEAST_SIDE_CSS {
            &HANDLES[..4]
        } else {
            &HANDLES
        }
    }

    /// The rectangle that is being drawn to select what lies in it, in turned du.
    fn marquee(&self) -> Option<Rect> {
        let Some(Held::Grip(grip)) = &self.held else { return None };
        self.is_marquee(grip).then(|| self.marquee_of(grip))
    }

    fn marquee_of(&self, grip: &Grip) -> Rect {
        let turned_from_du = self.viewport.turned_from_du();
        Rect::from_points(turned_from_du * grip.from, turned_from_du * grip.to)
    }

    /// Whether it is a drag that began on nothing, or on a line that was not selected.
    fn is_marquee(&self, grip: &Grip) -> bool {
        let is_free = match grip.hold {
            Hold::Page => true,
            Hold::Thing(id) => !grip.before.has(id) && !self.sheet.editor.scribble_ids().contains(&id),
            Hold::Handle(_) | Hold::Frame => false,
        };
        is_free && grip.is_dragged
    }

    fn select_in_marquee(&mut self) {
        let (Some(marquee), Some(Held::Grip(grip))) = (self.marquee(), &self.held) else { return };
        let scribbles = self.document().scribbles.iter().zip(self.sheet.editor.scribble_ids());
        let turned_from_du = self.viewport.turned_from_du();
        let is_in = |scribble| self.scribbles_shown && is_touched(scribble, marquee, turned_from_du);
        let touched: Vec<u32> =
            scribbles.filter(|(scribble, _)| is_in(scribble)).map(|(_, id)| *id).collect();
        let kept = if grip.adds { grip.before.clone() } else { Selection::default() };
        self.select(kept.with(touched));
    }

    /// Where there is no scribble in the rectangle, lines are meant that lie in it wholly.
    fn select_lines_in_marquee(&mut self, grip: &Grip) {
        if !self.selected_scribbles().is_empty() || !self.lines_shown {
            return;
        }
        let (marquee, turned_from_du) = (self.marquee_of(grip), self.viewport.turned_from_du());
        let drawing = &self.document().drawing;
        let outlines = outlines(drawing);
        let is_in = |curve: &Curve| {
            let bounds = bounds_of(&curve.path, turned_from_du).unwrap_or_default();
            marquee.union(bounds) == marquee && is_line(curve, &outlines)
        };
        let curves = drawing.curves.iter().zip(self.sheet.editor.curve_ids());
        let within: Vec<u32> = curves.filter(|(curve, _)| is_in(curve)).map(|(_, id)| *id).collect();
        self.select(self.selection.with(within));
    }
}

/// The bounds of a path in du, taken to elsewhere. Those of `kurbo` sort extrema by a routine that is 2 KB to load.
fn bounds_of(path: &BezPath, from_du: Affine) -> Option<Rect> {
    let path = from_du * path;
    path.segments().fold(None, |all, segment| bounds::union(all, Some(bounds_of_cubic(segment.to_cubic()))))
}

fn bounds_of_cubic(c: CubicBez) -> Rect {
    let [a, b, d] = [c.p1 - c.p0, c.p2 - c.p1, c.p3 - c.p2];
    let mut bounds = Rect::from_points(c.p0, c.p3);
    for [a, b, d] in [[a.x, b.x, d.x], [a.y, b.y, d.y]] {
        let turns = solve_quadratic(a, 2.0 * (b - a), a - 2.0 * b + d);
        for t in turns.into_iter().filter(|t| (0.0..1.0).contains(t)) {
            bounds = bounds.union_pt(c.eval(t));
        }
    }
    bounds
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_of_paths_are_tight_and_those_of_level_lines_have_no_height() {
        for (svg, expected) in [
            ("M 0 0 C 0 100 100 100 100 0", Rect::new(0.0, 0.0, 100.0, 75.0)),
            ("M 10 10 Q 60 110 110 10 L 110 -5", Rect::new(10.0, -5.0, 110.0, 60.0)),
            ("M 3 7 L 90 7", Rect::new(3.0, 7.0, 90.0, 7.0)),
        ] {
            let path = BezPath::from_svg(svg).expect("a path");
            for from_du in [Affine::IDENTITY, Affine::FLIP_X] {
                let (found, expected) =
                    (bounds_of(&path, from_du).expect("a path"), from_du.transform_rect_bbox(expected));
                let off = [
                    found.x0 - expected.x0,
                    found.y0 - expected.y0,
                    found.x1 - expected.x1,
                    found.y1 - expected.y1,
                ];
                assert!(off.iter().all(|off| off.abs() < 1e-9), "{svg}: {found}");
                assert_eq!(found.height() == 0.0, expected.height() == 0.0, "{svg}");
            }
        }
    }
}
