//! The kernels of the grid solver: shaders, and the pipelines that run them.

use std::cell::OnceCell;

use wgpu::VertexFormat::{Float32x2, Uint32, Uint32x4};

#[cfg(any(not(target_os = "unknown"), feature = "webgpu"))]
use super::computing;
use super::layer;
use super::texels::{FORMAT, HALF_FORMAT, THIN_FORMAT};
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

/// How texels of a format are drawn.
pub(crate) fn drawn(format: wgpu::TextureFormat) -> [&'static str; 3] {
    [TARGET, written(format), wgsl!("grid/draw")]
}

/// How what a kernel gives is written in a format.
pub(super) fn written(format: wgpu::TextureFormat) -> &'static str {
    if format == FORMAT { wgsl!("grid/floats") } else { wgsl!("grid/halves") }
}

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

/// Pipelines of kernels that make texels of one format, by their numbers, and how they are given what they read.
#[derive(Debug)]
struct Makers {
    format: wgpu::TextureFormat,
    pipelines: [OnceCell<Pipeline>; SOURCES.len()],
    operands_layout: wgpu::BindGroupLayout,
}

/// Pipelines for all kernels, and how they are given what they read: the same for all solvers on a device. Kernels are compiled
/// when the first solver is made that needs them.
#[derive(Debug)]
pub struct Kernels {
    /// Those that make floats, and those that make halves.
    makers: [Makers; 2],
    /// For targets of one number a texel, and of four.
    points: [wgpu::RenderPipeline; 2],
    pub(super) border: wgpu::RenderPipeline,
    pub(super) level_layout: wgpu::BindGroupLayout,
    /// Where passes over few texels are made programs.
    #[cfg(not(target_os = "unknown"))]
    pub(super) programs: Option<computing::Programs>,
}

impl Kernels {
    /// For solvers on a device.
    pub fn new(gpu: &Gpu) -> Self {
        let device = &gpu.device;
        let level =
            [entry(0, UNIFORM), entry(1, TEXELS), entry(2, TEXELS), entry(3, TEXELS), entry(4, TEXELS)];
        let level_layout = bind_group_layout(device, "level", &level);
        Self {
            makers: [FORMAT, HALF_FORMAT].map(|format| Makers::new(gpu, format)),
            points: points(device),
            border: border(device),
            level_layout,
            #[cfg(not(target_os = "unknown"))]
            programs: computing::Programs::of(gpu),
        }
    }

    /// What draws points into targets of a format.
    pub(super) fn points(&self, format: wgpu::TextureFormat) -> &wgpu::RenderPipeline {
        &self.points[usize::from(format == FORMAT)]
    }

    /// What makes texels of a format, on the device that these are for.
    pub(super) fn pipeline(&self, gpu: &Gpu, kernel: Kernel, format: wgpu::TextureFormat) -> &Pipeline {
        let makers = self.makers(format);
        makers.pipelines[kernel as usize].get_or_init(|| makers.compiled(gpu, kernel, &self.level_layout))
    }

    /// How kernels that make texels of a format are given what they read.
    pub(super) fn operands_layout(&self, format: wgpu::TextureFormat) -> &wgpu::BindGroupLayout {
        &self.makers(format).operands_layout
    }

    fn makers(&self, format: wgpu::TextureFormat) -> &Makers {
        &self.makers[usize::from(format != FORMAT)]
    }
}

impl Makers {
    fn new(gpu: &Gpu, format: wgpu::TextureFormat) -> Self {
        let operand = |i| entry(i as u32, if i < OPERANDS { TEXELS } else { result(format) });
        let operands: [_; OPERANDS + 1] = std::array::from_fn(operand);
        let operands_layout = bind_group_layout(&gpu.device, "operands", &operands[..bindings(gpu)]);
        Self { format, pipelines: Default::default(), operands_layout }
    }

    fn compiled(&self, gpu: &Gpu, kernel: Kernel, level_layout: &wgpu::BindGroupLayout) -> Pipeline {
        let source = &SOURCES[kernel as usize];
        let both = [Some(&self.operands_layout), Some(level_layout)];
        let layouts = if source.has_level { &both[..] } else { &both[..1] };
        #[cfg(any(not(target_os = "unknown"), feature = "webgpu"))]
        if gpu.computes {
            return Pipeline::Computes(computing::kernel(&gpu.device, source, self.format, layouts));
        }
        let drawing = Drawing { format: self.format, topology: TRIANGLES, buffers: &[] };
        let text = source.text(&drawn(self.format));
        Pipeline::Draws(pipeline(&gpu.device, source.name, &text, layouts, &drawing))
    }
}

pub(super) const TEXELS: wgpu::BindingType = wgpu::BindingType::Texture {
    sample_type: wgpu::TextureSampleType::Uint,
    view_dimension: wgpu::TextureViewDimension::D2,
    multisampled: false,
};

/// Texels of a format that are made.
pub(super) fn result(format: wgpu::TextureFormat) -> wgpu::BindingType {
    let (access, view_dimension) = (wgpu::StorageTextureAccess::WriteOnly, wgpu::TextureViewDimension::D2);
    wgpu::BindingType::StorageTexture { access, format, view_dimension }
}

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
