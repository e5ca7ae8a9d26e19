//! Weights of links that are satisfied by the function that is steep at a corner.
//!
//! What flows through a face, by the difference of the pixels (after the fitted schemes of D. N. de G. Allen, R. V. Southwell,
//! 1955). What flows is the difference of the conjugate function at the ends of the face. All faces that meet at an end take the
//! same value of it, which is zero where a wall without colour ends one of them: so what flows into a pixel flows out again,
//! wherever the tip lies among the pixels.

use kurbo::{Point, Vec2};
use scumble_core::{clamped, sort};

use super::super::constraints::{Constraints, Pull};
use super::super::cut_links::{Cut, Face, LEAST_FRACTION, Link};
use super::corner::Corner;
use super::patch::{Patch, Pixel, WAYS, beside, center};

/// Pixels within this distance of a corner are fitted to it, in px.
const REACH_PX: f64 = 6.0;

/// Weights become at most so many times larger or smaller.
const MOST: f64 = 16.0;

/// What flows out of a pixel that no wall holds is taken for nothing up to here.
const LEAST_FLOW: f64 = 0.01;

/// A pixel of which no link crosses a wall is held to its colour where that takes more than this.
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
pub(super) fn fit(constraints: &mut Constraints, corners: &[Corner]) {
    let corners: Vec<_> = corners.iter().copied().filter(Corner::is_singular).collect();
    let mut fit = Fit::default();
    for (corner, reach_px) in apart(corners) {
        let patch = Patch::around(&corner, reach_px, constraints);
        let mut fitting = Fitting { constraints, corner: &corner, patch: &patch, is_strict: true };
        fitting.is_strict = patch.pixels.iter().all(|pixel| fitting.is_closed(pixel));
        for pixel in &patch.pixels {
            fitting.fit_links(pixel, &mut fit);
            fitting.fit_holds(pixel, &mut fit);
        }
    }
    constraints.add_faces(fit.faces);
    constraints.add_pulls(fit.pulls);
    for (cut, part) in fit.cuts {
        let fraction = &mut constraints.cuts[cut].fraction;
        *fraction = (*fraction / part as f32).max(LEAST_FRACTION);
    }
}

/// Corners, and how far each reaches: no pixel is near two at different places.
fn apart(mut corners: Vec<Corner>) -> impl Iterator<Item = (Corner, f64)> {
    sort::sort_copies_by_key(&mut corners, |corner| sort::float(corner.tip.x));
    let mut reaches_px = vec![REACH_PX; corners.len()];
    for i in 0..corners.len() {
        for j in i + 1..corners.len() {
            if corners[j].tip.x - corners[i].tip.x > 2.0 * REACH_PX {
                break;
            }
            let half_px = 0.5 * corners[i].tip.distance(corners[j].tip);
            if half_px > 0.0 {
                [i, j].into_iter().for_each(|k| reaches_px[k] = reaches_px[k].min(half_px));
            }
        }
    }
    corners.into_iter().zip(reaches_px)
}

/// Constraints that are fitted to a corner.
struct Fitting<'a> {
    constraints: &'a Constraints,
    corner: &'a Corner,
    patch: &'a Patch,
    /// Whether the conjugate is taken to be zero at all ends of faces that a wall without colour comes to, around its tip
    /// too.
    is_strict: bool,
}

