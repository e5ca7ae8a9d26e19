//! What `scumble render` writes for other programs.

use kurbo::{BezPath, ParamCurve, ParamCurveNearest, Point};

use crate::folder::{CIRCLE, Folder, INSIDE, stderr};
use crate::share::refused;

/// A folder with a drawing that was coloured and kept.
fn kept(name: &str) -> Folder {
    let folder = Folder::new(name).with("d.svg", CIRCLE).with("s.json", INSIDE);
    let color = ["color", "d.svg", "--scribbles", "s.json", "-o", "o.png", "--save", "w.scumble"];
    run(&folder, &color);
    folder
}

/// What was written to the error stream.
#[track_caller]
fn run(folder: &Folder, arguments: &[&str]) -> String {
    let output = folder.run(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", stderr(&output));
    stderr(&output)
}

fn text(folder: &Folder, name: &str) -> String {
    String::from_utf8(folder.read(name)).unwrap()
}

#[test]
fn an_svg_has_colours_and_lines_as_paths() {
    let folder = kept("export-svg");
    run(&folder, &["render", "w.scumble", "-o", "o.SVG", "--lines"]);
    let svg = text(&folder, "o.SVG");
    assert!(svg.contains(r#"width="1024" height="1024" viewBox="0 0 1024 1024""#), "{svg}");
    assert!(svg.contains(r##"<rect width="1024" height="1024" fill="#ffffff"/>"##), "{svg}");
    assert!(svg.contains(r##"<path fill="#e6194b""##), "{svg}");
    assert!(svg.contains(r##"stroke="#000000" stroke-width="32""##), "{svg}");
    assert!(!svg.contains("<image"), "{svg}");
    run(&folder, &["render", "w.scumble", "-o", "bare.svg", "--transparent", "--size", "300"]);
    let bare = text(&folder, "bare.svg");
    assert!(bare.contains(r#"width="300" height="300""#) && !bare.contains("<rect"), "{bare}");
    assert!(!bare.contains("stroke="), "{bare}");
}

#[test]
fn colours_in_an_svg_follow_their_curves() {
    let small = CIRCLE.replace("r=\"24\"", "r=\"2\"");
    let scribbles = INSIDE.replace("[[38,50],[46,54]]", "[[41.5,52],[42.5,52]]");
    let folder = Folder::new("export-bent").with("d.svg", small).with("s.json", scribbles);
    run(&folder, &["color", "d.svg", "--scribbles", "s.json", "-o", "o.png", "--save", "w.scumble"]);
    run(&folder, &["render", "w.scumble", "-o", "o.svg"]);
    let path = |name: &str, before: &[&str]| {
        let text = text(&folder, name);
        let behind = before.iter().fold(&text[..], |text, before| text.split_once(before).expect(before).1);
        BezPath::from_svg(behind.split('"').next().expect("a value")).expect("a path")
    };
    let curve = path("w.scumble", &[r#""path": ""#]);
    let fill = path("o.svg", &[r##"<path fill="#e6194b""##, r#" d=""#]);
    let off_du = |at: Point| {
        curve.segments().map(|segment| segment.nearest(at, 1e-6).distance_sq).fold(f64::MAX, f64::min).sqrt()
    };
    let points: Vec<_> = fill.segments().flat_map(|segment| [segment.start(), segment.eval(0.5)]).collect();
    assert!(points.len() > 20);
    for point in points {
        assert!(off_du(point) < 0.04, "{point} is {} du off its curve", off_du(point));
    }
}

#[test]
fn an_svg_is_opened_with_its_scribbles() {
    let folder = kept("export-opened");
    run(&folder, &["render", "w.scumble", "-o", "o.svg"]);
    assert_eq!(run(&folder, &["convert", "o.svg", "again.scumble"]), "");
    assert_eq!(folder.read("again.scumble"), folder.read("w.scumble"));
    refused(&folder, &["render", "o.svg", "-o", "o.svg"], "name another file");
    run(&folder, &["render", "o.svg", "-o", "again.svg"]);
    assert_eq!(folder.read("again.svg"), folder.read("o.svg"));
}

#[test]
fn a_damaged_svg_is_opened_without_its_scribbles_and_says_so() {
    let folder = kept("export-damaged");
    run(&folder, &["render", "w.scumble", "-o", "o.svg", "--lines"]);
    let damaged = text(&folder, "o.svg").replacen("\"points\"", "\"pints\"", 1);
    let folder = folder.with("o.svg", damaged);
    let warning = run(&folder, &["convert", "o.svg", "lines.scumble"]);
    assert!(warning.contains("without the scribbles"), "{warning}");
    let lines = text(&folder, "lines.scumble");
    assert!(lines.contains("\"curves\"") && !lines.contains("\"scribbles\""), "{lines}");
    assert_eq!(lines.matches("\"path\"").count(), 1, "the colours are no lines: {lines}");
}

#[test]
fn a_pdf_is_written_as_large_as_asked_for() {
    let folder = kept("export-pdf");
    run(&folder, &["render", "w.scumble", "-o", "o.pdf", "--lines", "--size", "400"]);
    let pdf = folder.read("o.pdf");
    assert!(pdf.starts_with(b"%PDF-1.4\n") && pdf.ends_with(b"%%EOF\n"));
    assert!(String::from_utf8_lossy(&pdf).contains("/MediaBox [0 0 300 300]"));
    assert!(pdf.len() < folder.read("o.png").len());
}

#[test]
fn a_picture_is_as_large_as_its_drawing_was() {
    let a4 =
        CIRCLE.replace("viewBox", r#"width="210mm" height="297mm" viewBox"#).replace("64 64\"", "420 594\"");
    let folder = Folder::new("export-size").with("d.svg", a4).with("s.json", INSIDE);
    run(&folder, &["color", "d.svg", "--scribbles", "s.json", "-o", "o.png", "--save", "w.scumble"]);
    assert!(text(&folder, "w.scumble").contains(r#""version": "1.3""#));
    run(&folder, &["render", "w.scumble", "-o", "o.svg"]);
    assert!(text(&folder, "o.svg").contains(r#"width="210mm" height="297mm" viewBox="0 0 724.04 1024""#));
    run(&folder, &["render", "o.svg", "-o", "o.pdf"]);
    let pdf = String::from_utf8_lossy(&folder.read("o.pdf")).into_owned();
    assert!(pdf.contains("/MediaBox [0 0 595.276 841.89]"), "{pdf}");
    run(&folder, &["render", "o.svg", "-o", "small.svg", "--size", "512"]);
    assert!(text(&folder, "small.svg").contains(r#"width="362" height="512""#));
}

#[test]
fn a_name_of_another_kind_of_picture_is_refused() {
    let folder = kept("export-jpg");
    refused(&folder, &["render", "w.scumble", "-o", "o.jpg"], "name a file that ends in .png, .svg or .pdf");
}
