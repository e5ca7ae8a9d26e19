//! What the grid solver is given, with what it takes to show what it finds.

use scumble_core::{Blend, Boundary, PlanarMap};

use super::constraints::Constraints;
use super::curve_cells::CurveCells;
use crate::mesh::SolveError;
use crate::scene::View;

/// A picture to be solved on the pixels of a view.
#[derive(Clone, Debug, PartialEq)]
pub struct GridProblem {
    /// The pixels.
    pub view: View,
    /// The space that the colours are in.
    pub blend: Blend,
    /// What is given.
    pub constraints: Constraints,
    /// Where the picture may jump.
    pub curves: CurveCells,
}

impl GridProblem {
    /// What a map and the colours of its sides make of a view.
    ///
    /// # Errors
    /// See [`SolveError`]: where something shades.
    pub fn new(map: &PlanarMap, boundary: &Boundary, view: &View, blend: Blend) -> Result<Self, SolveError> {
        Self::of_whole(view, map, boundary, view, blend)
    }

    /// The same for a part of this problem's picture, on smaller pixels.
    ///
    /// # Errors
    /// See [`SolveError`]: where something shades.
    pub fn part(&self, map: &PlanarMap, boundary: &Boundary, view: &View) -> Result<Self, SolveError> {
        Self::of_whole(&self.view, map, boundary, view, self.blend)
    }

    fn of_whole(
        whole: &View,
        map: &PlanarMap,
        boundary: &Boundary,
        view: &View,
        blend: Blend,
    ) -> Result<Self, SolveError> {
        let constraints = Constraints::part(whole, map, boundary, view)?;
        Ok(Self { view: *view, blend, constraints, curves: CurveCells::new(map, view) })
    }
}
