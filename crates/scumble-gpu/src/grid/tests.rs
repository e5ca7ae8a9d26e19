//! Every kernel, drawn or computed, makes what its twin on the CPU computes. Needs a graphics driver; Mesa's software one is
//! enough.

#[path = "../../../../tests/grids/scene.rs"]
mod scene;

use kurbo::{BezPath, Circle, Shape, Vec2};
use scumble_solve::grid::{
    Constraints, Cut, Face, GridSolver, Hierarchy, Level, Link, Pull, STEPS, Size, Texel, Texture,
    kernels as twin,
};

use super::computing::Programs;
use super::equations::Equations;
use super::kernels::Kernel;
use super::levels::{GpuLevel, GpuLevels};
use super::reduction::Reduction;
use super::tape::Recorder;
use super::texels::{FORMAT, HALF_FORMAT, read, single, target, uploaded};
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
        Some(Self { kernels: Kernels::new(&gpu), gpu })
    }

    /// One that computes, where there is a device for it, and one that draws, as all do on WebGL.
    fn both() -> Vec<Self> {
        let Some(gpu) = gpu() else { return Vec::new() };
        let limits = wgpu::Limits::downlevel_webgl2_defaults().using_resolution(gpu.adapter.limits());
        let required_limits = wgpu::Limits { max_color_attachments: 1, ..limits };
        let descriptor = wgpu::DeviceDescriptor { required_limits, ..Default::default() };
        let opened = pollster::block_on(gpu.adapter.request_device(&descriptor));
        let (device, queue) = opened.expect("a device that draws alone");
        let drawing = Gpu { adapter: gpu.adapter.clone(), device, queue, computes: false };
        assert!(gpu.computes);
        [gpu, drawing].map(|gpu| Self { kernels: Kernels::new(&gpu), gpu }).into()
    }

    /// The levels of a problem, built.
    fn levels(&self, constraints: &Constraints) -> GpuLevels {
        let equations = Equations::new(&self.gpu, &self.kernels, constraints);
        let sizes = Size::levels(constraints);
        let levels = GpuLevels::new(&self.gpu, &self.kernels, &equations, &sizes);
        let mut recorder = Recorder::new(&self.gpu, &self.kernels);
        levels.build(&mut recorder);
        levels.gather(&mut recorder);
        recorder.take().play(&self.gpu);
        levels
    }

    /// What a kernel draws.
    fn drawn(&self, level: &GpuLevel, kernel: Kernel, operands: &[&Texture], like: &Level) -> Vec<Texel> {
        let operands: Vec<_> = operands.iter().map(|texture| uploaded(&self.gpu, texture)).collect();
        let marks = matches!(kernel, Kernel::Collect).then_some(&level.marks);
        let operands: Vec<_> = operands.iter().chain(marks).collect();
        let target = target(&self.gpu, [like.holds.width as u32, like.holds.height as u32], FORMAT);
        let mut recorder = Recorder::new(&self.gpu, &self.kernels);
        recorder.pass_on(&level.matrix, kernel, &operands, &target);
        recorder.take().play(&self.gpu);
        self.read(&target)
    }

    /// Checks that a kernel, at some depth, draws what its twin computes.
    fn assert_twin(
        &self,
        level: &GpuLevel,
        (kernel, depth): (Kernel, usize),
        operands: &[&Texture],
        like: &Level,
        twin: &dyn Fn(i32, i32) -> Texel,
    ) {
        let drawn = self.drawn(level, kernel, operands, like);
        assert_near(&drawn, &computed(like, twin).texels, ROUNDING, &format!("{kernel:?} at {depth}"));
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

/// The built levels of a problem with all kinds of links, and those on the CPU.
fn levels(bench: &Bench) -> (GpuLevels, Hierarchy) {
    let constraints = constraints(130, 97, &[]);
    (bench.levels(&constraints), Hierarchy::new(&constraints))
}

#[test]
fn kernels_within_a_level_draw_what_their_twins_compute() {
    for bench in Bench::both() {
        let (built, hierarchy) = levels(&bench);
        for (depth, (level, drawn)) in hierarchy.levels.iter().zip(&built.levels).take(LEVELS).enumerate() {
            let (values, right) = (noise_like(level, 1), noise_like(level, 2));
            let single = |texel| Texture { width: 1, height: 1, texels: vec![texel] };
            let (part, parts) = (single([STEPS[0]; 4]), single([STEPS[0], STEPS[1], 0.0, 0.0]));
            let check = |kernel, operands: &[&Texture], twin: &dyn Fn(i32, i32) -> Texel| {
                bench.assert_twin(drawn, (kernel, depth), operands, level, twin);
            };
            let (v, r) = (&values, &right);
            check(Kernel::Multiply, &[v], &|x, y| twin::multiply(level, v, x, y));
            check(Kernel::Residual, &[v, r], &|x, y| twin::residual(level, v, r, x, y));
            check(Kernel::Relax, &[v, r, &part], &|x, y| twin::relax(level, v, r, STEPS[0], x, y));
            check(Kernel::Start, &[r, &parts], &|x, y| twin::start(level, r, STEPS, x, y));
        }
    }
}

#[test]
fn restriction_is_the_transpose_of_interpolation() {
    let hierarchy = Hierarchy::new(&constraints(130, 97, &[]));
    for pair in hierarchy.levels[..=LEVELS].windows(2) {
        let [fine, coarse] = pair else { unreachable!() };
        let (residual, below) = (noise_like(fine, 1), noise_like(coarse, 2));
        let none = Texture::new(residual.width, residual.height);
        let shares = computed(fine, |x, y| twin::restrict(fine, &residual, x, y));
        let restricted = computed(coarse, |x, y| twin::collect(fine, coarse, &shares, x, y));
        let interpolated = computed(fine, |x, y| twin::interpolate(fine, &none, &below, x, y));
        let [[one, scale], [other, _]] =
            [(&restricted, &below), (&residual, &interpolated)].map(|(a, b)| product(a, b));
        assert!(scale > 0.0 && (one - other).abs() <= f64::from(ROUNDING) * scale, "{one} and {other}");
    }
}

/// The product of what is in the first channel, and that of its sizes.
fn product(a: &Texture, b: &Texture) -> [f64; 2] {
    let terms = a.texels.iter().zip(&b.texels).map(|(a, b)| f64::from(a[0]) * f64::from(b[0]));
    terms.fold([0.0; 2], |[sum, scale], term| [sum + term, scale + term.abs()])
}

#[test]
fn kernels_between_levels_draw_what_their_twins_compute() {
    for bench in Bench::both() {
        let (built, hierarchy) = levels(&bench);
        for (depth, pair) in hierarchy.levels[..=LEVELS].windows(2).enumerate() {
            let [fine, coarse] = pair else { unreachable!() };
            let (values, below) = (noise_like(fine, 1), noise_like(coarse, 2));
            let check = |kernel, operands: &[&Texture], like: &Level, twin: &dyn Fn(i32, i32) -> Texel| {
                bench.assert_twin(&built.levels[depth], (kernel, depth), operands, like, twin);
            };
            let (v, b) = (&values, &below);
            check(Kernel::Restrict, &[v], fine, &|x, y| twin::restrict(fine, v, x, y));
            check(Kernel::Gather, &[v], fine, &|x, y| twin::gather(fine, v, x, y));
            check(Kernel::Collect, &[v], coarse, &|x, y| twin::collect(fine, coarse, v, x, y));
            check(Kernel::Interpolate, &[v, b], fine, &|x, y| twin::interpolate(fine, v, b, x, y));
            check(Kernel::Spread, &[v, b], fine, &|x, y| twin::spread(fine, v, b, x, y));
        }
    }
}

/// Two halves, each held to a colour, with a wall between that has a narrow gap: links within cells.
fn halves() -> Constraints {
    let wall = |row: u32| {
        [(30, Link::East), (31, Link::West)].map(|(column, link)| Cut {
            pixel: 64 * row + column,
            link,
            fraction: 0.5,
            color: None,
        })
    };
    let pull = |pixel, c: f32| Pull { pixel, strength: 1.0, color: [c, 1.0 - c, 0.5, 1.0] };
    Constraints {
        width_px: 64,
        height_px: 64,
        cuts: (0..64).filter(|row| *row != 21).flat_map(wall).collect(),
        faces: vec![Face { pixel: 64 * 21 + 30, link: Link::East, width: 0.03 }],
        pulls: vec![pull(64 * 5 + 5, 0.2), pull(64 * 60 + 60, 0.9)],
        sources: Vec::new(),
        exits: Vec::new(),
        covers: None,
    }
}

/// Numbers of a level where there are some, compared.
fn assert_alike(drawn: &[Texel], expected: &Texture, name: &str) -> bool {
    let is_some = expected.texels.iter().flatten().any(|c| *c != 0.0);
    match is_some {
        true => assert_near(drawn, &expected.texels, ROUNDING, name),
        false => assert_eq!(drawn, expected.texels, "{name}"),
    }
    is_some
}

/// The links of pixels, of which the GPU keeps a number each, are compared by what kernels make of them.
#[test]
fn levels_are_built_as_on_the_cpu() {
    for bench in Bench::both() {
        let mut has_links = [false; 3];
        for constraints in [constraints(130, 97, &[]), halves()] {
            let (built, hierarchy) = (bench.levels(&constraints), Hierarchy::new(&constraints));
            assert_eq!(built.levels.len(), hierarchy.levels.len());
            for (depth, (level, drawn)) in hierarchy.levels.iter().zip(&built.levels).enumerate() {
                let check = |name: &str, view: &wgpu::TextureView, expected: &Texture| {
                    assert_alike(&bench.read(view), expected, &format!("{name} at {depth}"))
                };
                check("holds", &drawn.matrix.holds, &level.holds);
                check("given", &drawn.right, &hierarchy.given[depth]);
                let links = drawn.matrix.links.iter().zip([&level.east, &level.south, &level.within]);
                for (has, (drawn, expected)) in has_links.iter_mut().zip(links).filter(|_| depth > 0) {
                    *has |= check("links", drawn, expected);
                }
            }
        }
        assert_eq!(has_links, [true; 3], "links of all kinds");
    }
}

#[test]
fn a_picture_is_covered_as_the_twin_covers_it() {
    for bench in Bench::both() {
        let [under, colors, covers] = [1, 2, 3].map(|seed| noise(130, 97, seed));
        let mut covered = Texture::new(130, 97);
        covered.draw(|x, y| twin::cover(&under, &colors, &covers, x, y));
        let target = target(&bench.gpu, [130, 97], FORMAT);
        let operands = [under, colors, covers].map(|texture| uploaded(&bench.gpu, &texture));
        let mut recorder = Recorder::new(&bench.gpu, &bench.kernels);
        recorder.pass(Kernel::Cover, &operands.each_ref(), &target);
        recorder.take().play(&bench.gpu);
        assert_near(&bench.read(&target), &covered.texels, ROUNDING, "Cover");
    }
}

/// What comes back of a texel that a kernel has written as halves.
fn halved(Bench { gpu, kernels }: &Bench, texel: Texel) -> Texel {
    let [from, zero, one] =
        [texel, [0.0; 4], [1.0; 4]].map(|texel| Texture { width: 1, height: 1, texels: vec![texel] });
    let [from, zero, one] = [from, zero, one].map(|texture| uploaded(gpu, &texture));
    let [halves, floats] = [HALF_FORMAT, FORMAT].map(|format| target(gpu, [1, 1], format));
    let mut recorder = Recorder::new(gpu, kernels);
    recorder.pass(Kernel::Advance, &[&zero, &from, &one], &halves);
    recorder.pass(Kernel::Advance, &[&zero, &halves, &one], &floats);
    recorder.take().play(gpu);
    pollster::block_on(read(gpu, &floats)).expect("a texel")[0]
}

#[test]
fn halves_have_ten_digits_and_no_infinity() {
    for bench in Bench::both() {
        for texel in [[0.1, -0.7, 200.3, 0.0], [1e-3, -3e-5, 1.0, 4.0], [1e-9, -2e-13, 9e4, -1e5], [0.0; 4]] {
            for (half, float) in halved(&bench, texel).into_iter().zip(texel) {
                assert!((half - float).abs() <= float.abs() / 1024.0, "{half} {float}");
            }
        }
        let limits = halved(&bench, [1e-15, -1e-30, 1e9, -f32::INFINITY]);
        assert!(limits[..2].iter().all(|least| least.abs() < 1e-14), "{limits:?}");
        assert_eq!(limits[2..], [130_944.0, -130_944.0]);
    }
}

#[test]
fn reductions_take_every_texel_once() {
    for Bench { gpu, kernels } in Bench::both() {
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
                let products =
                    || a.texels.iter().zip(&b.texels).map(|(a, b)| f64::from(a[c]) * f64::from(b[c]));
                let (sum, size): (f64, f64) = (products().sum(), products().map(f64::abs).sum());
                assert!(
                    (f64::from(dot[c]) - sum).abs() <= 1e-6 * size,
                    "{width} × {height}: {} {sum}",
                    dot[c]
                );
                assert_eq!(largest[c], a.texels.iter().fold(0.0, |most, texel| texel[c].abs().max(most)));
            }
        }
    }
}

