//! What points and parts of the plane lie within.

use kurbo::{Point, Rect};

/// What points lie within, if there are any.
pub fn of(points: impl IntoIterator<Item = Point>) -> Option<Rect> {
    points.into_iter().fold(None, |all, at| union(all, Some(Rect::from_points(at, at))))
}

/// What two parts of the plane lie within, if there are any.
pub fn union(a: Option<Rect>, b: Option<Rect>) -> Option<Rect> {
    if let (Some(a), Some(b)) = (a, b) { Some(a.union(b)) } else { a.or(b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_hold_all_points_and_nothing_has_none() {
        assert_eq!(of([]), None);
        assert_eq!(of([(3.0, 9.0), (-1.0, 5.0)].map(Point::from)), Some(Rect::new(-1.0, 5.0, 3.0, 9.0)));
        let dot = of([Point::new(2.0, 4.0)]);
        assert_eq!((union(None, dot), union(dot, None)), (dot, dot));
    }
}
