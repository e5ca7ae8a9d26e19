//! Diffusion curves in and out of the program: the picture of what was written is the one that it was written of.

use crate::folder::{CIRCLE, Folder, INSIDE};
use crate::share::{difference, pixels, refused, run, text};

/// Two curves with a gap between them, a line that crosses both, and a curve that leaves the page.
const OPEN: &str = r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 200 150" fill="none" stroke="black">
    <path d="M100 20C30 20 30 120 90 120"/><path d="M110 120C170 120 170 20 106 20"/>
    <path d="M20 70H180"/><path d="M20 20C-60 60 -60 100 30 140L190 145"/></svg>"#;

const COLORS: &str = r##"{"scribbles":[
    {"color":"#e6194b","width":3,"points":[[60,40],[90,45]]},{"color":"#4363d8","width":3,"points":[[120,50],[140,60]]},
    {"color":"#ffe119","width":3,"points":[[80,100],[120,100]]},{"color":"#3cb44b","width":3,"points":[[170,20],[180,30]]}]}"##;

/// How far a picture may be from the one that its curves were written of: in the mean, and at most pixels, in levels.
const MEAN_LEVELS: f64 = 0.5;
const MOST_LEVELS: u8 = 4;

/// A part of the pixels may be further off: those at the curves themselves, whose samples lie elsewhere, and where colours
/// meet, which is up to a piece elsewhere.
const MOST: f64 = 0.985;

#[track_caller]
fn comes_back(name: &str, drawing: &str, scribbles: &str, options: &[&str]) -> Folder {
    let folder = Folder::new(name).with("d.svg", drawing).with("s.json", scribbles);
    let color =
        ["color", "d.svg", "--scribbles", "s.json", "-o", "o.png", "--size", "256", "--save", "w.scumble"];
    run(&folder, &[&color[..], options].concat());
    run(&folder, &["convert", "w.scumble", "w.xml"]);
    run(&folder, &["render", "w.xml", "-o", "again.png", "--size", "256"]);
    let [before, after] = ["o.png", "again.png"].map(|name| pixels(&folder, name));
    let mean = difference(&before, &after);
    let near = before.iter().zip(&after).filter(|(a, b)| a.abs_diff(**b) <= MOST_LEVELS).count();
    let near = near as f64 / before.len() as f64;
    assert!(mean < MEAN_LEVELS && near > MOST, "{name}: {mean} levels off, {near} of the pixels near");
    folder
}

#[test]
fn pictures_come_back() {
    for blend in ["srgb", "oklab"] {
        comes_back(&format!("curves-circle-{blend}"), CIRCLE, INSIDE, &["--blend", blend]);
        comes_back(&format!("curves-open-{blend}"), OPEN, COLORS, &["--blend", blend]);
        let spread = ["--blend", blend, "--spread", "--gap-closing", "0.8"];
        comes_back(&format!("curves-spread-{blend}"), OPEN, COLORS, &spread);
    }
}

#[test]
fn a_closed_curve_of_two_colours_is_cut_once_at_most() {
    let two = r##"{"scribbles":[{"color":"#e6194b","width":1.5,"points":[[46,38],[48,40]]},
        {"color":"#4363d8","width":1.5,"points":[[36,62],[38,66]]}]}"##;
    let folder = comes_back("curves-two", CIRCLE, two, &["--blend", "srgb"]);
    let curves = text(&folder, "w.xml").matches("<curve ").count();
    assert!(curves <= 2, "{curves}");
}

#[test]
fn what_was_read_is_written_as_it_was() {
    let folder = comes_back("curves-again", OPEN, COLORS, &["--blend", "srgb"]);
    run(&folder, &["convert", "w.xml", "kept.scumble"]);
    assert!(text(&folder, "kept.scumble").contains("\"color_points\""));
    run(&folder, &["convert", "kept.scumble", "again.xml"]);
    let curves = |name| text(&folder, name).matches("<curve ").count();
    assert_eq!(curves("w.xml"), curves("again.xml"));
    run(&folder, &["render", "again.xml", "-o", "twice.png", "--size", "256"]);
    assert!(difference(&pixels(&folder, "o.png"), &pixels(&folder, "twice.png")) < MEAN_LEVELS);
}

#[test]
fn curves_can_be_coloured_on() {
    let folder = comes_back("curves-shaded", CIRCLE, INSIDE, &[]);
    let shade = r##"{"scribbles":[{"color":"#ffffff","kind":"shade","strength":1,"width":200,"points":[[512,512]]}]}"##;
    let folder = folder.with("shade.json", shade);
    run(
        &folder,
        &[
            "color",
            "w.xml",
            "--scribbles",
            "shade.json",
            "-o",
            "shaded.png",
            "--size",
            "256",
            "--save",
            "s.scumble",
        ],
    );
    let shaded = pixels(&folder, "shaded.png");
    let pixel = |x: usize, y: usize| &shaded[4 * (256 * y + x)..][..3];
    assert!(pixel(128, 128).iter().all(|level| *level > 250), "{:?}", pixel(128, 128));
    assert!(pixel(128, 34)[1] < 60, "{:?}", pixel(128, 34));
    let output = folder.run(&["convert", "s.scumble", "s.xml"]);
    assert!(crate::folder::stderr(&output).contains("1 scribble that shades"), "{output:?}");
}

#[test]
fn bad_curves_are_refused() {
    let folder = Folder::new("curves-bad").with("bad.xml", "<curve_set/>").with("d.svg", CIRCLE);
    refused(&folder, &["convert", "bad.xml", "x.scumble"], "image_width");
    refused(&folder, &["render", "bad.xml", "-o", "x.png"], "image_width");
    refused(&folder, &["open", "#1.AA", "-o", "x.xml"], ".scumble");
}
