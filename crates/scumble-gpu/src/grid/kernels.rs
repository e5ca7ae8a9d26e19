//! The kernels of the grid solver: shaders, and the pipelines that run them.

use wgpu::VertexFormat::{Float32x2, Uint32, Uint32x4};

#[cfg(any(not(target_os = "unknown"), feature = "webgpu"))]
use super::computing;
use super::layer;
use super::texels::{FORMAT, THIN_FORMAT};
use crate::gpu::Gpu;
use crate::shaders::{SEEN, TARGET};
use crate::wgsl::wgsl;

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
    Diagonal,
    Mark,
    Attach,
    Join,
    Gather,
    Collect,
}

#[cfg(not(target_os = "unknown"))]
impl Kernel {
    /// Whether it reads the links of a level.
    pub(super) fn reads_links(self) -> bool {
        !matches!(self, Self::Spread | Self::Attach | Self::Collect)
    }

    /// Whether it reads how its unknowns are held.
    pub(super) fn reads_holds(self) -> bool {
        !matches!(self, Self::Diagonal | Self::Attach | Self::Collect)
    }
}

/// What a kernel is made of.
pub(crate) struct Source {
    pub(crate) name: &'static str,
    pub(super) pieces: &'static [&'static str],
    /// Whether it reads the matrix of a level.
    has_level: bool,
}

impl Source {
    /// With how every texel of a target comes to what the kernel gives.
    pub(crate) fn text(&self, way: &[&str]) -> String {
        let level: &[&str] = if self.has_level { &[LEVEL, UNKNOWNS] } else { &[] };
        [way, &[PASS, LOAD], level, self.pieces].concat().concat()
    }
}

/// Draws all texels.
pub(crate) const DRAW: [&str; 2] = [TARGET, wgsl!("grid/draw")];

const BLOCK: &str = wgsl!("grid/block");
const GIVEN: &str = wgsl!("grid/given");
pub(super) const LEVEL: &str = wgsl!("grid/level");
const LINKS: &str = wgsl!("grid/links");
pub(super) const LOAD: &str = wgsl!("grid/load");
const MATRIX: &str = wgsl!("grid/matrix");
const MERGED: &str = wgsl!("grid/merged");
const PARENT: &str = wgsl!("grid/parent");
const PASS: &str = wgsl!("grid/pass");
const UNKNOWNS: &str = wgsl!("grid/unknowns");

macro_rules! source {
    ($name:literal, $has_level:literal $(, $piece:ident)*) => {
        Source {
            name: $name,
            has_level: $has_level,
            pieces: &[$($piece,)* wgsl!(concat!("grid/", $name))],
        }
    };
}

/// In the order of [`Kernel`].
pub(crate) const SOURCES: [Source; 20] = [
    source!("multiply", true, LINKS, MATRIX, GIVEN),
    source!("residual", true, LINKS, MATRIX, GIVEN),
    source!("relax", true, LINKS, MATRIX, GIVEN),
    source!("start", true, LINKS, MATRIX),
    source!("restrict", true, LINKS, MATRIX),
    source!("interpolate", true, LINKS, MATRIX, PARENT),
    source!("spread", true, PARENT),
    source!("dot", false, BLOCK, MERGED),
    source!("sum", false, BLOCK, MERGED),
    source!("largest", false, BLOCK),
    source!("ratio", false),
    source!("advance", false),
    source!("retreat", false),
    source!("cover", false),
    source!("diagonal", true, LINKS),
    source!("mark", true),
    source!("attach", true),
    source!("join", true, LINKS),
    source!("gather", true, LINKS),
    source!("collect", true),
];

/// Draws single texels.
pub(crate) const POINTS: &str = wgsl!("grid/points");

/// Holds single pixels to what is beyond the borders of a part.
pub(crate) const BORDER: [&str; 2] = [SEEN, wgsl!("grid/border")];

/// What a kernel may read besides a level.
pub(super) const OPERANDS: usize = 3;

/// Operands, and what is computed.
pub(super) fn bindings(gpu: &Gpu) -> usize {
    OPERANDS + usize::from(gpu.computes)
}

