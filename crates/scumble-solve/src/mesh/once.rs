//! What a solver is for that is used once: less than what may be asked of one that is kept.

use kurbo::Rect;
use scumble_core::{Boundary, SideColors, SideId, Triangulation, bounds};

use super::dofs::half_edges;

/// One boundary, and a part of the plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Once<'a> {
    pub(crate) boundary: &'a Boundary,
    /// Regions that do not come near it are not solved, in du.
    pub(crate) part_du: Rect,
}

impl Once<'_> {
    /// Whether a region of some triangles is to be solved. Those without colours stay paper, unless something shades them.
    pub(super) fn needs(self, mesh: &Triangulation, triangles: &[u32]) -> bool {
        let Boundary { sides, sources, .. } = self.boundary;
        let comes_near = || bounds_du(mesh, triangles).is_some_and(|bounds| bounds.overlaps(self.part_du));
        (!sources.is_empty() || have_colors(mesh, triangles, sides)) && comes_near()
    }
}

/// Whether any side of some triangles has a colour.
fn have_colors(mesh: &Triangulation, triangles: &[u32], colors: &SideColors) -> bool {
    let sides = triangles.iter().flat_map(|&t| half_edges(t)).filter_map(|h| mesh.side(h));
    sides.map(SideId::index).any(|side| colors.get(side).is_some_and(Option::is_some))
}

/// What some triangles lie within, if there are any.
pub(super) fn bounds_du(mesh: &Triangulation, triangles: &[u32]) -> Option<Rect> {
    bounds::of(triangles.iter().flat_map(|&t| mesh.corners(t as usize)))
}
