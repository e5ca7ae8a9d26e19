//! Scribbles that nobody would draw on purpose: no engine panics at them, or takes them for more than they are.

use kurbo::{BezPath, Circle, Point, Rect, Shape, Stroke};
use scumble_core::{
    Curve, Drawing, Engine, Global, Labels, Line, Paint, PlanarMap, Progressive, Rgba8, Sampling, Scribble,
    ScribbleKind, Srgb8,
};

/// A square whose outline has a gap of 20 du, a circle that crosses it, and a line that ends in mid-page.
fn map() -> PlanarMap {
    let open =
        BezPath::from_svg("M 420 200 L 200 200 L 200 600 L 600 600 L 600 200 L 440 200").expect("a path");
    let line = BezPath::from_svg("M 0 700 L 800 650").expect("a path");
    let line_style = Line { stroke: Stroke::new(4.0), color: Rgba8([0, 0, 0, 255]) };
    let curves = [open, Circle::new((600.0, 400.0), 150.0).to_path(1e-3), line]
        .map(|path| Curve { path, line: Some(line_style.clone()) });
    let drawing = Drawing { curves: curves.to_vec(), ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 768.0)) };
    PlanarMap::build(&drawing, &Sampling::default()).expect("a map").with_gaps_closed(0.5)
}

fn engines() -> [Box<dyn Engine>; 3] {
    [Box::new(Global::new(false)), Box::new(Global::new(true)), Box::new(Progressive::default())]
}

fn scribble(points: Vec<Point>) -> Scribble {
    Scribble { color: Srgb8([9, 9, 9]).into(), kind: ScribbleKind::Fill, width_du: 8.0, points }
}

fn ways(map: &PlanarMap) -> Vec<Vec<Point>> {
    let nodes = map.triangulation().points();
    let [a, b] = map.ends(map.steps(1)[7].left).map(|node| nodes[node as usize]);
    let p = |x: f64, y: f64| Point::new(x, y);
    vec![
        vec![],
        vec![a],
        vec![a, a, a],
        vec![a.midpoint(b)],
        map.steps(1).iter().map(|step| nodes[map.ends(step.left)[0] as usize]).collect(),
        vec![nodes[map.gaps()[0].nodes[0] as usize], nodes[map.gaps()[0].nodes[1] as usize]],
        vec![p(200.0, 250.0), p(200.0, 550.0)],
        vec![p(0.0, 0.0), p(1024.0, 768.0)],
        vec![p(1024.0, 0.0), p(1024.0, 768.0), p(0.0, 768.0)],
        vec![p(-50.0, 3e9), p(f64::MAX, 7.0)],
        vec![p(f64::MAX, f64::MAX), p(-f64::MAX, -f64::MAX)],
        vec![p(300.0, 300.0), p(1e300, -1e300), p(300.0, 301.0)],
        vec![p(-1e7, 400.0), p(1e7, 400.0), p(f64::MIN_POSITIVE, -0.0)],
        vec![p(300.0, 300.0), p(300.0 + 1e-13, 300.0), p(300.0, 300.0 - 1e-13)],
        (0..100_000_u32).map(|i| p(250.0 + f64::from(i % 300), 250.0 + f64::from(i % 307))).collect(),
    ]
}

#[test]
fn no_scribble_is_too_odd() {
    let map = map();
    let scribbles: Vec<_> = ways(&map).into_iter().map(scribble).collect();
    for mut engine in engines() {
        for one in &scribbles {
            let labels = engine.label(&map, std::slice::from_ref(one));
            assert_eq!(labels.sides.len(), map.side_count());
        }
        let all = engine.label(&map, &scribbles);
        assert!(all.sides.iter().flatten().all(|&label| (label as usize) < scribbles.len()));
    }
}

#[test]
fn no_drawing_is_too_empty() {
    let map = PlanarMap::build(&Drawing::new(Rect::new(0.0, 0.0, 9.0, 2.0)), &Sampling::default());
    let map = map.expect("a map").with_gaps_closed(1.0);
    let scribbles: Vec<_> = ways(&self::map()).into_iter().map(scribble).collect();
    for mut engine in engines() {
        assert_eq!(engine.label(&map, &[]), Labels::none(&map));
        engine.label(&map, &scribbles);
    }
}

#[test]
fn three_hundred_scribbles_are_labelled_and_by_global_in_any_order() {
    let map = map();
    let at = |i: u32| Point::new(f64::from(i * 37 % 1024), f64::from(i * 61 % 768));
    let one = |i: u32| Scribble {
        color: if i.is_multiple_of(9) { Paint::Clear } else { Srgb8([i as u8, 9, 9]).into() },
        ..scribble((0..i % 7 + 1).map(|k| at(i) + kurbo::Vec2::new(f64::from(9 * k), 2.0)).collect())
    };
    let scribbles: Vec<_> = (0..300).map(one).collect();
    let reversed: Vec<_> = scribbles.iter().rev().cloned().collect();
    Progressive::default().label(&map, &scribbles);
    for spread in [false, true] {
        let labels = Global::new(spread).label(&map, &scribbles);
        let mirrored = Global::new(spread).label(&map, &reversed);
        let same = labels.sides.iter().zip(&mirrored.sides).all(|(a, b)| *a == b.map(|b| 299 - b));
        assert!(same && labels.closed_gaps == mirrored.closed_gaps);
    }
}
