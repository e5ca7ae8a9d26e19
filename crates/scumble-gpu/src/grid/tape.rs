//! Passes that are made ready once and drawn, or computed, over and over: all that a step of the solver does.

use super::kernels::{Kernel, Kernels, OPERANDS, Pipeline, bindings};
use super::levels::Matrix;
use crate::gpu::Gpu;

/// A kernel with what it reads and what it makes.
#[derive(Debug)]
pub(super) struct Pass {
    pub(super) pipeline: Pipeline,
    pub(super) operands: wgpu::BindGroup,
    pub(super) level: Option<wgpu::BindGroup>,
    pub(super) target: wgpu::TextureView,
}

/// Passes in their order.
#[derive(Debug, Default)]
pub(crate) struct Tape {
    pub(super) passes: Vec<Pass>,
    /// What they were recorded from, one by one; none any more once programs may have been made of them.
    #[cfg(not(target_os = "unknown"))]
    pub(super) recipes: Vec<Recipe>,
}

/// What a pass computes of what.
#[cfg(not(target_os = "unknown"))]
#[derive(Debug)]
pub(super) struct Recipe {
    pub(super) kernel: Kernel,
    pub(super) operands: Vec<wgpu::TextureView>,
    pub(super) matrix: Option<Matrix>,
    pub(super) target: wgpu::TextureView,
}

#[cfg(not(target_os = "unknown"))]
impl Recipe {
    /// The textures that it reads.
    pub(super) fn reads(&self) -> impl Iterator<Item = &wgpu::TextureView> {
        let Self { kernel, operands, matrix, .. } = self;
        let links = matrix.iter().filter(|_| kernel.reads_links()).flat_map(|matrix| &matrix.links);
        let holds = matrix.iter().filter(|_| kernel.reads_holds()).map(|matrix| &matrix.holds);
        operands.iter().chain(links).chain(holds)
    }

    /// The textures that it reads, and the one that it makes.
    pub(super) fn views(&self) -> impl Iterator<Item = &wgpu::TextureView> {
        self.reads().chain([&self.target])
    }
}

impl Tape {
    /// Has all passes made.
    pub(crate) fn play(&self, gpu: &Gpu) {
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        #[cfg(any(not(target_os = "unknown"), feature = "webgpu"))]
        super::computing::run(&self.passes, &mut encoder);
        self.passes.iter().for_each(|pass| pass.run(&mut encoder));
        gpu.queue.submit([encoder.finish()]);
    }
}

impl Pass {
    /// Draws it, unless it is computed.
    fn run(&self, encoder: &mut wgpu::CommandEncoder) {
        match &self.pipeline {
            Pipeline::Draws(pipeline) => self.draw(encoder, pipeline),
            #[cfg(any(not(target_os = "unknown"), feature = "webgpu"))]
            Pipeline::Computes(_) => {}
        }
    }

    fn draw(&self, encoder: &mut wgpu::CommandEncoder, pipeline: &wgpu::RenderPipeline) {
        let target = wgpu::RenderPassColorAttachment {
            view: &self.target,
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations {
                load: wgpu::LoadOp::Clear(wgpu::Color::TRANSPARENT),
                store: wgpu::StoreOp::Store,
            },
        };
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("kernel"),
            color_attachments: &[Some(target)],
            ..Default::default()
        });
        pass.set_pipeline(pipeline);
        pass.set_bind_group(0, &self.operands, &[]);
        if let Some(level) = &self.level {
            pass.set_bind_group(1, level, &[]);
        }
        pass.draw(0..3, 0..1);
    }
}

/// Makes passes ready.
#[derive(Debug)]
pub(crate) struct Recorder<'a> {
    gpu: &'a Gpu,
    kernels: &'a Kernels,
    tape: Tape,
}

impl<'a> Recorder<'a> {
    pub(crate) fn new(gpu: &'a Gpu, kernels: &'a Kernels) -> Self {
        Self { gpu, kernels, tape: Tape::default() }
    }

    /// What was recorded since this was last asked.
    pub(crate) fn take(&mut self) -> Tape {
        std::mem::take(&mut self.tape)
    }

    /// A pass of a kernel that reads no level.
    pub(super) fn pass(
        &mut self,
        kernel: Kernel,
        operands: &[&wgpu::TextureView],
        target: &wgpu::TextureView,
    ) {
        self.push(None, kernel, operands, target);
    }

    /// A pass of a kernel that reads a level.
    pub(crate) fn pass_on(
        &mut self,
        matrix: &Matrix,
        kernel: Kernel,
        operands: &[&wgpu::TextureView],
        target: &wgpu::TextureView,
    ) {
        self.push(Some(matrix), kernel, operands, target);
    }

    fn push(
        &mut self,
        matrix: Option<&Matrix>,
        kernel: Kernel,
        operands: &[&wgpu::TextureView],
        target: &wgpu::TextureView,
    ) {
        self.tape.passes.push(Pass {
            pipeline: self.kernels.pipeline(self.gpu, kernel, target.texture().format()).clone(),
            operands: self.operands(operands, target),
            level: matrix.map(|matrix| matrix.group.clone()),
            target: target.clone(),
        });
        #[cfg(not(target_os = "unknown"))]
        self.tape.recipes.push(Recipe {
            kernel,
            operands: operands.iter().copied().cloned().collect(),
            matrix: matrix.cloned(),
            target: target.clone(),
        });
    }

    /// The last operand stands also for those that a kernel does not read.
    fn operands(&self, operands: &[&wgpu::TextureView], target: &wgpu::TextureView) -> wgpu::BindGroup {
        let view = |i: usize| if i < OPERANDS { operands[i.min(operands.len() - 1)] } else { target };
        let entries: [_; OPERANDS + 1] = std::array::from_fn(|i| wgpu::BindGroupEntry {
            binding: i as u32,
            resource: wgpu::BindingResource::TextureView(view(i)),
        });
        self.gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("operands"),
            layout: self.kernels.operands_layout(target.texture().format()),
            entries: &entries[..bindings(self.gpu)],
        })
    }
}
