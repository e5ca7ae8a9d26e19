//! What shading scribbles lay over pixels: their layer, as the mesh solver finds it, which no pixel can do as well.

use scumble_core::{Bends, Blend, Boundary, PlanarMap, SoftSource};

use super::texture::Texture;
use crate::centers;
use crate::mesh::{MeshSolver, SolveError};
use crate::scene::View;

/// A layer on the pixels of a picture.
#[derive(Clone, Debug, PartialEq)]
pub struct Covers {
    /// Blend-space colours times opacity, and opacity, times how much they cover.
    pub colors: Texture,
    /// In all channels how much is covered, from 0 to 1; none where that is the opacity of the colours.
    pub parts: Option<Texture>,
}

/// The same layer on all of a page.
#[derive(Debug, Default)]
pub struct Shades {
    /// Of its colours, and of how much is covered where that is not their opacity; none where nothing shades.
    solvers: Vec<MeshSolver>,
}

impl Shades {
    /// That of the sources of a boundary.
    ///
    /// # Errors
    /// See [`SolveError`].
    pub fn new(map: &PlanarMap, boundary: &Boundary) -> Result<Self, SolveError> {
        let (sources, mut solvers) = (&boundary.sources, Vec::new());
        let mut add_layer = |sources: Vec<SoftSource>| {
            let boundary = Boundary { sides: Vec::new(), closed_gaps: boundary.closed_gaps.clone(), sources };
            let mut solver = MeshSolver::new(map.refined().clone());
            solver.solve(&boundary, Blend::default())?;
            solvers.push(solver);
            Ok(())
        };
        if !sources.is_empty() {
            add_layer(sources.clone())?;
        }
        if sources.iter().any(|source| source.color[3] != 1.0) {
            let mut covering = sources.clone();
            covering.iter_mut().for_each(|source| source.color = [1.0; 4]);
            add_layer(covering)?;
        }
        Ok(Self { solvers })
    }

    /// What a view shows of it, up to curves as they bend.
    pub(super) fn covers(&self, bends: &Bends, view: &View) -> Option<Covers> {
        let part_du = view.seen_du();
        let mut layers = self.solvers.iter().map(|solver| Texture {
            width: view.width_px as usize,
            height: view.height_px as usize,
            texels: centers::colors(&solver.bent(bends, part_du), view),
        });
        Some(Covers { colors: layers.next()?, parts: layers.next() })
    }
}

impl Covers {
    /// How much is covered, in the last channel.
    pub fn parts(&self) -> &Texture {
        self.parts.as_ref().unwrap_or(&self.colors)
    }
}
