//! One version of the page: its files, in a folder whose name is a hash of their content, and the service worker that
//! keeps just these.
//!
//! A page names nothing but files of its own folder, so that those of two versions never meet, also on a host that gets
//! another version while a page is open.

use crate::process::{node, root, run};
use anyhow::Result;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// What tells a version from others: so many bytes of a hash.
const NAME_BYTES: usize = 8;

const WORKER: &str = "web/offline/worker.js";

/// Names the folder of a version by its content, and puts the page and its worker beside it.
pub(crate) fn seal(dist: &Path, files: &Path) -> Result<()> {
    let page = bare(&fs::read_to_string(root().join("index.html"))?);
    let hashes = hashes_in(files, "")?;
    let version = name(&hashes, &[page.as_bytes(), &fs::read(root().join(WORKER))?]);
    fs::rename(files, dist.join(&version))?;
    let page = page.replace("\"web/", &format!("\"{version}/web/"));
    fs::write(dist.join("index.html"), &page)?;
    let inside = hashes.iter().map(|(path, hash)| (format!("{version}/{path}"), integrity(hash)));
    // The page by the path that it is opened by.
    let all = inside.chain([(String::new(), integrity(&Sha256::digest(&page).into()))]).collect();
    write_worker(&version, &all, &dist.join("worker.js"))
}

/// A page without what only its authors read: indentation, and lines of comment in its script.
fn bare(page: &str) -> String {
    let lines = page.lines().map(str::trim).filter(|line| !line.starts_with("//"));
    lines.map(|line| format!("{line}\n")).collect()
}

type Hash = [u8; 32];

/// What is in a folder and those in it: hashes by paths, with slashes.
fn hashes_in(folder: &Path, prefix: &str) -> Result<BTreeMap<String, Hash>> {
    let mut hashes = BTreeMap::new();
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let path = format!("{prefix}{}", entry.file_name().to_string_lossy());
        if entry.file_type()?.is_dir() {
            hashes.append(&mut hashes_in(&entry.path(), &format!("{path}/"))?);
        } else {
            hashes.insert(path, Sha256::digest(fs::read(entry.path())?).into());
        }
    }
    Ok(hashes)
}

/// The name of a version, from all that is in it.
fn name(hashes: &BTreeMap<String, Hash>, more: &[&[u8]]) -> String {
    let mut all = Sha256::new();
    for (path, hash) in hashes {
        all.update(path);
        all.update(hash);
    }
    more.iter().for_each(|content| all.update(Sha256::digest(content)));
    let digits: String = all.finalize().iter().take(NAME_BYTES).map(|byte| format!("{byte:02x}")).collect();
    format!("v-{digits}")
}

/// A hash as `fetch` takes it.
fn integrity(hash: &Hash) -> String {
    format!("sha256-{}", BASE64_STANDARD.encode(hash))
}

/// Writes the worker, with what it is to keep before it.
fn write_worker(version: &str, files: &BTreeMap<String, String>, to: &Path) -> Result<()> {
    let esbuild = ["node_modules/esbuild/bin/esbuild", WORKER, "--minify", "--log-level=warning"];
    run(node().args(esbuild).arg(format!("--outfile={}", to.display())))?;
    let (version, files) = (serde_json::to_string(version)?, serde_json::to_string(files)?);
    let worker = fs::read_to_string(to)?;
    Ok(fs::write(to, format!("const VERSION={version},FILES={files};\n{worker}"))?)
}
