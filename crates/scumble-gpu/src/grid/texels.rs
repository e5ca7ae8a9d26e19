//! Textures of numbers: made, filled and read.

use std::ops::Range;

use scumble_solve::grid::{Texel, Texture};

use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::read_back::{copied, mapped, read_back_error};

/// The bits of four floats a texel: every device draws whole numbers, many phones no floats but halves. Those would not do:
/// conjugate gradients live on the last bits.
pub(crate) const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba32Uint;

/// The bits of four halves a texel, two in each number, as `pass.wgsl` has them: half of what is moved, for what need not be
/// exact.
pub(crate) const HALF_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rg32Uint;

/// The bits of one float a texel.
pub(super) const THIN_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::R32Uint;

/// Texels that may be made; at first zeros.
pub(super) fn target(gpu: &Gpu, size: [u32; 2], format: wgpu::TextureFormat) -> wgpu::TextureView {
    let is_computed = gpu.computes && format != THIN_FORMAT;
    let computed =
        if is_computed { wgpu::TextureUsages::STORAGE_BINDING } else { wgpu::TextureUsages::empty() };
    let drawn = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
    made(gpu, size, format, drawn | computed).create_view(&Default::default())
}

/// A target like another.
pub(super) fn alike(gpu: &Gpu, view: &wgpu::TextureView) -> wgpu::TextureView {
    target(gpu, [view.texture().width(), view.texture().height()], view.texture().format())
}

/// The same texels on the GPU, to be read and drawn.
pub(crate) fn uploaded(gpu: &Gpu, texture: &Texture) -> wgpu::TextureView {
    let view = target(gpu, [texture.width as u32, texture.height as u32], FORMAT);
    write(gpu, view.texture(), bytemuck::cast_slice(&texture.texels));
    view
}

/// Pairs of numbers in rows on the GPU, to be read.
pub(super) fn uploaded_pairs(gpu: &Gpu, size: [u32; 2], pairs: &[[u32; 2]]) -> wgpu::TextureView {
    let texels = made(gpu, size, wgpu::TextureFormat::Rg32Uint, wgpu::TextureUsages::empty());
    write(gpu, &texels, bytemuck::cast_slice(pairs));
    texels.create_view(&Default::default())
}

/// A single texel of four equal numbers.
pub(super) fn single(gpu: &Gpu, number: f32) -> wgpu::TextureView {
    single_texel(gpu, [number; 4])
}

/// A single texel.
pub(super) fn single_texel(gpu: &Gpu, texel: Texel) -> wgpu::TextureView {
    uploaded(gpu, &Texture { width: 1, height: 1, texels: vec![texel] })
}

fn made(
    gpu: &Gpu,
    [width, height]: [u32; 2],
    format: wgpu::TextureFormat,
    usage: wgpu::TextureUsages,
) -> wgpu::Texture {
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("grid"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: usage | wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    })
}

/// Uploads some rows into a texture of the same size.
pub(super) fn write_rows(gpu: &Gpu, view: &wgpu::TextureView, texture: &Texture, rows: Range<usize>) {
    let texels = &texture.texels[rows.start * texture.width..rows.end * texture.width];
    let target = wgpu::TexelCopyTextureInfo {
        origin: wgpu::Origin3d { x: 0, y: rows.start as u32, z: 0 },
        ..view.texture().as_image_copy()
    };
    let size = wgpu::Extent3d { height: rows.len() as u32, ..view.texture().size() };
    write_part(gpu, target, bytemuck::cast_slice(texels), size);
}

fn write(gpu: &Gpu, texture: &wgpu::Texture, bytes: &[u8]) {
    write_part(gpu, texture.as_image_copy(), bytes, texture.size());
}

fn write_part(gpu: &Gpu, target: wgpu::TexelCopyTextureInfo<'_>, bytes: &[u8], size: wgpu::Extent3d) {
    let bytes_per_row = Some((bytes.len() as u32) / size.height.max(1));
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row, rows_per_image: None };
    gpu.queue.write_texture(target, bytes, layout, size);
}

/// The texels of a target of floats, row by row.
pub(crate) async fn read(gpu: &Gpu, view: &wgpu::TextureView) -> Result<Vec<Texel>, GpuError> {
    let texture = view.texture();
    debug_assert_eq!(texture.format(), FORMAT);
    let row_bytes = size_of::<Texel>() * texture.width() as usize;
    let (buffer, padded_row_bytes) = copied(gpu, texture, size_of::<Texel>() as u32);
    mapped(&gpu.device, &buffer).await.map_err(read_back_error)?;
    let bytes = buffer.get_mapped_range(..).map_err(read_back_error)?;
    let rows = bytes.chunks_exact(padded_row_bytes);
    Ok(rows.flat_map(|row| bytemuck::pod_collect_to_vec(&row[..row_bytes])).collect())
}
