//! What a scribble sees, gathered sample by sample: for each side how often, how far and from where.

use kurbo::Point;

use super::SLIP;
use super::angle::angle_part;
use super::circuit::Circuit;
use super::outline::Outline;
use super::view::{self, Glimpse, Jump};
use crate::planar_map::PlanarMap;
use crate::small_map::SmallMap;
use crate::sort;
use crate::stroke::{SAMPLE_SPACING_DU, Stroke};
use crate::triangulation::SideId;

/// Rays that a side sends out to look for scribbles: one every 5°, as in section 4.2.
const RAYS: u32 = 36;

/// Samples nearer to a side than this count as being at this distance, in du.
const NEAREST_DU: f64 = 0.5;

/// How a scribble sees one side. Sums are over its samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Sighting {
    pub(super) side: SideId,
    /// Number of samples that see it: κ.
    pub(super) kappa: u32,
    pub(super) distance_du: f64,
    /// Sum of 1 / distance.
    nearness: f64,
    /// Angle that it covers, as a part of the full turn.
    pub(super) angle: f64,
    /// The rays of the side that hit the scribble, one bit each.
    rays: u64,
    /// Whether a sample sees the next side of the outline right after it.
    pub(super) joined: bool,
}

impl Sighting {
    fn none(side: SideId) -> Self {
        Self { side, kappa: 0, distance_du: 0.0, nearness: 0.0, angle: 0.0, rays: 0, joined: false }
    }

    fn add(&mut self, eye: Point, [a, b]: [Point; 2], joined: bool) {
        let to_eye = eye - a.midpoint(b);
        let distance_du = to_eye.hypot().max(NEAREST_DU);
        self.kappa += 1;
        self.distance_du += distance_du;
        let nearness = distance_du.recip();
        self.nearness += nearness;
        self.angle += angle_of((a - eye).cross(b - eye), distance_du, (b - a).hypot2());
        self.rays |= rays_that_hit(angle_part(b - a, to_eye), nearness);
        self.joined |= joined;
    }

    /// What speaks for the scribble at this side (equation 5).
    pub(super) fn evidence(&self) -> Evidence {
        Evidence {
            hits: f64::from(self.rays.count_ones()),
            distance_du: f64::from(self.kappa) / self.nearness,
        }
    }
}

/// What the rays from a side find of one scribble: n(Q) and d(Q) of equation 5.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Evidence {
    /// Number of rays that hit the scribble.
    pub(super) hits: f64,
    /// Mean length of these rays.
    pub(super) distance_du: f64,
}

/// Roughly the angle that a piece covers, as a part of the full turn: exact where it is small.
fn angle_of(double_area: f64, distance_du: f64, length2_du2: f64) -> f64 {
    double_area.abs() / (distance_du * distance_du + 0.25 * length2_du2) / std::f64::consts::TAU
}

/// The rays that hit a sample: it hides what it is wide, and lies at `direction` (a part of the half turn).
/// `nearness` is 1 / its distance.
fn rays_that_hit(direction: f64, nearness: f64) -> u64 {
    let half_width = 0.5 * SAMPLE_SPACING_DU * std::f64::consts::FRAC_1_PI * nearness;
    let ray = |part: f64| ((part * f64::from(RAYS)) as u32).min(RAYS - 1);
    let [first, last] = [ray((direction - half_width).max(0.0)), ray(direction + half_width)];
    (2 << last) - (1 << first)
}

/// A place in a list of sightings for each side; kept between calls so that it need not be cleared whole.
#[derive(Clone, Debug)]
pub(super) struct Index(Vec<u32>);

impl Index {
    const ABSENT: u32 = u32::MAX;

    pub(super) fn new(side_count: usize) -> Self {
        Self(vec![Self::ABSENT; side_count])
    }

    /// Where the sighting of a side is, if it is seen.
    pub(super) fn get(&self, side: SideId) -> Option<usize> {
        let place = self.0[side.index()];
        (place != Self::ABSENT).then_some(place as usize)
    }

    fn fill(&mut self, sightings: &[Sighting]) {
        for (place, sighting) in sightings.iter().enumerate() {
            self.0[sighting.side.index()] = place as u32;
        }
    }

    fn clear(&mut self, sightings: &[Sighting]) {
        for sighting in sightings {
            self.0[sighting.side.index()] = Self::ABSENT;
        }
    }
}

