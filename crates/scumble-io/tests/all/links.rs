//! Links: how long they are, and what becomes of those that are none, damaged, hostile or of another version.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::collections::BTreeSet;
use std::path::Path;
use std::{fs, iter};

use kurbo::{Affine, BezPath, Point, Rect};
use scumble_core::work::{Item, Unknown};
use scumble_core::{Curve, Document, Drawing, Paint, Scribble, Work};
use scumble_io::{
    LinkError, MAX_LINK, import_svg, read_file, read_link, read_scribbles, write_file, write_link,
};
use serde_json::Value;

use crate::made::session;

const LINKS: &str = include_str!("../fixtures/v1.0/links.txt");

fn links() -> impl Iterator<Item = &'static str> {
    LINKS.lines().map(|line| line.split_once(' ').unwrap().1)
}

fn root() -> &'static Path {
    Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
}

fn length(work: &Work) -> usize {
    write_link(work).unwrap().fragment.len()
}

fn page() -> Drawing {
    Drawing::new(Rect::new(0.0, 0.0, 72.0, 72.0))
}

#[test]
fn sixty_scribbles_on_a_sample_take_at_most_4500_characters() {
    for seed in 1..6 {
        let scribbles = session(seed, 60);
        let points: usize = scribbles.iter().map(|scribble| scribble.points.len()).sum();
        assert!(points > 3000, "{points} points");
        let mut work = Work::new(Document { scribbles, ..Document::new(page()) });
        work.sample = Some("1F98B.svg".into());
        let length = length(&work);
        assert!(length <= 4500, "{length} characters for {points} points");
    }
}

/// Our samples, again and again in the cells of a grid.
#[test]
fn a_drawing_of_1900_segments_takes_at_most_10700_characters() {
    let samples = ["goldfish", "teapot-with-flowers"].map(|name| {
        let svg = fs::read(root().join(format!("web/samples/{name}.svg"))).unwrap();
        import_svg(&svg).unwrap().drawing.curves
    });
    let mut drawing = page();
    for cell in 0..12 {
        let at = Affine::translate((f64::from(cell % 4) * 256.0, f64::from(cell / 4) * 256.0));
        for Curve { path, line } in &samples[cell as usize % 2] {
            drawing.curves.push(Curve { path: at * Affine::scale(0.25) * path, line: line.clone() });
        }
    }
    let segments: usize = drawing.curves.iter().map(|curve| curve.path.segments().count()).sum();
    let length = length(&Work::new(Document::new(drawing)));
    assert!(segments >= 1900 && length <= 10_700, "{length} characters for {segments} segments");
}

#[test]
fn the_median_drawing_of_the_quality_set_takes_at_most_1200_characters() {
    let set = root().join("../shared/quality/dev");
    let Ok(entries) = fs::read_dir(&set) else {
        println!("skipped: {} is not there", set.display());
        return;
    };
    let folders = entries.map(|entry| entry.unwrap().path()).filter(|path| path.is_dir());
    let mut lengths: Vec<_> = folders
        .map(|folder| {
            let drawing = import_svg(&fs::read(folder.join("drawing.svg")).unwrap()).unwrap().drawing;
            let scribbles =
                read_scribbles(&fs::read(folder.join("dense.json")).unwrap(), &drawing).unwrap().scribbles;
            length(&Work::new(Document { scribbles, ..Document::new(drawing) }))
        })
        .collect();
    lengths.sort();
    assert!(lengths[lengths.len() / 2] <= 1200, "{lengths:?}");
}

#[test]
fn a_link_is_found_behind_any_address() {
    let link = links().next().unwrap();
    let expected = write_file(&read_link(link).unwrap());
    for before in ["https://example.org/scumble/", "  file:///a.html?b=c.d"] {
        for after in ["\n", ".", ").", "=", "\" "] {
            assert_eq!(write_file(&read_link(&format!("{before}{link}{after}")).unwrap()), expected);
        }
    }
}

#[test]
fn every_changed_character_is_an_error() {
    for link in links() {
        for at in 0..link.len() {
            for other in ["A", "Z", "a", "0", "9", "-", "_", "#", ".", "=", " ", "%", "é"] {
                let changed = [&link[..at], other, &link[at + 1..]].concat();
                // White space around a link is none of it.
                if changed != link && changed.trim() != link {
                    read_link(&changed).expect_err(&changed);
                }
            }
        }
    }
}

