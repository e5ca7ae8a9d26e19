//! The levels of the grid solver on the GPU, and the passes of the ways through them: what `hierarchy` is on the CPU.

use scumble_solve::grid::{FIRST_DEPTH, STEPS, Size, WHOLE_STEP};

use super::equations::Equations;
use super::kernels::{Kernel, Kernels, bind_group};
use super::tape::Recorder;
use super::texels::{FORMAT, HALF_FORMAT, alike, single, single_texel, target};
use crate::gpu::Gpu;

/// The matrix of a level.
#[derive(Clone, Debug)]
pub(crate) struct Matrix {
    pub(super) group: wgpu::BindGroup,
    #[cfg(not(target_os = "unknown"))]
    pub(super) size: Size,
    pub(super) links: [wgpu::TextureView; 3],
    pub(super) holds: wgpu::TextureView,
}

/// A level: its matrix, and what cycles write.
#[derive(Debug)]
pub(crate) struct GpuLevel {
    pub(crate) matrix: Matrix,
    /// The matrix with the texture that is first in `values` in the place of its `holds`.
    draft: Matrix,
    pub(super) values: wgpu::TextureView,
    /// At first the given colours.
    pub(super) right: wgpu::TextureView,
    pub(super) room: wgpu::TextureView,
    /// What each unknown adds to the one of the next level that it is a part of; nothing on the coarsest.
    shares: wgpu::TextureView,
    /// What each unknown is a part of, by cells of the coarser level; nothing on the coarsest.
    pub(super) marks: wgpu::TextureView,
}

/// Levels, the finest first.
#[derive(Debug)]
pub(crate) struct GpuLevels {
    pub(crate) levels: Vec<GpuLevel>,
    /// How strongly pixels are held.
    hold: wgpu::TextureView,
    /// Parts of the way that steps go: the two of [`STEPS`].
    parts: [wgpu::TextureView; 2],
    /// Those that the first two steps go, in one texel: on most levels, and on the coarsest.
    first_parts: [wgpu::TextureView; 2],
    pub(super) zero: wgpu::TextureView,
    /// Where the cells are that `east`, `south` and `within` lead to, from their own.
    directions: [wgpu::TextureView; 3],
}

/// As `Level` in WGSL has it.
type LevelUniform = [i32; 4];

/// Levels of more unknowns, or room for them, are kept in halves: what moves them is slower than what computes them. Neither
/// cycles nor directions need be exact: values and residuals, in floats, go along the direction as it is kept.
const MOST_IN_FLOATS: usize = 1 << 16;

/// Makes levels.
struct Maker<'a> {
    gpu: &'a Gpu,
    kernels: &'a Kernels,
}

impl Maker<'_> {
    fn target(&self, columns: usize, rows: usize, format: wgpu::TextureFormat) -> wgpu::TextureView {
        target(self.gpu, [columns as u32, rows as u32], format)
    }

    /// Room for numbers of all unknowns of a level.
    fn room(&self, size: Size) -> wgpu::TextureView {
        let columns = size.columns * size.slots;
        let format = if columns * size.rows > MOST_IN_FLOATS { HALF_FORMAT } else { FORMAT };
        self.target(columns, size.rows, format)
    }

    /// The level of the pixels. They have but one link to each side, and none within. Its matrix, right side and first values
    /// are those that are solved, in floats.
    fn finest(&self, size: Size, equations: &Equations, zero: &wgpu::TextureView) -> GpuLevel {
        let links = [&equations.east, &equations.south, zero].map(Clone::clone);
        let [holds, values] = [(); 2].map(|()| alike(self.gpu, &equations.right));
        self.level(size, links, [holds, values, equations.right.clone()])
    }

    fn coarse(&self, size: Size) -> GpuLevel {
        self.level(size, [(); 3].map(|()| self.room(size)), [(); 3].map(|()| self.room(size)))
    }

    fn level(
        &self,
        size: Size,
        links: [wgpu::TextureView; 3],
        [holds, values, right]: [wgpu::TextureView; 3],
    ) -> GpuLevel {
        let [room, shares] = [(); 2].map(|()| self.room(size));
        let marks = self.target(size.columns.div_ceil(2), size.rows.div_ceil(2), FORMAT);
        let draft = self.matrix(size, links.clone(), values.clone());
        let matrix = self.matrix(size, links, holds);
        GpuLevel { matrix, draft, values, right, room, shares, marks }
    }

    fn matrix(&self, size: Size, links: [wgpu::TextureView; 3], holds: wgpu::TextureView) -> Matrix {
        let uniform = uniform(self.gpu, [size.columns as i32, size.slots as i32, 0, 0]);
        let texels = links.iter().chain([&holds]).map(wgpu::BindingResource::TextureView);
        let resources = std::iter::once(uniform.as_entire_binding()).chain(texels);
        let group = bind_group(&self.gpu.device, "level", &self.kernels.level_layout, resources);
        Matrix {
            group,
            #[cfg(not(target_os = "unknown"))]
            size,
            links,
            holds,
        }
    }
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

