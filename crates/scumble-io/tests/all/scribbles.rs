//! What a file of scribbles becomes.

use kurbo::{Point, Rect};
use scumble_core::{Drawing, Paint, PenPressure, Scribble, ScribbleKind, Shading, Srgb8};
use scumble_io::{ReadScribbles, ScribbleNotes, ScribblesError, read_scribbles};

/// A page on which one page unit is 16 du.
fn drawing() -> Drawing {
    Drawing::new(Rect::new(10.0, 20.0, 74.0, 52.0))
}

fn read(json: &str) -> Result<ReadScribbles, ScribblesError> {
    read_scribbles(json.as_bytes(), &drawing())
}

/// A file of scribbles that share colour and width.
fn with_points(points: &[&str]) -> String {
    let scribble = |p: &&str| format!(r##"{{"color":"#ff0000","width":1.5,"points":{p}}}"##);
    format!(r#"{{"scribbles":[{}]}}"#, points.iter().map(scribble).collect::<Vec<_>>().join(","))
}

#[test]
fn scribbles_are_read_in_order_and_in_du() {
    let json = r##"{"scribbles":[{"color":"#E6194b","width":1.5,"points":[[10,20],[12.5,21]]},
        {"color":"#000000","width":1,"points":[[74,52]]}]}"##;
    let first = Scribble {
        color: Srgb8([0xe6, 0x19, 0x4b]).into(),
        kind: ScribbleKind::Fill,
        width_du: 24.0,
        points: vec![Point::new(0.0, 0.0), Point::new(40.0, 16.0)],
    };
    let dab = Scribble {
        color: Srgb8([0; 3]).into(),
        kind: ScribbleKind::Fill,
        width_du: 16.0,
        points: vec![Point::new(1024.0, 512.0)],
    };
    let expected = ReadScribbles { scribbles: vec![first, dab], notes: ScribbleNotes::default() };
    assert_eq!(read(json), Ok(expected));
}

