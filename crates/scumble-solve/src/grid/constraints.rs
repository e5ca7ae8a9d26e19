//! All that the grid solver knows of a drawing and its colours.

use scumble_core::{Boundary, PlanarMap};

use super::corners;
use super::covers::Covers;
use super::cut_links::{self, Cut, Face, Link};

use super::regions::PixelRegions;
use super::unreached;
use crate::mesh::SolveError;
use crate::scene::View;

/// A term on the diagonal of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pull {
    /// The pixel: row times width plus column.
    pub pixel: u32,
    /// How strong it is against a link to a pixel beside.
    pub strength: f32,
    /// Blend-space colour, times its opacity, and the opacity, that it draws towards.
    pub color: [f32; 4],
}

/// What curves, gaps and shading scribbles make of the pixels of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Constraints {
    /// Picture size.
    pub width_px: u32,
    /// Picture size.
    pub height_px: u32,
    /// By pixel and link, in ascending order, at most one for each link of a pixel.
    pub cuts: Vec<Cut>,
    /// The links whose faces walls make narrower or wider, by pixel; some of them are cut.
    pub faces: Vec<Face>,
    /// What draws pixels towards colours without a curve between, in no order; some pixels are named more than once.
    pub pulls: Vec<Pull>,
    /// What shading scribbles lay over the picture; none where nothing shades.
    pub covers: Option<Covers>,
}

impl Constraints {
    /// Those of a map and the colours of its sides in what a view shows.
    ///
    /// # Errors
    /// See [`SolveError`]: where something shades.
    pub fn new(map: &PlanarMap, boundary: &Boundary, view: &View) -> Result<Self, SolveError> {
        let (cuts, faces) = cut_links::cut_links(map, boundary, view);
        let (width_px, height_px) = (view.width_px, view.height_px);
        let covers = Covers::new(map, boundary, view)?;
        let mut all = Self { width_px, height_px, cuts, faces, pulls: Vec::new(), covers };
        let regions = PixelRegions::new(map.triangulation(), boundary, view);
        all.pulls = unreached::pulls(&regions, &all);
        Ok(all)
    }

    /// The same with links that fit what is known of the solution at corners and tips: all of a region is nearer to
    /// the truth then. The page does without: it is 4 KB for every visitor, for a picture of a moment.
    pub fn fitted(mut self, map: &PlanarMap, boundary: &Boundary, view: &View) -> Self {
        corners::fit(&mut self, map, boundary, view);
        self
    }

    /// Whether a link leads to another pixel of the picture.
    pub(super) fn leads_within(&self, cut: &Cut) -> bool {
        let [column, row] = [cut.pixel % self.width_px, cut.pixel / self.width_px];
        match cut.link {
            Link::East => column + 1 < self.width_px,
            Link::South => row + 1 < self.height_px,
            Link::West => column > 0,
            Link::North => row > 0,
        }
    }
}
