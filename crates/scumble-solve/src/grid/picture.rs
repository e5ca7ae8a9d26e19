//! A solved grid, and where it may jump: all that a painter needs.

use kurbo::Line;
use scumble_core::{Bends, Blend, Boundary, PlanarMap};

use super::straights::jumps;
use crate::scene::View;

/// The colours of pixels, and where between them the picture may jump.
#[derive(Clone, Debug)]
pub struct GridPicture {
    /// Picture size.
    pub width_px: u32,
    /// Picture size.
    pub height_px: u32,
    /// The space that the colours are in.
    pub blend: Blend,
    /// Blend-space colours times their opacity, and the opacity, at the centres of pixels, row by row.
    pub pixels: Vec<[f32; 4]>,
    /// All straight stretches of curves, and closed gaps, in px from the top left.
    pub jumps: Vec<Line>,
}

impl GridPicture {
    /// The pixels of a view, and the curves of a map in it, as they bend, and its closed gaps.
    pub fn new(
        map: &PlanarMap,
        bends: &Bends,
        boundary: &Boundary,
        view: &View,
        blend: Blend,
        pixels: Vec<[f32; 4]>,
    ) -> Self {
        let jumps = jumps(map, bends, boundary, view.px_from_du);
        Self { width_px: view.width_px, height_px: view.height_px, blend, pixels, jumps }
    }
}
