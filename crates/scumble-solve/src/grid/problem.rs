//! What the grid solver is given, with what it takes to show what it finds.

use std::sync::Arc;

use scumble_core::{Bends, Blend, Boundary, PlanarMap};

use super::constraints::Constraints;
use super::covers::Shades;
use super::curve_cells::CurveCells;
use crate::mesh::SolveError;
use crate::scene::View;

/// A picture to be solved on the pixels of a view.
#[derive(Clone, Debug)]
pub struct GridProblem {
    /// The pixels.
    pub view: View,
    /// The space that the colours are in.
    pub blend: Blend,
    /// What is given.
    pub constraints: Constraints,
    /// Where the picture may jump.
    pub curves: CurveCells,
    /// Of the whole page.
    shades: Arc<Shades>,
}

impl GridProblem {
    /// What a map and the colours of its sides make of a view.
    ///
    /// # Errors
    /// See [`SolveError`]: where something shades.
    pub fn new(map: &PlanarMap, boundary: &Boundary, view: &View, blend: Blend) -> Result<Self, SolveError> {
        let shades = Arc::new(Shades::new(map, boundary)?);
        let constraints = Constraints::shaded(map, boundary, &shades, view);
        let curves = CurveCells::new(map, &Bends::default(), boundary, view);
        Ok(Self { view: *view, blend, constraints, curves, shades })
    }

    /// The same for a part of this problem's picture, on smaller pixels, among which curves bend.
    pub fn part(&self, map: &PlanarMap, bends: &Bends, boundary: &Boundary, view: &View) -> Self {
        let whole = (&self.view, &self.curves);
        let constraints = Constraints::part(whole, map, bends, boundary, &self.shades, view);
        let curves = CurveCells::new(map, bends, boundary, view);
        Self { view: *view, blend: self.blend, constraints, curves, shades: Arc::clone(&self.shades) }
    }
}
