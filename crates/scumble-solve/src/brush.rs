//! The soft brush of a source: how strong it is at a place, and how soon it fades there.
//!
//! Between two points of a stroke radius or strength passes evenly from one to the other, and a brush is as strong as the
//! strongest of all dabs along it. So a sudden change of pressure is as soft as the end of a stroke, and more points on the
//! same way change nothing.

use kurbo::{Point, Rect};
use scumble_core::{SoftSource, bounds};

use segment::END;
pub(crate) use segment::Segment;

mod segment;

/// Segments that share a box.
const CHUNK: usize = 8;

/// The least length in which a layer falls by a factor of e, in radii where its stroke is thinnest: so that the equation
/// stays one that can be solved.
const LEAST_LENGTH: f64 = 0.125;

/// A place of a stroke as it is from somewhere.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    pub(crate) distance_du: f64,
    pub(crate) radius_du: f64,
}

/// What a brush does at a place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Pull {
    /// The factor of `α − 1` in the equation, in 1/du².
    pub(crate) strength: f64,
    /// The length `ℓ` in which the layer fades, in du.
    pub(crate) length_du: f64,
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
    /// The least and the greatest radius along the stroke.
    pub(crate) radii_du: [f64; 2],
    /// At most, along the stroke.
    pub(crate) weight: f64,
    /// Whether it is the same all along.
    is_even: bool,
}

impl Brush {
    pub(crate) fn new(source: &SoftSource) -> Self {
        let last = source.points.len().saturating_sub(1);
        let ends = (0..last.max(1)).map(|i| [i, last.min(i + 1)]);
        let segments: Vec<_> = ends.map(|ends| Segment::new(source, ends)).filter(Segment::shows).collect();
        let boxes: Vec<_> = segments.chunks(CHUNK).map(bounds_of).collect();
        let radii_du = segments.iter().flat_map(|segment| [0.0, 1.0].map(|t| segment.radius_du(t)));
        Self {
            boxes,
            bounds: bounds_of(&segments),
            radii_du: radii_du.fold([f64::INFINITY, 0.0], |[least, most], r| [r.min(least), r.max(most)]),
            weight: source.weight,
            is_even: source.parts.is_empty(),
            segments,
        }
    }

    /// What its layer does not leave.
    pub(crate) fn bounds(&self) -> Rect {
        self.bounds.inflate(self.end_du(), self.end_du())
    }

    /// The distance from the stroke at which its layer ends at the latest.
    pub(crate) fn end_du(&self) -> f64 {
        END * self.radii_du[1]
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

    /// The segments that are strongest, or fade last, at some point within a distance of a place; none where the layer has
    /// ended.
    pub(crate) fn near(&self, p: Point, spread_du: f64, near: &mut Vec<Segment>) {
        near.clear();
        let most_du = self.end_du() + spread_du;
        let least_du = self.distance_du(p, most_du);
        if least_du >= most_du {
            return;
        }
        // The nearest is the strongest where all are the same.
        let reach_du = if self.is_even { (least_du + 2.0 * spread_du).min(most_du) } else { most_du };
        self.for_each_within(p, reach_du, &mut |segment| near.push(*segment));
    }

    fn for_each_within(&self, p: Point, reach_du: f64, each: &mut dyn FnMut(&Segment)) {
        let reach_sq = reach_du * reach_du;
        for (rect, chunk) in self.boxes.iter().zip(self.segments.chunks(CHUNK)) {
            if distance_sq_to_rect(p, *rect) <= reach_sq {
                chunk.iter().filter(|segment| segment.distance_sq(p) <= reach_sq).for_each(&mut *each);
            }
        }
    }

    /// The places of the stroke that may need the finest mesh at a point, of those within a distance.
    pub(crate) fn for_each_place(&self, p: Point, most_du: f64, each: &mut dyn FnMut(Place)) {
        let distance_du = self.distance_du(p, most_du);
        if distance_du >= most_du {
            return;
        }
        if self.is_even {
            return each(Place { distance_du, radius_du: self.radii_du[1] });
        }
        self.for_each_within(p, most_du, &mut |segment| {
            let to = p - segment.start;
            for t in [segment.nearest(to).clamp(0.0, 1.0), 0.0, 1.0] {
                let distance_du = segment.distance_sq_at(to, t).sqrt();
                each(Place { distance_du, radius_du: segment.radius_du(t) });
            }
        });
    }

    /// What it does at a point at which no other segments are stronger than some of these, or fade later.
    pub(crate) fn pull(&self, p: Point, near: &[Segment]) -> Pull {
        if self.is_even {
            let radius_du = self.radii_du[1];
            let distance_sq = near.iter().map(|segment| segment.distance_sq(p)).fold(f64::INFINITY, f64::min);
            let strength = segment::profile(self.weight, radius_du, distance_sq);
            return self.pull_of(strength, segment::fade_length_du(radius_du, distance_sq.sqrt()));
        }
        let strengths = near.iter().map(|segment| segment.strength(p, self.weight));
        let lengths_du = near.iter().map(|segment| segment.length_du(p));
        self.pull_of(strengths.fold(0.0, f64::max), lengths_du.fold(0.0, f64::max))
    }

    fn pull_of(&self, strength: f64, length_du: f64) -> Pull {
        Pull { strength, length_du: length_du.max(LEAST_LENGTH * self.radii_du[0]) }
    }
}

/// The middle of a triangle, and how far its corners are from there at most, in du.
pub(crate) fn around(corners: [Point; 3]) -> (Point, f64) {
    let [a, b, c] = corners.map(Point::to_vec2);
    let middle = ((a + b + c) / 3.0).to_point();
    (middle, corners.map(|corner| corner.distance(middle)).into_iter().fold(0.0, f64::max))
}

fn bounds_of(segments: &[Segment]) -> Rect {
    bounds::of(segments.iter().flat_map(|segment| [segment.start, segment.end()])).unwrap_or_default()
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
        varied(points, &[])
    }

