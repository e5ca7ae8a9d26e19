//! All that the grid solver knows of a drawing and its colours.

use scumble_core::{Boundary, PlanarMap};

use super::cut_links::{self, Cut, Face, Link};
use super::pulls::{self, Pull};
use super::regions::PixelRegions;
use super::unreached;
use crate::scene::View;

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
    /// The layer that shading scribbles lay over the picture, a problem of its own: one of colours, which cover as much as
    /// their opacity, or that and then one of which the opacity is how much they cover. None where nothing shades.
    pub layers: Vec<Constraints>,
}

impl Constraints {
    /// Those of a map and the colours of its sides in what a view shows.
    pub fn new(map: &PlanarMap, boundary: &Boundary, view: &View) -> Self {
        let regions = PixelRegions::new(map.triangulation(), boundary, view);
        let layers = Self::layers(map, boundary, view, pulls::layers(&regions, &boundary.sources, view));
        let mut all = Self { layers, ..Self::without_pulls(map, boundary, view) };
        all.pulls = unreached::pulls(&regions, &all);
        all
    }

    /// A problem for each of some lists of pulls, in which nothing passes through lines.
    fn layers(map: &PlanarMap, boundary: &Boundary, view: &View, pulls: Vec<Vec<Pull>>) -> Vec<Self> {
        if pulls.is_empty() {
            return Vec::new();
        }
        let bare = Boundary { closed_gaps: boundary.closed_gaps.clone(), ..Boundary::default() };
        let bare = Self::without_pulls(map, &bare, view);
        pulls.into_iter().map(|pulls| Self { pulls, ..bare.clone() }).collect()
    }

    fn without_pulls(map: &PlanarMap, boundary: &Boundary, view: &View) -> Self {
        let (cuts, faces) = cut_links::cut_links(map, boundary, view);
        let (width_px, height_px) = (view.width_px, view.height_px);
        Self { width_px, height_px, cuts, faces, pulls: Vec::new(), layers: Vec::new() }
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
