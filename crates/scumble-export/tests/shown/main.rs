//! Exported pictures as other programs show them, beside what the painter paints.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

mod made;
mod pdf;
mod svg;
