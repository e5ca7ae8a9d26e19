//! What the pen does with the tool that selects: a click chooses, a drag moves what is chosen, resizes it by a handle of
//! its frame, or chooses all that lies in a rectangle.

use kurbo::{Affine, Line, ParamCurveNearest, Point, Rect, Shape};
use scumble_core::{Curve, Document, Fill, Scribble};

use super::Session;
use super::gestures::{CLICK_CSS, Held};
use crate::command::{Selecting, Tool};
use crate::effect::{Edit, Effect, SelectionState};
use crate::layers::drawn_width_du;
use crate::selection::{HANDLES, Handle, Selection};

/// So far beside a thing or a handle it may be pressed, in CSS pixels: with a mouse or a pen, and with a finger.
const REACHES_CSS: [[f64; 2]; 2] = [[4.0, 12.0], [12.0, 22.0]];

/// The frame keeps this distance from what it is around, in CSS pixels.
const RIM_CSS: f64 = 4.0;

/// A frame has handles if its longer side is so long, in CSS pixels, and those of a side if that is.
const LEAST_FRAME_CSS: f64 = 24.0;
const LEAST_SIDE_CSS: f64 = 64.0;

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

#[derive(Clone, Copy, Debug, PartialEq)]
enum Hold {
    /// A scribble or a curve, by its number.
    Thing(u32),
    Handle(Handle),
    /// The inside of the frame.
    Frame,
    /// Nothing.
    Page,
}

