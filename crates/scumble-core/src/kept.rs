//! Numbers as files hold them: with three digits after the point.
//!
//! A drawing in work has no others, so that it is the same when it is opened again: some engines decide by less than the last
//! digit.

use kurbo::{BezPath, PathEl, Point};

use crate::color_points::ColorPoint;
use crate::drawing::{Curve, Drawing, Fill, Line};
use crate::edit::Document;
use crate::scribble::{PenPressure, Scribble, ScribbleKind};

/// Steps of numbers in one.
const STEPS: f64 = 1000.0;

/// The nearest number that a file holds.
fn kept(number: f64) -> f64 {
    (number * STEPS).round() / STEPS
}

/// The same for a length that is positive.
fn kept_length(length: f64) -> f64 {
    kept(length).max(STEPS.recip())
}

fn kept_point(p: Point) -> Point {
    Point::new(kept(p.x), kept(p.y))
}

fn kept_path(path: &BezPath) -> BezPath {
    let element = |element| match element {
        PathEl::MoveTo(p) => PathEl::MoveTo(kept_point(p)),
        PathEl::LineTo(p) => PathEl::LineTo(kept_point(p)),
        PathEl::QuadTo(a, p) => PathEl::QuadTo(kept_point(a), kept_point(p)),
        PathEl::CurveTo(a, b, p) => PathEl::CurveTo(kept_point(a), kept_point(b), kept_point(p)),
        PathEl::ClosePath => PathEl::ClosePath,
    };
    path.iter().map(element).collect()
}

impl Document {
    /// The document with the numbers that files hold.
    pub fn kept(mut self) -> Self {
        self.drawing = self.drawing.kept();
        self.scribbles = self.scribbles.into_iter().map(Scribble::kept).collect();
        let at = |p: ColorPoint| ColorPoint { at_du: kept(p.at_du), ..p };
        self.color_points = self.color_points.into_iter().map(at).collect();
        self.settings.gap_closing = kept(self.settings.gap_closing);
        self
    }
}

impl Drawing {
    /// The drawing with the numbers that files hold.
    pub fn kept(mut self) -> Self {
        self.curves = self.curves.into_iter().map(Curve::kept).collect();
        let fill = |fill: Fill| Fill { path: kept_path(&fill.path), ..fill };
        self.fills = self.fills.into_iter().map(fill).collect();
        self
    }
}

impl Curve {
    /// The curve with the numbers that files hold.
    pub fn kept(self) -> Self {
        Self { path: kept_path(&self.path), line: self.line.map(Line::kept) }
    }
}

impl Line {
    fn kept(mut self) -> Self {
        let stroke = &mut self.stroke;
        stroke.width = kept_length(stroke.width);
        stroke.miter_limit = kept(stroke.miter_limit);
        stroke.dash_offset = kept(stroke.dash_offset);
        stroke.dash_pattern.iter_mut().for_each(|dash| *dash = kept(*dash));
        self
    }
}

impl Scribble {
    /// The scribble with the numbers that files hold.
    pub fn kept(mut self) -> Self {
        self.width_du = kept_length(self.width_du);
        self.points.iter_mut().for_each(|p| *p = kept_point(*p));
        self.kind = self.kind.kept();
        self
    }
}

impl ScribbleKind {
    fn kept(mut self) -> Self {
        if let Self::Shade(shading) = &mut self {
            shading.strength = kept(shading.strength);
            if let PenPressure::Radius(parts) | PenPressure::Strength(parts) = &mut shading.pressure {
                parts.iter_mut().for_each(|part| *part = kept(*part));
            }
        }
        self
    }
}
