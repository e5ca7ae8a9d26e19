//! A solved grid and the curves in it: all that a painter needs.

use scumble_core::{Bends, Blend, PlanarMap};

use super::straights::straights;
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
    /// The ends of all straight stretches of curves, in px from the top left.
    pub edges: Vec<[[f64; 2]; 2]>,
}

impl GridPicture {
    /// The pixels of a view, and the curves of a map in it, as they bend.
    pub fn new(map: &PlanarMap, bends: &Bends, view: &View, blend: Blend, pixels: Vec<[f32; 4]>) -> Self {
        let all = straights(map, bends, view.px_from_du);
        let curves = all.filter(|straight| map.pieces()[straight.piece].curve.is_some());
        let edges = curves.map(|straight| straight.ends.map(|p| [p.x, p.y])).collect();
        Self { width_px: view.width_px, height_px: view.height_px, blend, pixels, edges }
    }
}
