//! The pieces of a map as they run: straight, or from close by as their curves bend; its closed gaps; and where a picture may
//! jump.

use kurbo::{Affine, Line, Point};
use scumble_core::{Bends, Boundary, Piece, PlanarMap, SideId};

/// A straight stretch of a piece of a map.
pub(super) struct Straight {
    /// The piece.
    pub(super) piece: usize,
    /// Where on the piece it starts and ends, from 0 to 1.
    pub(super) parts: [f64; 2],
    /// The places of these.
    pub(super) ends: [Point; 2],
}

/// Those of all pieces, taken to elsewhere: from one knot to the next.
pub(super) fn straights<'a>(
    map: &'a PlanarMap,
    bends: &'a Bends,
    from_du: Affine,
) -> impl Iterator<Item = Straight> + use<'a> {
    let points = map.triangulation().points();
    map.pieces().iter().enumerate().flat_map(move |(piece, Piece { nodes, .. })| {
        let (side, [start, end]) = (SideId::of(piece, false), nodes.map(|node| points[node as usize]));
        let knot_count = bends.knot_count(side);
        let spot = move |i: usize| match i {
            0 => (0.0, start),
            _ if i > knot_count => (1.0, end),
            _ => {
                let part = bends.knot(side, i - 1);
                (part, start.lerp(end, part) + bends.off_du(side, part))
            }
        };
        (0..=knot_count).map(move |i| {
            let [a, b] = [spot(i), spot(i + 1)];
            Straight { piece, parts: [a.0, b.0], ends: [a.1, b.1].map(|p| from_du * p) }
        })
    })
}

/// Closed gaps, taken to elsewhere.
pub(super) fn closed_gaps(map: &PlanarMap, boundary: &Boundary, from_du: Affine) -> Vec<Line> {
    let points = map.triangulation().points();
    let line = |[start, end]: [u32; 2]| from_du * Line::new(points[start as usize], points[end as usize]);
    map.closed_gaps(&boundary.closed_gaps).map(|gap| line(gap.nodes)).collect()
}

/// Where a picture may jump: straight stretches of curves, and closed gaps, taken to elsewhere.
pub(super) fn jumps(map: &PlanarMap, bends: &Bends, boundary: &Boundary, from_du: Affine) -> Vec<Line> {
    let mut jumps = closed_gaps(map, boundary, from_du);
    let all = straights(map, bends, from_du);
    let curves = all.filter(|straight| map.pieces()[straight.piece].curve.is_some());
    jumps.extend(curves.map(|Straight { ends: [a, b], .. }| Line::new(a, b)));
    jumps
}
