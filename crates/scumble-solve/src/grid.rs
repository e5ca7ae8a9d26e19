//! The grid solver on the CPU: Laplace's equation on the pixels of a picture.
//!
//! Conjugate gradients, preconditioned by a multigrid cycle.

mod cut_links;
mod hierarchy;
mod kernels;
mod level;
mod parts;
mod texture;

pub use cut_links::{Cut, CutLinks, LEAST_FRACTION, Link};

use hierarchy::Hierarchy;
use texture::{Texel, Texture, minus, plus};

/// The unknowns of a picture.
#[derive(Clone, Debug)]
pub struct GridSolver {
    hierarchy: Hierarchy,
    values: Texture,
    residual: Texture,
    direction: Texture,
    image: Texture,
    length: Texel,
    /// What the last residual came to.
    power: Texel,
}

impl GridSolver {
    /// With a first picture.
    pub fn new(cuts: &CutLinks) -> Self {
        let mut hierarchy = Hierarchy::new(cuts);
        let values = hierarchy.first_picture();
        let mut residual = Texture::new(values.width, values.height);
        residual.draw(|x, y| kernels::residual(&hierarchy.levels[0], &values, hierarchy.right(), x, y));
        let direction = Texture::new(values.width, values.height);
        Self { hierarchy, values, residual, image: direction.clone(), direction, length: [0.0; 4], power: [0.0; 4] }
    }

    /// One step of conjugate gradients, by the formula of Polak and Ribière.
    pub fn step(&mut self) {
        let corrected = self.hierarchy.precondition(&self.residual);
        let turn = product(self.length, dot(&self.image, corrected));
        let part = ratio(turn, self.power).map(|c| -c);
        for (direction, corrected) in self.direction.texels.iter_mut().zip(&corrected.texels) {
            *direction = plus(*corrected, product(*direction, part));
        }
        self.power = dot(&self.residual, corrected);
        let (level, direction) = (&self.hierarchy.levels[0], &self.direction);
        self.image.draw(|x, y| kernels::multiply(level, direction, x, y));
        self.length = ratio(self.power, dot(&self.direction, &self.image));
        for i in 0..self.image.texels.len() {
            self.values.texels[i] = plus(self.values.texels[i], product(self.direction.texels[i], self.length));
            self.residual.texels[i] = minus(self.residual.texels[i], product(self.image.texels[i], self.length));
        }
    }

    /// Blend-space colours times opacity, and opacity, row by row.
    pub fn pixels(&self) -> &[[f32; 4]] {
        &self.values.texels
    }
}

fn product(a: Texel, b: Texel) -> Texel {
    [a[0] * b[0], a[1] * b[1], a[2] * b[2], a[3] * b[3]]
}

fn ratio(a: Texel, b: Texel) -> Texel {
    [0, 1, 2, 3].map(|c| if b[c] > 0.0 { a[c] / b[c] } else { 0.0 })
}

fn dot(a: &Texture, b: &Texture) -> Texel {
    let mut sum = [0.0_f64; 4];
    for (a, b) in a.texels.iter().zip(&b.texels) {
        (0..4).for_each(|c| sum[c] += f64::from(a[c] * b[c]));
    }
    sum.map(|c| c as f32)
}
