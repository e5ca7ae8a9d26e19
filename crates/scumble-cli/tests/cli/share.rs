//! What `scumble link`, `open`, `convert` and `render` make, and `color --save`.

use crate::folder::{CIRCLE, Folder, INSIDE, stderr};

/// A folder with a drawing, its scribbles, both saved, and the picture of them.
fn saved(name: &str) -> Folder {
    let folder = Folder::new(name).with("d.svg", CIRCLE).with("s.json", INSIDE);
    let color = ["color", "d.svg", "--scribbles", "s.json", "-o", "o.png", "--save", "w.scumble"];
    run(&folder, &[&color[..], &["--size", "200", "--gap-closing", "0.25", "--spread"]].concat());
    folder
}

#[track_caller]
pub(crate) fn run(folder: &Folder, arguments: &[&str]) -> String {
    let output = folder.run(arguments);
    assert!(output.status.success(), "{arguments:?}: {}", stderr(&output));
    String::from_utf8(output.stdout).unwrap()
}

#[track_caller]
pub(crate) fn refused(folder: &Folder, arguments: &[&str], message: &str) {
    let names = folder.names();
    let output = folder.run(arguments);
    assert_eq!(output.status.code(), Some(2), "{arguments:?}");
    assert!(stderr(&output).contains(message), "{arguments:?}: {}", stderr(&output));
    assert_eq!((folder.names(), output.stdout.len()), (names, 0), "nothing was written");
}

pub(crate) fn pixels(folder: &Folder, name: &str) -> Vec<u8> {
    let mut reader = png::Decoder::new(std::io::Cursor::new(folder.read(name))).read_info().unwrap();
    let mut rgba = vec![0; reader.output_buffer_size().unwrap()];
    reader.next_frame(&mut rgba).unwrap();
    rgba
}

/// The mean difference of two pictures, in levels.
pub(crate) fn difference(a: &[u8], b: &[u8]) -> f64 {
    assert_eq!(a.len(), b.len());
    let sum: u64 = a.iter().zip(b).map(|(a, b)| u64::from(a.abs_diff(*b))).sum();
    sum as f64 / a.len() as f64
}

pub(crate) fn text(folder: &Folder, name: &str) -> String {
    String::from_utf8(folder.read(name)).unwrap()
}

fn last_line(text: &str) -> &str {
    text.lines().last().unwrap()
}

