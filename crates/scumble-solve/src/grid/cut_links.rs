//! Where curves cut the links between neighbouring pixels: what the grid solver knows of a drawing.
//!
//! A curve owns no pixels. Each link that it crosses is cut, and each of the two pixels remembers how far it is to the
//! curve and the colour of the side that it faces (F. Gibou et al., *A second-order-accurate symmetric discretization
//! of the Poisson equation on irregular domains*, 2002). All decisions of what lies on which side are exact, so that
//! the cuts along a curve never leave a way through.

use kurbo::{Point, Vec2};
use robust::{Coord, orient2d};
use scumble_core::{BlendColor, Boundary, PlanarMap, SideId, sort};

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

/// All cut links of a picture, by pixel and link, at most one for each link of a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct CutLinks {
    /// Picture size.
    pub width_px: u32,
    /// Picture size.
    pub height_px: u32,
    /// In ascending order.
    pub cuts: Vec<Cut>,
    /// The links whose faces walls make narrower or wider, by pixel; some of them are cut.
    pub faces: Vec<Face>,
}

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

/// A straight piece of something that no colour crosses, in px, pixel centres having whole coordinates.
struct Wall {
    ends: [Point; 2],
    /// The colours of the left and the right side at its start, middle and end.
    sides: [Option<[BlendColor; 3]>; 2],
}

impl CutLinks {
    /// The links that the curves of a map and its closed gaps cut in what a view shows.
    pub fn new(map: &PlanarMap, boundary: &Boundary, view: &View) -> Self {
        let mut crossings = Crossings::new(view);
        let [mut eastern, mut southern] = [(); 2].map(|()| Crossings::new(view));
        for wall in walls(map, boundary, view) {
            crossings.cut_rows(&wall);
            crossings.cut_columns(&wall);
            eastern.cut_columns(&wall.moved(Vec2::new(-0.5, 0.0)));
            southern.cut_rows(&wall.moved(Vec2::new(0.0, -0.5)));
        }
        let mut faces = faces(&eastern.nearest(), Link::East);
        faces.extend(self::faces(&southern.nearest(), Link::South));
        Self { width_px: view.width_px, height_px: view.height_px, cuts: crossings.nearest(), faces }
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

/// A crossing of a link, and how much nearer it would be if the curve moved as points on rows and columns are taken to.
#[derive(Clone, Copy)]
struct Crossing {
    cut: Cut,
    nearing: f64,
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
        sort::sort_copies_by_key(&mut self.list, |crossing| !sort::float(crossing.nearing));
        sort::sort_copies_by_key(&mut self.list, |crossing| crossing.cut.key());
        let mut cuts: Vec<_> = self.list.into_iter().map(|crossing| crossing.cut).collect();
        cuts.dedup_by_key(|cut| (cut.pixel, cut.link));
        cuts.iter_mut().for_each(|cut| cut.fraction = cut.fraction.clamp(LEAST_FRACTION, 1.0));
        cuts
    }

    /// Cuts the links that run along rows. A point on a row lies above it.
    fn cut_rows(&mut self, wall: &Wall) {
        let [a, b] = wall.ends;
        let is_down = b.y > a.y;
        for row in whole_numbers(a.y.min(b.y).ceil(), a.y.max(b.y).ceil(), self.height_px) {
            let t = (row as f64 - a.y) / (b.y - a.y);
            let x = a.x + t * (b.x - a.x);
            let west = last_where(x, |column| wall.has_on_left(column, row) == is_down);
            let (fraction, nearing) = (x - west as f64, (a.x - b.x) / (b.y - a.y));
            self.push([west, row], Link::East, [fraction, nearing], wall.color(is_down, t));
            self.push([west + 1, row], Link::West, [1.0 - fraction, -nearing], wall.color(!is_down, t));
        }
    }

    /// Cuts the links that run along columns. A point on a column lies to the right of it.
    fn cut_columns(&mut self, wall: &Wall) {
        let [a, b] = wall.ends;
        let is_back = b.x < a.x;
        for column in whole_numbers(a.x.min(b.x).floor() + 1.0, a.x.max(b.x).floor() + 1.0, self.width_px) {
            let t = (column as f64 - a.x) / (b.x - a.x);
            let y = a.y + t * (b.y - a.y);
            let north = last_where(y, |row| wall.has_on_left(column, row) == is_back);
            let (fraction, nearing) = (y - north as f64, (b.y - a.y) / (b.x - a.x));
            self.push([column, north], Link::South, [fraction, nearing], wall.color(is_back, t));
            self.push([column, north + 1], Link::North, [1.0 - fraction, -nearing], wall.color(!is_back, t));
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

impl Wall {
    fn moved(&self, by: Vec2) -> Self {
        Self { ends: self.ends.map(|p| p + by), ..*self }
    }

    /// Whether the centre of a pixel lies to the left of the line through the wall. A centre on the line does not: the
    /// line is taken to be moved by next to nothing in x, and by next to nothing of that in −y.
    fn has_on_left(&self, column: i64, row: i64) -> bool {
        let [a, b] = self.ends;
        let turn = orient2d(coord(a), coord(b), Coord { x: column as f64, y: row as f64 });
        let along = b - a;
        let sign = if turn != 0.0 {
            turn
        } else if along.y != 0.0 {
            along.y
        } else {
            along.x
        };
        sign > 0.0
    }

    /// The colour of its left or right side, `t` of the way from its start to its end.
    fn color(&self, is_left: bool, t: f64) -> Option<[f32; 4]> {
        let [left, right] = self.sides;
        let colors = if is_left { left } else { right }?;
        let weights = [(1.0 - t) * (1.0 - 2.0 * t), 4.0 * t * (1.0 - t), t * (2.0 * t - 1.0)];
        Some([0, 1, 2, 3].map(|c| (0..3).map(|i| weights[i] * colors[i][c]).sum::<f64>() as f32))
    }
}

/// The pieces of a map and its closed gaps, in the pixels of a view.
fn walls<'a>(
    map: &'a PlanarMap,
    boundary: &'a Boundary,
    view: &View,
) -> impl Iterator<Item = Wall> + use<'a> {
    let px_from_du = view.px_from_du.then_translate(Vec2::new(-0.5, -0.5));
    let ends =
        move |nodes: [u32; 2]| nodes.map(|node| px_from_du * map.triangulation().points()[node as usize]);
    let color = |side: SideId| boundary.sides.get(side.index()).copied().flatten();
    let piece = move |(i, piece): (usize, &scumble_core::Piece)| {
        let right = color(SideId::of(i, true)).map(|[start, middle, end]| [end, middle, start]);
        Wall { ends: ends(piece.nodes), sides: [color(SideId::of(i, false)), right] }
    };
    let closed = map.gaps().iter().zip(&boundary.closed_gaps).filter(|(_, closed)| **closed);
    let gaps = closed.map(move |(gap, _)| Wall { ends: ends(gap.nodes), sides: [None; 2] });
    map.pieces().iter().enumerate().map(piece).chain(gaps)
}

fn coord(p: Point) -> Coord<f64> {
    Coord { x: p.x, y: p.y }
}

/// The whole numbers of a half-open range that count a picture's rows or columns.
fn whole_numbers(first: f64, end: f64, count: u32) -> std::ops::Range<i64> {
    first.max(0.0) as i64..end.min(f64::from(count)) as i64
}

/// The last whole number for which something holds that holds up to `near`, give or take a rounding.
fn last_where(near: f64, holds: impl Fn(i64) -> bool) -> i64 {
    let first = near.floor() as i64 - 1;
    (first + 1..=first + 2).rev().find(|&i| holds(i)).unwrap_or(first)
}
