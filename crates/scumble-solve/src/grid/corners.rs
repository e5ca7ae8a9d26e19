//! The equations of pixels near corners where the solution is steep without end: between two walls more than a right angle
//! apart of which one gives a colour and one gives none, or more than two where both do or neither. Worst is the tip of a curve
//! with one coloured side.
//!
//! There the solution goes as a power λ of the distance, below 1: as `r^λ sin(λθ)`, or as the cosine where no wall gives a colour, θ
//! being counted from a wall. What pixels get wrong at the corner is wrong in the whole region. Weights of links are those that
//! this function satisfies: what flows through a face, by the difference of the pixels (after the fitted schemes of D. N. de G.
//! Allen, R. V. Southwell, 1955). What flows is the difference of the conjugate function at the ends of the face. All faces that
//! meet at an end take the same value of it, which is zero where a wall without colour ends one of them: so what flows into a
//! pixel flows out again, wherever the tip lies among the pixels. Where two colours meet in a tip, that is another function; such
//! a tip is left as it is.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use kurbo::{Affine, Point, Vec2};
use scumble_core::{BlendColor, Boundary, Piece, PlanarMap, SideId, clamped, sort};

use super::constraints::Constraints;
use super::cut_links::{Cut, Face, LEAST_FRACTION, Link};
use super::wall::centers_from_du;
use crate::scene::View;

/// Pixels within this distance of a corner are fitted to it, in px.
const REACH_PX: f64 = 6.0;

/// Powers from this on are well enough as they are.
const REGULAR: f64 = 0.9;

/// Weights become at most so many times larger or smaller.
const MOST: f64 = 16.0;

/// A cut belongs to a wall of a corner that is so close by, in px.
const NEAR_PX: f64 = 0.5;

/// The plane between two walls at a corner, in px, pixel centres having whole coordinates.
#[derive(Clone, Copy, Debug)]
struct Corner {
    tip: Point,
    reach_px: f64,
    /// Along the first wall, which has a colour if one has any.
    first: Vec2,
    /// From that wall to the other one.
    angle: f64,
    /// Whether these walls give a colour.
    is_colored: [bool; 2],
    /// 1 where angles grow from that wall on as `atan2` has it, else −1.
    turn: f64,
}

impl Corner {
    fn power(&self) -> f64 {
        let is_mixed = self.is_colored[0] != self.is_colored[1];
        if is_mixed { FRAC_PI_2 / self.angle } else { PI / self.angle }
    }

    /// The angle of a place from the first wall, from 0 to 2π.
    fn angle_of(&self, p: Point) -> f64 {
        let way = p - self.tip;
        (self.turn * self.first.cross(way).atan2(self.first.dot(way))).rem_euclid(TAU)
    }

    /// The function at a place at an angle, and its conjugate.
    fn at(&self, p: Point, angle: f64) -> [f64; 2] {
        let length = p.distance(self.tip).powf(self.power());
        let (sin, cos) = (self.power() * angle).sin_cos();
        if self.is_colored[0] { [length * sin, length * cos] } else { [length * cos, -length * sin] }
    }

    fn has(&self, p: Point) -> bool {
        p.distance(self.tip) <= self.reach_px && self.angle_of(p) <= self.angle
    }

    fn value(&self, p: Point) -> f64 {
        self.at(p, self.angle_of(p))[0]
    }

    /// Whether a wall with or without colour is next to a place.
    fn is_wall_near(&self, p: Point, is_colored: bool) -> bool {
        let other = Vec2::from_angle(self.first.atan2() + self.turn * self.angle);
        let walls = [self.first / self.first.hypot(), other].into_iter().zip(self.is_colored);
        let mut alike = walls.filter(|(_, wall)| *wall == is_colored);
        let crossed = p - self.tip;
        alike.any(|(along, _)| along.cross(crossed).abs() < NEAR_PX && along.dot(crossed) > -NEAR_PX)
    }

