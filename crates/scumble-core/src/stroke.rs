//! Samples along a stroke, at equal distances however the pen's way was cut into points (section 4.1 of Bao & Fu
//! 2019). A stroke that grows is followed from where it was left.

use kurbo::Point;

use crate::planar_map::PlanarMap;
use crate::sample::clip;

/// Distance of the samples along a scribble, in du.
pub(crate) const SAMPLE_SPACING_DU: f64 = 3.0;

/// A stroke, as far as it has been followed.
#[derive(Clone, Debug, Default)]
pub(crate) struct Stroke {
    points: Vec<Point>,
    /// Way from the last sample to the last point, in du.
    since_sample_du: f64,
    triangle: usize,
}

impl Stroke {
    /// The points that have been followed.
    pub(crate) fn points(&self) -> &[Point] {
        &self.points
    }

    /// Whether a stroke begins with what has been followed, so that [`Stroke::follow`] may go on with it.
    pub(crate) fn begins(&self, points: &[Point]) -> bool {
        points.starts_with(&self.points)
    }

    /// Goes on to the end of a stroke that [begins](Stroke::begins) like this: calls `look` with each further
    /// sample that lies on the page, and the triangle that it lies in. Off the page there is nothing to see.
    pub(crate) fn follow(&mut self, map: &PlanarMap, points: &[Point], mut look: impl FnMut(Point, usize)) {
        for &p in points.get(self.points.len()..).unwrap_or_default() {
            match self.points.last().copied() {
                None => self.sample(map, p, &mut look),
                Some(last) => self.advance(map, last, p, &mut look),
            }
            self.points.push(p);
        }
    }

    fn advance(&mut self, map: &PlanarMap, from: Point, to: Point, look: &mut impl FnMut(Point, usize)) {
        let length_du = (to - from).hypot();
        if !length_du.is_finite() {
            // There is no telling where on such a way a sample lies.
            return;
        }
        let first_du = SAMPLE_SPACING_DU - self.since_sample_du;
        let on_page = clip([from, to], map.frame()).unwrap_or([1.0, 0.0]);
        let [begin, end] = on_page.map(|t| (t * length_du - first_du) / SAMPLE_SPACING_DU);
        for i in begin.max(0.0).ceil() as u64..(end + 1.0).max(0.0).floor() as u64 {
            self.sample(map, from.lerp(to, (first_du + i as f64 * SAMPLE_SPACING_DU) / length_du), look);
        }
        self.since_sample_du = (self.since_sample_du + length_du) % SAMPLE_SPACING_DU;
    }

    fn sample(&mut self, map: &PlanarMap, eye: Point, look: &mut impl FnMut(Point, usize)) {
        let Some(triangle) = map.triangulation().locate(eye, self.triangle) else { return };
        self.triangle = triangle;
        look(eye, triangle);
    }
}
