//! `scumble render`: the picture of some work; and the painting that it shares with `scumble color`.

use anyhow::ensure;
use scumble_core::drawing::LONGER_SIDE_DU;
use scumble_core::{Blend, Boundary, Document, Drawing};
use scumble_io::write_png;
use scumble_solve::{Picture, Pixmap, Shape, SolveError, line_shapes};

use crate::options::{Look, RenderOptions};
use crate::stages::{self, PAPER};
use crate::{files, works};

/// Largest distance of a drawn line from its true place, in pixels.
const LINE_TOLERANCE_PX: f64 = 0.1;

/// Makes the picture and writes it.
///
/// # Errors
/// When the file is bad or the picture cannot be written; then there is no picture.
pub(crate) fn run(options: &RenderOptions) -> anyhow::Result<()> {
    let is_same = files::is_same(&options.file, &options.output);
    ensure!(!is_same, "{} is read; name another file for the picture", options.file.display());
    let mut work = works::read(&options.file)?;
    works::fetch_lines(&mut work, options.samples.as_deref())?;
    let Document { drawing, scribbles, color_points, settings, .. } = &work.document;
    let mut picture = Picture::new(drawing)?;
    let (boundary, _) = stages::spread(&mut picture, scribbles, color_points, settings)?;
    let pixmap = paint(drawing, &mut picture, &boundary, settings.blend, &options.look)?;
    files::write(&options.output, &write_png(pixmap.width_px, pixmap.height_px, &pixmap.rgba)?)
}

/// Paints the whole page.
///
/// # Errors
/// When the solver fails.
pub(crate) fn paint(
    drawing: &Drawing,
    picture: &mut Picture,
    boundary: &Boundary,
    blend: Blend,
    look: &Look,
) -> Result<Pixmap, SolveError> {
    let view = stages::page_view(drawing, look.size_px);
    let shapes = shapes(drawing, picture, look);
    let field = picture.mesh().solve(boundary, blend)?;
    Ok(stages::paint_page(field, &shapes, &view, (!look.transparent).then_some(PAPER)))
}

/// What is painted over the colours.
pub(crate) fn shapes(drawing: &Drawing, picture: &Picture, look: &Look) -> Vec<Shape> {
    let tolerance_du = LINE_TOLERANCE_PX * LONGER_SIDE_DU / f64::from(look.size_px);
    if look.lines { line_shapes(drawing, picture.map(), tolerance_du) } else { Vec::new() }
}
