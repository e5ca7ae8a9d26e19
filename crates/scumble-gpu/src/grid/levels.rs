//! The levels of the grid solver on the GPU, and the passes of the ways through them: what `hierarchy` is on the CPU.

use scumble_solve::grid::{Hierarchy, Level, STEPS, Texture};

use super::kernels::{Kernel, Kernels};
use super::tape::Recorder;
use super::texels::{alike, single, uploaded, uploaded_first};
use crate::gpu::Gpu;

/// A level: its matrix, and what cycles write.
#[derive(Debug)]
pub(crate) struct GpuLevel {
    pub(crate) matrix: wgpu::BindGroup,
    pub(super) values: wgpu::TextureView,
    /// At first the given colours.
    pub(super) right: wgpu::TextureView,
    room: wgpu::TextureView,
}

/// Levels, the finest first.
#[derive(Debug)]
pub(crate) struct GpuLevels {
    pub(crate) levels: Vec<GpuLevel>,
    /// Parts of the way that steps go: the two of [`STEPS`].
    parts: [wgpu::TextureView; 2],
    one: wgpu::TextureView,
    pub(super) zero: wgpu::TextureView,
}

/// As `Level` in WGSL has it.
type LevelUniform = [i32; 4];

impl GpuLevel {
    fn new(gpu: &Gpu, kernels: &Kernels, level: &Level, given: &Texture, zero: &wgpu::TextureView) -> Self {
        let right = uploaded(gpu, given);
        Self {
            matrix: matrix(gpu, kernels, level, zero),
            values: alike(gpu, &right),
            room: alike(gpu, &right),
            right,
        }
    }
}

/// The matrix of a level. Pixels have but one link to each side, and none within.
pub(crate) fn matrix(
    gpu: &Gpu,
    kernels: &Kernels,
    level: &Level,
    zero: &wgpu::TextureView,
) -> wgpu::BindGroup {
    let is_finest = level.slots == 1;
    let links = if is_finest { uploaded_first } else { uploaded };
    let within = if is_finest { zero.clone() } else { uploaded(gpu, &level.within) };
    let textures = [links(gpu, &level.east), links(gpu, &level.south), within, uploaded(gpu, &level.holds)];
    let uniform = uniform(gpu, [level.columns as i32, level.slots as i32, 0, 0]);
    let texels = textures.iter().map(wgpu::BindingResource::TextureView);
    let resources = std::iter::once(uniform.as_entire_binding()).chain(texels);
    let entries: Vec<_> =
        (0..).zip(resources).map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource }).collect();
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("level"),
        layout: &kernels.level_layout,
        entries: &entries,
    })
}

fn uniform(gpu: &Gpu, level: LevelUniform) -> wgpu::Buffer {
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("level"),
        size: size_of::<LevelUniform>() as u64,
        usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.queue.write_buffer(&buffer, 0, bytemuck::cast_slice(&level));
    buffer
}

impl GpuLevels {
    pub(crate) fn new(gpu: &Gpu, kernels: &Kernels, hierarchy: &Hierarchy) -> Self {
        let zero = single(gpu, 0.0);
        let levels = hierarchy.levels.iter().zip(&hierarchy.given);
        Self {
            levels: levels.map(|(level, given)| GpuLevel::new(gpu, kernels, level, given, &zero)).collect(),
            parts: STEPS.map(|part| single(gpu, part)),
            one: single(gpu, 1.0),
            zero,
        }
    }

    /// Records the way to a first picture, from the coarsest level up, with one cycle at each.
    ///
    /// Right sides are overwritten, each when its given colours have been used.
    pub(crate) fn first_picture(&mut self, recorder: &mut Recorder<'_>) {
        for depth in (1..self.levels.len()).rev() {
            self.spread(recorder, depth);
            self.cycle_from(recorder, depth);
        }
        self.spread(recorder, 0);
    }

    fn spread(&self, recorder: &mut Recorder<'_>, depth: usize) {
        let coarse = self.levels.get(depth + 1).map_or(&self.zero, |coarse| &coarse.values);
        let GpuLevel { matrix, right, values, .. } = &self.levels[depth];
        recorder.pass_on(matrix, Kernel::Spread, &[right, coarse], values);
    }

    /// Records one symmetric cycle for the right side of a level, from zero.
    pub(crate) fn cycle_from_zero(&mut self, recorder: &mut Recorder<'_>, depth: usize) {
        if depth + 1 == self.levels.len() {
            return self.start(recorder, depth, &self.one);
        }
        self.start(recorder, depth, &self.parts[0]);
        self.relax(recorder, depth, 1);
        self.correct(recorder, depth);
        self.relax(recorder, depth, 1);
        self.relax(recorder, depth, 0);
    }

    fn start(&self, recorder: &mut Recorder<'_>, depth: usize, part: &wgpu::TextureView) {
        let GpuLevel { matrix, right, values, .. } = &self.levels[depth];
        recorder.pass_on(matrix, Kernel::Start, &[right, part], values);
    }

    fn cycle_from(&mut self, recorder: &mut Recorder<'_>, depth: usize) {
        self.relax(recorder, depth, 0);
        self.relax(recorder, depth, 1);
        if depth + 1 < self.levels.len() {
            self.correct(recorder, depth);
        }
        self.relax(recorder, depth, 1);
        self.relax(recorder, depth, 0);
    }

    fn relax(&mut self, recorder: &mut Recorder<'_>, depth: usize, step: usize) {
        let GpuLevel { matrix, right, values, room } = &mut self.levels[depth];
        recorder.pass_on(matrix, Kernel::Relax, &[values, right, &self.parts[step]], room);
        std::mem::swap(values, room);
    }

    /// Records how the values of a level are corrected by those of the next.
    fn correct(&mut self, recorder: &mut Recorder<'_>, depth: usize) {
        let GpuLevel { matrix, right, values, room } = &self.levels[depth];
        recorder.pass_on(matrix, Kernel::Residual, &[values, right], room);
        recorder.pass_on(matrix, Kernel::Restrict, &[room], &self.levels[depth + 1].right);
        self.cycle_from_zero(recorder, depth + 1);
        let (fine, coarse) = self.levels.split_at_mut(depth + 1);
        let GpuLevel { matrix, values, room, .. } = &mut fine[depth];
        recorder.pass_on(matrix, Kernel::Interpolate, &[values, &coarse[0].values], room);
        std::mem::swap(values, room);
    }
}