/// What runs a kernel.
#[derive(Clone, Debug)]
pub(super) enum Pipeline {
    Draws(wgpu::RenderPipeline),
    #[cfg(any(not(target_os = "unknown"), feature = "webgpu"))]
    Computes(wgpu::ComputePipeline),
}

/// A pipeline for each kernel, and how they are given what they read: the same for all solvers on a device.
#[derive(Debug)]
pub struct Kernels {
    pipelines: Vec<Pipeline>,
    /// For targets of one number a texel, and of four.
    points: [wgpu::RenderPipeline; 2],
    pub(super) border: wgpu::RenderPipeline,
    pub(super) operands_layout: wgpu::BindGroupLayout,
    pub(super) level_layout: wgpu::BindGroupLayout,
    /// Where passes over few texels are made programs.
    #[cfg(not(target_os = "unknown"))]
    pub(super) programs: Option<computing::Programs>,
}

impl Kernels {
    /// Has all of them compiled.
    pub fn new(gpu: &Gpu) -> Self {
        let device = &gpu.device;
        let operand = |i| entry(i as u32, if i < OPERANDS { TEXELS } else { RESULT });
        let operands: [_; OPERANDS + 1] = std::array::from_fn(operand);
        let level =
            [entry(0, UNIFORM), entry(1, TEXELS), entry(2, TEXELS), entry(3, TEXELS), entry(4, TEXELS)];
        let operands_layout = bind_group_layout(device, "operands", &operands[..bindings(gpu)]);
        let level_layout = bind_group_layout(device, "level", &level);
        let both = [Some(&operands_layout), Some(&level_layout)];
        let pipelines = SOURCES.iter().map(|source| {
            let layouts = if source.has_level { &both[..] } else { &both[..1] };
            #[cfg(any(not(target_os = "unknown"), feature = "webgpu"))]
            if gpu.computes {
                return Pipeline::Computes(computing::kernel(device, source, layouts));
            }
            let drawing = Drawing { format: FORMAT, topology: TRIANGLES, buffers: &[] };
            Pipeline::Draws(pipeline(device, source.name, &source.text(&DRAW), layouts, &drawing))
        });
        Self {
            pipelines: pipelines.collect(),
            points: points(device),
            border: border(device),
            operands_layout,
            level_layout,
            #[cfg(not(target_os = "unknown"))]
            programs: computing::Programs::of(gpu),
        }
    }

    /// What draws points into targets of a format.
    pub(super) fn points(&self, format: wgpu::TextureFormat) -> &wgpu::RenderPipeline {
        &self.points[usize::from(format == FORMAT)]
    }

    pub(super) fn pipeline(&self, kernel: Kernel) -> &Pipeline {
        &self.pipelines[kernel as usize]
    }
}

pub(super) const TEXELS: wgpu::BindingType = wgpu::BindingType::Texture {
    sample_type: wgpu::TextureSampleType::Uint,
    view_dimension: wgpu::TextureViewDimension::D2,
    multisampled: false,
};

pub(super) const RESULT: wgpu::BindingType = wgpu::BindingType::StorageTexture {
    access: wgpu::StorageTextureAccess::WriteOnly,
    format: FORMAT,
    view_dimension: wgpu::TextureViewDimension::D2,
};

pub(super) const UNIFORM: wgpu::BindingType = wgpu::BindingType::Buffer {
    ty: wgpu::BufferBindingType::Uniform,
    has_dynamic_offset: false,
    min_binding_size: None,
};

pub(super) fn entry(binding: u32, ty: wgpu::BindingType) -> wgpu::BindGroupLayoutEntry {
    let visibility = match ty {
        wgpu::BindingType::StorageTexture { .. } => wgpu::ShaderStages::COMPUTE,
        _ => wgpu::ShaderStages::FRAGMENT | wgpu::ShaderStages::COMPUTE,
    };
    wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None }
}

