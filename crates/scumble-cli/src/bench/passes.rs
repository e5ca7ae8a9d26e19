//! What one picture of the grid solver costs on a graphics card: told from the passes themselves, and measured.

use scumble_core::{Drawing, Scribble, Settings};
use scumble_gpu::grid::SolverCosts;
use scumble_gpu::{Gpu, GpuGridSolver, GridError, GridKernels};
use scumble_solve::Picture;
use scumble_solve::grid::{Constraints, FRAME_STEPS, PAGE_STEPS};

use super::drag;
use crate::clock::{Times, timed};
use crate::{made, stages};

/// Sides of the pictures.
const SIZES_PX: [u32; 2] = [1024, 4096];

/// Steps of a picture: until the page shows it for the first time, as many as drawings with all their colours need, and all of
/// the page.
const STEPS: [u64; 3] = [FRAME_STEPS as u64, 6, PAGE_STEPS as u64];

/// A step that changes nothing by more is the last: half a level of 255.
const HALF_LEVEL: f32 = 0.5 / 255.0;

/// What the graphics part of a laptop's processor moves.
const BYTES_PER_SECOND: f64 = 50e9;

/// Pictures that a graphics card makes to be timed. Without one a single picture takes long enough.
const RUNS: usize = 21;

/// Prints costs and times.
///
/// # Errors
/// When there is no graphics device, or one that has no textures of this size.
pub(crate) fn run() -> anyhow::Result<()> {
    let gpu = pollster::block_on(Gpu::headless(|error| eprintln!("scumble: {error}")))?;
    let kernels = GridKernels::new(&gpu);
    print_head();
    for size_px in SIZES_PX {
        let constraints = constraints(&drag::drawing(0), &made::scribbles(), size_px)?;
        print_costs(size_px, &GpuGridSolver::costs(&gpu, &kernels, &constraints)?);
    }
    let info = gpu.adapter.get_info();
    let (sizes, runs) = if gpu.is_software() { (1, 1) } else { (SIZES_PX.len(), RUNS) };
    println!();
    let title = format!("{} ({:?}), median of {runs}", info.name, info.device_type);
    println!("{title:<56} {:>12} {:>12}", "move, ms", "recolour, ms");
    for size_px in SIZES_PX.into_iter().take(sizes) {
        print_times(&gpu, &kernels, size_px, runs)?;
    }
    Ok(())
}

fn constraints(drawing: &Drawing, scribbles: &[Scribble], size_px: u32) -> anyhow::Result<Constraints> {
    let mut picture = Picture::new(drawing)?;
    picture.color(scribbles, &[], &Settings::default());
    let view = stages::page_view(drawing, size_px);
    Ok(Constraints::new(picture.map(), picture.boundary(), &view)?)
}

/// Prints how long pictures take until a step changes them by half a level, and in as many steps as in the page: where the end
/// of a curve was elsewhere before, and where colours were others.
fn print_times(gpu: &Gpu, kernels: &GridKernels, size_px: u32, runs: usize) -> anyhow::Result<()> {
    let [before, moved] = [0, 1].map(drag::drawing);
    let scribbles = made::scribbles();
    let mut colors = scribbles.clone();
    colors.iter_mut().zip(scribbles.iter().rev()).for_each(|(to, from)| to.color = from.color);
    let before = constraints(&before, &scribbles, size_px)?;
    let [moved, recolored] =
        [constraints(&moved, &scribbles, size_px)?, constraints(&moved, &colors, size_px)?];
    let mut solver = GpuGridSolver::new(gpu, kernels, &before)?;
    let least = pollster::block_on(solver.solve(HALF_LEVEL))?;
    for steps in [least, PAGE_STEPS] {
        let [mut moves, mut recolors] = [(); 2].map(|()| Times::default());
        for _ in 0..runs {
            solve_ms(&mut solver, kernels, &before, steps)?;
            moves.push(solve_ms(&mut solver, kernels, &moved, steps)?);
            recolors.push(solve_ms(&mut solver, kernels, &recolored, steps)?);
        }
        let title = format!("{size_px} × {size_px} px, {steps} steps");
        println!("{title:<56} {:12.1} {:12.1}", moves.median(), recolors.median());
    }
    Ok(())
}

/// From constraints to the picture, textures and pipelines being there.
fn solve_ms(
    solver: &mut GpuGridSolver,
    kernels: &GridKernels,
    constraints: &Constraints,
    steps: usize,
) -> Result<f64, GridError> {
    let (solved, ms) = timed(|| {
        solver.update(kernels, constraints)?;
        (0..steps).for_each(|_| solver.step());
        Ok::<_, GridError>(pollster::block_on(solver.last_change())?)
    });
    solved.map(|_| ms)
}

fn print_head() {
    println!("{:<34} {:>9} {:>9} {:>12}", "the grid solver", "passes", "GB moved", "ms at 50 GB/s");
}

fn print_costs(size_px: u32, costs: &SolverCosts) {
    let texture_gb = costs.texture_bytes as f64 / 1e9;
    println!("{size_px} × {size_px} px, {texture_gb:.2} GB of textures");
    let solves = STEPS.map(|steps| (format!("a picture in {steps} steps"), costs.solve(steps)));
    let parts = [("levels", costs.levels), ("first picture", costs.start), ("a step", costs.step)];
    let parts = parts.map(|(name, costs)| (name.to_owned(), costs));
    for (name, costs) in parts.into_iter().chain(solves) {
        let (bytes, ms) = (costs.bytes as f64, costs.bytes as f64 / BYTES_PER_SECOND * 1e3);
        println!("  {name:<32} {:9} {:9.2} {ms:12.1}", costs.passes, bytes / 1e9);
    }
}
