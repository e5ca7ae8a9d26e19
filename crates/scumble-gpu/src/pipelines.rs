//! The pipelines: field triangles, or what the grid solver found, and shapes over them.

use crate::items;
use crate::samples::{DEPTH_FORMAT, SAMPLES};
use crate::shaders;

/// How all of them reach the view.
pub(crate) const VIEW_LAYOUT: wgpu::BindGroupLayoutDescriptor<'static> = wgpu::BindGroupLayoutDescriptor {
    label: Some("view"),
    entries: &[wgpu::BindGroupLayoutEntry {
        binding: 0,
        visibility: wgpu::ShaderStages::VERTEX_FRAGMENT,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Uniform,
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    }],
};

/// What tells one pipeline from another.
struct Kernel {
    label: &'static str,
    source: &'static [&'static str],
    buffers: &'static [Option<wgpu::VertexBufferLayout<'static>>],
    depth_write: bool,
    depth_compare: wgpu::CompareFunction,
}

/// Draws triangles that do not overlap, over the paper where they are not opaque.
pub(crate) fn field(
    device: &wgpu::Device,
    view_layout: &wgpu::BindGroupLayout,
    format: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let kernel = Kernel {
        label: "field",
        source: &shaders::FIELD,
        buffers: &[Some(items::FIELD_LAYOUT)],
        depth_write: false,
        depth_compare: wgpu::CompareFunction::Always,
    };
    kernel.pipeline(device, &[Some(view_layout)], format)
}

/// Mixes triangles in, once a sample and shape: where a shape has been, its depth is no longer greater.
pub(crate) fn shape(
    device: &wgpu::Device,
    view_layout: &wgpu::BindGroupLayout,
    format: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let kernel = Kernel {
        label: "shape",
        source: &shaders::SHAPE,
        buffers: &[Some(items::SHAPE_LAYOUT)],
        depth_write: true,
        depth_compare: wgpu::CompareFunction::Greater,
    };
    kernel.pipeline(device, &[Some(view_layout)], format)
}

/// Draws what the grid solver found, over the paper where it is not opaque.
pub(crate) fn solution(
    device: &wgpu::Device,
    layouts: [&wgpu::BindGroupLayout; 2],
    format: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let kernel = Kernel {
        label: "solution",
        source: &shaders::SOLUTION,
        buffers: &[],
        depth_write: false,
        depth_compare: wgpu::CompareFunction::Always,
    };
    kernel.pipeline(device, &layouts.map(Some), format)
}

impl Kernel {
    fn pipeline(
        self,
        device: &wgpu::Device,
        bind_group_layouts: &[Option<&wgpu::BindGroupLayout>],
        format: wgpu::TextureFormat,
    ) -> wgpu::RenderPipeline {
        let label = Some(self.label);
        let source = wgpu::ShaderSource::Wgsl(self.source.concat().into());
        let module = device.create_shader_module(wgpu::ShaderModuleDescriptor { label, source });
        let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
            label,
            bind_group_layouts,
            immediate_size: 0,
        });
        let blend = Some(wgpu::BlendState::PREMULTIPLIED_ALPHA_BLENDING);
        let target = wgpu::ColorTargetState { format, blend, write_mask: wgpu::ColorWrites::ALL };
        device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
            label,
            layout: Some(&layout),
            vertex: wgpu::VertexState {
                module: &module,
                entry_point: Some("vertex"),
                compilation_options: Default::default(),
                buffers: self.buffers,
            },
            primitive: wgpu::PrimitiveState::default(),
            depth_stencil: Some(wgpu::DepthStencilState {
                format: DEPTH_FORMAT,
                depth_write_enabled: Some(self.depth_write),
                depth_compare: Some(self.depth_compare),
                stencil: Default::default(),
                bias: Default::default(),
            }),
            multisample: wgpu::MultisampleState { count: SAMPLES, ..Default::default() },
            fragment: Some(wgpu::FragmentState {
                module: &module,
                entry_point: Some("fragment"),
                compilation_options: Default::default(),
                targets: &[Some(target)],
            }),
            multiview_mask: None,
            cache: None,
        })
    }
}
