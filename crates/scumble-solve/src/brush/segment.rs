//! A straight part of a stroke, along which radius and strength pass evenly from those at its start to those at its end.

use kurbo::{Point, Vec2};
use scumble_core::SoftSource;
use scumble_core::source::RADII_DU;

/// The distance from a dab at which its layer ends, in radii of it.
pub(super) const END: f64 = 2.0;

/// A part of a stroke, straight.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Segment {
    pub(super) start: Point,
    along: Vec2,
    /// One over the square of its length; zero where it has none.
    per_length_sq: f64,
    /// At its start, and how much more there is at its end.
    radius_du: [f64; 2],
    /// The part of the root of the brush's weight that is left, likewise.
    part: [f64; 2],
}

impl Segment {
    /// The one between two points of a source.
    pub(super) fn new(source: &SoftSource, [start, end]: [usize; 2]) -> Self {
        let point = |i: usize| source.points.get(i).copied().unwrap_or_default();
        let parts = |i: usize| source.parts.get(i).copied().unwrap_or([1.0; 2]);
        let radius_du = |i: usize| (source.radius_du * parts(i)[0]).max(RADII_DU[0]);
        let along = point(end) - point(start);
        let per_length_sq = Some(along.hypot2().recip()).filter(|x| x.is_finite()).unwrap_or(0.0);
        let with_rise = |of: [f64; 2]| [of[0], of[1] - of[0]];
        Self {
            start: point(start),
            along,
            per_length_sq,
            radius_du: with_rise([start, end].map(radius_du)),
            part: with_rise([start, end].map(|i| parts(i)[1])),
        }
    }

    /// Whether any of its places has strength.
    pub(super) fn shows(&self) -> bool {
        self.part != [0.0; 2]
    }

    pub(super) fn end(&self) -> Point {
        self.start + self.along
    }

    pub(super) fn radius_du(&self, t: f64) -> f64 {
        self.radius_du[0] + t * self.radius_du[1]
    }

    /// Where the foot of a point on its line is, from 0 at its start to 1 at its end, and beyond.
    pub(super) fn nearest(&self, to: Vec2) -> f64 {
        to.dot(self.along) * self.per_length_sq
    }

    pub(super) fn distance_sq_at(&self, to: Vec2, t: f64) -> f64 {
        (to - self.along * t).hypot2()
    }

    pub(super) fn distance_sq(&self, p: Point) -> f64 {
        let to = p - self.start;
        self.distance_sq_at(to, self.nearest(to).clamp(0.0, 1.0))
    }

    /// The greatest that one of its places gives at a point.
    pub(super) fn strength(&self, p: Point, weight: f64) -> f64 {
        let to = p - self.start;
        let nearest = self.nearest(to);
        if [self.radius_du[1], self.part[1]] == [0.0; 2] {
            return self.strength_at(to, nearest.clamp(0.0, 1.0), weight);
        }
        let places = [self.strongest(to, nearest).clamp(0.0, 1.0), 0.0, 1.0];
        places.into_iter().map(|t| self.strength_at(to, t, weight)).fold(0.0, f64::max)
    }

    /// The place that gives most at a point, where radius or strength varies: there the derivative is zero, which is a
    /// quadratic equation for the way from the nearest place.
    fn strongest(&self, to: Vec2, nearest: f64) -> f64 {
        let per_length = self.per_length_sq.sqrt();
        let off_sq = self.distance_sq_at(to, nearest);
        let [radius_du, part] = [self.radius_du(nearest).max(RADII_DU[0]), self.part(nearest)];
        let [widens, grows] = [self.radius_du[1], self.part[1]].map(|rise| rise * per_length);
        let way_du = if widens == 0.0 {
            let room = (radius_du * radius_du - off_sq).max(0.0);
            grows * room / (part + (part * part + 3.0 * grows * grows * room).sqrt())
        } else {
            let (slope, excess) = (widens * widens, 3.0 * off_sq - radius_du * radius_du);
            let middle = radius_du * (1.0 + slope);
            let root = (middle * middle - slope * (1.0 - slope) * excess).max(0.0).sqrt();
            widens * excess / (middle + root)
        };
        nearest + way_du * per_length
    }

