//! The picture and what lies over it.

use scumble_solve::grid::{Constraints, Covers, Hierarchy};

use super::error::GridError;
use super::gradients::Gradients;
use super::kernels::{Kernel, Kernels};
use super::levels::GpuLevels;
use super::tape::{Recorder, Tape};
use super::texels::{alike, uploaded};
use crate::gpu::Gpu;

/// A step, and what comes of it.
#[derive(Debug)]
pub(super) struct Step {
    pub(super) tape: Tape,
    /// Finds out how large the change was.
    pub(super) measure: Tape,
    pub(super) seen: wgpu::TextureView,
}

/// A picture that is solved, and its layer.
#[derive(Debug)]
pub(super) struct Stack {
    picture: Gradients,
    layer: Option<Layer>,
}

/// What lies over a picture, and the picture under it.
#[derive(Debug)]
struct Layer {
    colors: wgpu::TextureView,
    parts: wgpu::TextureView,
    covered: wgpu::TextureView,
}

impl Layer {
    fn new(gpu: &Gpu, covers: &Covers) -> Self {
        let colors = uploaded(gpu, &covers.colors);
        let parts = covers.parts.as_ref().map_or_else(|| colors.clone(), |parts| uploaded(gpu, parts));
        Self { covered: alike(gpu, &colors), colors, parts }
    }
}

impl Stack {
    /// Records a first picture.
    pub(super) fn new(
        gpu: &Gpu,
        kernels: &Kernels,
        constraints: &Constraints,
        recorder: &mut Recorder<'_>,
    ) -> Result<Self, GridError> {
        let hierarchy = Hierarchy::new(constraints);
        check(gpu, &hierarchy)?;
        let picture = Gradients::new(gpu, GpuLevels::new(gpu, kernels, &hierarchy), recorder);
        let stack =
            Self { picture, layer: constraints.covers.as_ref().map(|covers| Layer::new(gpu, covers)) };
        stack.cover(recorder);
        Ok(stack)
    }

    /// A single texel that [`Step::measure`] draws: by how much the last step changed each channel most.
    pub(super) fn change(&self) -> &wgpu::TextureView {
        self.picture.change()
    }

    /// Records a step. After two of them, what is kept lies where it lay before.
    pub(super) fn step(&mut self, recorder: &mut Recorder<'_>) -> Step {
        self.picture.step(recorder);
        let seen = self.cover(recorder).clone();
        let tape = recorder.take();
        self.picture.measure(recorder);
        Step { tape, measure: recorder.take(), seen }
    }

    /// Records what is seen.
    fn cover(&self, recorder: &mut Recorder<'_>) -> &wgpu::TextureView {
        let under = self.picture.values();
        let Some(Layer { colors, parts, covered }) = &self.layer else { return under };
        recorder.pass(Kernel::Cover, &[under, colors, parts], covered);
        covered
    }
}

/// Whether textures hold what the solver needs.
fn check(gpu: &Gpu, hierarchy: &Hierarchy) -> Result<(), GridError> {
    let longest = hierarchy.given.iter().map(|t| t.width.max(t.height)).max().unwrap_or(0);
    let most = gpu.device.limits().max_texture_dimension_2d;
    if longest > most as usize { Err(GridError::TooLarge { most_px: most }) } else { Ok(()) }
}
