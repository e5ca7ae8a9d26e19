//! Angles by arithmetic alone: the library's own functions may differ from machine to machine, and sines of angles of any size
//! are 2.5 KB that every visitor of the page would load.

use kurbo::Vec2;

/// The angle between two vectors as a part of π, in `0..=1`; 0 where one of them is zero.
///
/// Good to 1e-5 (Abramowitz & Stegun 1964, 4.4.47).
pub fn angle_part(u: Vec2, v: Vec2) -> f64 {
    let (sin, cos) = (u.cross(v).abs(), u.dot(v));
    let (small, large) = (sin.min(cos.abs()), sin.max(cos.abs()));
    if large == 0.0 {
        return 0.0;
    }
    let z = small / large;
    let z2 = z * z;
    let series = 0.999_866 + z2 * (-0.330_299_5 + z2 * (0.180_141 + z2 * (-0.085_133 + z2 * 0.020_835_1)));
    let octant = z * series * std::f64::consts::FRAC_1_PI;
    let quadrant = if sin > cos.abs() { 0.5 - octant } else { octant };
    if cos < 0.0 { 1.0 - quadrant } else { quadrant }
}

/// The unit vector at an angle of some turns at most, in degrees from the x axis towards the y axis: its cosine and its sine.
///
/// Exact for right angles, good to 2e-15 for others (Taylor's series within an eighth of a turn).
pub fn unit_vector(degrees: f64) -> Vec2 {
    let quarters = (degrees / 90.0).round();
    let angle = (degrees - 90.0 * quarters).to_radians();
    // The sine starts from the product of 2 and 3, the cosine from that of 1 and 2.
    let series = |first: f64| {
        let term = |sum: f64, i: i32| {
            let k = first + 2.0 * f64::from(i);
            1.0 - angle * angle / (k * (k + 1.0)) * sum
        };
        (0..8).rev().fold(1.0, term)
    };
    let [cos, sin] = [series(1.0), angle * series(2.0)];
    match quarters.rem_euclid(4.0) as u8 {
        0 => Vec2::new(cos, sin),
        1 => Vec2::new(-sin, cos),
        2 => Vec2::new(-cos, -sin),
        _ => Vec2::new(sin, -cos),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_is_the_inverse_tangent() {
        for i in -3140..=3140 {
            let angle = f64::from(i) * 1e-3;
            let part = angle_part(Vec2::new(-2.0, 1.0), Vec2::from_angle(angle) * 0.3);
            let direction = Vec2::new(-2.0, 1.0).atan2();
            let expected = (angle - direction + 3.0 * std::f64::consts::PI) % std::f64::consts::TAU;
            let expected = (expected - std::f64::consts::PI).abs() / std::f64::consts::PI;
            assert!((part - expected).abs() < 1e-5, "{angle}: {part} is not {expected}");
        }
        assert_eq!(angle_part(Vec2::ZERO, Vec2::new(1.0, 0.0)), 0.0);
    }

    #[test]
    fn directions_are_exact_at_right_angles_and_good_between() {
        let right = [(0.0, [1.0, 0.0]), (90.0, [0.0, 1.0]), (180.0, [-1.0, 0.0]), (-90.0, [0.0, -1.0])];
        right.iter().for_each(|&(degrees, [x, y])| assert_eq!(unit_vector(degrees), Vec2::new(x, y)));
        for degrees in (-7200..=7200).map(|i| f64::from(i) * 0.1) {
            let off = unit_vector(degrees) - Vec2::from_angle(degrees.to_radians());
            assert!(off.hypot() < 2e-15, "{degrees}: {off:?}");
        }
    }
}
