//! Palettes in and out of drawings, and into each other.

use crate::folder::{CIRCLE, Folder};
use crate::share::{refused, run, text};

const SEA: &str = "GIMP Palette\nName: Sea\n  1 2 3\tdeep\n200 220 255\tshallow\n";

#[test]
fn a_palette_goes_into_a_drawing_and_out_again() {
    let folder = Folder::new("palette").with("d.svg", CIRCLE).with("sea.gpl", SEA);
    run(&folder, &["palette", "d.svg", "--from", "sea.gpl", "-o", "d.scumble"]);
    assert!(text(&folder, "d.scumble").contains("\"palette\": [\n\"#010203\",\n\"#c8dcff\"\n]"));
    assert!(text(&folder, "d.scumble").contains("\"swatch_names\": [\"deep\", \"shallow\"]"));
    run(&folder, &["convert", "d.scumble", "out.ase"]);
    run(&folder, &["convert", "out.ase", "out.gpl"]);
    assert!(text(&folder, "out.gpl").ends_with("\n  1   2   3\tdeep\n200 220 255\tshallow\n"));
    run(&folder, &["convert", "out.gpl", "out.hex"]);
    assert_eq!(text(&folder, "out.hex"), "010203\nc8dcff\n");
    refused(
        &folder,
        &["palette", "d.scumble", "--from", "out.hex", "-o", "./d.scumble"],
        "name another file",
    );
}

#[test]
fn a_palette_that_is_damaged_at_its_beginning_is_called_what_its_name_says() {
    let folder = Folder::new("palette-begin").with("sea.gpl", "\nGIMP\n1 2 3\n").with("sea.ase", "ASE");
    refused(&folder, &["convert", "sea.gpl", "x.hex"], "line 2 should have “GIMP Palette”");
    refused(&folder, &["convert", "sea.ase", "x.hex"], "Adobe Swatch Exchange");
}

#[test]
fn bad_palettes_are_refused() {
    let bad = SEA.replace("200 ", "300 ");
    let folder =
        Folder::new("palette-bad").with("d.svg", CIRCLE).with("bad.gpl", bad).with("none.gpl", "none");
    refused(&folder, &["palette", "d.svg", "--from", "bad.gpl", "-o", "x.scumble"], "line 4");
    refused(&folder, &["palette", "d.svg", "--from", "none.gpl", "-o", "x.scumble"], "“GIMP Palette”");
    refused(&folder, &["palette", "d.svg", "-o", "x.scumble"], "--from is missing");
    refused(&folder, &["palette", "d.svg", "--from", "bad.gpl"], "-o is missing");
    refused(&folder, &["convert", "d.svg", "x.gpl"], "no palette of its own");
    refused(&folder, &["convert", "bad.gpl", "x.scumble"], "not a Scumble file");
}