pub(super) fn bind_group_layout(
    device: &wgpu::Device,
    label: &str,
    entries: &[wgpu::BindGroupLayoutEntry],
) -> wgpu::BindGroupLayout {
    device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(label), entries })
}

/// Resources in the order of their bindings.
pub(super) fn bind_group<'a>(
    device: &wgpu::Device,
    label: &str,
    layout: &wgpu::BindGroupLayout,
    resources: impl Iterator<Item = wgpu::BindingResource<'a>>,
) -> wgpu::BindGroup {
    let entries: Vec<_> =
        (0..).zip(resources).map(|(binding, resource)| wgpu::BindGroupEntry { binding, resource }).collect();
    device.create_bind_group(&wgpu::BindGroupDescriptor { label: Some(label), layout, entries: &entries })
}

const TRIANGLES: wgpu::PrimitiveTopology = wgpu::PrimitiveTopology::TriangleList;

/// What a pipeline draws, of what, and where.
struct Drawing<'a> {
    format: wgpu::TextureFormat,
    topology: wgpu::PrimitiveTopology,
    buffers: &'a [Option<wgpu::VertexBufferLayout<'a>>],
}

fn points(device: &wgpu::Device) -> [wgpu::RenderPipeline; 2] {
    [(THIN_FORMAT, Uint32), (FORMAT, Uint32x4)]
        .map(|(format, numbers)| point_pipeline(device, POINTS, &[], format, &[Float32x2, numbers]))
}

fn border(device: &wgpu::Device) -> wgpu::RenderPipeline {
    let layout = layer::layout(device);
    point_pipeline(device, &BORDER.concat(), &[Some(&layout)], FORMAT, &[Float32x2, Uint32x4, Uint32])
}

/// Draws points that have numbers of some formats, each in a buffer of its own.
fn point_pipeline(
    device: &wgpu::Device,
    text: &str,
    layouts: &[Option<&wgpu::BindGroupLayout>],
    format: wgpu::TextureFormat,
    numbers: &[wgpu::VertexFormat],
) -> wgpu::RenderPipeline {
    let attribute = |(shader_location, &format)| wgpu::VertexAttribute { format, offset: 0, shader_location };
    let attributes: Vec<_> = (0..).zip(numbers).map(attribute).collect();
    let buffers: Vec<_> = attributes
        .iter()
        .map(|attribute| {
            Some(wgpu::VertexBufferLayout {
                array_stride: attribute.format.size(),
                step_mode: wgpu::VertexStepMode::Vertex,
                attributes: std::slice::from_ref(attribute),
            })
        })
        .collect();
    let drawing = Drawing { format, topology: wgpu::PrimitiveTopology::PointList, buffers: &buffers };
    pipeline(device, "points", text, layouts, &drawing)
}

/// A compiled text, and how what runs it is given what it reads.
pub(super) fn compiled(
    device: &wgpu::Device,
    label: Option<&str>,
    text: &str,
    bind_group_layouts: &[Option<&wgpu::BindGroupLayout>],
) -> (wgpu::ShaderModule, wgpu::PipelineLayout) {
    let source = wgpu::ShaderSource::Wgsl(text.into());
    let module = device.create_shader_module(wgpu::ShaderModuleDescriptor { label, source });
    let layout = wgpu::PipelineLayoutDescriptor { bind_group_layouts, ..Default::default() };
    (module, device.create_pipeline_layout(&layout))
}

fn pipeline(
    device: &wgpu::Device,
    name: &str,
    text: &str,
    layouts: &[Option<&wgpu::BindGroupLayout>],
    drawing: &Drawing<'_>,
) -> wgpu::RenderPipeline {
    let label = Some(name);
    let (module, layout) = compiled(device, label, text, layouts);
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label,
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some("vertex"),
            compilation_options: Default::default(),
            buffers: drawing.buffers,
        },
        primitive: wgpu::PrimitiveState { topology: drawing.topology, ..Default::default() },
        depth_stencil: None,
        multisample: wgpu::MultisampleState::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some("fragment"),
            compilation_options: Default::default(),
            targets: &[Some(drawing.format.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
