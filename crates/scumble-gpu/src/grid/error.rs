//! What can go wrong with the grid solver on a GPU. In each case a solver on the CPU can still do the work.

use thiserror::Error;

use crate::error::GpuError;

/// Why there is no solution. Apart from [`GpuError`], so that what only draws carries none of these sentences.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum GridError {
    /// A picture that does not fit into a texture.
    #[error(
        "the graphics device takes pictures of up to {most_px} pixels; make it smaller, or use a solver on the CPU"
    )]
    TooLarge {
        /// Longest side of a texture.
        most_px: u32,
    },
    /// The device failed, or there is none.
    #[error(transparent)]
    Gpu(#[from] GpuError),
}
