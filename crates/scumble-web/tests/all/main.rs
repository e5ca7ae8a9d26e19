//! What the page does, without a browser.
#![cfg(not(target_arch = "wasm32"))]

mod close;
mod edits;
mod followed;
mod making;
mod page;
mod select;
mod session;
mod shading;
mod solver;
mod stroke;
mod tools;
mod turned;
mod zigzags;
