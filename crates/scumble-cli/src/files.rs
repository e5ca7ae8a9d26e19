//! Files in and out: bounded reading, and writing that leaves either the whole file or nothing.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

use anyhow::{Context, ensure};

/// The bytes of a file, or one byte more than may be read of it.
///
/// # Errors
/// When the file cannot be read.
pub(crate) fn read(path: &Path) -> anyhow::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let read = File::open(path)
        .and_then(|file| file.take(scumble_io::MAX_FILE_BYTES as u64 + 1).read_to_end(&mut bytes));
    read.with_context(|| format!("{} cannot be read", path.display()))?;
    Ok(bytes)
}

/// Writes a file under another name beside it and renames it then, so that it is never there in part. A link is
/// followed; what is no file, such as a pipe or a device, is written to as it is.
///
/// # Errors
/// When the file cannot be written; then nothing is left behind.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> anyhow::Result<()> {
    check_folder(path)?;
    let there = fs::metadata(path);
    let is_read_only = there.as_ref().is_ok_and(|data| data.permissions().readonly());
    ensure!(!is_read_only, "{} cannot be written: it is read-only; name another file", path.display());
    let is_special = there.is_ok_and(|data| !data.is_file());
    let written = if is_special {
        fs::OpenOptions::new().write(true).open(path).and_then(|mut file| file.write_all(bytes))
    } else {
        replace(&fs::canonicalize(path).unwrap_or_else(|_| path.into()), bytes)
    };
    written.with_context(|| format!("{} cannot be written", path.display()))
}

/// Checks, before long work or another file is written, that there is a folder for a file.
///
/// # Errors
/// When there is none.
pub(crate) fn check_folder(path: &Path) -> anyhow::Result<()> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let (file, folder, is_there) = (path.display(), folder.display(), folder.is_dir());
    ensure!(is_there, "{file} cannot be written: there is no folder {folder}; make it, or name another file");
    Ok(())
}

/// Whether two paths name one file that is there.
pub(crate) fn is_same(a: &Path, b: &Path) -> bool {
    matches!((fs::canonicalize(a), fs::canonicalize(b)), (Ok(a), Ok(b)) if a == b)
}

fn replace(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    let unfinished = unfinished(path);
    let written = write_all(&unfinished, bytes).and_then(|()| fs::rename(&unfinished, path));
    if written.is_err() {
        // It may not be there at all; the first error is the one to tell.
        let _ = fs::remove_file(&unfinished);
    }
    written
}

fn write_all(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    let mut file = File::create_new(path)?;
    file.write_all(bytes)?;
    file.sync_all()
}

fn unfinished(path: &Path) -> PathBuf {
    let mut name = OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(format!(".{}.unfinished", std::process::id()));
    path.with_file_name(name)
}

/// The SVG files of a folder, sorted by name.
///
/// # Errors
/// When the folder cannot be read or has none.
pub(crate) fn drawings(folder: &Path) -> anyhow::Result<Vec<PathBuf>> {
    let entries =
        fs::read_dir(folder).with_context(|| format!("the folder {} cannot be read", folder.display()))?;
    let mut paths = entries.map(|entry| entry.map(|entry| entry.path())).collect::<Result<Vec<_>, _>>()?;
    paths.retain(|path| path.extension().is_some_and(|extension| extension == "svg"));
    anyhow::ensure!(!paths.is_empty(), "the folder {} has no SVG files", folder.display());
    paths.sort();
    Ok(paths)
}

/// Tells what was left out of a file.
pub(crate) fn warn(path: &Path, notes: &str) {
    if !notes.is_empty() {
        eprintln!("scumble: warning: {}: {notes}", path.display());
    }
}
