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
        Self { of_triangles: vec![NONE; map.triangulation().triangle_count()], labels: Labels::none(map) }
    }

    /// Labels of sides from those of the triangles that they bound. A gap between two labels is closed.
    pub(super) fn show(&mut self, map: &PlanarMap, of_triangles: &[u32]) -> &Labels {
        for (triangle, &label) in of_triangles.iter().enumerate() {
            if std::mem::replace(&mut self.of_triangles[triangle], label) != label {
                self.show_triangle(map, of_triangles, triangle);
            }
        }
        &self.labels
    }

    fn show_triangle(&mut self, map: &PlanarMap, of_triangles: &[u32], triangle: usize) {
        let mesh = map.triangulation();
        let label = of_triangles[triangle];
        for h in (0..3).map(|i| HalfEdge::of(triangle, i)) {
            if let Some(side) = mesh.side(h) {
                self.labels.sides[side.index()] = (label != NONE).then_some(label);
            } else if let (Some(gap), Some(twin)) = (mesh.gap(h), mesh.passage(h)) {
                self.labels.closed_gaps[gap as usize] = label != of_triangles[twin.triangle()];
            }
        }
    }
}
