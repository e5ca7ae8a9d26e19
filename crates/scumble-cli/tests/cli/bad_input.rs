//! Bad input: exit code 2, a message that says what is wrong, and nothing written.

use crate::folder::{CIRCLE, Folder, INSIDE, stderr};

/// Colours a drawing that cannot be coloured.
#[track_caller]
fn refused(name: &str, drawing: impl AsRef<[u8]>, scribbles: impl AsRef<[u8]>, message: &str) {
    let folder = Folder::new(&format!("bad-{name}")).with("d.svg", drawing).with("s.json", scribbles);
    refused_call(&folder, &["color", "d.svg", "--scribbles", "s.json", "-o", "o.png"], message);
    assert_eq!(folder.names(), ["d.svg", "s.json"], "nothing was written");
}

#[track_caller]
fn refused_call(folder: &Folder, arguments: &[&str], message: &str) {
    let output = folder.run(arguments);
    let text = stderr(&output);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {text}");
    assert!(text.starts_with("scumble: ") && text.contains(message), "{arguments:?}: {text}");
    assert!(output.stdout.is_empty());
}

fn svg(content: &str) -> String {
    format!(r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 64 64">{content}</svg>"#)
}

const LINE: &str = r#"<path d="M1 1h6" stroke="black"/>"#;

#[test]
fn drawings_that_are_none() {
    refused("empty", "", INSIDE, "is empty");
    refused("html", "<html/>", INSIDE, "starts with <html>");
    refused("text", "just some text", INSIDE, "d.svg: this is no SVG drawing");
    refused("junk", [0_u8, 159, 146, 150, 255, 0, 7], INSIDE, "not an SVG drawing");
    refused("pdf", "%PDF-1.7", INSIDE, "d.svg: the file is a PDF file; save it as SVG");
    refused("eps", "%!PS-Adobe-3.0", INSIDE, "PostScript");
    refused("gzip", [0x1f_u8, 0x8b, 8, 0, 1, 2, 3], INSIDE, "compressed");
    refused("no-curves", svg("<g/>"), INSIDE, "no lines");
    refused("only-text", svg("<text>a</text>"), INSIDE, "1 text");
}

#[test]
fn a_version_is_asked_for_alone() {
    let output = Folder::new("version").run(&["--version"]);
    assert!(output.status.success());
    assert_eq!(String::from_utf8_lossy(&output.stdout), format!("scumble {}\n", env!("CARGO_PKG_VERSION")));
    refused_call(&Folder::new("version-more"), &["color", "d.svg", "--version"], "are expected");
}

#[test]
fn help_is_given_for_all_commands_at_once() {
    for call in [&["help"][..], &["help", "color"], &["color", "--help"], &[]] {
        let output = Folder::new("help").run(call);
        assert!(output.status.success(), "{call:?}: {}", stderr(&output));
        assert!(String::from_utf8_lossy(&output.stdout).contains("scumble color DRAWING.svg"), "{call:?}");
    }
}

#[test]
fn a_message_names_the_file_that_it_is_about() {
    refused("names-drawing", svg(""), INSIDE, "d.svg: the drawing has no lines");
    refused("names-scribbles", CIRCLE, "{}", "s.json: the scribbles file");
}

#[test]
fn a_compressed_drawing_is_told_by_its_bytes_whatever_it_is_called() {
    const GZIP: [u8; 7] = [0x1f, 0x8b, 8, 0, 1, 2, 3];
    let names = ["d.svg", "d.svgz", "e.SVGZ"];
    let folder = names.into_iter().fold(Folder::new("svgz"), |folder, name| folder.with(name, GZIP));
    for name in names {
        refused_call(&folder, &["render", name, "-o", "o.png"], "compressed");
    }
}

#[test]
fn a_picture_never_takes_the_place_of_its_drawing() {
    let folder = Folder::new("over-input").with("d.png", CIRCLE).with("s.png", INSIDE);
    for output in ["d.png", "./s.png"] {
        refused_call(&folder, &["color", "d.png", "--scribbles", "s.png", "-o", output], "name another file");
    }
    assert_eq!(folder.read("d.png"), CIRCLE.as_bytes());
}

#[test]
fn drawings_without_a_page() {
    refused("zero-view-box", CIRCLE.replace("10 20 64 64", "0 0 0 64"), INSIDE, "no area");
    refused("nan-view-box", CIRCLE.replace("10 20 64 64", "0 0 NaN 64"), INSIDE, "no area");
}

#[test]
fn coordinates_that_are_no_places() {
    refused(
        "nan",
        svg(r#"<path d="M NaN 1 L 2 2" stroke="black"/>"#),
        INSIDE,
        "1 shape with unusable coordinates",
    );
    refused("huge", svg(r#"<path d="M 1 1 L 1e308 2" stroke="black"/>"#), INSIDE, "unusable coordinates");
}

#[test]
fn drawings_made_to_hurt() {
    refused("large", svg(&LINE.repeat(50_000_000 / LINE.len())), INSIDE, "larger than the 20 MB");
    refused(
        "nested",
        svg(&format!("{}{}", "<g>".repeat(1_000_000), "</g>".repeat(1_000_000))),
        INSIDE,
        "elements",
    );
    refused("deep", svg(&format!("{}{LINE}{}", "<g>".repeat(9000), "</g>".repeat(9000))), INSIDE, "too deep");
    let level =
        |i: usize| format!(r##"<g id="u{i}">{}</g>"##, format!(r##"<use href="#u{}"/>"##, i - 1).repeat(10));
    let levels: String = (1..=9).map(level).collect();
    refused("use", svg(&format!(r#"<g id="u0">{LINE}</g>{levels}"#)), INSIDE, "<use>");
    let laughs: String =
        (1..10).map(|i| format!(r#"<!ENTITY l{i} "{}">"#, format!("&l{};", i - 1).repeat(10))).collect();
    let bomb = format!(r#"<!DOCTYPE svg [<!ENTITY l0 "lol">{laughs}]>{}"#, svg("<text>&l9;</text>"));
    refused("entities", bomb, INSIDE, "entities");
}

#[test]
fn scribbles_that_are_none() {
    refused("scribbles-empty", CIRCLE, "", "is empty");
    refused("scribbles-junk", CIRCLE, [0_u8, 255, 1], "cannot be read");
    refused("scribbles-form", CIRCLE, "{}", "scribbles");
    refused("scribbles-color", CIRCLE, INSIDE.replace("#e6194b", "red"), "1 scribble without a colour");
    refused("scribbles-width", CIRCLE, INSIDE.replace("1.5", "0"), "1 scribble of unusable width");
    refused("scribbles-points", CIRCLE, INSIDE.replace("[38,50],[46,54]", ""), "1 scribble without points");
    refused(
        "scribbles-far",
        CIRCLE,
        INSIDE.replace("[38,50],[46,54]", "[1e300,9]"),
        "1 scribble off the page",
    );
    refused("scribbles-infinite", CIRCLE, INSIDE.replace("38", "1e999"), "cannot be read");
}

#[test]
fn calls_that_make_no_sense() {
    let folder = Folder::new("bad-calls").with("d.svg", CIRCLE).with("s.json", INSIDE);
    let color = ["color", "d.svg", "--scribbles", "s.json", "-o", "o.png"];
    for (extra, message) in [
        (&["--size", "0"][..], "--size 0: give a number of pixels from 1 to 16384"),
        (&["--size", "99999"], "1 to 16384"),
        (&["--size", "big"], "1 to 16384"),
        (&["--size"], "--size"),
        (&["--blend", "cmyk"], "oklab or srgb"),
        (&["--engine", "magic"], "global or progressive"),
        (&["--solver", "magic"], "mesh, gpu, cpu-grid or jeschke"),
        (&["--solver", "cpu-grid", "--timings"], "leave out --solver"),
        (&["--solver", "jeschke", "--size", "2049"], "up to 2048 pixels"),
        (&["--spread", "--engine", "progressive"], "only --engine global spreads"),
        (&["--gap-closing", "1.5"], "from 0 to 1"),
        (&["--gap-closing", "NaN"], "from 0 to 1"),
        (&["--gap-closing", "wide"], "from 0 to 1"),
        (&["--wide"], "--wide is unknown"),
        (&["--lines=yes"], "--lines is unknown here, or takes no value"),
        (&["--size=0"], "--size 0: give a number"),
        (&["-"], "“-” names no file"),
        (&["-o", "p.png"], "given twice"),
        (&["e.svg"], "2 arguments"),
    ] {
        refused_call(&folder, &[&color, extra].concat(), message);
    }
    refused_call(&folder, &["colour"], "no command “colour”");
    refused_call(&folder, &["color", "d.svg", "-o", "o.png"], "--scribbles is missing");
    refused_call(&folder, &["color", "d.svg", "--scribbles", "s.json"], "-o is missing");
    refused_call(&folder, &["color", "--scribbles", "s.json", "-o", "o.png"], "DRAWING.svg is missing");
    refused_call(
        &folder,
        &["color", "x.svg", "--scribbles", "s.json", "-o", "o.png"],
        "x.svg cannot be read",
    );
    refused_call(
        &folder,
        &["color", "d.svg", "--scribbles", "x.json", "-o", "o.png"],
        "x.json cannot be read",
    );
    refused_call(
        &folder,
        &["color", "d.svg", "--scribbles", "s.json", "-o", "no/o.png"],
        "no/o.png cannot be written: there is no folder no; make it",
    );
    let saved = ["color", "d.svg", "--scribbles", "s.json", "-o", "o.png", "--save", "no/s.scumble"];
    refused_call(&folder, &saved, "no/s.scumble cannot be written");
    assert!(!folder.names().contains(&"o.png".to_owned()), "no picture without its work");
    refused_call(&folder, &["color", "d.svg", "--scribbles", "s.json", "-o", "."], "cannot be written");
    refused_call(&folder, &["color", "d.svg", "--scribbles", "s.json", "-o", "o.jpg"], "ends in .png");
    refused_call(&folder, &["corpus", ".", "--take", "0"], "above zero");
    refused_call(&folder, &["corpus", "nowhere"], "nowhere cannot be read");
    refused_call(&folder, &["bench", "nowhere"], "cannot be read");
    refused_call(&folder, &["bench", "--made", "nowhere"], "arguments");
    refused_call(&folder, &["bench", "--made", "--memory"], "--memory is unknown here");
    assert_eq!(folder.names(), ["d.svg", "s.json"]);
}

#[test]
fn a_picture_that_is_there_stays_as_it_was() {
    let folder = Folder::new("bad-kept").with("d.svg", "").with("s.json", INSIDE).with("o.png", "old");
    refused_call(&folder, &["color", "d.svg", "--scribbles", "s.json", "-o", "o.png"], "is empty");
    assert_eq!(folder.read("o.png"), b"old");
}

#[test]
fn a_picture_whose_work_cannot_be_written_stays_as_it_was() {
    let folder = Folder::new("bad-work").with("d.svg", CIRCLE).with("s.json", INSIDE).with("o.png", "old");
    let folder = folder.with("w.scumble", "old");
    let path = read_only(&folder, "w.scumble");
    let color = ["color", "d.svg", "--scribbles", "s.json", "-o", "o.png", "--save"];
    refused_call(&folder, &[&color[..], &["w.scumble"]].concat(), "is read-only");
    std::fs::remove_file(path).unwrap();
    std::fs::create_dir(folder.path().join("w.scumble")).unwrap();
    refused_call(&folder, &[&color[..], &["w.scumble"]].concat(), "it is a folder");
    assert_eq!(folder.read("o.png"), b"old");
    assert_eq!(folder.names(), ["d.svg", "o.png", "s.json", "w.scumble"]);
}

/// Has a file that may not be written to.
fn read_only(folder: &Folder, name: &str) -> std::path::PathBuf {
    let path = folder.path().join(name);
    let mut permissions = std::fs::metadata(&path).unwrap().permissions();
    permissions.set_readonly(true);
    std::fs::set_permissions(&path, permissions).unwrap();
    path
}

#[test]
fn what_may_not_be_written_to_stays_as_it_was() {
    let folder =
        Folder::new("bad-read-only").with("d.svg", CIRCLE).with("s.json", INSIDE).with("o.png", "old");
    read_only(&folder, "o.png");
    refused_call(&folder, &["color", "d.svg", "--scribbles", "s.json", "-o", "o.png"], "is read-only");
    assert_eq!(folder.read("o.png"), b"old");
}