#[test]
fn a_scribble_without_colour_keeps_its_place_free() {
    let read = read(r#"{"scribbles":[{"color":"none","width":1,"points":[[20,30]]}]}"#).unwrap();
    assert_eq!(read.scribbles[0].color, Paint::Clear);
    assert!(read.notes.is_empty());
}

#[test]
fn a_scribble_fills_or_shades() {
    let kinds = |fields: &str| {
        let json =
            format!(r##"{{"scribbles":[{{"color":"#ff0000","width":1,"points":[[20,30]]{fields}}}]}}"##);
        read(&json).map(|read| read.scribbles[0].kind.clone())
    };
    let shade =
        |strength, crosses| Ok(ScribbleKind::Shade(Shading { strength, crosses, ..Shading::default() }));
    assert_eq!(kinds(""), Ok(ScribbleKind::Fill));
    assert_eq!(kinds(r#","kind":"fill","strength":7"#), Ok(ScribbleKind::Fill));
    assert_eq!(kinds(r#","kind":"shade","strength":0.8"#), shade(0.8, false));
    assert_eq!(kinds(r#","kind":"shade","strength":0,"crosses":true"#), shade(0.0, true));
    assert_eq!(kinds(r#","kind":"shade""#), shade(Shading::default().strength, false));
    let notes = |bad_kinds, bad_strengths| {
        Err(ScribblesError::NoneUsable(ScribbleNotes {
            bad_kinds,
            bad_strengths,
            ..ScribbleNotes::default()
        }))
    };
    assert_eq!(kinds(r#","kind":"glow""#), notes(1, 0));
    assert_eq!(kinds(r#","kind":"shade","strength":1.5"#), notes(0, 1));
    assert_eq!(kinds(r#","kind":"shade","strength":-0.1"#), notes(0, 1));
}

#[test]
fn the_third_number_of_a_point_is_how_hard_a_pen_pressed() {
    let pressure = |fields: &str, points: &str| {
        let json = format!(
            r##"{{"scribbles":[{{"color":"#ff0000","width":1,"kind":"shade"{fields},"points":{points}}}]}}"##
        );
        let scribble = read(&json).expect("a scribble").scribbles.remove(0);
        assert_eq!(scribble.points.len(), 3, "with or without it");
        scribble.shading().expect("a shade").pressure.clone()
    };
    let pressed = "[[20,30,0.25],[21,30],[22,30,7]]";
    let parts = vec![0.25, 1.0, 1.0];
    assert_eq!(pressure("", pressed), PenPressure::Radius(parts.clone()));
    assert_eq!(pressure(r#","pressure":"radius""#, pressed), PenPressure::Radius(parts.clone()));
    assert_eq!(pressure(r#","pressure":"strength""#, pressed), PenPressure::Strength(parts));
    assert_eq!(pressure("", "[[20,30,1],[21,30],[22,30]]"), PenPressure::Even);
    assert_eq!(pressure(r#","pressure":"strength""#, "[[20,30],[21,30],[22,30]]"), PenPressure::Even);
}

#[test]
fn no_scribbles_are_no_error() {
    assert_eq!(read(r#"{"scribbles":[]}"#), Ok(ReadScribbles::default()));
}

#[test]
fn what_is_no_scribbles_file_is_refused() {
    assert_eq!(read(" "), Err(ScribblesError::Empty));
    for bad in [
        "{}",
        "[]",
        "junk",
        "\u{0}",
        r#"{"scribbles":{}}"#,
        r##"{"scribbles":[{"color":"#ff0000","points":[[1,2]]}]}"##,
        r##"{"scribbles":[{"color":"#ff0000","width":1,"points":[[1]]}]}"##,
        r##"{"scribbles":[{"color":"#ff0000","width":1,"points":[[1,2,0.5,4]]}]}"##,
        r##"{"scribbles":[{"color":"#ff0000","width":1,"pressure":"hue","points":[[1,2]]}]}"##,
        r##"{"scribbles":[{"color":"#ff0000","width":1e999,"points":[[1,2]]}]}"##,
        r##"{"scribbles":[{"color":"#ff0000","width":1,"points":[[NaN,2]]}]}"##,
    ] {
        let error = read(bad).expect_err(bad).to_string();
        assert!(error.contains("cannot be read"), "{bad}: {error}");
    }
    assert!(matches!(read(&"[".repeat(100_000)), Err(ScribblesError::NotScribbles(_))));
    assert_eq!(read(&" x".repeat(15_000_000)), Err(ScribblesError::TooLarge));
}

#[test]
fn unknown_fields_are_counted_and_ignored() {
    let json = r##"{"version":2,"scribbles":[{"color":"#ff0000","width":1,"points":[[20,30]],"pen":[1],"id":"a"}]}"##;
    let read = read(json).unwrap();
    assert_eq!(read.scribbles.len(), 1);
    assert_eq!(read.notes, ScribbleNotes { unknown_fields: 3, ..ScribbleNotes::default() });
}

#[test]
fn faulty_scribbles_are_left_out_and_counted() {
    let json = r##"{"scribbles":[
        {"color":"None","width":1,"points":[[20,30]]}, {"color":"#12345","width":1,"points":[[20,30]]},
        {"color":"#ff0000","width":0,"points":[[20,30]]}, {"color":"#ff0000","width":-1,"points":[[20,30]]},
        {"color":"#ff0000","width":1e308,"points":[[20,30]]},
        {"color":"#ff0000","width":1,"points":[]}, {"color":"#ff0000","width":1,"points":[[200,30],[1e308,30]]},
        {"color":"#00ff00","width":1,"points":[[20,30]]}]}"##;
    let read = read(json).unwrap();
    assert_eq!(
        read.scribbles.iter().map(|s| s.color).collect::<Vec<_>>(),
        [Paint::Color(Srgb8([0, 255, 0]))]
    );
    let notes =
        ScribbleNotes { bad_colors: 2, bad_widths: 3, no_points: 1, off_page: 1, ..ScribbleNotes::default() };
    assert_eq!(read.notes, notes);
}

#[test]
fn pressures_that_no_pen_has_are_counted() {
    let read = read(&with_points(&["[[20,30,7],[21,30,0.5],[22,30,-1],[23,30]]"])).unwrap();
    assert_eq!(read.notes, ScribbleNotes { bad_pressures: 2, ..ScribbleNotes::default() });
    assert_eq!(read.notes.to_string(), "left out: 2 pressures not from 0 to 1");
}

#[test]
fn scribbles_of_which_none_can_be_used_are_refused() {
    let error = read(r##"{"scribbles":[{"color":"red","width":1,"points":[[20,30]]}]}"##).unwrap_err();
    assert_eq!(
        error.to_string(),
        "none of the scribbles can be used: left out: 1 scribble without a colour #rrggbb"
    );
}

#[test]
fn points_far_outside_are_brought_near() {
    let read = read(&with_points(&["[[20,30],[1e300,30],[-1e300,-1e300],[75,53]]"])).unwrap();
    assert_eq!(read.notes, ScribbleNotes { far_points: 2, ..ScribbleNotes::default() });
    let expected =
        [(160.0, 160.0), (2048.0, 160.0), (-1024.0, -1024.0), (1040.0, 528.0)].map(|(x, y)| Point::new(x, y));
    assert_eq!(read.scribbles[0].points, expected);
}

#[test]
fn scribbles_without_end_are_refused() {
    let zigzag = format!("[{}[10,20]]", "[10,20],[74,52],".repeat(4000));
    assert_eq!(read(&with_points(&[&zigzag])), Err(ScribblesError::TooLong { limit_pages: 5000 }));
}

#[test]
fn shades_without_end_are_refused() {
    let list = |count: usize| {
        let shade = r##"{"color":"#ff0000","width":9,"kind":"shade","points":[[20,30]]},"##.repeat(count);
        format!(r##"{{"scribbles":[{shade}{{"color":"#ff0000","width":9,"points":[[20,30]]}}]}}"##)
    };
    assert_eq!(read(&list(1000)).unwrap().scribbles.len(), 1001);
    assert_eq!(read(&list(1001)), Err(ScribblesError::TooManyShades));
}
