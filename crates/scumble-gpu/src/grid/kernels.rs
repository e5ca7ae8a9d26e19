//! The kernels of the grid solver: shaders, and the pipelines that draw with them.

use super::texels::FORMAT;

/// A kernel and its twin on the CPU have the same name, but for sums over all texels.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Kernel {
    Multiply,
    Residual,
    Relax,
    Start,
    Restrict,
    Interpolate,
    Spread,
    Dot,
    Sum,
    Largest,
    Ratio,
    Advance,
    Retreat,
    Cover,
}

/// What a kernel is made of.
pub(crate) struct Source {
    pub(crate) name: &'static str,
    pub(crate) text: &'static str,
    /// Whether it reads the matrix of a level.
    has_level: bool,
}

macro_rules! source {
    ($name:literal, $has_level:literal, $($piece:literal),+) => {
        Source {
            name: $name,
            has_level: $has_level,
            text: concat!($(include_str!(concat!("../../../../shaders/grid/", $piece, ".wgsl")), "\n"),+),
        }
    };
}

/// In the order of [`Kernel`].
pub(crate) const SOURCES: [Source; 14] = [
    source!("multiply", true, "pass", "level", "links", "matrix", "multiply"),
    source!("residual", true, "pass", "level", "links", "matrix", "residual"),
    source!("relax", true, "pass", "level", "links", "matrix", "relax"),
    source!("start", true, "pass", "level", "start"),
    source!("restrict", true, "pass", "level", "links", "restrict"),
    source!("interpolate", true, "pass", "level", "links", "parent", "interpolate"),
    source!("spread", true, "pass", "level", "parent", "spread"),
    source!("dot", false, "pass", "block", "dot"),
    source!("sum", false, "pass", "block", "sum"),
    source!("largest", false, "pass", "largest"),
    source!("ratio", false, "pass", "ratio"),
    source!("advance", false, "pass", "advance"),
    source!("retreat", false, "pass", "retreat"),
    source!("cover", false, "pass", "cover"),
];

/// What a kernel may read besides a level.
pub(super) const OPERANDS: usize = 3;

/// A pipeline for each kernel, and how they are given what they read: the same for all solvers on a device.
#[derive(Debug)]
pub struct Kernels {
    pipelines: Vec<wgpu::RenderPipeline>,
    pub(super) operands_layout: wgpu::BindGroupLayout,
    pub(super) level_layout: wgpu::BindGroupLayout,
}

impl Kernels {
    /// Has all of them compiled.
    pub fn new(device: &wgpu::Device) -> Self {
        let operands: [_; OPERANDS] = std::array::from_fn(|i| entry(i as u32, TEXELS));
        let level =
            [entry(0, UNIFORM), entry(1, TEXELS), entry(2, TEXELS), entry(3, TEXELS), entry(4, TEXELS)];
        let operands_layout = bind_group_layout(device, "operands", &operands);
        let level_layout = bind_group_layout(device, "level", &level);
        let both = [Some(&operands_layout), Some(&level_layout)];
        let pipelines = SOURCES.iter().map(|source| {
            let layouts = if source.has_level { &both[..] } else { &both[..1] };
            pipeline(device, source, layouts)
        });
        Self { pipelines: pipelines.collect(), operands_layout, level_layout }
    }

    pub(super) fn pipeline(&self, kernel: Kernel) -> &wgpu::RenderPipeline {
        &self.pipelines[kernel as usize]
    }
}

pub(super) const TEXELS: wgpu::BindingType = wgpu::BindingType::Texture {
    sample_type: wgpu::TextureSampleType::Uint,
    view_dimension: wgpu::TextureViewDimension::D2,
    multisampled: false,
};

pub(super) const UNIFORM: wgpu::BindingType = wgpu::BindingType::Buffer {
    ty: wgpu::BufferBindingType::Uniform,
    has_dynamic_offset: false,
    min_binding_size: None,
};

pub(super) fn entry(binding: u32, ty: wgpu::BindingType) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::FRAGMENT, ty, count: None }
}

pub(super) fn bind_group_layout(
    device: &wgpu::Device,
    label: &str,
    entries: &[wgpu::BindGroupLayoutEntry],
) -> wgpu::BindGroupLayout {
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(label), entries })
}

fn pipeline(
    device: &wgpu::Device,
    source: &Source,
    bind_group_layouts: &[Option<&wgpu::BindGroupLayout>],
) -> wgpu::RenderPipeline {
    let label = Some(source.name);
    let text = wgpu::ShaderSource::Wgsl(source.text.into());
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor { label, source: text });
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label,
        bind_group_layouts,
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label,
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("vertex"),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: wgpu::PrimitiveState::default(),
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("fragment"),
            compilation_options: Default::default(),
            targets: &[Some(FORMAT.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
