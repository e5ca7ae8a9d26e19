//! The changes that gestures are made of.

use std::mem::replace;

use super::Document;
use crate::color::Paint;
use crate::color_points::ColorPoint;
use crate::drawing::Curve;
use crate::palette::Swatch;
use crate::scribble::Scribble;
use crate::settings::Settings;
use crate::tracing::Tracing;

/// A change of a document; applying it gives the change that takes it back.
#[derive(Clone, Debug)]
pub(super) enum Change {
    InsertScribble(usize, u32, Scribble),
    RemoveScribble(usize),
    ReplaceScribble(usize, Scribble),
    RecolorScribble(usize, Paint),
    RecolorPoint(usize, Paint),
    MoveScribble {
        from: usize,
        to: usize,
    },
    ReplaceCurve(usize, Curve),
    RemoveCurve(usize),
    /// With all colours set by hand: those of the curve had gone with it.
    InsertCurve(usize, u32, Curve, Vec<ColorPoint>),
    SetSettings(Settings),
    SetPalette(Vec<Swatch>),
    SetTracing(Option<Tracing>),
}

impl Change {
    /// Whether it is one of the lines.
    pub(super) fn is_of_lines(&self) -> bool {
        matches!(self, Self::ReplaceCurve(..) | Self::RemoveCurve(_) | Self::InsertCurve(..))
    }

    /// Whether it is of what has sliders.
    pub(super) fn has_slider(&self) -> bool {
        self.is_of_slider_of(self)
    }

    /// Whether two changes are of the same slider, so that this one takes back what the other does, too.
    pub(super) fn is_of_slider_of(&self, other: &Self) -> bool {
        use Change::{SetSettings, SetTracing};
        matches!((self, other), (SetSettings(_), SetSettings(_)) | (SetTracing(_), SetTracing(_)))
    }

    /// Whether it is of what has sliders and would change nothing.
    pub(super) fn is_so(&self, document: &Document) -> bool {
        match self {
            Self::SetSettings(settings) => *settings == document.settings,
            Self::SetTracing(tracing) => *tracing == document.tracing,
            _ => false,
        }
    }
}

/// The numbers by which scribbles and curves are known, in the order of the document: whatever is done to them, and
/// wherever they come to lie, it stays theirs.
#[derive(Clone, Debug, Default)]
pub(super) struct Ids {
    pub(super) scribbles: Vec<u32>,
    pub(super) curves: Vec<u32>,
    next: u32,
}

impl Ids {
    pub(super) fn of(document: &Document) -> Self {
        let mut ids = Self::default();
        ids.scribbles = document.scribbles.iter().map(|_| ids.fresh()).collect();
        ids.curves = document.drawing.curves.iter().map(|_| ids.fresh()).collect();
        ids
    }

    pub(super) fn fresh(&mut self) -> u32 {
        self.next += 1;
        self.next
    }
}

/// Makes a change; returns the one that takes it back.
pub(super) fn apply(document: &mut Document, ids: &mut Ids, change: Change) -> Change {
    let Document { drawing, scribbles, color_points, settings, palette, tracing } = document;
    match change {
        Change::InsertScribble(index, id, scribble) => {
            scribbles.insert(index, scribble);
            ids.scribbles.insert(index, id);
            Change::RemoveScribble(index)
        }
        Change::RemoveScribble(index) => {
            Change::InsertScribble(index, ids.scribbles.remove(index), scribbles.remove(index))
        }
        Change::ReplaceScribble(index, after) => {
            Change::ReplaceScribble(index, replace(&mut scribbles[index], after))
        }
        Change::RecolorScribble(index, color) => {
            Change::RecolorScribble(index, replace(&mut scribbles[index].color, color))
        }
        Change::RecolorPoint(index, color) => {
            Change::RecolorPoint(index, replace(&mut color_points[index].color, color))
        }
        Change::MoveScribble { from, to } => {
            move_within(scribbles, from, to);
            move_within(&mut ids.scribbles, from, to);
            Change::MoveScribble { from: to, to: from }
        }
        Change::ReplaceCurve(index, after) => {
            Change::ReplaceCurve(index, replace(&mut drawing.curves[index], after))
        }
        Change::RemoveCurve(index) => {
            let others = without_curve(color_points, index as u32);
            let color_points = replace(color_points, others);
            Change::InsertCurve(index, ids.curves.remove(index), drawing.curves.remove(index), color_points)
        }
        Change::InsertCurve(index, id, curve, with) => {
            drawing.curves.insert(index, curve);
            ids.curves.insert(index, id);
            *color_points = with;
            Change::RemoveCurve(index)
        }
        Change::SetSettings(after) => Change::SetSettings(replace(settings, after)),
        Change::SetPalette(after) => Change::SetPalette(replace(palette, after)),
        Change::SetTracing(after) => Change::SetTracing(replace(tracing, after)),
    }
}

/// Takes an item to another place; those on the way come closer by one, and the others stay where they are.
fn move_within<T>(items: &mut Vec<T>, from: usize, to: usize) {
    let item = items.remove(from);
    items.insert(to, item);
}

/// The colours set by hand that are left without a curve, as the indices of the others are then.
fn without_curve(points: &[ColorPoint], curve: u32) -> Vec<ColorPoint> {
    let others = points.iter().filter(|point| point.curve != curve);
    others.map(|&point| ColorPoint { curve: point.curve - u32::from(point.curve > curve), ..point }).collect()
}
