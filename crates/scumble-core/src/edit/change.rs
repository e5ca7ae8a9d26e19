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

    /// What it puts another in the place of as a whole.
    fn place(&self) -> Option<Place> {
        match self {
            Self::ReplaceScribble(index, _) => Some(Place::Scribble(*index)),
            Self::ReplaceCurve(index, _) => Some(Place::Curve(*index)),
            Self::SetSettings(_) => Some(Place::Settings),
            Self::SetTracing(_) => Some(Place::Tracing),
            _ => None,
        }
    }

    /// Whether scribbles or curves have other indices after it.
    fn is_of_order(&self) -> bool {
        use Change::{InsertCurve, InsertScribble, MoveScribble, RemoveCurve, RemoveScribble};
        matches!(
            self,
            InsertScribble(..) | RemoveScribble(_) | MoveScribble { .. } | InsertCurve(..) | RemoveCurve(_)
        )
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

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Place {
    Scribble(usize),
    Curve(usize),
    Settings,
    Tracing,
}

/// Changes that, applied from the last to the first, take back what a gesture has done. However often a slider or an arrow key
/// puts another thing in a place, they have once what was there at first.
#[derive(Clone, Debug, Default)]
pub(super) struct Back {
    pub(super) changes: Vec<Change>,
    /// Places that have had other things since the order was last changed, in their order.
    places: Vec<Place>,
}

impl Back {
    pub(super) fn push(&mut self, change: Change) {
        if change.is_of_order() {
            self.places.retain(|place| matches!(place, Place::Settings | Place::Tracing));
        }
        if let Some(place) = change.place() {
            let Err(i) = self.places.binary_search(&place) else { return };
            self.places.insert(i, place);
        }
        self.changes.push(change);
    }
}

/// The colour of the only scribble that came, went or took another one, or of a swatch that did, given what takes that back and the
/// document as it is now.
pub(super) fn paint(back: &[Change], document: &Document) -> Option<Paint> {
    match *back {
        [Change::InsertScribble(_, _, ref gone)] => Some(gone.color),
        [Change::RemoveScribble(i) | Change::RecolorScribble(i, _)]
        | [Change::SetPalette(_), .., Change::RecolorScribble(i, _)] => {
            document.scribbles.get(i).map(|scribble| scribble.color)
        }
        _ => None,
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_that_has_many_things_keeps_the_first_until_the_order_changes() {
        let blank = || Curve { path: kurbo::BezPath::new(), line: None };
        let mut back = Back::default();
        for _ in 0..100 {
            back.push(Change::ReplaceCurve(0, blank()));
            back.push(Change::ReplaceCurve(1, blank()));
        }
        assert_eq!(back.changes.len(), 2);
        back.push(Change::RemoveCurve(0));
        back.push(Change::ReplaceCurve(0, blank()));
        back.push(Change::ReplaceCurve(0, blank()));
        assert_eq!(back.changes.len(), 4);
        back.push(Change::SetTracing(None));
        back.push(Change::RemoveCurve(0));
        back.push(Change::SetTracing(None));
        assert_eq!(back.changes.len(), 6, "a slider has no place in the order");
    }
}
