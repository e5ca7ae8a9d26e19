//! The border of the page as one more curve of the map.

use kurbo::{BezPath, Point, Rect, Size};

use super::{LATTICE_PER_DU, LatticePoint, Stretch};
use crate::sort;

/// Where a curve ends as close to the frame as this, in lattice units, the frame has a node beside its end, so that colours part
/// straight across: 48 du, three times as far as its nodes are from one another by default. Farther away these are beside it
/// well enough.
const NEAR: i32 = 48 * LATTICE_PER_DU as i32;

/// The frame's size in lattice units: the next whole one, so that the border itself lies on the lattice.
pub(crate) fn lattice_frame(size_du: Size) -> LatticePoint {
    let up = |du: f64| ((du * LATTICE_PER_DU).ceil() as i32).max(1);
    LatticePoint { x: up(size_du.width), y: up(size_du.height) }
}

pub(crate) fn frame_rect(frame: LatticePoint) -> Rect {
    Rect::from_points(Point::ORIGIN, frame.to_point())
}

/// The four edges of the frame by way of places on it, in lattice units from the origin along the frame: anticlockwise in
/// the sense of the triangulation.
pub(crate) fn frame_path(frame: LatticePoint, mut places: Vec<u32>) -> BezPath {
    let [width, height] = [frame.x, frame.y].map(|side| side as u32);
    places.extend([0, width, width + height, 2 * width + height]);
    sort::sort_unique(&mut places);
    let mut path = BezPath::new();
    path.move_to(Point::ORIGIN);
    places[1..].iter().for_each(|&place| path.line_to(point_at(frame, place as i32).to_point()));
    path.close_path();
    path
}

fn point_at(frame: LatticePoint, place: i32) -> LatticePoint {
    let half = frame.x + frame.y;
    let [x, y] = match place {
        _ if place <= frame.x => [place, 0],
        _ if place <= half => [frame.x, place - frame.x],
        _ if place <= half + frame.x => [half + frame.x - place, frame.y],
        _ => [0, 2 * half - place],
    };
    LatticePoint { x, y }
}

/// Adds the places on the frame beside the ends of a curve, and beside where it leaves the frame; none if it closes.
pub(crate) fn add_feet(frame: LatticePoint, stretches: &[Stretch], places: &mut Vec<u32>) {
    let Some(mut end) = stretches.last().map(|last| last.ends[1]) else { return };
    for &Stretch { ends: [start, next], .. } in stretches {
        if start != end {
            places.extend([end, start].into_iter().flat_map(|end| feet(frame, end)));
        }
        end = next;
    }
}

/// The places on the frame beside a point that is near it, but not on it: that is a node of the frame anyway.
fn feet(frame: LatticePoint, p: LatticePoint) -> impl Iterator<Item = u32> {
    let half = frame.x + frame.y;
    let distances_and_places = [
        (p.y, p.x),
        (frame.x - p.x, frame.x + p.y),
        (frame.y - p.y, half + frame.x - p.x),
        (p.x, 2 * half - p.y),
    ];
    let is_near = |&(distance, _): &(i32, i32)| (1..NEAR).contains(&distance);
    distances_and_places.into_iter().filter(is_near).map(|(_, place)| place as u32)
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: LatticePoint = LatticePoint { x: 400_000, y: 300_000 };

    #[test]
    fn places_lie_on_the_frame_beside_where_a_curve_ends() {
        for (end, expected) in [
            ((70_000, 5), &[(70_000, 0)][..]),
            ((399_000, 70_000), &[(400_000, 70_000)]),
            ((70_000, 299_000), &[(70_000, 300_000)]),
            ((1, 70_000), &[(0, 70_000)]),
            ((200_000, 40_000), &[(200_000, 0)]),
            ((0, 70_000), &[]),
            ((399_000, 299_999), &[(400_000, 299_999), (399_000, 300_000)]),
            ((200_000, 150_000), &[]),
        ] {
            let point = |(x, y)| LatticePoint { x, y };
            let places = feet(FRAME, point(end)).map(|place| point_at(FRAME, place as i32));
            assert_eq!(places.collect::<Vec<_>>(), expected.iter().copied().map(point).collect::<Vec<_>>());
        }
    }

    #[test]
    fn what_closes_ends_nowhere() {
        let [a, b, c] = [(5, 5), (9, 5), (9, 9)].map(|(x, y)| LatticePoint { x, y });
        let stretches = [[a, b], [b, c], [c, a]].map(|ends| Stretch { ends, arc_du: [0.0; 2] });
        for (count, expected) in [(3, 0), (2, 4)] {
            let mut places = Vec::new();
            add_feet(FRAME, &stretches[..count], &mut places);
            assert_eq!(places.len(), expected);
        }
    }

    #[test]
    fn the_frame_goes_once_around_by_way_of_all_places() {
        let path = frame_path(FRAME, vec![1_300_000, 5, 750_000]);
        let points: Vec<_> = path.segments().map(|segment| kurbo::ParamCurve::start(&segment)).collect();
        let expected = [
            (0, 0),
            (5, 0),
            (400_000, 0),
            (400_000, 300_000),
            (350_000, 300_000),
            (0, 300_000),
            (0, 100_000),
        ];
        assert_eq!(points, expected.map(|(x, y)| LatticePoint { x, y }.to_point()));
    }
}