    /// The greatest length that one of its places gives at a point; below zero where all have ended.
    pub(super) fn length_du(&self, p: Point) -> f64 {
        let to = p - self.start;
        let nearest = self.nearest(to);
        if self.radius_du[1] == 0.0 {
            return self.length_at(to, nearest.clamp(0.0, 1.0));
        }
        let places = [self.longest(to, nearest).clamp(0.0, 1.0), 0.0, 1.0];
        places.into_iter().map(|t| self.length_at(to, t)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The place that gives the greatest length, where the radius varies: there the radius grows as fast as half the distance.
    fn longest(&self, to: Vec2, nearest: f64) -> f64 {
        let per_length = self.per_length_sq.sqrt();
        let widens = self.radius_du[1] * per_length;
        let off_du = self.distance_sq_at(to, nearest).sqrt();
        let way_du = 2.0 * widens * off_du / (1.0 - 4.0 * widens * widens).max(0.0).sqrt();
        if way_du.is_finite() { nearest + way_du * per_length } else { nearest }
    }

    fn length_at(&self, to: Vec2, t: f64) -> f64 {
        fade_length_du(self.radius_du(t), self.distance_sq_at(to, t).sqrt())
    }

    fn part(&self, t: f64) -> f64 {
        self.part[0] + t * self.part[1]
    }

    fn strength_at(&self, to: Vec2, t: f64, weight: f64) -> f64 {
        let part = self.part(t);
        profile(weight * part * part, self.radius_du(t), self.distance_sq_at(to, t))
    }
}

/// The strength of a dab at the distance from its middle of which this is the square.
pub(super) fn profile(weight: f64, radius_du: f64, distance_sq: f64) -> f64 {
    let radius_sq = radius_du * radius_du;
    let inside = (1.0 - distance_sq / radius_sq).max(0.0);
    weight / radius_sq * inside * inside
}

/// In what length a layer falls by a factor of e at a distance from a dab, in du; below zero where the dab has ended.
pub(super) fn fade_length_du(radius_du: f64, distance_du: f64) -> f64 {
    radius_du - distance_du / END
}

#[cfg(test)]
mod tests {
    use super::*;

    const DABS: usize = 4000;

    /// From the origin to (60, 25), with parts of radius and strength at both ends.
    fn segment(parts: [[f64; 2]; 2]) -> Segment {
        let points = vec![Point::ZERO, Point::new(60.0, 25.0)];
        let parts = parts.to_vec();
        let source =
            SoftSource { points, radius_du: 20.0, weight: 1.0, color: [1.0; 4], crosses: false, parts };
        Segment::new(&source, [0, 1])
    }

    #[test]
    fn it_is_as_strong_as_the_strongest_of_its_dabs() {
        for parts in [
            [[0.1, 1.0], [1.0, 1.0]],
            [[1.0, 1.0], [0.5, 1.0]],
            [[1.0, 0.0], [1.0, 1.0]],
            [[1.0, 0.7], [1.0, 0.6]],
            [[1.0, 1.0], [1.0, 1.0]],
        ] {
            let segment = segment(parts);
            for p in
                (0..300).map(|i| Point::new(f64::from(i % 25) * 4.1 - 20.0, f64::from(i / 25) * 5.9 - 17.0))
            {
                let strength = |i: usize| {
                    let t = i as f64 / DABS as f64;
                    let [radius, part] = [0, 1].map(|k| (1.0 - t) * parts[0][k] + t * parts[1][k]);
                    profile(
                        8.0 * part.powi(2),
                        20.0 * radius,
                        segment.start.lerp(segment.end(), t).distance_squared(p),
                    )
                };
                let expected = (0..=DABS).map(strength).fold(0.0, f64::max);
                let found = segment.strength(p, 8.0);
                assert!(
                    (found - expected).abs() <= 1e-4 * expected + 1e-9,
                    "{found} {expected} at {p} of {parts:?}"
                );
            }
        }
    }

    #[test]
    fn lengths_are_the_greatest_of_its_dabs() {
        for radii in [[0.1, 1.0], [1.0, 0.5], [0.03, 1.0], [1.0, 1.0]] {
            let segment = segment(radii.map(|radius| [radius, 1.0]));
            for p in
                (0..300).map(|i| Point::new(f64::from(i % 25) * 6.1 - 40.0, f64::from(i / 25) * 7.9 - 30.0))
            {
                let length = |i: usize| {
                    let t = i as f64 / DABS as f64;
                    let radius_du = 20.0 * ((1.0 - t) * radii[0] + t * radii[1]);
                    fade_length_du(radius_du, segment.start.lerp(segment.end(), t).distance(p))
                };
                let expected = (0..=DABS).map(length).fold(f64::NEG_INFINITY, f64::max);
                let found = segment.length_du(p);
                assert!((found - expected).abs() <= 1e-2, "{found} {expected} at {p} of {radii:?}");
            }
        }
    }
}
