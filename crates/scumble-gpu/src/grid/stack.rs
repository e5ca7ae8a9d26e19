//! The picture and the layers over it, problems of their own that are solved in the same steps.

use std::iter;

use scumble_solve::grid::{Constraints, Hierarchy};

use super::error::GridError;
use super::gradients::Gradients;
use super::kernels::{Kernel, Kernels};
use super::levels::GpuLevels;
use super::tape::{Recorder, Tape};
use super::texels::alike;
use crate::gpu::Gpu;

/// A step of all of them, and what comes of it.
#[derive(Debug)]
pub(super) struct Step {
    pub(super) tape: Tape,
    /// Finds out how large the changes were.
    pub(super) measure: Tape,
    pub(super) seen: wgpu::TextureView,
}

/// All that is solved for a picture.
#[derive(Debug)]
pub(super) struct Stack {
    picture: Gradients,
    /// What lies over it, as in [`Constraints::layers`].
    layers: Vec<Gradients>,
    /// The picture under its layers, if it has any.
    covered: Option<wgpu::TextureView>,
}

impl Stack {
    /// Records first pictures.
    pub(super) fn new(
        gpu: &Gpu,
        kernels: &Kernels,
        constraints: &Constraints,
        recorder: &mut Recorder<'_>,
    ) -> Result<Self, GridError> {
        let mut begin = |constraints: &Constraints| {
            let hierarchy = Hierarchy::new(constraints);
            check(gpu, &hierarchy)?;
            Ok::<_, GridError>(Gradients::new(gpu, GpuLevels::new(gpu, kernels, &hierarchy), recorder))
        };
        let picture = begin(constraints)?;
        let layers = constraints.layers.iter().map(begin).collect::<Result<Vec<_>, _>>()?;
        let covered = (!layers.is_empty()).then(|| alike(gpu, picture.values()));
        let stack = Self { picture, layers, covered };
        stack.cover(recorder);
        Ok(stack)
    }

    /// Single texels that [`Step::measure`] draws: by how much the last step changed each channel most.
    pub(super) fn changes(&self) -> Vec<wgpu::TextureView> {
        self.problems().map(|problem| problem.change().clone()).collect()
    }

    /// Records a step. After two of them, what is kept lies where it lay before.
    pub(super) fn step(&mut self, recorder: &mut Recorder<'_>) -> Step {
        self.picture.step(recorder);
        self.layers.iter_mut().for_each(|layer| layer.step(recorder));
        let seen = self.cover(recorder).clone();
        let tape = recorder.take();
        self.problems().for_each(|problem| problem.measure(recorder));
        Step { tape, measure: recorder.take(), seen }
    }

    fn problems(&self) -> impl Iterator<Item = &Gradients> {
        iter::once(&self.picture).chain(&self.layers)
    }

    /// Records what is seen.
    fn cover(&self, recorder: &mut Recorder<'_>) -> &wgpu::TextureView {
        let under = self.picture.values();
        let (Some(colors), Some(covers), Some(covered)) =
            (self.layers.first(), self.layers.last(), &self.covered)
        else {
            return under;
        };
        recorder.pass(Kernel::Cover, &[under, colors.values(), covers.values()], covered);
        covered
    }
}

/// Whether textures hold what the solver needs.
fn check(gpu: &Gpu, hierarchy: &Hierarchy) -> Result<(), GridError> {
    let longest = hierarchy.given.iter().map(|t| t.width.max(t.height)).max().unwrap_or(0);
    let most = gpu.device.limits().max_texture_dimension_2d;
    if longest > most as usize { Err(GridError::TooLarge { most_px: most }) } else { Ok(()) }
}
