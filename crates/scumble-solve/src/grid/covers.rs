//! What shading scribbles lay over pixels: their layer, as the mesh solver finds it, which no pixel can do as well.

use scumble_core::{Blend, Boundary, PlanarMap, SoftSource};

use super::texture::Texture;
use crate::centers;
use crate::field::Field;
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
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Shades {
    /// What it lays over the picture, and how much of that is covered, where that is not its opacity. Nothing where nothing shades.
    layers: Vec<Field>,
}

impl Shades {
    /// That of the sources of a boundary.
    ///
    /// # Errors
    /// See [`SolveError`].
    pub fn new(map: &PlanarMap, boundary: &Boundary) -> Result<Self, SolveError> {
        let sources = &boundary.sources;
        if sources.is_empty() {
            return Ok(Self::default());
        }
        let mut solver = MeshSolver::new(map.refined().clone());
        let mut layer = |sources: Vec<SoftSource>| {
            let boundary = Boundary { sides: Vec::new(), closed_gaps: boundary.closed_gaps.clone(), sources };
            solver.solve(&boundary, Blend::default()).cloned()
        };
        let mut layers = vec![layer(sources.clone())?];
        if sources.iter().any(|source| source.color[3] != 1.0) {
            let mut covering = sources.clone();
            covering.iter_mut().for_each(|source| source.color = [1.0; 4]);
            layers.push(layer(covering)?);
        }
        Ok(Self { layers })
    }

    /// What a view shows of it.
    pub(super) fn covers(&self, view: &View) -> Option<Covers> {
        let mut layers = self.layers.iter().map(|field| Texture {
            width: view.width_px as usize,
            height: view.height_px as usize,
            texels: centers::colors(field, view),
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
