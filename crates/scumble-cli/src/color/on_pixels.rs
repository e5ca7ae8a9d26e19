//! Pictures by the solvers that work on pixels.

use std::sync::{Arc, OnceLock};

use anyhow::Context;
use scumble_core::Boundary;
use scumble_gpu::{Gpu, GpuGridSolver, GridError};
use scumble_solve::grid::{CutLinks, GridPicture, GridSolver, JeschkeSolver};
use scumble_solve::{Pixmap, paint_grid};

use crate::options::{ColorOptions, Solver};
use crate::render;
use crate::stages::{self, Opened, PAPER};

/// A step of the grid solver that changes no value by more than this is the last: a quarter of a level.
const TOLERANCE: f32 = 0.25 / 255.0;

/// Steps of Jeschke's solver, as in its paper.
const JESCHKE_STEPS: usize = 8;

/// Spreads the colours and paints the page.
///
/// # Errors
/// When there is no GPU that can do it.
pub(super) fn paint(opened: &Opened, boundary: &Boundary, options: &ColorOptions) -> anyhow::Result<Pixmap> {
    let (drawing, look) = (&opened.import.drawing, &options.look);
    let view = stages::page_view(drawing, look.size_px);
    let links = CutLinks::new(opened.picture.map(), boundary, &view);
    let pixels = solve(&links, options.solver)?;
    let picture = GridPicture::new(opened.picture.map(), &view, options.settings.blend, pixels);
    let shapes = render::shapes(drawing, &opened.picture, look);
    Ok(paint_grid(&picture, &shapes, &view, (!look.transparent).then_some(PAPER)))
}

fn solve(links: &CutLinks, solver: Solver) -> anyhow::Result<Vec<[f32; 4]>> {
    match solver {
        Solver::GpuGrid => {
            pollster::block_on(on_gpu(links)).context("--solver gpu (cpu-grid needs no graphics card)")
        }
        Solver::Jeschke => Ok(jeschke(links)),
        Solver::CpuGrid | Solver::Mesh => Ok(on_cpu(links)),
    }
}

async fn on_gpu(links: &CutLinks) -> Result<Vec<[f32; 4]>, GridError> {
    let failure = Arc::new(OnceLock::new());
    let noted = Arc::clone(&failure);
    let gpu = Gpu::headless(move |error| drop(noted.set(error))).await?;
    let mut solver = GpuGridSolver::new(&gpu, links)?;
    solver.solve(TOLERANCE).await?;
    let pixels = solver.pixels().await?;
    failure.get().map_or(Ok(pixels), |error| Err(error.clone().into()))
}

fn on_cpu(links: &CutLinks) -> Vec<[f32; 4]> {
    let mut solver = GridSolver::new(links);
    solver.solve(TOLERANCE);
    solver.pixels().to_vec()
}

fn jeschke(links: &CutLinks) -> Vec<[f32; 4]> {
    let mut solver = JeschkeSolver::new(links);
    (0..JESCHKE_STEPS).for_each(|_| solver.step());
    solver.pixels().to_vec()
}
