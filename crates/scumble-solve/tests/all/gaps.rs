//! Gaps that are closed to colours, and opened again.

use kurbo::{Arc, BezPath, Circle, Line, Point, Rect, Shape, Vec2};
use proptest::prelude::*;
use scumble_core::{
    Blend, BlendColor, Boundary, Curve, Drawing, Gap, HalfEdge, PlanarMap, Sampling, SideColors,
};
use scumble_solve::{Field, FieldTriangle, MeshSolver};

const CENTRE: Point = Point::new(512.0, 512.0);
const RADIUS_DU: f64 = 200.0;
const OPENING_DU: f64 = 20.0;

fn red() -> BlendColor {
    Blend::Oklab.from_srgb8("#e6194b".parse().expect("a colour"))
}

fn blue() -> BlendColor {
    Blend::Oklab.from_srgb8("#0082c8".parse().expect("a colour"))
}

fn map(curves: impl IntoIterator<Item = BezPath>, spacing_du: f64) -> PlanarMap {
    let curves = curves.into_iter().map(|path| Curve { path, line: None }).collect();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
    PlanarMap::build(&drawing, &Sampling { spacing_du, ..Sampling::default() }).expect("a map")
}

/// A circle with an opening to the right, and the gap across it.
fn open_circle() -> PlanarMap {
    let half = (0.5 * OPENING_DU / RADIUS_DU).asin();
    let arc = Arc::new(CENTRE, (RADIUS_DU, RADIUS_DU), half, std::f64::consts::TAU - 2.0 * half, 0.0);
    let map = map([arc.to_path(1e-6)], Sampling::default().spacing_du);
    let (first, last) = (map.steps(0).first().expect("a step"), map.steps(0).last().expect("a step"));
    let nodes = [map.ends(first.left)[0], map.ends(last.left)[1]];
    map.with_gaps(vec![Gap { nodes, is_wide: false, is_plain: false, is_slight: false }])
}

fn centre(triangle: &FieldTriangle) -> Point {
    let [a, b, c] = triangle.corners.map(|[x, y]| Vec2::new(x.into(), y.into()));
    ((a + b + c) / 3.0).to_point()
}

fn is_inside(triangle: &FieldTriangle) -> bool {
    centre(triangle).distance(CENTRE) < RADIUS_DU
}

/// Colours for the inner and the outer sides of the circle.
fn colors(map: &PlanarMap, inner: Option<BlendColor>, outer: Option<BlendColor>) -> SideColors {
    let mut colors = vec![None; map.side_count()];
    for side in map.steps(0).iter().flat_map(|step| [step.left, step.left.opposite()]) {
        let [a, b] = map.ends(side).map(|node| map.triangulation().points()[node as usize]);
        let is_inner = (b - a).cross(CENTRE - a) > 0.0;
        colors[side.index()] = if is_inner { inner } else { outer }.map(|color| [color; 3]);
    }
    colors
}

fn solved(map: &PlanarMap, boundary: &Boundary) -> Field {
    MeshSolver::new(map.refined().clone()).solve(boundary, Blend::Oklab).expect("a field").clone()
}

fn is_flat(triangle: &FieldTriangle, color: BlendColor) -> bool {
    triangle.colors.iter().all(|c| *c == color.map(|channel| channel as f32))
}

#[test]
fn a_closed_gap_keeps_the_colour_in_and_an_open_one_lets_it_out() {
    let map = open_circle();
    let sides = colors(&map, Some(red()), None);
    let closed = solved(&map, &Boundary { closed_gaps: vec![true], ..sides.clone().into() });
    assert!(closed.triangles.len() > 100);
    assert!(closed.triangles.iter().all(|triangle| is_inside(triangle) && is_flat(triangle, red())));
    let open = solved(&map, &sides.into());
    assert_eq!(open.triangles.len(), map.refined().triangle_count());
    assert!(open.triangles.iter().all(|triangle| is_flat(triangle, red())));
}

#[test]
fn two_colours_on_either_side_of_a_closed_gap_stay_apart_to_the_last_bit() {
    let map = open_circle();
    let sides = colors(&map, Some(red()), Some(blue()));
    let field = solved(&map, &Boundary { closed_gaps: vec![true], ..sides.clone().into() });
    assert_eq!(field.triangles.len(), map.refined().triangle_count());
    for triangle in &field.triangles {
        assert!(is_flat(triangle, if is_inside(triangle) { red() } else { blue() }));
    }
    let open = solved(&map, &sides.into());
    let in_the_opening = |t: &&FieldTriangle| centre(t).distance(CENTRE + Vec2::new(RADIUS_DU, 0.0)) < 8.0;
    let mut blended = open.triangles.iter().filter(in_the_opening).peekable();
    assert!(blended.peek().is_some());
    assert!(blended.all(|triangle| !is_flat(triangle, red()) && !is_flat(triangle, blue())));
}

#[test]
fn the_picture_may_jump_at_a_closed_gap_and_not_at_an_open_one() {
    let map = open_circle();
    let sides = colors(&map, Some(red()), Some(blue()));
    let ends = map.gaps()[0].nodes.map(|node| map.triangulation().points()[node as usize]);
    let gap = Line::new(ends[0], ends[1]);
    let is_on_gap = |[x, y]: [f32; 2]| {
        kurbo::ParamCurveNearest::nearest(&gap, Point::new(x.into(), y.into()), 1e-9).distance_sq < 1e-8
    };
    for closed in [true, false] {
        let boundary = Boundary { closed_gaps: vec![closed], ..sides.clone().into() };
        let mut length_du = 0.0;
        for triangle in solved(&map, &boundary).triangles {
            for i in 0..3 {
                let [a, b] = [triangle.corners[i], triangle.corners[(i + 1) % 3]];
                if is_on_gap(a) && is_on_gap(b) {
                    assert_eq!(triangle.side_edges >> i & 1 == 1, closed);
                    length_du += f64::from(a[0] - b[0]).hypot(f64::from(a[1] - b[1]));
                }
            }
        }
        assert!((length_du - 2.0 * OPENING_DU).abs() < 0.1, "from either side: {length_du}");
    }
}

