//! The elements of a region as they are in the mesh, and their system.

use std::mem;

use scumble_core::Triangulation;

use super::SolveError;
use super::dofs::Dofs;
use super::element::{self, Matrix};
use super::singular::{self, Powers};
use super::substitution::TileColumn;
use super::system::System;

/// Elements, and their system once one is needed.
#[derive(Debug)]
pub(super) struct Elements {
    pub(super) dofs: Dofs,
    analysis: Option<Analysis>,
    /// The one before, which undo comes back to.
    before: Option<Analysis>,
}

/// What there is for one set of coloured sides.
#[derive(Debug)]
struct Analysis {
    is_colored: Vec<bool>,
    powers: Powers,
    system: System,
}

impl Elements {
    pub(super) fn new(dofs: Dofs) -> Self {
        Self { dofs, analysis: None, before: None }
    }

    /// Has the system for some coloured sides, which is set up if it is neither the last one nor the one before; says whether
    /// it is not the last one.
    pub(super) async fn analyse(&mut self, is_colored: &[bool]) -> bool {
        if self.is_for(is_colored) {
            return false;
        }
        mem::swap(&mut self.analysis, &mut self.before);
        if !self.is_for(is_colored) {
            self.analysis = Some(Analysis::new(&self.dofs, is_colored).await);
        }
        true
    }

    fn is_for(&self, is_colored: &[bool]) -> bool {
        self.analysis.as_ref().is_some_and(|analysis| analysis.is_colored == is_colored)
    }

    /// Forgets the system before.
    pub(super) fn forget_before(&mut self) {
        self.before = None;
    }

    /// The system as of the last analysis.
    pub(super) fn system(&self) -> Option<&System> {
        self.analysis.as_ref().map(|analysis| &analysis.system)
    }

    /// Factors the system if that is not done yet.
    pub(super) async fn factor(
        &mut self,
        mesh: &Triangulation,
        memory: &mut Vec<TileColumn>,
    ) -> Result<(), SolveError> {
        let Some(Analysis { powers, system, .. }) = &mut self.analysis else { return Ok(()) };
        system.factor(&matrices(mesh, &self.dofs, powers), memory).await
    }
}

impl Analysis {
    async fn new(dofs: &Dofs, is_colored: &[bool]) -> Self {
        let mut fixed = vec![false; dofs.unknowns.count];
        for (side, _) in dofs.sides.iter().zip(is_colored).filter(|(_, is_colored)| **is_colored) {
            side.dofs.iter().for_each(|&dof| fixed[dof as usize] = true);
        }
        let powers = Powers::new(dofs, is_colored);
        let system = System::new(&dofs.unknowns, &fixed).await;
        Self { is_colored: is_colored.to_vec(), powers, system }
    }
}

/// What each element adds to the matrix.
fn matrices(mesh: &Triangulation, dofs: &Dofs, powers: &Powers) -> impl Fn(usize) -> Matrix {
    |i| {
        let corners = mesh.corners(dofs.triangles[i] as usize);
        match powers.of(&dofs.unknowns.of_element[i]) {
            Some((k, power)) => singular::stiffness(corners, k, power),
            None => element::stiffness(corners),
        }
    }
}
