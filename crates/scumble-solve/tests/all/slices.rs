//! Long work in slices.

use kurbo::{Circle, Line, Rect, Shape};
use scumble_core::pace::Slices;
use scumble_core::{Curve, Document, Drawing, EngineKind, Scribble, ScribbleKind, Settings, Shading, Srgb8};
use scumble_solve::{Field, Picture};

/// Circles with a line in each that leaves gaps, and scribbles, one of them across lines.
fn document(spread: bool) -> Document {
    let mut drawing = Drawing::new(Rect::new(0.0, 0.0, 1024.0, 768.0));
    for (x, y) in [(200.0, 200.0), (600.0, 200.0), (200.0, 560.0), (600.0, 560.0)] {
        let circle = Circle::new((x, y), 150.0).to_path(1e-6);
        let line = Line::new((x - 140.0, y), (x + 130.0, y + 20.0)).to_path(1e-6);
        drawing.curves.extend([circle, line].map(|path| Curve { path, line: None }));
    }
    let scribble = |from: (f64, f64), to: (f64, f64), level: u8| Scribble {
        color: Srgb8([level, 128, 255 - level]).into(),
        kind: ScribbleKind::Fill,
        width_du: 8.0,
        points: (0..=20).map(|i| Line::new(from, to).p0.lerp(to.into(), f64::from(i) / 20.0)).collect(),
    };
    let ways = [
        ((120.0, 150.0), (260.0, 150.0)),
        ((150.0, 260.0), (620.0, 260.0)),
        ((560.0, 500.0), (640.0, 640.0)),
    ];
    let scribbles = (0..).zip(ways).map(|(i, (from, to))| scribble(from, to, 80 * i)).collect();
    let settings = Settings { spread, ..Settings::default() };
    Document { scribbles, settings, ..Document::new(drawing) }
}

/// What comes of a document in slices, and between how many pauses.
fn in_slices(document: &Document) -> (Field, usize) {
    let mut pauses = 0;
    let mut slices = Slices::new(async {
        let mut picture = Picture::mapping(&document.drawing).await.expect("a map");
        picture.updating(document).await.expect("a field").clone()
    });
    loop {
        match slices.go_on() {
            Ok(field) => return (field, pauses),
            Err(left) => (slices, pauses) = (left, pauses + 1),
        }
    }
}

fn at_once(document: &Document) -> Field {
    let mut picture = Picture::new(&document.drawing).expect("a map");
    picture.update(document).expect("a field").clone()
}

#[test]
fn a_picture_that_is_made_in_slices_is_the_one_that_is_made_at_once() {
    for document in [false, true].map(document) {
        let (field, pauses) = in_slices(&document);
        assert!(pauses > 50, "{pauses}");
        assert!(field == at_once(&document));
    }
}

#[test]
fn shades_are_made_in_slices_of_their_own() {
    let plain = document(false);
    let mut shaded = plain.clone();
    for (scribble, crosses) in plain.scribbles.iter().zip([false, true, false]) {
        let kind = ScribbleKind::Shade(Shading { crosses, ..Shading::default() });
        shaded.scribbles.push(Scribble { kind, width_du: 40.0, ..scribble.clone() });
    }
    let [(_, without), (field, with)] = [&plain, &shaded].map(in_slices);
    assert!(with > without + 10, "{with} pauses with shades, {without} without");
    assert!(field == at_once(&shaded));
}

#[test]
fn each_scribble_of_the_progressive_engine_is_a_slice_at_least() {
    let all = document(false);
    let settings = Settings { engine: EngineKind::Progressive, ..all.settings };
    let first = Document { scribbles: all.scribbles[..1].to_vec(), settings, ..all.clone() };
    let all = Document { settings, ..all };
    let labelled = |document: &Document| {
        let mut picture = Picture::new(&document.drawing).expect("a map");
        let mut slices = picture.coloring(&document.scribbles, &[], &document.settings);
        let mut pauses = 0;
        while let Err(left) = slices.go_on() {
            (slices, pauses) = (left, pauses + 1);
        }
        pauses
    };
    assert!(labelled(&all) >= labelled(&first) + all.scribbles.len() - 1);
    assert!(in_slices(&all).0 == at_once(&all));
}
