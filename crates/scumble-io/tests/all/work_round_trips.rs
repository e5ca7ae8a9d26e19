//! Work comes back from a file and from a link as it was, but for what its lattices move; and then it stays. From its
//! exact bytes it comes back as it was.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use std::mem;

use kurbo::{BezPath, Cap, Join, PathEl, Point, Rect, Stroke};
use proptest::collection::vec;
use proptest::option;
use proptest::prelude::*;
use scumble_core::{
    Blend, ColorPoint, Curve, Document, Drawing, EngineKind, Fill, Line, Paint, PenPressure, Rgba8, Scribble,
    ScribbleKind, Settings, Shading, Srgb8, Swatch, Tracing, Work, exact,
};
use scumble_io::{FILE_IMAGE, read_file, read_link, write_file, write_link};

/// Pictures to trace.
const PNG: &[u8] = include_bytes!("../foreign/sketch.png");
const JPEG: &[u8] = include_bytes!("../foreign/sketch.jpg");

/// Half a step of a file, and of the points of a link, in du.
const FILE_DU: f64 = 0.0005;
const LINK_DU: f64 = 0.125;

/// Roundings of the numbers themselves.
const FLOAT: f64 = 1e-9;

fn points() -> impl Strategy<Value = Point> {
    let near = -1500.0..2500.0;
    let coordinate = prop_oneof![9 => near.boxed(), 1 => (-1e9..1e9).boxed(), 2 => (-9..1009_i32).prop_map(f64::from).boxed()];
    (coordinate.clone(), coordinate).prop_map(|(x, y)| Point::new(x, y))
}

fn subpaths() -> impl Strategy<Value = Vec<PathEl>> {
    let segment = prop_oneof![
        points().prop_map(PathEl::LineTo),
        (points(), points(), points()).prop_map(|(a, b, p)| PathEl::CurveTo(a, b, p)),
    ];
    (points(), vec(segment, 1..6), any::<bool>()).prop_map(|(start, segments, is_closed)| {
        let end = is_closed.then_some(PathEl::ClosePath);
        [PathEl::MoveTo(start)].into_iter().chain(segments).chain(end).collect()
    })
}

fn strokes() -> impl Strategy<Value = Stroke> {
    let joins = prop::sample::select(vec![Join::Miter, Join::Round, Join::Bevel]);
    let caps = prop::sample::select(vec![Cap::Butt, Cap::Round, Cap::Square]);
    let dashes = vec(0.0..99.0, 0..4);
    (1e-4..99.0, joins, [caps.clone(), caps], 1.0..9.0, dashes, -9.0..9.0).prop_map(
        |(width, join, [start, end], miter_limit, dashes, offset)| {
            let offset = if dashes.is_empty() { 0.0 } else { offset };
            Stroke::new(width)
                .with_join(join)
                .with_start_cap(start)
                .with_end_cap(end)
                .with_miter_limit(miter_limit)
                .with_dashes(offset, dashes)
        },
    )
}

fn lines() -> impl Strategy<Value = Option<Line>> {
    option::of((strokes(), any::<[u8; 4]>()).prop_map(|(stroke, rgba)| Line { stroke, color: Rgba8(rgba) }))
}

fn paints() -> impl Strategy<Value = Paint> {
    let color = |rgb| Paint::Color(Srgb8(rgb));
    prop_oneof![Just(Paint::Clear), any::<[u8; 3]>().prop_map(color), Just(color([1, 2, 3]))]
}

/// Curves, some with the line of the one before, and areas, some with the outline of a curve.
fn drawings() -> impl Strategy<Value = Drawing> {
    let curves = vec((subpaths(), option::of(lines())), 0..8);
    let fills = vec((vec((subpaths(), any::<u8>()), 1..3), any::<bool>(), any::<[u8; 4]>()), 0..3);
    let page = (-1e3..1e3, -1e3..1e3, 0.01..9e3, 0.01..9e3);
    (curves, fills, page).prop_map(|(curves, fills, (x, y, width, height))| {
        let mut drawing = Drawing::new(Rect::new(x, y, x + width, y + height));
        let mut line = None;
        for (path, own) in curves {
            line = own.unwrap_or(line);
            drawing.curves.push(Curve { path: BezPath::from_vec(path), line: line.clone() });
        }
        for (parts, even_odd, color) in fills {
            let outline = |(own, index): (Vec<PathEl>, u8)| match drawing.curves.get(usize::from(index)) {
                Some(curve) => curve.path.elements().to_vec(),
                None => own,
            };
            let path = BezPath::from_vec(parts.into_iter().flat_map(outline).collect());
            drawing.fills.push(Fill { path, even_odd, color: Rgba8(color) });
        }
        drawing
    })
}

