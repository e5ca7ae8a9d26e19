//! Shading with strokes, regions and pressures that nobody draws on purpose: there is a picture, of colours in their range.

use kurbo::{Affine, BezPath, Point, Rect};
use scumble_core::source::{RADII_DU, weight};
use scumble_core::{Blend, Boundary, Curve, Drawing, PlanarMap, Sampling, SoftSource};
use scumble_solve::grid::{Constraints, GridSolver};
use scumble_solve::{MeshSolver, View};

/// A page with a closed way on it.
fn map(way: &[(f64, f64)]) -> PlanarMap {
    let mut path = BezPath::new();
    path.move_to(way[0]);
    way[1..].iter().for_each(|&p| path.line_to(p));
    path.close_path();
    let drawing = Drawing {
        curves: vec![Curve { path, line: None }],
        ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0))
    };
    PlanarMap::build(&drawing, &Sampling::default()).expect("a map")
}

/// A triangle smaller than any brush, one smaller still, and one without width to speak of.
fn maps() -> [PlanarMap; 3] {
    [
        map(&[(500.0, 500.0), (500.4, 500.0), (500.0, 500.3)]),
        map(&[(500.0, 500.0), (500.02, 500.0), (500.0, 500.03)]),
        map(&[(100.0, 500.0), (900.0, 500.001), (900.0, 500.0)]),
    ]
}

/// Dabs within and off the page, points on the same place, a stroke of a thousand pages.
const WAYS: [&[(f64, f64)]; 6] = [
    &[(500.01, 500.01)],
    &[(-1.5, 500.0)],
    &[(-5000.0, 500.0)],
    &[(500.01, 500.01), (500.01, 500.01), (500.01, 500.01)],
    &[(490.0, 499.9), (490.0 + 1e-13, 499.9), (510.0, 500.1)],
    &[(1.024e6, -1.024e6), (500.0, 500.0), (-1.024e6, 1.024e6)],
];

/// What a pen leaves of radius and root of the weight at even and odd points.
const PARTS: [[[f64; 2]; 2]; 3] = [[[1.0; 2]; 2], [[0.0, 1.0], [1.0, 1.0]], [[1.0, 1.0], [1.0, 0.0]]];

fn sources() -> impl Iterator<Item = SoftSource> {
    let ways = WAYS.into_iter().flat_map(|way| PARTS.map(|parts| (way, parts)));
    ways.flat_map(|(way, parts)| {
        let radii =
            RADII_DU.into_iter().flat_map(|radius_du| [1e-12, 1.0].map(|strength| (radius_du, strength)));
        let kinds = radii.flat_map(|kind| [false, true].map(|crosses| (kind, crosses)));
        kinds.map(move |((radius_du, strength), crosses)| SoftSource {
            points: way.iter().copied().map(Point::from).collect(),
            radius_du,
            weight: weight(strength),
            color: [0.9, 0.1, 0.0, 1.0],
            crosses,
            parts: (0..way.len()).map(|i| parts[i % 2]).collect(),
        })
    })
}

fn check(colors: impl Iterator<Item = [f32; 4]>, slack: f32, source: &SoftSource) {
    let mut values = colors.flatten();
    assert!(values.all(|value| (-slack..=1.0 + slack).contains(&value)), "{source:?}");
}

#[test]
fn any_source_makes_a_picture() {
    for map in maps() {
        let mut solver = MeshSolver::new(map.refined().clone());
        for source in sources() {
            let sides = vec![Some([[0.5, 0.5, 0.5, 1.0]; 3]); map.side_count()];
            let boundary = Boundary { sides, sources: vec![source.clone()], ..Boundary::default() };
            let field = solver.solve(&boundary, Blend::Srgb).expect("a field");
            assert!(!field.triangles.is_empty());
            check(field.triangles.iter().flat_map(|triangle| triangle.colors), 0.0, &source);
            for size_px in [1, 16] {
                let px_from_du = Affine::scale(f64::from(size_px) / 1024.0);
                let view = View { px_from_du, width_px: size_px, height_px: size_px };
                let mut solver = GridSolver::new(&Constraints::new(&map, &boundary, &view).expect("solved"));
                solver.solve(1e-4);
                check(solver.pixels().into_iter(), 0.01, &source);
            }
        }
    }
}
