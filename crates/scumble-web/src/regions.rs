//! What colours stop at, to look at in place of the colours: each room of the planar map in a tint of its own, and a mark in
//! each gap that counts as closed.

use kurbo::{Line, Shape, Stroke};
use scumble_core::{Blend, ColorModel, Curve, Drawing, Gap, HalfEdge, PlanarMap, Rgba8, drawing};
use scumble_solve::{Field, FieldTriangle};

/// Lightness of the tints: three in turn, so that neighbours of like hue differ.
const LIGHTNESSES: [f64; 3] = [0.92, 0.86, 0.80];

const CHROMA: f64 = 0.08;

/// The golden angle, in degrees: hues in a row lie far apart.
const HUE_STEP: f64 = 137.507_764;

/// Marks are this wide, in device pixels.
const GAP_PX: f64 = 2.5;

/// Where a colour ends, and, fainter, where it may go on into a small room.
const GAP_COLORS: [Rgba8; 2] = [Rgba8([0xc8, 0x10, 0x2e, 0xff]), Rgba8([0xc8, 0x10, 0x2e, 0x50])];

/// Of which drawing a map is, which lines that has, and how readily gaps count as closed.
pub(crate) type MapKey = (u32, Option<u32>, f64);

/// What is shown of a map.
#[derive(Clone, Debug, Default)]
pub(crate) struct Regions {
    of: Option<MapKey>,
    field: Field,
    /// With their colours.
    gaps: Vec<(Line, Rgba8)>,
}

impl Regions {
    /// Takes the rooms and gaps of a map, if it is another one; tells whether it was.
    pub(crate) fn follow(&mut self, key: MapKey, map: &PlanarMap) -> bool {
        let is_other = self.of.replace(key) != Some(key);
        if is_other {
            self.field = tinted(map);
            let mark = |gap: &Gap| {
                let [from, to] = gap.nodes.map(|node| map.triangulation().points()[node as usize]);
                (Line::new(from, to), GAP_COLORS[usize::from(gap.is_wide)])
            };
            self.gaps = map.gaps().iter().map(mark).collect();
        }
        is_other
    }

    /// The rooms, tinted.
    pub(crate) fn field(&self) -> &Field {
        &self.field
    }

    /// The gaps, as lines that are to be seen at this many device pixels a du.
    pub(crate) fn marked_gaps(&self, page: &Drawing, px_per_du: f64) -> Drawing {
        let stroke = Stroke::new(GAP_PX / px_per_du);
        let mark = |&(gap, color): &(Line, Rgba8)| {
            let line = drawing::Line { stroke: stroke.clone(), color };
            Curve { path: gap.to_path(0.0), line: Some(line) }
        };
        Drawing { curves: self.gaps.iter().map(mark).collect(), ..Drawing::new(page.page) }
    }
}

fn tinted(map: &PlanarMap) -> Field {
    let mesh = map.refined();
    let (room_of, _) = mesh.rooms();
    let is_end =
        |h: HalfEdge| mesh.twin(h).is_none_or(|twin| room_of[twin.triangle()] != room_of[h.triangle()]);
    let triangle = |triangle: usize| FieldTriangle {
        corners: mesh.corners(triangle).map(|p| [p.x as f32, p.y as f32]),
        colors: [tint(room_of[triangle]); 6],
        side_edges: (0..3).map(|i| u32::from(is_end(HalfEdge::of(triangle, i))) << i).sum(),
    };
    Field { blend: Blend::Oklab, triangles: (0..mesh.triangle_count()).map(triangle).collect() }
}

fn tint(room: u32) -> [f32; 4] {
    let lightness = LIGHTNESSES[room as usize % LIGHTNESSES.len()];
    let (color, _) = ColorModel::Oklch.color([lightness, CHROMA, HUE_STEP * f64::from(room) % 360.0]);
    Blend::Oklab.from_srgb8(color).map(|x| x as f32)
}
