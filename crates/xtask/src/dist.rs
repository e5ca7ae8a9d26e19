//! The page as a folder of files, `dist/`, which any web host can serve from any path:
//!
//! | path | what |
//! |---|---|
//! | `index.html` | as in the repository, but that it names files of the version's folder |
//! | `worker.js` | the service worker, which keeps all files of this version |
//! | `v-…/` | the version's folder, with all of the following; see [`version`] |
//! | `web/` | icons, what makes the page installable, style sheet, and all scripts, minified: as one, but for those that are fetched when they are needed |
//! | `pkg/webgpu/`, `pkg/webgl/` | the editor as wasm, built twice, each with its JavaScript |
//! | `pkg/files/` | what only files and links need, likewise |
//! | `samples/` | the drawings that the page offers, bare and coloured, with thumbnails, `index.json` and licences |

use crate::process::{cargo, command, node, root, run};
use crate::{icons, samples, tools, version};
use anyhow::{Context, Result};
use std::fs;
use std::path::{Path, PathBuf};

/// The two builds of `scumble-web`, by the feature that tells them apart.
pub(crate) const FLAVOURS: [&str; 2] = ["webgpu", "webgl"];

/// The build of `scumble-files`.
const FILES: &str = "files";

/// The features of wasm that every browser with WebGPU or WebGL 2 has; `--all-features` would use others. Functions
/// that are called once stay functions: inlined they compress worse, by 3% of the whole.
const WASM_OPT: [&str; 12] = [
    "-O2",
    "--one-caller-inline-max-function-size=0",
    // Neighbours by name are neighbours by kind, and compress better.
    "--reorder-functions-by-name",
    "--strip-producers",
    "--strip-target-features",
    "--enable-bulk-memory",
    "--enable-nontrapping-float-to-int",
    "--enable-sign-ext",
    "--enable-mutable-globals",
    "--enable-reference-types",
    "--enable-multivalue",
    "--enable-simd",
];

/// Builds the page; steps whose input is as it was are skipped. Another build of it is waited for.
pub(crate) fn build() -> Result<PathBuf> {
    fs::create_dir_all(root().join("target"))?;
    let lock = fs::File::create(root().join("target/page.lock"))?;
    lock.lock()?;
    tools::rust_target(tools::WASM_TARGET)?;
    tools::npm_packages()?;
    let names = [FILES].into_iter().chain(FLAVOURS);
    let packages = names.map(|name| Ok((name, package(name)?))).collect::<Result<Vec<_>>>()?;
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

/// The folder with one wasm build and its JavaScript, ready to be served.
fn package(name: &str) -> Result<PathBuf> {
    let wasm = compile(name)?;
    tools::wasm_bindgen()?;
    let work = root().join("target/page").join(name);
    let (seen, package) = (work.join("seen"), work.join("package"));
    // The tools and their settings are part of it, so that a change of them runs the steps again.
    let tools = fs::read(root().join("package-lock.json"))?;
    let input = [fs::read(&wasm)?, tools, WASM_OPT.concat().into()].concat();
    if fs::read(&seen).is_ok_and(|seen| seen == input) {
        return Ok(package);
    }
    if work.exists() {
        fs::remove_dir_all(&work)?;
    }
    bind(&wasm, &package)?;
    let module = crate_of(name).replace('-', "_");
    optimise(&package.join(format!("{module}_bg.wasm")))?;
    minify(&package, &[package.join(format!("{module}.js"))])?;
    fs::write(seen, input)?;
    Ok(package)
}

/// The crate that a build is of.
fn crate_of(name: &str) -> &'static str {
    if name == FILES { "scumble-files" } else { "scumble-web" }
}

/// Compiles one build into a target folder of its own: in a shared one each would evict the other.
fn compile(name: &str) -> Result<PathBuf> {
    let target = root().join("target").join(name);
    let mut build = cargo();
    build.args(["build", "--profile", "web", "-p", crate_of(name), "--target", tools::WASM_TARGET]);
    if name != FILES {
        build.args(["--no-default-features", "--features", name]);
    }
    run(build.arg("--target-dir").arg(&target))?;
    let file = format!("{}.wasm", crate_of(name).replace('-', "_"));
    Ok(target.join(tools::WASM_TARGET).join("web").join(file))
}

fn bind(wasm: &Path, package: &Path) -> Result<()> {
    run(command("wasm-bindgen")
        .args(["--target", "web", "--no-typescript", "--out-dir"])
        .args([package, wasm]))
}

fn optimise(wasm: &Path) -> Result<()> {
    let optimised = wasm.with_extension("optimised");
    let wasm_opt = "node_modules/binaryen/bin/wasm-opt";
    run(node().arg(wasm_opt).args(WASM_OPT).arg(wasm).arg("-o").arg(&optimised))?;
    Ok(fs::rename(optimised, wasm)?)
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
    minify(to, &["main.js", "formats_worker.js", "style.css"].map(|name| from.join(name)))
}

/// Writes scripts, with those that they import, and styles into a folder, without what only people read. They may lie
/// in it already.
fn minify(folder: &Path, files: &[PathBuf]) -> Result<()> {
    let esbuild = ["node_modules/esbuild/bin/esbuild", "--bundle", "--format=esm", "--minify"];
    let options = ["--splitting", "--allow-overwrite", "--log-level=warning"];
    run(node().args(esbuild).args(options).arg(format!("--outdir={}", folder.display())).args(files))
}

fn copy_files(files: impl IntoIterator<Item = PathBuf>, to: &Path) -> Result<()> {
    fs::create_dir_all(to)?;
    for path in files {
        fs::copy(&path, to.join(path.file_name().unwrap_or_default()))?;
    }
    Ok(())
}
