//! An open graphics device, with no more features and limits than the renderer uses.

use std::sync::Arc;

use crate::error::GpuError;
#[cfg(any(not(target_os = "unknown"), feature = "webgpu"))]
use crate::grid::computing;

/// A device and where it came from. The handles are counted: clones are cheap and mean the same device.
#[derive(Clone, Debug)]
pub struct Gpu {
    /// What the device runs on.
    pub adapter: wgpu::Adapter,
    /// Makes buffers, textures and pipelines.
    pub device: wgpu::Device,
    /// Takes commands and data.
    pub queue: wgpu::Queue,
    /// Whether passes of the grid solver are computed; else they are drawn.
    pub computes: bool,
}

/// The entry to `wgpu`.
///
/// On WebGL nothing can be waited for; there pixels are fetched in the order of the commands, so fences that finish
/// at once are right.
pub fn instance() -> wgpu::Instance {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backend_options.gl.fence_behavior = wgpu::GlFenceBehavior::AutoFinish;
    wgpu::Instance::new(descriptor)
}

/// The first format of a surface that stores bytes as they are; the renderer does the sRGB encoding itself.
pub fn surface_format(capabilities: &wgpu::SurfaceCapabilities) -> Option<wgpu::TextureFormat> {
    use wgpu::TextureFormat::{Bgra8Unorm, Rgba8Unorm};
    capabilities.formats.iter().copied().find(|format| matches!(format, Rgba8Unorm | Bgra8Unorm))
}

impl Gpu {
    /// Opens a device that draws into textures alone, on any platform.
    ///
    /// # Errors
    /// When there is none.
    pub async fn headless(on_failure: impl Fn(GpuError) + Send + Sync + 'static) -> Result<Self, GpuError> {
        if wgpu::Instance::enabled_backend_features().is_empty() {
            return Err(GpuError::NoAdapter("no graphics interface on this platform".to_owned()));
        }
        Self::open(&instance(), None, on_failure).await
    }

    /// Opens a device, on WebGL for one surface, elsewhere for any.
    ///
    /// `on_failure` hears when the device is lost or fails later: everything must then be built anew. It may be
    /// called in the middle of any call into `wgpu`, so it should only make a note.
    pub async fn open(
        instance: &wgpu::Instance,
        surface: Option<&wgpu::Surface<'_>>,
        on_failure: impl Fn(GpuError) + Send + Sync + 'static,
    ) -> Result<Self, GpuError> {
        let options = wgpu::RequestAdapterOptions { compatible_surface: surface, ..Default::default() };
        let adapter = instance.request_adapter(&options).await;
        let adapter = adapter.map_err(|error| GpuError::NoAdapter(error.to_string()))?;
        let opened = adapter.request_device(&device_descriptor(&adapter)).await;
        let (device, queue) = opened.map_err(|error| GpuError::NoDevice(error.to_string()))?;
        watch(&device, on_failure);
        let computes = !IS_WEBGL && device.limits().max_compute_invocations_per_workgroup > 0;
        Ok(Self { adapter, device, queue, computes })
    }

    /// Whether there is no card: what draws is the processor.
    pub fn is_software(&self) -> bool {
        self.adapter.get_info().device_type == wgpu::DeviceType::Cpu
    }
}

/// Whether what draws is WebGL, which computes nothing.
const IS_WEBGL: bool = cfg!(all(target_os = "unknown", not(feature = "webgpu")));

/// Whether a device is destroyed when nobody uses it any more. In WebGPU it is not: what is destroyed there is gone under
/// its users.
const IS_DESTROYED_IF_DROPPED: bool = !cfg!(all(target_arch = "wasm32", feature = "webgpu"));

/// WebGL2's limits, but the adapter's texture size, and one colour attachment, as some adapters have few; and what computing
/// takes, where that can be had.
fn device_descriptor(adapter: &wgpu::Adapter) -> wgpu::DeviceDescriptor<'static> {
    let limits = wgpu::Limits::downlevel_webgl2_defaults().using_resolution(adapter.limits());
    let limits = wgpu::Limits { max_color_attachments: 1, ..limits };
    #[cfg(all(target_os = "unknown", feature = "webgpu"))]
    let limits = computing::limits(limits);
    #[cfg(not(target_os = "unknown"))]
    let limits = computing::most_limits(limits, &adapter.limits());
    wgpu::DeviceDescriptor { label: Some("scumble"), required_limits: limits, ..Default::default() }
}

fn watch(device: &wgpu::Device, on_failure: impl Fn(GpuError) + Send + Sync + 'static) {
    let on_failure = Arc::new(on_failure);
    let on_error = Arc::clone(&on_failure);
    device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| {
        on_error(GpuError::Failed(error.to_string()));
    }));
    device.set_device_lost_callback(move |reason, message| {
        if reason != wgpu::DeviceLostReason::Destroyed || !IS_DESTROYED_IF_DROPPED {
            on_failure(GpuError::Lost(message));
        }
    });
}
