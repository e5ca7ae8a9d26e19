//! Work in and out of files, whichever kind they are: `.svg`, `.scumble`, or the latter as `.json`.

use std::path::Path;

use anyhow::{Context, bail, ensure};
use scumble_core::Work;
use scumble_io::{import_svg, open_svg, read_file, write_file};

use crate::files;

/// Reads a drawing, or work with its scribbles.
///
/// # Errors
/// When the file cannot be read, or is no such file, or lacks its lines.
pub(crate) fn read(path: &Path) -> anyhow::Result<Work> {
    let bytes = files::read(path)?;
    if extension(path) == "svg" {
        let (work, notes) = open_svg(&bytes).with_context(|| path.display().to_string())?;
        files::warn(path, &notes);
        return Ok(work);
    }
    read_file(&bytes).with_context(|| path.display().to_string())
}

/// Writes work as its file.
///
/// # Errors
/// When it could not be read again, or cannot be written; then there is no file.
pub(crate) fn write(path: &Path, work: &Work) -> anyhow::Result<()> {
    files::write(path, &write_file(work)?)
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
            "it is a colouring of the sample {name}; name the folder with the samples: --samples dist/samples"
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
