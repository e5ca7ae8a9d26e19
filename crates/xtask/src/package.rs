//! One wasm build of the page with its JavaScript, optimised.
//!
//! The two know each other's functions by names that end in a hash, some hundreds, which do not compress: they get short ones.

use crate::process::{cargo, command, minifier, node, output_of, root, run, squeeze};
use crate::reorder::{small, smallest};
use crate::tools;
use anyhow::{Context, Result};
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

/// The two builds of `scumble-web`, by the feature that tells them apart.
pub(crate) const FLAVOURS: [&str; 2] = ["webgpu", "webgl"];

/// The build of `scumble-files`.
pub(crate) const FILES: &str = "files";

/// How a module is optimised first, and then once more, for what the first time left, with nothing that costs bytes.
const WASM_OPT: [&[&str]; 2] = [&["-O2", "--minify-imports-and-exports-and-modules"], &["-Os"]];

/// What is asked of it both times. The features of wasm are those that every browser with WebGPU or WebGL 2 has;
/// `--all-features` would use others.
const WASM_OPT_ALWAYS: [&str; 11] = [
    // Functions that are called once stay functions: inlined they compress worse, by 3% of the whole.
    "--one-caller-inline-max-function-size=0",
    // A call takes as much as a body that small.
    "--always-inline-max-function-size=5",
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

/// Vectors of four, which every browser with WebGPU has; a browser with WebGL 2 alone may be older than they are.
const VECTORS: &str = "-Ctarget-feature=+simd128";

/// What `wasm-opt` calls the only module that a build imports from.
const SHORT_MODULE: &str = "a";

/// The folder with a build and its JavaScript, ready to be served; made anew where what it is made of is not as it was.
pub(crate) fn build(name: &str) -> Result<PathBuf> {
    let wasm = compile(name)?;
    tools::wasm_bindgen()?;
    let work = root().join("target/page").join(name);
    let (seen, package) = (work.join("seen"), work.join("package"));
    // The tools and how they are used are part of it, so that a change of them runs the steps again.
    let tools = fs::read(root().join("package-lock.json"))?;
    let steps = [
        &include_bytes!("package.rs")[..],
        include_bytes!("order.rs"),
        include_bytes!("process.rs"),
        include_bytes!("reorder.rs"),
    ]
    .concat();
    let input = [fs::read(&wasm)?, tools, steps].concat();
    if fs::read(&seen).is_ok_and(|seen| seen == input) {
        return Ok(package);
    }
    if work.exists() {
        fs::remove_dir_all(&work)?;
    }
    bind(&wasm, &package)?;
    let module = crate_of(name).replace('-', "_");
    let names = optimise(name, &package.join(format!("{module}_bg.wasm")))?;
    shorten(&package.join(format!("{module}.js")), &names)?;
    fs::write(seen, input)?;
    Ok(package)
}

/// The crate that a build is of.
fn crate_of(name: &str) -> &'static str {
    if name == FILES { "scumble-files" } else { "scumble-web" }
}

/// Compiles one build. Only one is compiled with [`VECTORS`]; the others are compiled together, so that they have one set of
/// dependencies.
fn compile(name: &str) -> Result<PathBuf> {
    let flavour = if name == FILES { "webgl" } else { name };
    let target = root().join("target").join(flavour);
    let mut build = cargo();
    build.args(["build", "--profile", "web", "-p", "scumble-web", "--target", tools::WASM_TARGET]);
    build.args(["--no-default-features", "--features", &format!("scumble-web/{flavour}")]);
    let has_vectors = flavour == "webgpu";
    build.arg("--config").arg(rustflags(has_vectors.then_some(VECTORS))?);
    build.args(if has_vectors { &[][..] } else { &["-p", "scumble-files"] });
    run(build.arg("--target-dir").arg(&target))?;
    let file = format!("{}.wasm", crate_of(name).replace('-', "_"));
    Ok(target.join(tools::WASM_TARGET).join("web").join(file))
}

/// With the paths of this machine cut from what a module says of places in its sources.
fn rustflags(more: Option<&str>) -> Result<String> {
    let sources = cargo_home()?.join("registry/src");
    // Where crates come from elsewhere there is no such folder.
    let entries = fs::read_dir(sources).into_iter().flatten();
    let mut folders = entries.map(|entry| Ok(entry?.path())).collect::<Result<Vec<_>>>()?;
    folders.sort();
    let cut = folders.iter().map(|folder| format!("--remap-path-prefix={}/=", folder.display()));
    let flags: Vec<_> = cut.chain(more.map(str::to_owned)).collect();
    Ok(format!("target.{}.rustflags={}", tools::WASM_TARGET, serde_json::to_string(&flags)?))
}

