//! All that the grid solver knows of a drawing and its colours.

use std::ops::Range;

use scumble_core::{Bends, Boundary, PlanarMap, sort};

use super::corners;
use super::covers::{Covers, Shades};
use super::curve_cells::CurveCells;
use super::cut_links::{self, Cut, Face, Link, WAYS};
use super::regions::PixelRegions;
use super::unreached;
use super::whole::{self, Whole};
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

/// What the equation of a pixel has on its right side besides the colours that hold it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Source {
    /// The pixel: row times width plus column.
    pub pixel: u32,
    /// Blend-space colour, times its opacity, and the opacity; some may be below zero.
    pub color: [f32; 4],
}

/// The links of a pixel that lead out of a part of a larger picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exits {
    /// The pixel: row times width plus column.
    pub pixel: u32,
    /// A bit for each: 1 for that to the east, then south, west and north.
    pub links: u32,
}

impl Exits {
    /// Where the links lead, from their pixel.
    pub(super) fn ways(self) -> impl Iterator<Item = [i64; 2]> {
        WAYS.into_iter().filter(move |(link, _)| self.links >> *link as u32 & 1 == 1).map(|(_, way)| way)
    }

    /// What holds their pixel as long as it is not known to which colours.
    fn pull(&self) -> Pull {
        Pull { pixel: self.pixel, strength: self.links.count_ones() as f32, color: [0.0; 4] }
    }
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
    /// The links whose faces walls make narrower or wider: those to the east by pixel, then those to the south; some of
    /// them are cut.
    pub faces: Vec<Face>,
    /// What draws pixels towards colours without a curve between, by pixel; some pixels are named more than once.
    pub pulls: Vec<Pull>,
    /// What fitting to corners adds, in no order; some pixels are named more than once.
    pub sources: Vec<Source>,
    /// Where a part of a larger picture goes on while it is not known with which colours, by pixel.
    pub exits: Vec<Exits>,
    /// What shading scribbles lay over the picture; none where nothing shades.
    pub covers: Option<Covers>,
}

impl Constraints {
    /// Those of a map and the colours of its sides in what a view shows.
    ///
    /// # Errors
    /// See [`SolveError`]: where something shades.
    pub fn new(map: &PlanarMap, boundary: &Boundary, view: &View) -> Result<Self, SolveError> {
        Ok(Self::shaded(map, boundary, &Shades::new(map, boundary)?, view))
    }

    /// The same, with the shades of these sources already solved.
    pub(super) fn shaded(map: &PlanarMap, boundary: &Boundary, shades: &Shades, view: &View) -> Self {
        Self::with_borders(map, &Bends::default(), boundary, shades, view, &|_| Vec::new())
    }

    /// Those in what a view shows of a larger picture, which says what is beyond its borders, along pieces as they bend, with
    /// the shades of the page.
    pub fn within(
        whole: &Whole,
        map: &PlanarMap,
        bends: &Bends,
        boundary: &Boundary,
        shades: &Shades,
        view: &View,
    ) -> Self {
        Self::with_borders(map, bends, boundary, shades, view, &|all| whole.pulls(all, view))
    }

    /// The same of a larger picture of which only the view and the curves are known, where those of the part bend: at
    /// [`Self::exits`] pixels are held to no colour, and who solves them adds what there is beyond.
    pub(super) fn part(
        (whole, curves): (&View, &CurveCells),
        map: &PlanarMap,
        bends: &Bends,
        boundary: &Boundary,
        shades: &Shades,
        view: &View,
    ) -> Self {
        Self::with_borders(map, bends, boundary, shades, view, &|all| {
            all.exits = whole::exits(all, view, whole, curves);
            all.exits.iter().map(Exits::pull).collect()
        })
    }

    fn with_borders(
        map: &PlanarMap,
        bends: &Bends,
        boundary: &Boundary,
        shades: &Shades,
        view: &View,
        borders: &dyn Fn(&mut Self) -> Vec<Pull>,
    ) -> Self {
        let (cuts, faces) = cut_links::cut_links(map, bends, boundary, view);
        let (width_px, height_px) = (view.width_px, view.height_px);
        let (covers, pulls, sources, exits) =
            (shades.covers(bends, view), Vec::new(), Vec::new(), Vec::new());
        let mut all = Self { width_px, height_px, cuts, faces, pulls, sources, exits, covers };
        let pulls = borders(&mut all);
        all.add_pulls(pulls);
        let regions = PixelRegions::new(map.triangulation(), boundary, view);
        let pulls = unreached::pulls(&regions, bends, &all);
        all.add_pulls(pulls);
        all
    }

    /// The same, fitted to what is known of the solution at corners and tips: all of a region is nearer to the truth then.
    /// The page does without: it is 10 KB for every visitor, for a picture of a moment.
    pub fn fitted(mut self, map: &PlanarMap, bends: &Bends, boundary: &Boundary, view: &View) -> Self {
        corners::fit(&mut self, map, bends, boundary, view);
        self
    }

    /// The number of a pixel of the picture.
    pub(super) fn pixel(&self, [x, y]: [i64; 2]) -> u32 {
        (y * i64::from(self.width_px) + x) as u32
    }

    /// The numbers of the cuts of neighbouring pixels.
    pub(super) fn cuts_of(&self, pixels: &Range<u32>) -> Range<usize> {
        let first = |pixel: u32| self.cuts.partition_point(|cut| cut.pixel < pixel);
        first(pixels.start)..first(pixels.end)
    }

    /// The faces of the links of neighbouring pixels, to the east or to the south.
    pub(super) fn faces_of(&self, link: Link, pixels: &Range<u32>) -> &[Face] {
        let key = |face: &Face| (face.link == Link::South, face.pixel);
        let first = |pixel| self.faces.partition_point(|face| key(face) < (link == Link::South, pixel));
        &self.faces[first(pixels.start)..first(pixels.end)]
    }

    /// Whether a curve or a gap cuts a link of a pixel.
    pub(super) fn is_cut(&self, at: [i64; 2], link: Link) -> bool {
        let key = |cut: &Cut| (cut.pixel, cut.link as u8);
        self.cuts.binary_search_by_key(&(self.pixel(at), link as u8), key).is_ok()
    }

    /// What draws a pixel.
    pub(super) fn pulls_of(&self, pixel: u32) -> &[Pull] {
        let first = |pixel: u32| self.pulls.partition_point(|pull| pull.pixel < pixel);
        &self.pulls[first(pixel)..first(pixel + 1)]
    }

    /// Adds what draws pixels.
    pub(super) fn add_pulls(&mut self, pulls: impl IntoIterator<Item = Pull>) {
        self.pulls.extend(pulls);
        sort::sort_copies_by_key(&mut self.pulls, |pull| pull.pixel.into());
    }

    /// Makes faces so many times wider.
    pub(super) fn add_faces(&mut self, faces: Vec<Face>) {
        self.faces.extend(faces);
        let key = |face: &Face| u64::from(face.link == Link::South) << 32 | u64::from(face.pixel);
        sort::sort_copies_by_key(&mut self.faces, key);
        self.faces.dedup_by(|face, first| {
            let is_same = key(face) == key(first);
            first.width *= if is_same { face.width } else { 1.0 };
            is_same
        });
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
