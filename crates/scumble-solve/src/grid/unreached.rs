//! Pixels that are in a region with colours, and reach none: where the way to them is narrower than a pixel, or the side
//! that has the colour is so short that it crosses no link. They take the mean of the colours of their region. Not in
//! triangles with an edge that a curve bends away from: which region is beside the curve there they do not say.

use scumble_core::{Bends, BlendColor, HalfEdge, Triangulation};

use super::constraints::{Constraints, Pull};
use super::regions::PixelRegions;

/// The pulls of these pixels, given all other constraints.
pub(super) fn pulls(regions: &PixelRegions<'_>, bends: &Bends, constraints: &Constraints) -> Vec<Pull> {
    let is_unreached = constraints.unreached();
    let mut pulls = Vec::new();
    for mut triangles in regions.triangles() {
        let Some(color) = mean(regions.colors(&triangles)) else { continue };
        triangles.retain(|&triangle| !is_bent(regions.mesh, bends, triangle));
        let pixels = regions.pixels(&triangles, &is_unreached);
        pulls.extend(pixels.into_iter().map(|pixel| Pull { pixel, strength: 1.0, color }));
    }
    pulls
}

/// Whether a curve bends away from an edge of a triangle.
fn is_bent(mesh: &Triangulation, bends: &Bends, triangle: u32) -> bool {
    let mut sides = (0..3).filter_map(|i| mesh.side(HalfEdge::of(triangle as usize, i)));
    sides.any(|side| bends.knot_count(side) > 0)
}

/// The mean of colours by their lengths; `None` of none.
fn mean(colors: impl Iterator<Item = (f64, BlendColor)>) -> Option<[f32; 4]> {
    let (length, sum) = colors.fold((0.0, [0.0; 4]), |(all, sum), (length, color)| {
        (all + length, [0, 1, 2, 3].map(|i| sum[i] + length * color[i]))
    });
    (length > 0.0).then(|| sum.map(|c| (c / length) as f32))
}
