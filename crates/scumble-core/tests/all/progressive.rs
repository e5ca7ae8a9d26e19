//! The `Progressive` engine on one small drawing for each figure of Bao & Fu 2019 that shows a rule, and that history
//! leaves no trace.

use kurbo::{BezPath, Circle, Point, Rect, Shape};
use proptest::prelude::*;
use scumble_core::{
    Curve, Drawing, Engine, Gap, Labels, Paint, PlanarMap, Progressive, Sampling, Scribble, ScribbleKind,
};

fn map(paths: impl IntoIterator<Item = BezPath>) -> PlanarMap {
    let curves = paths.into_iter().map(|path| Curve { path, line: None }).collect();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
    PlanarMap::build(&drawing, &Sampling::default()).expect("a map")
}

fn polyline(points: &[(f64, f64)]) -> BezPath {
    let mut path = BezPath::new();
    path.move_to(points[0]);
    points[1..].iter().for_each(|&p| path.line_to(p));
    path
}

fn rect(x0: f64, y0: f64, x1: f64, y1: f64) -> BezPath {
    Rect::new(x0, y0, x1, y1).to_path(0.1)
}

fn circle(x: f64, y: f64, radius: f64) -> BezPath {
    Circle::new((x, y), radius).to_path(1e-6)
}

fn scribble(points: &[(f64, f64)]) -> Scribble {
    Scribble {
        color: Paint::Clear,
        kind: ScribbleKind::Fill,
        width_du: 4.0,
        points: points.iter().map(|&p| p.into()).collect(),
    }
}

fn label(map: &PlanarMap, scribbles: &[Scribble]) -> Labels {
    Progressive::default().label(map, scribbles)
}

/// The labels along one curve: on its left, or on its right.
fn along(map: &PlanarMap, labels: &Labels, curve: usize, right: bool) -> Vec<Option<u32>> {
    let side = |left: scumble_core::SideId| if right { left.opposite() } else { left };
    map.steps(curve).iter().map(|step| labels.sides[side(step.left).index()]).collect()
}

fn all(labels: &[Option<u32>], expected: Option<u32>) -> bool {
    labels.iter().all(|&label| label == expected)
}

/// The middles of the steps of a curve.
fn middles(map: &PlanarMap, curve: usize) -> Vec<Point> {
    let points = map.triangulation().points();
    let middle = |[a, b]: [u32; 2]| points[a as usize].midpoint(points[b as usize]);
    map.steps(curve).iter().map(|step| middle(map.ends(step.left))).collect()
}

/// A U with its mouth to the right, and a line beyond the mouth.
fn u_shape() -> PlanarMap {
    map([
        polyline(&[(600.0, 400.0), (300.0, 400.0), (300.0, 600.0), (600.0, 600.0)]),
        polyline(&[(800.0, 200.0), (800.0, 800.0)]),
    ])
}

#[test]
fn closed_shape_all_of_its_inside_and_nothing_outside() {
    let map = map([circle(300.0, 400.0, 150.0), circle(700.0, 500.0, 180.0)]);
    let labels = label(&map, &[scribble(&[(250.0, 400.0), (350.0, 420.0)])]);
    assert!(all(&along(&map, &labels, 0, false), Some(0)));
    assert!(all(&along(&map, &labels, 0, true), None));
    assert!(all(&along(&map, &labels, 1, false), None) && all(&along(&map, &labels, 1, true), None));
}

#[test]
fn two_squares_side_by_side_keep_apart() {
    let map = map([rect(200.0, 400.0, 500.0, 700.0), rect(500.0, 400.0, 800.0, 700.0)]);
    let labels = label(&map, &[scribble(&[(350.0, 500.0)]), scribble(&[(600.0, 500.0), (700.0, 600.0)])]);
    let count = |i| labels.sides.iter().filter(|&&label| label == Some(i)).count();
    assert_eq!(count(0), 4 * 83);
    assert_eq!(count(1), 4 * 83);
}

