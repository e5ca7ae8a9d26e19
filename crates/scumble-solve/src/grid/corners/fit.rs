//! Weights of links that are satisfied by the function that is steep at a corner.
//!
//! What flows through a face, by the difference of the pixels (after the fitted schemes of D. N. de G. Allen, R. V. Southwell,
//! 1955). What flows is the difference of the conjugate function at the ends of the face. All faces that meet at an end take the
//! same value of it, which is that of the wall where one without colour ends one of them: so what flows into a pixel flows out
//! again, wherever the tip lies among the pixels.

use kurbo::{Point, Vec2};
use scumble_core::clamped;

use super::super::constraints::{Constraints, Pull};
use super::super::cut_links::{Cut, Face, LEAST_FRACTION, Link, WAYS};
use super::corner::{self, Corner};
use super::ground::Ground;
use super::patch::{Patch, Pixel, beside, center};

/// Pixels within this distance of a corner are fitted to it, in px.
const REACH_PX: f64 = 4.0;

/// Weights become at most so many times larger or smaller.
const MOST: f64 = 16.0;

/// What flows out of a pixel that no wall holds is taken for nothing up to here.
const LEAST_FLOW: f64 = 0.01;

/// A pixel is held to the colour of a wall where that takes more than this.
const LEAST_HOLD: f64 = 1e-3;

/// What fits constraints to corners.
#[derive(Debug, Default)]
struct Fit {
    faces: Vec<Face>,
    /// Cuts by their numbers, and how many times stronger they are to be.
    cuts: Vec<(usize, f64)>,
    /// What holds pixels to the colour of a wall that ends beside them, and that none of their links crosses.
    pulls: Vec<Pull>,
}

/// Fits constraints to the corners that are steep.
pub(super) fn fit(constraints: &mut Constraints, corners: &[Corner], ground: &Ground<'_>) {
    let steep = corner::with_stretches(corners).into_iter().filter(Corner::is_singular);
    let mut fit = Fit::default();
    for (corner, apart_px) in corner::apart(steep, 2.0 * REACH_PX) {
        // No pixel is near two at different places.
        let reach_px = 0.5 * apart_px;
        let patch = Patch::around(&corner, reach_px, constraints, ground);
        let around = Around { constraints, corner: &corner, patch: &patch };
        let strict = Weights::new(&around, true);
        let is_closed = patch.pixels.iter().all(|pixel| strict.is_closed(pixel));
        let weights = if is_closed { strict } else { Weights::new(&around, false) };
        for pixel in &patch.pixels {
            weights.fit_links(pixel, &mut fit);
            weights.fit_holds(pixel, &mut fit);
        }
    }
    constraints.add_faces(fit.faces);
    constraints.add_pulls(fit.pulls);
    for (cut, part) in fit.cuts {
        let fraction = &mut constraints.cuts[cut].fraction;
        *fraction = (*fraction / part as f32).max(LEAST_FRACTION);
    }
}

/// A corner among the pixels.
struct Around<'a> {
    constraints: &'a Constraints,
    corner: &'a Corner,
    patch: &'a Patch,
}

impl Around<'_> {
    /// The function and its conjugate at a place, going on straight from a pixel.
    fn at(&self, from: &Pixel, to: Point) -> [f64; 2] {
        self.corner.steep(to, from.angle + self.corner.turned(center(from.at), to))
    }

    /// What flows through the face between two pixels: the difference of the conjugate at its ends, which is that of a wall
    /// without colour at ends that such a wall comes to, around its tip too, if it is strict.
    fn flow(&self, pixel: &Pixel, to: [i64; 2], is_strict: bool) -> f64 {
        let from = pixel.at;
        let middle = center(from).midpoint(center(to));
        let angle = pixel.angle + self.corner.turned(center(from), middle);
        let across = [from[1] - to[1], to[0] - from[0]];
        let at_end = |[x, y]: [i64; 2]| {
            let [one, other] = [[from, to], [to, from]].map(|ends| self.at_wall(ends, [x, y], is_strict));
            let end = middle + 0.5 * Vec2::new(x as f64, y as f64);
            let angle = angle + self.corner.turned(middle, end);
            one.or(other).unwrap_or_else(|| self.corner.conjugate(end, angle))
        };
        self.corner.turn * (at_end(across.map(|d| -d)) - at_end(across))
    }

    /// The conjugate at the wall without colour that the way around an end of the face between two pixels comes to, from the
    /// first one on: at once, or anywhere if it is strict.
    fn at_wall(&self, [from, to]: [[i64; 2]; 2], way: [i64; 2], is_strict: bool) -> Option<f64> {
        let [around, beyond] = [from, to].map(|at| beside(at, way));
        let steps = [[from, around], [around, beyond], [beyond, to]];
        let steps = if is_strict { &steps[..] } else { &steps[..1] };
        let mut cuts = steps.iter().map(|[a, b]| (*a, self.cut(*a, [b[0] - a[0], b[1] - a[1]])));
        let (at, cut) = cuts.find_map(|(at, cut)| Some((at, cut?)))?;
        if cut.color.is_some() { None } else { self.corner.conjugate_at_wall(at, cut) }
    }

    /// The cut of a pixel's link that leads some way.
    fn cut(&self, from: [i64; 2], way: [i64; 2]) -> Option<&Cut> {
        let (link, _) = WAYS.into_iter().find(|(_, other)| *other == way)?;
        Some(&self.constraints.cuts[self.patch.cut(from, link)?])
    }
}

