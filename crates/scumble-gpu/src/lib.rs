//! The painter on the GPU: what `scumble_solve::paint` does on the CPU, on WebGPU, WebGL2 and Vulkan through `wgpu`.
//!
//! | noun | file |
//! |---|---|
//! | an open device | [`gpu`] |
//! | a scene on the GPU, drawn | [`renderer`] |
//! | pixels on their way back | `read_back` |
//! | Laplace's equation on pixels | [`grid`] |
//! | whether a device draws what it should | [`probe`] |
//! | lists of things to draw, on the GPU | `items` |
//! | the textures that are drawn in | `samples` |
//! | how each kind of thing is drawn | `pipelines`, `shaders`, `wgsl` |
//!
//! Everything is drawn multisampled into textures that hold sRGB-encoded bytes and never convert, so that colours mix
//! in sRGB as they do on the CPU, and so that both builds for the web show the same bytes.

pub mod error;
pub mod gpu;
pub mod grid;
mod items;
mod pipelines;
pub mod probe;
mod read_back;
pub mod renderer;
mod samples;
mod shaders;
mod wgsl;

pub use error::GpuError;
pub use gpu::{Gpu, instance, surface_format};
pub use grid::{GpuGridSolver, GridError, Kernels as GridKernels};
pub use probe::probe;
pub use renderer::{Layer, Renderer};
pub use wgpu;
