//! What a shape costs to read, before it is read.
//!
//! `usvg` strokes every shape to find its bounds: its time grows with the number of segments, and with their size
//! where they are curved.

use std::str::FromStr;

use kurbo::{CubicBez, Point};
use roxmltree::Node;
use svgtypes::{
    Length, NumberListParser, PathParser, PathSegment, SimplePathSegment, SimplifyingPathParser, Transform,
};

/// Coordinates beyond this, in the units of their element, are no place in a drawing.
const MAX_COORDINATE: f64 = 1e9;

/// Arcs that are wider than high, or higher than wide, by more than this are lines, if anything.
const MAX_RADIUS_RATIO: f64 = 1e6;

/// Cost at which counting ends: no drawing may cost so much.
const ENOUGH: u64 = 10_000_000;

/// Curved segments longer than this, in the units of their element, count as so many.
const LONG_SEGMENTS: [(f64, u64); 2] = [(2e4, 200), (1e3, 8)];

/// Segments of a shape, longer curves counting more; `None` where a coordinate is no number or far too large.
/// Elements that are no shapes have none.
pub(crate) fn cost(node: Node) -> Option<u64> {
    let transform = node.attribute("transform").unwrap_or_default();
    if !is_transform(transform) {
        return None;
    }
    match node.tag_name().name() {
        "path" => node.attribute("d").map_or(Some(0), path_cost),
        "polyline" | "polygon" => node.attribute("points").map_or(Some(0), points_cost),
        "line" => lengths(node, &["x1", "y1", "x2", "y2"]).map(|_| 1),
        "rect" => Some(4 + lengths(node, &["x", "y", "width", "height"]).and(corner_cost(node))?),
        "circle" | "ellipse" => lengths(node, &["cx", "cy"]).and(corner_cost(node)),
        _ => Some(0),
    }
}

fn is_usable(number: f64) -> bool {
    number.abs() <= MAX_COORDINATE
}

/// The largest of some lengths, where they are usable.
fn lengths(node: Node, names: &[&str]) -> Option<f64> {
    let mut largest = 0.0_f64;
    for value in names.iter().filter_map(|name| node.attribute(*name)) {
        let number = Length::from_str(value).ok().map(|length| length.number).filter(|n| is_usable(*n));
        largest = largest.max(number?);
    }
    Some(largest)
}

/// Four round corners, or the four arcs of an ellipse.
fn corner_cost(node: Node) -> Option<u64> {
    let given =
        ["r", "rx", "ry"].map(|name| node.attribute(name).filter(|value| *value != "auto").and(Some(name)));
    let names: Vec<_> = given.into_iter().flatten().collect();
    let radius = |name| lengths(node, &[name]).filter(|radius| *radius > 0.0);
    let fits = radius("rx").zip(radius("ry")).is_none_or(|(rx, ry)| are_radii(rx, ry));
    lengths(node, &names).filter(|_| fits).map(|radius| 4 * curve_cost(radius))
}

fn curve_cost(length: f64) -> u64 {
    LONG_SEGMENTS.iter().find(|(longer_than, _)| length > *longer_than).map_or(1, |(_, cost)| *cost)
}

fn points_cost(points: &str) -> Option<u64> {
    let mut count = 0;
    for number in NumberListParser::from(points) {
        let Ok(number) = number else { return readable_start(count / 2) };
        is_usable(number).then_some(())?;
        count += 1;
    }
    Some(count / 2)
}

/// A list is drawn up to its first error, as SVG demands, where that is a segment at least.
fn readable_start(cost: u64) -> Option<u64> {
    (cost >= 2).then_some(cost)
}

fn is_transform(text: &str) -> bool {
    let Ok(Transform { a, b, c, d, e, f }) = text.parse() else { return false };
    [a, b, c, d, e, f].into_iter().all(is_usable)
}

fn path_cost(data: &str) -> Option<u64> {
    if data.trim() == "none" {
        return Some(0);
    }
    if !PathParser::from(data).map_while(Result::ok).all(is_no_endless_arc) {
        return None;
    }
    let (mut at, mut cost) = (Point::ORIGIN, 0);
    for segment in SimplifyingPathParser::from(data) {
        let Ok(segment) = segment else { return readable_start(cost) };
        let (end, own_cost) = segment_cost(at, segment);
        if !(is_usable(end.x) && is_usable(end.y)) {
            return None;
        }
        (at, cost) = (end, cost + own_cost?);
        if cost > ENOUGH {
            break;
        }
    }
    Some(cost)
}

