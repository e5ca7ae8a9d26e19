//! Single texels of textures of numbers, drawn as points.

use scumble_solve::grid::Texel;

use super::kernels::Kernels;
use crate::gpu::Gpu;

/// Where texels are.
#[derive(Debug)]
pub(super) struct Points<'a> {
    gpu: &'a Gpu,
    kernels: &'a Kernels,
    count: u32,
    centers: wgpu::Buffer,
}

impl<'a> Points<'a> {
    /// With their centres in clip space.
    pub(super) fn new(gpu: &'a Gpu, kernels: &'a Kernels, centers: &[[f32; 2]]) -> Self {
        Self {
            gpu,
            kernels,
            count: centers.len() as u32,
            centers: buffer(gpu, bytemuck::cast_slice(centers)),
        }
    }

    /// Draws their numbers, one or four for each, over what is in a target, or over one number everywhere.
    pub(super) fn draw<T: bytemuck::Pod>(
        &self,
        encoder: &mut wgpu::CommandEncoder,
        target: &wgpu::TextureView,
        everywhere: Option<f32>,
        numbers: &[T],
    ) {
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("points"),
            color_attachments: &[Some(attachment(target, everywhere))],
            ..Default::default()
        });
        if self.count > 0 {
            let numbers = buffer(self.gpu, bytemuck::cast_slice(numbers));
            pass.set_pipeline(self.kernels.points(target.texture().format()));
            pass.set_vertex_buffer(0, self.centers.slice(..));
            pass.set_vertex_buffer(1, numbers.slice(..));
            pass.draw(0..self.count, 0..1);
        }
    }
}

/// The pixels at the borders of a part of a picture.
#[derive(Debug)]
pub(super) struct Borders {
    count: u32,
    /// Their centres in clip space, the right sides of their equations, and the links that lead out.
    buffers: [wgpu::Buffer; 3],
}

impl Borders {
    pub(super) fn new(gpu: &Gpu, centers: &[[f32; 2]], rights: &[Texel], links: &[u32]) -> Self {
        let bytes =
            [bytemuck::cast_slice(centers), bytemuck::cast_slice(rights), bytemuck::cast_slice(links)];
        Self { count: links.len() as u32, buffers: bytes.map(|bytes| buffer(gpu, bytes)) }
    }

    /// Draws the right sides of their equations, with what a grid of the whole has beyond the borders.
    pub(super) fn draw(
        &self,
        gpu: &Gpu,
        kernels: &Kernels,
        whole: &wgpu::BindGroup,
        right: &wgpu::TextureView,
    ) {
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("border"),
            color_attachments: &[Some(attachment(right, None))],
            ..Default::default()
        });
        pass.set_pipeline(&kernels.border);
        pass.set_bind_group(0, whole, &[]);
        for (slot, buffer) in (0..).zip(&self.buffers) {
            pass.set_vertex_buffer(slot, buffer.slice(..));
        }
        pass.draw(0..self.count, 0..1);
        drop(pass);
        gpu.queue.submit([encoder.finish()]);
    }
}

fn attachment(target: &wgpu::TextureView, everywhere: Option<f32>) -> wgpu::RenderPassColorAttachment<'_> {
    let bits = |number: f32| f64::from(number.to_bits());
    let clear = |number| wgpu::LoadOp::Clear(wgpu::Color { r: bits(number), ..wgpu::Color::TRANSPARENT });
    let load = everywhere.map_or(wgpu::LoadOp::Load, clear);
    let ops = wgpu::Operations { load, store: wgpu::StoreOp::Store };
    wgpu::RenderPassColorAttachment { view: target, depth_slice: None, resolve_target: None, ops }
}

fn buffer(gpu: &Gpu, bytes: &[u8]) -> wgpu::Buffer {
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("points"),
        size: bytes.len() as u64,
        usage: wgpu::BufferUsages::VERTEX | wgpu::BufferUsages::COPY_DST,
        mapped_at_creation: false,
    });
    gpu.queue.write_buffer(&buffer, 0, bytes);
    buffer
}
