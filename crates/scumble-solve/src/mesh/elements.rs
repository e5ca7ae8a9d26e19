//! The elements of a region as they are in the mesh, and their system.

use scumble_core::Triangulation;

use super::SolveError;
use super::dofs::Dofs;
use super::element::{self, Matrix};
use super::system::System;

/// Elements, and their system once one is needed.
#[derive(Debug)]
pub(super) struct Elements {
    pub(super) dofs: Dofs,
    /// The last system, and which sides were coloured then.
    system: Option<(Vec<bool>, System)>,
}

impl Elements {
    pub(super) fn new(dofs: Dofs) -> Self {
        Self { dofs, system: None }
    }

    /// Sets the system up if the coloured sides are others than those of the last one.
    pub(super) fn analyse(&mut self, mesh: &Triangulation, is_colored: &[bool]) {
        if self.system.as_ref().is_none_or(|(sides, _)| sides != is_colored) {
            self.system = Some((is_colored.to_vec(), self.new_system(mesh, is_colored)));
        }
    }

    /// The system as of the last analysis.
    pub(super) fn system(&self) -> Option<&System> {
        self.system.as_ref().map(|(_, system)| system)
    }

    /// Factors the system if that is not done yet.
    pub(super) fn factor(&mut self, mesh: &Triangulation, memory: &mut Vec<f32>) -> Result<(), SolveError> {
        let Some((_, system)) = &mut self.system else { return Ok(()) };
        system.factor(&matrices(mesh, &self.dofs), memory)
    }

    fn new_system(&self, mesh: &Triangulation, is_colored: &[bool]) -> System {
        let mut fixed = vec![false; self.dofs.unknowns.count];
        for (side, _) in self.dofs.sides.iter().zip(is_colored).filter(|(_, is_colored)| **is_colored) {
            side.dofs.iter().for_each(|&dof| fixed[dof as usize] = true);
        }
        System::new(&self.dofs.unknowns, &matrices(mesh, &self.dofs), &fixed)
    }
}

/// What each element adds to the matrix.
fn matrices(mesh: &Triangulation, dofs: &Dofs) -> impl Fn(usize) -> Matrix {
    |i| element::stiffness(mesh.corners(dofs.triangles[i] as usize))
}
