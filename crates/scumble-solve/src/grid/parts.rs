//! The parts of a coarser cell: its unknowns of the finer level, joined where links between them are strong.

use super::level::Level;

/// Most unknowns of four cells.
const MOST: usize = 16;

/// A link weaker than this, as a part of the sum of the links of either unknown, does not make two unknowns one part:
/// through it they can keep different colours.
const STRONG: f32 = 0.08;

/// Of scores that do not differ by more than this the first counts: devices round them differently, and symmetric drawings
/// have many that are the same.
const CLEARLY: f32 = 1.001;

/// A part whose links lead out by no more than this, as a part of its links and of what holds it, is taken as one whose links
/// all stay within: less is what rounding leaves.
const ROUNDING: f32 = 1e-5;

/// Marks for each unknown which slot of its coarser cell it is a part of.
pub(super) fn mark(level: &mut Level, slots: usize) {
    let mut members = Members::default();
    for y in 0..level.rows.div_ceil(2) as i32 {
        for x in 0..level.columns.div_ceil(2) as i32 {
            members.find(level, x, y);
            let parents = members.parents(slots);
            for (i, (x, y)) in members.places.into_iter().take(members.count).enumerate() {
                level.holds.texels[y as usize * level.holds.width + x as usize][3] = f32::from(parents[i]);
            }
        }
    }
}

/// The unknowns of four cells, and the links between them.
#[derive(Default)]
struct Members {
    count: usize,
    places: [(i32, i32); MOST],
    /// Sum of the weights of all links of each, and how strongly it is held.
    links: [f32; MOST],
    holds: [f32; MOST],
    /// Members and weight of the links among them.
    inner: Vec<(usize, usize, f32)>,
}

impl Members {
    fn find(&mut self, level: &Level, cell_x: i32, cell_y: i32) {
        self.count = 0;
        self.inner.clear();
        for (dx, dy) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
            let (x, y) = (2 * cell_x + dx, 2 * cell_y + dy);
            if x < level.columns as i32 && y < level.rows as i32 {
                (0..level.slots as i32).for_each(|slot| self.add(level, level.column(x, slot), y));
            }
        }
    }

    /// Adds an unknown, if it is one at all, with its links to those that are there already.
    fn add(&mut self, level: &Level, x: i32, y: i32) {
        let [hold, diagonal, ..] = level.holds.load(x, y);
        if diagonal == 0.0 {
            return;
        }
        let i = self.count;
        level.for_each_link(x, y, |weight, nx, ny| {
            if let Some(j) = self.places[..i].iter().position(|&place| place == (nx, ny)) {
                self.inner.push((i, j, weight));
            }
        });
        (self.places[i], self.links[i], self.holds[i]) = ((x, y), diagonal - hold, hold);
        self.count += 1;
    }

    /// The slot of each member, counted from 1; 0 for none.
    fn parents(&self, slots: usize) -> [u8; MOST] {
        let labels = self.labels();
        let mut scores = self.scores(&labels);
        let mut parents = [0; MOST];
        for slot in 1..=slots {
            let is_better = |i: usize, best: usize| scores[i] > CLEARLY * scores[best];
            let best = (0..self.count).fold(0, |best, i| if is_better(i, best) { i } else { best });
            if scores[best] <= 0.0 {
                break;
            }
            scores[best] = 0.0;
            (0..self.count).filter(|&i| labels[i] == best).for_each(|i| parents[i] = slot as u8);
        }
        parents
    }

    /// The first member of the part that each belongs to.
    fn labels(&self) -> [usize; MOST] {
        let mut labels: [usize; MOST] = std::array::from_fn(|i| i);
        for _ in 0..self.count {
            let before = labels;
            for &(i, j, weight) in &self.inner {
                if weight >= STRONG * self.links[i].min(self.links[j]) {
                    let label = labels[i].min(labels[j]);
                    (labels[i], labels[j]) = (label, label);
                }
            }
            if labels == before {
                break;
            }
        }
        labels
    }

    /// How much the coarser level can do for each part, by its first member: its links to other parts, and less of it
    /// where it is held.
    fn scores(&self, labels: &[usize; MOST]) -> [f32; MOST] {
        let (mut links, mut holds) = ([0.0; MOST], [0.0; MOST]);
        for i in 0..self.count {
            links[labels[i]] += self.links[i];
            holds[labels[i]] += self.holds[i];
        }
        let all = links;
        for &(i, j, weight) in self.inner.iter().filter(|(i, j, _)| labels[*i] == labels[*j]) {
            links[labels[i.min(j)]] -= 2.0 * weight;
        }
        let leads_out = |i: usize| links[i] > ROUNDING * (all[i] + holds[i]);
        std::array::from_fn(|i| if leads_out(i) { links[i] * links[i] / (links[i] + holds[i]) } else { 0.0 })
    }
}
