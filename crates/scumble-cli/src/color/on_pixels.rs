//! Pictures by the solvers that work on pixels.

use scumble_core::Boundary;
use scumble_solve::grid::{CutLinks, GridPicture, GridSolver, JeschkeSolver};
use scumble_solve::{Pixmap, paint_grid};

use crate::options::{ColorOptions, Solver};
use crate::stages::{self, Opened, PAPER};

/// A step of the grid solver that changes no value by more than this is the last: a quarter of a level.
const TOLERANCE: f32 = 0.25 / 255.0;

/// Steps of Jeschke's solver, as in its paper.
const JESCHKE_STEPS: usize = 8;

/// Spreads the colours and paints the page.
pub(super) fn paint(opened: &Opened, boundary: &Boundary, options: &ColorOptions) -> Pixmap {
    let view = stages::page_view(&opened.import.drawing, options.size_px);
    let links = CutLinks::new(opened.picture.map(), boundary, &view);
    let pixels = solve(&links, options.solver);
    let picture = GridPicture::new(opened.picture.map(), &view, options.settings.blend, pixels);
    paint_grid(&picture, &super::shapes(opened, options), &view, (!options.transparent).then_some(PAPER))
}

fn solve(links: &CutLinks, solver: Solver) -> Vec<[f32; 4]> {
    if solver == Solver::Jeschke {
        let mut solver = JeschkeSolver::new(links);
        (0..JESCHKE_STEPS).for_each(|_| solver.step());
        return solver.pixels().to_vec();
    }
    let mut solver = GridSolver::new(links);
    solver.solve(TOLERANCE);
    solver.pixels().to_vec()
}
