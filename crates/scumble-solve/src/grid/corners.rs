//! The equations of pixels near corners where the solution is steep without end: where one wall gives a colour and the next
//! one, more than a right angle on, gives none. Worst is the tip of a curve with one coloured side.
//!
//! There the solution goes as a power of the distance, `r^λ sin(λθ)` with θ counted from the wall with a colour and λ below
//! 1, and what pixels get wrong at the corner is wrong in the whole region. Weights of links are those that this function
//! satisfies: what flows through a face, by the difference of the pixels (after the fitted schemes of D. N. de G. Allen,
//! R. V. Southwell, 1955).

use std::f64::consts::{FRAC_PI_2, TAU};

use kurbo::{Affine, Point, Vec2};
use scumble_core::{Boundary, Piece, PlanarMap, SideId, sort};

use super::constraints::Constraints;
use super::cut_links::{Cut, Face, LEAST_FRACTION, Link};
use super::wall::centers_from_du;
use crate::scene::View;

/// Pixels within this distance of a corner are fitted to it, in px.
const REACH_PX: f64 = 6.0;

/// Angles up to this much more than a right one are well enough as they are.
const SLACK: f64 = 0.1;

/// Weights become at most so many times larger or smaller.
const MOST: f64 = 4.0;

/// A cut belongs to a wall of a corner that is so close by, in px.
const NEAR_PX: f64 = 0.5;

/// The plane between two walls at a corner, in px, pixel centres having whole coordinates.
#[derive(Clone, Copy, Debug)]
struct Corner {
    tip: Point,
    reach_px: f64,
    /// Along the wall with a colour.
    colored: Vec2,
    /// From that wall to the other one.
    angle: f64,
    /// 1 where angles grow from that wall on as `atan2` has it, else −1.
    turn: f64,
}

impl Corner {
    fn power(&self) -> f64 {
        FRAC_PI_2 / self.angle
    }

    /// The angle of a place from the wall with a colour, from 0 to 2π.
    fn angle_of(&self, p: Point) -> f64 {
        let way = p - self.tip;
        (self.turn * self.colored.cross(way).atan2(self.colored.dot(way))).rem_euclid(TAU)
    }

    /// The function at a place at an angle, and its conjugate.
    fn at(&self, p: Point, angle: f64) -> [f64; 2] {
        let (length, power) = (p.distance(self.tip).powf(self.power()), self.power());
        [length * (power * angle).sin(), length * (power * angle).cos()]
    }

    fn has(&self, p: Point) -> bool {
        p.distance(self.tip) <= self.reach_px && self.angle_of(p) <= self.angle
    }

    fn value(&self, p: Point) -> f64 {
        self.at(p, self.angle_of(p))[0]
    }

    /// The angles of both walls, and their directions.
    fn walls(&self) -> [(f64, Vec2); 2] {
        [0.0, self.angle].map(|angle| (angle, Vec2::from_angle(self.colored.atan2() + self.turn * angle)))
    }

    /// The conjugate at an end of a face, or where a wall ends it on the way from its middle.
    fn conjugate(&self, middle: Point, end: Point) -> f64 {
        let near = self.angle_of(middle) < 0.5 * self.angle;
        let hit = |(angle, along)| Some((angle, crossing([middle, end], self.tip, along)?));
        let mut hits = self.walls().into_iter().filter_map(hit);
        match hits.find(|(angle, _)| self.angle < TAU - 1e-9 || near == (*angle == 0.0)) {
            Some((angle, hit)) => self.at(hit, angle)[1],
            None => self.at(end, self.angle_of(end))[1],
        }
    }

    /// What the weight of the link between two pixels is to be, if there is one that fits.
    fn weight(&self, a: Point, b: Point) -> Option<f64> {
        let middle = a.midpoint(b);
        let across = 0.5 * Vec2::new(a.y - b.y, b.x - a.x);
        let flow = self.conjugate(middle, middle - across) - self.conjugate(middle, middle + across);
        let weight = self.turn * flow / (self.value(b) - self.value(a));
        (weight.is_finite() && weight > 0.0).then_some(weight)
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
    /// Whether its left and its right side have colours.
    is_colored: [bool; 2],
}

/// The walls at all nodes: by node, and by their angles there.
fn rays(map: &PlanarMap, boundary: &Boundary, px_from_du: Affine) -> Vec<Ray> {
    let is_colored = |side: SideId| boundary.sides.get(side.index()).is_some_and(Option::is_some);
    let at = |node: u32| px_from_du * map.triangulation().points()[node as usize];
    let both = |[start, end]: [u32; 2], [left, right]: [bool; 2]| {
        let along = at(end) - at(start);
        let back = Ray { node: end, along: -along, is_colored: [right, left] };
        [Ray { node: start, along, is_colored: [left, right] }, back]
    };
    let piece = |(i, piece): (usize, &Piece)| {
        both(piece.nodes, [false, true].map(|is_right| is_colored(SideId::of(i, is_right))))
    };
    let closed = map.gaps().iter().zip(&boundary.closed_gaps).filter(|(_, closed)| **closed);
    let gaps = closed.flat_map(|(gap, _)| both(gap.nodes, [false; 2]));
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
    let [left, right] = [ray.is_colored[0], next.is_colored[1]];
    let angle = (next.along.atan2() - ray.along.atan2()).rem_euclid(TAU);
    let angle = if angle == 0.0 { TAU } else { angle };
    let (colored, turn) = if left { (ray.along, 1.0) } else { (next.along, -1.0) };
    let corner = Corner { tip, reach_px: REACH_PX, colored, angle, turn };
    (left != right && angle > FRAC_PI_2 + SLACK).then_some(corner)
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

fn center([x, y]: [i64; 2]) -> Point {
    Point::new(x as f64, y as f64)
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
        let cuts = self.cuts(from);
        let is_own = |i: usize| self.wall_of(corner, &self.constraints.cuts[i], from);
        let own: Vec<_> = cuts.clone().filter(|&i| is_own(i) == Some(0)).collect();
        if own.is_empty() || cuts.clone().any(|i| is_own(i).is_none()) {
            return Vec::new();
        }
        let strength: f64 = own.iter().map(|&i| 1.0 / f64::from(self.constraints.cuts[i].fraction)).sum();
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
        let weight = if corner.has(a) && corner.has(b) { corner.weight(a, b) } else { None };
        weight.map_or(width, |weight| weight.clamp(width / MOST, width * MOST))
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
        self.constraints.cuts[self.cuts(from)].iter().any(|cut| cut.link == link)
    }

    /// Which wall of a corner cuts a link: 0 is that with a colour.
    fn wall_of(&self, corner: &Corner, cut: &Cut, from: [i64; 2]) -> Option<usize> {
        let (_, way) = LINKS[cut.link as usize];
        let crossed = center(from) + f64::from(cut.fraction) * center(way).to_vec2() - corner.tip;
        let wall = usize::from(cut.color.is_none());
        let (_, along) = corner.walls()[wall];
        (along.cross(crossed).abs() < NEAR_PX && along.dot(crossed) > -NEAR_PX).then_some(wall)
    }
}

/// Where a ray crosses a line from a place to another one.
fn crossing([from, to]: [Point; 2], origin: Point, along: Vec2) -> Option<Point> {
    let (way, start) = (to - from, from - origin);
    let turn = way.cross(along);
    let t = along.cross(start) / turn;
    let hit = from + t * way;
    (turn != 0.0 && (0.0..=1.0).contains(&t) && (hit - origin).dot(along) >= 0.0).then_some(hit)
}
