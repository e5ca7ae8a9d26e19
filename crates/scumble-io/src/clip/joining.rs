//! Parts of outlines put together where they meet.

use kurbo::{BezPath, PathEl, Point};

/// A part with those that go on from its end, as long as there are some as near as this.
pub(super) fn grown(mut outline: BezPath, parts: &mut Vec<BezPath>, meet_du: f64) -> BezPath {
    loop {
        let Some([start, end]) = ends(&outline) else { return outline };
        let distances =
            parts.iter().enumerate().filter_map(|(i, part)| Some((i, ends(part)?))).flat_map(
                |(i, [first, last])| [(first.distance(end), i, false), (last.distance(end), i, true)],
            );
        let next = distances.min_by(|a, b| a.0.total_cmp(&b.0)).filter(|next| next.0 <= meet_du);
        let to_start = start.distance(end);
        match next {
            Some((distance, i, is_reversed)) if distance < to_start || to_start > meet_du => {
                let part = parts.remove(i);
                let part = if is_reversed { part.reverse_subpaths() } else { part };
                outline.extend(part.elements()[1..].iter().copied());
            }
            _ if to_start <= meet_du => {
                outline.close_path();
                return outline;
            }
            _ => return outline,
        }
    }
}

/// The first point of an outline that is not closed, and the last.
fn ends(outline: &BezPath) -> Option<[Point; 2]> {
    let [PathEl::MoveTo(start), .., last] = outline.elements() else { return None };
    last.end_point().map(|end| [*start, end])
}