#[test]
fn figure_3b_what_is_seen_through_the_mouth_stays_out() {
    let map = u_shape();
    for points in
        [&[(350.0, 480.0), (500.0, 520.0)][..], &[(400.0, 500.0)], &[(560.0, 450.0), (560.0, 550.0)]]
    {
        let labels = label(&map, &[scribble(points)]);
        assert!(all(&along(&map, &labels, 0, false), None), "the outside of the U");
        assert!(all(&along(&map, &labels, 0, true), Some(0)), "its inside");
        assert!(all(&along(&map, &labels, 1, false), None), "the line beyond");
        let frame = map.pieces().iter().enumerate().filter(|(_, piece)| piece.curve.is_none());
        assert!(frame.clone().count() > 0);
        for (i, _) in frame {
            assert!(labels.sides[2 * i].is_none() && labels.sides[2 * i + 1].is_none(), "the frame");
        }
    }
}

#[test]
fn figure_3b_a_scribble_beyond_the_mouth_leaves_the_u_to_one_within() {
    let map = u_shape();
    let beyond = scribble(&[(700.0, 100.0), (700.0, 900.0)]);
    let within = scribble(&[(350.0, 480.0), (500.0, 520.0)]);
    for (order, own) in [([beyond.clone(), within.clone()], 1), ([within, beyond], 0)] {
        let labels = label(&map, &order);
        assert!(all(&along(&map, &labels, 1, false), Some(1 - own)), "the line beyond");
        let inside = along(&map, &labels, 0, true);
        let kept = inside.iter().filter(|&&label| label == Some(own)).count();
        assert!(5 * kept >= 4 * inside.len(), "{kept} of {}", inside.len());
    }
}

#[test]
fn figure_3b_the_gap_at_the_mouth_is_closed_for_a_scribble_within_and_open_for_one_through_it() {
    let map = u_shape();
    let node = |x: f64, y: f64| {
        let points = map.triangulation().points();
        points.iter().position(|&p| p == Point::new(x, y)).expect("a node") as u32
    };
    let mouth = Gap {
        nodes: [node(600.0, 400.0), node(600.0, 600.0)],
        is_wide: false,
        is_plain: false,
        is_slight: false,
    };
    let map = map.clone().with_gaps(vec![mouth]);
    let within = scribble(&[(350.0, 480.0), (500.0, 520.0)]);
    let through = scribble(&[(350.0, 500.0), (700.0, 500.0), (700.0, 100.0), (100.0, 100.0)]);
    assert_eq!(label(&map, &[]).closed_gaps, [false]);
    assert_eq!(label(&map, &[within]).closed_gaps, [true]);
    assert_eq!(label(&map, &[through]).closed_gaps, [false]);
}

#[test]
fn figure_8_in_every_order_each_scribble_keeps_what_is_nearest() {
    let map = map([circle(512.0, 512.0, 300.0)]);
    let at = [(512.0, 300.0), (328.0, 618.0), (696.0, 618.0)];
    let dabs = at.map(|(x, y)| scribble(&[(x - 20.0, y), (x + 20.0, y)]));
    let mut results = Vec::new();
    for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        let labels = label(&map, &order.map(|i| dabs[i].clone()));
        let of_place = along(&map, &labels, 0, false);
        results.push(of_place.into_iter().map(|l| order[l.expect("a label") as usize]).collect::<Vec<_>>());
    }
    let mut agree = 0;
    for (i, middle) in middles(&map, 0).into_iter().enumerate() {
        let distance = |k: usize| (middle - Point::from(at[k])).hypot();
        let mut by_distance = [0, 1, 2];
        by_distance.sort_by(|&a, &b| distance(a).total_cmp(&distance(b)));
        if distance(by_distance[0]) < 0.7 * distance(by_distance[1]) {
            assert!(
                results.iter().all(|r| r[i] == by_distance[0]),
                "what is clearly nearest, in every order"
            );
        }
        agree += usize::from(results.iter().all(|r| r[i] == results[0][i]));
    }
    assert!(10 * agree >= 9 * results[0].len(), "{agree} of {} alike", results[0].len());
}

#[test]
fn figure_10a_a_scribble_across_two_regions_has_both() {
    let map = map([rect(200.0, 400.0, 500.0, 700.0), rect(500.0, 400.0, 800.0, 700.0)]);
    let labels = label(&map, &[scribble(&[(300.0, 550.0), (700.0, 560.0)])]);
    assert_eq!(labels.sides.iter().filter(|&&label| label == Some(0)).count(), 8 * 83);
}

