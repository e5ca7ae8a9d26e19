//! What there is to paint, and what paints it.

use scumble_core::Srgb8;
use scumble_solve::grid::GridProblem;
use scumble_solve::{Field, Pixmap, Scene, View, paint};

use crate::layers::Layers;

/// The colour of the page where nothing is coloured.
pub const PAPER: Srgb8 = Srgb8([255; 3]);

/// A picture to show or to keep.
#[derive(Debug)]
pub struct Painting<'a> {
    /// The coloured regions.
    pub field: &'a Field,
    /// What they are to be solved from in place of the field.
    pub problem: Option<&'a GridProblem>,
    /// What lies over them.
    pub layers: &'a Layers,
    /// Which part of the plane, at which size.
    pub view: View,
    /// The colour of the page where nothing is coloured; without one it is transparent there.
    pub paper: Option<Srgb8>,
}

impl Painting<'_> {
    /// The same, for a painter that takes it as a whole.
    pub fn scene(&self) -> Scene<'_> {
        Scene { paper: self.paper, field: self.field, shapes: self.layers.shapes() }
    }
}

/// What of a painting is not what it was in the frame before.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Changed {
    /// The colour field.
    pub field: bool,
    /// What is to be solved in place of it.
    pub problem: bool,
    /// The layer of scribbles.
    pub scribbles: bool,
    /// The layer of ink.
    pub ink: bool,
}

impl Changed {
    /// Everything, as for a painter that has painted nothing yet.
    pub const ALL: Self = Self { field: true, problem: true, scribbles: true, ink: true };
}

/// Puts paintings on the screen.
pub trait Painter {
    /// Shows a painting, and tells whether that is all: if not, it is to be called again for the rest. A painter may keep
    /// what has not changed since the call before.
    fn paint(&mut self, painting: &Painting<'_>, changed: Changed) -> bool;
}

/// A picture for a file, which stays as it is while the drawing is worked on.
#[derive(Debug)]
pub struct Export {
    /// The coloured regions.
    pub field: Field,
    pub(crate) layers: Layers,
    /// The whole page.
    pub view: View,
}

impl Export {
    /// Paints some rows of it, from the first one on. Without paper, what nothing covers is transparent.
    pub fn rows(&self, first: u32, count: u32, paper: Option<Srgb8>) -> Pixmap {
        let view = View {
            px_from_du: self.view.px_from_du.then_translate((0.0, -f64::from(first)).into()),
            height_px: count,
            ..self.view
        };
        paint(&Scene { paper, field: &self.field, shapes: self.layers.shapes() }, &view)
    }
}
