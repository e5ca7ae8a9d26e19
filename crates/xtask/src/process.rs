//! Child processes: started at the top of the repository, echoed, without standard input, and failing aloud.

use anyhow::{Context, Result, ensure};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The top of the repository.
pub(crate) fn root() -> &'static Path {
    let here = Path::new(env!("CARGO_MANIFEST_DIR"));
    here.ancestors().nth(2).unwrap_or(here)
}

/// A child process that starts at the top of the repository and finds the tools that this program installed.
pub(crate) fn command(program: impl AsRef<std::ffi::OsStr>) -> Command {
    let mut command = Command::new(program);
    command.current_dir(root()).stdin(Stdio::null()).env("PATH", search_path());
    command
}

/// The cargo that started this program.
pub(crate) fn cargo() -> Command {
    command(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()))
}

/// Node.
pub(crate) fn node() -> Command {
    command("node")
}

/// What takes from a script or style what only people read.
pub(crate) fn minifier() -> Command {
    let mut minifier = node();
    minifier.args(["node_modules/esbuild/bin/esbuild", "--format=esm", "--minify", "--log-level=warning"]);
    minifier
}

/// Makes a minified script that every visitor loads smaller still, in its place: by 4%. Its functions become arrows where they use
/// neither `this` nor `arguments`, as none of them is called by `new`.
pub(crate) fn squeeze(script: &Path) -> Result<()> {
    let mut terser = node();
    terser.arg("node_modules/terser/bin/terser").arg(script);
    terser.args(["--module", "--compress", "passes=3,ecma=2020,unsafe_arrows", "--mangle", "--output"]);
    run(terser.arg(script))
}

/// Prints the command, runs it with its output shown, and fails if it does.
pub(crate) fn run(command: &mut Command) -> Result<()> {
    output_of(command.stdout(Stdio::inherit())).map(drop)
}

/// Prints the command, runs it, fails if it does, and gives back what it writes to standard output.
pub(crate) fn output_of(command: &mut Command) -> Result<String> {
    let line = command_line(command);
    println!("$ {line}");
    let child = command.stderr(Stdio::inherit()).output();
    let output = child.with_context(|| format!("{line}: could not be started; is it installed?"))?;
    ensure!(output.status.success(), "{line}: {}", output.status);
    Ok(String::from_utf8(output.stdout)?)
}

/// Runs the command with its output in a file, and says whether it did what it should. A pipe would stay open as long as
/// anything that the command has left behind.
pub(crate) fn run_into(file: &Path, command: &mut Command) -> Result<bool> {
    let line = command_line(command);
    let log = std::fs::File::create(file)?;
    let status = command.stdout(log.try_clone()?).stderr(log).status();
    Ok(status.with_context(|| format!("{line}: could not be started; is it installed?"))?.success())
}

/// What the command writes to standard output, or nothing where it cannot be started or fails.
pub(crate) fn output(command: &mut Command) -> Option<String> {
    let output = command.stderr(Stdio::null()).output().ok()?;
    let text = String::from_utf8_lossy(&output.stdout).trim().to_owned();
    output.status.success().then_some(text)
}

/// Where a program of this name lies on the search path.
pub(crate) fn find(program: &str) -> Option<PathBuf> {
    let file = format!("{program}{}", std::env::consts::EXE_SUFFIX);
    std::env::split_paths(&search_path()).map(|folder| folder.join(&file)).find(|path| path.is_file())
}

/// Where `cargo install` puts what this program installs: beside the build, not among the user's own tools,
/// whose versions are theirs to choose.
pub(crate) fn tools_folder() -> PathBuf {
    root().join("target/tools")
}

fn search_path() -> std::ffi::OsString {
    let own = std::iter::once(tools_folder().join("bin"));
    let inherited = std::env::var_os("PATH").unwrap_or_default();
    std::env::join_paths(own.chain(std::env::split_paths(&inherited))).unwrap_or(inherited)
}

fn command_line(command: &Command) -> String {
    let words = std::iter::once(command.get_program()).chain(command.get_args());
    let words: Vec<_> = words.map(|word| word.to_string_lossy()).collect();
    words.join(" ")
}
