//! The graphics card, for pictures of the grid solver.

use std::sync::{Arc, OnceLock};

use pollster::block_on;
use scumble_gpu::{Gpu, GpuError, GpuGridSolver, GridError, GridKernels};
use scumble_solve::grid::Constraints;

/// A device with the solver's kernels, and what it failed by.
pub(crate) struct Card {
    gpu: Gpu,
    kernels: GridKernels,
    failure: Arc<OnceLock<GpuError>>,
}

impl Card {
    /// # Errors
    /// When there is none.
    pub(crate) fn find() -> Result<Self, GpuError> {
        let failure = Arc::new(OnceLock::new());
        let noted = Arc::clone(&failure);
        let gpu = block_on(Gpu::headless(move |error| drop(noted.set(error))))?;
        let kernels = GridKernels::new(&gpu);
        Ok(Self { gpu, kernels, failure })
    }

    /// A solver with its first picture.
    ///
    /// # Errors
    /// When the card cannot draw so large a picture.
    pub(crate) fn solver(&self, constraints: &Constraints) -> Result<GpuGridSolver, GridError> {
        GpuGridSolver::new(&self.gpu, &self.kernels, constraints)
    }

    /// Steps until no step changes anything by more than `tolerance`, and tells how many it took.
    ///
    /// # Errors
    /// When the card has failed, as in all that follows.
    pub(crate) fn solve(&self, solver: &mut GpuGridSolver, tolerance: f32) -> Result<usize, GpuError> {
        let steps = block_on(solver.solve(tolerance))?;
        self.unless_failed(steps)
    }

    /// Blend-space colours times opacity, and opacity, row by row.
    pub(crate) fn pixels(&self, solver: &GpuGridSolver) -> Result<Vec<[f32; 4]>, GpuError> {
        let pixels = block_on(solver.pixels())?;
        self.unless_failed(pixels)
    }

    fn unless_failed<T>(&self, value: T) -> Result<T, GpuError> {
        self.failure.get().map_or(Ok(value), |error| Err(error.clone()))
    }
}
