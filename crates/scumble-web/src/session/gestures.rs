//! What the pen does on the canvas: it scribbles, erases scribbles, picks a colour or moves the view.

use kurbo::{Line, Point};
use scumble_core::{Deed, Paint, Scribble, ScribbleKind};

use super::Session;
use super::selecting::Grip;
use crate::brush::{Brush, Ink};
use crate::command::{Phase, Tool};
use crate::effect::Effect;
use crate::layers::drawn_width_du;
use crate::stroke::{self, Sample};

/// The eraser reaches this far, in CSS pixels.
const ERASER_REACH_CSS: f64 = 5.0;

/// A pen that stays this close to where it came down has clicked, not dragged, in CSS pixels.
pub(super) const CLICK_CSS: f64 = 4.0;

/// What a stroke is drawn with, from its beginning to its end.
#[derive(Clone, Debug, Default)]
pub(super) struct Stroke {
    brush: Brush,
    /// Where the pen was, and how it pressed there.
    samples: Vec<Sample>,
}

impl Stroke {
    fn begin(&mut self, brush: Brush) {
        self.brush = brush;
        self.samples.clear();
    }

    fn press(&mut self, phase: Phase, samples: &[Sample]) {
        // A pen that is lifted reports no pressure where it was.
        let last = self.samples.last().map(|last| last.pressure).filter(|_| phase == Phase::Up);
        let pressed = |sample: &Sample| Sample { pressure: last.unwrap_or(sample.pressure), ..*sample };
        self.samples.extend(samples.iter().map(pressed));
    }

    /// The way through its samples, and what it is by how hard the pen pressed there.
    pub(super) fn drawn(&self, du_from_css: f64) -> (Vec<Point>, ScribbleKind) {
        self.along(&stroke::smooth(&self.samples, du_from_css))
    }

    /// The same while it is on its way, for the colours: what fills only grows at its end then, so that they go on with it.
    fn in_hand(&self, du_from_css: f64) -> (Vec<Point>, ScribbleKind) {
        match self.along(&self.samples) {
            straight @ (_, ScribbleKind::Fill) => straight,
            (_, ScribbleKind::Shade(_)) => self.drawn(du_from_css),
        }
    }

    /// The same as it is kept.
    fn kept(&self, du_from_css: f64) -> (Vec<Point>, ScribbleKind) {
        let way = stroke::smooth(&self.samples, du_from_css);
        self.along(&stroke::simplified(&way, self.brush.pressure_du(), du_from_css))
    }

    fn along(&self, way: &[Sample]) -> (Vec<Point>, ScribbleKind) {
        (way.iter().map(|sample| sample.place).collect(), self.brush.pressed(way))
    }
}

/// What a pen is that is down, where it draws no scribble.
#[derive(Debug)]
pub(super) enum Held {
    Eraser(Eraser),
    Grip(Grip),
    Picker,
    /// A hand on a place in du, which follows the pen.
    Hand(Point),
}

/// An eraser on its way.
#[derive(Debug)]
pub(super) struct Eraser {
    /// Up to here it has erased all that it touched, in du.
    last: Point,
    /// How many scribbles it has erased.
    erased: usize,
    /// Whether it has taken parts of others.
    has_rubbed: bool,
}

impl Session {
    /// Takes one batch of pointer samples: x and y in CSS pixels from the canvas' corner, and pressure, in turn.
    ///
    /// Samples that lie nowhere are left out. Pressure is within `0..=1`, and 1 for what has none.
    pub fn pointer(&mut self, phase: Phase, samples: &[f32]) {
        let samples: Vec<_> = self.samples_du(samples).collect();
        let points: Vec<_> = samples.iter().map(|sample| sample.place).collect();
        if matches!(phase, Phase::Down | Phase::Add) {
            self.stroke.begin(self.brush);
        }
        self.stroke.press(phase, &samples);
        match (phase, self.tool) {
            (Phase::Down | Phase::Add, Tool::Scribble) => self.begin_scribble(&points),
            (Phase::Down | Phase::Add, Tool::Select) => self.begin_selecting(&points, phase == Phase::Add),
            (Phase::Down | Phase::Add, Tool::Erase) | (Phase::Erase, _) => self.begin_erasing(&points),
            (Phase::Down | Phase::Add, Tool::Pick) | (Phase::Pick, _) => self.held = Some(Held::Picker),
            (Phase::Down | Phase::Add, Tool::Hand) => self.held = points.first().copied().map(Held::Hand),
            (Phase::Move, _) => self.carry_on(&points),
            (Phase::Up, _) => self.end(&points),
            (Phase::Cancel, _) => self.drop_gesture(),
        }
    }

