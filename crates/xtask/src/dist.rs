//! The page as a folder of files, `dist/`, which any web host can serve from any path:
//!
//! | path | what |
//! |---|---|
//! | `index.html` | as in the repository, but for indentation and comments, and that it names files of the version's folder |
//! | `worker.js` | the service worker, which keeps all files of this version |
//! | `v-…/` | the version's folder, with all of the following; see [`version`] |
//! | `web/` | icons, what makes the page installable, style sheets and scripts, minified: one of each, but for those that are fetched when they are needed |
//! | `pkg/webgpu/`, `pkg/webgl/` | the editor as wasm, built twice, each with its JavaScript |
//! | `pkg/files/` | what only files and links need, likewise |
//! | `samples/` | the drawings that the page offers, bare and coloured, with thumbnails, `index.json` and licences |

use crate::package::{self, FILES, FLAVOURS};
use crate::process::{minifier, root, run, squeeze};
use crate::{icons, samples, tools, version};
use anyhow::{Context, Result};
use std::fs;
use std::path::{Path, PathBuf};

/// Builds the page; steps whose input is as it was are skipped. Another build of it is waited for.
pub(crate) fn build() -> Result<PathBuf> {
    fs::create_dir_all(root().join("target"))?;
    let lock = fs::File::create(root().join("target/page.lock"))?;
    lock.lock()?;
    tools::rust_target(tools::WASM_TARGET)?;
    tools::npm_packages()?;
    let names = [FILES].into_iter().chain(FLAVOURS);
    let packages = names.map(|name| Ok((name, package::build(name)?))).collect::<Result<Vec<_>>>()?;
    let dist = root().join("dist");
    if dist.exists() {
        fs::remove_dir_all(&dist)?;
    }
    let files = dist.join("files");
    write_web(&root().join("web"), &files.join("web"))?;
    for (name, package) in packages {
        copy_files(files_in(&package)?, &files.join("pkg").join(name))?;
    }
    samples::collect(&files.join("samples"))?;
    version::seal(&dist, &files)?;
    Ok(dist)
}

/// The files directly in a folder, in the order of their names.
pub(crate) fn files_in(folder: &Path) -> Result<Vec<PathBuf>> {
    let entries = fs::read_dir(folder).with_context(|| folder.display().to_string())?;
    let mut paths = entries.map(|entry| Ok(entry?.path())).collect::<Result<Vec<_>>>()?;
    paths.retain(|path| path.is_file());
    paths.sort();
    Ok(paths)
}

/// Writes the page's own files, scripts and styles minified.
fn write_web(from: &Path, to: &Path) -> Result<()> {
    copy_files([from.join("icon.svg"), from.join("manifest.webmanifest")], to)?;
    icons::write(&from.join("icon.svg"), to)?;
    let files = ["main.js", "formats_worker.js", "style.css", "later.css"].map(|name| from.join(name));
    run(minifier().args(["--bundle", "--splitting"]).arg(format!("--outdir={}", to.display())).args(files))?;
    squeeze(&to.join("main.js"))
}

fn copy_files(files: impl IntoIterator<Item = PathBuf>, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    for path in files {
        fs::copy(&path, to.join(path.file_name().unwrap_or_default()))?;
    }
    Ok(())
}
