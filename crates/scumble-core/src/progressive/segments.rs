//! Sides seen one after the other, merged into segments, and what it costs a circuit to go along them.

use kurbo::{Point, Vec2};

use super::index::Index;
use super::outline::{Outline, ends};
use super::sighting::Sighting;
use super::{ALPHA, BETA, GAMMA};
use crate::planar_map::PlanarMap;
use crate::triangulation::SideId;

/// A place on a segment: before the side with this number, counted from the segment's start.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Place {
    pub(super) segment: u32,
    pub(super) at: u32,
}

/// Sides that follow one another along an outline, each seen together with the next by one sample.
#[derive(Clone, Copy, Debug)]
pub(super) struct Segment {
    /// Where its sides begin in the list of all.
    pub(super) first: usize,
    pub(super) len: usize,
    /// Whether it is a whole outline, so that its end is its start.
    pub(super) is_closed: bool,
}

/// What a scribble sees of one region, as segments.
#[derive(Debug)]
pub(super) struct Segments<'a> {
    map: &'a PlanarMap,
    index: &'a Index,
    sightings: &'a [Sighting],
    pub(super) segments: Vec<Segment>,
    /// Numbers of sightings, segment by segment.
    pub(super) sides: Vec<usize>,
    /// For each sighting its place in `sides` and its segment.
    place_of: Vec<(u32, u32)>,
    /// Cost of going along all sides before each one.
    cost_before: Vec<f64>,
}

/// Sides that the tangent at the end of a stretch is taken over.
const TANGENT_SIDES: usize = 3;

impl<'a> Segments<'a> {
    /// Merges the sightings with some numbers, seen by `sample_count` samples.
    pub(super) fn new(
        map: &'a PlanarMap,
        outline: &Outline,
        sightings: &'a [Sighting],
        numbers: &[usize],
        index: &'a Index,
        sample_count: usize,
    ) -> Self {
        let mut this = Self {
            map,
            index,
            sightings,
            segments: Vec::new(),
            sides: Vec::with_capacity(numbers.len()),
            place_of: vec![(u32::MAX, u32::MAX); sightings.len()],
            cost_before: Vec::new(),
        };
        this.add_segments(outline, numbers);
        this.charge(sample_count);
        this
    }

    /// From each start on; whole outlines have no start: they are what is left.
    fn add_segments(&mut self, outline: &Outline, numbers: &[usize]) {
        for &sighting in numbers {
            if self.is_start(outline, sighting) {
                self.add_segment(outline, sighting);
            }
        }
        for &sighting in numbers {
            if self.place_of[sighting].0 == u32::MAX {
                self.add_segment(outline, sighting);
            }
        }
    }

    fn is_start(&self, outline: &Outline, sighting: usize) -> bool {
        let before = self.index.get(outline.prev(self.sightings[sighting].side));
        before.is_none_or(|before| !self.sightings[before].joined)
    }

    fn add_segment(&mut self, outline: &Outline, start: usize) {
        let first = self.sides.len();
        let mut is_closed = false;
        let mut sighting = start;
        loop {
            self.place_of[sighting] = (self.sides.len() as u32, self.segments.len() as u32);
            self.sides.push(sighting);
            let seen = &self.sightings[sighting];
            let after = if seen.joined { self.index.get(outline.next(seen.side)) } else { None };
            match after {
                None => break,
                Some(next) if self.place_of[next].0 != u32::MAX => {
                    is_closed = next == start;
                    break;
                }
                Some(next) => sighting = next,
            }
        }
        self.segments.push(Segment { first, len: self.sides.len() - first, is_closed });
    }