    /// The conjugate at a place near another one, as it goes on from there, beyond a wall too.
    fn conjugate(&self, from: Point, to: Point) -> f64 {
        let [way, end] = [from, to].map(|p| p - self.tip);
        let turned = self.turn * way.cross(end).atan2(way.dot(end));
        self.at(to, self.angle_of(from) + turned)[1]
    }
}

/// Fits constraints to the corners of a map.
pub(super) fn fit(constraints: &mut Constraints, map: &PlanarMap, boundary: &Boundary, view: &View) {
    let corners = corners(map, boundary, view);
    let (mut faces, mut holds) = (Vec::new(), Vec::new());
    let fitting = Fitting { constraints };
    for corner in &corners {
        for [x, y] in fitting.pixels(corner) {
            fitting.fit_links(corner, [x, y], &mut faces);
            holds.extend(fitting.hold(corner, [x, y]));
        }
    }
    constraints.faces.extend(faces);
    for (cut, part) in holds {
        let fraction = &mut constraints.cuts[cut].fraction;
        *fraction = (*fraction / part as f32).max(LEAST_FRACTION);
    }
}

/// A wall at a node, seen from there.
#[derive(Clone, Copy)]
struct Ray {
    node: u32,
    along: Vec2,
    /// The colours of its left and its right side there.
    colors: [Option<BlendColor>; 2],
}

/// The walls at all nodes: by node, and by their angles there.
fn rays(map: &PlanarMap, boundary: &Boundary, px_from_du: Affine) -> Vec<Ray> {
    let colors = |side: SideId| boundary.sides.get(side.index()).copied().flatten();
    let at = |node: u32| px_from_du * map.triangulation().points()[node as usize];
    let both = |[start, end]: [u32; 2], [left, right]: [Option<[BlendColor; 3]>; 2]| {
        let along = at(end) - at(start);
        let at_end = |colors: Option<[BlendColor; 3]>, k: usize| colors.map(|colors| colors[k]);
        let back = Ray { node: end, along: -along, colors: [at_end(right, 0), at_end(left, 2)] };
        [Ray { node: start, along, colors: [at_end(left, 0), at_end(right, 2)] }, back]
    };
    let piece = |(i, piece): (usize, &Piece)| {
        both(piece.nodes, [false, true].map(|is_right| colors(SideId::of(i, is_right))))
    };
    let closed = map.gaps().iter().zip(&boundary.closed_gaps).filter(|(_, closed)| **closed);
    let gaps = closed.flat_map(|(gap, _)| both(gap.nodes, [None; 2]));
    let mut rays: Vec<_> = map.pieces().iter().enumerate().flat_map(piece).chain(gaps).collect();
    sort::sort_copies_by_key(&mut rays, |ray| sort::float(ray.along.atan2()));
    sort::sort_copies_by_key(&mut rays, |ray| ray.node.into());
    rays
}

fn corners(map: &PlanarMap, boundary: &Boundary, view: &View) -> Vec<Corner> {
    let px_from_du = centers_from_du(view);
    let rays = rays(map, boundary, px_from_du);
    let mut corners = Vec::new();
    for around in rays.chunk_by(|a, b| a.node == b.node) {
        let tip = px_from_du * map.triangulation().points()[around[0].node as usize];
        let nexts = around.iter().cycle().skip(1);
        corners.extend(around.iter().zip(nexts).filter_map(|(ray, next)| corner(tip, ray, next)));
    }
    keep_apart(&mut corners);
    corners
}

/// What lies between a wall and the next one, if it is such a corner.
fn corner(tip: Point, ray: &Ray, next: &Ray) -> Option<Corner> {
    let colors = [ray.colors[0], next.colors[1]];
    let [left, right] = colors.map(|color| color.is_some());
    let angle = (next.along.atan2() - ray.along.atan2()).rem_euclid(TAU);
    let angle = if angle == 0.0 { TAU } else { angle };
    let (first, turn) = if left || !right { (ray.along, 1.0) } else { (next.along, -1.0) };
    let is_colored = [left || right, left && right];
    let corner = Corner { tip, reach_px: REACH_PX, first, angle, is_colored, turn };
    let is_jump = left && right && colors[0] != colors[1];
    (!is_jump && corner.power() < REGULAR).then_some(corner)
}

