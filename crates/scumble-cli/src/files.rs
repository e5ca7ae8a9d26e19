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

/// [`write_together`] for one file.
///
/// # Errors
/// When it cannot be written; then nothing is left behind.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> anyhow::Result<()> {
    write_together(&[(path, bytes)])
}

/// Writes files under other names beside them and renames them once all are there, so that none is ever there in part, nor
/// without the others, unless renaming fails. A link is followed; what is no file, such as a pipe or a device, is written to as
/// it is, before any file is renamed.
///
/// # Errors
/// When one cannot be written; then no file is there in part.
pub(crate) fn write_together(files: &[(&Path, &[u8])]) -> anyhow::Result<()> {
    let unfinished = files.iter().map(|(path, bytes)| Unfinished::new(path, bytes));
    let mut unfinished = unfinished.collect::<anyhow::Result<Vec<_>>>()?;
    unfinished.sort_by_key(|file| file.places.is_some());
    unfinished.iter().try_for_each(Unfinished::finish)
}

/// Checks, before long work, that there is a folder for a file, and none in its place.
///
/// # Errors
/// When it is not so.
pub(crate) fn check_folder(path: &Path) -> anyhow::Result<()> {
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let (file, folder, is_there) = (path.display(), folder.display(), folder.is_dir());
    ensure!(is_there, "{file} cannot be written: there is no folder {folder}; make it, or name another file");
    ensure!(!path.is_dir(), "{file} cannot be written: it is a folder; name a file");
    Ok(())
}

/// Whether two paths name one file that is there.
pub(crate) fn is_same(a: &Path, b: &Path) -> bool {
    matches!((fs::canonicalize(a), fs::canonicalize(b)), (Ok(a), Ok(b)) if a == b)
}

/// A file that is not at its place yet. What there is of it goes where it is dropped before.
struct Unfinished<'a> {
    path: &'a Path,
    bytes: &'a [u8],
    /// Where it is until then, and its place; none for a pipe or a device.
    places: Option<[PathBuf; 2]>,
}

impl<'a> Unfinished<'a> {
    fn new(path: &'a Path, bytes: &'a [u8]) -> anyhow::Result<Self> {
        check_folder(path)?;
        let there = fs::metadata(path);
        let is_read_only = there.as_ref().is_ok_and(|data| data.permissions().readonly());
        ensure!(!is_read_only, "{} cannot be written: it is read-only; name another file", path.display());
        if there.is_ok_and(|data| !data.is_file()) {
            return Ok(Self { path, bytes, places: None });
        }
        let place = fs::canonicalize(path).unwrap_or_else(|_| path.into());
        let until_then = unfinished(&place);
        let written = write_all(&until_then, bytes);
        let file = Self { path, bytes, places: Some([until_then, place]) };
        written.with_context(|| file.failure())?;
        Ok(file)
    }

    fn finish(&self) -> anyhow::Result<()> {
        let finished = match &self.places {
            Some([from, to]) => fs::rename(from, to),
            None => {
                let file = fs::OpenOptions::new().write(true).open(self.path);
                file.and_then(|mut file| file.write_all(self.bytes))
            }
        };
        finished.with_context(|| self.failure())
    }

    fn failure(&self) -> String {
        format!("{} cannot be written", self.path.display())
    }
}

impl Drop for Unfinished<'_> {
    fn drop(&mut self) {
        if let Some([from, _]) = &self.places {
            // A finished one is not there any more.
            let _ = fs::remove_file(from);
        }
    }
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
    paths.retain(|path| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("svg")));
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
