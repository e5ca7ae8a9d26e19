//! From all texels to one, block by block.

use super::kernels::Kernel;
use super::tape::Recorder;
use super::texels::{FORMAT, target};
use crate::gpu::Gpu;

/// Columns and rows of a block, as the kernels have them.
const BLOCK: u32 = 8;

/// Room for what is more than one block, the largest first.
#[derive(Debug)]
pub(crate) struct Reduction(Vec<wgpu::TextureView>);

impl Reduction {
    /// Of textures of one size.
    pub(crate) fn new(gpu: &Gpu, width: u32, height: u32) -> Self {
        let smaller = |&[width, height]: &[u32; 2]| Some([width.div_ceil(BLOCK), height.div_ceil(BLOCK)]);
        let sizes = std::iter::successors(smaller(&[width, height]), smaller);
        let rooms = sizes.take_while(|size| *size != [1, 1]).map(|size| target(gpu, size, FORMAT));
        Self(rooms.collect())
    }

    /// Records a dot product, by channel, into a single texel.
    pub(crate) fn dot(
        &self,
        recorder: &mut Recorder<'_>,
        factors: [&wgpu::TextureView; 2],
        to: &wgpu::TextureView,
    ) {
        self.record(recorder, [Kernel::Dot, Kernel::Sum], &factors, to);
    }

    /// Records how the largest number, by channel and without its sign, gets into a single texel.
    pub(crate) fn largest(
        &self,
        recorder: &mut Recorder<'_>,
        of: &wgpu::TextureView,
        to: &wgpu::TextureView,
    ) {
        self.record(recorder, [Kernel::Largest; 2], &[of], to);
    }

    fn record(
        &self,
        recorder: &mut Recorder<'_>,
        [mut kernel, next]: [Kernel; 2],
        operands: &[&wgpu::TextureView],
        to: &wgpu::TextureView,
    ) {
        let mut operands = operands.to_vec();
        for room in &self.0 {
            recorder.pass(kernel, &operands, room);
            (kernel, operands) = (next, vec![room]);
        }
        recorder.pass(kernel, &operands, to);
    }
}
