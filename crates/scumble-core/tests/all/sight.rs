//! The `Sight` engine as a person sees it: what a scribble claims, and that history leaves no trace.

use kurbo::{BezPath, Circle, Point, Rect, Shape};
use proptest::prelude::*;
use scumble_core::{Curve, Drawing, Engine, PlanarMap, Sampling, Scribble, ScribbleKind, Sight, Srgb8};

fn map(paths: impl IntoIterator<Item = BezPath>) -> PlanarMap {
    let curves = paths.into_iter().map(|path| Curve { path, line: None }).collect();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
    PlanarMap::build(&drawing, &Sampling::default()).expect("a map")
}

fn two_circles() -> PlanarMap {
    map([(300.0, 400.0, 150.0), (700.0, 500.0, 180.0)].map(|(x, y, r)| Circle::new((x, y), r).to_path(1e-6)))
}

fn scribble(points: &[(f64, f64)]) -> Scribble {
    Scribble {
        color: Srgb8([9, 9, 9]).into(),
        kind: ScribbleKind::Fill,
        width_du: 4.0,
        points: points.iter().map(|&p| p.into()).collect(),
    }
}

#[test]
fn a_scribble_inside_a_closed_shape_claims_all_of_its_inside_and_nothing_outside() {
    let map = two_circles();
    let labels = Sight::default().label(&map, &[scribble(&[(250.0, 400.0), (350.0, 420.0)])]);
    for curve in 0..2 {
        for step in map.steps(curve) {
            assert_eq!(labels.sides[step.left.index()], (curve == 0).then_some(0));
            assert_eq!(labels.sides[step.left.opposite().index()], None);
        }
    }
}

#[test]
fn the_latest_scribble_wins() {
    let map = two_circles();
    let both = [scribble(&[(250.0, 400.0)]), scribble(&[(260.0, 400.0)])];
    let labels = Sight::default().label(&map, &both);
    assert!(map.steps(0).iter().all(|step| labels.sides[step.left.index()] == Some(1)));
}

#[test]
fn a_scribble_off_the_page_claims_nothing() {
    let map = two_circles();
    let far = scribble(&[(-1e9, 5.0), (-1e9, 1e9)]);
    assert!(Sight::default().label(&map, &[far]).sides.iter().all(Option::is_none));
}

fn strokes() -> impl Strategy<Value = Vec<Vec<Point>>> {
    let point = (0.0..1024.0_f64, 0.0..1024.0_f64).prop_map(Point::from);
    proptest::collection::vec(proptest::collection::vec(point, 1..6), 1..5)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn growing_changing_and_erasing_strokes_leaves_no_trace(strokes in strokes(), cut in 0..5_usize) {
        let map = two_circles();
        let all: Vec<_> = strokes.into_iter()
            .map(|points| Scribble { color: Srgb8([1, 2, 3]).into(), kind: ScribbleKind::Fill, width_du: 3.0, points }).collect();
        let mut engine = Sight::default();
        for i in 0..all.len() {
            for grown in 1..=all[i].points.len() {
                let mut now = all[..=i].to_vec();
                now[i].points.truncate(grown);
                prop_assert_eq!(engine.label(&map, &now), Sight::default().label(&map, &now));
            }
        }
        let mut fewer = all.clone();
        fewer.remove(cut % all.len());
        prop_assert_eq!(engine.label(&map, &fewer), Sight::default().label(&map, &fewer));
    }
}