    fn samples_du(&self, samples: &[f32]) -> impl Iterator<Item = Sample> {
        let du_from_css = self.viewport.css_from_du().inverse();
        let samples = samples.as_chunks().0.iter().map(move |&[x, y, pressure]| Sample {
            place: du_from_css * Point::new(x.into(), y.into()),
            pressure: if pressure.is_nan() { 1.0 } else { f64::from(pressure).clamp(0.0, 1.0) },
        });
        samples.filter(|sample| sample.place.is_finite())
    }

    fn carry_on(&mut self, points: &[Point]) {
        if self.sheet.editor.is_scribbling() {
            let (points, kind) = self.stroke.in_hand(self.du_from_css());
            self.sheet.editor.draw_scribble(points, kind);
            self.scribbles_changed();
        } else if let Some(Held::Hand(place)) = self.held {
            self.drag(place, points);
        } else if let Some(Held::Grip(_)) = self.held {
            self.follow_grip(points);
        } else {
            self.erase_along(points);
        }
    }

    /// Moves the view so that a place in du lies under the pen.
    fn drag(&mut self, place: Point, points: &[Point]) {
        if let Some(&under) = points.last() {
            let css_from_du = self.viewport.css_from_du();
            self.viewport.pan(css_from_du * under - css_from_du * place);
            self.stale.view = true;
        }
    }

    pub(super) fn end(&mut self, points: &[Point]) {
        if self.sheet.editor.is_scribbling() {
            return self.end_scribble();
        }
        self.carry_on(points);
        match (self.held.take(), points.last()) {
            (Some(Held::Eraser(eraser)), _) => self.end_erasing(&eraser),
            (Some(Held::Grip(grip)), _) => self.end_selecting(&grip),
            (Some(Held::Picker), Some(&place)) => self.pick(place),
            _ => {}
        }
    }

    pub(super) fn drop_gesture(&mut self) {
        if self.sheet.editor.is_scribbling() {
            return self.drop_scribble();
        }
        match self.held.take() {
            Some(Held::Eraser(_)) => {
                self.sheet.editor.abort();
                self.scribbles_changed();
            }
            Some(Held::Grip(grip)) => self.drop_grip(grip),
            _ => {}
        }
    }

    fn begin_scribble(&mut self, points: &[Point]) {
        let Some(&first) = points.first() else { return };
        let color = match self.brush.ink() {
            Ink::Paint(color) => color,
            Ink::Tone(tone) => Paint::Color(tone.step(self.color_under(first))),
        };
        let (points, kind) = self.stroke.in_hand(self.du_from_css());
        let width_du = self.stroke.brush.size_du();
        self.sheet.editor.begin_scribble(Scribble { color, kind, width_du, points });
        self.scribbles_changed();
    }

    /// Ends what is in hand, as it is.
    pub(super) fn commit(&mut self) {
        if self.sheet.editor.is_scribbling() {
            self.end_scribble();
        } else if !self.drops_too_long() {
            self.sheet.editor.commit();
        }
    }

    fn end_scribble(&mut self) {
        let (points, kind) = self.stroke.kept(self.du_from_css());
        self.sheet.editor.draw_scribble(points, kind);
        if !self.is_on_page() {
            return self.drop_scribble();
        }
        if self.drops_too_long() {
            return;
        }
        self.sheet.editor.commit();
        self.scribbles_changed();
        let scribbles = &self.document().scribbles;
        let is_fill = scribbles.last().is_some_and(Scribble::is_fill);
        self.tell(Effect::ScribbleAdded { count: scribbles.len(), is_fill });
    }

