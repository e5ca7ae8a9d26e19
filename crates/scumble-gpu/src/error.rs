//! What can go wrong with a GPU. In each case another backend, or the painter on the CPU, can still do the work.

use thiserror::Error;

/// Why a GPU cannot be used, or no longer.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum GpuError {
    /// Nothing that `wgpu` can draw with.
    #[error("no graphics adapter was found; allow hardware acceleration or install a graphics driver ({0})")]
    NoAdapter(String),
    /// There is an adapter, but it does not give what is needed.
    #[error(
        "the graphics adapter did not open; close other programs that use it, or update its driver ({0})"
    )]
    NoDevice(String),
    /// The device went away: driver reset, sleep, too many open pages.
    #[error("the graphics device was lost; open a new one and draw everything again ({0})")]
    Lost(String),
    /// The device refused a command or ran out of memory.
    #[error("the graphics device failed; open a new one and draw everything again ({0})")]
    Failed(String),
    /// Pixels could not be fetched.
    #[error("the picture could not be read from the graphics device; draw it without the GPU ({0})")]
    ReadBack(String),
    /// The device works, but draws something else.
    #[error("the graphics device draws wrong colours; use another renderer ({0})")]
    Probe(String),
}
