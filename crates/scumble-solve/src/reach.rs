//! Which regions a source shades.

use kurbo::{Point, Rect};
use scumble_core::{SoftSource, Triangulation};

use crate::brush::Brush;

/// Where a source shows.
#[derive(Debug)]
pub(crate) enum Reach {
    /// In the region of one triangle.
    Region(u32),
    /// Wherever its brush reaches.
    Brush(Brush),
    /// Nowhere: there is no triangle at all.
    Nowhere,
}

impl Reach {
    pub(crate) fn new(mesh: &Triangulation, source: &SoftSource) -> Self {
        if source.crosses {
            return Self::Brush(Brush::new(source));
        }
        // A stroke that begins off the page begins at the place on it that is nearest.
        let bounds = bounds(mesh);
        let first = source.points.first().copied().unwrap_or_default();
        let nearest = Point::new(first.x.clamp(bounds.x0, bounds.x1), first.y.clamp(bounds.y0, bounds.y1));
        mesh.locate(nearest, 0).map_or(Self::Nowhere, |triangle| Self::Region(triangle as u32))
    }

    /// Whether it shades a region, of which these are the triangles in ascending order.
    pub(crate) fn meets(&self, mesh: &Triangulation, triangles: &[u32]) -> bool {
        match self {
            Self::Nowhere => false,
            Self::Region(triangle) => triangles.binary_search(triangle).is_ok(),
            Self::Brush(brush) => triangles.iter().any(|&t| meets(brush, mesh.corners(t as usize))),
        }
    }
}

/// Whether a brush comes near enough to a triangle to be taken into account there.
fn meets(brush: &Brush, corners: [Point; 3]) -> bool {
    let [a, b, c] = corners;
    let middle = ((a.to_vec2() + b.to_vec2() + c.to_vec2()) / 3.0).to_point();
    let spread_du = corners.into_iter().map(|corner| corner.distance(middle)).fold(0.0, f64::max);
    let reach_du = brush.radius_du + spread_du;
    brush.bounds().overlaps(Rect::from_points(a, b).union_pt(c))
        && brush.distance_du(middle, reach_du) < reach_du
}

fn bounds(mesh: &Triangulation) -> Rect {
    let first = mesh.points().first().copied().unwrap_or_default();
    mesh.points().iter().fold(Rect::from_points(first, first), |bounds, p| bounds.union_pt(*p))
}
