//! `cargo xtask test`: every check and every test, each run even where an earlier one failed, then the summary.
//!
//! Two of them are on their way at a time, as each waits much of the time: for a browser, a linker or a package. Each is a process
//! of its own, whose output is shown once it has ended.

use crate::process::{cargo, command, find, node, output, root, run, run_into};
use crate::{dist, package, samples, tools};
use anyhow::{Result, bail, ensure};
use std::fs;
use std::path::PathBuf;
use std::process::Command;
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::Instant;

/// How many of OpenMoji's drawings are taken, always the same ones.
const CORPUS_SAMPLE: &str = "300";

/// A check by the name that asks for it alone: `cargo xtask test NAME`.
type Check = (&'static str, fn() -> Result<()>);

/// One after the other, as most of them build in the same folder.
const CHECKS: [Check; 8] = [
    ("formatting", formatting),
    ("lints", lints),
    ("wasm-lints", wasm_lints),
    ("licences", licences),
    ("native-tests", native_tests),
    ("corpus", corpus),
    ("types", javascript_types),
    ("wasm-tests", wasm_tests),
];

/// Mesa's software driver compiles the kernels for longer than it runs them. Without optimising it takes less than half as long.
const QUICK_SHADERS: [(&str, &str); 1] = [("GALLIVM_PERF", "nopt")];

/// The tests of the page in Chromium and Firefox, which among all checks are taken file by file.
const PAGE: Check = ("page", || page(&page_tests()?));

/// So many lines of a check that failed are repeated at the end, where who reads only that finds them.
const LAST_LINES: usize = 100;

/// How the name of a file with such tests ends.
const PAGE_TEST: &str = ".test.mjs";

/// Runs all checks and prints what became of each; fails if one did.
pub(crate) fn run_all() -> Result<()> {
    install_all();
    let this = std::env::current_exe()?;
    let (tests, outcomes) = (Mutex::new(page_tests()?), Mutex::new(Vec::new()));
    let check = |name: &str, command: &mut Command| {
        let outcome = checked(name, command);
        let is_ok = outcome.is_ok;
        locked(&outcomes).push(outcome);
        is_ok
    };
    let rest = || {
        while let Some(file) = { locked(&tests).pop() } {
            let name = file.file_name().unwrap_or_default().to_string_lossy().into_owned();
            check(&name, node().arg("--test").arg(file));
        }
    };
    // Nobody takes a test of the page before that is built, in folders of its own.
    let mut waiting = locked(&tests);
    thread::scope(|scope| {
        scope.spawn(|| {
            for (name, _) in CHECKS {
                check(name, command(&this).args(["test", name]));
            }
            rest();
        });
        if !check("dist", command(&this).arg("dist")) {
            waiting.clear();
        }
        drop(waiting);
        rest();
    });
    sum_up(&outcomes.into_inner().unwrap_or_else(PoisonError::into_inner))
}

/// Runs the checks of some names; a test of the page has that of its file.
pub(crate) fn run_named(names: &[&str]) -> Result<()> {
    let known = || CHECKS.iter().chain([&PAGE]);
    for name in names {
        match known().find(|(own, _)| own == name) {
            Some((_, check)) => check()?,
            None if name.ends_with(PAGE_TEST) => page(&[root().join("tests/e2e").join(name)])?,
            None => {
                let known: Vec<_> = known().map(|(name, _)| *name).collect();
                bail!("there is no check {name}; there are {}, and the files in tests/e2e", known.join(", "));
            }
        }
    }
    Ok(())
}

/// Installs what several checks need, which they could not at once. What cannot be had they say themselves.
fn install_all() {
    for install in
        [tools::browsers, tools::poppler, tools::npm_packages, || tools::rust_target(tools::WASM_TARGET)]
    {
        if let Err(error) = install() {
            eprintln!("{error:#}");
        }
    }
}

fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// What became of a check.
struct Outcome {
    name: String,
    is_ok: bool,
    seconds: u64,
    text: String,
}

/// Runs a command and shows its output as a whole; it is kept in `target/checks/`.
fn checked(name: &str, command: &mut Command) -> Outcome {
    println!("{name} …");
    let start = Instant::now();
    let (is_ok, text) = logged(name, command).unwrap_or_else(|error| (false, format!("{error:#}")));
    let outcome = Outcome { name: name.to_owned(), is_ok, seconds: start.elapsed().as_secs(), text };
    println!("\n== {name}\n{}\n{}", outcome.text, outcome.line());
    outcome
}

fn logged(name: &str, command: &mut Command) -> Result<(bool, String)> {
    let folder = root().join("target/checks");
    fs::create_dir_all(&folder)?;
    let log = folder.join(format!("{name}.log"));
    let is_ok = run_into(&log, command)?;
    Ok((is_ok, String::from_utf8_lossy(&fs::read(log)?).into_owned()))
}

impl Outcome {
    fn line(&self) -> String {
        format!("{} {} ({} s)", if self.is_ok { "ok    " } else { "FAILED" }, self.name, self.seconds)
    }

    /// The last it printed: what went wrong is mostly there.
    fn last_lines(&self) -> String {
        let lines: Vec<_> = self.text.lines().collect();
        lines[lines.len().saturating_sub(LAST_LINES)..].join("\n")
    }
}

fn sum_up(outcomes: &[Outcome]) -> Result<()> {
    let lines: Vec<_> = outcomes.iter().map(Outcome::line).collect();
    println!("\n{}", lines.join("\n"));
    let failed: Vec<_> = outcomes.iter().filter(|outcome| !outcome.is_ok).collect();
    for outcome in &failed {
        println!("\n== the last lines of {}\n{}", outcome.name, outcome.last_lines());
    }
    let failed = failed.len();
    println!("\nchecks: {} passed, {failed} failed", outcomes.len() - failed);
    ensure!(failed == 0, "{failed} of {} checks failed; see above", outcomes.len());
    Ok(())
}

fn formatting() -> Result<()> {
    run(cargo().args(["fmt", "--all", "--check"]))
}

fn lints() -> Result<()> {
    run(cargo().args(["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"]))
}

/// Of what runs in a browser: the page, and the command line, which is timed there.
fn wasm_lints() -> Result<()> {
    tools::rust_target(tools::WASM_TARGET)?;
    tools::rust_target(tools::WASI_TARGET)?;
    let command_line =
        ["clippy", "-p", "scumble-cli", "--target", tools::WASI_TARGET, "--", "-D", "warnings"];
    run(cargo().args(command_line))?;
    for flavour in package::FLAVOURS {
        let package = ["clippy", "-p", "scumble-web", "--all-targets", "--target", tools::WASM_TARGET];
        let features = ["--no-default-features", "--features", flavour, "--", "-D", "warnings"];
        run(cargo().args(package).args(features))?;
    }
    Ok(())
}

fn licences() -> Result<()> {
    if output(cargo().args(["deny", "--version"])).is_none() {
        println!("skipped: cargo-deny is not installed (cargo install cargo-deny --locked)");
        return Ok(());
    }
    run(cargo().args(["deny", "check", "licenses", "bans", "sources"]))
}

fn native_tests() -> Result<()> {
    tools::poppler()?;
    run(cargo().args(["test", "--workspace", "--no-fail-fast"]).envs(QUICK_SHADERS))
}

/// With the program that the tests are built with: built by itself, it has other features of its dependencies, which would be
/// built again.
fn corpus() -> Result<()> {
    tools::npm_packages()?;
    run(cargo().args(["test", "--workspace", "--no-run"]))?;
    let mut scumble = command(root().join("target/debug/scumble"));
    run(scumble.args(["corpus", samples::OPENMOJI_BLACK, "--take", CORPUS_SAMPLE]))
}

fn javascript_types() -> Result<()> {
    tools::npm_packages()?;
    for project in ["web", "web/offline", "tests/e2e"] {
        run(node().args(["node_modules/typescript/bin/tsc", "--project", project]))?;
    }
    Ok(())
}

fn wasm_tests() -> Result<()> {
    tools::rust_target(tools::WASM_TARGET)?;
    tools::wasm_bindgen()?;
    tools::wasm_pack()?;
    tools::geckodriver()?;
    tools::browsers()?;
    for flavour in package::FLAVOURS {
        wasm_tests_in("chrome", flavour)?;
    }
    // Without a graphics card, Firefox has no WebGL 2.
    wasm_tests_in("firefox", "webgpu")
}

/// Runs them with the driver of that browser alone: of two that are named, the runner takes one whatever it is told.
fn wasm_tests_in(browser: &str, flavour: &str) -> Result<()> {
    let driver = if browser == "firefox" { "geckodriver" } else { "chromedriver" };
    let mut pack = command("wasm-pack");
    pack.args(["test", "--headless", &format!("--{browser}"), "crates/scumble-web"])
        .args(["--no-default-features", "--features", flavour, "--test", "browser"])
        .env(driver.to_uppercase(), find(driver).unwrap_or_default())
        .envs(QUICK_SHADERS);
    // Where several things are built at once, a solve without a graphics card may take tens of times as long as alone, and a
    // driver may come up late. The limits, in seconds, are there for what hangs.
    run(pack.env("WASM_BINDGEN_TEST_TIMEOUT", "600").env("WASM_BINDGEN_TEST_DRIVER_TIMEOUT", "120"))
}

fn page(tests: &[PathBuf]) -> Result<()> {
    tools::browsers()?;
    dist::build()?;
    run(node().args(["--test", "--test-concurrency=2"]).args(tests))
}

/// The tests of the page, each a file.
fn page_tests() -> Result<Vec<PathBuf>> {
    let mut files = dist::files_in(&root().join("tests/e2e"))?;
    files.retain(|file| file.to_string_lossy().ends_with(PAGE_TEST));
    Ok(files)
}
