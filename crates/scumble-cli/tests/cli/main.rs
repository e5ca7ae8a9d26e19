//! The program as a user meets it: run as a process of its own, in a folder of its own.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod bad_input;
mod color;
mod corpus;
mod curves;
mod eval;
mod exports;
mod folder;
mod palettes;
mod samples;
mod share;
