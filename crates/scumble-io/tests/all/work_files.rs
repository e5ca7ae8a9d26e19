//! `.scumble` files: what they say, what they keep, and what becomes of those that are none.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use kurbo::{Point, Rect};
use scumble_core::work::{Item, MAX_SHADES};
use scumble_core::{Blend, Document, EngineKind, Paint, PenPressure, Settings, Srgb8, Swatch, Work, exact};
use scumble_io::{
    FileError, LinkError, PageSize, import_drawing, read_file, read_link, write_file, write_link,
    write_svg_source,
};

/// A file with some members beside what it must have.
fn file(members: &str) -> String {
    format!(r#"{{"format": "scumble", "version": "1.0", "canvas": [10, 20, 64, 32]{members}}}"#)
}

fn read(members: &str) -> Result<Work, FileError> {
    read_file(file(members).as_bytes())
}

fn text(work: &Work) -> String {
    String::from_utf8(write_file(work).unwrap()).unwrap()
}

#[test]
fn the_least_file_is_an_empty_page() {
    let work = read("").unwrap();
    assert_eq!(work.document.drawing.page, Rect::new(10.0, 20.0, 74.0, 52.0));
    assert_eq!(work.document.settings, Settings::default());
    assert!(work.document.drawing.curves.is_empty() && work.document.scribbles.is_empty());
}

#[test]
fn what_is_not_said_is_as_in_svg() {
    let work = read(r#", "curves": [{"path": "M 1 2 L 3 4", "width": 2}, {"path": "M1 2"}]"#);
    assert!(matches!(work, Err(FileError::Damaged { .. })), "a path without segments");
    let work =
        read(r#", "curves": [{"path": "M 1 2 L 3 4", "width": 2}, {"path": "M 1 2 L 3 4 Z"}]"#).unwrap();
    let [first, second] = &*work.document.drawing.curves else { panic!() };
    let line = first.line.as_ref().unwrap();
    let stroke = (line.stroke.width, line.stroke.miter_limit, line.stroke.start_cap, line.stroke.join);
    assert_eq!(stroke, (2.0, 4.0, kurbo::Cap::Butt, kurbo::Join::Miter));
    assert_eq!((line.color.0, second.line.is_none()), ([0, 0, 0, 255], true));
}

#[test]
fn settings_and_scribbles_are_read() {
    let work = read(
        r##", "settings": {"blend": "srgb", "engine": "progressive", "gap_closing": 7, "spread": true},
        "palette": ["#ff0000", "none"], "color_points": [{"curve": 3, "side": "left", "at": 1.5, "color": "#010203"}],
        "scribbles": [{"color": "none", "width": 2, "points": [[1, 2.5], [-3e2, 4]]}]"##,
    )
    .unwrap();
    let expected =
        Settings { blend: Blend::Srgb, engine: EngineKind::Progressive, gap_closing: 1.0, spread: true };
    assert_eq!(work.document.settings, expected);
    assert_eq!(work.document.palette, [Paint::from(Srgb8([255, 0, 0])), Paint::Clear].map(Swatch::from));
    assert_eq!(work.document.scribbles[0].points, [Point::new(1.0, 2.5), Point::new(-300.0, 4.0)]);
    assert_eq!((work.document.color_points[0].curve, work.document.color_points[0].is_left), (3, true));
}

#[test]
fn radii_or_strengths_of_a_pen_are_read_and_said_to_be_of_version_1_2() {
    let shade = |more: &str| {
        read(&format!(
            r##", "scribbles": [{{"color": "#ff0000", "width": 2, "kind": "shade", "points": [[1,2],[3,4]]{more}}}]"##
        ))
    };
    let pressure = |work: &Work| work.document.scribbles[0].shading().unwrap().pressure.clone();
    let (radii, strengths) = (r#", "radii": [0.25,1]"#, r#", "strengths": [0,0.5]"#);
    assert_eq!(pressure(&shade(radii).unwrap()), PenPressure::Radius(vec![0.25, 1.0]));
    assert_eq!(pressure(&shade(strengths).unwrap()), PenPressure::Strength(vec![0.0, 0.5]));
    for more in [radii, strengths] {
        let text = text(&shade(more).unwrap());
        assert!(text.contains(r#""version": "1.2""#) && text.contains(&more[2..]), "{text}");
    }
    assert!(text(&shade("").unwrap()).contains(r#""version": "1.0""#));
    for bad in [r#", "radii": [1]"#, r#", "radii": [1,2]"#, r#", "strengths": [0,-0.5]"#, r#", "radii": 7"#] {
        assert!(matches!(shade(bad), Err(FileError::Damaged { .. })), "{bad}");
    }
}

#[test]
fn a_link_keeps_what_a_pen_made_beside_what_nobody_knows() {
    let file = r##"{"format": "scumble", "version": "1.2", "canvas": [0, 0, 64, 64], "scribbles": [
        {"color": "#ff0000", "width": 2, "points": [[1,2]], "mood": 7},
        {"color": "#ff0000", "width": 2, "kind": "shade", "points": [[1,2]], "radii": [0.25], "mood": 8}]}"##;
    let work = read_file(file.as_bytes()).unwrap();
    let linked = read_link(&write_link(&work).unwrap().fragment).unwrap();
    assert_eq!(text(&linked), text(&work));
    assert_eq!(linked.unknown, work.unknown);
    let [plain, pressed] = &*linked.document.scribbles else { panic!() };
    assert!(plain.is_fill());
    assert_eq!(pressed.shading().unwrap().pressure, PenPressure::Radius(vec![0.25]));
}

/// A page of an older version may have kept the one from before as a field that it does not know.
#[test]
fn what_a_pen_made_is_as_it_was_made_last() {
    let mut work =
        read(r#", "scribbles": [{"color": "none", "width": 2, "kind": "shade", "points": [[1,2]], "strengths": [0.5]}]"#)
            .unwrap();
    work.unknown.keep(Item::Scribble, 0, r#""radii": [0.25]"#);
    let linked = read_link(&write_link(&work).unwrap().fragment).unwrap();
    for read in [linked, read_file(&write_file(&work).unwrap()).unwrap()] {
        assert_eq!(read.document.scribbles, work.document.scribbles);
        assert!(!text(&read).contains("radii"));
    }
}

/// A palette with names that are more or fewer than its colours, before or behind it.
#[test]
fn swatches_have_names() {
    let names = |members: &str| -> Vec<String> {
        read(members).unwrap().document.palette.into_iter().map(|swatch| swatch.name).collect()
    };
    let [palette, two, one] = [
        r##", "palette": ["#ff0000", "#00ff00"]"##,
        r#", "swatch_names": ["Skin \u263a", "Hair", "Eyes"]"#,
        r#", "swatch_names": ["Skin"]"#,
    ];
    assert_eq!(names(&[palette, two].concat()), ["Skin ☺", "Hair"]);
    assert_eq!(names(&[one, palette].concat()), ["Skin", ""]);
    assert_eq!(names(palette), ["", ""]);
    assert!(read(&[palette, r#", "swatch_names": [1]"#].concat()).is_err());
    assert!(read(&[palette, r#", "swatch_names": "Skin""#].concat()).is_err());
}

#[test]
fn names_of_swatches_make_a_newer_version_and_go_along_with_unknown_fields() {
    let mut work = read(r##", "palette": ["#ff0000", "#00ff00"], "title": "Fish""##).unwrap();
    assert!(text(&work).contains(r#""version": "1.0""#));
    work.document.palette[1].name = "Hair \"dark\"".into();
    let text = text(&work);
    assert!(text.contains(r#""version": "1.2""#), "{text}");
    let linked = read_link(&write_link(&work).unwrap().fragment).unwrap();
    for read in [linked, read_file(text.as_bytes()).unwrap()] {
        assert_eq!(self::text(&read), text);
        assert_eq!(read.document.palette, work.document.palette);
    }
}

#[test]
fn the_size_of_a_page_goes_along_with_the_work() {
    let svg = r#"<svg width="148mm" height="21cm" viewBox="0 0 148 210"><path d="M1 1H9V9Z"/></svg>"#;
    let (work, _) = import_drawing(svg.as_bytes()).unwrap();
    let size = PageSize::of(&work).unwrap();
    assert_eq!((&size.sides, size.longer_px()), (&["148mm".to_owned(), "21cm".to_owned()], 794));
    let text = text(&work);
    assert!(text.contains(r#""version": "1.3""#) && text.contains(r#""size": ["148mm", "21cm"]"#), "{text}");
    let linked = read_link(&write_link(&work).unwrap().fragment).unwrap();
    for again in [linked, read_file(text.as_bytes()).unwrap(), exact::read(&exact::write(&work)).unwrap()] {
        assert_eq!(PageSize::of(&again).as_ref(), Some(&size));
        assert!(self::text(&again).contains(r#""version": "1.3""#));
    }
    for bare in
        [svg.replace("148mm", "100%"), svg.replace("148mm", "148cm"), svg.replace(r#"height="21cm""#, "")]
    {
        let (work, _) = import_drawing(bare.as_bytes()).unwrap();
        assert_eq!((PageSize::of(&work), self::text(&work).matches("\"size\"").count()), (None, 0));
    }
}

/// What a later version of the same first number might write.
const NEWER: &str = r##"{"format": "scumble", "version": "1.4", "canvas": [0, 0, 9, 9], "title": "A \"fish\" ☺ \ud83d\ude00",
    "settings": {"spread": true, "paper": {"color": "#fff", "grain": [1, 2.50, -1e-400, null, true]}},
    "curves": [{"path": "M 1 2 L 3 4", "layer": 2}],
    "fills": [{"path": "M 1 2 L 3 4 L 5 6 Z", "pattern": "dots"}],
    "scribbles": [{"color": "#ff0000", "width": 1, "points": [[1, 2]]},
        {"color": "#00ff00", "width": 1, "points": [[3, 4]], "mood": "glow", "id": "b"},
        {"color": "#0000ff", "width": 1, "points": [[5, 6]], "id": "c"}],
    "color_points": [{"curve": 0, "side": "right", "at": 1, "color": "none", "pinned": false}],
    "layers": []}"##;

const UNKNOWN: [&str; 9] = [
    r#""title": "A \"fish\" ☺ \ud83d\ude00""#,
    r##""paper": {"color": "#fff", "grain": [1, 2.50, -1e-400, null, true]}"##,
    r#""layer": 2"#,
    r#""pattern": "dots""#,
    r#""mood": "glow","id": "b""#,
    r#""id": "c""#,
    r#""pinned": false"#,
    r#""layers": []"#,
    r#""version": "1.4""#,
];

#[test]
fn fields_of_a_newer_minor_version_are_kept() {
    let work = read_file(NEWER.as_bytes()).unwrap();
    for text in [text(&work), text(&read_link(&write_link(&work).unwrap().fragment).unwrap())] {
        for field in UNKNOWN {
            assert_eq!(text.matches(field).count(), 1, "{field} in {text}");
        }
        assert_eq!(text, self::text(&read_file(text.as_bytes()).unwrap()));
    }
}

#[test]
fn unknown_fields_of_a_scribble_go_where_it_goes() {
    let work = read_file(NEWER.as_bytes()).unwrap();
    let [_, second, third] = <[_; 3]>::try_from(work.document.scribbles.clone()).unwrap();
    let recolored = scumble_core::Scribble { color: Paint::Clear, ..second };
    let edited = work.edited(Document { scribbles: vec![third, recolored], ..work.document.clone() });
    let text = text(&edited);
    let of_third = r##"{"color": "#0000ff", "width": 1, "points": [[5,6]], "id": "c"}"##;
    let of_second = r#"{"color": "none", "width": 1, "points": [[3,4]], "mood": "glow","id": "b"}"#;
    assert!(text.contains(of_third) && text.contains(of_second), "{text}");
}

#[test]
fn a_newer_major_version_is_refused_whatever_it_says() {
    for version in ["2.0", "3", "17.5"] {
        let file =
            format!(r#"{{"canvas": {{"a": 1}}, "curves": 7, "version": "{version}", "format": "scumble"}}"#);
        let error = read_file(file.as_bytes()).unwrap_err();
        assert_eq!(error, FileError::Newer(version.into()));
        assert!(error.to_string().contains("update Scumble"), "{error}");
    }
}

#[test]
fn what_is_no_such_file_is_refused() {
    assert_eq!(read_file(b" \n").unwrap_err(), FileError::Empty);
    assert_eq!(read_file(&[0xff, 0xfe, 0]).unwrap_err(), FileError::NotText);
    assert_eq!(read_file(&vec![b' '; 20_000_000]).unwrap_err(), FileError::Empty);
    assert_eq!(read_file(&vec![b'x'; 20_000_001]).unwrap_err(), FileError::TooLarge);
    for text in
        ["<svg/>", "{}", "[]", "7", r#"{"scribbles": []}"#, r#"{"format": "scumble", "version": "0.9"}"#]
    {
        assert_eq!(read_file(text.as_bytes()).unwrap_err(), FileError::NotWork, "{text}");
    }
}

#[test]
fn damage_is_told_with_its_line() {
    for (members, expected) in [
        (",\n\n\"curves\": [{\"path\": \"M 1 2 l 3 4\"}]", "a path of M, L, Q, C and Z"),
        (",\n\n\"curves\": [{\"path\": \"M 1 2 L 3 NaN\"}]", "a path of M, L, Q, C and Z"),
        (",\n\n\"curves\": [{\"path\": \"M 1 2 L 3 2e9\"}]", "a path of M, L, Q, C and Z"),
        (",\n\n\"curves\": [{\"path\": \"M 1 2 L 3 4 M 5 6 L 7 8\"}]", "one path"),
        (",\n\n\"curves\": [{\"width\": 1}]", "a path in the curve"),
        (",\n\n\"scribbles\": [{\"color\": \"#ff0000\", \"width\": 0, \"points\": [[1, 2]]}]", "above zero"),
        (",\n\n\"scribbles\": [{\"color\": \"red\", \"width\": 1, \"points\": [[1, 2]]}]", "a colour"),
        (
            ",\n\n\"scribbles\": [{\"color\": \"#ff0000\", \"width\": 1, \"points\": [[1, 2, 3]]}]",
            "fewer numbers",
        ),
        (",\n\n\"scribbles\": [{\"color\": \"#ff0000\", \"width\": 1, \"points\": [[1]]}]", "more numbers"),
        (",\n\n\"scribbles\": [{\"color\": \"#ff0000\", \"width\": 1, \"points\": []}]", "points"),
        (",\n\n\"scribbles\": [{\"color\": \"#ff0000\", \"width\": 1, \"points\": [[1, 1e10]]}]", "between"),
        (",\n\n\"color_points\": [{\"curve\": -1, \"side\": \"left\", \"at\": 1}]", "counted from 0"),
        (",\n\n\"color_points\": [{\"curve\": 0.5, \"side\": \"left\", \"at\": 1}]", "counted from 0"),
        (",\n\n\"settings\": {\"engine\": \"quantum\"}", "that this version knows"),
        (",\n\n\"settings\": {\"spread\": 1}", "true or false"),
        (",\n\n\"sample\": \"../../secret\"", "plain file name"),
        (",\n\n\"extra\": {\"a\": 01}", "a number"),
        (",\n\n\"extra\": [1 2]", "a comma"),
        (",\n\n\"extra\": \"\\q\"", "a known escape"),
        (",\n\n\"extra\": \"\\ud800\"", "hexadecimal"),
    ] {
        let error = read(members).expect_err(members);
        let text = error.to_string();
        assert!(text.contains("line 3 ") && text.contains(expected), "{members}: {text}");
    }
    assert!(matches!(
        read_file(file("").replace("[10, 20, 64, 32]", "[0, 0, 0, 1]").as_bytes()),
        Err(FileError::Damaged { .. })
    ));
    assert!(matches!(
        read_file(br#"{"format": "scumble", "version": "1.0"}"#),
        Err(FileError::Damaged { .. })
    ));
}

#[test]
fn every_cut_of_a_file_is_an_error() {
    let whole = text(&read_file(NEWER.as_bytes()).unwrap());
    let whole = whole.trim_end();
    for at in (0..whole.len()).filter(|at| whole.is_char_boundary(*at)) {
        read_file(&whole.as_bytes()[..at]).expect_err("cut");
    }
}

#[test]
fn limits_hold() {
    assert!(read(&format!(", \"deep\": {}{}", "[".repeat(90), "]".repeat(90))).is_ok());
    let error = read(&format!(", \"deep\": {}", "[".repeat(1_000_000))).unwrap_err();
    assert!(error.to_string().contains("less nesting"), "{error}");
    let curves = |count| {
        format!(
            ", \"curves\": [{}{{\"path\": \"M 1 2 L 3 4\"}}]",
            r#"{"path": "M 1 2 L 3 4"},"#.repeat(count)
        )
    };
    assert_eq!(read(&curves(199_999)).unwrap().document.drawing.curves.len(), 200_000);
    assert_eq!(read(&curves(200_000)).unwrap_err(), FileError::TooManyCurves);
    let zigzag = "[0, 0], [1024, 1024],".repeat(2000);
    let scribbles =
        format!(", \"scribbles\": [{{\"color\": \"none\", \"width\": 1, \"points\": [{zigzag} [0, 0]]}}]");
    assert!(matches!(read(&scribbles), Err(FileError::TooLong { .. })));
}

/// As many shades as there may be, and one scribble more.
fn many_shades(last: &str) -> String {
    let shade = |kind: &str| {
        format!(r##"{{"color": "#ff0000", "width": 500, "kind": "{kind}", "points": [[0, 0]]}}"##)
    };
    let shades = [shade("shade"), ",".into()].concat().repeat(MAX_SHADES);
    format!(r#", "curves": [{{"path": "M 1 2 L 3 4"}}], "scribbles": [{shades}{}]"#, shade(last))
}

#[test]
fn every_reader_and_writer_refuses_more_shades_than_there_may_be() {
    let most = read(&many_shades("fill")).unwrap();
    assert_eq!(most.document.scribbles.len(), MAX_SHADES + 1);
    let link = write_link(&most).unwrap().fragment;
    assert_eq!(read_link(&link).unwrap().document.scribbles.len(), MAX_SHADES + 1);
    let error = read(&many_shades("shade")).unwrap_err();
    assert_eq!(error.to_string(), "more than 1000 of the scribbles shade; use fewer of them");
    let mut more = most.clone();
    more.document.scribbles[MAX_SHADES] = more.document.scribbles[0].clone();
    assert_eq!(write_file(&more).unwrap_err(), error);
    assert_eq!(write_svg_source(&more).unwrap_err(), error);
    assert_eq!(write_link(&more).unwrap_err(), LinkError::TooManyShades);
}

#[test]
fn a_picture_with_too_many_shades_opens_as_its_lines_and_says_so() {
    let svg = |source: &str| {
        format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9">{source}<path d="M1 1h7" stroke="black"/></svg>"#
        )
    };
    let source = write_svg_source(&read(&many_shades("fill")).unwrap()).unwrap();
    assert_eq!(import_drawing(svg(&source).as_bytes()).unwrap().1, "");
    let (work, notes) =
        import_drawing(svg(&source.replace("\"points\"", "\"kind\": \"shade\", \"points\"")).as_bytes())
            .unwrap();
    assert!(work.document.scribbles.is_empty());
    assert!(notes.ends_with("more than 1000 of the scribbles shade; use fewer of them"), "{notes}");
}