impl GpuLevel {
    /// Records what the unknowns of the next level get from those of this one: what a kernel has each add, added up.
    fn pass_down(
        &self,
        recorder: &mut Recorder<'_>,
        kernel: Kernel,
        operand: &wgpu::TextureView,
        to: &wgpu::TextureView,
    ) {
        let Self { matrix, shares, marks, .. } = self;
        recorder.pass_on(matrix, kernel, &[operand], shares);
        recorder.pass_on(matrix, Kernel::Collect, &[shares, marks], to);
    }
}

impl GpuLevels {
    /// Room for levels of these sizes.
    pub(crate) fn new(gpu: &Gpu, kernels: &Kernels, equations: &Equations, sizes: &[Size]) -> Self {
        let (zero, maker) = (single(gpu, 0.0), Maker { gpu, kernels });
        let level = |(depth, size): (usize, &Size)| match depth {
            0 => maker.finest(*size, equations, &zero),
            _ => maker.coarse(*size),
        };
        Self {
            levels: sizes.iter().enumerate().map(level).collect(),
            hold: equations.hold.clone(),
            parts: STEPS.map(|part| single(gpu, part)),
            first_parts: [STEPS, WHOLE_STEP].map(|[x, y]| single_texel(gpu, [x, y, 0.0, 0.0])),
            directions: [[1.0, 0.0], [0.0, 1.0], [0.0, 0.0]]
                .map(|[x, y]| single_texel(gpu, [x, y, 0.0, 0.0])),
            zero,
        }
    }

    /// Records how the matrices of all levels come from the equations of pixels.
    ///
    /// Values, rooms and shares are overwritten.
    pub(crate) fn build(&self, recorder: &mut Recorder<'_>) {
        for depth in 0..self.levels.len() {
            self.complete(recorder, depth);
            if depth + 1 < self.levels.len() {
                self.build_coarser(recorder, depth);
            }
        }
    }

    /// The numbers of the unknowns of a level whose links are there.
    fn complete(&self, recorder: &mut Recorder<'_>, depth: usize) {
        let GpuLevel { matrix, draft, values, room, marks, .. } = &self.levels[depth];
        let holds = &matrix.holds;
        let hold = if depth == 0 { &self.hold } else { room };
        if depth + 1 == self.levels.len() {
            return recorder.pass_on(draft, Kernel::Diagonal, &[hold], holds);
        }
        recorder.pass_on(matrix, Kernel::Diagonal, &[hold], values);
        recorder.pass_on(draft, Kernel::Mark, &[hold], marks);
        recorder.pass_on(draft, Kernel::Attach, &[values, marks], holds);
    }

    /// The links of the next level, and how strongly it is held.
    fn build_coarser(&self, recorder: &mut Recorder<'_>, depth: usize) {
        let [fine, coarse] = [depth, depth + 1].map(|depth| &self.levels[depth]);
        for (direction, links) in self.directions.iter().zip(&coarse.matrix.links) {
            fine.pass_down(recorder, Kernel::Join, direction, links);
        }
        fine.pass_down(recorder, Kernel::Gather, &fine.matrix.holds, &coarse.room);
    }

