//! Pixels on their way back from the device: tiles copied into buffers, the buffers mapped, the rows unpacked.

use std::sync::{Arc, Mutex, PoisonError};
use std::task::{Poll, Waker};

use scumble_solve::{Pixmap, View};

use crate::error::GpuError;
use crate::gpu::Gpu;

/// A view cut into tiles, each with the place of its top left pixel, none larger than `side_px` either way.
pub(crate) fn tiles(view: &View, side_px: u32) -> Vec<(u32, u32, View)> {
    let starts = |length_px: u32| (0..length_px).step_by(side_px as usize);
    let at = |x_px: u32, y_px: u32| View {
        px_from_du: view.px_from_du.then_translate((-f64::from(x_px), -f64::from(y_px)).into()),
        width_px: side_px.min(view.width_px - x_px),
        height_px: side_px.min(view.height_px - y_px),
    };
    starts(view.height_px).flat_map(|y| starts(view.width_px).map(move |x| (x, y, at(x, y)))).collect()
}

/// A copy of a texture of premultiplied 8-bit colours, and where it belongs in the picture.
#[derive(Debug)]
pub(crate) struct Copy {
    x_px: usize,
    y_px: usize,
    buffer: wgpu::Buffer,
    width_px: usize,
    padded_row_bytes: usize,
    format: wgpu::TextureFormat,
}

impl Copy {
    /// Has a texture copied.
    pub(crate) fn new(gpu: &Gpu, texture: &wgpu::Texture, x_px: u32, y_px: u32) -> Self {
        let (buffer, padded_row_bytes) = copied(gpu, texture, 4);
        Self {
            x_px: x_px as usize,
            y_px: y_px as usize,
            buffer,
            width_px: texture.width() as usize,
            padded_row_bytes,
            format: texture.format(),
        }
    }

    /// Waits for the copy and puts it into its place in the picture.
    async fn unpack(self, device: &wgpu::Device, picture: &mut Pixmap) -> Result<(), GpuError> {
        mapped(device, &self.buffer).await.map_err(read_back_error)?;
        let bytes = self.buffer.get_mapped_range(..).map_err(read_back_error)?;
        let picture_rows = picture.rgba.chunks_exact_mut(4 * picture.width_px as usize).skip(self.y_px);
        for (row, picture_row) in bytes.chunks_exact(self.padded_row_bytes).zip(picture_rows) {
            let pixels = picture_row.chunks_exact_mut(4).skip(self.x_px).take(self.width_px);
            for (pixel, texel) in pixels.zip(row.chunks_exact(4)) {
                pixel.copy_from_slice(&straight(texel, self.format));
            }
        }
        Ok(())
    }
}

/// Has the rows of a texture copied, each padded to so many bytes.
pub(crate) fn copied(gpu: &Gpu, texture: &wgpu::Texture, texel_bytes: u32) -> (wgpu::Buffer, usize) {
    let padded_row_bytes =
        (texel_bytes * texture.width()).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT);
    let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("read back"),
        size: u64::from(padded_row_bytes) * u64::from(texture.height()),
        usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
        mapped_at_creation: false,
    });
    let layout = wgpu::TexelCopyBufferLayout {
        offset: 0,
        bytes_per_row: Some(padded_row_bytes),
        rows_per_image: None,
    };
    let target = wgpu::TexelCopyBufferInfo { buffer: &buffer, layout };
    let mut encoder = gpu.device.create_command_encoder(&Default::default());
    encoder.copy_texture_to_buffer(texture.as_image_copy(), target, texture.size());
    gpu.queue.submit([encoder.finish()]);
    (buffer, padded_row_bytes as usize)
}

pub(crate) fn read_back_error(error: impl ToString) -> GpuError {
    GpuError::ReadBack(error.to_string())
}

/// Puts copies together.
pub(crate) async fn collect(
    device: wgpu::Device,
    copies: Vec<Copy>,
    width_px: u32,
    height_px: u32,
) -> Result<Pixmap, GpuError> {
    let rgba = vec![0; 4 * width_px as usize * height_px as usize];
    let mut picture = Pixmap { width_px, height_px, rgba };
    for copy in copies {
        copy.unpack(&device, &mut picture).await?;
    }
    Ok(picture)
}

/// A texel as RGBA with straight alpha.
fn straight(texel: &[u8], format: wgpu::TextureFormat) -> [u8; 4] {
    let &[c0, c1, c2, alpha] = texel else { return [0; 4] };
    let premultiplied = if format == wgpu::TextureFormat::Bgra8Unorm { [c2, c1, c0] } else { [c0, c1, c2] };
    let whole = u32::from(alpha);
    let [r, g, b] = premultiplied.map(|c| {
        let level = (255 * u32::from(c) + whole / 2).checked_div(whole).unwrap_or(0);
        level.min(255) as u8
    });
    [r, g, b, alpha]
}

/// What a mapping has come to, and who waits for it.
#[derive(Default)]
struct Mapping {
    result: Option<Result<(), wgpu::BufferAsyncError>>,
    waker: Option<Waker>,
}

/// Maps a buffer for reading.
///
/// The device calls back: from the event loop on WebGPU, where `poll` does nothing, elsewhere from within `poll`.
pub(crate) async fn mapped(
    device: &wgpu::Device,
    buffer: &wgpu::Buffer,
) -> Result<(), wgpu::BufferAsyncError> {
    let mapping = Arc::new(Mutex::new(Mapping::default()));
    let called = Arc::clone(&mapping);
    buffer.map_async(wgpu::MapMode::Read, .., move |result| {
        let waker = {
            let mut mapping = called.lock().unwrap_or_else(PoisonError::into_inner);
            mapping.result = Some(result);
            mapping.waker.take()
        };
        waker.into_iter().for_each(Waker::wake);
    });
    if device.poll(wgpu::PollType::wait_indefinitely()).is_err() {
        return Err(wgpu::BufferAsyncError);
    }
    std::future::poll_fn(|context| {
        let mut mapping = mapping.lock().unwrap_or_else(PoisonError::into_inner);
        mapping.waker = Some(context.waker().clone());
        mapping.result.take().map_or(Poll::Pending, Poll::Ready)
    })
    .await
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::Affine;
    use wgpu::TextureFormat::{Bgra8Unorm, Rgba8Unorm};

    #[test]
    fn alpha_becomes_straight() {
        assert_eq!(straight(&[10, 20, 30, 255], Rgba8Unorm), [10, 20, 30, 255]);
        assert_eq!(straight(&[10, 20, 30, 255], Bgra8Unorm), [30, 20, 10, 255]);
        assert_eq!(straight(&[64, 128, 1, 128], Rgba8Unorm), [128, 255, 2, 128]);
        assert_eq!(straight(&[0, 0, 0, 0], Rgba8Unorm), [0; 4]);
    }

    #[test]
    fn tiles_cover_the_view_once() {
        let view = View { px_from_du: Affine::scale(3.0), width_px: 5, height_px: 4 };
        let tiles = tiles(&view, 2);
        let sizes: Vec<_> =
            tiles.iter().map(|(x, y, tile)| (*x, *y, tile.width_px, tile.height_px)).collect();
        let top = [(0, 0, 2, 2), (2, 0, 2, 2), (4, 0, 1, 2)];
        let bottom = [(0, 2, 2, 2), (2, 2, 2, 2), (4, 2, 1, 2)];
        assert_eq!(sizes, [top, bottom].concat());
        let (_, _, last) = &tiles[5];
        assert_eq!(last.px_from_du * kurbo::Point::new(2.0, 1.0), kurbo::Point::new(2.0, 1.0));
    }
}
