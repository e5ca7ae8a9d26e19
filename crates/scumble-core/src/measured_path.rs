//! Distances along a path: from a place on it to the distance from its start, and back.

use kurbo::{BezPath, CubicBez, ParamCurve, ParamCurveArclen};

/// Distances along a path are that far off at most, in du, or by that part of the path of one segment's handles.
const ACCURACY_DU: f64 = 1e-3;
const ACCURACY: f64 = 1e-6;

/// A path, and where each of its segments begins. A *place* is the number of a segment and, behind the point, how far
/// along it in its own parameter.
#[derive(Clone, Debug)]
pub struct MeasuredPath {
    segments: Vec<CubicBez>,
    /// The distance of each segment's start from that of the path, and of the end.
    starts_du: Vec<f64>,
}

impl MeasuredPath {
    /// Measures a path; its coordinates are finite.
    pub fn new(path: &BezPath) -> Self {
        let segments: Vec<_> = path.segments().map(|segment| segment.to_cubic()).collect();
        let mut end_du = 0.0;
        let mut starts_du = vec![end_du];
        for segment in &segments {
            end_du += length_du(segment);
            starts_du.push(end_du);
        }
        Self { segments, starts_du }
    }

    /// The segments, as cubics.
    pub fn segments(&self) -> &[CubicBez] {
        &self.segments
    }

    /// The length of the path.
    pub fn length_du(&self) -> f64 {
        self.starts_du.last().copied().unwrap_or_default()
    }

    /// The distance of a place from the start; what is no place counts as the nearer end.
    pub fn at_du(&self, place: f64) -> f64 {
        let segment = (place.max(0.0) as usize).min(self.segments.len());
        let start_du = self.starts_du[segment];
        let part = (place - segment as f64).clamp(0.0, 1.0);
        match self.segments.get(segment) {
            Some(c) if part > 0.0 => start_du + length_du(&c.subsegment(0.0..part)),
            _ => start_du,
        }
    }

    /// The place at a distance from the start; the nearer end where that is off the path.
    pub fn place(&self, at_du: f64) -> f64 {
        let after = self.starts_du.partition_point(|start_du| *start_du <= at_du);
        let Some(segment) = after.checked_sub(1) else { return 0.0 };
        match self.segments.get(segment) {
            Some(c) => {
                segment as f64 + c.inv_arclen(at_du - self.starts_du[segment], accuracy_du(c)).min(1.0)
            }
            None => self.segments.len() as f64,
        }
    }
}

/// The length of a segment with finite coordinates.
pub(crate) fn length_du(c: &CubicBez) -> f64 {
    c.arclen(accuracy_du(c))
}

fn accuracy_du(c: &CubicBez) -> f64 {
    let around_du = (c.p1 - c.p0).hypot() + (c.p2 - c.p1).hypot() + (c.p3 - c.p2).hypot();
    ACCURACY_DU.max(ACCURACY * around_du)
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::{Circle, Shape};

    #[test]
    fn places_and_distances_turn_into_each_other() {
        let path = MeasuredPath::new(&Circle::new((500.0, 500.0), 100.0).to_path(1e-6));
        let length_du = 200.0 * std::f64::consts::PI;
        assert!((path.length_du() - length_du).abs() < 0.01);
        for part in [0.0, 0.1, 0.25, 0.6, 0.999] {
            let place = path.place(part * length_du);
            assert!((path.at_du(place) - part * length_du).abs() < 0.01, "{part}");
            assert!((place - part * path.segments().len() as f64).abs() < 0.01, "{part}: {place}");
        }
    }

    #[test]
    fn what_is_off_the_path_counts_as_its_nearer_end() {
        let path = MeasuredPath::new(&BezPath::from_svg("M 0 0 L 10 0 L 10 5").expect("a path"));
        assert_eq!(
            [-1.0, 0.0, 2.0, 9.0, f64::NAN].map(|place| path.at_du(place)),
            [0.0, 0.0, 15.0, 15.0, 0.0]
        );
        assert_eq!([-1.0, 15.1, 1e300].map(|at_du| path.place(at_du)), [0.0, 2.0, 2.0]);
        assert_eq!(MeasuredPath::new(&BezPath::new()).at_du(1.0), 0.0);
    }
}
