//! How finely the ends of a curve's segments are sampled: where it ends or turns, the colours around it change most.

use kurbo::{BezPath, CubicBez, PathSeg, Vec2};

use crate::planar_map::Sampling;

/// A piece at a corner is this many times as long as one at a tip.
const CORNER: f64 = 2.0;

/// The cosine of the least turn that is a corner: 45°.
const CORNER_COSINE: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Curves smaller than this, in du, have longer pieces at their ends, in proportion: what a curve spoils around itself is
/// about as large as it is.
const SMALL_DU: f64 = 48.0;

/// The segments of a curve that have a length, and how long a piece of each may be at its start and at its end, in du.
pub(super) fn segments(path: &BezPath, sampling: &Sampling) -> Vec<(PathSeg, [f64; 2])> {
    let scale = (SMALL_DU / path.control_box().size().max_side()).max(1.0);
    let all: Vec<_> = path.segments().filter(|segment| directions(segment.to_cubic()).is_some()).collect();
    let mut ends_du = vec![[sampling.spacing_du; 2]; all.len()];
    for (i, segment) in all.iter().enumerate() {
        let next = (i + 1) % all.len();
        if let Some(tips) = sharpness(segment.to_cubic(), all[next].to_cubic()) {
            let end_du = sampling.spacing_du.min(scale * tips * sampling.tip_du);
            (ends_du[i][1], ends_du[next][0]) = (end_du, end_du);
        }
    }
    all.into_iter().zip(ends_du).collect()
}

/// How many times as long as at a tip a piece may be where one segment is followed by another; `None` where they go on
/// smoothly.
fn sharpness(before: CubicBez, after: CubicBez) -> Option<f64> {
    if before.p3 != after.p0 {
        return Some(1.0);
    }
    let ([_, out], [into, _]) = (directions(before)?, directions(after)?);
    (out.dot(into) < CORNER_COSINE).then_some(CORNER)
}

/// The directions at both ends; `None` for a point.
fn directions(c: CubicBez) -> Option<[Vec2; 2]> {
    let first = |ways: [Vec2; 3]| ways.into_iter().find(|way| way.hypot2() > 0.0).map(Vec2::normalize);
    Some([first([c.p1 - c.p0, c.p2 - c.p0, c.p3 - c.p0])?, first([c.p3 - c.p2, c.p3 - c.p1, c.p3 - c.p0])?])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ends_du(path: &str) -> Vec<[f64; 2]> {
        let path = BezPath::from_svg(path).expect("a path");
        segments(&path, &Sampling::default()).into_iter().map(|(_, ends_du)| ends_du).collect()
    }

    #[test]
    fn pieces_are_short_at_tips_and_corners_and_not_between() {
        assert_eq!(ends_du("M 0 0 H 200 V 200 L 210 400"), [[0.5, 1.0], [1.0, 4.0], [4.0, 0.5]]);
        assert_eq!(ends_du("M 0 0 H 200 V 200 Z"), [[1.0; 2]; 3]);
    }

    #[test]
    fn pieces_of_small_curves_are_longer() {
        assert_eq!(ends_du("M 0 0 H 24"), [[1.0; 2]]);
        assert_eq!(ends_du("M 0 0 H 4"), [[4.0; 2]]);
    }

    #[test]
    fn a_segment_without_length_is_no_corner() {
        assert_eq!(ends_du("M 0 0 H 100 h 0 H 200"), [[0.5, 4.0], [4.0, 0.5]]);
        assert!(ends_du("M 5 5 h 0").is_empty());
    }
}
