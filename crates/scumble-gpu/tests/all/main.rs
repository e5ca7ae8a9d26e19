//! What a device without a screen draws and solves.

mod golden;
mod solution;