/// What one scribble sees and influences, as far as it has been followed.
#[derive(Clone, Debug, Default)]
pub(super) struct Reach {
    stroke: Stroke,
    sightings: Vec<Sighting>,
    parts: SmallMap<Part>,
    /// The sides that it influences, in ascending order.
    influence: Vec<(SideId, Evidence)>,
    /// The gaps that its circuits close.
    gaps: Vec<u32>,
}

/// The part of a scribble that lies in one region.
#[derive(Clone, Debug, Default)]
pub(super) struct Part {
    pub(super) samples: Vec<Point>,
    /// The triangles of the samples.
    pub(super) triangles: Vec<usize>,
    /// In ascending order of sides, without repeats.
    pub(super) jumps: Vec<Jump>,
    /// Places of what is seen of the region in the list of sightings.
    pub(super) places: Vec<usize>,
}

impl Reach {
    /// The points that have been followed.
    pub(super) fn points(&self) -> &[Point] {
        self.stroke.points()
    }

    /// Whether a scribble begins with what has been followed.
    pub(super) fn begins(&self, points: &[Point]) -> bool {
        self.stroke.begins(points)
    }

    /// The sides that the scribble influences with what speaks for it, in ascending order of sides.
    pub(super) fn influence(&self) -> &[(SideId, Evidence)] {
        &self.influence
    }

    /// The gaps of the map that its circuits close.
    pub(super) fn gaps(&self) -> &[u32] {
        &self.gaps
    }

    /// Goes on to the end of a scribble that [begins](Reach::begins) like this.
    pub(super) fn follow(&mut self, map: &PlanarMap, outline: &Outline, index: &mut Index, points: &[Point]) {
        index.fill(&self.sightings);
        let Self { stroke, sightings, parts, .. } = self;
        stroke.follow(map, points, |eye, triangle| {
            let glimpses = view::glimpses(map, outline, eye, triangle);
            for glimpse in &glimpses {
                add(index, sightings, eye, glimpse);
            }
            let part = parts.entry(outline.region_of_triangle(triangle));
            part.samples.push(eye);
            part.triangles.push(triangle);
            view::jumps(eye, &glimpses, &mut part.jumps);
        });
        self.find_influence(map, outline, index);
        index.clear(&self.sightings);
    }

    fn find_influence(&mut self, map: &PlanarMap, outline: &Outline, index: &Index) {
        self.parts.values_mut().for_each(|part| part.places.clear());
        for (place, sighting) in self.sightings.iter().enumerate() {
            let region = outline.region_of_side(sighting.side);
            if let Some(part) = region.and_then(|region| self.parts.get_mut(region)) {
                part.places.push(place);
            }
        }
        self.influence.clear();
        let most = self.parts.values().map(|part| part.samples.len()).max().unwrap_or_default();
        let is_meant = |part: &Part| part.samples.len() as f64 >= SLIP * most as f64;
        for part in self.parts.values_mut().filter(|part| is_meant(part)) {
            // Sides number less than 2³⁰.
            sort::sort_by_key(&mut part.jumps, |jump| {
                sort::pair([jump.from.0, jump.to.0]) << 2 | jump.kind as u64
            });
            part.jumps.dedup();
            let circuit = Circuit::around(map, outline, part, &self.sightings, index);
            self.influence.extend(
                circuit.sides.iter().map(|&place| self.sightings[place]).map(|s| (s.side, s.evidence())),
            );
        }
        sort::sort_by_key(&mut self.influence, |(side, _)| side.0.into());
        if !outline.rooms.is_one() {
            self.find_gaps(outline);
        }
    }

    fn find_gaps(&mut self, outline: &Outline) {
        let is_within = |side: SideId| self.influence.binary_search_by_key(&side, |&(side, _)| side).is_ok();
        let seen = self.sightings.iter().map(|sighting| sighting.side);
        let seen = seen.filter_map(|side| Some((outline.triangle_of_side(side)?, is_within(side))));
        self.gaps = outline.rooms.closed(seen);
    }
}

fn add(index: &mut Index, sightings: &mut Vec<Sighting>, eye: Point, glimpse: &Glimpse) {
    let side = glimpse.side;
    let place = index.get(side).unwrap_or_else(|| {
        index.0[side.index()] = sightings.len() as u32;
        sightings.push(Sighting::none(side));
        sightings.len() - 1
    });
    sightings[place].add(eye, glimpse.line, glimpse.joined);
}
