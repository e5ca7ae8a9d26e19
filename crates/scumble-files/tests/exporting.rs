//! What the page exports.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use scumble_core::exact;
use scumble_files::exporting::Wanted;
use scumble_files::opening::{self, OpenError};
use scumble_solve::Field;

const SVG: &[u8] = br#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 512 384">
    <path d="M100 75H340V315H100Z" stroke="black" fill="none"/></svg>"#;

#[test]
fn an_exported_svg_opens_as_the_work_that_it_was() {
    let work = exact::write(&opening::file(SVG).unwrap().0);
    let field = Field::default().to_bytes();
    let wanted = Wanted { work: &work, field: &field, size_px: 1024, lines: true, transparent: false };
    let (opened, notes) = opening::file(&wanted.svg(b"").unwrap()).unwrap();
    assert_eq!((exact::write(&opened), &*notes), (work.clone(), ""));
    assert!(wanted.pdf().unwrap().starts_with(b"%PDF-"));
    assert!(matches!(Wanted { field: b"", ..wanted }.pdf(), Err(OpenError::Damaged)));
    assert!(matches!(Wanted { work: b"", ..wanted }.svg(b""), Err(OpenError::Damaged)));
}
