//! Numbers and points within bounds, with little code.

use kurbo::{Point, Rect};

/// `value`, or the bound that it is beyond; NaN stays NaN. The first bound is at most the second.
///
/// [`f64::clamp`] writes out its bounds where it panics: one call with bounds that are not constant takes the code that
/// writes floats into the page, 9 KB of its first load.
pub fn clamped(value: f64, [least, most]: [f64; 2]) -> f64 {
    if value < least {
        least
    } else if value > most {
        most
    } else {
        value
    }
}

/// The point itself, or the nearest one of a rectangle with its edges.
pub fn nearest_in(rect: Rect, point: Point) -> Point {
    Point::new(clamped(point.x, [rect.x0, rect.x1]), clamped(point.y, [rect.y0, rect.y1]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_beyond_a_bound_becomes_the_bound() {
        assert_eq!([-2.0, 0.25, 7.0, f64::INFINITY].map(|x| clamped(x, [-1.0, 1.0])), [-1.0, 0.25, 1.0, 1.0]);
        assert!(clamped(f64::NAN, [-1.0, 1.0]).is_nan());
    }

    #[test]
    fn a_point_comes_onto_the_nearest_edge() {
        let rect = Rect::new(0.0, 0.0, 20.0, 10.0);
        assert_eq!(nearest_in(rect, Point::new(-5.0, 4.0)), Point::new(0.0, 4.0));
        assert_eq!(nearest_in(rect, Point::new(25.0, 14.0)), Point::new(20.0, 10.0));
        assert_eq!(nearest_in(rect, Point::new(3.0, 4.0)), Point::new(3.0, 4.0));
    }
}
