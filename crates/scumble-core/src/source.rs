//! Soft sources: what shading scribbles lay over the picture.
//!
//! Along its stroke a source of radius `R` and weight `w` covers what is under it, by `α` from 0 to 1, and the rest of the
//! plane draws that back to nothing: `−Δα + α / ℓ² + (w / R²) χ (α − 1) = 0` (screened Poisson equation), where
//! `χ = (1 − d² / R²)²` at the distance `d < R` from the stroke and zero beyond, and `ℓ = R − d / 2`. So it ends softly at
//! the distance `2 R`, whatever the region is like; nothing flows through lines. Where a pen varied `R` or `w` along the
//! stroke, each of `w χ / R²` and `ℓ` is the greatest that any place of the stroke gives, as if it were drawn in dabs.
//!
//! The picture under a source shows by `1 − α`. Where several cover it, their colours count by `α / (1 − α)` each, and the
//! picture under them by 1: so their order makes no difference, and all stays between the colours that are given.

use std::cmp::Ordering;

use kurbo::Point;

use crate::color::{Blend, BlendColor};
use crate::drawing::LONGER_SIDE_DU;
use crate::scribble::{Scribble, Shading};
use crate::sort;

/// A soft source along a stroke.
#[derive(Clone, Debug, PartialEq)]
pub struct SoftSource {
    /// The stroke, in du; at least one point, all finite.
    pub points: Vec<Point>,
    /// Distance from the stroke up to which it draws to its colour, in du; within [`RADII_DU`]. What it lays over the
    /// picture ends at twice that.
    pub radius_du: f64,
    /// How strongly it draws against what the rest of the plane does; positive, without unit. See [`weight`].
    pub weight: f64,
    /// Its colour, in the blend space.
    pub color: BlendColor,
    /// Whether it shows in all regions within its radius, or only in the one that it begins in, or that
    /// most of it lies in where it leaves that at once.
    pub crosses: bool,
    /// For each point the parts that are left of the radius and of the root of the weight there, within `0..=1`, and
    /// linear in between; empty where all is left.
    pub parts: Vec<[f64; 2]>,
}

impl SoftSource {
    /// Whether it differs from another in nothing but the colour.
    pub fn is_alike(&self, other: &Self) -> bool {
        let numbers = |source: &Self| (source.radius_du, source.weight, source.crosses);
        numbers(self) == numbers(other) && self.points == other.points && self.parts == other.parts
    }
}

/// Radii beyond these, in du, are taken as these.
pub const RADII_DU: [f64; 2] = [0.5, LONGER_SIDE_DU];

/// Coordinates beyond this, in du, are taken as this: a thousand pages.
const FARTHEST_DU: f64 = 1000.0 * LONGER_SIDE_DU;

/// What full strength lets through of the picture under it, in the middle of a stroke: colours that are far apart in
/// OKLab need that little to come within two levels of sRGB.
const LEAST_LEFT: f64 = 5e-4;

/// The weight of a source by what it lets through of the picture under it, in the middle of a long and even stroke: times
/// that, over what it does not let through. By the root of what it lets through, in eighths, from the solution of the
/// equation across the stroke.
const WEIGHTS: [f64; 9] = [1.0, 1.320, 1.968, 2.489, 2.869, 3.143, 3.342, 3.488, 3.598];

/// The sources of the scribbles that shade, in an order that does not depend on theirs. Without strength, width or
/// place there is no source.
pub fn soft_sources(scribbles: &[Scribble], blend: Blend) -> Vec<SoftSource> {
    let mut sources: Vec<SoftSource> = Vec::new();
    for source in scribbles.iter().filter_map(|scribble| soft_source(scribble, blend)) {
        let place = sources.partition_point(|before| compare(before, &source).is_le());
        sources.insert(place, source);
    }
    sources
}

fn soft_source(scribble: &Scribble, blend: Blend) -> Option<SoftSource> {
    let shading = scribble.shading()?;
    let weight = weight(shading.strength);
    let (points, mut parts) = pressed(scribble, shading);
    if parts.iter().all(|parts| *parts == [1.0, 1.0]) {
        parts.clear();
    }
    let has_strength = parts.is_empty() || parts.iter().any(|[_, root]| *root > 0.0);
    let is_sound = weight > 0.0 && scribble.width_du > 0.0 && !points.is_empty() && has_strength;
    is_sound.then(|| SoftSource {
        points,
        radius_du: (0.5 * scribble.width_du).clamp(RADII_DU[0], RADII_DU[1]),
        weight,
        color: blend.from_paint(scribble.color),
        crosses: shading.crosses,
        parts,
    })
}