fn scribbles() -> impl Strategy<Value = Vec<Scribble>> {
    let near = (0.0..1024.0, 0.0..1024.0).prop_map(|(x, y)| Point::new(x, y));
    let shading = (0.0..=1.0, any::<bool>(), pressures());
    let kinds = option::of(shading);
    vec((paints(), kinds, 1e-4..99.0, vec((near, 0.0..=1.0), 1..9)), 0..6).prop_map(|all| {
        all.into_iter()
            .map(|(color, kind, width_du, points)| {
                let (points, parts): (_, Vec<f64>) = points.into_iter().unzip();
                let kind = kind.map_or(ScribbleKind::Fill, |(strength, crosses, pressed)| {
                    ScribbleKind::Shade(Shading { strength, crosses, pressure: pressed(parts) })
                });
                Scribble { color, kind, width_du, points }
            })
            .collect()
    })
}

/// What a pen makes of the parts at the points of a stroke.
fn pressures() -> impl Strategy<Value = fn(Vec<f64>) -> PenPressure> {
    prop_oneof![
        Just((|_| PenPressure::Even) as fn(Vec<f64>) -> PenPressure),
        Just(PenPressure::Radius as fn(Vec<f64>) -> PenPressure),
        Just(PenPressure::Strength as fn(Vec<f64>) -> PenPressure),
    ]
}

fn settings() -> impl Strategy<Value = Settings> {
    (any::<[bool; 3]>(), 0.0..=1.0).prop_map(|([is_srgb, is_progressive, spread], gap_closing)| Settings {
        blend: if is_srgb { Blend::Srgb } else { Blend::Oklab },
        engine: if is_progressive { EngineKind::Progressive } else { EngineKind::Global },
        gap_closing,
        spread,
    })
}

fn works() -> impl Strategy<Value = Work> {
    let color_point =
        (any::<u32>(), any::<bool>(), 0.0..9e3, paints()).prop_map(|(curve, is_left, at_du, color)| {
            ColorPoint { curve: curve % 100_000, is_left, at_du, color }
        });
    (drawings(), scribbles(), settings(), vec(swatches(), 0..5), vec(color_point, 0..4), tracings()).prop_map(
        |(drawing, scribbles, settings, palette, color_points, (tracing, image))| {
            let document = Document { drawing, scribbles, color_points, settings, palette, tracing };
            Work { image, ..Work::new(document) }
        },
    )
}

fn swatches() -> impl Strategy<Value = Swatch> {
    let name = prop_oneof![Just(String::new()), any::<String>()];
    (paints(), name).prop_map(|(color, name)| Swatch { color, name })
}

/// A picture under the lines, with or without its file; or none.
fn tracings() -> impl Strategy<Value = (Option<Tracing>, Vec<u8>)> {
    let tracing = (any::<u32>(), 0.0..=1.0).prop_map(|(image, opacity)| Tracing { image, opacity });
    let image = prop_oneof![Just(PNG.to_vec()), Just(JPEG.to_vec()), Just(Vec::new())];
    option::of((tracing, image))
        .prop_map(|both| both.unzip())
        .prop_map(|(tracing, image)| (tracing, image.unwrap_or_default()))
}

fn through_file(work: &Work) -> Work {
    read_file(&write_file(work).unwrap()).unwrap()
}

fn through_link(work: &Work) -> Work {
    read_link(&write_link(work).unwrap().fragment).unwrap()
}

/// All points, with handles, in order.
fn places(work: &Work) -> Vec<Point> {
    let drawing = &work.document.drawing;
    let paths =
        drawing.curves.iter().map(|curve| &curve.path).chain(drawing.fills.iter().map(|fill| &fill.path));
    let path_points = paths.flat_map(|path| path.iter()).flat_map(|element| match element {
        PathEl::MoveTo(p) | PathEl::LineTo(p) => vec![p],
        PathEl::QuadTo(a, p) => vec![a, p],
        PathEl::CurveTo(a, b, p) => vec![a, b, p],
        PathEl::ClosePath => vec![],
    });
    let scribbles = work.document.scribbles.iter().flat_map(|scribble| scribble.points.clone());
    path_points.chain(scribbles).collect()
}

/// All other numbers; they keep three digits, and widths are at least 0.001.
fn lengths(work: &Work) -> Vec<f64> {
    let Document { drawing, scribbles, color_points, settings, .. } = &work.document;
    let strokes = drawing.curves.iter().filter_map(|curve| Some(&curve.line.as_ref()?.stroke));
    let of_stroke = strokes.flat_map(|stroke| {
        let dashes = stroke.dash_pattern.iter().copied();
        [stroke.width.max(0.001), stroke.miter_limit, stroke.dash_offset].into_iter().chain(dashes)
    });
    let widths = scribbles.iter().map(|scribble| scribble.width_du.max(0.001));
    let shadings = scribbles.iter().filter_map(Scribble::shading);
    let parts = shadings.flat_map(|shading| {
        let parts = match &shading.pressure {
            PenPressure::Even => &[][..],
            PenPressure::Radius(parts) | PenPressure::Strength(parts) => parts,
        };
        [shading.strength].into_iter().chain(parts.iter().copied())
    });
    let places = color_points.iter().map(|point| point.at_du);
    of_stroke.chain(widths).chain(parts).chain(places).chain([settings.gap_closing]).collect()
}

