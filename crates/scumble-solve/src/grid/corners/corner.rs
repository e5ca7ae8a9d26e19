//! A corner between two walls, and what the solution is like there.
//!
//! It goes as a power λ of the distance: as `r^λ sin(λθ)`, or as the cosine where no wall gives a colour, θ being counted from a
//! wall; where the walls give two colours, what goes evenly with θ from one to the other comes on top. Around a short stretch
//! with a colour between walls without one, it goes as the logarithm of the distance.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use kurbo::{Point, Vec2};
use scumble_core::{BlendColor, SideId, clamped, sort};

use super::super::cut_links::{Cut, WAYS};
use super::arcosh::arcosh;
use super::patch::center;

/// Powers from this on are well enough as they are.
const REGULAR: f64 = 0.9;

/// A cut belongs to a wall of a corner that is so close by, in px.
const NEAR_PX: f64 = 0.5;

/// The corners at the ends of a stretch with a colour that is shorter than this are taken together, in px.
pub(super) const SHORT_PX: f64 = 1.0;

/// Needles are well enough as pixels see them from a stretch s of this length on (see [`Corner::around_needle`]), in px.
const NEEDLE_PX: f64 = 1.25;

/// Walls go on straight past a stretch if the angle between them differs from π by less than this, in radians.
const STRAIGHT: f64 = 0.5;

/// Cuts so close to the middle of a stretch are beside it, in px.
const BESIDE_PX: f64 = 0.75;

/// A wall at a node, seen from there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ray {
    pub(super) node: u32,
    /// The node that it leads to.
    pub(super) end: u32,
    pub(super) along: Vec2,
    /// What is on its left and on its right there.
    pub(super) faces: [Face; 2],
}

/// One side of a wall, at a node.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Face {
    /// `None` for a gap.
    pub(super) side: Option<SideId>,
    pub(super) color: Option<BlendColor>,
}

/// The plane between two walls at a corner, in px, pixel centres having whole coordinates.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    pub(super) tip: Point,
    /// Where the node is that it is at. What is around a needle has its tip beside that.
    node: Point,
    /// Along the first wall, which has a colour if one has any.
    first: Vec2,
    /// From that wall to the other one.
    pub(super) angle: f64,
    /// What these walls give there.
    colors: [Option<BlendColor>; 2],
    /// 1 where angles grow from that wall on as `atan2` has it, else −1.
    pub(super) turn: f64,
    /// The side of the first wall that faces the other one; `None` for that of a gap. Of a stretch at the tip, its own.
    pub(super) side: Option<SideId>,
    /// What has a colour between two walls that have none.
    stretch: Option<Stretch>,
}

/// A short stretch of a wall, whose middle is the tip of a corner.
#[derive(Clone, Copy, Debug)]
struct Stretch {
    half_px: f64,
    color: BlendColor,
}

impl Corner {
    /// What lies between a wall at a node and the next one there.
    pub(super) fn between(tip: Point, ray: &Ray, next: &Ray) -> Self {
        let [left, right] = [ray.faces[0], next.faces[1]];
        let angle = angle_between(ray.along, next.along);
        let is_left_first = left.color.is_some() || right.color.is_none();
        let (along, turn, faces) =
            if is_left_first { (ray.along, 1.0, [left, right]) } else { (next.along, -1.0, [right, left]) };
        let colors = faces.map(|face| face.color);
        Self { tip, node: tip, first: along, angle, colors, turn, side: faces[0].side, stretch: None }
    }

    /// What lies around a short stretch with a colour, given what lies at its ends, where the walls go on nearly straight.
    fn around_stretch([one, other]: [Self; 2]) -> Option<Self> {
        let ([Some(color), None], [Some(_), None]) = (one.colors, other.colors) else { return None };
        let length_px = one.tip.distance(other.tip);
        let angle = one.angle + other.angle - PI;
        let is_straight = (angle - PI).abs() < STRAIGHT;
        (is_straight && length_px > 0.0 && length_px < SHORT_PX).then(|| Self {
            tip: one.tip.midpoint(other.tip),
            node: one.tip.midpoint(other.tip),
            first: one.other_wall(),
            angle,
            colors: [None; 2],
            turn: -one.turn,
            side: one.side,
            stretch: Some(Stretch { half_px: 0.5 * length_px, color }),
        })
    }

