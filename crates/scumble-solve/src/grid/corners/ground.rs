//! The triangles around a corner: what its region is.

use kurbo::{Affine, Point};
use scumble_core::{HalfEdge, PlanarMap};

use super::corner::Corner;
use crate::barriers::Barriers;

/// A map, of which pixels are to be found in the regions of corners.
#[derive(Debug)]
pub(super) struct Ground<'a> {
    pub(super) map: &'a PlanarMap,
    pub(super) closed_gaps: &'a [bool],
    /// Pixel centres have whole coordinates.
    pub(super) centers_from_du: Affine,
}

impl Ground<'_> {
    /// Where a node is.
    pub(super) fn place(&self, node: u32) -> Point {
        self.centers_from_du * self.map.triangulation().points()[node as usize]
    }

    /// Whether a place is in the region between the walls of a corner: one can go there without going farther from the tip
    /// than it is.
    pub(super) fn leads_to(&self, corner: &Corner, place: Point) -> bool {
        let Some(first) = corner.side.and_then(|side| self.map.half_edge(side)) else { return true };
        let barriers = Barriers { mesh: self.map.triangulation(), closed_gaps: self.closed_gaps };
        let far_px = place.distance(corner.tip);
        let (mut seen, mut next) = (vec![first.triangle()], 0);
        while let Some(&t) = seen.get(next) {
            next += 1;
            let corners = barriers.mesh.corners(t).map(|p| self.centers_from_du * p);
            if contains(corners, place) {
                return true;
            }
            for i in 0..3 {
                let near = [corners[i], corners[(i + 1) % 3]];
                let twin = barriers.passage(HalfEdge::of(t, i));
                let beyond = twin.map(HalfEdge::triangle).filter(|_| distance(near, corner.tip) <= far_px);
                seen.extend(beyond.filter(|beyond| !seen.contains(beyond)));
            }
        }
        false
    }
}

/// Whether a place lies within a triangle, not on its edges.
fn contains([a, b, c]: [Point; 3], p: Point) -> bool {
    [(a, b), (b, c), (c, a)].into_iter().all(|(a, b)| (b - a).cross(p - a) > 0.0)
}

/// How far a place is from a line.
fn distance([a, b]: [Point; 2], p: Point) -> f64 {
    let (along, way) = (b - a, p - a);
    let t = (along.dot(way) / along.hypot2()).clamp(0.0, 1.0);
    (way - t * along).hypot()
}
