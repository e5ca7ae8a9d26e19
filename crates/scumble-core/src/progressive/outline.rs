//! The outlines of the regions of a map: which side follows which, all along a region's border.

use kurbo::Point;

use super::rooms::Rooms;
use crate::planar_map::PlanarMap;
use crate::triangulation::SideId;

/// What does not change while scribbles do: for each side its neighbours along the border of its region, which lies
/// to the left. Outlines turn around the tips of open curves from one side to the other.
#[derive(Clone, Debug)]
pub(super) struct Outline {
    /// Per side; `None` for the outer sides of the frame.
    triangles: Vec<Option<u32>>,
    /// Per side the one that begins where it ends.
    next: Vec<SideId>,
    prev: Vec<SideId>,
    /// Per triangle.
    regions: Vec<u32>,
    /// What the gaps part.
    pub(super) rooms: Rooms,
}

impl Outline {
    pub(super) fn new(map: &PlanarMap) -> Self {
        let mesh = map.triangulation();
        let itself: Vec<_> = (0..map.side_count()).map(|side| SideId(side as u32)).collect();
        let mut outline = Self {
            triangles: vec![None; map.side_count()],
            next: itself.clone(),
            prev: itself,
            regions: mesh.regions().0,
            rooms: Rooms::new(mesh, map.gaps().len()),
        };
        for h in mesh.half_edges() {
            let Some(side) = mesh.side(h) else { continue };
            outline.triangles[side.index()] = Some(h.triangle() as u32);
            if let Some(next) = mesh.side_after(h, |_| true) {
                outline.next[side.index()] = next;
                outline.prev[next.index()] = side;
            }
        }
        outline
    }

    /// The side that begins where this one ends, on the border of the same region.
    pub(super) fn next(&self, side: SideId) -> SideId {
        self.next[side.index()]
    }

    /// The side that ends where this one begins, on the border of the same region.
    pub(super) fn prev(&self, side: SideId) -> SideId {
        self.prev[side.index()]
    }

    /// The region that a triangle belongs to.
    pub(super) fn region_of_triangle(&self, triangle: usize) -> u32 {
        self.regions[triangle]
    }

    /// The triangle that a side belongs to; `None` for the outer sides of the frame.
    pub(super) fn triangle_of_side(&self, side: SideId) -> Option<usize> {
        self.triangles[side.index()].map(|triangle| triangle as usize)
    }

    /// The region that a side borders on; `None` for the outer sides of the frame.
    pub(super) fn region_of_side(&self, side: SideId) -> Option<u32> {
        self.triangle_of_side(side).map(|triangle| self.regions[triangle])
    }
}

/// Where a side begins and ends, its region to the left.
pub(super) fn ends(map: &PlanarMap, side: SideId) -> [Point; 2] {
    map.ends(side).map(|node| map.triangulation().points()[node as usize])
}
