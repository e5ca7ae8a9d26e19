//! `scumble link`, `scumble open`, `scumble convert`: work as a link, and as a file again.

use anyhow::ensure;
use scumble_core::{Curve, Drawing, Work};
use scumble_io::{Link, read_link, write_link};

use crate::options::{ConvertOptions, LinkOptions, OpenOptions};
use crate::{files, palettes, works};

/// Prints a link, as the last line.
///
/// # Errors
/// When the file is bad, or too large for a link.
pub(crate) fn link(options: &LinkOptions) -> anyhow::Result<()> {
    let work = works::read(&options.file)?;
    let link = write_link(&work)?;
    files::warn(&options.file, if work.image.is_empty() { "" } else { "left out: the tracing image" });
    if options.stats {
        print!("{}", stats(&work, &link));
    }
    println!("{}{}", options.base, link.fragment);
    Ok(())
}

/// A table of what takes how much of a link.
fn stats(work: &Work, Link { fragment, sizes }: &Link) -> String {
    let drawing = &work.document.drawing;
    let line_points = if work.sample.is_some() { 0 } else { line_points(drawing) };
    let lines = if work.sample.is_some() { 0 } else { drawing.curves.len() + drawing.fills.len() };
    let color_points = work.document.scribbles.iter().map(|scribble| scribble.points.len()).sum();
    let colors = work.document.scribbles.len() + work.document.color_points.len();
    let rest = sizes.all - sizes.head - sizes.lines - sizes.colors;
    let rows = [
        row("page, settings", 0, 0, sizes.head),
        row("lines", lines, line_points, sizes.lines),
        row("scribbles", colors, color_points, sizes.colors),
        row("the rest", 0, 0, rest),
        row("all", lines + colors, line_points + color_points, sizes.all),
    ];
    let head =
        format!("{:<16}{:>8}{:>8}{:>8}{:>16}\n", "part", "items", "points", "bytes", "bytes per point");
    format!("{head}{}{} characters\n", rows.concat(), fragment.len())
}

fn row(part: &str, items: usize, points: usize, bytes: usize) -> String {
    let count = |count: usize| if count > 0 { count.to_string() } else { "–".into() };
    let per_point = if points > 0 { format!("{:.2}", bytes as f64 / points as f64) } else { "–".into() };
    format!("{part:<16}{:>8}{:>8}{bytes:>8}{per_point:>16}\n", count(items), count(points))
}

/// Points and handles of all curves and areas.
fn line_points(drawing: &Drawing) -> usize {
    let curves = drawing.curves.iter().map(|Curve { path, .. }| path);
    let elements = curves.chain(drawing.fills.iter().map(|fill| &fill.path)).flat_map(|path| path.iter());
    elements
        .map(|element| match element {
            kurbo::PathEl::MoveTo(_) | kurbo::PathEl::LineTo(_) => 1,
            kurbo::PathEl::QuadTo(..) => 2,
            kurbo::PathEl::CurveTo(..) => 3,
            kurbo::PathEl::ClosePath => 0,
        })
        .sum()
}

/// Turns a link into a file.
///
/// # Errors
/// When the link is none, or damaged; then nothing is written.
pub(crate) fn open(options: &OpenOptions) -> anyhow::Result<()> {
    let mut work = read_link(&options.link)?;
    works::fetch_lines(&mut work, options.samples.as_deref())?;
    works::write(&options.output, &work)
}

/// Turns one file into another.
///
/// # Errors
/// When the file is bad; then nothing is written.
pub(crate) fn convert(ConvertOptions { from, to, samples }: &ConvertOptions) -> anyhow::Result<()> {
    ensure!(!files::is_same(from, to), "{} is read; name another file to write", from.display());
    if let Some(kind) = works::palette_kind(to) {
        return palettes::write(to, &palettes::read(from)?, kind);
    }
    let mut work = works::read(from)?;
    if samples.is_some() || works::extension(to) == "xml" {
        works::fetch_lines(&mut work, samples.as_deref())?;
    }
    works::write(to, &work)
}
