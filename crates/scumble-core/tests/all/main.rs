//! What the core computes, by its public functions.

mod boundary;
mod coloring;
mod edit;
mod global;
mod odd_scribbles;
mod planar_map;
mod progressive;
mod sight;
