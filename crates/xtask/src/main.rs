//! The commands that the README names: `cargo xtask serve`, `test`, `dist` and their smaller sisters.
//!
//! Each installs what it needs and finds missing, so that a fresh machine with cargo, Node and npm is enough.

mod checks;
mod dist;
mod icons;
mod order;
mod package;
mod process;
mod reorder;
mod samples;
mod tools;
mod version;

use anyhow::{Result, bail};
use process::{cargo, node, root, run};
use std::process::ExitCode;

const USAGE: &str = "\
cargo xtask serve [PORT]  build the page, serve it on this machine and print its address
cargo xtask test          check formatting, lints, licences and types; run every test
cargo xtask test NAME …   run some checks alone, for example native-tests, page or select.test.mjs
cargo xtask dist          build the page into dist/, which any web host can serve
cargo xtask picture       make docs/editor.png, the picture of the editor, anew
cargo xtask golden        take the golden pictures of the page, tests/e2e/golden/, anew
cargo xtask corpus [N]    take OpenMoji's black drawings, all or N of them, through the whole chain
cargo xtask bench [ARGS]  time each stage of the chain: scumble bench, in release form
cargo xtask bench --web SET|--made|--memory
                          the same in Chromium, how long the page takes to come up, and how long the pen waits in it";

fn main() -> ExitCode {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    match obey(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error:#}");
            ExitCode::FAILURE
        }
    }
}

fn obey(arguments: &[&str]) -> Result<()> {
    match arguments {
        ["serve", port @ ..] if port.len() <= 1 => serve(port),
        ["test"] => checks::run_all(),
        ["test", names @ ..] => checks::run_named(names),
        ["dist"] => dist::build().map(|folder| println!("The page is in {}", folder.display())),
        ["picture"] => picture(),
        ["golden"] => golden(),
        ["corpus"] => corpus(&[]),
        ["corpus", count] => corpus(&["--take", count]),
        ["bench", "--web", what] => bench_in_browser(what),
        ["bench", arguments @ ..] => scumble("bench", arguments),
        _ => bail!("{USAGE}"),
    }
}

fn serve(port: &[&str]) -> Result<()> {
    let folder = dist::build()?;
    run(node().arg("tests/e2e/static_server.mjs").arg(folder).args(port))
}

fn picture() -> Result<()> {
    tools::browsers()?;
    dist::build()?;
    std::fs::create_dir_all(root().join("docs"))?;
    run(node().args(["--test", "tests/e2e/readme.test.mjs"]).env("PICTURE", root().join("docs/editor.png")))
}

fn golden() -> Result<()> {
    tools::browsers()?;
    dist::build()?;
    run(node().args(["--test", "tests/e2e/golden.test.mjs"]).env("GOLDEN", "accept"))
}

fn corpus(arguments: &[&str]) -> Result<()> {
    tools::npm_packages()?;
    scumble("corpus", &[&[samples::OPENMOJI_BLACK], arguments].concat())
}

/// Times what a browser runs: the command line, compiled for WASI, whose files and clock a page can stand for.
fn bench_in_browser(what: &str) -> Result<()> {
    tools::browsers()?;
    tools::rust_target(tools::WASI_TARGET)?;
    dist::build()?;
    let target = root().join("target/wasi");
    let build = ["build", "--release", "-p", "scumble-cli", "--target", tools::WASI_TARGET, "--target-dir"];
    run(cargo().args(build).arg(&target))?;
    let program = target.join(tools::WASI_TARGET).join("release/scumble.wasm");
    run(node().arg("tests/e2e/bench.mjs").arg(program).arg(what))
}

fn scumble(command: &str, arguments: &[&str]) -> Result<()> {
    run(cargo().args(["run", "--release", "-p", "scumble-cli", "--", command]).args(arguments))
}
