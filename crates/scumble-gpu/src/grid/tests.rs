//! Every kernel draws what its twin on the CPU computes. Needs a graphics driver; Mesa's software one is enough.

#[path = "../../../../tests/grids/scene.rs"]
mod scene;

use kurbo::{BezPath, Circle, Shape, Vec2};
use scumble_solve::grid::{
    Constraints, GridSolver, Hierarchy, Level, STEPS, Texel, Texture, kernels as twin,
};

use super::kernels::Kernel;
use super::levels::{GpuLevels, matrix};
use super::reduction::Reduction;
use super::tape::Recorder;
use super::texels::{read, single, target, uploaded};
use super::*;
use scene::{SHADES, boundary, constraints, map, view};

/// A tenth of an 8-bit level.
const TENTH: f32 = 0.1 / 255.0;

/// An open device, or `None`, said aloud, where there is none.
fn gpu() -> Option<Gpu> {
    let failed = |error: GpuError| panic!("{error}");
    pollster::block_on(Gpu::headless(failed)).map_err(|error| eprintln!("skipped: {error}")).ok()
}

/// Numbers from −1 to 1 without a pattern: Fibonacci hashing (D. E. Knuth, *The Art of Computer Programming* 3, 6.4).
fn noise(width: usize, height: usize, seed: u32) -> Texture {
    let number = |i: u32| {
        (i.wrapping_mul(0x9e37_79b9) ^ seed.wrapping_mul(0x85eb_ca6b)) as i32 as f32 / 2_f32.powi(31)
    };
    let texels = (0..(width * height) as u32).map(|i| [0, 1, 2, 3].map(|c| number(4 * i + c)));
    Texture { width, height, texels: texels.collect() }
}

fn noise_like(level: &Level, seed: u32) -> Texture {
    noise(level.holds.width, level.holds.height, seed)
}

fn computed(like: &Level, kernel: impl Fn(i32, i32) -> Texel) -> Texture {
    let mut texture = Texture::new(like.holds.width, like.holds.height);
    texture.draw(kernel);
    texture
}

/// Kernels on a device.
struct Bench {
    gpu: Gpu,
    kernels: Kernels,
}

impl Bench {
    fn new() -> Option<Self> {
        let gpu = gpu()?;
        Some(Self { kernels: Kernels::new(&gpu.device), gpu })
    }

    /// What a kernel draws.
    fn drawn(&self, level: &Level, kernel: Kernel, operands: &[&Texture], like: &Level) -> Vec<Texel> {
        let zero = single(&self.gpu, 0.0);
        let matrix = matrix(&self.gpu, &self.kernels, level, &zero);
        let operands: Vec<_> = operands.iter().map(|texture| uploaded(&self.gpu, texture)).collect();
        let target = target(&self.gpu, like.holds.width as u32, like.holds.height as u32);
        let mut recorder = Recorder::new(&self.gpu, &self.kernels);
        recorder.pass_on(&matrix, kernel, &operands.iter().collect::<Vec<_>>(), &target);
        recorder.take().play(&self.gpu);
        self.read(&target)
    }

    fn read(&self, view: &wgpu::TextureView) -> Vec<Texel> {
        pollster::block_on(read(&self.gpu, view)).expect("the texels come back")
    }
}

/// Checks that numbers are the same to a part of the largest.
fn assert_near(drawn: &[Texel], expected: &[Texel], part: f32, name: &str) {
    let largest = expected.iter().flatten().fold(0.0_f32, |largest, c| largest.max(c.abs()));
    assert!(largest > 0.0, "{name}: nothing to compare");
    assert_eq!(drawn.len(), expected.len(), "{name}");
    for (i, (drawn, expected)) in drawn.iter().zip(expected).enumerate() {
        let is_near = drawn.iter().zip(expected).all(|(a, b)| (a - b).abs() <= part * largest);
        assert!(is_near, "{name}: {drawn:?} instead of {expected:?} at {i}");
    }
}

/// Levels that have all kinds of links; the coarsest, where colours hold everything, have none.
const LEVELS: usize = 5;

/// How much of the largest number rounding may cost.
const ROUNDING: f32 = 1e-6;