    /// Records how the given colours of all levels come from those of pixels.
    pub(crate) fn gather(&self, recorder: &mut Recorder<'_>) {
        for pair in self.levels.windows(2) {
            pair[0].pass_down(recorder, Kernel::Gather, &pair[0].right, &pair[1].right);
        }
    }

    /// Records the way to a first picture, from the coarsest level up, with one cycle at each.
    ///
    /// Right sides are overwritten, each when its given colours have been used.
    pub(crate) fn first_picture(&mut self, recorder: &mut Recorder<'_>) {
        self.gather(recorder);
        for depth in (1..self.levels.len()).rev() {
            self.spread(recorder, depth);
            self.cycle_from(recorder, depth, depth + FIRST_DEPTH);
        }
        self.spread(recorder, 0);
    }

    fn spread(&self, recorder: &mut Recorder<'_>, depth: usize) {
        let coarse = self.levels.get(depth + 1).map_or(&self.zero, |coarse| &coarse.values);
        let GpuLevel { matrix, right, values, .. } = &self.levels[depth];
        recorder.pass_on(matrix, Kernel::Spread, &[right, coarse], values);
    }

    /// Records one symmetric cycle for the right side of the finest level, from zero.
    pub(crate) fn precondition(&mut self, recorder: &mut Recorder<'_>) {
        self.cycle_from_zero(recorder, 0, self.levels.len());
    }

    /// Records one symmetric cycle for the right side of a level, from zero, down to the level `last` or the coarsest.
    fn cycle_from_zero(&mut self, recorder: &mut Recorder<'_>, depth: usize, last: usize) {
        let is_coarsest = depth + 1 == self.levels.len();
        self.start(recorder, depth, &self.first_parts[usize::from(is_coarsest)]);
        if is_coarsest || depth == last {
            return;
        }
        self.correct(recorder, depth, last);
        self.relax(recorder, depth, 1);
        self.relax(recorder, depth, 0);
    }

    fn start(&self, recorder: &mut Recorder<'_>, depth: usize, parts: &wgpu::TextureView) {
        let GpuLevel { matrix, right, values, .. } = &self.levels[depth];
        recorder.pass_on(matrix, Kernel::Start, &[right, parts], values);
    }

    fn cycle_from(&mut self, recorder: &mut Recorder<'_>, depth: usize, last: usize) {
        self.relax(recorder, depth, 0);
        self.relax(recorder, depth, 1);
        if depth + 1 < self.levels.len() {
            self.correct(recorder, depth, last);
        }
        self.relax(recorder, depth, 1);
        self.relax(recorder, depth, 0);
    }

    fn relax(&mut self, recorder: &mut Recorder<'_>, depth: usize, step: usize) {
        let GpuLevel { matrix, right, values, room, .. } = &mut self.levels[depth];
        recorder.pass_on(matrix, Kernel::Relax, &[values, right, &self.parts[step]], room);
        std::mem::swap(values, room);
    }

    /// Records how the values of a level are corrected by those of the next.
    fn correct(&mut self, recorder: &mut Recorder<'_>, depth: usize, last: usize) {
        let level @ GpuLevel { matrix, right, values, room, .. } = &self.levels[depth];
        recorder.pass_on(matrix, Kernel::Residual, &[values, right], room);
        level.pass_down(recorder, Kernel::Restrict, room, &self.levels[depth + 1].right);
        self.cycle_from_zero(recorder, depth + 1, last);
        let (fine, coarse) = self.levels.split_at_mut(depth + 1);
        let GpuLevel { matrix, values, room, .. } = &mut fine[depth];
        recorder.pass_on(matrix, Kernel::Interpolate, &[values, &coarse[0].values], room);
        std::mem::swap(values, room);
    }
}
