//! The grid solver of this build finds what the one on the CPU finds, in a browser.

#[path = "../../../../tests/grids/scene.rs"]
mod scene;

use scene::{SHADES, constraints};
use scumble_gpu::{Gpu, GpuGridSolver, GridKernels, instance, wgpu};
use scumble_solve::grid::{Constraints, GridSolver, PAGE_STEPS, TOLERANCE, Texel};
use wasm_bindgen_test::wasm_bindgen_test;
use web_sys::OffscreenCanvas;

/// How far apart they may be: a tenth of an 8-bit level.
const TENTH: f32 = 0.1 / 255.0;

/// A device, on WebGL for a canvas of its own.
async fn gpu() -> Gpu {
    let instance = instance();
    let canvas = OffscreenCanvas::new(16, 16).expect("a canvas");
    let surface = instance.create_surface(wgpu::SurfaceTarget::OffscreenCanvas(canvas)).expect("a surface");
    Gpu::open(&instance, Some(&surface), |error| panic!("{error}")).await.expect("a device")
}

#[wasm_bindgen_test]
async fn the_grid_solver_finds_what_its_twin_on_the_cpu_finds() {
    let gpu = gpu().await;
    let kernels = GridKernels::new(&gpu);
    // The first has levels in halves.
    for (width_px, height_px) in [(530, 520), (256, 256), (130, 97), (5, 200), (1, 1)] {
        for shades in SHADES {
            let constraints = constraints(width_px, height_px, shades);
            let mut on_gpu = GpuGridSolver::new(&gpu, &kernels, &constraints).expect("a solver");
            (0..PAGE_STEPS).for_each(|_| on_gpu.step());
            let mut on_cpu = GridSolver::new(&constraints);
            on_cpu.solve(0.1 * TOLERANCE);
            let farthest = farthest(&on_gpu.pixels().await.expect("the pixels come back"), &on_cpu.pixels());
            assert!(farthest <= TENTH, "{width_px} × {height_px}, {shades:?}: {} levels", 255.0 * farthest);
        }
    }
}

#[cfg(feature = "webgpu")]
#[wasm_bindgen_test]
async fn what_is_computed_is_what_is_drawn() {
    let constraints = constraints(130, 97, SHADES[2]);
    let drawing = Gpu { computes: false, ..gpu().await };
    let computing = Gpu { computes: true, ..drawing.clone() };
    let mut pictures = Vec::new();
    for gpu in [drawing, computing] {
        let kernels = GridKernels::new(&gpu);
        let mut solver = GpuGridSolver::new(&gpu, &kernels, &constraints).expect("a solver");
        (0..PAGE_STEPS).for_each(|_| solver.step());
        pictures.push(solver.pixels().await.expect("the pixels come back"));
    }
    let farthest = farthest(&pictures[0], &pictures[1]);
    assert!(farthest <= TENTH, "{} levels", 255.0 * farthest);
}

#[wasm_bindgen_test]
async fn what_has_changed_is_drawn_over_what_was_there() {
    let gpu = gpu().await;
    let kernels = GridKernels::new(&gpu);
    let before = constraints(130, 97, &[]);
    let mut on_gpu = GpuGridSolver::new(&gpu, &kernels, &before).expect("a solver");
    on_gpu.step();
    let mut cuts = before.cuts.clone();
    cuts.retain(|cut| cut.pixel % 130 > 20);
    cuts.iter_mut().filter_map(|cut| cut.color.as_mut()).for_each(|color| color.swap(0, 1));
    let after = Constraints { cuts, ..before };
    on_gpu.update(&kernels, &after).expect("a solver");
    (0..PAGE_STEPS).for_each(|_| on_gpu.step());
    let mut on_cpu = GridSolver::new(&after);
    on_cpu.solve(0.1 * TOLERANCE);
    let farthest = farthest(&on_gpu.pixels().await.expect("the pixels come back"), &on_cpu.pixels());
    assert!(farthest <= TENTH, "{} levels", 255.0 * farthest);
}

fn farthest(a: &[Texel], b: &[Texel]) -> f32 {
    assert_eq!(a.len(), b.len());
    a.iter().flatten().zip(b.iter().flatten()).fold(0.0, |most, (a, b)| (a - b).abs().max(most))
}
