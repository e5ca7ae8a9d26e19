//! One level of the hierarchy of grids: cells in rows, and how their unknowns hang together.
//!
//! On the finest level a cell is a pixel with one unknown. On the coarser ones it is four cells of the level before, and
//! has up to [`SLOTS`] unknowns: one for each part of the cell that no wall divides, so that a colour on one side of a
//! curve is never mixed with that on the other side. Parts beyond that number, those that given colours hold anyway,
//! are left to the finer level. The unknowns of a cell lie side by side in textures.

use super::cut_links::{CutLinks, Link};
use super::texture::{Texel, Texture};

/// Unknowns of a cell, save on the finest level.
pub(super) const SLOTS: usize = 4;

/// A link weaker than this, as a part of the strongest of either unknown, does not make two unknowns one.
const STRONG: f32 = 0.25;

/// A level: the matrix of its unknowns. It is symmetric; what a row has besides its links holds it to given colours.
#[derive(Clone, Debug)]
pub(super) struct Level {
    pub(super) columns: usize,
    pub(super) rows: usize,
    /// Unknowns of a cell.
    pub(super) slots: usize,
    /// Weights of the links of each unknown to the slots of the cell to the east.
    pub(super) east: Texture,
    /// The same for the cell to the south.
    pub(super) south: Texture,
    /// For each unknown: how strongly it is held, the diagonal of the matrix, the damping of the interpolation to it,
    /// and which slot of the coarser cell it is a part of, counted from 1; 0 for none.
    pub(super) holds: Texture,
}

impl Level {
    /// The finest level, and the right side of its equations.
    pub(super) fn finest(cuts: &CutLinks) -> (Self, Texture) {
        let (columns, rows) = (cuts.width_px as usize, cuts.height_px as usize);
        let mut level = Self::empty(columns, rows, 1);
        let mut right = Texture::new(columns, rows);
        let open = |is_within: bool| [f32::from(u8::from(is_within)), 0.0, 0.0, 0.0];
        level.east.draw(|x, _| open(x as usize + 1 < columns));
        level.south.draw(|_, y| open(y as usize + 1 < rows));
        for cut in &cuts.cuts {
            let i = cut.pixel as usize;
            match cut.link {
                Link::East => level.east.texels[i][0] = 0.0,
                Link::South => level.south.texels[i][0] = 0.0,
                Link::West | Link::North => {}
            }
            if let Some(color) = cut.color {
                let weight = 1.0 / cut.fraction;
                level.holds.texels[i][0] += weight;
                right.texels[i] = super::texture::plus(right.texels[i], color.map(|c| weight * c));
            }
        }
        level.sum_up();
        (level, right)
    }

    fn empty(columns: usize, rows: usize, slots: usize) -> Self {
        let texture = Texture::new(columns * slots, rows);
        Self { columns, rows, slots, east: texture.clone(), south: texture.clone(), holds: texture }
    }

    /// The next coarser level; marks which unknown of this one is a part of which.
    pub(super) fn coarser(&mut self) -> Self {
        let mut coarse = Self::empty(self.columns.div_ceil(2), self.rows.div_ceil(2), SLOTS);
        for y in 0..coarse.rows as i32 {
            for x in 0..coarse.columns as i32 {
                self.part(x, y);
            }
        }
        coarse.east.draw(|x, y| coarse_east(self, x, y));
        coarse.south.draw(|x, y| coarse_south(self, x, y));
        coarse.holds.draw(|x, y| [coarse_hold(self, x, y), 0.0, 0.0, 0.0]);
        coarse.sum_up();
        coarse
    }

    /// Completes the numbers of the unknowns.
    fn sum_up(&mut self) {
        let mut holds = Texture::new(self.holds.width, self.holds.height);
        holds.draw(|x, y| self.summed(x, y));
        self.holds = holds;
    }

    fn summed(&self, x: i32, y: i32) -> Texel {
        let [hold, ..] = self.holds.load(x, y);
        let (mut sum, mut largest) = (0.0, 0.0_f32);
        self.for_each_link(x, y, |weight, _, _| {
            sum += weight;
            largest = largest.max(weight);
        });
        let diagonal = hold + sum;
        let damping = diagonal.max(4.0 * largest);
        [hold, diagonal, if damping > 0.0 { 1.0 / damping } else { 0.0 }, 0.0]
    }

    /// Visits the links of an unknown: weight, and the place of the other one.
    #[inline]
    pub(super) fn for_each_link(&self, x: i32, y: i32, mut visit: impl FnMut(f32, i32, i32)) {
        let slots = self.slots as i32;
        let slot = x % slots;
        let here = x - slot;
        let (to_east, to_south) = (self.east.load(x, y), self.south.load(x, y));
        for t in 0..slots {
            let (east, west, column) = (here + slots + t, here - slots + t, here + t);
            visit(to_east[t as usize], east, y);
            visit(to_south[t as usize], column, y + 1);
            visit(self.east.load(west, y)[slot as usize], west, y);
            visit(self.south.load(column, y - 1)[slot as usize], column, y - 1);
        }
    }

    /// The slot of the coarser cell that an unknown is a part of, counted from 1; 0 for none.
    #[inline]
    pub(super) fn parent(&self, x: i32, y: i32) -> usize {
        self.holds.load(x, y)[3] as usize
    }

    /// The places of the unknowns in a coarser cell.
    pub(super) fn members(&self, cell_x: i32, cell_y: i32) -> impl Iterator<Item = (i32, i32)> + use<> {
        let slots = self.slots as i32;
        (0..2).flat_map(move |dy| (0..2 * slots).map(move |i| (2 * slots * cell_x + i, 2 * cell_y + dy)))
    }