#[test]
fn a_cycle_draws_what_the_one_on_the_cpu_computes() {
    for bench in Bench::both() {
        let (mut built, mut hierarchy) = levels(&bench);
        let right = noise_like(&hierarchy.levels[0], 5);
        built.levels[0].right = uploaded(&bench.gpu, &right);
        let mut recorder = Recorder::new(&bench.gpu, &bench.kernels);
        built.precondition(&mut recorder);
        recorder.take().play(&bench.gpu);
        let drawn = bench.read(&built.levels[0].values);
        assert_near(&drawn, &hierarchy.precondition(&right).texels, 1e-5, "a cycle");
    }
}

fn farthest(a: &[Texel], b: &[Texel]) -> f32 {
    a.iter().flatten().zip(b.iter().flatten()).fold(0.0, |most, (a, b)| (a - b).abs().max(most))
}

/// Kernels that run pass by pass, and such that run programs of passes, as on cards.
fn both_ways(gpu: &Gpu) -> [Kernels; 2] {
    [None, Some(Programs::new(gpu))].map(|programs| {
        let mut kernels = Kernels::new(gpu);
        kernels.programs = programs;
        kernels
    })
}

/// Solves on the CPU and in all ways on the GPU, to a step that changes nothing by more than the second bound, and compares; the
/// first pictures by the first bound.
fn assert_same_pictures(gpu: &Gpu, constraints: &Constraints, bounds: [f32; 2]) {
    for kernels in both_ways(gpu) {
        assert_same_picture(gpu, &kernels, constraints, bounds);
    }
}

