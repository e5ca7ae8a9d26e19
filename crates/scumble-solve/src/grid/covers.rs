//! What shading scribbles lay over pixels: their layer, as the mesh solver finds it, which no pixel can do as well.

use scumble_core::{Blend, Boundary, PlanarMap, SoftSource};

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

impl Covers {
    /// Those of the sources of a boundary in what a view shows; none where nothing shades.
    ///
    /// # Errors
    /// See [`SolveError`].
    pub(super) fn new(map: &PlanarMap, boundary: &Boundary, view: &View) -> Result<Option<Self>, SolveError> {
        let sources = &boundary.sources;
        if sources.is_empty() {
            return Ok(None);
        }
        let mut solver = MeshSolver::new(map.refined().clone());
        let mut layer = |sources: Vec<SoftSource>| {
            let boundary = Boundary { sides: Vec::new(), closed_gaps: boundary.closed_gaps.clone(), sources };
            let texels = centers::colors(solver.solve(&boundary, Blend::default())?, view);
            Ok(Texture { width: view.width_px as usize, height: view.height_px as usize, texels })
        };
        let colors = layer(sources.clone())?;
        let is_opaque = sources.iter().all(|source| source.color[3] == 1.0);
        let covering = || sources.iter().map(|source| SoftSource { color: [1.0; 4], ..source.clone() });
        let parts = if is_opaque { None } else { Some(layer(covering().collect())?) };
        Ok(Some(Self { colors, parts }))
    }

    /// How much is covered, in the last channel.
    pub fn parts(&self) -> &Texture {
        self.parts.as_ref().unwrap_or(&self.colors)
    }
}
