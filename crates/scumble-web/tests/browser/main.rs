//! The page's module, and what it draws, in a browser.
#![cfg(target_arch = "wasm32")]

mod golden;
mod grids;
mod web;

wasm_bindgen_test::wasm_bindgen_test_configure!(run_in_browser);