fn assert_same_picture(
    gpu: &Gpu,
    kernels: &Kernels,
    constraints: &Constraints,
    [first, tolerance]: [f32; 2],
) {
    let size = [constraints.width_px, constraints.height_px];
    let mut on_cpu = GridSolver::new(constraints);
    let mut on_gpu = GpuGridSolver::new(gpu, kernels, constraints).expect("a solver");
    let pixels = |solver: &GpuGridSolver| pollster::block_on(solver.pixels()).expect("the pixels come back");
    let start = farthest(&pixels(&on_gpu), &on_cpu.pixels());
    assert!(start <= first, "{size:?}: {start} at first");
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
            assert_same_pictures(&gpu, &constraints, [TENTH; 2]);
        }
    }
}

/// Large levels are in halves, in which cycles and first pictures are not exact; the solution is.
#[test]
fn large_pictures_are_those_of_the_cpu() {
    let Some(gpu) = gpu() else { return };
    let tolerance = 0.01 * TENTH;
    assert_same_pictures(&gpu, &constraints(300, 290, &[]), [3.0 * TENTH, tolerance]);
    let constraints = constraints(530, 520, &[]);
    for bench in Bench::both() {
        let levels = bench.levels(&constraints).levels;
        let formats = levels.iter().map(|level| level.room.texture().format());
        let halves = formats.take_while(|format| *format == HALF_FORMAT).count();
        assert_eq!(halves, 3, "levels of one slot, of two and of four");
        assert_eq!(levels[0].matrix.holds.texture().format(), FORMAT, "what is solved");
        assert_same_picture(&bench.gpu, &bench.kernels, &constraints, [20.0 * TENTH, tolerance]);
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
    assert_same_pictures(
        &gpu,
        &Constraints::new(&map, &colors, &view(192, 192)).expect("solved"),
        [TENTH, 0.01 * TENTH],
    );
}

#[test]
fn a_picture_that_no_texture_holds_is_refused() {
    let Some(gpu) = gpu() else { return };
    let most_px = gpu.device.limits().max_texture_dimension_2d;
    let kernels = Kernels::new(&gpu);
    let wide = Constraints { width_px: most_px + 1, height_px: 1, ..constraints(1, 1, &[]) };
    let solver = GpuGridSolver::new(&gpu, &kernels, &wide);
    assert_eq!(solver.err(), Some(GridError::TooLarge { most_px }));
}

/// What shows after so many steps.
fn seen(solver: &mut GpuGridSolver, steps: usize) -> Vec<Texel> {
    (0..steps).for_each(|_| solver.step());
    pollster::block_on(solver.pixels()).expect("the pixels come back")
}

/// A circle, in colours; the first two of these are as large.
fn circle(x: f64, color: f64, width_px: u32) -> Constraints {
    let map = map([Circle::new((x, 500.0), 200.0).to_path(1e-3)].into_iter());
    let boundary = boundary(&map, &[[color, 0.9]]);
    Constraints::new(&map, &boundary, &view(width_px, 97)).expect("solved")
}

#[test]
fn other_constraints_leave_nothing_of_those_before() {
    let Some(gpu) = gpu() else { return };
    let before = constraints(130, 97, SHADES[2]);
    let layered = |shades| constraints(130, 97, shades);
    let others = [
        circle(500.0, 0.2, 130),
        circle(503.0, 0.2, 130),
        circle(503.0, 0.7, 130),
        circle(503.0, 0.3, 64),
        layered(SHADES[1]),
    ];
    for (steps, kernels) in [3, 4].into_iter().zip(both_ways(&gpu)) {
        let mut solver = GpuGridSolver::new(&gpu, &kernels, &before).expect("a solver");
        for other in &others {
            seen(&mut solver, steps);
            solver.update(&kernels, other).expect("a solver");
            let mut fresh = GpuGridSolver::new(&gpu, &kernels, other).expect("a solver");
            assert_eq!(seen(&mut solver, 0), seen(&mut fresh, 0), "at first");
            assert_eq!(seen(&mut solver, steps), seen(&mut fresh, steps), "after {steps} steps");
        }
    }
}

#[test]
fn only_what_has_changed_is_uploaded() {
    let Some(Bench { gpu, kernels }) = Bench::new() else { return };
    let before = circle(500.0, 0.2, 130);
    let mut solver = GpuGridSolver::new(&gpu, &kernels, &before).expect("a solver");
    assert_eq!(solver.update(&kernels, &before), Ok(0));
    let mut cuts = before.cuts.clone();
    let cut = cuts.iter_mut().find(|cut| cut.color.is_some()).expect("a colour");
    cut.fraction *= 0.5;
    assert_eq!(solver.update(&kernels, &Constraints { cuts, ..before }), Ok(1));
}

#[test]
fn colors_alone_leave_the_levels_as_they_are() {
    let Some(Bench { gpu, kernels }) = Bench::new() else { return };
    let mut equations = Equations::new(&gpu, &kernels, &circle(500.0, 0.2, 130));
    let recolored = equations.update(&gpu, &kernels, &circle(500.0, 0.7, 130));
    assert!(recolored.pixels > 0 && !recolored.weights, "{recolored:?}");
    let moved = equations.update(&gpu, &kernels, &circle(503.0, 0.7, 130));
    assert!(moved.weights, "{moved:?}");
}

/// Levels of 16 × 16 cells and smaller, and the last sums, are computed in one dispatch wherever larger ones wait for them.
#[test]
fn small_levels_take_few_dispatches() {
    let Some(gpu) = gpu() else { return };
    let dispatches = |kernels| {
        let constraints = constraints(256, 256, &[]);
        let GpuGridSolver { build, start, steps: [step, _], .. } =
            GpuGridSolver::new(&gpu, kernels, &constraints).expect("a solver");
        [build, start, step.tape].map(|tape| tape.passes.len())
    };
    let [one_by_one, programs] = both_ways(&gpu).each_ref().map(dispatches);
    assert_eq!((one_by_one, programs), ([89, 199, 72], [45, 63, 39]));
}

#[test]
fn costs_are_those_of_the_passes() {
    let Some(Bench { gpu, kernels }) = Bench::new() else { return };
    let costs = |side_px| {
        let (cuts, faces, pulls, sources) = Default::default();
        let [width_px, height_px] = [side_px; 2];
        let exits = Vec::new();
        let blank = Constraints { width_px, height_px, cuts, faces, pulls, sources, exits, covers: None };
        GpuGridSolver::costs(&gpu, &kernels, &blank).expect("costs")
    };
    // One pixel: the diagonal; the first picture, what it lacks, and no direction yet; each a pass with its textures.
    let pixel = costs(1);
    let [thin, thick] = [4, 16];
    let diagonal = 3 * thin + 2 * thick;
    let spread = 4 * thick;
    let residual = 2 * thin + 5 * thick;
    let ratio = 3 * thick;
    assert_eq!(pixel.levels, Costs { passes: 1, bytes: diagonal });
    assert_eq!(pixel.start, Costs { passes: 3, bytes: spread + residual + ratio });
    let [small, large] = [128, 256].map(costs);
    for (small, large) in [(small.levels, large.levels), (small.start, large.start), (small.step, large.step)]
    {
        assert!(large.passes > small.passes, "one level more");
        assert!((3.9..4.1).contains(&(large.bytes as f64 / small.bytes as f64)), "{large:?} {small:?}");
    }
    assert!((3.9..4.1).contains(&(large.texture_bytes as f64 / small.texture_bytes as f64)));
    assert!(5 * costs(512).step.bytes < 4 * 4 * large.step.bytes, "large levels are in halves");
    assert_eq!(large.recolor(3).passes, large.start.passes + 3 * large.step.passes);
    assert_eq!(large.solve(3).passes, large.levels.passes + large.recolor(3).passes);
}
