//! Levels from pixels to a single cell, and the ways through them: cycles, and the start from the coarsest.

use super::constraints::Constraints;
use super::kernels;
use super::level::Level;
use super::texture::Texture;

/// Steps before and after each coarser level: Chebyshev's for what the coarser one cannot see, the upper three quarters
/// of the spectrum of Jacobi's method.
pub const STEPS: [f32; 2] = [0.561_8, 1.389_2];

/// So many levels below its own a cycle goes on the way to a first picture: for what is seen on coarser ones those have had a cycle
/// of their own. To go on costs a seventh of all passes, and saves no step on any real drawing.
pub const FIRST_DEPTH: usize = 4;

/// Steps on the coarsest level: one all the way, and none.
pub const WHOLE_STEP: [f32; 2] = [1.0, 0.0];

/// Levels, the finest first, with what cycles write.
#[derive(Clone, Debug)]
pub struct Hierarchy {
    /// Down to a single cell.
    pub levels: Vec<Level>,
    /// By level: values, right side, and room for one more.
    values: Vec<Texture>,
    rights: Vec<Texture>,
    rooms: Vec<Texture>,
    /// What each unknown adds to the one of the next level that it is a part of.
    shares: Vec<Texture>,
    /// Given colours, by level.
    pub given: Vec<Texture>,
}

impl Hierarchy {
    /// For what is given.
    pub fn new(constraints: &Constraints) -> Self {
        let (finest, right) = Level::finest(constraints);
        let (mut levels, mut given) = (vec![finest], vec![right]);
        while let (Some(level), Some(right)) = (levels.last_mut(), given.last())
            && level.columns.max(level.rows) > 1
        {
            let coarse = level.coarser();
            let right = gathered(level, &coarse, right);
            given.push(right);
            levels.push(coarse);
        }
        let room: Vec<_> = given.iter().map(|t| Texture::new(t.width, t.height)).collect();
        Self { levels, values: room.clone(), rights: room.clone(), shares: room.clone(), rooms: room, given }
    }

    /// The right side of the finest level.
    pub(super) fn right(&self) -> &Texture {
        &self.given[0]
    }

    /// A first picture, from the coarsest level up, with one cycle at each.
    pub fn first_picture(&mut self) -> Texture {
        for depth in (1..self.levels.len()).rev() {
            self.rights[depth].clone_from(&self.given[depth]);
            self.spread(depth);
            self.cycle_from(depth, depth + FIRST_DEPTH);
        }
        self.spread(0);
        self.values[0].clone()
    }

    fn spread(&mut self, depth: usize) {
        let (fine, coarse) = self.values.split_at_mut(depth + 1);
        let none = Texture::default();
        let (level, given) = (&self.levels[depth], &self.given[depth]);
        let coarse = coarse.first().unwrap_or(&none);
        fine[depth].draw(|x, y| kernels::spread(level, given, coarse, x, y));
    }

    /// One symmetric cycle for a right side, from zero.
    pub fn precondition(&mut self, right: &Texture) -> &Texture {
        self.rights[0].texels.copy_from_slice(&right.texels);
        self.cycle_from_zero(0, self.levels.len());
        &self.values[0]
    }

    /// One symmetric cycle for the right side of a level, from zero, down to the level `last` or the coarsest.
    fn cycle_from_zero(&mut self, depth: usize, last: usize) {
        let (level, right) = (&self.levels[depth], &self.rights[depth]);
        let is_coarsest = depth + 1 == self.levels.len();
        let parts = if is_coarsest { WHOLE_STEP } else { STEPS };
        self.values[depth].draw(|x, y| kernels::start(level, right, parts, x, y));
        if is_coarsest || depth == last {
            return;
        }
        self.correct(depth, last);
        self.relax(depth, STEPS[1]);
        self.relax(depth, STEPS[0]);
    }

    fn cycle_from(&mut self, depth: usize, last: usize) {
        self.relax(depth, STEPS[0]);
        self.relax(depth, STEPS[1]);
        if depth + 1 < self.levels.len() {
            self.correct(depth, last);
        }
        self.relax(depth, STEPS[1]);
        self.relax(depth, STEPS[0]);
    }

    fn relax(&mut self, depth: usize, omega: f32) {
        let (level, values, right) = (&self.levels[depth], &self.values[depth], &self.rights[depth]);
        self.rooms[depth].draw(|x, y| kernels::relax(level, values, right, omega, x, y));
        std::mem::swap(&mut self.values[depth], &mut self.rooms[depth]);
    }

    /// Corrects the values of a level by those of the next.
    fn correct(&mut self, depth: usize, last: usize) {
        let (level, coarse) = (&self.levels[depth], &self.levels[depth + 1]);
        let (values, right) = (&self.values[depth], &self.rights[depth]);
        self.rooms[depth].draw(|x, y| kernels::residual(level, values, right, x, y));
        let (residual, shares) = (&self.rooms[depth], &mut self.shares[depth]);
        shares.draw(|x, y| kernels::restrict(level, residual, x, y));
        self.rights[depth + 1].draw(|x, y| kernels::collect(level, coarse, shares, x, y));
        self.cycle_from_zero(depth + 1, last);
        let (level, values, coarse) = (&self.levels[depth], &self.values[depth], &self.values[depth + 1]);
        self.rooms[depth].draw(|x, y| kernels::interpolate(level, values, coarse, x, y));
        std::mem::swap(&mut self.values[depth], &mut self.rooms[depth]);
    }
}

/// The given colours of a coarser level.
fn gathered(level: &Level, coarse: &Level, right: &Texture) -> Texture {
    let [mut shares, mut gathered] = [right, &coarse.holds].map(|t| Texture::new(t.width, t.height));
    shares.draw(|x, y| kernels::gather(level, right, x, y));
    gathered.draw(|x, y| kernels::collect(level, coarse, &shares, x, y));
    gathered
}
