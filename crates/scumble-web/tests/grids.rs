//! The grid solver of this build finds what the one on the CPU finds, in a browser.
#![cfg(target_arch = "wasm32")]

use kurbo::{Affine, BezPath, Circle, Point, Rect, Shape};
use scumble_core::{Boundary, Curve, Drawing, PlanarMap, Sampling, SoftSource};
use scumble_gpu::{Gpu, GpuGridSolver, GridKernels, instance, wgpu};
use scumble_solve::View;
use scumble_solve::grid::{Constraints, GridSolver, PAGE_STEPS, TOLERANCE};
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};
use web_sys::OffscreenCanvas;

wasm_bindgen_test_configure!(run_in_browser);

/// How far apart they may be: a tenth of an 8-bit level.
const TENTH: f32 = 0.1 / 255.0;

/// A device, on WebGL for a canvas of its own.
async fn gpu() -> Gpu {
    let instance = instance();
    let canvas = OffscreenCanvas::new(16, 16).expect("a canvas");
    let surface = instance.create_surface(wgpu::SurfaceTarget::OffscreenCanvas(canvas)).expect("a surface");
    Gpu::open(&instance, Some(&surface), |error| panic!("{error}")).await.expect("a device")
}

/// Circles that overlap, with colours on both sides, a barrier across them, and a stroke that shades.
fn constraints(width_px: u32, height_px: u32) -> Constraints {
    let mut barrier = BezPath::new();
    barrier.move_to((100.0, 130.0));
    barrier.curve_to((400.0, 900.0), (600.0, 100.0), (930.0, 700.0));
    let circles = [(400.0, 400.0, 230.0), (600.0, 500.0, 250.0), (150.0, 850.0, 60.0)];
    let circles = circles.map(|(x, y, radius)| Circle::new((x, y), radius).to_path(1e-3));
    let curves = circles.into_iter().chain([barrier]).map(|path| Curve { path, line: None }).collect();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
    let map = PlanarMap::build(&drawing, &Sampling::default()).expect("a map");
    let stroke = [(250.0, 300.0), (700.0, 650.0)].map(Point::from).to_vec();
    let source = SoftSource {
        points: stroke,
        radius_du: 60.0,
        weight: 20.0,
        color: [0.5; 4],
        crosses: true,
        parts: Vec::new(),
    };
    let boundary = Boundary { sources: vec![source], ..boundary(&map) };
    let view = View { px_from_du: Affine::scale(f64::from(width_px) / 1024.0), width_px, height_px };
    Constraints::new(&map, &boundary, &view)
}

fn boundary(map: &PlanarMap) -> Boundary {
    let mut sides = vec![None; map.side_count()];
    for (curve, colors) in [[0.2, 0.9], [0.7, 0.4], [0.1, 1.0]].into_iter().enumerate() {
        for step in map.steps(curve) {
            for (side, value) in [step.left, step.left.opposite()].into_iter().zip(colors) {
                sides[side.index()] = Some([[value, 1.0 - value, 0.5 * value, 1.0]; 3]);
            }
        }
    }
    sides.into()
}

#[wasm_bindgen_test]
async fn the_grid_solver_finds_what_its_twin_on_the_cpu_finds() {
    let gpu = gpu().await;
    let kernels = GridKernels::new(&gpu.device);
    for (width_px, height_px) in [(256, 256), (130, 97), (5, 200), (1, 1)] {
        let constraints = constraints(width_px, height_px);
        let mut on_gpu = GpuGridSolver::new(&gpu, &kernels, &constraints).expect("a solver");
        (0..PAGE_STEPS).for_each(|_| on_gpu.step());
        let mut on_cpu = GridSolver::new(&constraints);
        on_cpu.solve(0.1 * TOLERANCE);
        let pixels = on_gpu.pixels().await.expect("the pixels come back");
        assert_eq!(pixels.len(), on_cpu.pixels().len());
        let pairs = pixels.iter().flatten().zip(on_cpu.pixels().iter().flatten());
        let farthest = pairs.fold(0.0_f32, |most, (a, b)| (a - b).abs().max(most));
        assert!(farthest <= TENTH, "{width_px} × {height_px}: {} levels", 255.0 * farthest);
    }
}
