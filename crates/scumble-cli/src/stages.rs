//! From a file to a picture, stage by stage, each with its time.

use kurbo::Affine;
use scumble_core::drawing::LONGER_SIDE_DU;
use scumble_core::pace::now;
use scumble_core::work::Unknown;
use scumble_core::{ColorPoint, Document, Drawing, Scribble, Settings, Srgb8, Work};
use scumble_io::import_drawing;
use scumble_solve::{Field, Picture, Pixmap, Scene, Shape, SolveError, View, paint};

use crate::clock::timed;

/// White.
pub(crate) const PAPER: Srgb8 = Srgb8([255; 3]);

/// A drawing that is ready for colours, and the milliseconds that it took.
#[derive(Debug)]
pub(crate) struct Opened {
    pub(crate) document: Document,
    /// What it keeps beside that, as the size of its page.
    pub(crate) unknown: Unknown,
    /// What was left out of it.
    pub(crate) notes: String,
    pub(crate) picture: Picture,
    pub(crate) import_ms: f64,
    pub(crate) map_ms: f64,
    pub(crate) mesh_ms: f64,
}

/// Imports, maps and meshes a drawing.
///
/// # Errors
/// When the bytes are no drawing, or it has too many pieces.
pub(crate) fn open(file: &[u8]) -> anyhow::Result<Opened> {
    let (imported, import_ms) = timed(|| import_drawing(file));
    let (Work { document, unknown, .. }, notes) = imported?;
    let (picture, map_ms) = timed(|| Picture::new(&document.drawing));
    let mut picture = picture?;
    let (_, mesh_ms) = timed(|| picture.mesh().triangle_count());
    Ok(Opened { document, unknown, notes, picture, import_ms, map_ms, mesh_ms })
}

/// The milliseconds that scribbles took.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct SpreadTimes {
    pub(crate) color_ms: f64,
    pub(crate) analyse_ms: f64,
    pub(crate) factor_ms: f64,
    pub(crate) solve_ms: f64,
}

impl SpreadTimes {
    pub(crate) fn total_ms(&self) -> f64 {
        self.color_ms + self.analyse_ms + self.factor_ms + self.solve_ms
    }
}

/// Colours the sides and spreads their colours.
///
/// # Errors
/// When the solver fails.
pub(crate) fn spread(
    picture: &mut Picture,
    scribbles: &[Scribble],
    by_hand: &[ColorPoint],
    settings: &Settings,
) -> Result<SpreadTimes, SolveError> {
    let ((), color_ms) = timed(|| now(picture.coloring(scribbles, by_hand, settings)));
    let (solver, boundary) = picture.mesh_and_boundary();
    let ((), analyse_ms) = timed(|| solver.analyse(boundary));
    let (factored, factor_ms) = timed(|| solver.factor());
    factored?;
    let (solved, solve_ms) = timed(|| solver.spread(settings.blend).map(|_| ()));
    solved?;
    Ok(SpreadTimes { color_ms, analyse_ms, factor_ms, solve_ms })
}

/// The whole page with a longer side of so many pixels.
pub(crate) fn page_view(drawing: &Drawing, size_px: u32) -> View {
    let scale = f64::from(size_px) / LONGER_SIDE_DU;
    let size = drawing.size_du() * scale;
    let [width_px, height_px] = [size.width, size.height].map(|side| (side.round() as u32).max(1));
    View { px_from_du: Affine::scale(scale), width_px, height_px }
}

/// Paints a field and shapes over it.
pub(crate) fn paint_page(field: &Field, shapes: &[Shape], view: &View, paper: Option<Srgb8>) -> Pixmap {
    paint(&Scene { paper, field, shapes }, view)
}
