//! The grid solver on the CPU: Laplace's equation on the pixels of a picture.
//!
//! | noun | file |
//! |---|---|
//! | all that is given | `constraints` |
//! | how the pieces of a map run, its closed gaps, and where a picture may jump | `straights` |
//! | where curves cut the links between pixels | `cut_links`, `wall` |
//! | corners where the solution is steep without end | `corners` |
//! | what that makes of the equations of pixels | `equations` |
//! | the layer that shading scribbles lay over pixels | `covers` |
//! | the regions of a map among pixels | `regions` |
//! | pixels that their colour cannot reach | `unreached` |
//! | numbers in rows and columns, as the GPU has them | `texture` |
//! | a grid and how its unknowns hang together | `level`, `parts` |
//! | what is computed from texel to texel | `kernels` |
//! | grids from pixels to a single cell, and cycles through them | `hierarchy` |
//! | a problem, and steps to its solution | `gradients` |
//! | another solver, to compare with | `jeschke` |
//! | what a painter needs of a solved grid | `picture`, `curve_cells` |
//! | which pixels are seen past curves | `sight` |
//! | a picture to be solved | `problem` |
//! | what is beyond the borders of a part | `whole` |
//!
//! Conjugate gradients, preconditioned by a symmetric multigrid cycle; after O. Tatebe, *The multigrid preconditioned
//! conjugate gradient method* (1993). Interpolation is that of smoothed aggregation (P. Vaněk, J. Mandel, M. Brezina,
//! 1996), which for whole cells is that of D. Y. Kwak, *V-cycle multigrid for cell-centered finite differences* (1999);
//! the matrices of the coarser grids are not those of Galerkin but have the same five points as the finest, one for each
//! part of a cell.
//! Everything is computed texel by texel in `f32`, as it is on the GPU.

mod constraints;
mod corners;
mod covers;
mod curve_cells;
mod cut_links;
mod equations;
mod gradients;
mod hierarchy;
mod jeschke;
pub mod kernels;
mod level;
mod parts;
mod picture;
mod problem;
mod regions;
mod sight;
mod straights;
mod texture;
mod unreached;
mod wall;
mod whole;

pub use constraints::{Constraints, Exits, Pull, Source};
pub use covers::{Covers, Shades};
pub use curve_cells::CurveCells;
pub use cut_links::{Cut, Face, LEAST_FRACTION, Link};
pub use equations::Equation;
pub use hierarchy::{FIRST_DEPTH, Hierarchy, STEPS, WHOLE_STEP};
pub use jeschke::JeschkeSolver;
pub use level::{Level, Size};
pub use picture::GridPicture;
pub use problem::GridProblem;
pub use texture::{Texel, Texture};
pub use whole::{AROUND_PX, Whole};

use gradients::Gradients;
pub(crate) use sight::Sight;

/// A step that changes no value by more than this may be the last: a twentieth of a level of 255.
pub const TOLERANCE: f32 = 0.05 / 255.0;

/// Steps after which a picture is taken as it is. Real drawings need up to 6; where half of the sides have no colour,
/// up to 9.
pub const MAX_STEPS: usize = 24;

/// Steps where nobody looks at how far they have come, because that would take waiting for a GPU.
pub const PAGE_STEPS: usize = 9;

/// Those of them that the page makes in a frame. The first ones leave real drawings with all their colours within half a level of
/// the solution, and within seven where half of the sides have none; three more leave a tenth of that.
pub const FRAME_STEPS: usize = 3;

/// A picture on its way to the solution.
#[derive(Clone, Debug)]
pub struct GridSolver {
    picture: Gradients,
    covers: Option<Covers>,
}

impl GridSolver {
    /// With a first picture.
    pub fn new(constraints: &Constraints) -> Self {
        Self { picture: Gradients::new(constraints), covers: constraints.covers.clone() }
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
        self.picture.last_change()
    }

    /// One step of conjugate gradients.
    pub fn step(&mut self) {
        self.picture.step();
    }

    /// Blend-space colours times opacity, and opacity, row by row.
    pub fn pixels(&self) -> Vec<Texel> {
        let under = self.picture.values();
        let Some(covers) = &self.covers else { return under.texels.clone() };
        let mut pixels = Texture::new(under.width, under.height);
        pixels.draw(|x, y| kernels::cover(under, &covers.colors, covers.parts(), x, y));
        pixels.texels
    }
}
