//! `scumble render`: the picture of some work; and the painting that it shares with `scumble color`.

use anyhow::ensure;
use scumble_core::drawing::LONGER_SIDE_DU;
use scumble_core::{Document, Drawing};
use scumble_export::{Export, PX_PER_DU};
use scumble_io::{PageSize, write_png};
use scumble_solve::{Field, Picture, Pixmap, Shape, SolveError, line_shapes};

use crate::options::{Format, Look, RenderOptions};
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
    stages::spread(&mut picture, scribbles, color_points, settings)?;
    let look = &options.look;
    let bytes = if options.format == Format::Png {
        let pixmap = paint(drawing, &mut picture, look)?;
        write_png(pixmap.width_px, pixmap.height_px, &pixmap.rgba)?
    } else {
        let field = &field_at(drawing, &mut picture, PX_PER_DU)?;
        let paper = (!look.transparent).then_some(PAPER);
        let own_px = PageSize::of(&work).map(|own| own.longer_px());
        let size_px = look.asked_px.or(own_px).unwrap_or_else(|| look.size_px());
        let look = scumble_export::Look { size_px, lines: look.lines, paper };
        written(&Export::new(&work, field, look), field, options.format)?
    };
    files::write(&options.output, &bytes)
}

/// A picture for other programs.
fn written(export: &Export<'_>, field: &Field, format: Format) -> anyhow::Result<Vec<u8>> {
    if format == Format::Pdf {
        return Ok(export.pdf());
    }
    let raster = export.raster_view().map(|view| {
        let pixmap = stages::paint_page(field, &[], &view, export.look().paper);
        write_png(pixmap.width_px, pixmap.height_px, &pixmap.rgba)
    });
    Ok(export.svg(raster.transpose()?.as_deref())?.into_bytes())
}

/// Paints the whole page of a picture with its colours.
///
/// # Errors
/// When the solver fails.
pub(crate) fn paint(drawing: &Drawing, picture: &mut Picture, look: &Look) -> Result<Pixmap, SolveError> {
    let view = stages::page_view(drawing, look.size_px());
    let shapes = shapes(drawing, picture, look);
    let field = field_at(drawing, picture, f64::from(look.size_px()) / LONGER_SIDE_DU)?;
    Ok(stages::paint_page(&field, &shapes, &view, (!look.transparent).then_some(PAPER)))
}

/// The field of the whole page as it is seen at a scale.
fn field_at(drawing: &Drawing, picture: &mut Picture, px_per_du: f64) -> Result<Field, SolveError> {
    let field = picture.solve()?.clone();
    Ok(picture.close_up(drawing, drawing.frame(), px_per_du).unwrap_or(field))
}

/// What is painted over the colours.
pub(crate) fn shapes(drawing: &Drawing, picture: &Picture, look: &Look) -> Vec<Shape> {
    let tolerance_du = LINE_TOLERANCE_PX * LONGER_SIDE_DU / f64::from(look.size_px());
    if look.lines { line_shapes(drawing, Some(picture.map()), tolerance_du) } else { Vec::new() }
}
