//! The mesh solver: the colours of the sides of curves, spread by Laplace's equation into a picture.
//!
//! Quadratic finite elements on the refined triangulation (after S. Boyé, P. Barla, G. Guennebaud, *A vectorial
//! solver for free-form vector gradients*, 2012). There is one unknown for each sector of a node, one for each
//! edge inside a region and one for each side of a curve, so no colour leaks from one side to the other. Coloured
//! sides are fixed; the others, and the frame, are no-flux barriers. A region without a coloured side stays paper.
//!
//! Every region is a linear system of its own. Its geometry is looked at once, its matrix is factored when the set
//! of its coloured sides changes, and a change of colours costs two triangular solves. All arithmetic is scalar
//! and in a fixed order, so a picture is the same on every machine.

mod dofs;
mod element;
mod order;
mod region;
mod system;

use scumble_core::{Blend, SideColors, Triangulation};
use thiserror::Error;

use crate::field::Field;
use region::Region;

/// Why a drawing has no colour field.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum SolveError {
    /// The factor of a region does not fit into memory or into 32-bit indices.
    #[error(
        "a region of the drawing has too much detail to be coloured; simplify it or divide it with a line"
    )]
    TooLarge,
    /// A pivot was not positive: corners that are not finite.
    #[error("a region of the drawing could not be solved; please report this drawing")]
    NotPositive,
}

/// Spreads the colours of sides over a mesh, and remembers what it can for the next time.
///
/// The three stages can be called one by one, with the same colours, to time them; each does the earlier ones if
/// they are missing, and each looks only at the regions whose colours changed.
#[derive(Debug)]
pub struct MeshSolver {
    mesh: Triangulation,
    regions: Vec<Region>,
    field: Field,
}

impl MeshSolver {
    /// Numbers the unknowns of a mesh.
    pub fn new(mesh: Triangulation) -> Self {
        let regions = dofs::number(&mesh).into_iter().map(Region::new).collect();
        Self { mesh, regions, field: Field::default() }
    }

    /// Number of triangles of the mesh.
    pub fn triangle_count(&self) -> usize {
        self.mesh.triangle_count()
    }

    /// Number of unknowns of all regions, before colours fix some of them.
    pub fn unknown_count(&self) -> usize {
        self.regions.iter().map(Region::unknown_count).sum()
    }

    /// Sets up the systems of the regions whose set of coloured sides changed.
    ///
    /// Sides that `colors` is too short for have no colour.
    pub fn analyse(&mut self, colors: &SideColors) {
        for region in &mut self.regions {
            region.analyse(&self.mesh, colors);
        }
    }

    /// Factors the systems that are not factored yet.
    ///
    /// # Errors
    /// See [`SolveError`].
    pub fn factor(&mut self, colors: &SideColors) -> Result<(), SolveError> {
        self.analyse(colors);
        self.regions.iter_mut().try_for_each(Region::factor)
    }

    /// The colour field. `colors` are in the space `blend`; every value lies within the range of the colours that
    /// are given to its region, channel by channel, and is exact where that is a single colour.
    ///
    /// # Errors
    /// See [`SolveError`].
    pub fn solve(&mut self, colors: &SideColors, blend: Blend) -> Result<&Field, SolveError> {
        self.factor(colors)?;
        let mut changed = false;
        for region in &mut self.regions {
            changed |= region.solve();
        }
        if changed {
            self.field.triangles.clear();
            for region in &self.regions {
                region.emit(&self.mesh, &mut self.field.triangles);
            }
        }
        self.field.blend = blend;
        Ok(&self.field)
    }
}
