//! Colours across lines, into regions that no scribble reaches: each joins the neighbour with which it shares the
//! longest border, the longest of all first.
//!
//! A closed curve is the outline of a thing more often than a line within it: its length counts half.

use std::collections::{BTreeMap, BinaryHeap};

use super::flood::NONE;
use crate::planar_map::PlanarMap;
use crate::triangulation::HalfEdge;

/// Lengths are counted in these parts of a du, so that their sums are exact.
const PARTS_PER_DU: f64 = 4096.0;

/// What the map alone says about borders.
#[derive(Clone, Debug)]
pub(super) struct Crossing {
    /// Per triangle.
    region_of: Vec<u32>,
    region_count: usize,
    /// The triangles on either side of each piece of curve inside the page, and how long it counts.
    borders: Vec<([u32; 2], u64)>,
}

impl Crossing {
    pub(super) fn new(map: &PlanarMap) -> Self {
        let mesh = map.triangulation();
        let is_closed: Vec<bool> = (0..map.curve_count()).map(|curve| map.is_closed(curve)).collect();
        let border = |h: HalfEdge| {
            let side = mesh.side(h).filter(|side| !side.is_right())?;
            let curve = map.pieces()[side.piece()].curve?;
            let triangles = [h, mesh.twin(h)?].map(|h| h.triangle() as u32);
            let [a, b] = mesh.segment(h);
            let share = if is_closed[curve as usize] { 0.5 } else { 1.0 };
            Some((triangles, (share * PARTS_PER_DU * (b - a).hypot()) as u64))
        };
        let borders = mesh.half_edges().filter_map(border).collect();
        let (region_of, region_count) = mesh.regions();
        Self { region_of, region_count, borders }
    }

    /// Labels the regions without a label, wherever there is any label to take.
    pub(super) fn cross(&self, labels: &mut [u32], ranks: &[u32]) {
        let mut areas = Areas::new(self.region_count + ranks.len());
        let area = |labels: &[u32], triangle: usize| match ranks.get(labels[triangle] as usize) {
            Some(&rank) => self.region_count as u32 + rank,
            None => self.region_of[triangle],
        };
        for &(triangles, length) in &self.borders {
            let [a, b] = triangles.map(|triangle| area(labels, triangle as usize));
            areas.add_border(a, b, length);
        }
        areas.join_all(self.region_count as u32);
        let mut label_of_rank = vec![NONE; ranks.len()];
        (0..).zip(ranks).for_each(|(label, &rank)| label_of_rank[rank as usize] = label);
        for (label, &region) in labels.iter_mut().zip(&self.region_of).filter(|(label, _)| **label == NONE) {
            if let Some(rank) = (areas.find(region) as usize).checked_sub(self.region_count) {
                *label = label_of_rank[rank];
            }
        }
    }
}

/// Regions, then scribbles, and the borders between them.
struct Areas {
    borders: Vec<BTreeMap<u32, u64>>,
    joined_to: Vec<u32>,
}

impl Areas {
    fn new(count: usize) -> Self {
        Self { borders: vec![BTreeMap::new(); count], joined_to: (0..count as u32).collect() }
    }

    fn add_border(&mut self, a: u32, b: u32, length: u64) {
        if a != b {
            *self.borders[a as usize].entry(b).or_default() += length;
            *self.borders[b as usize].entry(a).or_default() += length;
        }
    }

    /// Joins regions, those below `region_count`, to areas, until only scribbles have borders.
    fn join_all(&mut self, region_count: u32) {
        let mut queue: BinaryHeap<(u64, u32, u32)> = BinaryHeap::new();
        for region in 0..region_count {
            queue.extend(
                self.borders[region as usize].iter().map(|(&other, &length)| (length, region, other)),
            );
        }
        while let Some((length, region, other)) = queue.pop() {
            if self.borders[region as usize].get(&other) != Some(&length) {
                continue;
            }
            self.joined_to[region as usize] = other;
            let moved = std::mem::take(&mut self.borders[region as usize]);
            for (next, length) in moved {
                self.borders[next as usize].remove(&region);
                if next != other {
                    self.add_border(other, next, length);
                    let length = self.borders[other as usize][&next];
                    let pairs = [(other, next), (next, other)].into_iter();
                    queue.extend(pairs.filter(|(from, _)| *from < region_count).map(|(a, b)| (length, a, b)));
                }
            }
        }
    }

    fn find(&self, mut area: u32) -> u32 {
        while self.joined_to[area as usize] != area {
            area = self.joined_to[area as usize];
        }
        area
    }
}