#[test]
fn kernels_within_a_level_draw_what_their_twins_compute() {
    let Some(bench) = Bench::new() else { return };
    for (depth, level) in Hierarchy::new(&constraints(130, 97, &[])).levels.iter().take(LEVELS).enumerate() {
        let (values, right) = (noise_like(level, 1), noise_like(level, 2));
        let part = Texture { width: 1, height: 1, texels: vec![[STEPS[0]; 4]] };
        let check = |kernel, operands: &[&Texture], twin: &dyn Fn(i32, i32) -> Texel| {
            let drawn = bench.drawn(level, kernel, operands, level);
            assert_near(&drawn, &computed(level, twin).texels, ROUNDING, &format!("{kernel:?} at {depth}"));
        };
        let (v, r) = (&values, &right);
        check(Kernel::Multiply, &[v], &|x, y| twin::multiply(level, v, x, y));
        check(Kernel::Residual, &[v, r], &|x, y| twin::residual(level, v, r, x, y));
        check(Kernel::Relax, &[v, r, &part], &|x, y| twin::relax(level, v, r, STEPS[0], x, y));
        check(Kernel::Start, &[r, &part], &|x, y| twin::start(level, r, STEPS[0], x, y));
    }
}

#[test]
fn kernels_between_levels_draw_what_their_twins_compute() {
    let Some(bench) = Bench::new() else { return };
    for (depth, pair) in Hierarchy::new(&constraints(130, 97, &[])).levels[..=LEVELS].windows(2).enumerate() {
        let [fine, coarse] = pair else { unreachable!("windows of two") };
        let (values, below) = (noise_like(fine, 1), noise_like(coarse, 2));
        let check = |kernel, operands: &[&Texture], like, twin: &dyn Fn(i32, i32) -> Texel| {
            let drawn = bench.drawn(fine, kernel, operands, like);
            assert_near(&drawn, &computed(like, twin).texels, ROUNDING, &format!("{kernel:?} at {depth}"));
        };
        let (v, b) = (&values, &below);
        check(Kernel::Restrict, &[v], coarse, &|x, y| twin::restrict(fine, coarse, v, x, y));
        check(Kernel::Interpolate, &[v, b], fine, &|x, y| twin::interpolate(fine, v, b, x, y));
        check(Kernel::Spread, &[v, b], fine, &|x, y| twin::spread(fine, v, b, x, y));
    }
}

#[test]
fn a_picture_is_covered_as_the_twin_covers_it() {
    let Some(bench) = Bench::new() else { return };
    let [under, colors, covers] = [1, 2, 3].map(|seed| noise(130, 97, seed));
    let mut covered = Texture::new(130, 97);
    covered.draw(|x, y| twin::cover(&under, &colors, &covers, x, y));
    let target = target(&bench.gpu, 130, 97);
    let operands = [under, colors, covers].map(|texture| uploaded(&bench.gpu, &texture));
    let mut recorder = Recorder::new(&bench.gpu, &bench.kernels);
    recorder.pass(Kernel::Cover, &operands.each_ref(), &target);
    recorder.take().play(&bench.gpu);
    assert_near(&bench.read(&target), &covered.texels, ROUNDING, "Cover");
}

#[test]
fn reductions_take_every_texel_once() {
    let Some(Bench { gpu, kernels }) = Bench::new() else { return };
    for (width, height) in [(1, 1), (8, 8), (9, 3), (64, 65), (200, 130)] {
        let (mut a, b) = (noise(width, height, 3), noise(width, height, 4));
        a.texels.iter_mut().rev().take(1).for_each(|last| *last = [2.0, -2.0, 3.0, -3.0]);
        let reduction = Reduction::new(&gpu, width as u32, height as u32);
        let (views, [dot, largest]) =
            ([&a, &b].map(|t| uploaded(&gpu, t)), [(); 2].map(|()| single(&gpu, 0.0)));
        let mut recorder = Recorder::new(&gpu, &kernels);
        reduction.dot(&mut recorder, [&views[0], &views[1]], &dot);
        reduction.largest(&mut recorder, &views[0], &largest);
        recorder.take().play(&gpu);
        let [dot, largest] =
            [dot, largest].map(|view| pollster::block_on(read(&gpu, &view)).expect("a texel")[0]);
        for c in 0..4 {
            let products = || a.texels.iter().zip(&b.texels).map(|(a, b)| f64::from(a[c]) * f64::from(b[c]));
            let (sum, size): (f64, f64) = (products().sum(), products().map(f64::abs).sum());
            assert!((f64::from(dot[c]) - sum).abs() <= 1e-6 * size, "{width} × {height}: {} {sum}", dot[c]);
            assert_eq!(largest[c], a.texels.iter().fold(0.0, |most, texel| texel[c].abs().max(most)));
        }
    }
}

