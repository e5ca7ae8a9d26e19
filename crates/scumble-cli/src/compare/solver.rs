//! The grid solver, wherever it computes.

use scumble_gpu::{GpuError, GpuGridSolver, GridError};
use scumble_solve::grid::{Constraints, GridSolver, TOLERANCE};

use crate::card::Card;

/// On the processor, or on the graphics card.
pub(super) enum Solver<'a> {
    Cpu(Box<GridSolver>),
    Gpu(Box<GpuGridSolver>, &'a Card),
}

impl<'a> Solver<'a> {
    /// # Errors
    /// When the card cannot draw so large a picture.
    pub(super) fn new(constraints: &Constraints, card: Option<&'a Card>) -> Result<Self, GridError> {
        Ok(match card {
            Some(card) => Self::Gpu(Box::new(card.solver(constraints)?), card),
            None => Self::Cpu(Box::new(GridSolver::new(constraints))),
        })
    }

    /// Steps until it changes next to nothing, and tells how many it took.
    ///
    /// # Errors
    /// When the card fails, as in all that follows.
    pub(super) fn solve(&mut self) -> Result<usize, GpuError> {
        match self {
            Self::Cpu(solver) => Ok(solver.solve(TOLERANCE)),
            Self::Gpu(solver, card) => card.solve(solver, TOLERANCE),
        }
    }

    pub(super) fn step(&mut self) {
        match self {
            Self::Cpu(solver) => solver.step(),
            Self::Gpu(solver, _) => solver.step(),
        }
    }

    pub(super) fn pixels(&self) -> Result<Vec<[f32; 4]>, GpuError> {
        match self {
            Self::Cpu(solver) => Ok(solver.pixels()),
            Self::Gpu(solver, card) => card.pixels(solver),
        }
    }
}
