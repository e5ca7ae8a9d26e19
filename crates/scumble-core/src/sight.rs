//! The `Sight` engine: a scribble claims the sides that it sees, and the latest scribble wins.
//!
//! The sampling is that of section 4.1 of Bao & Fu 2019; what the paper then does to tell a scribble's own
//! boundary from what it sees through gaps is left to other engines.

use kurbo::Point;

use crate::engine::{Engine, Labels};
use crate::planar_map::PlanarMap;
use crate::sample::clip;
use crate::scribble::Scribble;
use crate::triangulation::SideId;
use crate::visibility::visibility_polygon;

/// Distance of the samples along a scribble, in du.
const SAMPLE_SPACING_DU: f64 = 3.0;

/// Claims sides by sight; keeps what each scribble of the last call saw.
#[derive(Clone, Debug, Default)]
pub struct Sight {
    reaches: Vec<Reach>,
}

impl Engine for Sight {
    fn label(&mut self, map: &PlanarMap, scribbles: &[Scribble]) -> Labels {
        self.reaches.resize_with(scribbles.len(), Reach::default);
        let mut labels = Labels::none(map);
        for (i, (scribble, reach)) in scribbles.iter().zip(&mut self.reaches).enumerate() {
            reach.follow(map, &scribble.points);
            for side in &reach.sides {
                labels.sides[side.index()] = Some(i as u32);
            }
        }
        labels
    }
}

/// What a scribble saw, as far as it has been followed.
#[derive(Clone, Debug, Default)]
struct Reach {
    points: Vec<Point>,
    /// Way from the last sample to the last point, in du.
    since_sample_du: f64,
    triangle: usize,
    /// Sorted, without repeats.
    sides: Vec<SideId>,
}

impl Reach {
    /// Goes on to the end of a scribble, from the start again where it is not the one that was followed so far.
    fn follow(&mut self, map: &PlanarMap, points: &[Point]) {
        if !points.starts_with(&self.points) {
            *self = Self::default();
        }
        for &p in &points[self.points.len()..] {
            match self.points.last().copied() {
                None => self.look(map, p),
                Some(last) => self.advance(map, last, p),
            }
            self.points.push(p);
        }
        self.sides.sort_unstable();
        self.sides.dedup();
    }

    /// Samples at equal distances along the whole stroke, however it was cut into points; off the page there is
    /// nothing to see.
    fn advance(&mut self, map: &PlanarMap, from: Point, to: Point) {
        let length_du = (to - from).hypot();
        let first_du = SAMPLE_SPACING_DU - self.since_sample_du;
        let on_page = clip([from, to], map.frame()).unwrap_or([1.0, 0.0]);
        let [begin, end] = on_page.map(|t| (t * length_du - first_du) / SAMPLE_SPACING_DU);
        for i in begin.max(0.0).ceil() as u64..(end + 1.0).max(0.0).floor() as u64 {
            self.look(map, from.lerp(to, (first_du + i as f64 * SAMPLE_SPACING_DU) / length_du));
        }
        self.since_sample_du = (self.since_sample_du + length_du) % SAMPLE_SPACING_DU;
    }

    /// Adds the sides whose middle is seen from a point.
    fn look(&mut self, map: &PlanarMap, eye: Point) {
        let mesh = map.triangulation();
        let Some(triangle) = mesh.locate(eye, self.triangle) else { return };
        self.triangle = triangle;
        let polygon = visibility_polygon(mesh, eye, triangle);
        let middles = polygon.iter().filter(|seen| seen.interval[0] <= 0.5 && 0.5 <= seen.interval[1]);
        self.sides.extend(middles.filter_map(|seen| mesh.side(seen.half_edge)));
    }
}