    /// The places of the unknowns that a coarser unknown is made of.
    pub(super) fn parts(&self, x: i32, y: i32) -> impl Iterator<Item = (i32, i32)> + use<'_> {
        let (cell, slot) = (x / SLOTS as i32, x as usize % SLOTS + 1);
        self.members(cell, y).filter(move |&(fx, fy)| self.parent(fx, fy) == slot)
    }

    /// Adds half the weights of links to a cell's unknowns, those that start at `x`, to the sums of their parents.
    fn add_halves(&self, sums: &mut Texel, weights: Texel, x: i32, y: i32) {
        for t in 0..self.slots {
            if let Some(sum) = self.parent(x + t as i32, y).checked_sub(1) {
                sums[sum] += 0.5 * weights[t];
            }
        }
    }

    /// Divides the unknowns of a coarser cell into parts and gives the first of these a slot each.
    fn part(&mut self, cell_x: i32, cell_y: i32) {
        let places: Vec<_> = self.members(cell_x, cell_y).collect();
        let mut labels: Vec<usize> = (0..places.len()).collect();
        for _ in 0..places.len() {
            for (i, &(x, y)) in places.iter().enumerate() {
                self.for_each_link(x, y, |weight, nx, ny| {
                    if let Some(j) = places.iter().position(|&p| p == (nx, ny))
                        && self.is_strong(weight, (x, y), (nx, ny))
                    {
                        let label = labels[i].min(labels[j]);
                        (labels[i], labels[j]) = (label, label);
                    }
                });
            }
        }
        let mut scores = vec![(0.0_f32, 0.0_f32); places.len()];
        for (i, &(x, y)) in places.iter().enumerate() {
            let score = &mut scores[labels[i]];
            score.1 += self.holds.load(x, y)[0];
            self.for_each_link(x, y, |weight, nx, ny| {
                if !places.contains(&(nx, ny)) {
                    score.0 += weight;
                }
            });
        }
        let scores: Vec<f32> =
            scores.iter().map(|&(links, hold)| if links > 0.0 { links * links / (links + hold) } else { 0.0 }).collect();
        let mut order: Vec<usize> = (0..places.len()).filter(|&i| scores[i] > 0.0).collect();
        order.sort_by(|&i, &j| scores[j].total_cmp(&scores[i]));
        for (i, &(x, y)) in places.iter().enumerate() {
            let slot = order.iter().take(SLOTS).position(|&label| label == labels[i]).map_or(0, |slot| slot + 1);
            if (x as usize) < self.holds.width && (y as usize) < self.holds.height {
                self.holds.texels[y as usize * self.holds.width + x as usize][3] = slot as f32;
            }
        }
    }

    fn is_strong(&self, weight: f32, a: (i32, i32), b: (i32, i32)) -> bool {
        weight > 0.0 && weight >= STRONG * self.strongest(a).min(self.strongest(b))
    }

    fn strongest(&self, (x, y): (i32, i32)) -> f32 {
        let mut largest = 0.0_f32;
        self.for_each_link(x, y, |weight, _, _| largest = largest.max(weight));
        largest
    }
}

/// The links of a coarser unknown to the east: half the sum of those that they are made of, for they lead twice as far.
fn coarse_east(fine: &Level, x: i32, y: i32) -> Texel {
    let slots = fine.slots as i32;
    let mut sums = [0.0; 4];
    for (fx, fy) in fine.parts(x, y).filter(|(fx, _)| fx / slots % 2 == 1) {
        let beside = fx - fx % slots + slots;
        fine.add_halves(&mut sums, fine.east.load(fx, fy), beside, fy);
    }
    sums
}

/// The same to the south.
fn coarse_south(fine: &Level, x: i32, y: i32) -> Texel {
    let slots = fine.slots as i32;
    let mut sums = [0.0; 4];
    for (fx, fy) in fine.parts(x, y).filter(|(_, fy)| fy % 2 == 1) {
        fine.add_halves(&mut sums, fine.south.load(fx, fy), fx - fx % slots, fy + 1);
    }
    sums
}

/// How strongly a coarser unknown is held: by all that holds its parts, each through the links of that part.
fn coarse_hold(fine: &Level, x: i32, y: i32) -> f32 {
    let mut sum = 0.0;
    fine.for_each_hold(x, y, |part, fx, fy| sum += part * fine.holds.load(fx, fy)[0]);
    sum
}

/// What is left of a hold that reaches on through the links of the unknown that it holds.
fn through(hold: f32, diagonal: f32) -> f32 {
    if diagonal > 0.0 { (diagonal - hold) / diagonal } else { 0.0 }
}

impl Level {
    /// Visits what holds a coarser unknown: the unknowns that are parts of it, and those beside them that are parts of
    /// none; with the part of their hold that reaches it.
    pub(super) fn for_each_hold(&self, x: i32, y: i32, mut visit: impl FnMut(f32, i32, i32)) {
        for (fx, fy) in self.parts(x, y) {
            let [hold, diagonal, ..] = self.holds.load(fx, fy);
            visit(through(hold, diagonal), fx, fy);
            self.for_each_link(fx, fy, |weight, nx, ny| {
                if weight > 0.0 && self.parent(nx, ny) == 0 {
                    visit(weight / self.holds.load(nx, ny)[1], nx, ny);
                }
            });
        }
    }
}