/// Everything that is no number: it comes back as it was.
fn forms(work: &Work) -> String {
    let Document { drawing, scribbles, color_points, settings, palette, .. } = &work.document;
    let kinds = |path: &BezPath| -> String {
        let kind = |element: &PathEl| format!("{element:?}").chars().next();
        path.elements().iter().filter_map(kind).collect()
    };
    let line = |line: &Line| {
        (
            line.stroke.join,
            line.stroke.start_cap,
            line.stroke.end_cap,
            line.stroke.dash_pattern.len(),
            line.color,
        )
    };
    let curves: Vec<_> = drawing.curves.iter().map(|c| (kinds(&c.path), c.line.as_ref().map(line))).collect();
    let fills: Vec<_> = drawing.fills.iter().map(|f| (kinds(&f.path), f.even_odd, f.color)).collect();
    let shades = |shading: &Shading| (shading.crosses, mem::discriminant(&shading.pressure));
    let stroke =
        |scribble: &Scribble| (scribble.color, scribble.points.len(), scribble.shading().map(shades));
    let strokes: Vec<_> = scribbles.iter().map(stroke).collect();
    let set: Vec<_> = color_points.iter().map(|p| (p.curve, p.is_left, p.color)).collect();
    let settings = (settings.blend, settings.engine, settings.spread);
    format!("{curves:?} {fills:?} {strokes:?} {set:?} {settings:?} {palette:?} {:?}", work.sample)
}

#[track_caller]
fn assert_near(given: &Work, read: &Work, points_du: f64) {
    assert_eq!(forms(given), forms(read));
    let [given_places, read_places] = [given, read].map(places);
    for (a, b) in given_places.iter().zip(&read_places) {
        let off = (a.x - b.x).abs().max((a.y - b.y).abs());
        let float = FLOAT * a.x.abs().max(a.y.abs()).max(1.0);
        assert!(off <= points_du + float, "{a} became {b}");
    }
    let [given_lengths, read_lengths] = [given, read].map(lengths);
    for (a, b) in given_lengths.iter().zip(&read_lengths) {
        assert!((a - b).abs() <= FILE_DU + FLOAT, "{a} became {b}");
    }
    let [a, b] = [given, read].map(|work| work.document.drawing.page);
    for (a, b) in [(a.x0, b.x0), (a.y0, b.y0), (a.width(), b.width()), (a.height(), b.height())] {
        assert!((a - b).abs() <= 1e-8, "{a} became {b}");
    }
}

proptest! {
    #[test]
    fn a_file_moves_nothing_by_more_than_half_a_step(work in works()) {
        assert_near(&work, &through_file(&work), FILE_DU);
    }

    #[test]
    fn a_link_moves_nothing_by_more_than_half_a_step(work in works()) {
        assert_near(&work, &through_link(&work), LINK_DU);
    }

    #[test]
    fn what_has_been_read_stays_as_it_is(work in works()) {
        let once = through_file(&work);
        prop_assert_eq!(write_file(&once), write_file(&through_file(&once)));
        let once = through_link(&work);
        prop_assert_eq!(write_file(&once), write_file(&through_link(&once)));
        prop_assert_eq!(write_link(&once).unwrap().fragment, write_link(&through_link(&once)).unwrap().fragment);
    }

    #[test]
    fn a_file_keeps_what_came_in_a_link(work in works()) {
        let linked = through_link(&work);
        let filed = through_file(&linked);
        prop_assert_eq!(write_link(&linked).unwrap().fragment, write_link(&filed).unwrap().fragment);
        prop_assert_eq!(write_file(&linked), write_file(&filed));
    }

    #[test]
    fn a_file_keeps_the_picture_under_the_lines_byte_by_byte(work in works()) {
        let read = through_file(&work);
        prop_assert_eq!(&read.image, &work.image);
        prop_assert_eq!(read.document.tracing.is_some(), !work.image.is_empty());
        if let Some(tracing) = read.document.tracing {
            prop_assert_eq!(tracing.image, FILE_IMAGE);
            prop_assert!((tracing.opacity - work.document.tracing.unwrap().opacity).abs() <= 0.0005 + FLOAT);
        }
        let linked = through_link(&work);
        prop_assert!(linked.document.tracing.is_none() && linked.image.is_empty());
    }

    #[test]
    fn exact_bytes_lose_nothing_but_the_file_of_the_picture(work in works()) {
        let read = exact::read(&exact::write(&work)).unwrap();
        let expected = Work { image: Vec::new(), ..work };
        prop_assert_eq!(format!("{read:?}"), format!("{expected:?}"));
    }

    #[test]
    fn exact_bytes_that_are_cut_off_are_no_work(work in works(), end in any::<prop::sample::Index>()) {
        let bytes = exact::write(&work);
        prop_assert!(exact::read(&bytes[..end.index(bytes.len())]).is_none());
        prop_assert!(exact::read(&[&bytes[..], &[0]].concat()).is_none());
    }
}
