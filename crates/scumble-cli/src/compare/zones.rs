//! Where on a picture curves are near, and where their ends, junctions and changes are.

use kurbo::{Line, ParamCurveNearest, Point};
use scumble_core::{BlendColor, Boundary, PlanarMap, SideId};
use scumble_solve::View;

/// Pixels nearer to a curve than this, in px, do not count.
const CURVE_PX: f64 = 2.0;

/// What is near a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Zone {
    /// Nothing.
    Away,
    /// A curve or a closed gap.
    Curve,
    /// The end of a curve or of a closed gap, a junction, or where the colour of a side changes or begins.
    Special,
}

/// What is near each pixel, row by row; special places are near where they are so many px away.
pub(super) fn zones(map: &PlanarMap, boundary: &Boundary, view: &View, special_px: f64) -> Vec<Zone> {
    let at = |node: u32| view.px_from_du * map.triangulation().points()[node as usize];
    let mut zones = Zones::new(view);
    let curves = map.pieces().iter().filter(|piece| piece.curve.is_some()).map(|piece| piece.nodes);
    let gaps: Vec<_> = map.closed_gaps(&boundary.closed_gaps).map(|gap| gap.nodes).collect();
    for nodes in curves.chain(gaps.iter().copied()) {
        zones.mark(nodes.map(at), CURVE_PX, Zone::Curve);
    }
    for node in special_nodes(map, boundary).into_iter().chain(gaps.into_iter().flatten()) {
        zones.mark([at(node); 2], special_px, Zone::Special);
    }
    zones.pixels
}

struct Zones {
    width: usize,
    height: usize,
    pixels: Vec<Zone>,
}

impl Zones {
    fn new(view: &View) -> Self {
        let [width, height] = [view.width_px, view.height_px].map(|length_px| length_px as usize);
        Self { width, height, pixels: vec![Zone::Away; width * height] }
    }

    /// Marks the pixels nearer than a distance to a line.
    fn mark(&mut self, [a, b]: [Point; 2], distance_px: f64, zone: Zone) {
        let range = |a: f64, b: f64, count: usize| {
            let first = (a.min(b) - distance_px).max(0.0) as usize;
            first..((a.max(b) + distance_px).max(0.0) as usize + 1).min(count)
        };
        for y in range(a.y, b.y, self.height) {
            for x in range(a.x, b.x, self.width) {
                let center = Point::new(x as f64 + 0.5, y as f64 + 0.5);
                if Line::new(a, b).nearest(center, 1e-6).distance_sq < distance_px * distance_px {
                    let pixel = &mut self.pixels[y * self.width + x];
                    *pixel = zone.max(*pixel);
                }
            }
        }
    }
}

/// The nodes where curves end or meet, or where the colour of a side changes, or begins or ceases.
fn special_nodes(map: &PlanarMap, boundary: &Boundary) -> Vec<u32> {
    let colors = |side: SideId| boundary.sides.get(side.index()).copied().flatten();
    let mut around = vec![Vec::new(); map.triangulation().points().len()];
    for (i, piece) in map.pieces().iter().enumerate().filter(|(_, piece)| piece.curve.is_some()) {
        let [left, right] = [false, true].map(|is_right| colors(SideId::of(i, is_right)));
        around[piece.nodes[0] as usize].push([left, right]);
        around[piece.nodes[1] as usize].push([right, left]);
    }
    let is_plain = |side: &Option<[BlendColor; 3]>| side.is_none_or(|[a, b, c]| a == b && b == c);
    let is_special = |sides: &[[_; 2]]| match sides {
        [] => false,
        [[left, right], other] => other != &[*right, *left] || !other.iter().all(is_plain),
        _ => true,
    };
    (0..).zip(&around).filter(|(_, sides)| is_special(sides)).map(|(node, _)| node).collect()
}
