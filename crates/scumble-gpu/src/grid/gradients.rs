//! One problem on its way to the solution: what conjugate gradients keep, and how a step is recorded.

use super::kernels::Kernel;
use super::levels::GpuLevels;
use super::reduction::Reduction;
use super::tape::Recorder;
use super::texels::{alike, single};
use crate::gpu::Gpu;

/// What steps read and draw. The residual is the right side of the finest level.
#[derive(Debug)]
pub(super) struct Gradients {
    levels: GpuLevels,
    reduction: Reduction,
    values: Pair,
    direction: Pair,
    residual_room: wgpu::TextureView,
    /// The matrix times the direction.
    image: wgpu::TextureView,
    scalars: Scalars,
}

/// Single texels.
#[derive(Debug)]
struct Scalars {
    /// How far the last step went along the direction, by channel.
    length: wgpu::TextureView,
    /// The direction times its image.
    curvature: wgpu::TextureView,
    /// A product that is used at once.
    product: wgpu::TextureView,
    /// How much of the last direction the next one takes away.
    part: wgpu::TextureView,
    largest: wgpu::TextureView,
    change: wgpu::TextureView,
}

/// What a pass reads, and room for what it makes of it.
#[derive(Debug)]
struct Pair {
    now: wgpu::TextureView,
    room: wgpu::TextureView,
}

impl Gradients {
    /// Records a first picture and what it lacks.
    pub(super) fn new(gpu: &Gpu, mut levels: GpuLevels, recorder: &mut Recorder<'_>) -> Self {
        levels.first_picture(recorder);
        let finest = &mut levels.levels[0];
        let like = |view: &wgpu::TextureView| alike(gpu, view);
        let residual = like(&finest.values);
        // Any direction will do whose image is that of what is kept of it.
        let [corrected, now, room] = [(); 3].map(|()| like(&finest.room));
        let values = std::mem::replace(&mut finest.values, corrected);
        recorder.pass_on(&finest.matrix, Kernel::Residual, &[&values, &finest.right], &residual);
        finest.right = residual;
        let scalars = Scalars::new(gpu);
        // There is no direction yet, whatever the textures hold.
        recorder.pass(Kernel::Ratio, &[&levels.zero, &levels.zero], &scalars.curvature);
        Self {
            residual_room: like(&values),
            direction: Pair { now, room },
            image: like(&values),
            reduction: Reduction::new(gpu, values.texture().width(), values.texture().height()),
            values: Pair { room: like(&values), now: values },
            scalars,
            levels,
        }
    }

    /// What it has come to.
    pub(super) fn values(&self) -> &wgpu::TextureView {
        &self.values.now
    }

    /// A single texel that [`Gradients::measure`] draws: by how much the last step changed each channel most.
    pub(super) fn change(&self) -> &wgpu::TextureView {
        &self.scalars.change
    }

    /// Records a step. After two of them, what is kept lies where it lay before.
    pub(super) fn step(&mut self, recorder: &mut Recorder<'_>) {
        self.levels.precondition(recorder);
        self.turn(recorder);
        self.advance(recorder);
    }

    /// The next direction.
    fn turn(&mut self, recorder: &mut Recorder<'_>) {
        let Scalars { curvature, product, part, .. } = &self.scalars;
        let (corrected, direction) = (&self.levels.levels[0].values, &mut self.direction);
        self.reduction.dot(recorder, [&self.image, corrected], product);
        recorder.pass(Kernel::Ratio, &[product, curvature], part);
        recorder.pass(Kernel::Retreat, &[corrected, &direction.now, part], &direction.room);
        direction.swap();
    }

    /// As far along the direction as is best.
    fn advance(&mut self, recorder: &mut Recorder<'_>) {
        let Scalars { length, curvature, product, .. } = &self.scalars;
        let finest = &mut self.levels.levels[0];
        let direction = &self.direction.now;
        recorder.pass_on(&finest.matrix, Kernel::Multiply, &[direction], &self.image);
        self.reduction.dot(recorder, [direction, &self.image], curvature);
        self.reduction.dot(recorder, [&finest.right, direction], product);
        recorder.pass(Kernel::Ratio, &[product, curvature], length);
        recorder.pass(Kernel::Advance, &[&self.values.now, direction, length], &self.values.room);
        self.values.swap();
        recorder.pass(Kernel::Retreat, &[&finest.right, &self.image, length], &self.residual_room);
        std::mem::swap(&mut finest.right, &mut self.residual_room);
    }

    /// Records how large the change of the last step was.
    pub(super) fn measure(&self, recorder: &mut Recorder<'_>) {
        let Scalars { length, largest, change, .. } = &self.scalars;
        self.reduction.largest(recorder, &self.direction.now, largest);
        recorder.pass(Kernel::Advance, &[&self.levels.zero, largest, length], change);
    }
}

impl Pair {
    fn swap(&mut self) {
        std::mem::swap(&mut self.now, &mut self.room);
    }
}

impl Scalars {
    fn new(gpu: &Gpu) -> Self {
        let [length, curvature, product, part, largest, change] = [(); 6].map(|()| single(gpu, 0.0));
        Self { length, curvature, product, part, largest, change }
    }
}
