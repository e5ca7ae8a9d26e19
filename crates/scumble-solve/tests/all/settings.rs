//! A picture under changing settings is the one that a fresh picture gives.

use kurbo::{BezPath, Point, Rect, Shape};
use scumble_core::{Blend, Curve, Document, Drawing, EngineKind, Scribble, ScribbleKind, Settings, Srgb8};
use scumble_solve::Picture;

/// Two rooms of 480 by 400 du with a doorway of 60 du between them, and a closed one below.
fn document() -> Document {
    let rooms = Rect::new(20.0, 20.0, 980.0, 420.0).to_path(1e-6);
    let closed = Rect::new(20.0, 500.0, 980.0, 700.0).to_path(1e-6);
    let wall = |from: f64, to: f64| {
        let mut path = BezPath::new();
        path.move_to((500.0, from));
        path.line_to((500.0, to));
        path
    };
    let paths = [rooms, closed, wall(20.0, 190.0), wall(250.0, 420.0)];
    let curves = paths.map(|path| Curve { path, line: None }).to_vec();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 768.0)) };
    let points = vec![Point::new(100.0, 100.0), Point::new(300.0, 300.0)];
    let scribbles = vec![Scribble {
        color: Srgb8([200, 30, 30]).into(),
        kind: ScribbleKind::Fill,
        width_du: 8.0,
        points,
    }];
    Document { scribbles, ..Document::new(drawing) }
}

#[test]
fn a_picture_depends_on_its_settings_and_not_on_those_before() {
    let mut document = document();
    let mut picture = Picture::new(&document.drawing).expect("a map");
    let default = Settings::default();
    let ways = [
        Settings { spread: true, gap_closing: 0.9, ..default },
        Settings { engine: EngineKind::Progressive, gap_closing: 0.1, ..default },
        Settings { gap_closing: 0.1, ..default },
        Settings { spread: true, blend: Blend::Srgb, ..default },
        default,
    ];
    for settings in ways {
        document.settings = settings;
        let field = picture.update(&document).expect("a field").clone();
        let mut fresh = Picture::new(&document.drawing).expect("a map");
        // The fresh one comes to its settings step by step.
        let steps = [Settings { gap_closing: settings.gap_closing, ..default }, settings];
        for settings in steps {
            document.settings = settings;
            fresh.update(&document).expect("a field");
        }
        assert_eq!(Ok(&field), fresh.update(&document), "{settings:?}");
    }
}