#[test]
fn figure_10b_a_scribble_that_slips_out_of_its_region_stays_in_it() {
    let map = map([rect(200.0, 400.0, 500.0, 700.0)]);
    let labels = label(&map, &[scribble(&[(250.0, 550.0), (510.0, 560.0)])]);
    assert_eq!(labels.sides.iter().filter(|&&label| label == Some(0)).count(), 4 * 83);
    let through_the_mouth = scribble(&[(350.0, 500.0), (620.0, 500.0)]);
    let map = u_shape();
    let labels = label(&map, &[through_the_mouth]);
    assert!(all(&along(&map, &labels, 0, true), Some(0)));
    assert!(all(&along(&map, &labels, 1, false), None) && all(&along(&map, &labels, 1, true), None));
}

#[test]
fn figure_10c_a_scribble_over_another_divides_their_region() {
    let map = map([rect(200.0, 400.0, 800.0, 600.0)]);
    let scribbles =
        [scribble(&[(250.0, 500.0), (550.0, 500.0)]), scribble(&[(450.0, 490.0), (750.0, 510.0)])];
    let labels = label(&map, &scribbles);
    let inside = along(&map, &labels, 0, false);
    for (middle, label) in middles(&map, 0).into_iter().zip(&inside) {
        let expected = if middle.x < 300.0 { Some(0) } else { Some(1) };
        if middle.x < 300.0 || middle.x > 700.0 {
            assert_eq!(*label, expected, "at {middle}");
        }
    }
    let borders = inside.windows(2).filter(|pair| pair[0] != pair[1]).count();
    assert!(borders <= 4, "{borders} borders");
}

#[test]
fn figure_11_each_further_scribble_takes_its_part_of_a_region() {
    let map = map([circle(512.0, 512.0, 300.0)]);
    let at = [(512.0, 330.0), (512.0, 700.0), (330.0, 512.0), (700.0, 512.0)];
    let scribbles = at.map(|(x, y)| scribble(&[(x - 15.0, y), (x + 15.0, y)]));
    for count in 1..=scribbles.len() {
        let labels = label(&map, &scribbles[..count]);
        let inside = along(&map, &labels, 0, false);
        for (i, at) in at.map(Point::from).into_iter().enumerate().take(count) {
            let near = middles(&map, 0).into_iter().zip(&inside);
            let nearest = near.min_by(|a, b| (a.0 - at).hypot().total_cmp(&(b.0 - at).hypot()));
            assert_eq!(nearest.map(|(_, label)| *label), Some(Some(i as u32)), "{i} of {count}");
        }
        let borders = (0..inside.len()).filter(|&i| inside[i] != inside[(i + 1) % inside.len()]).count();
        assert!(borders <= 2 * count, "{borders} borders with {count} scribbles");
    }
}

#[test]
fn figure_11_a_curve_added_between_two_scribbles_parts_them() {
    let shape = || rect(200.0, 400.0, 800.0, 600.0);
    let scribbles =
        [scribble(&[(300.0, 480.0), (300.0, 520.0)]), scribble(&[(400.0, 480.0), (400.0, 520.0)])];
    let map = map([shape(), polyline(&[(600.0, 400.0), (600.0, 600.0)])]);
    let labels = label(&map, &scribbles);
    for (middle, label) in middles(&map, 0).into_iter().zip(along(&map, &labels, 0, false)) {
        assert_eq!(label.is_some(), middle.x < 600.0, "at {middle}");
    }
}

#[test]
fn figure_17_a_scribble_that_goes_around_a_corner_has_what_it_sees_on_its_way() {
    let map = map([
        polyline(&[(300.0, 300.0), (700.0, 300.0), (700.0, 700.0)]),
        polyline(&[(300.0, 400.0), (600.0, 400.0), (600.0, 700.0)]),
    ]);
    let labels = label(&map, &[scribble(&[(320.0, 350.0), (650.0, 350.0), (650.0, 680.0)])]);
    assert!(all(&along(&map, &labels, 0, false), Some(0)), "the outer wall");
    assert!(all(&along(&map, &labels, 1, true), Some(0)), "the inner wall");
    assert!(all(&along(&map, &labels, 0, true), None) && all(&along(&map, &labels, 1, false), None));
}

