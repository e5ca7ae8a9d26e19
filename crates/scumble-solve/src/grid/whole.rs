//! A solved picture of the whole, which says what is beyond the borders of a part of it that is solved at a larger scale.

use kurbo::{Point, Vec2};
use scumble_core::{PlanarMap, clamped};

use super::constraints::{Constraints, Exits, Pull};
use super::curve_cells::CurveCells;
use super::cut_links::{Link, WAYS};
use super::texture::{Texel, plus, times};
use crate::scene::View;

/// A curve that passes through the centre of a pixel, to so many px, hides it: which side it is on is rounding.
const BEYOND_PX: f64 = 0.01;

/// A picture without shades, and the curves in it.
#[derive(Clone, Debug)]
pub struct Whole {
    view: View,
    pixels: Vec<Texel>,
    curves: CurveCells,
}

impl Whole {
    /// What was found for the pixels of a view: blend-space colours times opacity, and opacity, row by row.
    pub fn new(map: &PlanarMap, view: &View, pixels: Vec<Texel>) -> Self {
        Self { view: *view, pixels, curves: CurveCells::new(map, view) }
    }

    /// What draws the pixels at the borders of a part to what lies beyond.
    pub(super) fn pulls(&self, constraints: &Constraints, view: &View) -> Vec<Pull> {
        let pull = |Exit { pixel, beyond_px, .. }: Exit| {
            self.color(beyond_px).map(|color| Pull { pixel, strength: 1.0, color })
        };
        exits(constraints, view, &self.view).filter_map(pull).collect()
    }

    /// The colour at a place, in px: that of the centres around it that no curve hides, by their nearness. `None`
    /// between curves that are closer than pixels.
    fn color(&self, place: Point) -> Option<Texel> {
        let [width, height] = [self.view.width_px, self.view.height_px].map(f64::from);
        let cell = (place + Vec2::new(0.5, 0.5)).floor();
        let listed = self.curves.pieces_of(cell.x as u32, cell.y as u32);
        let (mut sum, mut weights) = ([0.0; 4], 0.0);
        for (dx, dy) in [(-0.5, -0.5), (0.5, -0.5), (-0.5, 0.5), (0.5, 0.5)] {
            let corner = cell + Vec2::new(dx, dy);
            // At the border what is there goes on.
            let center =
                Point::new(clamped(corner.x, [0.5, width - 0.5]), clamped(corner.y, [0.5, height - 0.5]));
            if !is_hidden(place, center, listed) {
                let weight = ((1.0 - (place.x - corner.x).abs()) * (1.0 - (place.y - corner.y).abs())) as f32;
                let pixel = center.y as usize * self.view.width_px as usize + center.x as usize;
                sum = plus(sum, times(self.pixels[pixel], weight));
                weights += weight;
            }
        }
        (weights > 0.0).then(|| times(sum, 1.0 / weights))
    }
}

/// A link that leads out of a part.
#[derive(Clone, Copy)]
struct Exit {
    pixel: u32,
    link: Link,
    /// To which place of the whole.
    beyond_px: Point,
}

/// The links that lead out of a part of a larger picture and are not cut, together for each pixel.
pub(super) fn exits_by_pixel(constraints: &Constraints, view: &View, whole: &View) -> Vec<Exits> {
    let all: Vec<_> = exits(constraints, view, whole).collect();
    let of_pixel = |run: &[Exit]| Exits {
        pixel: run[0].pixel,
        links: run.iter().map(|exit| 1 << exit.link as u32).sum(),
    };
    all.chunk_by(|a, b| a.pixel == b.pixel).map(of_pixel).collect()
}

/// The links that lead out of a part of a larger picture, save those that are cut, by pixel.
fn exits(constraints: &Constraints, view: &View, whole: &View) -> impl Iterator<Item = Exit> {
    let [width, height] = [view.width_px, view.height_px].map(i64::from);
    let whole_from_part = whole.px_from_du * view.px_from_du.inverse();
    let [width_px, height_px] = [whole.width_px, whole.height_px].map(f64::from);
    let columns = move |y: i64| if y == 0 || y == height - 1 { 1 } else { (width - 1).max(1) };
    let pixels = (0..height).flat_map(move |y| (0..width).step_by(columns(y) as usize).map(move |x| [x, y]));
    let links = pixels.flat_map(|at| WAYS.map(|(link, [dx, dy])| (at, link, [at[0] + dx, at[1] + dy])));
    let leads_out = move |[x, y]: [i64; 2]| !((0..width).contains(&x) && (0..height).contains(&y));
    links.filter_map(move |(at, link, beyond)| {
        let [x, y] = beyond.map(|c| c as f64 + 0.5);
        let beyond_px = whole_from_part * Point::new(x, y);
        let is_within = (0.0..width_px).contains(&beyond_px.x) && (0.0..height_px).contains(&beyond_px.y);
        let is_exit = leads_out(beyond) && is_within && !constraints.is_cut(at, link);
        is_exit.then(|| Exit { pixel: constraints.pixel(at), link, beyond_px })
    })
}

/// Whether one of some pieces of curves passes between a place and the centre of a pixel.
fn is_hidden(place: Point, center: Point, pieces: &[[f32; 4]]) -> bool {
    let way = center - place;
    let end = center + BEYOND_PX * way / way.length().max(BEYOND_PX);
    pieces.iter().any(|piece| {
        let [ax, ay, bx, by] = piece.map(f64::from);
        let [a, b] = [Point::new(ax, ay), Point::new(bx, by)];
        are_apart([a, b], [place, end]) && are_apart([place, end], [a, b])
    })
}

/// Whether two places are on different sides of the line through two others.
fn are_apart([a, b]: [Point; 2], places: [Point; 2]) -> bool {
    let [one, other] = places.map(|p| (b - a).cross(p - a) > 0.0);
    one != other
}
