//! A solved picture of the whole, which says what is beyond the borders of a part of it that is solved at a larger scale.

use kurbo::{Line, Point, Vec2};
use scumble_core::{Bends, Boundary, PlanarMap, clamped};

use super::constraints::{Constraints, Exits, Pull};
use super::curve_cells::CurveCells;
use super::cut_links::{Link, WAYS};
use super::sight::Sight;
use super::texture::{Texel, plus, times};
use crate::scene::View;

/// A part is solved with so many pixels of the whole around it: what its borders get wrong has faded away then. That is most
/// where a curve, a side without colour or a closed gap crosses them, about which only the pixels of the whole are known.
pub const AROUND_PX: f64 = 8.0;

/// A picture without shades, and what may part its pixels.
#[derive(Clone, Debug)]
pub struct Whole {
    view: View,
    pixels: Vec<Texel>,
    curves: CurveCells,
}

impl Whole {
    /// What was found for the pixels of a view: blend-space colours times opacity, and opacity, row by row. Its curves bend as
    /// those of its parts.
    pub fn new(map: &PlanarMap, bends: &Bends, boundary: &Boundary, view: &View, pixels: Vec<Texel>) -> Self {
        Self { view: *view, pixels, curves: CurveCells::new(map, bends, boundary, view) }
    }

    /// What draws the pixels at the borders of a part to what lies beyond, along links as wide as any, walls beside them or not.
    pub(super) fn pulls(&self, constraints: &Constraints, view: &View) -> Vec<Pull> {
        let exits = exits(constraints, view, &self.view, &self.curves);
        let links = exits.iter().flat_map(|exits| exits.ways().map(|way| (exits.pixel, way)));
        let pull = |(pixel, way): (u32, [i64; 2])| {
            let [column, row] = [pixel % view.width_px, pixel / view.width_px].map(i64::from);
            let color = self.color(place_in(&self.view, view, [column + way[0], row + way[1]]))?;
            Some(Pull { pixel, strength: 1.0, color })
        };
        links.filter_map(pull).collect()
    }

    /// The colour at a place, in px: that of the centres around it that no curve hides, by their nearness. `None`
    /// between curves that are closer than pixels.
    fn color(&self, place: Point) -> Option<Texel> {
        let (mut sum, mut weights) = ([0.0; 4], 0.0);
        for Seen { pixel, weight } in seen(&self.view, &self.curves, place) {
            sum = plus(sum, times(self.pixels[pixel], weight));
            weights += weight;
        }
        (weights > 0.0).then(|| times(sum, 1.0 / weights))
    }
}

/// A pixel that is seen from a place.
struct Seen {
    pixel: usize,
    /// By its nearness.
    weight: f32,
}

/// The pixels around a place, in px, whose centres no curve hides.
fn seen(view: &View, curves: &CurveCells, place: Point) -> impl Iterator<Item = Seen> {
    let [width, height] = [view.width_px, view.height_px].map(f64::from);
    let cell = (place + Vec2::new(0.5, 0.5)).floor();
    let listed = curves.pieces_of(cell.x as u32, cell.y as u32);
    let corners = [(-0.5, -0.5), (0.5, -0.5), (-0.5, 0.5), (0.5, 0.5)].map(|shift| cell + Vec2::from(shift));
    corners.into_iter().filter_map(move |corner| {
        // At the border what is there goes on.
        let center =
            Point::new(clamped(corner.x, [0.5, width - 0.5]), clamped(corner.y, [0.5, height - 0.5]));
        let weight = ((1.0 - (place.x - corner.x).abs()) * (1.0 - (place.y - corner.y).abs())) as f32;
        let pixel = center.y as usize * width as usize + center.x as usize;
        (!is_hidden(place, center, listed)).then_some(Seen { pixel, weight })
    })
}

/// The links that lead out of a part of a larger picture to where that is seen, and are not cut.
pub(super) fn exits(constraints: &Constraints, view: &View, whole: &View, curves: &CurveCells) -> Vec<Exits> {
    let [width, height] = [view.width_px, view.height_px].map(i64::from);
    let mut all = Vec::new();
    for y in 0..height {
        let is_end = y == 0 || y == height - 1;
        for x in (0..width).step_by(if is_end { 1 } else { (width - 1).max(1) as usize }) {
            let is_exit = |(link, [dx, dy]): &(Link, [i64; 2])| {
                let beyond = [x + dx, y + dy];
                let place = place_in(whole, view, beyond);
                !holds(view, beyond)
                    && holds_place(whole, place)
                    && !constraints.is_cut([x, y], *link)
                    && seen(whole, curves, place).next().is_some()
            };
            let links = WAYS.iter().filter(|way| is_exit(way)).map(|(link, _)| 1 << *link as u32).sum();
            if links > 0 {
                all.push(Exits { pixel: constraints.pixel([x, y]), links });
            }
        }
    }
    all
}

fn holds(view: &View, [x, y]: [i64; 2]) -> bool {
    (0..i64::from(view.width_px)).contains(&x) && (0..i64::from(view.height_px)).contains(&y)
}

/// Whether a larger picture holds a place beyond a part of it. What it has of its last pixels may be half a pixel more than the
/// page.
fn holds_place(whole: &View, place: Point) -> bool {
    let is_within = |c: f64, count: u32| c >= 0.0 && c + 0.5 < f64::from(count);
    is_within(place.x, whole.width_px) && is_within(place.y, whole.height_px)
}

/// Where the centre of a pixel of a part is in a larger picture, in px.
fn place_in(whole: &View, part: &View, pixel: [i64; 2]) -> Point {
    let [x, y] = pixel.map(|c| c as f64 + 0.5);
    whole.px_from_du * (part.px_from_du.inverse() * Point::new(x, y))
}

/// Whether one of some pieces passes between a place and the centre of a pixel.
fn is_hidden(place: Point, center: Point, pieces: &[[f32; 4]]) -> bool {
    let sight = Sight::new(place, center);
    pieces.iter().any(|piece| {
        let [ax, ay, bx, by] = piece.map(f64::from);
        sight.is_crossed_by(Line::new((ax, ay), (bx, by)))
    })
}
