//! What lies under the pen with the tool that selects.

use kurbo::{Affine, Line, ParamCurveNearest, Point, Rect};
use scumble_core::starts::{Starts, subpaths};
use scumble_core::{Curve, Document, Drawing, Scribble};

use super::Session;
use crate::layers::drawn_width_du;
use crate::selection::Handle;

/// So far beside a thing or a handle it may be pressed, in CSS pixels: with a mouse or a pen, and with a finger.
const REACHES_CSS: [[f64; 2]; 2] = [[4.0, 12.0], [12.0, 22.0]];

/// What can be taken hold of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Hold {
    /// A scribble or a curve, by its number.
    Thing(u32),
    Handle(Handle),
    /// The inside of the frame.
    Frame,
    /// Nothing.
    Page,
}

impl Session {
    pub(super) fn hold_at(&self, place: Point, adds: bool) -> Hold {
        let handle = if adds { None } else { self.handle_at(place) };
        let thing = || self.scribble_at(place, adds).or_else(|| self.line_at(place, adds));
        if let Some(handle) = handle {
            Hold::Handle(handle)
        } else if let Some(id) = thing() {
            Hold::Thing(id)
        } else if !adds && self.frame_turned().is_some_and(|frame| frame.contains(self.turned(place))) {
            Hold::Frame
        } else {
            Hold::Page
        }
    }

    fn handle_at(&self, place: Point) -> Option<Handle> {
        let (frame, place) = (self.frame_turned()?, self.turned(place));
        let reach_du = REACHES_CSS[usize::from(self.is_finger)][1] / self.viewport.zoom();
        // Within a small frame there must be room left to take hold of what it is around.
        let inside_du = reach_du.min(0.25 * frame.size().min_side());
        let reach_du = if frame.contains(place) { inside_du } else { reach_du };
        let is_near = |handle: &&Handle| {
            let way = handle.on(frame) - place;
            way.x.abs().max(way.y.abs()) <= reach_du
        };
        self.handles(Some(frame)).iter().find(is_near).copied()
    }

    /// A place in du, in turned ones.
    fn turned(&self, place: Point) -> Point {
        self.viewport.turned_from_du() * place
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
        let outlines = outlines(drawing);
        let is_there = |&i: &usize| {
            let curve = &drawing.curves[i];
            let half_du = curve.line.as_ref().map_or(0.0, |line| 0.5 * line.stroke.width);
            self.is_near(i, place, half_du + self.reach_du()) && is_line(curve, &outlines)
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
}

/// Whether a curve can be selected: it is drawn as a line, and is not the outline of solid ink, which would stay behind.
pub(super) fn is_line(curve: &Curve, outlines: &Starts<'_>) -> bool {
    let way = curve.path.elements();
    curve.line.is_some() && !outlines.like(way).any(|outline| outline.starts_with(way))
}

/// Those of solid ink.
pub(super) fn outlines(drawing: &Drawing) -> Starts<'_> {
    Starts::of(drawing.fills.iter().flat_map(|fill| subpaths(&fill.path)))
}

/// Whether a scribble, as it is drawn, reaches into a rectangle in turned du.
pub(super) fn is_touched(scribble: &Scribble, marquee: Rect, turned_from_du: Affine) -> bool {
    let [a, c] = [marquee.origin(), Point::new(marquee.x1, marquee.y1)];
    let [b, d] = [Point::new(c.x, a.y), Point::new(a.x, c.y)];
    let du_from_turned = turned_from_du.inverse();
    let edges = [(a, b), (b, c), (c, d), (d, a)].map(|(from, to)| du_from_turned * Line::new(from, to));
    let rest_du = 0.5 * (drawn_width_du(scribble) - scribble.width_du);
    scribble.points.first().is_some_and(|first| marquee.contains(turned_from_du * *first))
        || edges.into_iter().any(|edge| scribble.is_touched(edge, rest_du))
}