#[test]
fn no_scribble_is_too_odd() {
    let map = map([rect(200.0, 400.0, 500.0, 700.0), circle(700.0, 500.0, 100.0)]);
    let node = map.triangulation().points()[map.ends(map.steps(0)[7].left)[0] as usize];
    let odd = [
        vec![],
        vec![Point::new(-50.0, 3e9), Point::new(f64::MAX, 7.0)],
        vec![Point::new(f64::NAN, 1.0), Point::new(300.0, f64::INFINITY), Point::new(300.0, 500.0)],
        vec![node],
        vec![node, node],
        vec![Point::new(200.0, 550.5)],
        vec![Point::new(200.0, 450.0), Point::new(200.0, 650.0)],
        vec![Point::new(0.0, 0.0), Point::new(1024.0, 1024.0)],
        (0..100_000).map(|i| Point::new(300.0 + f64::from(i % 100), 500.0 + f64::from(i % 7))).collect(),
    ];
    let scribbles: Vec<_> =
        odd.into_iter().map(|points| Scribble { points, ..scribble(&[(0.0, 0.0)]) }).collect();
    for one in &scribbles {
        let _ = label(&map, std::slice::from_ref(one));
    }
    let _ = label(&map, &scribbles);
    let _ = label(&self::map([]), &scribbles);
}

fn crossing_shapes() -> PlanarMap {
    map([
        circle(300.0, 400.0, 150.0),
        circle(420.0, 500.0, 180.0),
        polyline(&[(600.0, 200.0), (900.0, 220.0), (880.0, 500.0), (640.0, 520.0)]),
        polyline(&[(100.0, 800.0), (900.0, 700.0)]),
    ])
}

fn strokes() -> impl Strategy<Value = Vec<Vec<Point>>> {
    let near = |(x, y): (f64, f64)| {
        let step = (-120.0..120.0_f64, -120.0..120.0_f64);
        proptest::collection::vec(step, 0..5).prop_map(move |steps| {
            let mut at = Point::new(x, y);
            let mut points = vec![at];
            for step in steps {
                at += kurbo::Vec2::from(step);
                points.push(at);
            }
            points
        })
    };
    let stroke = (0.0..1024.0_f64, 0.0..1024.0_f64).prop_flat_map(near);
    proptest::collection::vec(stroke, 1..6)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(40))]

    #[test]
    fn growing_changing_and_erasing_strokes_leaves_no_trace(strokes in strokes(), cut in 0..5_usize) {
        let map = crossing_shapes();
        let all: Vec<_> = strokes.into_iter()
            .map(|points| Scribble { points, ..scribble(&[(0.0, 0.0)]) }).collect();
        let mut engine = Progressive::default();
        for i in 0..all.len() {
            for grown in 1..=all[i].points.len() {
                let mut now = all[..=i].to_vec();
                now[i].points.truncate(grown);
                prop_assert_eq!(engine.label(&map, &now), label(&map, &now));
            }
        }
        let mut changed = all.clone();
        changed[cut % all.len()].points.reverse();
        prop_assert_eq!(engine.label(&map, &changed), label(&map, &changed));
        changed.remove(cut % all.len());
        prop_assert_eq!(engine.label(&map, &changed), label(&map, &changed));
        changed.reverse();
        prop_assert_eq!(engine.label(&map, &changed), label(&map, &changed));
        prop_assert_eq!(engine.label(&map, &all), label(&map, &all));
        prop_assert_eq!(engine.label(&map, &[]), label(&map, &[]));
    }

    #[test]
    fn cutting_a_stroke_into_more_points_changes_nothing_much(x in 250.0..350.0_f64, y in 300.0..450.0_f64) {
        let map = map([circle(300.0, 400.0, 150.0)]);
        let dab = label(&map, &[scribble(&[(x, y)])]);
        let twice = label(&map, &[scribble(&[(x, y), (x, y)])]);
        prop_assert_eq!(dab, twice);
    }
}
