//! Files and links of every released version load for ever, and stand for what they stood for.
//!
//! `fixtures/vN.M/links.txt` has lines of a name and its link; `NAME.scumble` is the same work as a file of that version.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::fs;
use std::path::{Path, PathBuf};

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
            let [linked, filed] =
                [read_link(&link).unwrap(), read_file(&file).unwrap()].map(|work| write_file(&work));
            assert_eq!(linked, filed, "{link}");
        }
    }
}

#[test]
fn what_the_newest_version_wrote_is_written_again() {
    let newest = versions().pop().unwrap();
    let pairs = pairs(&newest);
    assert_eq!(pairs.len(), 20);
    for (link, file) in pairs {
        let work = read_file(&file).unwrap();
        assert_eq!(String::from_utf8(write_file(&work).unwrap()), String::from_utf8(file));
        assert_eq!(write_link(&work).unwrap().fragment, link);
    }
}