/// The points of a stroke that are finite, and what a pen leaves of the radius and of the root of the weight there. Where
/// strength changes much from one to the next, there are some between: the weight does not grow as evenly as it.
fn pressed(scribble: &Scribble, shading: &Shading) -> (Vec<Point>, Vec<[f64; 2]>) {
    let near = |x: f64| x.clamp(-FARTHEST_DU, FARTHEST_DU);
    let finite = scribble.points.iter().enumerate().filter(|(_, p)| p.is_finite());
    let mut places: Vec<(Point, [f64; 2])> = Vec::new();
    for (i, p) in finite {
        let to = (Point::new(near(p.x), near(p.y)), shading.pressure.parts(i).map(part));
        let from = *places.last().unwrap_or(&to);
        let steps = (STRENGTH_STEPS * (to.1[1] - from.1[1]).abs()).ceil().max(1.0);
        let between = (1..steps as u64).map(|step| lerp(from, to, step as f64 / steps));
        places.extend(between.chain([to]));
    }
    let root = |strength: f64| (weight(strength * shading.strength) / weight(shading.strength)).sqrt();
    places.into_iter().map(|(p, [radius, strength])| (p, [radius, part(root(strength))])).unzip()
}

/// Steps in which a pen's strength may grow from nothing to all from one point to the next.
const STRENGTH_STEPS: f64 = 16.0;

fn lerp((p, a): (Point, [f64; 2]), (q, b): (Point, [f64; 2]), t: f64) -> (Point, [f64; 2]) {
    (p.lerp(q, t), [0, 1].map(|k| (1.0 - t) * a[k] + t * b[k]))
}

/// A part within its range; all for what is no number.
fn part(part: f64) -> f64 {
    if part.is_nan() { 1.0 } else { part.clamp(0.0, 1.0) }
}

/// The weight with which the middle of a long and even stroke covers by its strength what is under it, to a hundredth;
/// and by 0.9995 at full strength. Zero for what is no number.
pub fn weight(strength: f64) -> f64 {
    let strength = if strength.is_nan() { 0.0 } else { strength.clamp(0.0, 1.0) };
    let left = 1.0 - (1.0 - LEAST_LEFT) * strength;
    let at = left.sqrt() * (WEIGHTS.len() - 1) as f64;
    let i = (at as usize).min(WEIGHTS.len() - 2);
    let t = at - i as f64;
    ((1.0 - t) * WEIGHTS[i] + t * WEIGHTS[i + 1]) * (1.0 - left) / left
}

fn compare(a: &SoftSource, b: &SoftSource) -> Ordering {
    key(a).cmp(key(b))
}