#[test]
fn a_cycle_draws_what_the_one_on_the_cpu_computes() {
    let Some(Bench { gpu, kernels }) = Bench::new() else { return };
    let mut hierarchy = Hierarchy::new(&constraints(130, 97, &[]));
    let right = noise_like(&hierarchy.levels[0], 5);
    let mut levels = GpuLevels::new(&gpu, &kernels, &hierarchy);
    levels.levels[0].right = uploaded(&gpu, &right);
    let mut recorder = Recorder::new(&gpu, &kernels);
    levels.cycle_from_zero(&mut recorder, 0);
    recorder.take().play(&gpu);
    let drawn = pollster::block_on(read(&gpu, &levels.levels[0].values)).expect("the texels come back");
    assert_near(&drawn, &hierarchy.precondition(&right).texels, 1e-5, "a cycle");
}

fn farthest(a: &[Texel], b: &[Texel]) -> f32 {
    a.iter().flatten().zip(b.iter().flatten()).fold(0.0, |most, (a, b)| (a - b).abs().max(most))
}

/// Solves on both, to a step that changes nothing by more than a tolerance, and compares.
fn assert_same_picture(gpu: &Gpu, constraints: &Constraints, tolerance: f32) {
    let size = [constraints.width_px, constraints.height_px];
    let mut on_cpu = GridSolver::new(constraints);
    let mut on_gpu = GpuGridSolver::new(gpu, &Kernels::new(&gpu.device), constraints).expect("a solver");
    let pixels = |solver: &GpuGridSolver| pollster::block_on(solver.pixels()).expect("the pixels come back");
    let start = farthest(&pixels(&on_gpu), &on_cpu.pixels());
    assert!(start <= TENTH, "{size:?}: {start} at first");
    let steps = on_cpu.solve(tolerance);
    let gpu_steps = pollster::block_on(on_gpu.solve(tolerance)).expect("a solution");
    assert!(steps.abs_diff(gpu_steps) <= 1, "{size:?}: {gpu_steps} instead of {steps} steps");
    let end = farthest(&pixels(&on_gpu), &on_cpu.pixels());
    assert!(end <= TENTH, "{size:?}: {end} after {steps} steps");
}

#[test]
fn pictures_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    for (width_px, height_px) in [(256, 256), (130, 97), (5, 200), (1, 1)] {
        for (layers, shades) in SHADES.into_iter().enumerate() {
            let constraints = constraints(width_px, height_px, shades);
            let covers = constraints.covers.as_ref();
            assert_eq!(covers.map_or(0, |covers| 1 + usize::from(covers.parts.is_some())), layers);
            assert_same_picture(&gpu, &constraints, TENTH);
        }
    }
}

/// Many steps, in which the sums of the GPU, which has no doubles, might lead elsewhere.
#[test]
fn a_spiral_of_barriers_is_that_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    let center = Vec2::new(512.0, 512.0);
    let at = |i: u32| (center + f64::from(20 + i) * Vec2::from_angle(f64::from(i) / 12.0)).to_point();
    let mut spiral = BezPath::new();
    spiral.move_to(at(0));
    (1..460).for_each(|i| spiral.line_to(at(i)));
    let ends = [10.0, 500.0].map(|radius| Circle::new((512.0, 512.0), radius).to_path(1e-3));
    let map = map(ends.into_iter().chain([spiral]));
    let colors = boundary(&map, &[[0.2, 0.9], [0.7, 0.4]]);
    assert_same_picture(
        &gpu,
        &Constraints::new(&map, &colors, &view(192, 192)).expect("solved"),
        0.01 * TENTH,
    );
}

#[test]
fn a_picture_that_no_texture_holds_is_refused() {
    let Some(gpu) = gpu() else { return };
    let most_px = gpu.device.limits().max_texture_dimension_2d;
    let kernels = Kernels::new(&gpu.device);
    let wide = Constraints { width_px: most_px + 1, height_px: 1, ..constraints(1, 1, &[]) };
    let solver = GpuGridSolver::new(&gpu, &kernels, &wide);
    assert_eq!(solver.err(), Some(GridError::TooLarge { most_px }));
}
