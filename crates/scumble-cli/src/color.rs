//! `scumble color`: one picture from a drawing and scribbles.

mod on_pixels;
mod parts;

use std::path::Path;

use anyhow::{Context, ensure};
use scumble_core::{Document, Scribble, Work};
use scumble_io::{FileError, ReadScribbles, keeps_work, read_scribbles, write_file, write_png};
use scumble_solve::{Pixmap, SolveError};
use serde::Serialize;

use crate::clock::timed;
use crate::options::{ColorOptions, Solver};
use crate::stages::{self, Opened, SpreadTimes};
use crate::{files, render, works};

pub(crate) use parts::MOST_PX;

/// What `--timings` prints.
#[derive(Debug, Serialize)]
struct Timings {
    counts: Counts,
    ms: Milliseconds,
}

#[derive(Debug, Serialize)]
struct Counts {
    curves: usize,
    pieces: usize,
    triangles: usize,
    unknowns: usize,
}

/// `analyse` and `factor` are sums over all scribbles; `color` and `solve` have one time for each.
#[derive(Debug, Serialize)]
struct Milliseconds {
    import: f64,
    map: f64,
    mesh: f64,
    analyse: f64,
    factor: f64,
    color: Vec<f64>,
    solve: Vec<f64>,
    paint: f64,
}

/// Makes the picture and writes it.
///
/// # Errors
/// When the input is bad or the picture cannot be written; then there is no file.
pub(crate) fn run(options: &ColorOptions) -> anyhow::Result<()> {
    check_files(options)?;
    let mut opened = open(&options.drawing)?;
    let read = read_scribbles(&files::read(&options.scribbles)?, &opened.document.drawing);
    let ReadScribbles { scribbles, notes } = read.with_context(|| options.scribbles.display().to_string())?;
    let kept = kept(&opened, &scribbles, options)?;
    files::warn(&options.drawing, &opened.notes);
    files::warn(&options.scribbles, &notes.to_string());
    if options.solver != Solver::Mesh {
        let by_hand = &opened.document.color_points;
        opened.picture.color(&scribbles, by_hand, &options.settings);
        return write(&on_pixels::paint(&opened, options)?, kept.as_deref(), options);
    }
    let times = spread(&mut opened, &scribbles, options)?;
    let Opened { document, picture, .. } = &mut opened;
    let drawing = &document.drawing;
    let (pixmap, paint_ms) = timed(|| render::paint(drawing, picture, &options.look));
    write(&pixmap?, kept.as_deref(), options)?;
    if options.timings {
        println!("{}", serde_json::to_string(&timings(&mut opened, &times, paint_ms))?);
    }
    Ok(())
}

/// Checks that what is written is not what is read, nor one file for both, and has a folder.
fn check_files(options: &ColorOptions) -> anyhow::Result<()> {
    for input in [&options.drawing, &options.scribbles] {
        let is_same = |output: &Path| files::is_same(input, output);
        ensure!(!is_same(&options.output), "{} is read; name another file for the picture", input.display());
        let is_saved_over = options.save.as_deref().is_some_and(is_same);
        ensure!(!is_saved_over, "{} is read; name another file to save", input.display());
    }
    let is_both = options.save.as_deref().is_some_and(|save| files::is_same(save, &options.output));
    ensure!(!is_both, "{} is the picture; name another file to save", options.output.display());
    files::check_folder(&options.output)?;
    options.save.as_deref().map_or(Ok(()), files::check_folder)
}

/// A drawing without scribbles of its own: those would be lost, and its units are no longer those of its viewBox.
fn open(path: &Path) -> anyhow::Result<Opened> {
    let (name, bytes) = (path.display(), files::read(path)?);
    ensure!(
        !works::is_work(path, &bytes),
        "{name} is no SVG; `scumble render` makes the picture of a .scumble file"
    );
    ensure!(
        !keeps_work(&bytes),
        "{name} was made of a .scumble file, which it keeps; `scumble render` makes its picture"
    );
    stages::open(&bytes).with_context(|| name.to_string())
}

/// Writes the picture and the file that keeps its source, if there is one: both or none.
fn write(pixmap: &Pixmap, kept: Option<&[u8]>, options: &ColorOptions) -> anyhow::Result<()> {
    let picture = write_png(pixmap.width_px, pixmap.height_px, &pixmap.rgba)?;
    let source = options.save.as_deref().zip(kept);
    let files: Vec<_> = [(&*options.output, &picture[..])].into_iter().chain(source).collect();
    files::write_together(&files)
}

/// The file that keeps the drawing with its scribbles, if it is to be kept.
fn kept(
    opened: &Opened,
    scribbles: &[Scribble],
    options: &ColorOptions,
) -> Result<Option<Vec<u8>>, FileError> {
    if options.save.is_none() {
        return Ok(None);
    }
    let (settings, scribbles) = (options.settings, scribbles.to_vec());
    let document = Document { scribbles, settings, ..opened.document.clone() };
    let work = Work { unknown: opened.unknown.clone(), ..Work::new(document) };
    write_file(&work).map(Some)
}

/// Spreads the colours: of all scribbles at once or, where each is to be timed, of one more at a time.
fn spread(
    opened: &mut Opened,
    scribbles: &[Scribble],
    options: &ColorOptions,
) -> Result<Vec<SpreadTimes>, SolveError> {
    let Opened { document, picture, .. } = opened;
    let mut spread =
        |scribbles| stages::spread(picture, scribbles, &document.color_points, &options.settings);
    let mut times = Vec::new();
    if options.timings {
        for count in 1..scribbles.len() {
            times.push(spread(&scribbles[..count])?);
        }
    }
    let last = spread(scribbles)?;
    times.extend((!scribbles.is_empty()).then_some(last));
    Ok(times)
}

fn timings(opened: &mut Opened, times: &[SpreadTimes], paint_ms: f64) -> Timings {
    let counts = Counts {
        curves: opened.document.drawing.curves.len(),
        pieces: opened.picture.map().pieces().len(),
        triangles: opened.picture.mesh().triangle_count(),
        unknowns: opened.picture.mesh().unknown_count(),
    };
    let each = |of: fn(&SpreadTimes) -> f64| times.iter().map(of).map(rounded).collect();
    let sum = |of: fn(&SpreadTimes) -> f64| rounded(times.iter().map(of).sum());
    let ms = Milliseconds {
        import: rounded(opened.import_ms),
        map: rounded(opened.map_ms),
        mesh: rounded(opened.mesh_ms),
        analyse: sum(|times| times.analyse_ms),
        factor: sum(|times| times.factor_ms),
        color: each(|times| times.color_ms),
        solve: each(|times| times.solve_ms),
        paint: rounded(paint_ms),
    };
    Timings { counts, ms }
}

/// Microseconds are as fine as the figures mean anything.
fn rounded(ms: f64) -> f64 {
    (ms * 1e3).round() / 1e3
}
