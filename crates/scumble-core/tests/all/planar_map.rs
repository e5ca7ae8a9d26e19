//! What a planar map promises, on curves that people draw and on curves made to hurt.

use kurbo::{BezPath, Circle, Point, Rect, Shape, Stroke};
use proptest::prelude::*;
use scumble_core::{Curve, Drawing, Gap, HalfEdge, Line, PlanarMap, Rgba8, Sampling, Triangulation};

fn drawing(paths: impl IntoIterator<Item = BezPath>) -> Drawing {
    let line = Line { stroke: Stroke::new(4.0), color: Rgba8([0, 0, 0, 255]) };
    let curves = paths.into_iter().map(|path| Curve { path, line: Some(line.clone()) }).collect();
    Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 768.0)) }
}

fn map(paths: impl IntoIterator<Item = BezPath>) -> PlanarMap {
    PlanarMap::build(&drawing(paths), &Sampling::default()).expect("a map")
}

fn polyline(points: &[(f64, f64)]) -> BezPath {
    let mut path = BezPath::new();
    path.move_to(points[0]);
    points[1..].iter().for_each(|&p| path.line_to(p));
    path
}

fn area(mesh: &Triangulation, t: usize) -> f64 {
    let [a, b, c] = mesh.corners(t);
    0.5 * (b - a).cross(c - a)
}

/// Checks all that later code relies on: triangles that turn left and tile the page, twins that are mutual, sides
/// on both faces of every piece, and steps that follow one another.
fn assert_sound(map: &PlanarMap) {
    for mesh in [map.triangulation(), map.refined()] {
        let areas: Vec<f64> = (0..mesh.triangle_count()).map(|t| area(mesh, t)).collect();
        assert!(areas.iter().all(|&a| a > 0.0));
        let page: f64 = 1024.0 * 768.0;
        assert!((areas.iter().sum::<f64>() - page).abs() < 1e-6 * page);
        let mut seen = vec![0; map.side_count()];
        for h in mesh.half_edges() {
            assert!(mesh.twin(h).is_none_or(|twin| mesh.twin(twin) == Some(h)));
            if let Some(side) = mesh.side(h) {
                seen[side.index()] += 1;
                let piece = map.pieces()[side.piece()];
                let [a, b] = if side.is_right() { [piece.nodes[1], piece.nodes[0]] } else { piece.nodes };
                assert_eq!(mesh.ends(h), [a, b]);
            } else {
                assert!(mesh.twin(h).is_some());
            }
        }
        assert!(seen.iter().all(|&count| count <= 1));
        assert!(seen.chunks(2).all(|both| both[0] + both[1] >= 1));
    }
    for curve in 0..map.curve_count() {
        let end = |side: scumble_core::SideId, last: bool| {
            map.pieces()[side.piece()].nodes[usize::from(side.is_right() != last)]
        };
        for pair in map.steps(curve).windows(2) {
            assert!(pair[0].arc_du[1] <= pair[1].arc_du[0] + 1e-9);
            if (pair[0].arc_du[1] - pair[1].arc_du[0]).abs() < 1e-9 {
                assert_eq!(end(pair[0].left, true), end(pair[1].left, false));
            }
        }
    }
}

#[test]
fn a_circle_cuts_the_page_in_two() {
    let map = map([Circle::new((400.0, 400.0), 200.0).to_path(1e-6)]);
    assert_sound(&map);
    assert_eq!(map.triangulation().regions().1, 2);
}

#[test]
fn two_crossing_lines_cut_a_circle_in_four() {
    let map = map([
        Circle::new((400.0, 400.0), 200.0).to_path(1e-6),
        polyline(&[(150.0, 400.0), (650.0, 401.0)]),
        polyline(&[(400.0, 150.0), (390.0, 650.0)]),
    ]);
    assert_sound(&map);
    assert_eq!(map.triangulation().regions().1, 5);
}

#[test]
fn a_rectangle_on_the_frame_is_the_frame() {
    let map = map([Rect::new(0.0, 0.0, 1024.0, 768.0).to_path(0.1)]);
    assert_sound(&map);
    assert_eq!(map.triangulation().regions().1, 1);
    assert!(map.pieces().iter().all(|piece| piece.curve == Some(0)));
}

#[test]
fn every_curve_keeps_its_steps_when_curves_coincide() {
    let circle = || Circle::new((400.0, 400.0), 200.0).to_path(1e-6);
    let map = map([circle(), circle(), circle().reverse_subpaths()]);
    assert_sound(&map);
    assert_eq!(map.steps(0), map.steps(1));
    assert_eq!(map.steps(2).len(), map.steps(0).len());
    assert!(map.pieces().iter().all(|piece| piece.curve.is_none_or(|curve| curve == 0)));
}

#[test]
fn points_and_broken_numbers_have_no_steps() {
    let map = map([
        polyline(&[(10.0, 10.0), (10.0, 10.0)]),
        polyline(&[(f64::NAN, 10.0), (20.0, 10.0)]),
        polyline(&[(-50.0, -50.0), (-10.0, -60.0)]),
        polyline(&[(f64::INFINITY, 10.0), (20.0, 10.0)]),
    ]);
    assert_sound(&map);
    assert!((0..4).all(|curve| map.steps(curve).is_empty()));
}

