//! The renderer of this build draws what the painter on the CPU paints, in a browser.

#[path = "../../../../tests/golden/scenes.rs"]
mod scenes;

use scumble_gpu::{Gpu, Layer, Renderer, instance, probe, surface_format, wgpu};
use scumble_solve::FieldChange;
use wasm_bindgen_test::wasm_bindgen_test;
use web_sys::OffscreenCanvas;

/// A renderer for a canvas of its own.
async fn renderer() -> Renderer {
    let instance = instance();
    let canvas = OffscreenCanvas::new(16, 16).expect("a canvas");
    let surface = instance.create_surface(wgpu::SurfaceTarget::OffscreenCanvas(canvas)).expect("a surface");
    let gpu = Gpu::open(&instance, Some(&surface), |error| panic!("{error}")).await.expect("a device");
    let format = surface_format(&surface.get_capabilities(&gpu.adapter)).expect("a format that stores bytes");
    Renderer::new(&gpu, format)
}

#[wasm_bindgen_test]
async fn golden_scenes_are_drawn_as_they_are_painted() {
    let mut renderer = renderer().await;
    for golden in scenes::all() {
        renderer.set_field(&golden.field, &FieldChange::ALL);
        renderer.set_shapes(Layer::Ink, &golden.ink);
        renderer.set_shapes(Layer::Scribbles, &golden.scribbles);
        let drawn = renderer.read_back(&golden.view, golden.paper).await.expect("the pixels come back");
        assert_eq!(golden.differences(&drawn), None);
    }
}

#[wasm_bindgen_test]
async fn the_probe_passes() {
    assert_eq!(probe(&mut renderer().await).await, Ok(()));
}
