//! The pictures that the mesh solver and the grid solver make of the same boundary.

use scumble_core::{Bends, Blend, Boundary};
use scumble_gpu::GridError;
use scumble_solve::grid::Constraints;
use scumble_solve::{Picture, View, centers};

use super::levels::{Levels, Spread, levels};
use super::solver::Solver;
use super::zones::{self, Zone};
use crate::card::Card;
use crate::clock::timed;

/// Pixels nearer than this, in px, to an end, a junction or a change count apart.
const SPECIAL_PX: f64 = 4.0;

/// Further steps, for the picture that the iteration tends to.
const FURTHER_STEPS: usize = 8;

/// Both pictures.
pub(crate) struct Both<'a> {
    pub(super) constraints: Constraints,
    solver: Solver<'a>,
    /// Those of the grid solver.
    pub(super) steps: usize,
    /// What it takes for the picture, once it is known where curves cut its links.
    pub(crate) grid_ms: f64,
    pub(super) mesh: Vec<Levels>,
    pub(super) grid: Vec<Levels>,
    zones: Vec<Zone>,
    blend: Blend,
}

impl<'a> Both<'a> {
    /// Has both solvers make their picture, that on pixels on a graphics card where there is one; colours are in the space
    /// `blend`.
    ///
    /// # Errors
    /// When one fails.
    pub(crate) fn new(
        picture: &mut Picture,
        boundary: &Boundary,
        blend: Blend,
        view: &View,
        card: Option<&'a Card>,
    ) -> anyhow::Result<Self> {
        let mesh = levels(&centers::colors(picture.mesh().solve(boundary, blend)?, view), blend);
        let (map, bends) = (picture.map(), Bends::default());
        let constraints = Constraints::new(map, boundary, view)?.fitted(map, &bends, boundary, view);
        let (solved, grid_ms) = timed(|| {
            let mut solver = Solver::new(&constraints, card)?;
            let steps = solver.solve()?;
            Ok::<_, GridError>((solver, steps))
        });
        let (solver, steps) = solved?;
        let grid = levels(&solver.pixels()?, blend);
        let zones = zones::zones(map, boundary, view, SPECIAL_PX);
        Ok(Self { constraints, solver, steps, grid_ms, mesh, grid, zones, blend })
    }

    /// How far they are from each other away from curves, from their ends and junctions, and from changes of what a side is.
    pub(crate) fn differences(&self) -> Spread {
        self.between(Zone::Away, &self.grid, &self.mesh)
    }

    /// How far any two pictures are from each other in a zone.
    pub(super) fn between(&self, zone: Zone, a: &[Levels], b: &[Levels]) -> Spread {
        Spread::of(a, b, |i| self.zones[i] == zone)
    }

    /// The most that further steps of the grid solver change.
    ///
    /// # Errors
    /// When the graphics card fails.
    pub(super) fn change_by_further_steps(&mut self) -> anyhow::Result<f64> {
        (0..FURTHER_STEPS).for_each(|_| self.solver.step());
        Ok(Spread::of(&self.grid, &levels(&self.solver.pixels()?, self.blend), |_| true).largest())
    }
}