impl Fitting<'_> {
    /// Whether nothing flows out of a pixel that no wall holds.
    fn is_closed(&self, pixel: &Pixel) -> bool {
        let value = self.value(pixel, center(pixel.at));
        let is_cut = WAYS.iter().any(|(link, _)| self.patch.cut(pixel.at, *link).is_some());
        is_cut || self.flow_out(pixel, value).abs() < LEAST_FLOW
    }

    fn fit_links(&self, pixel: &Pixel, fit: &mut Fit) {
        for link in [Link::East, Link::South] {
            let width = self.patch.width(pixel.at, link);
            let fitted = self.fitted(pixel, link, width);
            if fitted != width && self.patch.cut(pixel.at, link).is_none() {
                let pixel = self.constraints.pixel(pixel.at);
                fit.faces.push(Face { pixel, link, width: (fitted / width) as f32 });
            }
        }
    }

    /// What holds a pixel to the colours of walls, such that the function of the corner is a solution there.
    fn fit_holds(&self, pixel: &Pixel, fit: &mut Fit) {
        let numbers = WAYS.iter().filter_map(|(link, _)| self.patch.cut(pixel.at, *link));
        let cuts: Vec<_> = numbers.map(|number| (number, &self.constraints.cuts[number])).collect();
        if !cuts.iter().all(|(_, cut)| self.corner.is_cut(pixel.at, cut)) {
            return;
        }
        let value = self.value(pixel, center(pixel.at));
        let strength = self.flow_out(pixel, value) / value;
        let colored = || cuts.iter().filter(|(_, cut)| cut.color.is_some());
        let before: f64 = colored().map(|(_, cut)| 1.0 / f64::from(cut.fraction)).sum();
        if !(strength.is_finite() && strength > 0.0) {
        } else if before > 0.0 {
            let part = clamped(strength / before, [1.0 / MOST, MOST]);
            fit.cuts.extend(colored().map(|&(number, _)| (number, part)));
        } else if let Some(color) = self.corner.color_near(pixel.angle).filter(|_| strength > LEAST_HOLD) {
            fit.pulls.push(Pull {
                pixel: self.constraints.pixel(pixel.at),
                strength: strength as f32,
                color,
            });
        }
    }

    /// What flows out of a pixel through its links where the function has a value.
    fn flow_out(&self, pixel: &Pixel, value: f64) -> f64 {
        let open = WAYS.into_iter().filter(|(link, _)| self.patch.cut(pixel.at, *link).is_none());
        let flows = open.map(|(link, way)| {
            let width = self.fitted(pixel, link, self.patch.width(pixel.at, link));
            width * (self.value(pixel, center(beside(pixel.at, way))) - value)
        });
        flows.sum()
    }

    /// The weight of a link that is not cut.
    fn fitted(&self, pixel: &Pixel, link: Link, width: f64) -> f64 {
        match self.satisfied(pixel, link) {
            Some(weight) if weight > 0.0 => clamped(weight, [width / MOST, width * MOST]),
            _ => width,
        }
    }

    /// The weight of a link with which what flows through its face is right; `None` where it leads away from the corner.
    fn satisfied(&self, pixel: &Pixel, link: Link) -> Option<f64> {
        let (_, way) = WAYS[link as usize];
        let to = beside(pixel.at, way);
        self.patch.angle(to)?;
        let difference = self.value(pixel, center(to)) - self.value(pixel, center(pixel.at));
        Some(self.flow(pixel, to) / difference).filter(|weight| weight.is_finite())
    }

    /// The function at a place, going on from a pixel.
    fn value(&self, from: &Pixel, to: Point) -> f64 {
        self.at(from, [center(from.at), to])[0]
    }

    /// The function and its conjugate at the end of a way, the first place of which lies in the direction of a pixel.
    fn at(&self, from: &Pixel, way: [Point; 2]) -> [f64; 2] {
        self.corner.steep(way[1], from.angle + self.corner.turned(way[0], way[1]))
    }

    /// What flows through the face between two pixels: the difference of the conjugate at its ends, which is zero at a wall
    /// without colour.
    fn flow(&self, pixel: &Pixel, to: [i64; 2]) -> f64 {
        let from = pixel.at;
        let middle = center(from).midpoint(center(to));
        let in_middle = Pixel { angle: pixel.angle + self.corner.turned(center(from), middle), ..*pixel };
        let across = [from[1] - to[1], to[0] - from[0]];
        let at_end = |[x, y]: [i64; 2]| {
            let is_walled = self.meets_wall(from, to, [x, y]) || self.meets_wall(to, from, [x, y]);
            let end = middle + 0.5 * Vec2::new(x as f64, y as f64);
            if is_walled { 0.0 } else { self.at(&in_middle, [middle, end])[1] }
        };
        self.corner.turn * (at_end(across.map(|d| -d)) - at_end(across))
    }

    /// Whether the way around an end of the face between two pixels, from the first one on, comes to a wall without colour.
    fn meets_wall(&self, from: [i64; 2], to: [i64; 2], way: [i64; 2]) -> bool {
        let [around, beyond] = [from, to].map(|at| beside(at, way));
        let steps = [[from, around], [around, beyond], [beyond, to]];
        let steps = if self.is_strict { &steps[..] } else { &steps[..1] };
        let mut cuts = steps.iter().map(|[a, b]| self.cut(*a, [b[0] - a[0], b[1] - a[1]]));
        cuts.find_map(|cut| cut).is_some_and(|cut| cut.color.is_none())
    }

    /// The cut of a pixel's link that leads some way.
    fn cut(&self, from: [i64; 2], way: [i64; 2]) -> Option<&Cut> {
        let (link, _) = WAYS.into_iter().find(|(_, other)| *other == way)?;
        Some(&self.constraints.cuts[self.patch.cut(from, link)?])
    }
}
