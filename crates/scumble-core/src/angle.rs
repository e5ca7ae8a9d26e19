//! Angles by arithmetic alone: the library's own inverse tangent may differ from machine to machine.

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
}
