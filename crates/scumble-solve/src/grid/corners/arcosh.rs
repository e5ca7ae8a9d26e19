//! The inverse hyperbolic cosine: what the solution is like around a stretch with a colour in a straight wall without one.

/// The inverse hyperbolic cosine of a number z in the upper half of the complex plane, from 0 to πi: 2 ln(√((z + 1) / 2) +
/// √((z − 1) / 2)); after W. Kahan, *Branch cuts for complex elementary functions* (1987).
pub(super) fn arcosh([x, y]: [f64; 2]) -> [f64; 2] {
    let root = |x: f64| {
        let length = x.hypot(y);
        [length + x, length - x].map(|double| 0.5 * double.max(0.0).sqrt())
    };
    let ([a, b], [c, d]) = (root(x + 1.0), root(x - 1.0));
    [2.0 * (a + c).hypot(b + d).ln(), 2.0 * (b + d).atan2(a + c)]
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use super::*;

    #[test]
    fn the_inverse_hyperbolic_cosine_is_that_of_numbers_whose_cosine_is_known() {
        for (real, imaginary) in [(0.0, 0.0), (0.0, 1.0), (0.0, PI), (2.0, 0.0), (2.0, PI), (0.5, 2.0)] {
            let z = [f64::cosh(real) * f64::cos(imaginary), f64::sinh(real) * f64::sin(imaginary)];
            let [x, y] = arcosh(z);
            assert!((x - real).abs() < 1e-7 && (y - imaginary).abs() < 1e-7, "{z:?}: {x} + {y} i");
        }
    }
}
