//! The grid solver on the CPU: Laplace's equation on the pixels of a picture.
//!
//! | noun | file |
//! |---|---|
//! | all that is given | `constraints` |
//! | where curves cut the links between pixels | `cut_links`, `wall` |
//! | what shading scribbles do to pixels | `pulls`, `regions` |
//! | pixels that their colour cannot reach | `unreached` |
//! | numbers in rows and columns, as the GPU has them | `texture` |
//! | a grid and how its unknowns hang together | `level`, `parts` |
//! | what is computed from texel to texel | `kernels` |
//! | grids from pixels to a single cell, and cycles through them | `hierarchy` |
//! | another solver, to compare with | `jeschke` |
//! | what a painter needs of a solved grid | `picture`, `curve_cells` |
//! | a picture to be solved | `problem` |
//!
//! Conjugate gradients, preconditioned by a symmetric multigrid cycle; after O. Tatebe, *The multigrid preconditioned
//! conjugate gradient method* (1993). Interpolation is that of smoothed aggregation (P. Vaněk, J. Mandel, M. Brezina,
//! 1996), which for whole cells is that of D. Y. Kwak, *V-cycle multigrid for cell-centered finite differences* (1999); the matrices of the
//! coarser grids are not those of Galerkin but have the same five points as the finest, one for each part of a cell.
//! Everything is computed texel by texel in `f32`, as it is on the GPU.

mod constraints;
mod curve_cells;
mod cut_links;
mod hierarchy;
mod jeschke;
pub mod kernels;
mod level;
mod parts;
mod picture;
mod problem;
mod pulls;
mod regions;
mod texture;
mod unreached;
mod wall;

pub use constraints::Constraints;
pub use curve_cells::CurveCells;
pub use cut_links::{Cut, Face, LEAST_FRACTION, Link};
pub use hierarchy::{Hierarchy, STEPS};
pub use jeschke::JeschkeSolver;
pub use level::Level;
pub use picture::GridPicture;
pub use problem::GridProblem;
pub use pulls::Pull;
pub use texture::{Texel, Texture};

use texture::{minus, plus};

/// A step that changes no value by more than this may be the last: a twentieth of a level of 255.
pub const TOLERANCE: f32 = 0.05 / 255.0;

/// Steps after which a picture is taken as it is. Real drawings need up to 6; where half of the sides have no colour,
/// up to 9.
pub const MAX_STEPS: usize = 24;

/// Steps where nobody looks at how far they have come, because that would take waiting for a GPU.
pub const PAGE_STEPS: usize = 10;

/// A picture on its way to the solution.
#[derive(Clone, Debug)]
pub struct GridSolver {
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

impl GridSolver {
    /// With a first picture.
    pub fn new(constraints: &Constraints) -> Self {
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

    /// Steps until a step changes no channel by more than `tolerance`, or [`MAX_STEPS`] are done; and how many it took.
    pub fn solve(&mut self, tolerance: f32) -> usize {
        for steps in 1..=MAX_STEPS {
            self.step();
            if self.last_change() <= tolerance {
                return steps;
            }
        }
        MAX_STEPS
    }

    /// By how much the last step changed the value that it changed most.
    pub fn last_change(&self) -> f32 {
        let changes = self.direction.texels.iter().flat_map(|&direction| product(direction, self.length));
        changes.map(f32::abs).fold(0.0, f32::max)
    }

    /// One step of conjugate gradients.
    ///
    /// Both the direction and how far to go along it are taken as they are, not by the shorter formulas that follow where
    /// nothing is rounded: so no step makes it worse, also where the last one has left nothing but rounding errors.
    pub fn step(&mut self) {
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