impl Session {
    pub(super) fn begin_selecting(&mut self, points: &[Point], adds: bool) {
        let Some(&from) = points.first() else { return };
        self.sheet.editor.commit();
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
                Hold::Handle(handle) => self.place(begins, |frame| handle.resize(frame, way)),
                Hold::Frame => self.place(begins, |_| Affine::translate(way)),
                Hold::Thing(id) if self.selection.has(id) => self.place(begins, |_| Affine::translate(way)),
                _ => self.select_in_marquee(),
            }
        }
    }

    /// Puts what is selected to a place that depends on the frame around its middle lines, as the gesture found it.
    fn place(&mut self, begins: bool, place: impl Fn(Rect) -> Affine) {
        if begins {
            self.sheet.editor.begin();
        } else if !self.sheet.editor.is_changing() {
            // A command has ended it.
            self.held = None;
            return;
        }
        self.sheet.editor.restart();
        if let Some(frame) = self.selected_bounds() {
            self.transform_selected(place(frame));
        }
    }

    pub(super) fn end_selecting(&mut self, grip: &Grip) {
        if self.sheet.editor.is_changing() {
            let is_handle = matches!(grip.hold, Hold::Handle(_));
            return self.end_placing(if is_handle { Edit::Resized } else { Edit::Moved });
        }
        match grip.hold {
            _ if grip.is_dragged => self.select_lines_in_marquee(grip),
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
        self.things_changed();
    }

    pub(super) fn choose(&mut self, selecting: Selecting) {
        self.sheet.editor.commit();
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
        if !was_empty || selecting != Selecting::None {
            self.tell_selected();
        }
    }

    /// What comes so many after what is selected: scribbles from the uppermost down, then curves likewise.
    fn neighbour(&self, step: isize) -> Vec<u32> {
        let (editor, Document { drawing, .. }) = (&self.sheet.editor, self.document());
        let curves = drawing.curves.iter().zip(editor.curve_ids()).rev();
        let curves = curves.filter(|(curve, _)| is_line(curve, &drawing.fills)).map(|(_, id)| id);
        let all: Vec<u32> = editor.scribble_ids().iter().rev().chain(curves).copied().collect();
        let count = all.len() as isize;
        let now = all.iter().position(|id| self.selection.has(*id));
        let next = now.map_or(step.min(0), |now| now as isize + step);
        if count == 0 { all } else { vec![all[next.rem_euclid(count) as usize]] }
    }

    pub(super) fn select(&mut self, selection: Selection) {
        if selection != self.selection {
            self.selection = selection;
            (self.stale.scribbles, self.stale.lines) = (true, true);
        }
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

    /// The bounds of the middle lines of what is selected, in du.
    pub(super) fn selected_bounds(&self) -> Option<Rect> {
        let Document { drawing, scribbles, .. } = self.document();
        let points = self.selected_scribbles().into_iter().flat_map(|i| &scribbles[i].points);
        let dabs = points.map(|p| Rect::from_points(*p, *p));
        let boxes = self.selected_curves().into_iter().map(|i| drawing.curves[i].path.bounding_box());
        dabs.chain(boxes).reduce(|a, b| a.union(b))
    }

    /// The frame around what is selected as it is drawn, in du.
    fn frame_du(&self) -> Option<Rect> {
        let Document { drawing, scribbles, .. } = self.document();
        let scribbles = self.selected_scribbles().into_iter().map(|i| drawn_width_du(&scribbles[i]));
        let lines = self.selected_curves().into_iter().filter_map(|i| drawing.curves[i].line.as_ref());
        let widest_du = scribbles.chain(lines.map(|line| line.stroke.width)).fold(0.0, f64::max);
        let rim_du = 0.5 * widest_du + RIM_CSS / self.viewport.zoom();
        self.selected_bounds().map(|bounds| bounds.inflate(rim_du, rim_du))
    }

    pub(super) fn selection_state(&self) -> SelectionState {
        let [scribbles, curves] = [self.selected_scribbles(), self.selected_curves()];
        let css = |rect: Rect| self.viewport.css_from_du().transform_rect_bbox(rect);
        let drawing = &self.document().drawing;
        let is_hidden = |i: &usize| drawing.curves[*i].line.as_ref().is_some_and(|line| line.color.0[3] == 0);
        SelectionState {
            scribbles: scribbles.len(),
            lines: curves.len(),
            are_hidden: !curves.is_empty() && curves.iter().all(is_hidden),
            frame_css: self.frame_du().map(css),
            handles: self.handles().len(),
            marquee_css: self.marquee().map(css),
        }
    }

    /// The handles that the frame has: those of corners, then those of sides.
    fn handles(&self) -> &'static [Handle] {
        let is_stretchy = self.selected_bounds().is_some_and(|bounds| bounds.width() + bounds.height() > 0.0);
        let are_lines = self.selected_scribbles().is_empty();
        let size_css = self.frame_du().unwrap_or_default().size() * self.viewport.zoom();
        if !is_stretchy || are_lines || size_css.max_side() < LEAST_FRAME_CSS {
            &HANDLES[..0]
        } else if size_css.min_side() < LEAST_SIDE_CSS {
            &HANDLES[..4]
        } else {
            &HANDLES
        }
    }

    /// The rectangle that is being drawn to select what lies in it, in du.
    fn marquee(&self) -> Option<Rect> {
        let Some(Held::Grip(grip)) = &self.held else { return None };
        let is_free = match grip.hold {
            Hold::Page => true,
            Hold::Thing(id) => !grip.before.has(id) && !self.sheet.editor.scribble_ids().contains(&id),
            _ => false,
        };
        (is_free && grip.is_dragged).then(|| Rect::from_points(grip.from, grip.to))
    }

    fn hold_at(&self, place: Point, adds: bool) -> Hold {
        let handle = if adds { None } else { self.handle_at(place) };
        let thing = || self.scribble_at(place, adds).or_else(|| self.line_at(place, adds));
        if let Some(handle) = handle {
            Hold::Handle(handle)
        } else if let Some(id) = thing() {
            Hold::Thing(id)
        } else if !adds && self.frame_du().is_some_and(|frame| frame.contains(place)) {
            Hold::Frame
        } else {
            Hold::Page
        }
    }

    fn handle_at(&self, place: Point) -> Option<Handle> {
        let frame = self.frame_du()?;
        let reach_du = REACHES_CSS[usize::from(self.is_finger)][1] / self.viewport.zoom();
        // Within a small frame there must be room left to take hold of what it is around.
        let inside_du = reach_du.min(0.25 * frame.size().min_side());
        let reach_du = if frame.contains(place) { inside_du } else { reach_du };
        let is_near = |handle: &&Handle| {
            let way = handle.on(frame) - place;
            way.x.abs().max(way.y.abs()) <= reach_du
        };
        self.handles().iter().find(is_near).copied()
    }

    fn reach_du(&self) -> f64 {
        REACHES_CSS[usize::from(self.is_finger)][0] / self.viewport.zoom()
    }

    /// The uppermost scribble at a place. Who adds to lines means no scribble.
    fn scribble_at(&self, place: Point, adds: bool) -> Option<u32> {
        if !self.scribbles_shown || (adds && !self.selected_curves().is_empty()) {
            return None;
        }
        let mut all = self.document().scribbles.iter().zip(self.sheet.editor.scribble_ids()).rev();
        let is_there = |scribble: &Scribble| {
            let rest_du = self.reach_du() + 0.5 * (drawn_width_du(scribble) - scribble.width_du);
            scribble.is_touched(Line::new(place, place), rest_du)
        };
        all.find(|(scribble, _)| is_there(scribble)).map(|(_, id)| *id)
    }

    /// The uppermost line at a place. Who adds to scribbles means no line.
    fn line_at(&self, place: Point, adds: bool) -> Option<u32> {
        if !self.lines_shown || (adds && !self.selected_scribbles().is_empty()) {
            return None;
        }
        let Document { drawing, .. } = self.document();
        let is_there = |&i: &usize| {
            let curve = &drawing.curves[i];
            let half_du = curve.line.as_ref().map_or(0.0, |line| 0.5 * line.stroke.width);
            self.is_near(i, place, half_du + self.reach_du()) && is_line(curve, &drawing.fills)
        };
        let there = (0..drawing.curves.len()).rev().find(is_there);
        there.and_then(|i| self.sheet.editor.curve_ids().get(i).copied())
    }

    /// Whether a curve comes within a distance of a place.
    fn is_near(&self, curve: usize, place: Point, most_du: f64) -> bool {
        let map = self.sheet.picture.map();
        let points = map.triangulation().points();
        map.steps(curve).iter().any(|step| {
            let [a, b] = map.ends(step.left).map(|node| points[node as usize]);
            Line::new(a, b).nearest(place, 0.0).distance_sq <= most_du * most_du
        })
    }

    fn select_in_marquee(&mut self) {
        let (Some(marquee), Some(Held::Grip(grip))) = (self.marquee(), &self.held) else { return };
        let scribbles = self.document().scribbles.iter().zip(self.sheet.editor.scribble_ids());
        let touched = scribbles.filter(|(scribble, _)| self.scribbles_shown && is_touched(scribble, marquee));
        let touched: Vec<u32> = touched.map(|(_, id)| *id).collect();
        let kept = if grip.adds { grip.before.clone() } else { Selection::default() };
        self.select(kept.with(touched));
    }

    /// Where there is no scribble in the rectangle, lines are meant that lie in it wholly.
    fn select_lines_in_marquee(&mut self, grip: &Grip) {
        if !self.selected_scribbles().is_empty() || !self.lines_shown {
            return;
        }
        let marquee = Rect::from_points(grip.from, grip.to);
        let drawing = &self.document().drawing;
        let is_in = |curve: &Curve| {
            let bounds = curve.path.bounding_box();
            marquee.union(bounds) == marquee && is_line(curve, &drawing.fills)
        };
        let curves = drawing.curves.iter().zip(self.sheet.editor.curve_ids());
        let within: Vec<u32> = curves.filter(|(curve, _)| is_in(curve)).map(|(_, id)| *id).collect();
        self.select(self.selection.with(within));
    }
}

/// Whether a curve can be selected: it is drawn as a line, and is not the outline of solid ink, which would stay behind.
fn is_line(curve: &Curve, fills: &[Fill]) -> bool {
    let way = curve.path.elements();
    let is_outlined = |fill: &Fill| fill.path.elements().windows(way.len().max(1)).any(|part| part == way);
    curve.line.is_some() && !fills.iter().any(is_outlined)
}

fn is_touched(scribble: &Scribble, marquee: Rect) -> bool {
    let [a, c] = [marquee.origin(), Point::new(marquee.x1, marquee.y1)];
    let [b, d] = [Point::new(c.x, a.y), Point::new(a.x, c.y)];
    let edges = [(a, b), (b, c), (c, d), (d, a)].map(|(from, to)| Line::new(from, to));
    let rest_du = 0.5 * (drawn_width_du(scribble) - scribble.width_du);
    scribble.points.first().is_some_and(|first| marquee.contains(*first))
        || edges.into_iter().any(|edge| scribble.is_touched(edge, rest_du))
}