#[test]
fn every_cut_is_an_error() {
    for link in links() {
        for at in 0..link.len() {
            read_link(&link[..at]).expect_err("cut at its end");
            read_link(&link[at + 1..]).expect_err("cut at its start");
            read_link(&[&link[..at], &link[at + 1..]].concat()).expect_err("cut in the middle");
        }
    }
}

#[test]
fn what_is_no_link_says_what_to_do() {
    let link = links().next().unwrap();
    let error = |text: &str| read_link(text).unwrap_err();
    for text in ["", "#", "#1", "1.AAAA", "https://example.org/", "#one.AAAA", "#.AAAA", "#-1.AAAA"] {
        assert_eq!(error(text), LinkError::NoLink, "{text}");
    }
    for text in ["#1.", "#1.AAAA", "#01.AAAA", "#0.AAAA", "#1.AAAAAAAAAAAAAAA"] {
        assert_eq!(error(text), LinkError::Damaged, "{text}");
    }
    for version in ["2", "10", "99999999999999"] {
        assert_eq!(error(&link.replacen("#1", &format!("#{version}"), 1)), LinkError::Newer);
    }
    assert_eq!(error(&format!("#1.{}", "A".repeat(MAX_LINK))), LinkError::TooLong);
    for error in
        [LinkError::NoLink, LinkError::Damaged, LinkError::Newer, LinkError::TooLong, LinkError::TooLarge]
    {
        assert!(error.to_string().contains(';') || error.to_string().contains(": "), "{error}");
    }
}

#[test]
fn work_that_could_not_be_read_again_gets_no_link() {
    let refused = |document| assert_eq!(write_link(&Work::new(document)).unwrap_err(), LinkError::TooLarge);
    let line = BezPath::from_vec(vec![
        kurbo::PathEl::MoveTo(Point::new(1.0, 2.0)),
        kurbo::PathEl::LineTo(Point::new(3.0, 4.0)),
    ]);
    // Nothing tells these apart, so that they take hardly any characters; but memory.
    let curves = vec![Curve { path: line, line: None }; 20_000];
    refused(Document::new(Drawing { curves, ..page() }));
    let still = |count| Scribble {
        color: Paint::Clear,
        kind: Default::default(),
        width_du: 1.0,
        points: vec![Point::ZERO; count],
    };
    refused(Document { scribbles: vec![still(300_000)], ..Document::new(page()) });
    assert!(
        write_link(&Work::new(Document { scribbles: vec![still(100_000)], ..Document::new(page()) })).is_ok()
    );
    let ends = [Point::ZERO, Point::new(1024.0, 1024.0)];
    let points: Vec<_> = iter::repeat_n(ends, 5000).flatten().collect();
    let endless = Scribble { color: Paint::Clear, kind: Default::default(), width_du: 1.0, points };
    refused(Document { scribbles: vec![endless], ..Document::new(page()) });
    let scattered = session(1, 2000);
    refused(Document { scribbles: scattered, ..Document::new(page()) });
}

/// What a link keeps of the fields of an item that are not known.
fn linked(item: Item, fields: &str) -> Result<Work, LinkError> {
    let still =
        Scribble { color: Paint::Clear, kind: Default::default(), width_du: 1.0, points: vec![Point::ZERO] };
    let mut work = Work::new(Document { scribbles: vec![still], ..Document::new(page()) });
    work.unknown.keep(item, 0, fields);
    read_link(&write_link(&work).unwrap().fragment)
}

/// The files of all versions, which have all fields.
fn files() -> Vec<Vec<u8>> {
    let versions = ["v1.0", "v1.1", "v1.2", "v1.3"];
    let folders = versions.map(|version| root().join("crates/scumble-io/tests/fixtures").join(version));
    let entries = folders.iter().flat_map(|folder| fs::read_dir(folder).unwrap());
    let paths = entries.map(|entry| entry.unwrap().path());
    let files = paths.filter(|path| path.extension().is_some_and(|ending| ending == "scumble"));
    files.map(|path| fs::read(path).unwrap()).collect()
}

/// The names of the fields of all items of a kind in a file.
fn names(file: &Value, item: Item) -> BTreeSet<&String> {
    let list = |name: &str| file[name].as_array().into_iter().flatten().collect();
    let items: Vec<_> = match item {
        Item::Work => vec![file],
        Item::Settings => vec![&file["settings"]],
        Item::Curve => list("curves"),
        Item::Fill => list("fills"),
        Item::Scribble => list("scribbles"),
        Item::ColorPoint => list("color_points"),
    };
    items.into_iter().filter_map(Value::as_object).flat_map(|fields| fields.keys()).collect()
}

