//! Colours across lines, into regions that no scribble reaches: each joins the neighbour with which it shares the
//! longest border, the longest of all first.
//!
//! A closed curve is the outline of a thing more often than a line within it: its length counts half.

use std::collections::{BTreeMap, BinaryHeap};

use super::flood::NONE;
use crate::planar_map::PlanarMap;
use crate::sets::Sets;
use crate::triangulation::SideId;

/// Lengths are counted in these parts of a du, so that their sums are exact.
const PARTS_PER_DU: f64 = 4096.0;

/// The triangles on either side of a piece, and how long it counts: not 0, as nodes are a step of the lattice apart.
type Border = ([u32; 2], u64);

/// What the map alone says about borders.
#[derive(Clone, Debug)]
pub(super) struct Crossing {
    /// Per triangle.
    region_of: Vec<u32>,
    region_count: usize,
    /// Of all pieces of curve inside the page.
    borders: Vec<Border>,
}

impl Crossing {
    pub(super) async fn new(map: &PlanarMap) -> Self {
        let (region_of, region_count) = map.refined().finding_regions().await;
        let mut beside = beside_pieces(map);
        let mut borders = Vec::new();
        // Curve by curve: one that goes along the same two areas for long is soon counted.
        for curve in 0..map.curve_count() {
            let share = if map.is_closed(curve) { 0.5 } else { 1.0 };
            for side in map.steps(curve).iter().map(|step| step.left) {
                let is_own = map.pieces()[side.piece()].curve == Some(curve as u32);
                if let Some(triangles) = beside[side.piece()].take_if(|_| is_own) {
                    borders.push((triangles, (share * PARTS_PER_DU * length_du(map, side)) as u64));
                }
            }
        }
        Self { region_of, region_count, borders }
    }

    /// Labels the regions without a label, wherever there is any label to take.
    pub(super) fn cross(&self, labels: &mut [u32], ranks: &[u32]) {
        let mut areas = Areas::new(self.region_count + ranks.len());
        let area = |(label, region): (&u32, &u32)| match ranks.get(*label as usize) {
            Some(rank) => self.region_count as u32 + rank,
            None => *region,
        };
        let area_of: Vec<u32> = labels.iter().zip(&self.region_of).map(area).collect();
        let pair = |(triangles, _): &Border| {
            let [a, b] = triangles.map(|triangle| area_of[triangle as usize]);
            [a.min(b), a.max(b)]
        };
        for run in self.borders.chunk_by(|first, second| pair(first) == pair(second)) {
            let [a, b] = pair(&run[0]);
            areas.add_border(a, b, run.iter().map(|(_, length)| length).sum());
        }
        areas.join_all(self.region_count as u32);
        let mut label_of_rank = vec![NONE; ranks.len()];
        (0..).zip(ranks).for_each(|(label, &rank)| label_of_rank[rank as usize] = label);
        for (label, &region) in labels.iter_mut().zip(&self.region_of).filter(|(label, _)| **label == NONE) {
            if let Some(rank) = (areas.sets.find(region) as usize).checked_sub(self.region_count) {
                *label = label_of_rank[rank];
            }
        }
    }
}

/// For each piece the triangles on either side of it, where there are two.
fn beside_pieces(map: &PlanarMap) -> Vec<Option<[u32; 2]>> {
    let mesh = map.refined();
    let mut beside = vec![None; map.pieces().len()];
    for h in mesh.half_edges() {
        if let (Some(side), Some(twin)) = (mesh.side(h), mesh.twin(h)) {
            beside[side.piece()] = Some([h, twin].map(|h| h.triangle() as u32));
        }
    }
    beside
}

fn length_du(map: &PlanarMap, side: SideId) -> f64 {
    let points = map.triangulation().points();
    let [a, b] = map.pieces()[side.piece()].nodes.map(|node| points[node as usize]);
    (b - a).hypot()
}

/// Regions, then scribbles, and how long the borders between them are: 0 once there is none any more. Nothing is taken out of a
/// map, which would be 5 KB of code for every visitor of the page.
struct Areas {
    borders: Vec<BTreeMap<u32, u64>>,
    sets: Sets,
}

impl Areas {
    fn new(count: usize) -> Self {
        Self { borders: vec![BTreeMap::new(); count], sets: Sets::new(count) }
    }

    fn border(&mut self, of: u32, with: u32) -> &mut u64 {
        self.borders[of as usize].entry(with).or_default()
    }

    fn add_border(&mut self, a: u32, b: u32, length: u64) {
        if a != b {
            *self.border(a, b) += length;
            *self.border(b, a) += length;
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
            if *self.border(region, other) != length {
                continue;
            }
            // Those that are no more count, too: what is moved costs as much.
            let count = |area: u32| self.borders[area as usize].len();
            let may_move = other < region_count && count(other) < count(region);
            let (from, to) = if may_move { (other, region) } else { (region, other) };
            let changed = self.join(from, to);
            let pairs =
                changed.into_iter().flat_map(|(next, length)| [(length, to, next), (length, next, to)]);
            queue.extend(pairs.filter(|(_, from, _)| *from < region_count));
        }
    }

    /// Joins an area to a neighbour, which takes its borders; gives those that this made longer.
    fn join(&mut self, from: u32, to: u32) -> Vec<(u32, u64)> {
        self.sets.join(from, to);
        *self.border(to, from) = 0;
        let moved = std::mem::take(&mut self.borders[from as usize]);
        let mut changed = Vec::new();
        for (next, length) in moved.into_iter().filter(|&(next, length)| next != to && length > 0) {
            *self.border(next, from) = 0;
            self.add_border(to, next, length);
            changed.push((next, *self.border(to, next)));
        }
        changed
    }
}