#[test]
fn a_coloured_drawing_is_kept_with_its_scribbles_and_settings() {
    let folder = saved("save");
    let file = text(&folder, "w.scumble");
    assert!(
        file.contains(r##"{"color": "#e6194b", "width": 24, "points": [[448,480], [576,544]]}"##),
        "{file}"
    );
    assert!(file.contains(r#""gap_closing": 0.25, "spread": true"#), "{file}");
    run(&folder, &["render", "w.scumble", "-o", "again.png", "--size", "200"]);
    assert!(difference(&pixels(&folder, "o.png"), &pixels(&folder, "again.png")) < 0.01);
    refused(&folder, &["render", "w.scumble", "-o", "w.scumble"], "ends in .png, .svg or .pdf");
}

#[test]
fn a_link_becomes_the_file_again() {
    let folder = saved("link");
    let printed = run(&folder, &["link", "w.scumble"]);
    let link = last_line(&printed);
    assert!(link.starts_with("#1.") && link.len() < 200, "{link}");
    let based = run(&folder, &["link", "w.scumble", "--base", "https://example.org/a/"]);
    assert_eq!(last_line(&based), format!("https://example.org/a/{link}"));
    run(&folder, &["open", last_line(&based), "-o", "opened.scumble"]);
    let again = run(&folder, &["link", "opened.scumble"]);
    assert_eq!(last_line(&again), link);
    run(&folder, &["render", "opened.scumble", "-o", "again.png", "--size", "200"]);
    assert!(difference(&pixels(&folder, "o.png"), &pixels(&folder, "again.png")) < 0.5);
}

#[test]
fn statistics_come_before_the_link() {
    let printed = run(&saved("stats"), &["link", "w.scumble", "--stats"]);
    assert!(printed.contains("bytes per point") && last_line(&printed).starts_with("#1."), "{printed}");
    let scribbles = printed.lines().find(|line| line.starts_with("scribbles")).unwrap();
    let cells: Vec<_> = scribbles.split_whitespace().collect();
    let [_, "1", "2", bytes, per_point] = cells[..] else { panic!("{scribbles}") };
    let per_point: f64 = per_point.parse().unwrap();
    assert!((2.0 * per_point - bytes.parse::<f64>().unwrap()).abs() <= 0.011, "{scribbles}");
}

#[test]
fn damaged_links_are_refused() {
    let folder = saved("damaged");
    let printed = run(&folder, &["link", "w.scumble"]);
    let link = last_line(&printed);
    let open = |link: &str, message| refused(&folder, &["open", link, "-o", "x.scumble"], message);
    open(&link[..link.len() - 1], "damaged");
    open(&link.replacen("#1.", "#2.", 1), "newer Scumble");
    open("https://example.org/", "no link");
    refused(&folder, &["open", link, "-o", "x.png"], ".scumble");
    refused(&folder, &["open", link], "-o is missing");
    refused(&folder, &["link", "w.scumble", "--base", "https://example.org/#"], "up to it");
    refused(&folder, &["link", "w.scumble", "--base", "--stats"], "--base --stats is no address");
    refused(&folder, &["link", "w.scumble", "--base", "a b"], "is no address");
}

#[test]
fn a_link_to_a_sample_takes_its_lines_from_the_folder_of_samples() {
    let folder = saved("sample");
    let named = text(&folder, "w.scumble").replacen("\"canvas\"", "\"sample\": \"d.svg\",\n\"canvas\"", 1);
    let folder = folder.with("named.scumble", &named);
    let printed = run(&folder, &["link", "named.scumble"]);
    let link = last_line(&printed);
    refused(&folder, &["open", link, "-o", "x.scumble"], "--samples");
    refused(&folder, &["open", link, "-o", "x.scumble", "--samples", "nowhere"], "cannot be read");
    run(&folder, &["open", link, "-o", "opened.scumble", "--samples", "."]);
    assert_eq!(text(&folder, "opened.scumble"), named);
}

#[test]
fn curves_of_a_sample_are_written_with_its_lines() {
    let named = text(&saved("sample-curves"), "w.scumble").replacen(
        "\"canvas\"",
        "\"sample\": \"d.svg\",\n\"canvas\"",
        1,
    );
    let lines = named.find(",\n\"curves\"").unwrap();
    let end = named[lines + 1..].find("\n],").unwrap() + lines + 3;
    let bare = [&named[..lines], &named[end..]].concat();
    let folder = Folder::new("sample-curves").with("d.svg", CIRCLE).with("n.scumble", bare);
    refused(&folder, &["convert", "n.scumble", "n.xml"], "name the folder with the samples");
    run(&folder, &["convert", "n.scumble", "n.xml", "--samples=."]);
    assert!(text(&folder, "n.xml").contains("<curve "));
    run(&folder, &["convert", "n.scumble", "n.json"]);
}

#[test]
fn a_file_is_told_by_how_it_begins_whatever_it_is_called() {
    let folder = saved("kinds");
    let work = text(&folder, "w.scumble");
    let folder = folder.with("line", CIRCLE).with("line.json", format!("\u{feff}\n{CIRCLE}"));
    let folder = folder.with("work", &work).with("work.svg", format!("\u{feff} {work}"));
    for name in ["line", "line.json", "work", "work.svg"] {
        run(&folder, &["render", name, "-o=r.png", "--size=64"]);
        run(&folder, &["convert", name, "c.scumble"]);
    }
    for name in ["work", "work.svg", "w.scumble"] {
        let color = ["color", name, "--scribbles", "s.json", "-o", "r.png"];
        refused(&folder, &color, "scumble render");
    }
}

#[test]
fn an_exported_picture_is_not_coloured_anew() {
    let folder = saved("exported");
    run(&folder, &["render", "w.scumble", "-o", "e.svg"]);
    let color = ["color", "e.svg", "--scribbles", "s.json", "-o", "x.png"];
    refused(&folder, &color, "e.svg was made of a .scumble file, which it keeps; `scumble render`");
}

#[test]
fn files_turn_into_each_other() {
    let folder = saved("convert");
    run(&folder, &["convert", "d.svg", "d.scumble"]);
    run(&folder, &["convert", "w.scumble", "w.json"]);
    run(&folder, &["convert", "w.json", "again.scumble"]);
    assert_eq!(folder.read("again.scumble"), folder.read("w.scumble"));
    assert!(text(&folder, "d.scumble").contains("\"curves\""));
    run(&folder, &["render", "d.svg", "-o", "d.png", "--lines", "--size", "64"]);
    refused(&folder, &["convert", "w.json", "w.svg"], "ends in .scumble, .json, .xml");
    refused(&folder, &["convert", "w.json", "./w.json"], "name another file");
    refused(&folder, &["convert", "s.json", "x.scumble"], "not a Scumble file");
    refused(&folder, &["convert", "missing.scumble", "x.scumble"], "cannot be read");
}

/// A page with one line and a picture of one pixel under it.
const TRACED: &str = r##"{
"format": "scumble",
"version": "1.1",
"canvas": [0, 0, 64, 64],
"settings": {"blend": "oklab", "engine": "global", "gap_closing": 0.5, "spread": false},
"curves": [
{"path": "M 100 100 L 900 100", "width": 9, "color": "#000000"}
],
"tracing_opacity": 0.25,
"tracing_image": "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNoAAAAggCBd81ytgAAAABJRU5ErkJggg=="
}
"##;

#[test]
fn a_tracing_image_stays_in_files_and_goes_nowhere_else() {
    let folder = Folder::new("traced").with("w.scumble", TRACED).with("sea.hex", "#010203");
    run(&folder, &["convert", "w.scumble", "again.scumble"]);
    assert_eq!(text(&folder, "again.scumble"), TRACED);
    run(&folder, &["palette", "w.scumble", "--from", "sea.hex", "-o", "sea.scumble"]);
    assert_eq!(text(&folder, "sea.scumble").replace(",\n\"palette\": [\n\"#010203\"\n]", ""), TRACED);

    let (before, rest) = TRACED.split_once(",\n\"tracing_opacity").unwrap();
    let bare = [before, "\n}\n"].concat().replace("1.1", "1.0");
    assert!(rest.contains("tracing_image"));
    let folder = folder.with("bare.scumble", bare);
    for output in ["o.png", "o.svg", "o.pdf"] {
        run(&folder, &["render", "w.scumble", "-o", output, "--lines"]);
        let traced = folder.read(output);
        run(&folder, &["render", "bare.scumble", "-o", output, "--lines"]);
        assert_eq!(traced, folder.read(output), "{output}");
    }
    let linked = folder.run(&["link", "w.scumble"]);
    assert!(stderr(&linked).contains("left out: the tracing image"), "{}", stderr(&linked));
    assert_eq!(String::from_utf8(linked.stdout).unwrap(), run(&folder, &["link", "bare.scumble"]));
}