#[test]
fn gaps_beyond_the_end_of_the_list_are_open_and_gaps_that_are_no_edges_do_nothing() {
    let circle = || Circle::new(CENTRE, RADIUS_DU).to_path(1e-6);
    let plain = map([circle()], 3.0);
    let [a, b] = plain.pieces()[0].nodes;
    let far = [a, a + 100];
    let gaps = [[a, b], [b, a], far, [a, a], [7, u32::MAX]].map(|nodes| Gap {
        nodes,
        is_wide: false,
        is_plain: false,
        is_slight: false,
    });
    let map = map([circle()], 3.0).with_gaps(gaps.to_vec());
    let sides = colors(&map, Some(red()), None);
    let without = solved(&plain, &sides.clone().into());
    for closed_gaps in [vec![], vec![true; 2], vec![true; 5], vec![true; 9]] {
        assert_eq!(solved(&map, &Boundary { closed_gaps, ..sides.clone().into() }), without);
    }
}

/// Lines and circles that leave passages, with a gap at every edge between them whose circle holds no other node.
fn passages() -> impl Strategy<Value = PlanarMap> {
    let place = || (0.0..1024.0_f64, 0.0..1024.0_f64);
    let line = (place(), place()).prop_map(|(a, b)| Line::new(a, b).to_path(1e-6));
    let circle = (place(), 20.0..300.0_f64).prop_map(|(middle, r)| Circle::new(middle, r).to_path(1e-6));
    let curves = proptest::collection::vec(prop_oneof![3 => line, 1 => circle], 2..7);
    curves.prop_map(|curves| {
        let map = map(curves, 24.0);
        let gaps = gabriel_edges(&map)
            .map(|nodes| Gap { nodes, is_wide: false, is_plain: false, is_slight: false })
            .collect();
        map.with_gaps(gaps)
    })
}

fn gabriel_edges(map: &PlanarMap) -> impl Iterator<Item = [u32; 2]> + '_ {
    let mesh = map.triangulation();
    let apex = |h: HalfEdge| mesh.points()[mesh.origin(h.prev()) as usize];
    let is_open = move |h: HalfEdge, p: Point| {
        let [a, b] = mesh.segment(h);
        (a - p).dot(b - p) > 0.0
    };
    mesh.half_edges().filter_map(move |h| {
        let twin = mesh.passage(h).filter(|&twin| h < twin)?;
        (is_open(h, apex(h)) && is_open(h, apex(twin))).then(|| mesh.ends(h))
    })
}

/// Colours for as many sides as there are, in runs, some without colour.
fn sides(map: &PlanarMap, seed: &[(Option<[f64; 2]>, usize)]) -> SideColors {
    let runs = seed.iter().flat_map(|&(colors, count)| vec![colors; count]);
    let mut runs = runs.cycle();
    let mut blend = || {
        let [a, b] = runs.next().flatten()?;
        Some([a, 0.5 * (a + b), b].map(|t| std::array::from_fn(|i| red()[i] + t * (blue()[i] - red()[i]))))
    };
    (0..map.side_count()).map(|_| blend()).collect()
}

fn seeds() -> impl Strategy<Value = Vec<(Option<[f64; 2]>, usize)>> {
    let color = prop_oneof![1 => Just(None), 2 => [0.0..1.0_f64, 0.0..1.0].prop_map(Some)];
    proptest::collection::vec((color, 1..40_usize), 1..8)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn closing_and_opening_leaves_no_trace(
        map in passages(),
        seed in seeds(),
        patterns in proptest::collection::vec(proptest::collection::vec(any::<bool>(), 0..40), 2..5),
    ) {
        let sides = sides(&map, &seed);
        let mut solver = MeshSolver::new(map.refined().clone());
        for pattern in patterns.iter().chain(&patterns) {
            let closed_gaps = pattern.iter().copied().cycle().take(map.gaps().len()).collect();
            let boundary = Boundary { closed_gaps, ..sides.clone().into() };
            prop_assert_eq!(solver.solve(&boundary, Blend::Oklab), Ok(&solved(&map, &boundary)));
        }
    }

    #[test]
    fn with_all_gaps_closed_nothing_goes_through_any(map in passages()) {
        let boundary = Boundary {
            sides: (0..map.side_count()).map(|i| Some([[i as f64, 0.5, 0.5, 1.0]; 3])).collect(),
            closed_gaps: vec![true; map.gaps().len()],
            sources: Vec::new(),
        };
        let mesh = map.refined();
        let along = |h: &HalfEdge| mesh.gap(*h).map(|gap| (gap, mesh.segment(*h)));
        let mut lengths_du = vec![0.0; map.gaps().len()];
        for (gap, [a, b]) in mesh.half_edges().filter_map(|h| along(&h)) {
            lengths_du[gap as usize] += a.distance(b);
        }
        for (gap, length_du) in map.gaps().iter().zip(lengths_du) {
            let [a, b] = gap.nodes.map(|node| map.triangulation().points()[node as usize]);
            prop_assert!((length_du - 2.0 * a.distance(b)).abs() < 1e-6);
        }
        prop_assert!(MeshSolver::new(mesh.clone()).solve(&boundary, Blend::Oklab).is_ok());
    }
}
