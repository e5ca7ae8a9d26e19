//! Counts, on the tree as written, what an import leaves out or ignores.

use std::str::FromStr;

use roxmltree::{Document, Node};
use svgtypes::{Length, NumberListParser, SimplePathSegment, SimplifyingPathParser, Transform};

use crate::limits::SVG;
use crate::notes::ImportNotes;

/// Counts the elements that an import leaves out or ignores, and the shapes that are faulty.
pub(crate) fn of(xml: &Document) -> ImportNotes {
    let mut notes = ImportNotes::default();
    let elements = xml.descendants().filter(|node| matches!(node.tag_name().namespace(), None | Some(SVG)));
    for node in elements {
        match node.tag_name().name() {
            "text" | "foreignObject" => notes.texts += 1,
            "image" => notes.images += 1,
            "clipPath" => notes.clip_paths += 1,
            "mask" => notes.masks += 1,
            "filter" => notes.filters += 1,
            "marker" => notes.markers += 1,
            _ => notes.broken += usize::from(!is_readable(node)),
        }
    }
    notes
}

/// Whether the coordinates of an element are numbers that `usvg` can hold.
fn is_readable(node: Node) -> bool {
    let geometry_is_readable = match node.tag_name().name() {
        "path" => node.attribute("d").is_none_or(path_is_readable),
        "polyline" | "polygon" => node.attribute("points").is_none_or(points_are_readable),
        "rect" => lengths_are_readable(node, &["x", "y", "width", "height"]),
        "circle" => lengths_are_readable(node, &["cx", "cy", "r"]),
        "ellipse" => lengths_are_readable(node, &["cx", "cy"]),
        "line" => lengths_are_readable(node, &["x1", "y1", "x2", "y2"]),
        _ => true,
    };
    geometry_is_readable && node.attribute("transform").is_none_or(transform_is_readable)
}

fn is_usable(number: f64) -> bool {
    (number as f32).is_finite()
}

fn lengths_are_readable(node: Node, names: &[&str]) -> bool {
    let mut values = names.iter().filter_map(|name| node.attribute(*name));
    values.all(|value| Length::from_str(value).is_ok_and(|length| is_usable(length.number)))
}

fn points_are_readable(points: &str) -> bool {
    NumberListParser::from(points).all(|number| number.is_ok_and(is_usable))
}

fn transform_is_readable(transform: &str) -> bool {
    let Ok(Transform { a, b, c, d, e, f }) = transform.parse() else { return false };
    [a, b, c, d, e, f].into_iter().all(is_usable)
}

fn path_is_readable(data: &str) -> bool {
    data.trim() == "none"
        || SimplifyingPathParser::from(data).all(|segment| segment.is_ok_and(segment_is_usable))
}

fn segment_is_usable(segment: SimplePathSegment) -> bool {
    match segment {
        SimplePathSegment::MoveTo { x, y } | SimplePathSegment::LineTo { x, y } => {
            is_usable(x) && is_usable(y)
        }
        SimplePathSegment::Quadratic { x1, y1, x, y } => [x1, y1, x, y].into_iter().all(is_usable),
        SimplePathSegment::CurveTo { x1, y1, x2, y2, x, y } => {
            [x1, y1, x2, y2, x, y].into_iter().all(is_usable)
        }
        SimplePathSegment::ClosePath => true,
    }
}
