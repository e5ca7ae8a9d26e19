//! What a scribble sees, gathered view by view, and apart for each region that it goes through.

use super::index::Index;
use super::outline::Outline;
use super::sighting::Sighting;
use super::view::{Jump, Sample, View};
use crate::small_map::SmallMap;
use crate::sort;
use crate::triangulation::SideId;

/// What is seen from some samples of a scribble.
#[derive(Clone, Debug, Default)]
pub(super) struct Survey {
    /// One for each side that is seen.
    pub(super) sightings: Vec<Sighting>,
    parts: SmallMap<Part>,
}

/// The part of a scribble that lies in one region.
#[derive(Clone, Debug, Default)]
pub(super) struct Part {
    pub(super) samples: Vec<Sample>,
    /// In ascending order of sides, without repeats, once they are sorted.
    pub(super) jumps: Vec<Jump>,
    /// Numbers of the sightings of sides of the region.
    pub(super) sightings: Vec<usize>,
}

impl Survey {
    /// Adds a view that stands for some samples.
    pub(super) fn add(
        &mut self,
        outline: &Outline,
        sighting_of: &mut Index,
        samples: &[Sample],
        view: &View,
    ) {
        for &sample in samples {
            self.parts.entry(outline.region_of_triangle(sample.triangle)).samples.push(sample);
        }
        for glimpse in &view.glimpses {
            let number = sighting_of.get(glimpse.side).unwrap_or_else(|| {
                sighting_of.set(glimpse.side, self.sightings.len());
                self.sightings.push(Sighting::none(glimpse.side));
                self.sightings.len() - 1
            });
            self.sightings[number].add(view.eye, glimpse, samples.len() as u32);
        }
        if let Some(last) = samples.last() {
            view.jumps(&mut self.parts.entry(outline.region_of_triangle(last.triangle)).jumps);
        }
    }

    /// Puts in order what is known of each part.
    pub(super) fn complete(&mut self, outline: &Outline) {
        for (number, sighting) in self.sightings.iter().enumerate() {
            let region = outline.region_of_side(sighting.side);
            if let Some(part) = region.and_then(|region| self.parts.get_mut(region)) {
                part.sightings.push(number);
            }
        }
        self.parts.values_mut().for_each(Part::sort);
    }

    /// The parts with not less of the scribble than some share of the largest.
    pub(super) fn parts(&self, least: f64) -> impl Iterator<Item = &Part> {
        let most = self.parts.values().map(|part| part.samples.len()).max().unwrap_or_default();
        self.parts.values().filter(move |part| part.samples.len() as f64 >= least * most as f64)
    }

    /// The sides that are seen.
    pub(super) fn sides(&self) -> impl Iterator<Item = SideId> {
        self.sightings.iter().map(|sighting| sighting.side)
    }
}

impl Part {
    fn sort(&mut self) {
        // Sides number less than 2³⁰.
        sort::sort_copies_by_key(&mut self.jumps, |jump| {
            sort::pair([jump.from.0, jump.to.0]) << 2 | jump.kind as u64
        });
        self.jumps.dedup();
    }
}
