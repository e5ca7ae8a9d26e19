//! The tools that building and testing need. Each function leaves its tool ready, installing it where it is
//! missing.

use crate::process::{cargo, command, find, node, output, root, run, tools_folder};
use anyhow::{Context, Result, bail, ensure};
use std::fs;
use std::path::Path;

/// The target that the page is compiled for.
pub(crate) const WASM_TARGET: &str = "wasm32-unknown-unknown";

/// The target that the command line is compiled for to be timed in a browser.
pub(crate) const WASI_TARGET: &str = "wasm32-wasip1";

const WASM_PACK_VERSION: &str = "0.15.1";

const GECKODRIVER_VERSION: &str = "0.37.1";

/// Debian's packages of browsers and their drivers, each with the program in it.
const BROWSERS: [(&str, &str); 3] =
    [("chromium", "chromium"), ("chromium-driver", "chromedriver"), ("firefox-esr", "firefox-esr")];

/// Debian's package of the Vulkan driver that needs no GPU, on which Firefox runs WebGPU.
const VULKAN: &str = "mesa-vulkan-drivers";

/// The standard library for a target.
pub(crate) fn rust_target(target: &str) -> Result<()> {
    let libraries = output(command("rustc").args(["--print", "target-libdir", "--target", target]));
    if libraries.is_some_and(|folder| Path::new(&folder).is_dir()) {
        return Ok(());
    }
    run(command("rustup").args(["target", "add", target]))
}

/// `wasm-bindgen`, whose version must be that of the crate exactly. Its own lock file is not used: it can name
/// crates that are no longer served.
pub(crate) fn wasm_bindgen() -> Result<()> {
    let version = locked_version("wasm-bindgen")?;
    install("wasm-bindgen", "wasm-bindgen-cli", &version, &[])
}

/// `wasm-pack`, which runs the tests of a wasm crate in a browser.
pub(crate) fn wasm_pack() -> Result<()> {
    install("wasm-pack", "wasm-pack", WASM_PACK_VERSION, &["--locked"])
}

/// `geckodriver`, through which `wasm-pack` drives Firefox: Debian has no package of it.
pub(crate) fn geckodriver() -> Result<()> {
    install("geckodriver", "geckodriver", GECKODRIVER_VERSION, &["--locked"])
}

/// The packages of `package-lock.json`, exactly.
pub(crate) fn npm_packages() -> Result<()> {
    node_version()?;
    let lock = fs::read(root().join("package-lock.json"))?;
    let installed = root().join("node_modules/.installed-package-lock.json");
    if fs::read(&installed).is_ok_and(|installed| installed == lock) {
        return Ok(());
    }
    run(command(if cfg!(windows) { "npm.cmd" } else { "npm" }).arg("ci"))?;
    Ok(fs::write(installed, lock)?)
}

/// Chromium with its driver, Firefox, and a Vulkan driver that needs no GPU: installed where this is Debian and
/// we may, otherwise named.
pub(crate) fn browsers() -> Result<()> {
    if missing_packages().is_empty() {
        return Ok(());
    }
    if may_install() {
        apt_install(&missing_packages())?;
    }
    let missing = missing_packages().join(" ");
    ensure!(missing.is_empty(), "the browser tests need {missing}: on Debian, apt-get install {missing}");
    Ok(())
}

/// Poppler, which shows tests what a PDF looks like: installed where this is Debian and we may. Elsewhere these tests
/// say that they are skipped.
pub(crate) fn poppler() -> Result<()> {
    if find("pdftoppm").is_none() && may_install() { apt_install(&["poppler-utils"]) } else { Ok(()) }
}

fn may_install() -> bool {
    find("apt-get").is_some() && output(command("id").arg("-u")).as_deref() == Some("0")
}

fn missing_packages() -> Vec<&'static str> {
    let browsers =
        BROWSERS.iter().filter(|(_, program)| find(program).is_none()).map(|(package, _)| *package);
    browsers.chain((!has_software_vulkan()).then_some(VULKAN)).collect()
}

fn has_software_vulkan() -> bool {
    let drivers = fs::read_dir("/usr/share/vulkan/icd.d").into_iter().flatten().flatten();
    drivers.into_iter().any(|driver| driver.file_name().to_string_lossy().starts_with("lvp_icd"))
}

fn apt_install(packages: &[&str]) -> Result<()> {
    let apt = || {
        let mut apt = command("apt-get");
        apt.args(["-q", "-y"]).env("DEBIAN_FRONTEND", "noninteractive");
        apt
    };
    run(apt().arg("update"))?;
    run(apt().args(["install", "--no-install-recommends"]).args(packages))
}

/// Installs a program where that version is missing. Not optimised it is there minutes sooner, and takes seconds longer at most for what
/// it does.
fn install(program: &str, package: &str, version: &str, options: &[&str]) -> Result<()> {
    let installed = output(command(program).arg("--version")).unwrap_or_default();
    if installed.split_whitespace().nth(1) == Some(version) {
        return Ok(());
    }
    let install = ["install", package, "--version", version, "--debug", "--root"];
    run(cargo().args(install).arg(tools_folder()).args(options).env("CARGO_PROFILE_DEV_DEBUG", "0"))
}

fn locked_version(package: &str) -> Result<String> {
    let lock = fs::read_to_string(root().join("Cargo.lock"))?;
    let entry = format!("name = \"{package}\"\nversion = \"");
    let (_, rest) = lock.split_once(&entry).with_context(|| format!("{package} is not in Cargo.lock"))?;
    Ok(rest.split('"').next().unwrap_or_default().to_owned())
}

fn node_version() -> Result<()> {
    let version = output(node().arg("--version")).unwrap_or_default();
    let major = version.trim_start_matches('v').split('.').next().and_then(|major| major.parse().ok());
    match major {
        Some(20u32..) => Ok(()),
        Some(_) => bail!("Node {version} is too old; install Node 20 or newer from https://nodejs.org"),
        None => bail!("Node is missing; install Node 20 or newer from https://nodejs.org"),
    }
}
