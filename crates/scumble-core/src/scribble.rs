//! A scribble: a stroke of colour that a person drew over the lines, to fill regions or to shade where it was drawn.

use kurbo::{Line, ParamCurveNearest, Point, Rect, Shape};

use crate::bounds;
use crate::color::Paint;

/// A stroke of colour. A single point is a dab.
#[derive(Clone, Debug, PartialEq)]
pub struct Scribble {
    /// The colour as picked, or nothing.
    pub color: Paint,
    /// What becomes of it.
    pub kind: ScribbleKind,
    /// Width of the drawn stroke in du; positive.
    pub width_du: f64,
    /// The pen's way, in du; at least one point, all finite.
    pub points: Vec<Point>,
}

/// What a scribble does.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum ScribbleKind {
    /// Colours the sides of curves, as the engine sees it.
    #[default]
    Fill,
    /// Colours the place where it was drawn, and leaves the sides of curves as they are.
    Shade(Shading),
}

/// How a shading scribble colours its place. Half its width is the radius of its soft brush.
#[derive(Clone, Debug, PartialEq)]
pub struct Shading {
    /// How far the colour gets its way, within `0..=1`: not at all, to all the way along the middle of the stroke.
    pub strength: f64,
    /// Whether it goes on beyond the region that it begins in: the first that a length of half its width lies in or, where
    /// it is shorter, the one that most of it lies in.
    pub crosses: bool,
    /// What a pen made of it along the stroke.
    pub pressure: PenPressure,
}

impl Default for Shading {
    /// A clear highlight.
    fn default() -> Self {
        Self { strength: 0.5, crosses: false, pressure: PenPressure::Even }
    }
}

/// What varies along a shading scribble, by how hard a pen pressed: the part that is left of it at each point, within
/// `0..=1`, and evenly more or less between them. At points beyond the end of the list all is left.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum PenPressure {
    /// Nothing.
    #[default]
    Even,
    /// Its radius.
    Radius(Vec<f64>),
    /// Its strength.
    Strength(Vec<f64>),
}

impl PenPressure {
    /// The parts that are left of radius and strength at a point of the stroke.
    pub fn parts(&self, point: usize) -> [f64; 2] {
        let part = |parts: &[f64]| parts.get(point).copied().unwrap_or(1.0);
        match self {
            Self::Even => [1.0, 1.0],
            Self::Radius(parts) => [part(parts), 1.0],
            Self::Strength(parts) => [1.0, part(parts)],
        }
    }
}

impl ScribbleKind {
    /// That of a stroke through these places of one of this kind: the numbers of its points, or where between two of them.
    pub(crate) fn through(&self, places: &[f64]) -> Self {
        match self {
            Self::Fill => Self::Fill,
            Self::Shade(shading) => {
                Self::Shade(Shading { pressure: shading.pressure.through(places), ..*shading })
            }
        }
    }
}

impl PenPressure {
    fn through(&self, places: &[f64]) -> Self {
        let at = |parts: &[f64], place: f64| {
            let [from, to] =
                [place.floor(), place.ceil()].map(|point| parts.get(point as usize).copied().unwrap_or(1.0));
            from + place.fract() * (to - from)
        };
        let along = |parts: &[f64]| places.iter().map(|&place| at(parts, place)).collect();
        match self {
            Self::Even => Self::Even,
            Self::Radius(parts) => Self::Radius(along(parts)),
            Self::Strength(parts) => Self::Strength(along(parts)),
        }
    }
}

impl Scribble {
    /// Whether it colours the sides of curves.
    pub fn is_fill(&self) -> bool {
        self.kind == ScribbleKind::Fill
    }

    /// How it shades, if it does.
    pub fn shading(&self) -> Option<&Shading> {
        match &self.kind {
            ScribbleKind::Fill => None,
            ScribbleKind::Shade(shading) => Some(shading),
        }
    }

    /// The bounds of the pen's way, in du; none where it has no points.
    pub fn bounds_du(&self) -> Option<Rect> {
        bounds::of(self.points.iter().copied())
    }

    /// Whether a straight way touches the stroke as it is drawn, or comes within a distance of it, in du.
    pub fn is_touched(&self, way: Line, reach_du: f64) -> bool {
        let most_du = 0.5 * self.width_du + reach_du;
        if !self
            .bounds_du()
            .is_some_and(|bounds| bounds.inflate(most_du, most_du).overlaps(way.bounding_box()))
        {
            return false;
        }
        let dab = self.points.first().map(|&point| Line::new(point, point));
        let segments = self.points.windows(2).map(|ends| Line::new(ends[0], ends[1]));
        dab.into_iter().chain(segments).any(|segment| distance_sq(segment, way) <= most_du * most_du)
    }
}

/// The square of the least distance between two segments.
fn distance_sq(a: Line, b: Line) -> f64 {
    if cross(a, b) {
        return 0.0;
    }
    let distance_sq = |point: Point, to: Line| to.nearest(point, 0.0).distance_sq;
    let from_ends = |ends: Line, to: Line| distance_sq(ends.p0, to).min(distance_sq(ends.p1, to));
    from_ends(a, b).min(from_ends(b, a))
}

/// Whether each segment has the ends of the other strictly on either side of it.
fn cross(a: Line, b: Line) -> bool {
    let parts = |a: Line, b: Line| {
        let side = |point: Point| (a.p1 - a.p0).cross(point - a.p0);
        side(b.p0) * side(b.p1) < 0.0
    };
    parts(a, b) && parts(b, a)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn scribble(points: &[(f64, f64)]) -> Scribble {
        let points = points.iter().map(|&p| p.into()).collect();
        Scribble { color: Paint::Clear, kind: ScribbleKind::Fill, width_du: 10.0, points }
    }

    fn way(from: (f64, f64), to: (f64, f64)) -> Line {
        Line::new(from, to)
    }

    #[test]
    fn a_way_touches_what_it_crosses_or_comes_near() {
        let stroke = scribble(&[(0.0, 0.0), (100.0, 0.0), (100.0, 100.0)]);
        assert!(stroke.is_touched(way((50.0, -80.0), (50.0, 80.0)), 0.0), "across");
        assert!(stroke.is_touched(way((10.0, 4.9), (90.0, 4.9)), 0.0), "along its rim");
        assert!(!stroke.is_touched(way((10.0, 5.1), (90.0, 5.1)), 0.0), "beside it");
        assert!(stroke.is_touched(way((10.0, 7.9), (90.0, 7.9)), 3.0), "within reach");
        assert!(stroke.is_touched(way((101.0, 50.0), (101.0, 50.0)), 0.0), "a click");
        assert!(!stroke.is_touched(way((-8.0, 0.0), (-80.0, 0.0)), 0.0), "beyond its end, in line with it");
    }

    #[test]
    fn a_dab_is_touched_like_a_stroke() {
        let dab = scribble(&[(50.0, 50.0)]);
        assert!(dab.is_touched(way((50.0, 50.0), (50.0, 50.0)), 0.0));
        assert!(dab.is_touched(way((0.0, 54.0), (100.0, 54.0)), 0.0));
        assert!(!dab.is_touched(way((0.0, 56.0), (100.0, 56.0)), 0.0));
        assert!(!scribble(&[]).is_touched(way((0.0, 0.0), (9.0, 9.0)), 99.0));
    }
}
