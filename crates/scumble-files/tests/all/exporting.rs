//! What the page exports.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use scumble_core::{Work, exact};
use scumble_files::exporting::Wanted;
use scumble_files::opening::{self, Content, OpenError};
use scumble_solve::Field;

const SVG: &[u8] = br#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 512 384">
    <path d="M100 75H340V315H100Z" stroke="black" fill="none"/></svg>"#;

/// The work in a file, and what was left out.
fn work(file: &[u8]) -> (Work, String) {
    match opening::file(file, "").unwrap() {
        Content::Work(work, notes) => (*work, notes),
        Content::Palette(..) | Content::Image => panic!("work"),
    }
}

#[test]
fn an_exported_svg_opens_as_the_work_that_it_was() {
    let work = exact::write(&work(SVG).0);
    let field = Field::default().to_bytes();
    let wanted = Wanted { work: &work, field: &field, size_px: 1024, lines: true, transparent: false };
    let (opened, notes) = self::work(&wanted.svg(b"").unwrap());
    assert_eq!((exact::write(&opened), &*notes), (work.clone(), ""));
    assert!(wanted.pdf().unwrap().starts_with(b"%PDF-"));
    assert!(matches!(Wanted { field: b"", ..wanted }.pdf(), Err(OpenError::Damaged)));
    assert!(matches!(Wanted { work: b"", ..wanted }.svg(b""), Err(OpenError::Damaged)));
}