    /// What lies around a needle: a short wall that ends at a tip, and stands at its foot where a wall without colour goes on nearly
    /// straight, from `before` the needle to `after` it as angles grow.
    ///
    /// Of a needle of length ℓ at the angle aπ to what is after it, `z = (w − (1 − a)s)^a (w + as)^(1 − a)` with
    /// `s = ℓ / (a^a (1 − a)^(1 − a))` takes the half plane of `w` to that of `z` without the needle, and what is far off to
    /// itself. There its left face is the stretch of the wall from `(1 − 2a)s` to `(1 − a)s`, its right one that from `−as` on.
    pub(super) fn around_needle(
        foot: Point,
        [before, needle, after]: [&Ray; 3],
        length_px: f64,
    ) -> Option<Self> {
        let is_bare = before.faces[0].color.is_none() && after.faces[1].color.is_none();
        let [to_left, to_right] =
            [angle_between(needle.along, after.along), angle_between(before.along, needle.along)];
        let angle = to_left + to_right;
        let a = to_left / angle;
        let [left, right] = needle.faces;
        let (Face { side, color }, ends) = match [left.color, right.color] {
            [Some(_), None] => (left, [1.0 - 2.0 * a, 1.0 - a]),
            [None, Some(_)] => (right, [-a, 1.0 - 2.0 * a]),
            [one, other] if one == other => (left, [-a, 1.0 - a]),
            _ => return None,
        };
        let (color, scale_px) = (color?, length_px / (a.powf(a) * (1.0 - a).powf(1.0 - a)));
        let [middle_px, half_px] = [ends[1] + ends[0], ends[1] - ends[0]].map(|sum| 0.5 * sum * scale_px);
        (is_bare && scale_px < NEEDLE_PX && (angle - PI).abs() < STRAIGHT).then_some(Self {
            tip: foot + middle_px * after.along / after.along.hypot(),
            node: foot,
            first: before.along,
            angle,
            colors: [None; 2],
            turn: 1.0,
            side,
            stretch: Some(Stretch { half_px, color }),
        })
    }

    fn other_wall(&self) -> Vec2 {
        Vec2::from_angle(self.first.atan2() + self.turn * self.angle)
    }

    /// Whether the solution is steep without end.
    pub(super) fn is_singular(&self) -> bool {
        self.stretch.is_some() || self.power() < REGULAR
    }

    /// From the colour of the first wall to that of the other one; `None` where they are not two.
    pub(super) fn jump(&self) -> Option<[f32; 4]> {
        let [from, to] = [self.colors[0]?, self.colors[1]?];
        (from != to).then(|| single([0, 1, 2, 3].map(|c| to[c] - from[c])))
    }

    /// The colour of the wall that is nearer to a direction, if it gives one.
    pub(super) fn color_near(&self, angle: f64) -> Option<[f32; 4]> {
        if let Some(stretch) = &self.stretch {
            return Some(single(stretch.color));
        }
        let [first, other] = self.colors;
        let near = if angle < 0.5 * self.angle || other.is_none() { first } else { other };
        near.map(single)
    }

    /// The direction of the wall that gives a colour.
    pub(super) fn angle_of_color(&self, color: [f32; 4]) -> Option<f64> {
        let walls = self.colors.into_iter().zip([0.0, self.angle]);
        walls.into_iter().find(|(wall, _)| wall.map(single) == Some(color)).map(|(_, angle)| angle)
    }

    fn power(&self) -> f64 {
        let [first, other] = self.colors.map(|color| color.is_some());
        if first == other { PI / self.angle } else { FRAC_PI_2 / self.angle }
    }

    /// The direction in which a place lies, as an angle from the first wall, from 0 to 2π.
    pub(super) fn angle_of(&self, p: Point) -> f64 {
        let way = p - self.tip;
        (self.turn * self.first.cross(way).atan2(self.first.dot(way))).rem_euclid(TAU)
    }

    /// By how much that angle grows on the straight way from one place to another.
    pub(super) fn turned(&self, from: Point, to: Point) -> f64 {
        let [from, to] = [from, to].map(|p| p - self.tip);
        self.turn * from.cross(to).atan2(from.dot(to))
    }

    /// Whether a place lies between the walls, and is so far from both, in px.
    pub(super) fn is_between(&self, p: Point, clear_px: f64) -> bool {
        let (angle, length_px) = (self.angle_of(p), p.distance(self.tip));
        let is_clear = |angle: f64| length_px * if angle < FRAC_PI_2 { angle.sin() } else { 1.0 } >= clear_px;
        angle < self.angle && is_clear(angle) && is_clear(self.angle - angle)
    }

