//! `cargo xtask test`: every check and every test, each run even where an earlier one failed, then the summary.

use crate::process::{cargo, command, find, node, output, root, run};
use crate::{dist, package, samples, tools};
use anyhow::{Result, ensure};
use std::time::Instant;

/// How many of OpenMoji's drawings are taken, always the same ones.
const CORPUS_SAMPLE: &str = "300";

type Check = (&'static str, fn() -> Result<()>);

const CHECKS: [Check; 9] = [
    ("formatting", formatting),
    ("lints", lints),
    ("lints of the page's wasm", wasm_lints),
    ("licences and sources", licences),
    ("native tests", native_tests),
    ("300 drawings of OpenMoji", corpus),
    ("types of the page's JavaScript", javascript_types),
    ("wasm tests in Chromium", wasm_tests),
    ("the page in Chromium and Firefox", page_tests),
];

/// Runs all checks and prints what became of each; fails if one did.
pub(crate) fn run_all() -> Result<()> {
    let mut summary = Vec::new();
    let mut failed = 0;
    for (name, check) in CHECKS {
        println!("\n== {name}");
        let start = Instant::now();
        let outcome = check();
        if let Err(error) = &outcome {
            failed += 1;
            eprintln!("{name}: {error:#}");
        }
        let word = if outcome.is_ok() { "ok    " } else { "FAILED" };
        summary.push(format!("{word} {name} ({} s)", start.elapsed().as_secs()));
    }
    let passed = CHECKS.len() - failed;
    println!("\n{}\nchecks: {passed} passed, {failed} failed", summary.join("\n"));
    ensure!(failed == 0, "{failed} of {} checks failed; see above", CHECKS.len());
    Ok(())
}

fn formatting() -> Result<()> {
    run(cargo().args(["fmt", "--all", "--check"]))
}

fn lints() -> Result<()> {
    run(cargo().args(["clippy", "--workspace", "--all-targets", "--", "-D", "warnings"]))
}

fn wasm_lints() -> Result<()> {
    tools::rust_target(tools::WASM_TARGET)?;
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
    run(cargo().args(["test", "--workspace", "--no-fail-fast"]))
}

fn corpus() -> Result<()> {
    tools::npm_packages()?;
    let run_corpus = ["run", "-p", "scumble-cli", "--", "corpus", samples::OPENMOJI_BLACK];
    run(cargo().args(run_corpus).args(["--take", CORPUS_SAMPLE]))
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
    tools::browsers()?;
    let driver = find("chromedriver").unwrap_or_default();
    for flavour in package::FLAVOURS {
        let test = ["test", "--headless", "--chrome", "crates/scumble-web", "--no-default-features"];
        let mut pack = command("wasm-pack");
        pack.args(test).args(["--features", flavour]).env("CHROMEDRIVER", &driver);
        // Where several things are built at once, a solve without a graphics card takes longer than the 20 s of the runner.
        run(pack.env("WASM_BINDGEN_TEST_TIMEOUT", "120"))?;
    }
    Ok(())
}

fn page_tests() -> Result<()> {
    tools::browsers()?;
    dist::build()?;
    let files = dist::files_in(&root().join("tests/e2e"))?;
    let tests = files.iter().filter(|file| file.to_string_lossy().ends_with(".test.mjs"));
    run(node().args(["--test", "--test-concurrency=1"]).args(tests))
}
