//! `scumble color`: one picture from a drawing and scribbles.

mod on_pixels;

use anyhow::ensure;
use scumble_core::drawing::LONGER_SIDE_DU;
use scumble_core::{Boundary, Drawing, Scribble};
use scumble_io::{ReadScribbles, read_scribbles, write_png};
use scumble_solve::{Pixmap, Shape, SolveError, line_shapes};
use serde::Serialize;

use crate::clock::timed;
use crate::files;
use crate::options::{ColorOptions, Solver};
use crate::stages::{self, Opened, PAPER, SpreadTimes};

/// Largest distance of a drawn line from its true place, in pixels.
const LINE_TOLERANCE_PX: f64 = 0.1;

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
    for input in [&options.drawing, &options.scribbles] {
        let is_same = files::is_same(input, &options.output);
        ensure!(!is_same, "{} is read; name another file for the picture", input.display());
    }
    let mut opened = stages::open(&files::read(&options.drawing)?)?;
    let ReadScribbles { scribbles, notes } =
        read_scribbles(&files::read(&options.scribbles)?, drawing(&opened))?;
    warn(&options.drawing, &opened.import.notes.to_string());
    warn(&options.scribbles, &notes.to_string());
    if options.solver != Solver::Mesh {
        let boundary = opened.picture.color(&scribbles, &options.settings);
        let pixmap = on_pixels::paint(&opened, &boundary, options)?;
        return files::write(&options.output, &write_png(pixmap.width_px, pixmap.height_px, &pixmap.rgba)?);
    }
    let (colors, times) = spread(&mut opened, &scribbles, options)?;
    let (pixmap, paint_ms) = timed(|| paint(&mut opened, &colors, options));
    let pixmap = pixmap?;
    files::write(&options.output, &write_png(pixmap.width_px, pixmap.height_px, &pixmap.rgba)?)?;
    if options.timings {
        println!("{}", serde_json::to_string(&timings(&mut opened, &times, paint_ms))?);
    }
    Ok(())
}

fn drawing(opened: &Opened) -> &Drawing {
    &opened.import.drawing
}

fn warn(path: &std::path::Path, notes: &str) {
    if !notes.is_empty() {
        eprintln!("scumble: warning: {}: {notes}", path.display());
    }
}

/// Spreads the colours: of all scribbles at once or, where each is to be timed, of one more at a time.
fn spread(
    opened: &mut Opened,
    scribbles: &[Scribble],
    options: &ColorOptions,
) -> Result<(Boundary, Vec<SpreadTimes>), SolveError> {
    let mut times = Vec::new();
    if options.timings {
        for count in 1..scribbles.len() {
            times.push(stages::spread(&mut opened.picture, &scribbles[..count], &options.settings)?.1);
        }
    }
    let (boundary, last) = stages::spread(&mut opened.picture, scribbles, &options.settings)?;
    times.extend((!scribbles.is_empty()).then_some(last));
    Ok((boundary, times))
}

fn paint(opened: &mut Opened, boundary: &Boundary, options: &ColorOptions) -> Result<Pixmap, SolveError> {
    let view = stages::page_view(drawing(opened), options.size_px);
    let shapes = shapes(opened, options);
    let field = opened.picture.mesh().solve(boundary, options.settings.blend)?;
    Ok(stages::paint_page(field, &shapes, &view, (!options.transparent).then_some(PAPER)))
}

/// What is painted over the colours.
fn shapes(opened: &Opened, options: &ColorOptions) -> Vec<Shape> {
    if options.lines { lines(opened, options.size_px) } else { Vec::new() }
}

fn lines(opened: &Opened, size_px: u32) -> Vec<Shape> {
    let tolerance_du = LINE_TOLERANCE_PX * LONGER_SIDE_DU / f64::from(size_px);
    line_shapes(drawing(opened), opened.picture.map(), tolerance_du)
}

fn timings(opened: &mut Opened, times: &[SpreadTimes], paint_ms: f64) -> Timings {
    let counts = Counts {
        curves: drawing(opened).curves.len(),
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