    /// The steep function at a place at an angle, and its conjugate.
    pub(super) fn steep(&self, p: Point, angle: f64) -> [f64; 2] {
        let half_px = self.stretch.map_or(1.0, |stretch| stretch.half_px);
        let length = (p.distance(self.tip) / half_px).powf(self.power());
        let (sin, cos) = (self.power() * angle).sin_cos();
        if self.stretch.is_some() {
            let [real, imaginary] = arcosh([length * cos, length * sin]);
            return [real, -imaginary];
        }
        if self.colors[0].is_some() { [length * sin, length * cos] } else { [length * cos, -length * sin] }
    }

    /// The conjugate at the wall without colour that cuts a link of a pixel. Beside a stretch with a colour both walls meet: there
    /// it is that of neither.
    pub(super) fn conjugate_at_wall(&self, at: [i64; 2], cut: &Cut) -> Option<f64> {
        if self.stretch.is_none() {
            return Some(0.0);
        }
        let crossed = self.crossed(at, cut);
        let is_other = crossed.dot(self.other_wall()) > crossed.dot(self.first) / self.first.hypot();
        (crossed.hypot() > BESIDE_PX).then_some(if is_other { -PI } else { 0.0 })
    }

    /// The conjugate at a place at an angle, as it is at the nearer wall where the place is not between them.
    pub(super) fn conjugate(&self, p: Point, angle: f64) -> f64 {
        let angle = if self.stretch.is_some() { clamped(angle, [0.0, self.angle]) } else { angle };
        self.steep(p, angle)[1]
    }

    /// Where a link of a pixel is cut, seen from the tip.
    fn crossed(&self, at: [i64; 2], cut: &Cut) -> Vec2 {
        let (_, way) = WAYS[cut.link as usize];
        center(at) + f64::from(cut.fraction) * center(way).to_vec2() - self.tip
    }

    /// Whether one of its walls is what cuts a link of a pixel.
    pub(super) fn is_cut(&self, at: [i64; 2], cut: &Cut) -> bool {
        let crossed = self.crossed(at, cut);
        if let Some(stretch) = self.stretch
            && crossed.hypot() <= stretch.half_px + NEAR_PX
        {
            return true;
        }
        let walls = [self.first / self.first.hypot(), self.other_wall()].into_iter().zip(self.colors);
        let mut alike = walls.filter(|(_, color)| color.is_some() == cut.color.is_some());
        alike.any(|(along, _)| along.cross(crossed).abs() < NEAR_PX && along.dot(crossed) > -NEAR_PX)
    }
}

/// Corners, with those at both ends of a short stretch with a colour taken together: a side has a corner at each end.
pub(super) fn with_stretches(corners: &[Corner]) -> Vec<Corner> {
    let mut list = corners.to_vec();
    sort::sort_copies_by_key(&mut list, |corner| corner.side.map_or(u64::MAX, |side| side.index() as u64));
    let together = list.chunk_by(|a, b| a.side.is_some() && a.side == b.side).flat_map(|of_side| {
        let around = <[_; 2]>::try_from(of_side).ok().and_then(Corner::around_stretch);
        around.map_or_else(|| of_side.to_vec(), |around| vec![around])
    });
    together.collect()
}

/// Corners, and how far the nearest one at another place is from each, or as far as asked for.
pub(super) fn apart(corners: impl Iterator<Item = Corner>, most_px: f64) -> Vec<(Corner, f64)> {
    let mut list: Vec<_> = corners.map(|corner| (corner, most_px)).collect();
    sort::sort_copies_by_key(&mut list, |(corner, _)| sort::float(corner.tip.x));
    for i in 0..list.len() {
        for j in i + 1..list.len() {
            let [a, b] = [&list[i].0, &list[j].0];
            if b.tip.x - a.tip.x > most_px {
                break;
            }
            let distance_px = a.tip.distance(b.tip);
            if a.node != b.node {
                [i, j].into_iter().for_each(|k| list[k].1 = list[k].1.min(distance_px));
            }
        }
    }
    list
}

/// From one direction on to another as angles grow: more than 0, up to 2π.
fn angle_between(from: Vec2, to: Vec2) -> f64 {
    let angle = (to.atan2() - from.atan2()).rem_euclid(TAU);
    if angle == 0.0 { TAU } else { angle }
}

fn single(color: BlendColor) -> [f32; 4] {
    color.map(|c| c as f32)
}
