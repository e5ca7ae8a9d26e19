//! A solved picture of the whole, which says what is beyond the borders of a part of it that is solved at a larger scale.

use kurbo::{Point, Vec2};
use scumble_core::{PlanarMap, clamped};

use super::constraints::{Constraints, Pull};
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

    /// What draws the pixels at the borders of a part, along links that no curve cuts, to what lies beyond.
    pub(super) fn pulls(&self, constraints: &Constraints, view: &View) -> Vec<Pull> {
        let whole_from_part = self.view.px_from_du * view.px_from_du.inverse();
        let center = |[x, y]: [i64; 2]| whole_from_part * Point::new(x as f64 + 0.5, y as f64 + 0.5);
        let open = exits(view).filter(|(at, link, _)| !constraints.is_cut(*at, *link));
        let pull = |(at, _, beyond)| {
            let color = self.color(center(beyond))?;
            Some(Pull { pixel: constraints.pixel(at), strength: 1.0, color })
        };
        open.filter_map(pull).collect()
    }

    /// The colour at a place, in px: that of the centres around it that no curve hides, by their nearness. `None` beyond the
    /// picture and between curves that are closer than pixels.
    fn color(&self, place: Point) -> Option<Texel> {
        let [width, height] = [self.view.width_px, self.view.height_px].map(f64::from);
        if !((0.0..width).contains(&place.x) && (0.0..height).contains(&place.y)) {
            return None;
        }
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

/// The links that lead out of a picture: from which pixel, and to which one.
fn exits(view: &View) -> impl Iterator<Item = ([i64; 2], Link, [i64; 2])> {
    let [width, height] = [view.width_px, view.height_px].map(i64::from);
    let sides = (0..height).flat_map(move |y| [[0, y], [width - 1, y]]);
    let ends = (0..width).flat_map(move |x| [[x, 0], [x, height - 1]]);
    let leads_out = move |[x, y]: [i64; 2]| !((0..width).contains(&x) && (0..height).contains(&y));
    let mut pixels: Vec<_> = sides.chain(ends).collect();
    pixels.sort_unstable();
    pixels.dedup();
    pixels.into_iter().flat_map(move |at| {
        let ways = WAYS.map(|(link, [dx, dy])| (at, link, [at[0] + dx, at[1] + dy]));
        ways.into_iter().filter(move |(_, _, beyond)| leads_out(*beyond))
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
