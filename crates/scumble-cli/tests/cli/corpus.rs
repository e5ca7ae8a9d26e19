//! `scumble corpus` on small folders, and on a fixed 300 of OpenMoji's drawings where they are installed.

use std::path::Path;

use crate::folder::{CIRCLE, Folder};

#[test]
fn sound_and_empty_drawings_pass_and_faulty_ones_fail() {
    let empty = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"/>"#;
    let folder = Folder::new("corpus").with("a.svg", CIRCLE).with("b.svg", empty).with("c.txt", "no drawing");
    let output = folder.run(&["corpus", "."]);
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("2 drawings: 1 sound, 1 without lines, 0 faulty"), "{text}");
    assert_eq!(output.status.code(), Some(0));
    let folder = folder.with("D.SVG", "<svg");
    let output = folder.run(&["corpus", "."]);
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("3 drawings: 1 sound, 1 without lines, 1 faulty"), "{text}");
    assert!(text.contains("D.SVG: this is no SVG drawing"), "{text}");
    assert_eq!(output.status.code(), Some(1));
}

#[test]
fn three_hundred_openmoji_drawings_are_sound() {
    let openmoji = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../node_modules/openmoji/black/svg");
    if !openmoji.exists() {
        println!("skipped: the npm package openmoji is not installed");
        return;
    }
    let output = Folder::new("openmoji").run(&["corpus", &openmoji.to_string_lossy(), "--take", "300"]);
    let text = String::from_utf8_lossy(&output.stdout);
    assert_eq!(output.status.code(), Some(0), "{text}");
    assert!(text.contains("300 drawings"), "{text}");
}
