//! Work in and out of files, whichever kind they are: `.svg` or `.xml`, `.scumble`, or the latter as `.json`. What is read is
//! told by how it begins.

use std::path::Path;

use anyhow::{Context, bail, ensure};
use scumble_core::{Document, Work};
use scumble_io::{
    MAX_FILE_BYTES, PaletteKind, import_drawing, import_svg, read_file, write_curve_set, write_file,
};
use scumble_solve::Picture;

use crate::files;

/// Reads a drawing, or work with its scribbles.
///
/// # Errors
/// When the file cannot be read, or is no such file, or lacks its lines.
pub(crate) fn read(path: &Path) -> anyhow::Result<Work> {
    let bytes = files::read(path)?;
    if is_work(path, &bytes) {
        return read_file(&bytes).with_context(|| path.display().to_string());
    }
    let (work, notes) = import_drawing(&bytes).with_context(|| path.display().to_string())?;
    files::warn(path, &notes);
    Ok(work)
}

/// Whether a file is meant as one of ours: by how it begins or, if that tells nothing, by what it is called.
pub(crate) fn is_work(path: &Path, bytes: &[u8]) -> bool {
    match bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes).trim_ascii_start() {
        [b'{', ..] => true,
        [b'<', ..] => false,
        _ => matches!(&*extension(path), "scumble" | "json") || palette_kind(path).is_some(),
    }
}

/// Writes work as its file, or the colours of its picture as diffusion curves.
///
/// # Errors
/// When it could not be read again, or cannot be written; then there is no file.
pub(crate) fn write(path: &Path, work: &Work) -> anyhow::Result<()> {
    match &*extension(path) {
        "xml" => write_curves(path, &work.document),
        _ => files::write(path, &write_file(work)?),
    }
}

fn write_curves(path: &Path, document: &Document) -> anyhow::Result<()> {
    let mut picture = Picture::new(&document.drawing)?;
    let labels = picture.label(&document.scribbles, &document.settings);
    let (text, notes) = write_curve_set(document, picture.map(), &labels);
    let (name, limit_mb) = (path.display(), MAX_FILE_BYTES / 1_000_000);
    let is_readable = text.len() <= MAX_FILE_BYTES;
    ensure!(
        is_readable,
        "{name} would be larger than the {limit_mb} MB that can be opened; simplify the drawing"
    );
    files::warn(path, &notes.to_string());
    files::write(path, text.as_bytes())
}

/// Checks that a file's name is that of a kind that can be written.
///
/// # Errors
/// When it is not.
pub(crate) fn check_writable(path: &Path) -> anyhow::Result<()> {
    let is_ours = matches!(&*extension(path), "scumble" | "json");
    ensure!(is_ours, "{} cannot be written; name a file that ends in .scumble or .json", path.display());
    Ok(())
}

/// Checks that a file's name is that of a kind that work can be turned into.
///
/// # Errors
/// When it is not.
pub(crate) fn check_convertible(path: &Path) -> anyhow::Result<()> {
    let is_known = matches!(&*extension(path), "scumble" | "json" | "xml") || palette_kind(path).is_some();
    let name = path.display();
    ensure!(
        is_known,
        "{name} cannot be written; name a file that ends in .scumble, .json, .xml, .gpl, .ase or .hex"
    );
    Ok(())
}

/// The kind of palette that a file's name is that of.
pub(crate) fn palette_kind(path: &Path) -> Option<PaletteKind> {
    PaletteKind::of_extension(&extension(path))
}

/// Puts the lines of a sample where work has only its name.
///
/// # Errors
/// When no folder is named, or the sample is not in it.
pub(crate) fn fetch_lines(work: &mut Work, samples: Option<&Path>) -> anyhow::Result<()> {
    let Some(name) = work.sample.as_ref().filter(|_| work.document.drawing.curves.is_empty()) else {
        return Ok(());
    };
    let Some(samples) = samples else {
        bail!(
            "it is a colouring of the sample {name}; name the folder with the samples: --samples dist/*/samples"
        );
    };
    let path = samples.join(name);
    work.document.drawing =
        import_svg(&files::read(&path)?).with_context(|| path.display().to_string())?.drawing;
    Ok(())
}

/// What a file's name ends in, in small letters.
pub(crate) fn extension(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_ascii_lowercase()
}