/// What the function of a corner is at pixels, and the weights that it satisfies.
struct Weights<'a> {
    around: &'a Around<'a>,
    /// By pixel.
    values: Vec<f64>,
    /// By pixel: of the links to the east and to the south that are not cut and do not lead away from the corner.
    weights: Vec<[Option<f64>; 2]>,
}

impl<'a> Weights<'a> {
    fn new(around: &'a Around<'a>, is_strict: bool) -> Self {
        let pixels = &around.patch.pixels;
        let values = pixels.iter().map(|pixel| around.at(pixel, center(pixel.at))[0]).collect();
        let mut weights = Self { around, values, weights: Vec::new() };
        weights.weights = pixels
            .iter()
            .zip(&weights.values)
            .map(|(pixel, &value)| {
                [Link::East, Link::South].map(|link| weights.satisfied(pixel, value, link, is_strict))
            })
            .collect();
        weights
    }

    /// The weight of a link with which what flows through its face is right, or nearly so.
    fn satisfied(&self, pixel: &Pixel, value: f64, link: Link, is_strict: bool) -> Option<f64> {
        let patch = self.around.patch;
        let to = beside(pixel.at, WAYS[link as usize].1);
        let other = patch.pixel(to).filter(|_| patch.cut(pixel.at, link).is_none())?;
        let weight = self.around.flow(pixel, to, is_strict) / (self.values[other] - value);
        let width = patch.width(pixel.at, link);
        (weight.is_finite() && weight > 0.0).then(|| clamped(weight, [width / MOST, width * MOST]))
    }

    /// The weight of a link that is not cut.
    fn weight(&self, pixel: &Pixel, link: Link) -> f64 {
        let patch = self.around.patch;
        let (owner, axis) = match link {
            Link::East | Link::South => (pixel.at, link as usize),
            Link::West | Link::North => (beside(pixel.at, WAYS[link as usize].1), link as usize - 2),
        };
        let fitted = patch.pixel(owner).and_then(|owner| self.weights[owner][axis]);
        fitted.unwrap_or_else(|| patch.width(pixel.at, link))
    }

    /// The value at the pixel to which a link leads.
    fn beside(&self, pixel: &Pixel, link: Link) -> f64 {
        let to = beside(pixel.at, WAYS[link as usize].1);
        let known = self.around.patch.pixel(to).map(|other| self.values[other]);
        known.unwrap_or_else(|| self.around.at(pixel, center(to))[0])
    }

    /// What flows out of a pixel through its links, and its value.
    fn flow_out(&self, pixel: &Pixel) -> [f64; 2] {
        let patch = self.around.patch;
        let value = patch.pixel(pixel.at).map_or(0.0, |pixel| self.values[pixel]);
        let open = WAYS.into_iter().filter(|(link, _)| patch.cut(pixel.at, *link).is_none());
        let flows = open.map(|(link, _)| self.weight(pixel, link) * (self.beside(pixel, link) - value));
        [flows.sum(), value]
    }

    /// Whether nothing flows out of a pixel that no wall holds.
    fn is_closed(&self, pixel: &Pixel) -> bool {
        let is_cut = WAYS.iter().any(|(link, _)| self.around.patch.cut(pixel.at, *link).is_some());
        is_cut || self.flow_out(pixel)[0].abs() < LEAST_FLOW
    }

    fn fit_links(&self, pixel: &Pixel, fit: &mut Fit) {
        for link in [Link::East, Link::South] {
            let (width, weight) = (self.around.patch.width(pixel.at, link), self.weight(pixel, link));
            if weight != width {
                let pixel = self.around.constraints.pixel(pixel.at);
                fit.faces.push(Face { pixel, link, width: (weight / width) as f32 });
            }
        }
    }

    /// What holds a pixel to the colours of walls, such that the function of the corner is a solution there.
    fn fit_holds(&self, pixel: &Pixel, fit: &mut Fit) {
        let Around { constraints, corner, patch } = self.around;
        let numbers = WAYS.iter().filter_map(|(link, _)| patch.cut(pixel.at, *link));
        let cuts: Vec<_> = numbers.map(|number| (number, &constraints.cuts[number])).collect();
        if !cuts.iter().all(|(_, cut)| corner.is_cut(pixel.at, cut)) {
            return;
        }
        let [flow, value] = self.flow_out(pixel);
        let strength = flow / value;
        let colored = || cuts.iter().filter(|(_, cut)| cut.color.is_some());
        let before: f64 = colored().map(|(_, cut)| 1.0 / f64::from(cut.fraction)).sum();
        if !(strength.is_finite() && strength > LEAST_HOLD) {
        } else if before > 0.0 {
            let part = clamped(strength / before, [1.0 / MOST, MOST]);
            fit.cuts.extend(colored().map(|&(number, _)| (number, part)));
        } else if let Some(color) = corner.color_near(pixel.angle) {
            fit.pulls.push(Pull { pixel: constraints.pixel(pixel.at), strength: strength as f32, color });
        }
    }
}
