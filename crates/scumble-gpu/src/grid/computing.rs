//! Passes that are computed, where a device can; programs outside the page alone, where nobody loads every byte of them.

#[cfg(not(target_os = "unknown"))]
mod fusion;
#[cfg(not(target_os = "unknown"))]
mod program;

use super::kernels::{Pipeline, Source, compiled, written};
use super::tape::Pass;
use super::texels::FORMAT;
use crate::wgsl::wgsl;
#[cfg(not(target_os = "unknown"))]
pub(super) use fusion::fuse;
#[cfg(not(target_os = "unknown"))]
pub(super) use program::Programs;
#[cfg(test)]
pub(crate) use program::text as program_text;

/// Columns and rows that are computed together, as the shader has them.
const WORKGROUP: u32 = 8;

/// What is computed goes to a texture of floats, or of halves.
const FLOATS_TO: &str = "alias Result=texture_storage_2d<rgba32uint,write>;\n";
const HALVES_TO: &str = "alias Result=texture_storage_2d<rg32uint,write>;\n";

/// Computes all texels.
const COMPUTE: &str = wgsl!("grid/compute");

/// How texels of a format are computed.
pub(crate) fn computed(format: wgpu::TextureFormat) -> [&'static str; 3] {
    [if format == FORMAT { FLOATS_TO } else { HALVES_TO }, written(format), COMPUTE]
}

/// Limits with what computing takes. In WebGPU every adapter has that.
pub(crate) fn limits(least: wgpu::Limits) -> wgpu::Limits {
    wgpu::Limits {
        max_storage_textures_per_shader_stage: 1,
        max_compute_invocations_per_workgroup: WORKGROUP * WORKGROUP,
        max_compute_workgroup_size_x: WORKGROUP,
        max_compute_workgroup_size_y: WORKGROUP,
        max_compute_workgroup_size_z: 1,
        max_compute_workgroups_per_dimension: least.max_texture_dimension_2d.div_ceil(WORKGROUP),
        ..least
    }
}

/// Limits with what computing takes, and what programs take, as far as an adapter has that.
#[cfg(not(target_os = "unknown"))]
pub(crate) fn most_limits(least: wgpu::Limits, most: &wgpu::Limits) -> wgpu::Limits {
    let computing = limits(least.clone());
    let programs = program::limits(computing.clone());
    [programs, computing].into_iter().find(|limits| limits.check_limits(most)).unwrap_or(least)
}

/// What runs a kernel.
pub(super) fn kernel(
    device: &wgpu::Device,
    source: &Source,
    format: wgpu::TextureFormat,
    layouts: &[Option<&wgpu::BindGroupLayout>],
) -> wgpu::ComputePipeline {
    pipeline(device, source.name, &source.text(&computed(format)), layouts)
}

fn pipeline(
    device: &wgpu::Device,
    name: &str,
    text: &str,
    layouts: &[Option<&wgpu::BindGroupLayout>],
) -> wgpu::ComputePipeline {
    let label = Some(name);
    let (module, layout) = compiled(device, label, text, layouts);
    device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
        label,
        layout: Some(&layout),
        module: &module,
        entry_point: Some("compute"),
        compilation_options: Default::default(),
        cache: None,
    })
}

/// Runs the passes that are computed.
pub(super) fn run(passes: &[Pass], encoder: &mut wgpu::CommandEncoder) {
    let mut computing = encoder.begin_compute_pass(&Default::default());
    for pass in passes {
        if let Pipeline::Computes(pipeline) = &pass.pipeline {
            compute(pass, pipeline, &mut computing);
        }
    }
}

fn compute(pass: &Pass, pipeline: &wgpu::ComputePipeline, computing: &mut wgpu::ComputePass<'_>) {
    computing.set_pipeline(pipeline);
    computing.set_bind_group(0, &pass.operands, &[]);
    if let Some(level) = &pass.level {
        computing.set_bind_group(1, level, &[]);
    }
    let [columns, rows] = [pass.target.texture().width(), pass.target.texture().height()];
    computing.dispatch_workgroups(columns.div_ceil(WORKGROUP), rows.div_ceil(WORKGROUP), 1);
}
