//! A solved grid as a layer of a scene: its colours, and what cuts it.

use bytemuck::{Pod, Zeroable};
use kurbo::Affine;
use scumble_solve::grid::{CurveCells, GridProblem, Texture};

use super::kernels::{TEXELS, UNIFORM, bind_group, bind_group_layout, entry};
use super::texels::{uploaded, uploaded_pairs};
use crate::gpu::Gpu;

/// Pieces of curves in a row of their texture.
const ROW: usize = 1024;

/// What is drawn of a grid.
#[derive(Debug)]
pub(crate) struct GridLayer {
    pub(crate) px_from_du: Affine,
    uniform: wgpu::Buffer,
    cells: wgpu::TextureView,
    pieces: wgpu::TextureView,
    /// Once there are colours.
    pub(crate) group: Option<wgpu::BindGroup>,
}

/// From pixels of a target to those of the grid, as the shader reads it.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct GridUniform {
    linear: [f32; 4],
    shift: [f32; 4],
}

/// How the shader is given a grid.
pub(crate) fn layout(device: &wgpu::Device) -> wgpu::BindGroupLayout {
    let entries = [entry(0, UNIFORM), entry(1, TEXELS), entry(2, TEXELS), entry(3, TEXELS)];
    bind_group_layout(device, "solution", &entries)
}

impl GridLayer {
    /// Without colours.
    pub(crate) fn new(gpu: &Gpu, problem: &GridProblem) -> Self {
        let uniform = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("solution"),
            size: size_of::<GridUniform>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let CurveCells { columns, rows, cells, pieces } = &problem.curves;
        Self {
            px_from_du: problem.view.px_from_du,
            uniform,
            cells: uploaded_pairs(gpu, [*columns, *rows], cells),
            pieces: uploaded(gpu, &in_rows(pieces)),
            group: None,
        }
    }

    /// Colours to draw, with what a shader needs to look them up.
    pub(crate) fn with_values(
        &self,
        gpu: &Gpu,
        layout: &wgpu::BindGroupLayout,
        values: &wgpu::TextureView,
    ) -> wgpu::BindGroup {
        let textures = [values, &self.cells, &self.pieces].map(wgpu::BindingResource::TextureView);
        let resources = std::iter::once(self.uniform.as_entire_binding()).chain(textures);
        bind_group(&gpu.device, "solution", layout, resources)
    }

    /// What will be drawn next is seen in pixels that du are taken to.
    pub(crate) fn look(&self, queue: &wgpu::Queue, px_from_du: Affine) {
        let [a, b, c, d, e, f] = (self.px_from_du * px_from_du.inverse()).as_coeffs().map(|v| v as f32);
        let uniform = GridUniform { linear: [a, b, c, d], shift: [e, f, 0.0, 0.0] };
        queue.write_buffer(&self.uniform, 0, bytemuck::bytes_of(&uniform));
    }
}

fn in_rows(pieces: &[[f32; 4]]) -> Texture {
    let height = pieces.len().div_ceil(ROW).max(1);
    let mut texels = pieces.to_vec();
    texels.resize(ROW * height, [0.0; 4]);
    Texture { width: ROW, height, texels }
}