#[test]
fn a_link_keeps_those_unknown_fields_that_a_file_keeps() {
    for file in files() {
        let unknown = read_file(&file).unwrap().unknown;
        let file = serde_json::from_slice(&file).unwrap();
        let named = |item| names(&file, item).into_iter().map(move |name| (item, format!("\"{name}\"")));
        for (item, name) in Item::ALL.into_iter().flat_map(named) {
            let is_unknown = unknown.fields[item as usize].iter().any(|(_, text)| text.contains(&name));
            let is_kept =
                linked(item, &[&name, ": 0"].concat()).is_ok_and(|work| work.unknown != Unknown::default());
            assert_eq!(is_kept, is_unknown, "{item:?} {name}");
        }
    }
}

#[test]
fn what_came_in_a_link_can_be_saved_whatever_its_unknown_fields_are_called() {
    let plain = linked(Item::Work, r#""mood": 7"#).unwrap();
    for fields in [
        r#""format": "x", "mood": 7"#,
        r#""mood": 7, "version": "9.0""#,
        r#""canvas": 0, "mood": 7, "settings": 0, "curves": 0, "fills": 0"#,
        r#""tracing_image": "x", "mood": 7"#,
        r#""\u0073cribbles": [{"color": "none", "width": 1, "points": [[1, 1]]}], "mood": 7"#,
    ] {
        let linked = linked(Item::Work, fields).unwrap();
        assert_eq!(write_file(&linked), write_file(&plain), "{fields}");
        read_file(&write_file(&linked).unwrap()).unwrap();
    }
    for bad in [r#""mood": 7}, {"#, r#""radii": [1, 1]"#, r#""radii": 1"#, r#""mood""#] {
        assert_eq!(linked(Item::Scribble, bad).unwrap_err(), LinkError::Damaged, "{bad}");
    }
}

#[test]
fn unknown_fields_of_a_link_are_no_deeper_than_in_a_file() {
    for (item, most) in [(Item::Work, 99), (Item::Settings, 98), (Item::Scribble, 97)] {
        let deep = |depth| linked(item, &format!(r#""mood": {}{}"#, "[".repeat(depth), "]".repeat(depth)));
        read_file(&write_file(&deep(most).unwrap()).unwrap()).unwrap();
        assert_eq!(deep(most + 1).unwrap_err(), LinkError::Damaged, "{item:?}");
    }
}

#[test]
fn a_sample_is_named_in_place_of_its_lines() {
    let svg = fs::read(root().join("web/samples/goldfish.svg")).unwrap();
    let mut work = Work::new(Document::new(import_svg(&svg).unwrap().drawing));
    let whole = length(&work);
    work.sample = Some("goldfish.svg".into());
    assert!(length(&work) < whole / 10);
    let read = read_link(&write_link(&work).unwrap().fragment).unwrap();
    assert_eq!(read.sample.as_deref(), Some("goldfish.svg"));
    assert!(read.document.drawing.curves.is_empty());
    assert_eq!(read.document.drawing.page, work.document.drawing.page);
    for hostile in ["", "../x.svg", "a/b.svg", ".svg", "a b", "é.svg"] {
        work.sample = Some(hostile.into());
        assert!(write_link(&work).is_err(), "{hostile}");
    }
}

#[test]
fn numbers_that_are_none_do_no_harm() {
    let odd = [f64::NAN, f64::INFINITY, -1e300, 1e300, -0.0];
    for x in odd {
        let mut drawing = page();
        let mut path = BezPath::new();
        path.move_to((x, 1.0));
        path.curve_to((1.0, x), (x, x), (x, 3.0));
        drawing.curves.push(Curve { path, line: None });
        let scribbles = vec![Scribble {
            color: Paint::Clear,
            kind: Default::default(),
            width_du: x,
            points: vec![Point::new(x, 1.0)],
        }];
        let work = Work::new(Document { scribbles, ..Document::new(drawing) });
        if let Ok(link) = write_link(&work) {
            let read = read_link(&link.fragment).unwrap();
            assert_eq!(write_link(&read).unwrap().fragment, link.fragment);
        }
        if let Ok(file) = write_file(&work) {
            read_file(&file).unwrap();
        }
    }
}
