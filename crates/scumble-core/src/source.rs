//! Soft sources: what shading scribbles add to the equation that spreads colours.
//!
//! Along its stroke a source of radius `R`, weight `w` and colour `c` turns Laplace's equation into
//! `−Δu + (w / R²) χ (u − c) = 0`, where `χ = (1 − d² / R²)²` at the distance `d < R` from the stroke, and zero beyond
//! (screened Poisson equation). Where a pen varied `R` or `w` along the stroke, the term is the greatest that any place of
//! the stroke gives, as if it were drawn in dabs. The solution stays between the colours that are given and has no crease. Where sources
//! overlap, their terms add up.

use std::cmp::Ordering;

use kurbo::Point;

use crate::color::{Blend, BlendColor};
use crate::drawing::LONGER_SIDE_DU;
use crate::scribble::Scribble;
use crate::sort;

/// A soft source along a stroke.
#[derive(Clone, Debug, PartialEq)]
pub struct SoftSource {
    /// The stroke, in du; at least one point, all finite.
    pub points: Vec<Point>,
    /// Distance from the stroke at which it ends, in du; within [`RADII_DU`].
    pub radius_du: f64,
    /// How strong it is against its surroundings; positive.
    pub weight: f64,
    /// Its colour, in the blend space.
    pub color: BlendColor,
    /// Whether it shows in all regions within its radius, or only in the one that it begins in, or that
    /// most of it lies in where it leaves that at once.
    pub crosses: bool,
    /// For each point the parts that are left of radius and strength there, within `0..=1`, and linear in between; empty
    /// where all is left. The weight goes with the third power of strength.
    pub parts: Vec<[f64; 2]>,
}

/// Radii beyond these, in du, are taken as these.
pub const RADII_DU: [f64; 2] = [0.5, LONGER_SIDE_DU];

/// Coordinates beyond this, in du, are taken as this: a thousand pages.
const FARTHEST_DU: f64 = 1000.0 * LONGER_SIDE_DU;

/// The weight at full strength. In the middle of a dab, what is at its rim shows through by 1 in 1100 then: colours that
/// are far apart in OKLab need that to come within two levels of sRGB.
pub const FULL_WEIGHT: f64 = 160.0;

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
    let near = |x: f64| x.clamp(-FARTHEST_DU, FARTHEST_DU);
    let finite = scribble.points.iter().enumerate().filter(|(_, p)| p.is_finite());
    let (points, mut parts): (Vec<_>, Vec<_>) =
        finite.map(|(i, p)| (Point::new(near(p.x), near(p.y)), shading.pressure.parts(i).map(part))).unzip();
    let has_strength = parts.iter().any(|[_, strength]| *strength > 0.0);
    if parts.iter().all(|parts| *parts == [1.0, 1.0]) {
        parts.clear();
    }
    let is_sound = weight > 0.0 && scribble.width_du > 0.0 && has_strength;
    is_sound.then(|| SoftSource {
        points,
        radius_du: (0.5 * scribble.width_du).clamp(RADII_DU[0], RADII_DU[1]),
        weight,
        color: blend.from_paint(scribble.color),
        crosses: shading.crosses,
        parts,
    })
}

/// A part within its range; all for what is no number.
fn part(part: f64) -> f64 {
    if part.is_nan() { 1.0 } else { part.clamp(0.0, 1.0) }
}

/// The weight of a source of some strength: to the eye, even steps of strength are even steps of shade. Zero for what
/// is no number.
fn weight(strength: f64) -> f64 {
    let strength = if strength.is_nan() { 0.0 } else { strength.clamp(0.0, 1.0) };
    FULL_WEIGHT * strength * strength * strength
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
    use crate::scribble::{PenPressure, ScribbleKind, Shading};

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
        assert_eq!(weights[3][0].weight, FULL_WEIGHT);
        assert_eq!(sources(&[scribble(7.0, 8.0, &[(1.0, 2.0)])])[0].weight, FULL_WEIGHT);
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
        assert_eq!(parts(PenPressure::Strength(list)), [[1.0, 0.25], [1.0, 1.0], [1.0, 1.0]]);
        assert_eq!(parts(PenPressure::Strength(vec![7.0, 0.5, -3.0])), [[1.0, 1.0], [1.0, 0.0], [1.0, 1.0]]);
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
