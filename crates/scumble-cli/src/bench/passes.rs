//! What one picture of the grid solver costs on a graphics card: told from the passes themselves, and measured.

use scumble_core::{Blend, Drawing, Settings};
use scumble_gpu::grid::SolverCosts;
use scumble_gpu::{Gpu, GpuGridSolver, GridError, GridKernels, wgpu};
use scumble_solve::Picture;
use scumble_solve::grid::{Constraints, GridProblem, PAGE_STEPS};

use crate::clock::{Times, timed};
use crate::{made, stages};

/// Sides of the pictures.
const SIZES_PX: [u32; 2] = [1024, 4096];

/// Steps of a picture: as many as drawings with all their colours need, and those of the page.
const STEPS: [u64; 2] = [6, PAGE_STEPS as u64];

/// What the graphics part of a laptop's processor moves.
const BYTES_PER_SECOND: f64 = 50e9;

/// Pictures that a graphics card makes to be timed. Without one a single picture takes long enough.
const RUNS: usize = 5;

/// Cells in a row of the made drawing.
const CELLS: u32 = 5;

/// Prints costs and times.
///
/// # Errors
/// When there is no graphics device, or one that has no textures of this size.
pub(crate) fn run() -> anyhow::Result<()> {
    let gpu = pollster::block_on(Gpu::headless(|error| eprintln!("scumble: {error}")))?;
    let kernels = GridKernels::new(&gpu.device);
    let drawing = made::drawing(CELLS);
    print_head();
    for size_px in SIZES_PX {
        let problem = problem(&drawing, size_px)?;
        print_costs(size_px, &GpuGridSolver::costs(&gpu, &kernels, &problem.constraints)?);
    }
    let info = gpu.adapter.get_info();
    println!();
    let is_card = info.device_type != wgpu::DeviceType::Cpu;
    let (sizes, runs) = if is_card { (SIZES_PX.len(), RUNS) } else { (1, 1) };
    println!("{} ({:?}), {PAGE_STEPS} steps, median of {runs}", info.name, info.device_type);
    for size_px in SIZES_PX.into_iter().take(sizes) {
        let solve_ms = solve_ms(&gpu, &kernels, &problem(&drawing, size_px)?.constraints, runs)?;
        println!("{:<34} {solve_ms:9.1} ms", format!("{size_px} × {size_px} px"));
    }
    Ok(())
}

fn problem(drawing: &Drawing, size_px: u32) -> anyhow::Result<GridProblem> {
    let mut picture = Picture::new(drawing)?;
    picture.color(&made::scribbles(), &[], &Settings::default());
    let view = stages::page_view(drawing, size_px);
    Ok(GridProblem::new(picture.map(), picture.boundary(), &view, Blend::default())?)
}

/// From constraints to the picture, textures and pipelines being there.
fn solve_ms(
    gpu: &Gpu,
    kernels: &GridKernels,
    constraints: &Constraints,
    runs: usize,
) -> Result<f64, GridError> {
    let mut solver = GpuGridSolver::new(gpu, kernels, constraints)?;
    pollster::block_on(solver.last_change())?;
    let mut times = Times::default();
    for _ in 0..runs {
        let (solved, ms) = timed(|| {
            solver.update(kernels, constraints)?;
            (0..PAGE_STEPS).for_each(|_| solver.step());
            Ok::<_, GridError>(pollster::block_on(solver.last_change())?)
        });
        solved?;
        times.push(ms);
    }
    Ok(times.median())
}

fn print_head() {
    println!("{:<34} {:>9} {:>9} {:>12}", "the grid solver", "passes", "GB moved", "ms at 50 GB/s");
}

fn print_costs(size_px: u32, costs: &SolverCosts) {
    let texture_gb = costs.texture_bytes as f64 / 1e9;
    println!("{size_px} × {size_px} px, {texture_gb:.2} GB of textures");
    let solves = STEPS.map(|steps| (format!("a picture in {steps} steps"), costs.solve(steps)));
    let parts = [("levels and first picture".to_owned(), costs.start), ("a step".to_owned(), costs.step)];
    for (name, costs) in parts.into_iter().chain(solves) {
        let (bytes, ms) = (costs.bytes as f64, costs.bytes as f64 / BYTES_PER_SECOND * 1e3);
        println!("  {name:<32} {:9} {:9.2} {ms:12.1}", costs.passes, bytes / 1e9);
    }
}
