//! A folder for the files of one test, and the program run in it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A circle of radius 24 in the middle of a page of 64 × 64.
pub(crate) const CIRCLE: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="10 20 64 64">
    <circle cx="42" cy="52" r="24" fill="none" stroke="black" stroke-width="2"/></svg>"#;

/// A red scribble inside that circle.
pub(crate) const INSIDE: &str =
    r##"{"scribbles":[{"color":"#e6194b","width":1.5,"points":[[38,50],[46,54]]}]}"##;

/// The files of one test.
pub(crate) struct Folder(PathBuf);

impl Folder {
    /// An empty folder; the name is that of the test.
    pub(crate) fn new(name: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        if path.exists() {
            fs::remove_dir_all(&path).unwrap();
        }
        fs::create_dir_all(&path).unwrap();
        Self(path)
    }

    pub(crate) fn path(&self) -> &Path {
        &self.0
    }

    /// Writes a file.
    pub(crate) fn with(self, name: &str, content: impl AsRef<[u8]>) -> Self {
        fs::write(self.0.join(name), content).unwrap();
        self
    }

    /// Names of all files, sorted.
    pub(crate) fn names(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).unwrap();
        let mut names: Vec<_> = entries.map(|e| e.unwrap().file_name().into_string().unwrap()).collect();
        names.sort();
        names
    }

    /// The bytes of a file.
    pub(crate) fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.0.join(name)).unwrap()
    }

    /// Runs the program in this folder.
    pub(crate) fn run(&self, arguments: &[&str]) -> Output {
        Command::new(env!("CARGO_BIN_EXE_scumble")).args(arguments).current_dir(&self.0).output().unwrap()
    }
}

/// What the program wrote to the error stream.
pub(crate) fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}
