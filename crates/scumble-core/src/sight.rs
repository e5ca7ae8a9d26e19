//! The `Sight` engine: a scribble claims the sides that it sees, and the latest scribble wins.
//!
//! The sampling is that of section 4.1 of Bao & Fu 2019; what the paper then does to tell a scribble's own
//! boundary from what it sees through gaps is left to other engines.

use std::mem;

use kurbo::Point;

use crate::engine::{Engine, Labels};
use crate::pace::Slices;
use crate::planar_map::PlanarMap;
use crate::scribble::Scribble;
use crate::stroke::Stroke;
use crate::triangulation::SideId;
use crate::visibility::visibility_polygon;

/// Claims sides by sight; keeps what each scribble of the last call saw.
#[derive(Clone, Debug, Default)]
pub struct Sight {
    reaches: Vec<Reach>,
}

impl Engine for Sight {
    /// All in one.
    fn labelling<'a>(&'a mut self, map: &'a PlanarMap, scribbles: &'a [Scribble]) -> Slices<'a, Labels> {
        Slices::new(async { self.labels(map, scribbles) })
    }
}

impl Sight {
    fn labels(&mut self, map: &PlanarMap, scribbles: &[Scribble]) -> Labels {
        self.reaches.resize_with(scribbles.len(), Reach::default);
        let mut labels = Labels::none(map);
        for (i, (scribble, reach)) in scribbles.iter().zip(&mut self.reaches).enumerate() {
            reach.follow(map, &scribble.points);
            for side in &reach.sides {
                labels.sides[side.index()] = Some(i as u32);
            }
        }
        labels
    }
}

/// What a scribble saw, as far as it has been followed.
#[derive(Clone, Debug, Default)]
struct Reach {
    stroke: Stroke,
    /// Without repeats.
    sides: Vec<SideId>,
}

impl Reach {
    /// Goes on to the end of a scribble, from the start again where it is not the one that was followed so far.
    fn follow(&mut self, map: &PlanarMap, points: &[Point]) {
        if !self.stroke.begins(points) {
            *self = Self::default();
        }
        if self.stroke.points().len() == points.len() {
            return;
        }
        let mut is_new = vec![true; map.side_count()];
        self.sides.iter().for_each(|side| is_new[side.index()] = false);
        let sides = &mut self.sides;
        self.stroke.follow(map, points, |eye, triangle| {
            see(map, eye, triangle, |side| {
                if mem::take(&mut is_new[side.index()]) {
                    sides.push(side);
                }
            });
        });
    }
}

/// Calls `claim` with the sides whose middle is seen from a point in a triangle.
fn see(map: &PlanarMap, eye: Point, triangle: usize, mut claim: impl FnMut(SideId)) {
    let mesh = map.triangulation();
    visibility_polygon(mesh, eye, triangle, |seen| {
        if seen.interval[0] <= 0.5 && 0.5 <= seen.interval[1] {
            mesh.side(seen.half_edge).into_iter().for_each(&mut claim);
        }
    });
}
