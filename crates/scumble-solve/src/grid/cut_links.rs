//! Where curves cut the links between neighbouring pixels.
//!
//! A curve owns no pixels. Each link that it crosses is cut, and each of the two pixels remembers how far it is to the
//! curve and the colour of the side that it faces (F. Gibou et al., *A second-order-accurate symmetric discretization
//! of the Poisson equation on irregular domains*, 2002).

use kurbo::{Rect, Vec2};
use scumble_core::{Bends, Boundary, PlanarMap, sort};

use super::wall::{Place, Segment, Wall, around, walls};
use crate::scene::View;

/// The neighbour that a link of a pixel leads to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Link {
    /// One column on.
    East,
    /// One row on.
    South,
    /// One column back.
    West,
    /// One row back.
    North,
}

/// The links of a pixel, and where they lead.
pub(super) const WAYS: [(Link, [i64; 2]); 4] =
    [(Link::East, [1, 0]), (Link::South, [0, 1]), (Link::West, [-1, 0]), (Link::North, [0, -1])];

/// A link of one pixel that ends at a curve, or at a gap that is closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cut {
    /// The pixel: row times width plus column.
    pub pixel: u32,
    /// Which of its links.
    pub link: Link,
    /// How far the nearest crossing is from the pixel's centre, in px, from [`LEAST_FRACTION`] to 1.
    pub fraction: f32,
    /// Blend-space colour, times its opacity, and the opacity, of the side that faces the pixel; `None` where it lets
    /// no colour through and gives none.
    pub color: Option<[f32; 4]>,
}

/// Crossings nearer to a pixel's centre than this, in px, are taken to be this far: it bounds the weight of a colour.
pub const LEAST_FRACTION: f32 = 0.02;

/// Steps in which fractions are compared: wider than what they are rounded by, narrower than what two curves are apart.
const FRACTION_STEPS: f64 = (1 << 20) as f64;

/// The face between two pixels, through which colour passes along their link, where it is not just 1 px wide: beside a
/// side without colour it ends there, whichever pixel that is in.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Face {
    /// The pixel: row times width plus column.
    pub pixel: u32,
    /// The link to the east or to the south.
    pub link: Link,
    /// In px, above 0, at most 2.
    pub width: f32,
}

/// The links that the curves of a map, as they bend, and its closed gaps cut in what a view shows, and the faces beside them.
pub(super) fn cut_links(
    map: &PlanarMap,
    bends: &Bends,
    boundary: &Boundary,
    view: &View,
) -> (Vec<Cut>, Vec<Face>) {
    let [mut crossings, mut eastern, mut southern] = [(); 3].map(|()| Crossings::new(view));
    let around = around(view);
    for wall in walls(map, bends, boundary, view) {
        let Segment([a, b]) = wall.segment;
        if !around.overlaps(Rect::from_points(a, b)) {
            continue;
        }
        crossings.cut_rows(&wall, wall.segment);
        crossings.cut_columns(&wall, wall.segment);
        eastern.cut_columns(&wall, wall.segment.moved(Vec2::new(-0.5, 0.0)));
        southern.cut_rows(&wall, wall.segment.moved(Vec2::new(0.0, -0.5)));
    }
    let mut faces = faces(&eastern.nearest(), Link::East);
    faces.extend(self::faces(&southern.nearest(), Link::South));
    (crossings.nearest(), faces)
}

/// A crossing of a link, and how much nearer it would be if the curve moved as points on rows and columns are taken to.
#[derive(Clone, Copy)]
struct Crossing {
    cut: Cut,
    nearing: f64,
}

impl Crossing {
    /// Whether another crossing, whose key is no smaller, is one of the same link. Then the one that is nearer stays, of two at one
    /// place the one that would come nearer.
    fn absorbs(&mut self, other: &Self) -> bool {
        let nearing = |crossing: &Self| sort::float(crossing.nearing);
        if other.cut.key() == self.cut.key() && nearing(other) > nearing(self) {
            *self = *other;
        }
        (other.cut.pixel, other.cut.link) == (self.cut.pixel, self.cut.link)
    }
}

/// All crossings, in no order.
struct Crossings {
    width_px: u32,
    height_px: u32,
    list: Vec<Crossing>,
}

/// The faces of links to the east or to the south, given where walls cut the line that the face is a part of, as if the
/// middle of each link were a pixel.
fn faces(cuts: &[Cut], link: Link) -> Vec<Face> {
    let barriers = cuts.iter().filter(|cut| cut.color.is_none());
    let mut faces: Vec<Face> = Vec::new();
    for Cut { pixel, fraction, .. } in barriers {
        match faces.last_mut().filter(|face| face.pixel == *pixel) {
            Some(face) => face.width += fraction - 0.5,
            None => faces.push(Face { pixel: *pixel, link, width: fraction + 0.5 }),
        }
    }
    faces
}

impl Crossings {
    fn new(view: &View) -> Self {
        Self { width_px: view.width_px, height_px: view.height_px, list: Vec::new() }
    }

    /// The crossing of each link that is nearest to its pixel.
    fn nearest(mut self) -> Vec<Cut> {
        sort::sort_copies_by_key(&mut self.list, |crossing| crossing.cut.key());
        self.list.dedup_by(|crossing, nearest| nearest.absorbs(crossing));
        let mut cuts: Vec<_> = self.list.into_iter().map(|crossing| crossing.cut).collect();
        cuts.iter_mut().for_each(|cut| cut.fraction = cut.fraction.clamp(LEAST_FRACTION, 1.0));
        cuts
    }

    /// Cuts the links along rows that a wall crosses, which is here.
    fn cut_rows(&mut self, wall: &Wall, segment: Segment) {
        let [a, b] = segment.0;
        let is_down = segment.is_down();
        for row in segment.rows(self.height_px) {
            let Place { t, before, fraction } = segment.on_row(row);
            let nearing = (a.x - b.x) / (b.y - a.y);
            self.push([before, row], Link::East, [fraction, nearing], wall.color(is_down, t));
            self.push([before + 1, row], Link::West, [1.0 - fraction, -nearing], wall.color(!is_down, t));
        }
    }

    /// Cuts the links along columns that a wall crosses, which is here.
    fn cut_columns(&mut self, wall: &Wall, segment: Segment) {
        let [a, b] = segment.0;
        let is_back = segment.is_back();
        for column in segment.columns(self.width_px) {
            let Place { t, before, fraction } = segment.on_column(column);
            let nearing = (b.y - a.y) / (b.x - a.x);
            self.push([column, before], Link::South, [fraction, nearing], wall.color(is_back, t));
            self.push([column, before + 1], Link::North, [1.0 - fraction, -nearing], wall.color(!is_back, t));
        }
    }

    fn push(&mut self, [x, y]: [i64; 2], link: Link, [fraction, nearing]: [f64; 2], color: Option<[f32; 4]>) {
        let [width, height] = [self.width_px, self.height_px].map(i64::from);
        if (0..width).contains(&x) && (0..height).contains(&y) {
            let cut = Cut { pixel: (y * width + x) as u32, link, fraction: fraction as f32, color };
            self.list.push(Crossing { cut, nearing });
        }
    }
}

impl Cut {
    /// Pixel, link and fraction, in steps wide enough that crossings at a common node count as equally far.
    fn key(&self) -> u64 {
        let steps = (f64::from(self.fraction) * FRACTION_STEPS).round();
        u64::from(self.pixel) << 34 | (self.link as u64) << 32 | steps as u64
    }
}
