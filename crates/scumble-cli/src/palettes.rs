//! `scumble palette`: the colours of another program's palette for a drawing; and palettes in and out of files.

use std::path::Path;

use anyhow::{Context, ensure};
use scumble_core::Swatch;
use scumble_io::{PaletteKind, read_palette, write_palette};

use crate::options::PaletteOptions;
use crate::{files, works};

/// Gives work another palette.
///
/// # Errors
/// When either file is bad; then nothing is written.
pub(crate) fn run(options: &PaletteOptions) -> anyhow::Result<()> {
    for input in [&options.file, &options.from] {
        let is_same = files::is_same(input, &options.output);
        ensure!(!is_same, "{} is read; name another file to write", input.display());
    }
    let mut work = works::read(&options.file)?;
    work.document.palette = read_file(&options.from)?;
    works::write(&options.output, &work)
}

/// The swatches of a palette, or those of the palette that is kept with work.
///
/// # Errors
/// When the file is bad or has no colours.
pub(crate) fn read(path: &Path) -> anyhow::Result<Vec<Swatch>> {
    if works::palette_kind(path).is_some() {
        return read_file(path);
    }
    let palette = works::read(path)?.document.palette;
    let advice = "give it one with scumble palette";
    ensure!(!palette.is_empty(), "{} has no palette of its own; {advice}", path.display());
    Ok(palette)
}

fn read_file(path: &Path) -> anyhow::Result<Vec<Swatch>> {
    let palette = read_palette(&files::read(path)?, works::palette_kind(path))
        .with_context(|| path.display().to_string())?;
    files::warn(path, &palette.notes());
    Ok(palette.swatches)
}

/// Writes a palette.
///
/// # Errors
/// When it has no colours or cannot be written; then there is no file.
pub(crate) fn write(path: &Path, palette: &[Swatch], kind: PaletteKind) -> anyhow::Result<()> {
    files::write(path, &write_palette(palette, kind)?)
}