    /// Equation 3 for each side, weighted by the part of the view that it takes up.
    fn charge(&mut self, sample_count: usize) {
        let samples = sample_count.max(1) as f64;
        let lengths_du: Vec<f64> = self.segments.iter().map(|segment| self.length_du(segment)).collect();
        let longest_du = lengths_du.iter().copied().fold(0.0, f64::max);
        let distance_du = |sighting: &Sighting| sighting.distance_du / f64::from(sighting.kappa);
        let farthest_du =
            self.sides.iter().map(|&sighting| distance_du(&self.sightings[sighting])).fold(0.0, f64::max);
        let mut sum = 0.0;
        self.cost_before = vec![sum];
        for (segment, length_du) in self.segments.iter().zip(lengths_du) {
            for &sighting in &self.sides[segment.first..segment.first + segment.len] {
                let seen = &self.sightings[sighting];
                // A view may stand for a sample just across a line: then more seem to see the side than there are.
                let e_vis = (1.0 - f64::from(seen.kappa) / samples).max(0.0);
                let e_dist = distance_du(seen) / farthest_du;
                let e_len = 1.0 - length_du / longest_du;
                sum += seen.angle / samples * (ALPHA * e_vis + BETA * e_dist + GAMMA * e_len);
                self.cost_before.push(sum);
            }
        }
    }

    fn length_du(&self, segment: &Segment) -> f64 {
        let sides = &self.sides[segment.first..segment.first + segment.len];
        sides.iter().map(|&sighting| self.ends(sighting)).map(|[a, b]| (b - a).hypot()).sum()
    }

    fn ends(&self, sighting: usize) -> [Point; 2] {
        ends(self.map, self.sightings[sighting].side)
    }

    /// The place before a side.
    pub(super) fn before(&self, side: SideId) -> Option<Place> {
        let (flat, segment) = self.place_of[self.index.get(side)?];
        let first = self.segments.get(segment as usize)?.first;
        Some(Place { segment, at: flat - first as u32 })
    }

    /// The place after a side.
    pub(super) fn after(&self, side: SideId) -> Option<Place> {
        let before = self.before(side)?;
        let segment = self.segments[before.segment as usize];
        let at = before.at + 1;
        Some(Place { at: if segment.is_closed { at % segment.len as u32 } else { at }, ..before })
    }

    /// A number for each place, in ascending order of places.
    pub(super) fn number(&self, place: Place) -> u32 {
        self.segments[place.segment as usize].first as u32 + place.segment + place.at
    }

    /// The sides from one place of a segment on to another, as ranges of the list of all: two where the way goes
    /// over the start of a closed segment. From a place to itself is all around.
    pub(super) fn way(&self, from: Place, to: Place) -> [std::ops::Range<usize>; 2] {
        let segment = self.segments[from.segment as usize];
        let [from, to] = [from, to].map(|place| segment.first + place.at as usize);
        if from < to { [from..to, 0..0] } else { [from..segment.first + segment.len, segment.first..to] }
    }

    /// What it costs to go along a range of sides.
    pub(super) fn cost(&self, range: &std::ops::Range<usize>) -> f64 {
        self.cost_before[range.end] - self.cost_before[range.start]
    }

    /// Where a side of the list of all begins and ends.
    pub(super) fn side_ends(&self, flat: usize) -> [Point; 2] {
        self.ends(self.sides[flat])
    }

    /// Where a place is.
    pub(super) fn point(&self, place: Place) -> Point {
        let segment = self.segments[place.segment as usize];
        let at = place.at as usize;
        if at < segment.len {
            self.side_ends(segment.first + at)[0]
        } else {
            self.side_ends(segment.first + segment.len - 1)[1]
        }
    }

    /// The direction in which a way along a segment arrives at a place, over the last few sides.
    pub(super) fn arriving(&self, place: Place) -> Vec2 {
        let at = if place.at == 0 { self.segments[place.segment as usize].len as u32 } else { place.at };
        let back = at.saturating_sub(TANGENT_SIDES as u32);
        self.point(place) - self.point(Place { at: back, ..place })
    }

    /// The direction in which a way along a segment leaves a place, over the next few sides.
    pub(super) fn leaving(&self, place: Place) -> Vec2 {
        let len = self.segments[place.segment as usize].len as u32;
        let ahead = (place.at + TANGENT_SIDES as u32).min(len);
        self.point(Place { at: ahead, ..place }) - self.point(place)
    }
}
