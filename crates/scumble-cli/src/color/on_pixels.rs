//! Pictures by the solvers that work on pixels.

use anyhow::Context;
use scumble_solve::Pixmap;
use scumble_solve::grid::{Constraints, GridSolver, JeschkeSolver, TOLERANCE};

use super::parts::{MOST_PX, Page};
use crate::card::Card;
use crate::options::{ColorOptions, Solver};
use crate::render;
use crate::stages::{self, Opened, PAPER};

/// Steps of Jeschke's solver, as in its paper.
const JESCHKE_STEPS: usize = 8;

/// Spreads the colours of the picture's boundary and paints the page.
///
/// # Errors
/// When there is no GPU that can do it, or a shade cannot be solved.
pub(super) fn paint(opened: &Opened, options: &ColorOptions) -> anyhow::Result<Pixmap> {
    let (drawing, look) = (&opened.document.drawing, &options.look);
    let page = Page {
        drawing,
        picture: &opened.picture,
        boundary: opened.picture.boundary(),
        blend: options.settings.blend,
        view: stages::page_view(drawing, look.size_px()),
        shapes: &render::shapes(drawing, &opened.picture, look),
        paper: (!look.transparent).then_some(PAPER),
        most_px: MOST_PX,
    };
    match options.solver {
        Solver::GpuGrid => paint_on_gpu(&page).context("--solver gpu (cpu-grid needs no graphics card)"),
        Solver::Jeschke => page.paint(|constraints| Ok(jeschke(constraints))),
        Solver::CpuGrid | Solver::Mesh => page.paint(|constraints| Ok(on_cpu(constraints))),
    }
}

fn paint_on_gpu(page: &Page<'_>) -> anyhow::Result<Pixmap> {
    let card = Card::find()?;
    page.paint(|constraints| {
        let mut solver = card.solver(constraints)?;
        card.solve(&mut solver, TOLERANCE)?;
        Ok(card.pixels(&solver)?)
    })
}

fn on_cpu(constraints: &Constraints) -> Vec<[f32; 4]> {
    let mut solver = GridSolver::new(constraints);
    solver.solve(TOLERANCE);
    solver.pixels()
}

fn jeschke(constraints: &Constraints) -> Vec<[f32; 4]> {
    let mut solver = JeschkeSolver::new(constraints);
    (0..JESCHKE_STEPS).for_each(|_| solver.step());
    solver.pixels().to_vec()
}
