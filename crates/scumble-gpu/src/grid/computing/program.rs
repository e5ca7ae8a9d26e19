//! Programs: what many passes over few texels do, computed in one dispatch.

use bytemuck::{Pod, Zeroable};
use wgpu::util::DeviceExt;

use crate::gpu::Gpu;
use crate::grid::kernels::{LEVEL, LOAD, SOURCES, Source, TEXELS, bind_group, bind_group_layout, result};
use crate::grid::texels::{FORMAT, target};
use crate::wgsl::wgsl;

/// Textures that a program takes texels from, at most, as the shader has them.
pub(super) const INLETS: usize = 8;

/// Texels that programs compute together, as the shader has them.
const WORKGROUP: u32 = 512;

/// Bytes of the largest buffer of a program: the textures of small passes have less than half of them.
const STORAGE_BYTES: u64 = 1 << 20;

/// Limits of computing with what programs take.
pub(super) fn limits(computing: wgpu::Limits) -> wgpu::Limits {
    wgpu::Limits {
        max_storage_buffers_per_shader_stage: 2,
        max_storage_buffer_binding_size: STORAGE_BYTES,
        max_compute_invocations_per_workgroup: WORKGROUP,
        max_compute_workgroup_size_x: WORKGROUP,
        ..computing
    }
}

/// The number of an instruction that takes the texels of the inlet that the offset of its first operand names.
pub(super) const TAKE: u32 = SOURCES.len() as u32;

/// The number of one that gives those of its first operand to the outlet.
pub(super) const GIVE: u32 = TAKE + 1;

/// Rows of texels in the pool, as the shader has them.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Texels {
    pub(super) offset: u32,
    pub(super) width: u32,
    pub(super) height: u32,
}

/// A pass, as the shader has it: its kernel by number.
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Instruction {
    pub(super) kernel: u32,
    pub(super) columns: u32,
    pub(super) slots: u32,
    pub(super) result: Texels,
    pub(super) operands: [Texels; 3],
    pub(super) links: [Texels; 3],
    pub(super) holds: Texels,
}

/// What runs programs.
#[derive(Debug)]
pub(in crate::grid) struct Programs {
    pub(super) pipeline: wgpu::ComputePipeline,
    layout: wgpu::BindGroupLayout,
    /// Single texels, for programs with fewer inlets and with no outlet.
    unused: [wgpu::TextureView; 2],
}

impl Programs {
    /// What runs them on a card that can. On a few cores, passes one by one are faster than one work group.
    pub(in crate::grid) fn of(gpu: &Gpu) -> Option<Self> {
        let can_run = gpu.device.limits().max_compute_invocations_per_workgroup >= WORKGROUP;
        (can_run && !gpu.is_software()).then(|| Self::new(gpu))
    }

    pub(in crate::grid) fn new(gpu: &Gpu) -> Self {
        let layout = bind_group_layout(&gpu.device, "program", &entries());
        let pipeline = super::pipeline(&gpu.device, "program", &text(), &[Some(&layout)]);
        Self { pipeline, layout, unused: [(); 2].map(|()| target(gpu, [1, 1], FORMAT)) }
    }

    /// A texture so small that one work group is dispatched for it.
    pub(super) fn one(&self) -> &wgpu::TextureView {
        &self.unused[1]
    }

    /// What a program reads and writes.
    pub(super) fn group(
        &self,
        device: &wgpu::Device,
        instructions: &[Instruction],
        pool: &wgpu::Buffer,
        inlets: &[&wgpu::TextureView],
        outlet: Option<&wgpu::TextureView>,
    ) -> wgpu::BindGroup {
        let instructions = device.create_buffer_init(&wgpu::util::BufferInitDescriptor {
            label: Some("instructions"),
            contents: bytemuck::cast_slice(instructions),
            usage: wgpu::BufferUsages::STORAGE,
        });
        let [nothing, nowhere] = &self.unused;
        let inlets = (0..INLETS).map(|i| inlets.get(i).copied().unwrap_or(nothing));
        let first = [
            wgpu::BindingResource::TextureView(outlet.unwrap_or(nowhere)),
            instructions.as_entire_binding(),
            pool.as_entire_binding(),
        ];
        let resources = first.into_iter().chain(inlets.map(wgpu::BindingResource::TextureView));
        bind_group(device, "program", &self.layout, resources)
    }
}

fn entries() -> Vec<wgpu::BindGroupLayoutEntry> {
    let types = [result(FORMAT), storage(true), storage(false)].into_iter().chain([TEXELS; INLETS]);
    let visibility = wgpu::ShaderStages::COMPUTE;
    (0..)
        .zip(types)
        .map(|(binding, ty)| wgpu::BindGroupLayoutEntry { binding, visibility, ty, count: None })
        .collect()
}

fn storage(read_only: bool) -> wgpu::BindingType {
    wgpu::BindingType::Buffer {
        ty: wgpu::BufferBindingType::Storage { read_only },
        has_dynamic_offset: false,
        min_binding_size: None,
    }
}

/// All kernels in one text, chosen by their numbers.
pub(crate) fn text() -> String {
    let numbers = format!("const TAKE = {TAKE}u;\nconst GIVE = {GIVE}u;\n");
    let kernels: String = SOURCES.iter().map(renamed).collect();
    let case =
        |(i, source): (usize, &Source)| format!("case {i}u: {{ return kernel_{}(place); }}\n", source.name);
    let cases: String = SOURCES.iter().enumerate().map(case).collect();
    let chosen = format!(
        "fn kernel(number: u32, place: vec2<i32>) -> vec4<f32> {{\nswitch number {{\n{cases}default: {{ return vec4(0.0); }}\n}}\n}}\n"
    );
    let [to, floats, _] = super::computed(FORMAT);
    [wgsl!("grid/program"), to, floats, &numbers, LOAD, LEVEL, &kernels, &chosen].concat()
}

/// The pieces of a kernel, with the kernel's name after every name that they declare.
fn renamed(source: &Source) -> String {
    let text = source.pieces.concat();
    let names: Vec<&str> = text.lines().filter_map(declared).collect();
    let rename = |word: &str| {
        let (name, rest) = word.split_at(word.find(|c| !is_of_name(c)).unwrap_or(word.len()));
        let suffix = if names.contains(&name) { ["_", source.name] } else { [""; 2] };
        [name, suffix[0], suffix[1], rest].concat()
    };
    text.split_inclusive(|c| !is_of_name(c)).map(rename).collect()
}

/// The name that a line of a text as devices read it declares outside of functions.
fn declared(line: &str) -> Option<&str> {
    let rest = ["fn ", "const ", "var<private>"].iter().find_map(|kind| line.strip_prefix(kind))?;
    rest.split(|c| !is_of_name(c)).next()
}

fn is_of_name(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}