    fn varied(points: &[(f64, f64)], parts: &[[f64; 2]]) -> Brush {
        let points = points.iter().map(|&p| p.into()).collect();
        let parts = parts.to_vec();
        Brush::new(&SoftSource {
            points,
            radius_du: 10.0,
            weight: 8.0,
            color: [1.0; 4],
            crosses: false,
            parts,
        })
    }

    /// At a place of which much around is looked at.
    fn strength(brush: &Brush, p: Point) -> f64 {
        let mut near = Vec::new();
        brush.near(p, 3.0, &mut near);
        brush.pull(p, &near).strength
    }

    #[test]
    fn it_is_strongest_in_the_middle_and_ends_at_its_radius() {
        for (points, place) in [(vec![(5.0, 5.0)], (5.0, 5.0)), (vec![(0.0, 0.0), (40.0, 0.0)], (20.0, 0.0))]
        {
            let brush = brush(&points);
            let away = |du: f64| strength(&brush, Point::new(place.0, place.1 + du));
            assert_eq!([0.0, 5.0, 10.0, 11.0].map(away), [0.08, 0.08 * 0.5625, 0.0, 0.0]);
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

    #[test]
    fn more_points_on_the_way_and_the_way_back_are_the_same_brush() {
        for [start, middle, end] in
            [[[0.1, 1.0], [0.4, 1.0], [1.0, 1.0]], [[1.0, 0.0], [1.0, 1.0 / 3.0], [1.0, 1.0]]]
        {
            let rising = varied(&[(0.0, 0.0), (60.0, 0.0)], &[start, end]);
            let falling = varied(&[(60.0, 0.0), (20.0, 0.0), (0.0, 0.0)], &[end, middle, start]);
            for p in (0..100).map(|i| Point::new(f64::from(i) - 20.0, f64::from(i * 37 % 21) - 10.0)) {
                assert!((strength(&rising, p) - strength(&falling, p)).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn without_strength_nothing_is_there() {
        let way = [(0.0, 0.0), (30.0, 0.0), (90.0, 0.0), (120.0, 0.0)];
        let brush = varied(&way, &[[1.0, 1.0], [1.0, 0.0], [1.0, 0.0], [1.0, 1.0]]);
        assert!(strength(&brush, Point::new(10.0, 0.0)) > 0.0);
        assert_eq!(strength(&brush, Point::new(60.0, 0.0)), 0.0);
        let mut places = 0;
        brush.for_each_place(Point::new(60.0, 0.0), 15.0, &mut |_| places += 1);
        assert_eq!(places, 0, "nothing that needs a finer mesh");
    }
}
