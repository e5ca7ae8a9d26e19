//! The grid solver on the GPU: what [`scumble_solve::grid::GridSolver`] does on the CPU, in the same steps.
//!
//! | noun | file |
//! |---|---|
//! | a shader and what it reads | `kernels` |
//! | textures of numbers | `texels` |
//! | passes that are drawn over and over | `tape` |
//! | levels, and the ways through them | `levels` |
//! | sums over all texels | `reduction` |
//! | a problem, and steps to its solution | `gradients` |
//! | the picture and what lies over it | `stack` |
//! | the solution as a layer of a scene | `layer` |
//! | why it cannot be done | `error` |
//!
//! Every pass draws a texture of numbers from others with a fragment shader, so that WebGL2 can do it too. The matrices
//! of the levels come from the CPU.

mod error;
mod gradients;
pub(crate) mod kernels;
pub(crate) mod layer;
mod levels;
mod reduction;
mod stack;
mod tape;
mod texels;

#[cfg(test)]
mod tests;

use scumble_solve::grid::{Constraints, MAX_STEPS, Texel};

use crate::error::GpuError;
use crate::gpu::Gpu;
pub use error::GridError;
pub use kernels::Kernels;
use stack::{Stack, Step};
use tape::Recorder;

/// A picture on its way to the solution, on the GPU.
#[derive(Debug)]
pub struct GpuGridSolver {
    gpu: Gpu,
    /// Every step draws into the textures that the one before has read: what is done next, and what was done last.
    steps: [Step; 2],
    /// By how much the last step changed each channel most.
    change: wgpu::TextureView,
}

impl GpuGridSolver {
    /// With a first picture.
    ///
    /// # Errors
    /// When the device cannot draw so large a picture.
    pub fn new(gpu: &Gpu, kernels: &Kernels, constraints: &Constraints) -> Result<Self, GridError> {
        let mut recorder = Recorder::new(gpu, kernels);
        let mut stack = Stack::new(gpu, kernels, constraints, &mut recorder)?;
        recorder.take().play(gpu);
        let [first, second] = [(); 2].map(|()| stack.step(&mut recorder));
        Ok(Self { gpu: gpu.clone(), steps: [first, second], change: stack.change().clone() })
    }

    /// Steps until a step changes no channel by more than `tolerance`, or [`MAX_STEPS`] are done; and how many it took.
    ///
    /// # Errors
    /// When the device fails.
    pub async fn solve(&mut self, tolerance: f32) -> Result<usize, GpuError> {
        for steps in 1..=MAX_STEPS {
            self.step();
            if self.last_change().await? <= tolerance {
                return Ok(steps);
            }
        }
        Ok(MAX_STEPS)
    }

    /// One step of conjugate gradients.
    pub fn step(&mut self) {
        self.steps[0].tape.play(&self.gpu);
        self.steps.swap(0, 1);
    }

    /// By how much the last step changed the value that it changed most.
    ///
    /// # Errors
    /// When the device fails.
    pub async fn last_change(&self) -> Result<f32, GpuError> {
        self.steps[1].measure.play(&self.gpu);
        let changes = texels::read(&self.gpu, &self.change).await?;
        Ok(changes.into_iter().flatten().fold(0.0, |largest, change| largest.max(change.abs())))
    }

    /// What [`GpuGridSolver::pixels`] reads, on the GPU.
    pub(crate) fn values(&self) -> &wgpu::TextureView {
        &self.steps[1].seen
    }

    /// Blend-space colours times opacity, and opacity, row by row.
    ///
    /// # Errors
    /// When the device fails.
    pub async fn pixels(&self) -> Result<Vec<Texel>, GpuError> {
        texels::read(&self.gpu, self.values()).await
    }
}
