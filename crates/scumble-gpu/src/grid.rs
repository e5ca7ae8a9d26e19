//! The grid solver on the GPU: what [`scumble_solve::grid::GridSolver`] does on the CPU, in the same steps.
//!
//! | noun | file |
//! |---|---|
//! | a shader and what it reads | `kernels` |
//! | textures of numbers | `texels` |
//! | the equations of pixels, what changes of them, and what is beyond the borders of a part | `equations`, `points` |
//! | passes that are made over and over, and how they are computed, many in one where they are small | `tape`, `computing` |
//! | levels, and the ways through them | `levels` |
//! | sums over all texels | `reduction` |
//! | a problem, and steps to its solution | `gradients` |
//! | the picture and what lies over it | `stack` |
//! | the solution as a layer of a scene | `layer` |
//! | what passes cost | `costs` |
//! | why it cannot be done | `error` |
//!
//! Every pass makes a texture of numbers from others. On WebGL2 it is drawn with a fragment shader; elsewhere the same kernel
//! is computed, where the device can: cards of computing centres draw far more slowly than they compute. Of a problem only the
//! equations of pixels at curves are uploaded, and later those that have changed: the matrices of the levels are made from them.

#[cfg(any(not(target_os = "unknown"), feature = "webgpu"))]
pub(crate) mod computing;
#[cfg(not(target_os = "unknown"))]
mod costs;
mod equations;
mod error;
mod gradients;
pub(crate) mod kernels;
pub(crate) mod layer;
mod levels;
mod points;
mod reduction;
mod stack;
mod tape;
pub(crate) mod texels;

#[cfg(test)]
mod tests;

use scumble_solve::grid::{Constraints, MAX_STEPS, Texel};

use crate::error::GpuError;
use crate::gpu::Gpu;
#[cfg(not(target_os = "unknown"))]
pub use costs::{Costs, SolverCosts};
pub use error::GridError;
pub use kernels::Kernels;
use stack::{Stack, Step};
use tape::{Recorder, Tape};

/// A picture on its way to the solution, on the GPU.
#[derive(Debug)]
pub struct GpuGridSolver {
    gpu: Gpu,
    stack: Stack,
    /// Builds the levels, which depend on no colours.
    build: Tape,
    is_built: bool,
    /// Makes the first picture.
    start: Tape,
    /// Every step writes the textures that the one before has read: what is done next, and what was done last.
    steps: [Step; 2],
    /// Whether the steps stand as they did at the start.
    is_even: bool,
    /// By how much the last step changed each channel most.
    change: wgpu::TextureView,
}

impl GpuGridSolver {
    /// With a first picture; what is a part of a larger one has none before that is known.
    ///
    /// # Errors
    /// When the device cannot draw so large a picture.
    pub fn new(gpu: &Gpu, kernels: &Kernels, constraints: &Constraints) -> Result<Self, GridError> {
        let mut solver = Self::record(gpu, kernels, constraints)?;
        #[cfg(not(target_os = "unknown"))]
        solver.fuse(kernels);
        if constraints.exits.is_empty() {
            solver.begin();
        }
        Ok(solver)
    }

    /// What a solver costs; it draws nothing for that.
    ///
    /// # Errors
    /// When the device cannot draw so large a picture.
    #[cfg(not(target_os = "unknown"))]
    pub fn costs(gpu: &Gpu, kernels: &Kernels, constraints: &Constraints) -> Result<SolverCosts, GridError> {
        let Self { build, start, steps, .. } = Self::record(gpu, kernels, constraints)?;
        Ok(SolverCosts::of([&build, &start], steps.each_ref().map(|step| &step.tape)))
    }

    fn record(gpu: &Gpu, kernels: &Kernels, constraints: &Constraints) -> Result<Self, GridError> {
        let mut recorder = Recorder::new(gpu, kernels);
        let (mut stack, [build, start]) = Stack::new(gpu, kernels, constraints, &mut recorder)?;
        let steps = [(); 2].map(|()| stack.step(&mut recorder));
        let change = stack.change().clone();
        Ok(Self { gpu: gpu.clone(), stack, build, is_built: false, start, steps, is_even: true, change })
    }

    /// Makes programs of passes over few texels, where that is faster.
    #[cfg(not(target_os = "unknown"))]
    fn fuse(&mut self, kernels: &Kernels) {
        let Self { gpu, build, start, steps: [even, odd], change, .. } = self;
        let mut tapes = [build, start, &mut even.tape, &mut even.measure, &mut odd.tape, &mut odd.measure];
        if let Some(programs) = &kernels.programs {
            computing::fuse(gpu, programs, &mut tapes, &even.under, change);
        }
        tapes.into_iter().for_each(|tape| tape.recipes.clear());
    }

    /// Takes other constraints, with a first picture as [`GpuGridSolver::new`] does. Where there are as many pixels and as many
    /// layers as before, only what has changed is uploaded, and where that is colours alone, no level is built; tells for how
    /// many pixels it was.
    ///
    /// # Errors
    /// When the device cannot draw so large a picture; then nothing has changed.
    pub fn update(&mut self, kernels: &Kernels, constraints: &Constraints) -> Result<usize, GridError> {
        let Some(changes) = self.stack.update(&self.gpu, kernels, constraints) else {
            *self = Self::new(&self.gpu, kernels, constraints)?;
            return Ok(constraints.width_px as usize * constraints.height_px as usize);
        };
        self.is_built &= !changes.weights;
        if constraints.exits.is_empty() {
            self.begin();
        }
        Ok(changes.pixels)
    }

    /// Begins, or begins anew, with what a grid of the whole, without shades, has beyond the borders of the part that this solves.
    pub(crate) fn begin_within(&mut self, kernels: &Kernels, whole: &wgpu::BindGroup) {
        self.stack.look_beyond(&self.gpu, kernels, whole);
        self.begin();
    }

    /// Makes the first picture. The last one would be no better start: from there it takes three steps to half a level where a
    /// curve was moved a little, and six where all colours are others; from here, which costs as much as one, it takes one.
    fn begin(&mut self) {
        if !std::mem::replace(&mut self.is_even, true) {
            self.steps.swap(0, 1);
        }
        if !std::mem::replace(&mut self.is_built, true) {
            self.build.play(&self.gpu);
        }
        self.start.play(&self.gpu);
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
        self.is_even = !self.is_even;
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

    /// The same without what shading scribbles lay over it.
    pub(crate) fn under(&self) -> &wgpu::TextureView {
        &self.steps[1].under
    }

    /// Blend-space colours times opacity, and opacity, row by row.
    ///
    /// # Errors
    /// When the device fails.
    pub async fn pixels(&self) -> Result<Vec<Texel>, GpuError> {
        texels::read(&self.gpu, self.values()).await
    }
}
