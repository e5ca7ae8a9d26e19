//! One problem on its way to the solution, by steps of conjugate gradients.

use super::constraints::Constraints;
use super::hierarchy::Hierarchy;
use super::kernels;
use super::texture::{Texel, Texture, minus, plus};

/// The picture so far, and what the next step needs.
#[derive(Clone, Debug)]
pub(super) struct Gradients {
    hierarchy: Hierarchy,
    values: Texture,
    residual: Texture,
    direction: Texture,
    /// The matrix times the direction.
    image: Texture,
    /// How far the last step went along the direction, by channel.
    length: Texel,
    /// The direction times its image.
    curvature: Texel,
}

impl Gradients {
    /// With a first picture.
    pub(super) fn new(constraints: &Constraints) -> Self {
        let mut hierarchy = Hierarchy::new(constraints);
        let values = hierarchy.first_picture();
        let mut residual = Texture::new(values.width, values.height);
        residual.draw(|x, y| kernels::residual(&hierarchy.levels[0], &values, hierarchy.right(), x, y));
        let direction = Texture::new(values.width, values.height);
        Self {
            hierarchy,
            values,
            residual,
            image: direction.clone(),
            direction,
            length: [0.0; 4],
            curvature: [0.0; 4],
        }
    }

    /// By how much the last step changed the value that it changed most.
    pub(super) fn last_change(&self) -> f32 {
        let changes = self.direction.texels.iter().flat_map(|&direction| product(direction, self.length));
        changes.map(f32::abs).fold(0.0, f32::max)
    }

    /// One step of conjugate gradients.
    ///
    /// Both the direction and how far to go along it are taken as they are, not by the shorter formulas that follow where
    /// nothing is rounded: so no step makes it worse, also where the last one has left nothing but rounding errors.
    pub(super) fn step(&mut self) {
        let corrected = self.hierarchy.precondition(&self.residual);
        let part = ratio(dot(&self.image, corrected), self.curvature);
        for (direction, corrected) in self.direction.texels.iter_mut().zip(&corrected.texels) {
            *direction = minus(*corrected, product(*direction, part));
        }
        let (level, direction) = (&self.hierarchy.levels[0], &self.direction);
        self.image.draw(|x, y| kernels::multiply(level, direction, x, y));
        self.curvature = dot(&self.direction, &self.image);
        self.length = ratio(dot(&self.residual, &self.direction), self.curvature);
        for i in 0..self.image.texels.len() {
            self.values.texels[i] =
                plus(self.values.texels[i], product(self.direction.texels[i], self.length));
            self.residual.texels[i] =
                minus(self.residual.texels[i], product(self.image.texels[i], self.length));
        }
    }

    /// What it has come to.
    pub(super) fn values(&self) -> &Texture {
        &self.values
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
