//! Files and links of every released version load for ever, and stand for what they stood for.
//!
//! `fixtures/vN.M/links.txt` has lines of a name and its link; `NAME.scumble` is the same work as a file of that version,
//! with the picture under its lines, which no link has; `NAME.work`, of some, its exact bytes as browsers keep them.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

use scumble_core::{Document, Work, exact};
use scumble_io::{read_file, read_link, write_file, write_link};

fn versions() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fixtures");
    let mut versions: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    versions.sort();
    versions
}

/// The links of a version with the files that are the same.
fn pairs(version: &Path) -> Vec<(String, Vec<u8>)> {
    let links = fs::read_to_string(version.join("links.txt")).unwrap();
    let pair = |line: &str| {
        let (name, link) = line.split_once(' ').unwrap();
        (link.to_owned(), fs::read(version.join(name).with_extension("scumble")).unwrap())
    };
    links.lines().map(pair).collect()
}

#[test]
fn links_stand_for_what_they_stood_for() {
    for version in versions() {
        for (link, file) in pairs(&version) {
            let filed = Work { image: Vec::new(), ..read_file(&file).unwrap() };
            let [linked, filed] = [read_link(&link).unwrap(), filed].map(|work| write_file(&work));
            assert_eq!(linked, filed, "{link}");
        }
    }
}

#[test]
fn exact_bytes_stand_for_what_they_stood_for() {
    let mut count = 0;
    for path in versions().iter().flat_map(|version| fs::read_dir(version).unwrap()) {
        let path = path.unwrap().path();
        if path.extension().is_some_and(|extension| extension == "work") {
            let kept = exact::read(&fs::read(&path).unwrap()).unwrap();
            let filed = read_file(&fs::read(path.with_extension("scumble")).unwrap()).unwrap();
            assert_eq!(exact::write(&kept), exact::write(&filed), "{}", path.display());
            count += 1;
        }
    }
    assert_eq!(count, 8);
}

#[test]
fn pictures_under_the_lines_are_what_they_were() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests");
    for (name, image, opacity) in [("rooms-traced", "sketch.png", 0.5), ("ink-traced", "sketch.jpg", 0.25)] {
        let file = fs::read(folder.join("fixtures/v1.1").join(name).with_extension("scumble")).unwrap();
        let Work { document: Document { tracing, .. }, image: read, .. } = read_file(&file).unwrap();
        assert_eq!(read, fs::read(folder.join("foreign").join(image)).unwrap());
        assert_eq!(tracing.unwrap().opacity, opacity);
    }
}

/// Each file says the least version that has its fields.
#[test]
fn what_released_versions_wrote_is_written_again() {
    let pairs: Vec<_> = versions().iter().flat_map(|version| pairs(version)).collect();
    assert_eq!(pairs.len(), 25);
    for (link, file) in pairs {
        let work = read_file(&file).unwrap();
        assert_eq!(String::from_utf8(write_file(&work).unwrap()), String::from_utf8(file));
        assert_eq!(write_link(&work).unwrap().fragment, link);
    }
}