/// Numbers that differ where sources do.
fn key(source: &SoftSource) -> impl Iterator<Item = u64> {
    let numbers = [source.radius_du, source.weight, f64::from(u8::from(source.crosses))];
    let points = source.points.iter().flat_map(|p| [p.x, p.y]);
    let parts = source.parts.as_flattened().iter().copied();
    numbers.into_iter().chain(source.color).chain(points).chain(parts).map(sort::float)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::{Paint, Srgb8};
    use crate::scribble::{PenPressure, ScribbleKind};

    fn scribble(strength: f64, width_du: f64, points: &[(f64, f64)]) -> Scribble {
        Scribble {
            color: Paint::Color(Srgb8([200, 30, 40])),
            kind: ScribbleKind::Shade(Shading { strength, ..Shading::default() }),
            width_du,
            points: points.iter().map(|&p| p.into()).collect(),
        }
    }

    fn sources(scribbles: &[Scribble]) -> Vec<SoftSource> {
        soft_sources(scribbles, Blend::Oklab)
    }

    #[test]
    fn weight_grows_with_strength_from_nothing_to_full() {
        let weights = [0.1, 0.5, 0.9, 1.0].map(|strength| sources(&[scribble(strength, 8.0, &[(1.0, 2.0)])]));
        assert!(weights.is_sorted_by(|a, b| a[0].weight < b[0].weight));
        assert_eq!(weights[3][0].weight, weight(1.0));
        assert_eq!(sources(&[scribble(7.0, 8.0, &[(1.0, 2.0)])])[0].weight, weight(1.0));
    }

    #[test]
    fn what_shades_nothing_is_no_source() {
        let dab = [(1.0, 2.0)];
        for strength in [0.0, -0.0, -1.0, f64::NAN, 1e-200] {
            assert_eq!(sources(&[scribble(strength, 8.0, &dab)]), []);
        }
        assert_eq!(sources(&[scribble(1.0, f64::NAN, &dab), scribble(1.0, 0.0, &dab)]), []);
        assert_eq!(sources(&[scribble(1.0, 8.0, &[]), scribble(1.0, 8.0, &[(f64::NAN, 1.0)])]), []);
        assert_eq!(sources(&[Scribble { kind: ScribbleKind::Fill, ..scribble(1.0, 8.0, &dab) }]), []);
    }

    fn pressed(pressure: PenPressure, points: &[(f64, f64)]) -> Scribble {
        let kind = ScribbleKind::Shade(Shading { pressure, ..Shading::default() });
        Scribble { kind, ..scribble(1.0, 8.0, points) }
    }

    #[test]
    fn a_pen_leaves_a_part_of_radius_or_strength_at_each_point() {
        let way = [(1.0, 2.0), (f64::NAN, 0.0), (5.0, 6.0), (7.0, 8.0)];
        let parts = |pressure: PenPressure| sources(&[pressed(pressure, &way)])[0].parts.clone();
        let list = vec![0.25, 0.5, f64::NAN];
        assert_eq!(parts(PenPressure::Radius(list.clone())), [[0.25, 1.0], [1.0, 1.0], [1.0, 1.0]]);
        let full = Shading::default().strength;
        let root = |strength: f64| (weight(strength * full) / weight(full)).sqrt();
        let strengths = parts(PenPressure::Strength(list));
        // Steps of a sixteenth from a quarter to all.
        assert_eq!(strengths.len(), 14);
        assert_eq!([strengths[0], strengths[4]], [0.25, 0.5].map(|strength| [1.0, root(strength)]));
        assert_eq!(strengths[12..], [[1.0, 1.0]; 2]);
        let beyond = parts(PenPressure::Strength(vec![7.0, 0.5, -3.0]));
        assert_eq!([beyond[0], beyond[16]], [[1.0, 1.0], [1.0, 0.0]]);
    }

    #[test]
    fn where_all_is_left_the_source_is_that_of_a_mouse_and_where_nothing_is_there_is_none() {
        let way = [(1.0, 2.0), (5.0, 6.0)];
        let even = sources(&[pressed(PenPressure::Even, &way)]);
        assert_eq!(sources(&[pressed(PenPressure::Radius(vec![1.0, 1.0]), &way)]), even);
        assert_eq!(sources(&[pressed(PenPressure::Strength(vec![2.0]), &way)]), even);
        assert_eq!(sources(&[pressed(PenPressure::Strength(vec![0.0, 0.0]), &way)]), []);
        assert_eq!(sources(&[pressed(PenPressure::Radius(vec![0.0, 0.0]), &way)]).len(), 1);
    }

    #[test]
    fn numbers_out_of_range_are_brought_back() {
        let odd = [(1e300, -1e300), (f64::INFINITY, 0.0), (5.0, 6.0)];
        let source = &sources(&[scribble(1.0, 1e300, &odd)])[0];
        let far = 1024e3;
        assert_eq!(source.points, [Point::new(far, -far), Point::new(5.0, 6.0)]);
        assert_eq!(source.radius_du, 1024.0);
        assert_eq!(sources(&[scribble(1.0, 1e-9, &odd)])[0].radius_du, 0.5);
    }

    #[test]
    fn their_order_makes_no_difference() {
        let a = scribble(0.5, 8.0, &[(1.0, 2.0)]);
        let all = [
            a.clone(),
            Scribble { color: Paint::Clear, ..a.clone() },
            scribble(0.5, 8.0, &[(1.0, 2.5)]),
            a,
            pressed(PenPressure::Radius(vec![0.5]), &[(1.0, 2.0)]),
            pressed(PenPressure::Radius(vec![0.6]), &[(1.0, 2.0)]),
            pressed(PenPressure::Strength(vec![0.5]), &[(1.0, 2.0)]),
        ];
        let forth = sources(&all);
        let back: Vec<_> = all.iter().rev().cloned().collect();
        assert_eq!((forth.len(), &forth), (7, &sources(&back)));
    }
}