/// No pixel is near two corners at different places.
fn keep_apart(corners: &mut Vec<Corner>) {
    sort::sort_copies_by_key(corners, |corner| sort::float(corner.tip.x));
    for i in 0..corners.len() {
        for j in i + 1..corners.len() {
            if corners[j].tip.x - corners[i].tip.x > 2.0 * REACH_PX {
                break;
            }
            let half_px = 0.5 * corners[i].tip.distance(corners[j].tip);
            if half_px > 0.0 {
                corners[i].reach_px = corners[i].reach_px.min(half_px);
                corners[j].reach_px = corners[j].reach_px.min(half_px);
            }
        }
    }
}

/// Constraints that corners are fitted to.
struct Fitting<'a> {
    constraints: &'a Constraints,
}

/// The links of a pixel, and where they lead.
const LINKS: [(Link, [i64; 2]); 4] =
    [(Link::East, [1, 0]), (Link::South, [0, 1]), (Link::West, [-1, 0]), (Link::North, [0, -1])];

fn center(p: [i64; 2]) -> Point {
    let [x, y] = p.map(|c| c as f64);
    Point::new(x, y)
}

impl Fitting<'_> {
    /// The pixels near a corner.
    fn pixels(&self, corner: &Corner) -> impl Iterator<Item = [i64; 2]> + use<> {
        let range = |middle: f64, count: u32| {
            let first = (middle - corner.reach_px).ceil().max(0.0) as i64;
            first..((middle + corner.reach_px).floor() as i64 + 1).min(count.into())
        };
        let columns = range(corner.tip.x, self.constraints.width_px);
        let (rows, corner) = (range(corner.tip.y, self.constraints.height_px), *corner);
        rows.flat_map(move |y| columns.clone().map(move |x| [x, y])).filter(move |p| corner.has(center(*p)))
    }

    fn fit_links(&self, corner: &Corner, from: [i64; 2], faces: &mut Vec<Face>) {
        for (link, [dx, dy]) in LINKS.into_iter().take(2) {
            let to = [from[0] + dx, from[1] + dy];
            let width = self.width(from, to);
            let fitted = self.fitted(corner, from, to, width);
            if fitted != width && !self.is_cut(from, link) {
                faces.push(Face { pixel: self.pixel(from), link, width: (fitted / width) as f32 });
            }
        }
    }

    /// The cuts of a pixel by the colour of a corner, and how many times stronger they are to be, so that the function of
    /// the corner is a solution there.
    fn hold(&self, corner: &Corner, from: [i64; 2]) -> Vec<(usize, f64)> {
        let (cuts, all) = (&self.constraints.cuts, self.cuts(from));
        let own: Vec<_> = all.clone().filter(|&i| cuts[i].color.is_some()).collect();
        if own.is_empty() || !all.clone().all(|i| self.is_own(corner, from, &cuts[i])) {
            return Vec::new();
        }
        let strength: f64 = own.iter().map(|&i| 1.0 / f64::from(cuts[i].fraction)).sum();
        let value = corner.value(center(from));
        let flows = LINKS.into_iter().filter(|(link, _)| !self.is_cut(from, *link)).map(|(_, [dx, dy])| {
            let to = [from[0] + dx, from[1] + dy];
            self.fitted(corner, from, to, self.width(from, to)) * (corner.value(center(to)) - value)
        });
        let part = flows.sum::<f64>() / value / strength;
        let is_fit = part.is_finite() && part > 0.0;
        own.into_iter().filter(|_| is_fit).map(|i| (i, part.clamp(1.0 / MOST, MOST))).collect()
    }

    /// The weight of a link that is not cut.
    fn fitted(&self, corner: &Corner, from: [i64; 2], to: [i64; 2], width: f64) -> f64 {
        let [a, b] = [center(from), center(to)];
        if !(corner.has(a) && corner.has(b)) {
            return width;
        }
        let weight = self.flow(corner, from, to) / (corner.value(b) - corner.value(a));
        if weight.is_finite() && weight > 0.0 { clamped(weight, [width / MOST, width * MOST]) } else { width }
    }

    /// What flows through the face between two pixels: the difference of the conjugate at its ends, which is zero at a wall without
    /// colour.
    fn flow(&self, corner: &Corner, from: [i64; 2], to: [i64; 2]) -> f64 {
        let middle = center(from).midpoint(center(to));
        let across = [from[1] - to[1], to[0] - from[0]];
        let at_end = |[x, y]: [i64; 2]| {
            let is_walled = self.meets_wall(from, to, [x, y]) || self.meets_wall(to, from, [x, y]);
            let end = middle + 0.5 * Vec2::new(x as f64, y as f64);
            if is_walled { 0.0 } else { corner.conjugate(middle, end) }
        };
        corner.turn * (at_end(across.map(|d| -d)) - at_end(across))
    }

    /// Whether the way around an end of the face between two pixels, from the first one on, comes to a wall without colour.
    fn meets_wall(&self, from: [i64; 2], to: [i64; 2], [x, y]: [i64; 2]) -> bool {
        let [beside, beyond] = [from, to].map(|p| [p[0] + x, p[1] + y]);
        let steps = [[from, beside], [beside, beyond], [beyond, to]];
        let mut cuts = steps.into_iter().map(|[a, b]| self.cut(a, [b[0] - a[0], b[1] - a[1]]));
        cuts.find_map(|cut| cut).is_some_and(|cut| cut.color.is_none())
    }

    /// The cut of a pixel's link that leads some way.
    fn cut(&self, from: [i64; 2], way: [i64; 2]) -> Option<&Cut> {
        self.constraints.cuts[self.cuts(from)].iter().find(|cut| LINKS[cut.link as usize].1 == way)
    }

    /// The width of the face between two pixels.
    fn width(&self, from: [i64; 2], to: [i64; 2]) -> f64 {
        let pixel = self.pixel([from[0].min(to[0]), from[1].min(to[1])]);
        let Constraints { width_px, height_px, faces, .. } = self.constraints;
        if to[0] < 0 || to[1] < 0 || to[0] >= (*width_px).into() || to[1] >= (*height_px).into() {
            return 0.0;
        }
        let key = (from[0] == to[0], pixel);
        let found = faces.binary_search_by_key(&key, |face| (face.link == Link::South, face.pixel));
        found.map_or(1.0, |i| faces[i].width.into())
    }

    fn pixel(&self, [x, y]: [i64; 2]) -> u32 {
        (y * i64::from(self.constraints.width_px) + x) as u32
    }

    /// The numbers of a pixel's cuts.
    fn cuts(&self, from: [i64; 2]) -> std::ops::Range<usize> {
        let pixel = self.pixel(from);
        let cuts = &self.constraints.cuts;
        cuts.partition_point(|cut| cut.pixel < pixel)..cuts.partition_point(|cut| cut.pixel <= pixel)
    }

    fn is_cut(&self, from: [i64; 2], link: Link) -> bool {
        self.cut(from, LINKS[link as usize].1).is_some()
    }

    /// Whether a wall of a corner is what cuts a link.
    fn is_own(&self, corner: &Corner, from: [i64; 2], cut: &Cut) -> bool {
        let (_, way) = LINKS[cut.link as usize];
        let crossed = center(from) + f64::from(cut.fraction) * center(way).to_vec2();
        corner.is_wall_near(crossed, cut.color.is_some())
    }
}