    pub(super) fn du_from_css(&self) -> f64 {
        1.0 / self.viewport.zoom()
    }

    /// Whether the last scribble may touch the page: it colours nothing where it does not.
    fn is_on_page(&self) -> bool {
        let bounds = self.document().scribbles.last().and_then(Scribble::bounds_du);
        bounds.is_some_and(|bounds| bounds.overlaps(self.document().drawing.frame()))
    }

    fn drop_scribble(&mut self) {
        self.sheet.editor.abort();
        self.scribbles_changed();
        self.tell(Effect::ScribbleDropped);
    }

    /// A click erases the uppermost scribble alone; what lies under it goes once the pen is dragged.
    fn begin_erasing(&mut self, points: &[Point]) {
        let Some(&last) = points.first() else { return };
        self.sheet.editor.begin(if self.erases_parts { Deed::Rubbed } else { Deed::Erased });
        self.held = Some(Held::Eraser(Eraser { last, erased: 0, has_rubbed: false }));
        let place = Line::new(last, last);
        let uppermost = self.touched(place).pop();
        self.erase(uppermost.as_slice(), place);
    }

    fn erase_along(&mut self, points: &[Point]) {
        for &point in points {
            let Some(Held::Eraser(eraser)) = &mut self.held else { return };
            let way = Line::new(eraser.last, point);
            if (way.p1 - way.p0).hypot() * self.viewport.zoom() >= CLICK_CSS {
                eraser.last = point;
                let touched = self.touched(way);
                self.erase(&touched, way);
            }
        }
    }

    fn end_erasing(&mut self, &Eraser { erased, has_rubbed, .. }: &Eraser) {
        self.sheet.editor.commit();
        self.forget_missing();
        let count = self.document().scribbles.len();
        if has_rubbed {
            self.tell(Effect::ScribblesRubbed { count });
        } else {
            self.tell(Effect::ScribblesErased { erased, count });
        }
    }

    /// The scribbles that the eraser touches on its way, in drawing order.
    fn touched(&self, way: Line) -> Vec<usize> {
        let reach_du = self.eraser_reach_du();
        let scribbles = self.document().scribbles.iter().enumerate();
        scribbles.filter(|(_, scribble)| scribble.is_touched(way, reach_du)).map(|(i, _)| i).collect()
    }

    fn eraser_reach_du(&self) -> f64 {
        ERASER_REACH_CSS / self.viewport.zoom()
    }

    /// Takes scribbles away, in ascending order, or what is touched of them on a way.
    fn erase(&mut self, indices: &[usize], way: Line) {
        if self.erases_parts {
            return indices.iter().rev().for_each(|i| self.rub(*i, way));
        }
        let erased = self.sheet.editor.erase_scribbles(indices);
        if let (Some(Held::Eraser(eraser)), 1..) = (&mut self.held, erased) {
            eraser.erased += erased;
            self.scribbles_changed();
        }
    }

    /// Takes what is drawn of a scribble within reach of a way; what is left of it stays in its place.
    fn rub(&mut self, index: usize, way: Line) {
        let scribble = &self.document().scribbles[index];
        let reach_du = self.eraser_reach_du() + 0.5 * drawn_width_du(scribble);
        let (Some(parts), Some(Held::Eraser(eraser))) = (scribble.rubbed(way, reach_du), &mut self.held)
        else {
            return;
        };
        eraser.has_rubbed |= !parts.is_empty();
        eraser.erased += usize::from(parts.is_empty());
        self.put_parts(index, parts);
        self.scribbles_changed();
    }

    /// Puts the parts of a scribble in its place, one after the other.
    fn put_parts(&mut self, index: usize, parts: Vec<Scribble>) {
        let editor = &mut self.sheet.editor;
        if parts.is_empty() {
            editor.erase_scribbles(&[index]);
        }
        for (i, part) in (index..).zip(parts) {
            if i == index { editor.replace_scribble(i, part) } else { editor.insert_scribble(i, part) }
        }
    }
}
