//! All that is derived from a document: map, labels, colour points, field. Kept, and redone where the source
//! changed.

use scumble_core::{
    Boundary, ColorPoint, Document, Drawing, Engine, Labels, MapError, PlanarMap, Sampling, Scribble,
    Settings, boundary,
};

use crate::field::Field;
use crate::mesh::{MeshSolver, SolveError};

/// The picture of one drawing under changing scribbles.
///
/// The stages are [`Picture::new`] (map), [`Picture::mesh`], [`Picture::color`] and the solver's own; a caller
/// that does not care calls [`Picture::update`].
#[derive(Debug)]
pub struct Picture {
    map: PlanarMap,
    /// The engine and the settings that it was made for.
    engine: Box<dyn Engine>,
    settings: Settings,
    solver: Option<MeshSolver>,
}

impl Picture {
    /// Builds the planar map of a drawing.
    ///
    /// # Errors
    /// When the drawing has too many pieces.
    pub fn new(drawing: &Drawing) -> Result<Self, MapError> {
        let settings = Settings::default();
        let map = PlanarMap::build(drawing, &Sampling::default())?.with_gaps_closed(settings.gap_closing);
        Ok(Self { map, engine: settings.engine(), settings, solver: None })
    }

    /// The same drawing, of which nothing but the map is known.
    pub fn again(&self) -> Self {
        let Self { map, settings, .. } = self;
        Self { map: map.clone(), engine: settings.engine(), settings: *settings, solver: None }
    }

    /// The settings of the last labels.
    pub fn settings(&self) -> &Settings {
        &self.settings
    }

    /// Whether labels by other settings take neither another map nor another engine.
    pub fn suits(&self, settings: &Settings) -> bool {
        let settings = settings.clamped();
        self.settings.gap_closing == settings.gap_closing && self.settings.share_engine(&settings)
    }

    /// The planar map of the drawing.
    pub fn map(&self) -> &PlanarMap {
        &self.map
    }

    /// The solver on the refined map; meshes at the first call.
    pub fn mesh(&mut self) -> &mut MeshSolver {
        let map = &self.map;
        self.solver.get_or_insert_with(|| MeshSolver::new(map.refined().clone()))
    }

    /// Whether [`Picture::mesh`] has been called since the map is what it is.
    pub fn has_mesh(&self) -> bool {
        self.solver.is_some()
    }

    /// The labels of the sides and gaps, by the scribbles that fill; they name scribbles by their indices among all.
    pub fn label(&mut self, scribbles: &[Scribble], settings: &Settings) -> Labels {
        let settings = settings.clamped();
        let before = std::mem::replace(&mut self.settings, settings);
        let is_other_map =
            before.gap_closing != settings.gap_closing && self.map.close_gaps(settings.gap_closing);
        if is_other_map {
            self.solver = None;
        }
        if is_other_map || !before.share_engine(&settings) {
            self.engine = settings.engine();
        }
        self.label_fills(scribbles)
    }

    fn label_fills(&mut self, scribbles: &[Scribble]) -> Labels {
        if scribbles.iter().all(Scribble::is_fill) {
            return self.engine.label(&self.map, scribbles);
        }
        let (places, fills): (Vec<_>, Vec<_>) = (0..)
            .zip(scribbles)
            .filter(|(_, scribble)| scribble.is_fill())
            .map(|(i, s)| (i, s.clone()))
            .unzip();
        let mut labels = self.engine.label(&self.map, &fills);
        for label in labels.sides.iter_mut().flatten() {
            *label = places[*label as usize];
        }
        labels
    }

    /// The colours that scribbles and points set by hand give the sides, and the gaps that the scribbles leave closed.
    pub fn color(&mut self, scribbles: &[Scribble], by_hand: &[ColorPoint], settings: &Settings) -> Boundary {
        let labels = self.label(scribbles, settings);
        boundary(&self.map, &labels, scribbles, by_hand, settings.blend)
    }

    /// The colour field of a document with the drawing that this picture was made for.
    ///
    /// # Errors
    /// When the solver fails.
    pub fn update(&mut self, document: &Document) -> Result<&Field, SolveError> {
        let Document { scribbles, color_points, settings, .. } = document;
        let boundary = self.color(scribbles, color_points, settings);
        self.mesh().solve(&boundary, document.settings.blend)
    }
}
