//! Which regions a source shades.
//!
//! One that crosses no lines stays in the region that it begins in. It may begin a little across a line from there: then
//! it is where most of it lies. So that it stays there while it grows, the first region decides that a length of one
//! radius of it lies in.

use kurbo::{Point, Rect};
use scumble_core::{SoftSource, Triangulation, clip, nearest_in};

use crate::brush::{self, Brush};

/// A triangle that is in no region.
const NONE: u32 = u32::MAX;

/// Lengths are taken in steps of so many radii.
const STEP: f64 = 1.0 / 32.0;

/// Where a source shows.
#[derive(Debug)]
pub(crate) enum Reach {
    /// In the region of one index.
    Region(u32),
    /// Wherever its brush reaches.
    Brush(Brush),
    /// Nowhere: there is no triangle at all.
    Nowhere,
}

impl Reach {
    /// Whether it shades a region of an index and triangles.
    pub(crate) fn meets(&self, mesh: &Triangulation, index: u32, triangles: &[u32]) -> bool {
        match self {
            Self::Nowhere => false,
            Self::Region(region) => *region == index,
            Self::Brush(brush) => triangles.iter().any(|&t| meets(brush, mesh.corners(t as usize))),
        }
    }
}

/// The regions of a mesh, by place.
#[derive(Debug)]
pub(crate) struct Regions<'a> {
    mesh: &'a Triangulation,
    bounds: Rect,
    of_triangle: Vec<u32>,
    count: usize,
}

impl<'a> Regions<'a> {
    /// The regions of which these are the triangles.
    pub(crate) fn new(mesh: &'a Triangulation, regions: &mut dyn Iterator<Item = &[u32]>) -> Self {
        let mut of_triangle = vec![NONE; mesh.triangle_count()];
        let mut count = 0;
        for triangles in regions {
            triangles.iter().for_each(|&t| of_triangle[t as usize] = count);
            count += 1;
        }
        Self { mesh, bounds: bounds(mesh), of_triangle, count: count as usize }
    }

    pub(crate) fn reach(&self, source: &SoftSource) -> Reach {
        if source.crosses {
            return Reach::Brush(Brush::new(source));
        }
        let region = self.longest(source).or_else(|| self.at_start(source));
        region.map_or(Reach::Nowhere, Reach::Region)
    }

    /// The region of the first point, or where that is off the page, of the place on it that is nearest.
    fn at_start(&self, source: &SoftSource) -> Option<u32> {
        let first = source.points.first().copied().unwrap_or_default();
        self.at(nearest_in(self.bounds, first), &mut 0)
    }

    /// The first region with a radius of the stroke's length, or where there is none, the one with most of it; of
    /// those with equally much the first. `None` where the stroke has no length on the page.
    fn longest(&self, source: &SoftSource) -> Option<u32> {
        let mut lengths_du = vec![0.0; self.count];
        let (mut longest, mut hint) = (None, 0);
        for ends in source.points.windows(2) {
            let [from, to] = clipped([ends[0], ends[1]], self.bounds);
            let steps = ((to - from).hypot() / (STEP * source.radius_du)).ceil();
            let step_du = (to - from).hypot() / steps;
            for i in 0..steps as u64 {
                let at = from.lerp(to, (i as f64 + 0.5) / steps);
                let Some(region) = self.at(at, &mut hint) else { continue };
                lengths_du[region as usize] += step_du;
                let length_du = lengths_du[region as usize];
                if length_du >= source.radius_du {
                    return Some(region);
                }
                if longest.is_none_or(|(_, most_du)| length_du > most_du) {
                    longest = Some((region, length_du));
                }
            }
        }
        longest.map(|(region, _)| region)
    }

    /// The region at a point; the walk to it starts from the triangle of the last one.
    fn at(&self, p: Point, hint: &mut usize) -> Option<u32> {
        *hint = self.mesh.locate(p, *hint)?;
        Some(self.of_triangle[*hint]).filter(|&region| region != NONE)
    }
}

/// The part of a segment that lies in a rectangle; without length where none does.
fn clipped(ends: [Point; 2], rect: Rect) -> [Point; 2] {
    let part = clip(ends, rect).filter(|[start, end]| start < end);
    part.unwrap_or_default().map(|t| ends[0].lerp(ends[1], t))
}

/// Whether a brush draws at a triangle to its colour, or all but does. Where it only passes on what it drew elsewhere
/// nothing comes of it: that would be through lines.
fn meets(brush: &Brush, corners: [Point; 3]) -> bool {
    let [a, b, c] = corners;
    let (middle, spread_du) = brush::around(corners);
    let reach_du = brush.radii_du[1] + spread_du;
    brush.bounds().overlaps(Rect::from_points(a, b).union_pt(c))
        && brush.distance_du(middle, reach_du) < reach_du
}

fn bounds(mesh: &Triangulation) -> Rect {
    let first = mesh.points().first().copied().unwrap_or_default();
    mesh.points().iter().fold(Rect::from_points(first, first), |bounds, p| bounds.union_pt(*p))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_are_clipped_to_the_part_within() {
        let rect = Rect::new(0.0, 0.0, 10.0, 8.0);
        let part = |from: (f64, f64), to: (f64, f64)| clipped([from.into(), to.into()], rect);
        assert_eq!(part((2.0, 2.0), (4.0, 6.0)), [Point::new(2.0, 2.0), Point::new(4.0, 6.0)]);
        assert_eq!(part((-5.0, 4.0), (15.0, 4.0)), [Point::new(0.0, 4.0), Point::new(10.0, 4.0)]);
        assert_eq!(part((5.0, 4.0), (5.0, 12.0)), [Point::new(5.0, 4.0), Point::new(5.0, 8.0)]);
        for (from, to) in [((-5.0, 9.0), (15.0, 9.0)), ((-9.0, 4.0), (-1.0, 4.0)), ((12.0, 4.0), (12.0, 4.0))]
        {
            let [a, b] = part(from, to);
            assert_eq!(a, b, "{from:?} {to:?}");
        }
    }
}