/// Arcs are cut into more curves the larger they are; one that is much wider than high grows with its ratio.
fn is_no_endless_arc(segment: PathSegment) -> bool {
    let PathSegment::EllipticalArc { rx, ry, x, y, .. } = segment else { return true };
    [rx, ry, x, y].into_iter().all(is_usable) && are_radii(rx, ry)
}

fn are_radii(rx: f64, ry: f64) -> bool {
    let [narrow, wide] = [rx.abs().min(ry.abs()), rx.abs().max(ry.abs())];
    narrow == 0.0 || wide <= MAX_RADIUS_RATIO * narrow
}

/// The end of a segment, and what it costs where its control points are usable.
fn segment_cost(at: Point, segment: SimplePathSegment) -> (Point, Option<u64>) {
    match segment {
        SimplePathSegment::MoveTo { x, y } | SimplePathSegment::LineTo { x, y } => {
            (Point::new(x, y), Some(1))
        }
        SimplePathSegment::Quadratic { x1, y1, x, y } => {
            let (control, end) = (Point::new(x1, y1), Point::new(x, y));
            (end, cubic_cost(CubicBez::new(at, control, control, end)))
        }
        SimplePathSegment::CurveTo { x1, y1, x2, y2, x, y } => {
            let end = Point::new(x, y);
            (end, cubic_cost(CubicBez::new(at, Point::new(x1, y1), Point::new(x2, y2), end)))
        }
        SimplePathSegment::ClosePath => (at, Some(1)),
    }
}

fn cubic_cost(c: CubicBez) -> Option<u64> {
    let length = (c.p1 - c.p0).hypot() + (c.p2 - c.p1).hypot() + (c.p3 - c.p2).hypot();
    is_usable(length).then(|| curve_cost(length))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cost_of(element: &str) -> Option<u64> {
        let xml = roxmltree::Document::parse(element).unwrap();
        cost(xml.root_element())
    }

    #[test]
    fn a_shape_costs_its_segments() {
        assert_eq!(cost_of(r#"<path d="M1 1 L 2 2 C 3 3 4 4 5 5 Q 6 6 7 7 Z"/>"#), Some(5));
        assert_eq!(cost_of(r#"<polygon points="1,1 2,2 3,3"/>"#), Some(3));
        assert_eq!(cost_of(r#"<rect width="9" height="9" rx="auto"/>"#), Some(8));
        assert_eq!(cost_of(r#"<circle r="9"/>"#), Some(4));
        assert_eq!(cost_of(r#"<line x2="10%"/>"#), Some(1));
        assert_eq!(cost_of("<g/>"), Some(0));
    }

    #[test]
    fn long_curves_cost_more_and_long_lines_do_not() {
        assert_eq!(cost_of(r#"<path d="M0 0 L 1e8 0"/>"#), Some(2));
        assert_eq!(cost_of(r#"<path d="M0 0 C 1e8 0 0 0 0 0"/>"#), Some(201));
        assert_eq!(cost_of(r#"<circle r="5000"/>"#), Some(32));
    }

    #[test]
    fn damaged_lists_are_read_up_to_the_damage() {
        assert_eq!(cost_of(r#"<path d="M1 1 L 2 2 3"/>"#), Some(2));
        assert_eq!(cost_of(r#"<polyline points="1,1 2,2 x"/>"#), Some(2));
    }

    #[test]
    fn coordinates_that_are_no_places_have_no_cost() {
        for element in [
            r#"<path d="M 0 0 L NaN 0"/>"#,
            r#"<path d="M 0 0 L 1e308 0"/>"#,
            r#"<path d="M 0 0 C 1e300 0 0 0 0 0"/>"#,
            r#"<circle r="NaN"/>"#,
            r#"<path d="M 0 0 A 1e-40 1e9 0 0 1 9 9"/>"#,
            r#"<path d="M 0 0 a 1e200 1e200 0 0 1 9 9"/>"#,
            r#"<ellipse rx="1e-30" ry="9"/>"#,
            r#"<line x2="1e30"/>"#,
            r#"<polyline points="1 1 x 1"/>"#,
            r#"<g transform="scale(NaN)"/>"#,
        ] {
            assert_eq!(cost_of(element), None, "{element}");
        }
    }
}
