//! The elements of a region as they are in the mesh, and their system.

use std::mem;

use scumble_core::Triangulation;

use super::SolveError;
use super::dofs::Dofs;
use super::element::{self, Matrix};
use super::singular::Powers;
use super::substitution::TileColumn;
use super::system::System;

/// Largest factor that is kept for undo, in columns of tiles: 16 MB.
const MOST_KEPT_COLUMNS: usize = 1 << 20;

/// Elements, and their system once one is needed.
#[derive(Debug)]
pub(super) struct Elements {
    pub(super) dofs: Dofs,
    analysis: Option<Analysis>,
    /// What there was before the first change of this step, or of the last one where this one has none.
    before: Option<Analysis>,
    /// Whether this step has changed it.
    is_changed: bool,
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
        Self { dofs, analysis: None, before: None, is_changed: false }
    }

    /// Keeps the system of the moment until the end of the step that begins.
    pub(super) fn begin_step(&mut self) {
        if !mem::take(&mut self.is_changed) {
            self.before = None;
        }
    }

    /// Has the system for some coloured sides, which is set up if it is neither the last one nor the one that is kept.
    pub(super) async fn analyse(&mut self, is_colored: &[bool]) {
        let is_other = |it: &Option<Analysis>| it.as_ref().is_none_or(|it| it.is_colored != is_colored);
        if !is_other(&self.analysis) {
            return;
        }
        let is_first = !mem::replace(&mut self.is_changed, true);
        if !is_other(&self.before) {
            mem::swap(&mut self.analysis, &mut self.before);
            return;
        }
        let is_small = |last: &mut Analysis| last.system.column_count() <= MOST_KEPT_COLUMNS;
        if is_first {
            self.before = self.analysis.take_if(is_small);
        }
        // What is not kept goes before more memory is asked for.
        self.analysis = None;
        self.analysis = Some(Analysis::new(&self.dofs, is_colored).await);
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
            Some(singular) => singular.stiffness(corners),
            None => element::stiffness(corners),
        }
    }
}
