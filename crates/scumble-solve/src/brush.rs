//! The soft brush of a source: how strong it is at a place.

use kurbo::{Point, Rect, Vec2};
use scumble_core::SoftSource;

/// Segments that share a box.
const CHUNK: usize = 8;

/// The distance in which a shade on paper fades by a factor of e, in radii of the widest brush. Without it, nothing
/// would keep a shade from flowing all over a region that has no colour.
const FADE_RADII: f64 = 1.5;

/// A part of a stroke, straight.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Segment {
    start: Point,
    along: Vec2,
    /// One over the square of its length; zero where it has none.
    per_length_sq: f64,
}

/// A source whose stroke can be asked for distances.
#[derive(Debug)]
pub(crate) struct Brush {
    /// Those of the stroke; a dab has one without length.
    segments: Vec<Segment>,
    /// The box of every [`CHUNK`] segments.
    boxes: Vec<Rect>,
    /// The box of all of them.
    bounds: Rect,
    pub(crate) radius_du: f64,
    pub(crate) weight: f64,
}

impl Brush {
    pub(crate) fn new(source: &SoftSource) -> Self {
        let dab = source.points.iter().take(2 - source.points.len().min(2)).map(|&p| [p, p]);
        let ends: Vec<_> = source.points.windows(2).map(|w| [w[0], w[1]]).chain(dab).collect();
        let boxes: Vec<_> = ends.chunks(CHUNK).map(|chunk| bounds(chunk.as_flattened())).collect();
        let radius_du = source.radius_du;
        let bounds = bounds(ends.as_flattened());
        let segments = ends.into_iter().map(Segment::new).collect();
        Self { segments, boxes, bounds, radius_du, weight: source.weight }
    }

    /// What no point within its radius lies outside of.
    pub(crate) fn bounds(&self) -> Rect {
        self.bounds.inflate(self.radius_du, self.radius_du)
    }

    /// The distance of a point from the stroke, in du, where it is less than so much; that much elsewhere.
    pub(crate) fn distance_du(&self, p: Point, most_du: f64) -> f64 {
        let mut least_sq = most_du * most_du;
        if distance_sq_to_rect(p, self.bounds) >= least_sq {
            return most_du;
        }
        for (rect, chunk) in self.boxes.iter().zip(self.segments.chunks(CHUNK)) {
            if distance_sq_to_rect(p, *rect) < least_sq {
                least_sq = chunk.iter().map(|segment| segment.distance_sq(p)).fold(least_sq, f64::min);
            }
        }
        least_sq.sqrt()
    }

    /// The segments that are nearest to some point within a distance of a place, and within the radius of it; none
    /// where the brush does not reach.
    pub(crate) fn near(&self, p: Point, spread_du: f64, near: &mut Vec<Segment>) {
        near.clear();
        let most_du = self.radius_du + spread_du;
        let least_du = self.distance_du(p, most_du);
        if least_du >= most_du {
            return;
        }
        let reach_sq = (least_du + 2.0 * spread_du).min(most_du).powi(2);
        for (rect, chunk) in self.boxes.iter().zip(self.segments.chunks(CHUNK)) {
            if distance_sq_to_rect(p, *rect) <= reach_sq {
                near.extend(chunk.iter().filter(|segment| segment.distance_sq(p) <= reach_sq));
            }
        }
    }

    /// The factor of `u − c` in the equation at a point to which no other segments are nearest than some of these,
    /// in 1/du².
    pub(crate) fn strength(&self, p: Point, near: &[Segment]) -> f64 {
        let least_sq = near.iter().map(|segment| segment.distance_sq(p)).fold(f64::INFINITY, f64::min);
        self.strength_at(least_sq)
    }

    /// The same at a distance from the stroke of which this is the square.
    pub(crate) fn strength_at(&self, distance_sq: f64) -> f64 {
        let radius_sq = self.radius_du * self.radius_du;
        let inside = (1.0 - distance_sq / radius_sq).max(0.0);
        self.weight / radius_sq * inside * inside
    }
}

impl Segment {
    fn new([start, end]: [Point; 2]) -> Self {
        let along = end - start;
        let length_sq = along.hypot2();
        let per_length_sq = Some(length_sq.recip()).filter(|x| x.is_finite()).unwrap_or(0.0);
        Self { start, along, per_length_sq }
    }

    fn distance_sq(&self, p: Point) -> f64 {
        let to = p - self.start;
        let t = (to.dot(self.along) * self.per_length_sq).clamp(0.0, 1.0);
        (to - self.along * t).hypot2()
    }
}

/// The pull of the paper on a region that has no colour but is shaded, in 1/du²: a source of clear colour that is
/// everywhere, and so weak that it shows beyond the others alone.
pub(crate) fn fade_strength<'a>(brushes: impl Iterator<Item = &'a Brush>) -> f64 {
    let reach_du = FADE_RADII * brushes.map(|brush| brush.radius_du).fold(0.0, f64::max);
    (reach_du * reach_du).recip()
}

fn bounds(points: &[Point]) -> Rect {
    let first = points.first().copied().unwrap_or_default();
    points.iter().fold(Rect::from_points(first, first), |bounds, p| bounds.union_pt(*p))
}

fn distance_sq_to_rect(p: Point, rect: Rect) -> f64 {
    let out = |x: f64, from: f64, to: f64| (from - x).max(x - to).max(0.0);
    let (x, y) = (out(p.x, rect.x0, rect.x1), out(p.y, rect.y0, rect.y1));
    x * x + y * y
}

#[cfg(test)]
mod tests {
    use super::*;

    fn brush(points: &[(f64, f64)]) -> Brush {
        let points = points.iter().map(|&p| p.into()).collect();
        Brush::new(&SoftSource { points, radius_du: 10.0, weight: 8.0, color: [1.0; 4], crosses: false })
    }

    #[test]
    fn it_is_strongest_in_the_middle_and_ends_at_its_radius() {
        for (points, place) in [(vec![(5.0, 5.0)], (5.0, 5.0)), (vec![(0.0, 0.0), (40.0, 0.0)], (20.0, 0.0))]
        {
            let brush = brush(&points);
            let strength = |away: f64| {
                let p = Point::new(place.0, place.1 + away);
                let mut near = Vec::new();
                brush.near(p, 3.0, &mut near);
                brush.strength(p, &near)
            };
            assert_eq!([0.0, 5.0, 10.0, 11.0].map(strength), [0.08, 0.08 * 0.5625, 0.0, 0.0]);
        }
    }

    #[test]
    fn distances_are_those_to_the_nearest_segment() {
        let way: Vec<_> = (0..100).map(|i| (f64::from(i), 30.0 * (f64::from(i) * 0.2).sin())).collect();
        let brush = brush(&way);
        for p in (0..200).map(|i| Point::new(f64::from(i) - 40.0, f64::from(i * 37 % 90) - 45.0)) {
            let all =
                brush.segments.iter().map(|segment| segment.distance_sq(p)).fold(f64::INFINITY, f64::min);
            assert_eq!(brush.distance_du(p, 1e9), all.sqrt());
            assert_eq!(brush.distance_du(p, 7.0), all.sqrt().min(7.0));
        }
    }
}