fn cargo_home() -> Result<PathBuf> {
    let named = || std::env::var_os("CARGO_HOME").map(PathBuf::from);
    let at_home = || std::env::home_dir().map(|home| home.join(".cargo"));
    named().or_else(at_home).context("cargo's folder is not known; set CARGO_HOME")
}

fn bind(wasm: &Path, package: &Path) -> Result<()> {
    run(command("wasm-bindgen")
        .args(["--target", "web", "--no-typescript", "--out-dir"])
        .args([package, wasm]))
}

/// Optimises a module in its place, and gives back the short names that its imports and exports have now.
fn optimise(name: &str, wasm: &Path) -> Result<ShortNames> {
    let [first, again] = WASM_OPT;
    let list = wasm_opt(wasm, first)?;
    wasm_opt(wasm, again)?;
    // What most visits fetch has the most care taken.
    let reorder = if name == FLAVOURS[0] { smallest } else { small };
    fs::write(wasm, reorder(&fs::read(wasm)?)?)?;
    ShortNames::read(&list)
}

/// Runs `wasm-opt` on a module in its place; what it writes to standard output.
fn wasm_opt(wasm: &Path, passes: &[&str]) -> Result<String> {
    let optimised = wasm.with_extension("optimised");
    let mut tool = node();
    tool.arg("node_modules/binaryen/bin/wasm-opt").args(passes).args(WASM_OPT_ALWAYS);
    let written = output_of(tool.arg(wasm).arg("-o").arg(&optimised))?;
    fs::rename(optimised, wasm)?;
    Ok(written)
}

/// Has a script use the short names, and minifies it in its place.
fn shorten(script: &Path, names: &ShortNames) -> Result<()> {
    fs::write(script, names.written_in(&fs::read_to_string(script)?))?;
    run(minifier().arg("--allow-overwrite").arg(format!("--outfile={}", script.display())).arg(script))?;
    squeeze(script)
}

/// Short names by those that `wasm-bindgen` gave.
#[derive(Debug, Default, PartialEq)]
struct ShortNames {
    /// Of modules, as they are quoted.
    modules: BTreeMap<String, String>,
    imports: BTreeMap<String, String>,
    exports: BTreeMap<String, String>,
}

impl ShortNames {
    /// Reads a list of `wasm-opt`.
    fn read(list: &str) -> Result<Self> {
        #[derive(serde::Deserialize)]
        struct List {
            /// Module, name, short name.
            imports: Vec<[String; 3]>,
            exports: Vec<(String, String)>,
        }
        let List { imports, exports } =
            serde_json::from_str(list).context("the names that wasm-opt lists")?;
        let modules =
            imports.iter().map(|[module, ..]| (format!("\"{module}\""), format!("\"{SHORT_MODULE}\"")));
        Ok(Self {
            modules: modules.collect(),
            imports: imports.iter().map(|[_, name, short]| (name.clone(), short.clone())).collect(),
            exports: exports.into_iter().collect(),
        })
    }

    /// A script of `wasm-bindgen` with these names. There an export is a property of `wasm`; an import has a name of its own.
    fn written_in(&self, script: &str) -> String {
        let script =
            self.modules.iter().fold(script.to_owned(), |script, (name, short)| script.replace(name, short));
        let is_in_name = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '$';
        let mut written = String::with_capacity(script.len());
        let mut rest = &script[..];
        while let Some(start) = rest.find(is_in_name) {
            let (before, from) = rest.split_at(start);
            let (name, after) = from.split_at(from.find(|c| !is_in_name(c)).unwrap_or(from.len()));
            written.push_str(before);
            let names = if written.ends_with("wasm.") { &self.exports } else { &self.imports };
            written.push_str(names.get(name).map_or(name, String::as_str));
            rest = after;
        }
        written + rest
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const LIST: &str =
        r#"{"imports": [["./m.js", "__wbg_a_0", "$"]], "exports": [["palette", "b"], ["memory", "c"]]}"#;

    #[test]
    fn exports_are_renamed_where_they_are_those_of_the_module_alone() {
        let names = ShortNames::read(LIST).expect("names");
        let script = r#"get palette() { return wasm.palette(a.memory, wasm.memory.buffer); } return {"./m.js": {__wbg_a_0: f}};"#;
        let expected = r#"get palette() { return wasm.b(a.memory, wasm.c.buffer); } return {"a": {$: f}};"#;
        assert_eq!(names.written_in(script), expected);
    }

    #[test]
    fn lists_that_are_none_are_refused() {
        for list in ["", "{}", r#"{"imports": [["a", "b"]], "exports": []}"#] {
            assert!(ShortNames::read(list).is_err(), "{list}");
        }
    }
}