#[test]
fn a_thousand_lines_through_one_point() {
    let centre = Point::new(500.3, 380.7);
    let map = map((0..1000).map(|i| {
        let arm = kurbo::Vec2::from_angle(f64::from(i) * 0.003_141) * 40.0;
        polyline(&[(centre - arm).into(), (centre + arm).into()])
    }));
    assert_sound(&map);
    assert!((0..1000).all(|curve| !map.steps(curve).is_empty()));
}

#[test]
fn gaps_are_edges_of_the_map_and_chains_of_short_edges_of_the_refined_one() {
    let map = map([polyline(&[(100.0, 300.0), (400.0, 310.0)]), polyline(&[(440.0, 303.0), (700.0, 300.0)])]);
    let end = |curve: usize, p: Point| {
        let nodes = map.steps(curve).iter().flat_map(|step| map.ends(step.left));
        let at = |node: &u32| map.triangulation().points()[*node as usize].distance(p);
        nodes.min_by(|a, b| at(a).total_cmp(&at(b))).expect("a node")
    };
    let nodes = [end(0, Point::new(400.0, 310.0)), end(1, Point::new(440.0, 303.0))];
    let [a, b] = nodes.map(|node| map.triangulation().points()[node as usize]);
    let map = map.with_gaps(vec![Gap { nodes, is_wide: false, is_plain: false, is_slight: false }]);
    assert_sound(&map);
    let in_gap = |mesh: &Triangulation| {
        let edges = mesh.half_edges().filter(|&h| mesh.gap(h) == Some(0));
        edges.map(|h: HalfEdge| mesh.segment(h)).collect::<Vec<_>>()
    };
    assert_eq!(in_gap(map.triangulation()).len(), 2);
    let refined = in_gap(map.refined());
    let lengths_du = refined.iter().map(|[p, q]| p.distance(*q));
    let [shortest_du, longest_du] = [lengths_du.clone().fold(9.0, f64::min), lengths_du.fold(0.0, f64::max)];
    assert!(shortest_du <= 0.5 && (4.0..18.0).contains(&longest_du), "{shortest_du} {longest_du}");
    for end in refined.iter().flatten() {
        assert!(((*end - a).cross(b - a) / a.distance(b)).abs() < 1e-9);
    }
    assert!(in_gap(map.with_gaps(vec![]).triangulation()).is_empty());
}

fn coordinate() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => -50.0..1100.0_f64,
        2 => (0..20_i32).prop_map(|i| f64::from(i) * 50.0),
        2 => (0..4_i32, -3..4_i32).prop_map(|(i, j)| f64::from(i) * 200.0 + f64::from(j) * 1e-9),
        1 => prop_oneof![Just(1e308), Just(-1e30), Just(f64::NAN), Just(0.0), Just(1e-300)],
    ]
}

fn path() -> impl Strategy<Value = BezPath> {
    let point = || (coordinate(), coordinate());
    (point(), proptest::collection::vec((point(), point(), point(), any::<bool>()), 1..5), any::<bool>())
        .prop_map(|(start, segments, closed)| {
            let mut path = BezPath::new();
            path.move_to(start);
            for (a, b, c, straight) in segments {
                if straight { path.line_to(c) } else { path.curve_to(a, b, c) }
            }
            if closed {
                path.close_path();
            }
            path
        })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    #[test]
    fn any_curves_make_a_sound_map(paths in proptest::collection::vec(path(), 0..12)) {
        assert_sound(&map(paths));
    }

    #[test]
    fn any_edges_may_be_gaps(paths in proptest::collection::vec(path(), 0..6), every in 1..20_usize) {
        let map = map(paths);
        let mesh = map.triangulation();
        let inner = mesh.half_edges().filter(|&h| mesh.passage(h).is_some_and(|twin| h < twin));
        let gaps: Vec<_> = inner.step_by(every).map(|h| Gap { nodes: mesh.ends(h), is_wide: false, is_plain: false, is_slight: false }).collect();
        let map = map.clone().with_gaps(gaps);
        assert_sound(&map);
        let mesh = map.triangulation();
        prop_assert!((0..map.gaps().len()).all(|gap| mesh.half_edges().filter(|&h| mesh.gap(h) == Some(gap as u32)).count() == 2));
    }

    #[test]
    fn nearly_coincident_curves_make_a_sound_map(
        offsets in proptest::collection::vec((-1e-2..1e-2_f64, -1e-9..1e-9_f64, 0.0..0.02_f64), 2..8),
    ) {
        let circles = offsets.iter().map(|&(dx, dy, dr)| Circle::new((400.0 + dx, 400.0 + dy), 100.0 + dr).to_path(1e-6));
        let lines = offsets.iter().map(|&(dx, dy, dr)| polyline(&[(100.0, 400.0 + dy), (700.0 + dx, 400.0 + dr)]));
        let map = map(circles.chain(lines));
        assert_sound(&map);
        prop_assert!((0..map.curve_count()).all(|curve| !map.steps(curve).is_empty()));
    }
}
