//! `scumble eval` on sets of one drawing.

use std::fs;
use std::io::Cursor;

use crate::folder::{CIRCLE, Folder, INSIDE, stderr};

const SIDE_PX: u32 = 64;

/// The truth of a red scribble in the circle: its inside is red, the upper half beside a curve, all else unscored.
fn truth() -> Vec<u8> {
    let pixel = |x: u32, y: u32| {
        let radius_px = (f64::from(x) - 31.5).hypot(f64::from(y) - 31.5);
        let green = if y < 32 { 255 } else { 128 };
        [if radius_px < 22.0 { [0, green, 0] } else { [1, 0, 0] }].concat()
    };
    let rgb: Vec<u8> = (0..SIDE_PX).flat_map(|y| (0..SIDE_PX).flat_map(move |x| pixel(x, y))).collect();
    png_file(SIDE_PX, png::ColorType::Rgb, &rgb)
}

fn png_file(side_px: u32, color: png::ColorType, data: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = png::Encoder::new(Cursor::new(&mut file), side_px, side_px);
    encoder.set_color(color);
    encoder.write_header().unwrap().write_image_data(data).unwrap();
    file
}

/// A set of one drawing.
fn set(name: &str) -> Folder {
    let folder = Folder::new(&format!("eval-{name}"));
    fs::create_dir(folder.path().join("circle")).unwrap();
    folder
        .with("index.json", r#"[{"id":"circle","name":"a circle"}]"#)
        .with("circle/drawing.svg", CIRCLE)
        .with("circle/sparse.json", INSIDE)
        .with("circle/dense.json", INSIDE)
        .with("circle/truth.png", truth())
}

#[track_caller]
fn report(folder: &Folder, options: &[&str]) -> String {
    let output = folder.run(&[&["eval", "."], options].concat());
    assert!(output.status.success(), "{}", stderr(&output));
    String::from_utf8(output.stdout).unwrap()
}

#[test]
fn every_method_colours_a_closed_shape() {
    let folder = set("methods");
    for method in ["global", "progressive", "sight", "flood", "lazybrush", "lazybrush-soft", "nearest"] {
        let text = report(&folder, &["--engine", method]);
        let expected = format!("{method}, dense: 1 drawings: side 1.0000 area 1.0000 cover 1.0000");
        assert!(text.contains(&expected), "{text}");
        assert!(text.contains("  worst circle"), "{text}");
        assert!(text.contains("all scribbles at once"), "{text}");
    }
}

#[test]
fn a_scribble_on_the_wrong_side_has_nothing_right() {
    let outside = INSIDE.replace("[38,50],[46,54]", "[12,22],[14,24]");
    let folder = set("wrong").with("circle/sparse.json", outside);
    let text = report(&folder, &["--kind", "sparse"]);
    assert!(text.contains("side 0.0000 area 0.0000 cover 0.0000"), "{text}");
}

#[test]
fn single_scribbles_are_reported_beside_the_plain_ways() {
    let text = report(&set("single"), &["--single"]);
    let lines: Vec<_> = text.lines().collect();
    assert_eq!(lines.len(), 3, "{text}");
    for (line, method) in lines.iter().zip(["global", "flood", "sight"]) {
        assert!(line.starts_with(method), "{text}");
        assert!(line.contains("precision 1.0000 (0 below 0.5), recall 1.0000 (0 below 0.5)"), "{text}");
    }
}

#[test]
fn pictures_and_a_sheet_are_written_where_asked() {
    let folder = set("pictures");
    report(&folder, &["--sheet", "sheet.png", "--pictures", "out/pictures"]);
    let size = |name: &str| {
        let reader = png::Decoder::new(Cursor::new(folder.read(name))).read_info().unwrap();
        reader.info().size()
    };
    assert_eq!(size("out/pictures/circle.png"), (SIDE_PX, SIDE_PX));
    assert!(size("sheet.png").0 > 3 * SIDE_PX);
}

#[track_caller]
fn refused(folder: &Folder, options: &[&str], message: &str) {
    let output = folder.run(&[&["eval", "."], options].concat());
    let text = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{text}");
    assert!(text.starts_with("scumble: ") && text.contains(message), "{text}");
    assert!(output.stdout.is_empty());
}

#[test]
fn bad_sets_are_refused_with_a_reason() {
    let refused = |folder: Folder, message| refused(&folder, &[], message);
    refused(Folder::new("eval-empty"), "index.json cannot be read");
    refused(set("index").with("index.json", "{}"), "index.json is no list of drawings");
    refused(set("none").with("index.json", "[]"), "index.json lists no drawing");
    refused(set("id").with("index.json", r#"[{"id":"square"}]"#), "drawing square: ");
    refused(set("drawing").with("circle/drawing.svg", "<svg"), "drawing circle: ");
    refused(set("scribbles").with("circle/dense.json", "[]"), "dense.json: ");
    refused(set("color").with("circle/dense.json", INSIDE.replace("e6194b", "123456")), "#123456");
    refused(set("text").with("circle/truth.png", "truth"), "truth.png: not a PNG file");
    let cut = &truth()[..60];
    refused(set("cut").with("circle/truth.png", cut), "truth.png: ");
    let gray = png_file(4, png::ColorType::Grayscale, &[0; 16]);
    refused(set("gray").with("circle/truth.png", gray), "three channels");
    let wide = CIRCLE.replace("10 20 64 64", "10 20 128 64");
    refused(set("shape").with("circle/drawing.svg", wide), "shape of the drawing");
}

#[test]
fn calls_that_make_no_sense_are_refused() {
    let folder = set("calls");
    for (options, message) in [
        (&["--engine", "crayon"][..], "lazybrush"),
        (&["--kind", "thick"], "sparse or dense"),
        (&["--gap-closing", "2"], "from 0 to 1"),
        (&["--gap-closing", "NaN"], "from 0 to 1"),
        (&["--single", "--sheet", "s.png"], "--single makes no pictures"),
        (&["--single", "--spread"], "--single takes sparse scribbles"),
        (&["--single", "--kind", "dense"], "--single takes sparse scribbles"),
        (&["--sheet", "no/s.png"], "no/s.png cannot be written"),
        (&["more"], "2 arguments"),
    ] {
        refused(&folder, options, message);
    }
}
