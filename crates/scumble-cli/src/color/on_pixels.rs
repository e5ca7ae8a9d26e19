//! Pictures by the solvers that work on pixels.

use std::sync::{Arc, OnceLock};

use anyhow::Context;
use scumble_core::Boundary;
use scumble_gpu::{Gpu, GpuGridSolver, GridError, GridKernels};
use scumble_solve::grid::{Constraints, GridPicture, GridSolver, JeschkeSolver, TOLERANCE};
use scumble_solve::{Pixmap, paint_grid};

use crate::options::{ColorOptions, Solver};
use crate::render;
use crate::stages::{self, Opened, PAPER};

/// Steps of Jeschke's solver, as in its paper.
const JESCHKE_STEPS: usize = 8;

/// Spreads the colours and paints the page.
///
/// # Errors
/// When there is no GPU that can do it, or a shade cannot be solved.
pub(super) fn paint(opened: &Opened, boundary: &Boundary, options: &ColorOptions) -> anyhow::Result<Pixmap> {
    let (drawing, look) = (&opened.document.drawing, &options.look);
    let view = stages::page_view(drawing, look.size_px);
    let map = opened.picture.map();
    let constraints = Constraints::new(map, boundary, &view)?.fitted(map, boundary, &view);
    let pixels = solve(&constraints, options.solver)?;
    let picture = GridPicture::new(map, &view, options.settings.blend, pixels);
    let shapes = render::shapes(drawing, &opened.picture, look);
    Ok(paint_grid(&picture, &shapes, &view, (!look.transparent).then_some(PAPER)))
}

fn solve(constraints: &Constraints, solver: Solver) -> anyhow::Result<Vec<[f32; 4]>> {
    match solver {
        Solver::GpuGrid => {
            pollster::block_on(on_gpu(constraints)).context("--solver gpu (cpu-grid needs no graphics card)")
        }
        Solver::Jeschke => Ok(jeschke(constraints)),
        Solver::CpuGrid | Solver::Mesh => Ok(on_cpu(constraints)),
    }
}

async fn on_gpu(constraints: &Constraints) -> Result<Vec<[f32; 4]>, GridError> {
    let failure = Arc::new(OnceLock::new());
    let noted = Arc::clone(&failure);
    let gpu = Gpu::headless(move |error| drop(noted.set(error))).await?;
    let mut solver = GpuGridSolver::new(&gpu, &GridKernels::new(&gpu.device), constraints)?;
    solver.solve(TOLERANCE).await?;
    let pixels = solver.pixels().await?;
    failure.get().map_or(Ok(pixels), |error| Err(error.clone().into()))
}

fn on_cpu(constraints: &Constraints) -> Vec<[f32; 4]> {
    let mut solver = GridSolver::new(constraints);
    solver.solve(TOLERANCE);
    solver.pixels().to_vec()
}

fn jeschke(constraints: &Constraints) -> Vec<[f32; 4]> {
    let mut solver = JeschkeSolver::new(constraints);
    (0..JESCHKE_STEPS).for_each(|_| solver.step());
    solver.pixels().to_vec()
}
