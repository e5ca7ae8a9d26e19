//! Passes that are computed: outside the page, where every byte of this would be loaded, and where a device can.

use super::kernels::{Pipeline, Source, compiled};
use super::tape::Pass;
use crate::wgsl::wgsl;

/// Columns and rows that are computed together, as the shader has them.
const WORKGROUP: u32 = 8;

/// Computes all texels.
pub(crate) const COMPUTE: &str = wgsl!("grid/compute");

/// Limits with what computing takes, where an adapter has that.
pub(crate) fn limits(limits: wgpu::Limits, most: &wgpu::Limits) -> wgpu::Limits {
    let computing = wgpu::Limits {
        max_storage_textures_per_shader_stage: 1,
        max_compute_invocations_per_workgroup: WORKGROUP * WORKGROUP,
        max_compute_workgroup_size_x: WORKGROUP,
        max_compute_workgroup_size_y: WORKGROUP,
        max_compute_workgroup_size_z: 1,
        max_compute_workgroups_per_dimension: limits.max_texture_dimension_2d.div_ceil(WORKGROUP),
        ..limits.clone()
    };
    if computing.check_limits(most) { computing } else { limits }
}

pub(super) fn pipeline(
    device: &wgpu::Device,
    source: &Source,
    layouts: &[Option<&wgpu::BindGroupLayout>],
) -> wgpu::ComputePipeline {
    let label = Some(source.name);
    let (module, layout) = compiled(device, label, &source.text(&[COMPUTE]), layouts);
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
