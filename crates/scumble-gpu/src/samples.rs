//! The textures in which a picture is drawn: every sample's colour and depth, before they are resolved.

use scumble_core::Srgb8;
use scumble_solve::View;

/// Samples in a pixel: what WebGL2 and WebGPU promise.
pub(crate) const SAMPLES: u32 = 4;

/// Tells 2²⁴ shapes apart.
pub(crate) const DEPTH_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Depth32Float;

/// Textures that hold every sample of a picture while it is drawn.
#[derive(Debug)]
pub(crate) struct Samples {
    width_px: u32,
    height_px: u32,
    color: wgpu::TextureView,
    depth: wgpu::TextureView,
}

impl Samples {
    pub(crate) fn new(device: &wgpu::Device, view: &View, format: wgpu::TextureFormat) -> Self {
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT;
        let samples = |format| texture(device, view, SAMPLES, format, usage).create_view(&Default::default());
        Self {
            width_px: view.width_px,
            height_px: view.height_px,
            color: samples(format),
            depth: samples(DEPTH_FORMAT),
        }
    }

    /// Whether they have the size of a view.
    pub(crate) fn fit(&self, view: &View) -> bool {
        (self.width_px, self.height_px) == (view.width_px, view.height_px)
    }

    /// Begins a pass that clears to the paper and ends by resolving into the target.
    pub(crate) fn begin<'a>(
        &self,
        encoder: &'a mut wgpu::CommandEncoder,
        paper: Option<Srgb8>,
        target: &wgpu::TextureView,
    ) -> wgpu::RenderPass<'a> {
        let color = wgpu::RenderPassColorAttachment {
            view: &self.color,
            depth_slice: None,
            resolve_target: Some(target),
            ops: clear_to(clear_color(paper)),
        };
        let depth = wgpu::RenderPassDepthStencilAttachment {
            view: &self.depth,
            depth_ops: Some(clear_to(0.0)),
            stencil_ops: None,
        };
        encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("scene"),
            color_attachments: &[Some(color)],
            depth_stencil_attachment: Some(depth),
            ..Default::default()
        })
    }
}

fn clear_to<V>(value: V) -> wgpu::Operations<V> {
    wgpu::Operations { load: wgpu::LoadOp::Clear(value), store: wgpu::StoreOp::Discard }
}

fn clear_color(paper: Option<Srgb8>) -> wgpu::Color {
    paper.map_or(wgpu::Color::TRANSPARENT, |Srgb8(rgb)| {
        let [r, g, b] = rgb.map(|c| f64::from(c) / 255.0);
        wgpu::Color { r, g, b, a: 1.0 }
    })
}

/// A texture of a view's size.
pub(crate) fn texture(
    device: &wgpu::Device,
    view: &View,
    sample_count: u32,
    format: wgpu::TextureFormat,
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    device.create_texture(&wgpu::TextureDescriptor {
        label: Some("picture"),
        size: wgpu::Extent3d { width: view.width_px, height: view.height_px, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage,
        view_formats: &[],
    })
}
