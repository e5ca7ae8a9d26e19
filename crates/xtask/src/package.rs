//! One wasm build of the page with its JavaScript, optimised.
//!
//! The two know each other's functions by names that end in a hash, some hundreds, which do not compress: they get short ones.

use crate::dist::minifier;
use crate::process::{cargo, command, node, output_of, root, run};
use crate::tools;
use anyhow::{Context, Result};
use serde_json::{Map, Value};
use std::fs;
use std::path::{Path, PathBuf};

/// The two builds of `scumble-web`, by the feature that tells them apart.
pub(crate) const FLAVOURS: [&str; 2] = ["webgpu", "webgl"];

/// The build of `scumble-files`.
pub(crate) const FILES: &str = "files";

/// The features of wasm that every browser with WebGPU or WebGL 2 has; `--all-features` would use others. Functions
/// that are called once stay functions: inlined they compress worse, by 3% of the whole.
const WASM_OPT: [&str; 13] = [
    "-O2",
    "--one-caller-inline-max-function-size=0",
    // Neighbours by name are neighbours by kind, and compress better.
    "--reorder-functions-by-name",
    "--minify-imports-and-exports-and-modules",
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

/// What `wasm-opt` calls the only module that a build imports from.
const SHORT_MODULE: &str = "a";

/// The folder with a build and its JavaScript, ready to be served; made anew where what it is made of is not as it was.
pub(crate) fn build(name: &str) -> Result<PathBuf> {
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
    let names = optimise(&package.join(format!("{module}_bg.wasm")))?;
    shorten(&package.join(format!("{module}.js")), &names, &work.join("names.json"))?;
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

/// Gives back the short names by those that the module's JavaScript has still.
fn optimise(wasm: &Path) -> Result<Map<String, Value>> {
    let optimised = wasm.with_extension("optimised");
    let wasm_opt = "node_modules/binaryen/bin/wasm-opt";
    let names = output_of(node().arg(wasm_opt).args(WASM_OPT).arg(wasm).arg("-o").arg(&optimised))?;
    fs::rename(optimised, wasm)?;
    short_names(&names)
}

/// The names of a list of `wasm-opt`, which has `imports` of module, name and short name, and `exports` of name and short name.
fn short_names(list: &str) -> Result<Map<String, Value>> {
    let list: Value = serde_json::from_str(list).context("wasm-opt: its list of names")?;
    let rows = ["imports", "exports"].into_iter().filter_map(|kind| list[kind].as_array()).flatten();
    let mut names = Map::new();
    for row in rows.filter_map(Value::as_array) {
        let [.., name, short] = row.as_slice() else { continue };
        names.insert(name.as_str().unwrap_or_default().to_owned(), short.clone());
        if let [module, _, _] = row.as_slice() {
            names.insert(module.as_str().unwrap_or_default().to_owned(), SHORT_MODULE.into());
        }
    }
    Ok(names)
}

/// Minifies a script in its place, with short names for the properties that have one: no export may be called as a property of
/// the browser's that the script uses.
fn shorten(script: &Path, names: &Map<String, Value>, list: &Path) -> Result<()> {
    fs::write(list, serde_json::to_vec(names)?)?;
    let any: Vec<_> = names.keys().map(|name| name.replace('.', r"\.").replace('$', r"\$")).collect();
    run(minifier()
        .arg(format!("--mangle-props=^({})$", any.join("|")))
        .args(["--mangle-quoted", "--allow-overwrite"])
        .arg(format!("--mangle-cache={}", list.display()))
        .arg(format!("--outfile={}", script.display()))
        .arg(script))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_names_are_by_those_of_modules_imports_and_exports() {
        let list = r#"{"imports": [["./m.js", "__wbg_a_0", "$"]], "exports": [["app_a", "b"]]}"#;
        let names = short_names(list).expect("names");
        let expected = [("./m.js", SHORT_MODULE), ("__wbg_a_0", "$"), ("app_a", "b")];
        assert_eq!(
            names,
            expected.map(|(name, short)| (name.to_owned(), short.into())).into_iter().collect()
        );
        assert!(short_names("no list").is_err());
    }
}
