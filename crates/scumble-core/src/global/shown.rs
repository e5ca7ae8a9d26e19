//! From labels of triangles to labels of the sides and gaps between them, redone where they changed.

use super::flood::NONE;
use crate::engine::Labels;
use crate::planar_map::PlanarMap;
use crate::triangulation::HalfEdge;

/// The labels of the last call.
#[derive(Clone, Debug)]
pub(super) struct Shown {
    of_triangles: Vec<u32>,
    labels: Labels,
}

impl Shown {
    /// Nothing has a label.
    pub(super) fn new(map: &PlanarMap) -> Self {
        Self { of_triangles: vec![NONE; map.refined().triangle_count()], labels: Labels::none(map) }
    }

    /// Those of the last call.
    pub(super) fn labels(&self) -> &Labels {
        &self.labels
    }

    /// Makes labels of sides from those of the triangles that they bound. A gap is closed where two labels meet at any of
    /// its parts, which `gaps` lists; a wide one only where a label ends.
    pub(super) fn show(&mut self, map: &PlanarMap, gaps: &[HalfEdge], of_triangles: &[u32]) {
        let mesh = map.refined();
        for (triangle, &label) in of_triangles.iter().enumerate() {
            if std::mem::replace(&mut self.of_triangles[triangle], label) != label {
                for side in (0..3).filter_map(|i| mesh.side(HalfEdge::of(triangle, i))) {
                    self.labels.sides[side.index()] = (label != NONE).then_some(label);
                }
            }
        }
        self.labels.closed_gaps.fill(false);
        for &h in gaps {
            if let (Some(gap), Some(twin)) = (mesh.gap(h), mesh.passage(h)) {
                let [a, b] = [h, twin].map(|h| of_triangles[h.triangle()]);
                let is_end = a == NONE || b == NONE || !map.gaps()[gap as usize].is_wide;
                self.labels.closed_gaps[gap as usize] |= a != b && is_end;
            }
        }
    }
}
