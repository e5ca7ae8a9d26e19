//! What there is to paint, and what paints it.

use std::sync::Arc;

use kurbo::Rect;
use scumble_core::{Srgb8, bounds};
use scumble_solve::grid::GridProblem;
use scumble_solve::{EVERYWHERE, Field, FieldChange, Part, Pixmap, Scene, View, paint};

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
    /// What a part of them in view is to be solved from, with what all of them have beyond its borders.
    pub part: Option<&'a GridProblem>,
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
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Changed {
    /// The colour field.
    pub field: FieldChange,
    /// What is to be solved in place of it.
    pub problem: bool,
    /// The part of it.
    pub part: bool,
    /// The layer of scribbles.
    pub scribbles: bool,
    /// The layer of ink.
    pub ink: bool,
    /// All that has changed beside the field lies within, in du.
    pub within_du: Option<Rect>,
}

impl Changed {
    /// Everything, as for a painter that has painted nothing yet.
    pub const ALL: Self = Self {
        field: FieldChange::ALL,
        problem: true,
        part: true,
        scribbles: true,
        ink: true,
        within_du: Some(EVERYWHERE),
    };

    /// Adds what has changed within a part of the plane, in du.
    pub(crate) fn add_within(&mut self, part_du: Option<Rect>) {
        self.within_du = bounds::union(self.within_du, part_du);
    }

    /// Adds what may have changed anywhere.
    pub(crate) fn add_everywhere(&mut self) {
        self.within_du = Some(EVERYWHERE);
    }

    /// The whole picture under the shapes.
    pub(crate) fn add_colors(&mut self) {
        (self.field, self.problem) = (FieldChange::ALL, true);
    }

    /// The pixels of a view that show it, and one more on each side.
    pub(crate) fn part(&self, view: &View) -> Option<Part> {
        part_px(bounds::union(self.within_du, self.field.within_du)?, view)
    }
}

/// The pixels of a view that show a rectangle of du, and one more on each side.
pub(crate) fn part_px(within_du: Rect, view: &View) -> Option<Part> {
    let within_px = view.px_from_du.transform_rect_bbox(within_du).inflate(1.0, 1.0);
    // A cast keeps within the range of its type.
    let span = |from: f64, to: f64, end: u32| (from as u32).min(end)..(to.ceil() as u32).min(end);
    let columns = span(within_px.x0, within_px.x1, view.width_px);
    let rows = span(within_px.y0, within_px.y1, view.height_px);
    (!columns.is_empty() && !rows.is_empty()).then_some(Part { columns, rows })
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
    pub field: Arc<Field>,
    pub(crate) layers: Layers,
    /// The whole page.
    pub view: View,
}

impl Export {
    /// Paints some rows of it, from the first one on. Without paper, what nothing covers is transparent.
    pub fn rows(&self, first: u32, count: u32, paper: Option<Srgb8>) -> Pixmap {
        let view = self.view.part(&Part { rows: first..first + count, ..self.view.whole() });
        paint(&Scene { paper, field: &self.field, shapes: self.layers.shapes() }, &view)
    }
}
