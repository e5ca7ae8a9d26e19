//! A problem with a known answer, solved by either solver.

use kurbo::{Affine, BezPath, Point, Rect, Vec2};
use scumble_core::{Bends, Blend, Boundary, Curve, Drawing, PlanarMap, Sampling};
use scumble_solve::grid::{AROUND_PX, Constraints, GridSolver, Shades, Whole};
use scumble_solve::{Field, FieldTriangle, MeshSolver, View};

use super::DEFAULT_DU;

/// Length of the page's sides.
const PAGE_DU: f64 = 1024.0;

/// Distance of nodes for the grid solver: so small that chords matter less than pixels.
const GRID_DU: f64 = 3.0;

/// Curves on a page, the colours of their sides, and the values in between.
///
/// Both functions take a point and another one to the side of it that is meant, for points on a curve where the
/// value jumps.
pub(crate) struct Problem<'a> {
    pub(crate) curves: Vec<BezPath>,
    /// The value along a side of a curve (0, 1, …); `None` for no colour.
    pub(crate) side: &'a dyn Fn(usize, Point, Point) -> Option<f64>,
    pub(crate) exact: &'a dyn Fn(Point, Point) -> f64,
}

impl Problem<'_> {
    pub(crate) fn solve(&self, spacing_du: f64) -> Field {
        let map = self.map(spacing_du);
        let mut solver = MeshSolver::new(map.refined().clone());
        solver.solve(&self.boundary(&map), Blend::Srgb).expect("a field").clone()
    }

    fn map(&self, spacing_du: f64) -> PlanarMap {
        let curves = self.curves.iter().map(|path| Curve { path: path.clone(), line: None }).collect();
        let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, PAGE_DU, PAGE_DU)) };
        let scale = spacing_du / DEFAULT_DU;
        let [tip_du, chord_du] =
            [Sampling::default().tip_du, Sampling::default().chord_du].map(|du| du * scale);
        PlanarMap::build(&drawing, &Sampling { spacing_du, tip_du, chord_du }).expect("a map")
    }

    fn boundary(&self, map: &PlanarMap) -> Boundary {
        let mut colors = vec![None; map.side_count()];
        for curve in 0..map.curve_count() {
            for side in map.steps(curve).iter().flat_map(|step| [step.left, step.left.opposite()]) {
                let [a, b] = map.ends(side).map(|node| map.triangulation().points()[node as usize]);
                let left = a.midpoint(b) + Vec2::new(a.y - b.y, b.x - a.x) * 0.1;
                let [start, middle, end] = [a, a.midpoint(b), b].map(|at| (self.side)(curve, at, left));
                colors[side.index()] = start
                    .zip(middle)
                    .zip(end)
                    .map(|((start, middle), end)| [start, middle, end].map(|v| [v, v, v, 1.0]));
            }
        }
        colors.into()
    }

    /// The largest error at the nodes of the field and at points within its triangles.
    pub(crate) fn largest_error(&self, spacing_du: f64) -> f64 {
        self.largest_error_where(spacing_du, |_| true)
    }

    pub(crate) fn largest_error_where(&self, spacing_du: f64, place: impl Fn(Point) -> bool) -> f64 {
        let field = self.solve(spacing_du);
        assert!(!field.triangles.is_empty());
        let error = |triangle: &FieldTriangle| {
            let inside = at(triangle, [1.0 / 3.0; 3]);
            let samples = samples(triangle).into_iter().filter(|(p, _)| place(*p));
            samples.map(|(p, value)| 255.0 * (value - (self.exact)(p, inside)).abs()).fold(0.0, f64::max)
        };
        field.triangles.iter().map(error).fold(0.0, f64::max)
    }

    /// Checks that the error falls to this part of itself, or less, each time the mesh width is halved.
    pub(crate) fn assert_falls(&self, spacings_du: &[f64], part: f64) {
        let errors: Vec<_> = spacings_du.iter().map(|&spacing_du| self.largest_error(spacing_du)).collect();
        assert!(errors.windows(2).all(|pair| pair[1] <= part * pair[0]), "{errors:?}");
    }

    /// The values that the grid solver gives the pixels that get a colour, with the places of their centres.
    pub(crate) fn solve_grid(&self, size_px: u32) -> Vec<(Point, f64)> {
        let map = self.map(GRID_DU);
        let (boundary, view) = (self.boundary(&map), page(size_px));
        let constraints = Constraints::new(&map, &boundary, &view).expect("solved");
        values(&solved(&constraints.fitted(&map, &Bends::default(), &boundary, &view)), &view)
    }

    /// The largest error of the grid solver in a part of a page of so many pixels: those pixels around a place in which nothing
    /// is seen of its borders, so many times smaller.
    pub(crate) fn largest_error_in_part(&self, size_px: u32, times: f64, middle: Point) -> f64 {
        let map = self.map(GRID_DU);
        let (boundary, view) = (self.boundary(&map), page(size_px));
        let constraints = Constraints::new(&map, &boundary, &view).expect("solved");
        let straight = &Bends::default();
        let pixels = solved(&constraints.fitted(&map, straight, &boundary, &view));
        let whole = Whole::new(&map, straight, &boundary, &view, pixels);

        let px_from_du = view.px_from_du.then_scale(times);
        let half_px = Vec2::new(f64::from(size_px), f64::from(size_px)) / 2.0;
        let px_from_du = px_from_du.then_translate(half_px - (px_from_du * middle).to_vec2());
        let part = View { px_from_du, ..view };
        let constraints = Constraints::within(&whole, &map, straight, &boundary, &Shades::default(), &part);
        let pixels = values(&solved(&constraints.fitted(&map, straight, &boundary, &part)), &part);
        let inner_du = (half_px.x - AROUND_PX * times) / px_from_du.as_coeffs()[0];
        let inner = Rect::from_center_size(middle, (2.0 * inner_du, 2.0 * inner_du));
        let there = pixels.into_iter().filter(|(p, _)| inner.contains(*p));
        let errors: Vec<_> = there.map(|(p, value)| 255.0 * (value - (self.exact)(p, p)).abs()).collect();
        assert!(!errors.is_empty());
        errors.into_iter().fold(0.0, f64::max)
    }

    /// The largest error of the grid solver at places.
    pub(crate) fn largest_grid_error(&self, size_px: u32, place: impl Fn(Point) -> bool) -> f64 {
        self.grid_errors(size_px, place).into_iter().fold(0.0, f64::max)
    }

    /// The errors of the grid solver at places.
    pub(crate) fn grid_errors(&self, size_px: u32, place: impl Fn(Point) -> bool) -> Vec<f64> {
        let pixels = self.solve_grid(size_px);
        assert!(!pixels.is_empty());
        let there = pixels.into_iter().filter(|(p, _)| place(*p));
        there.map(|(p, value)| 255.0 * (value - (self.exact)(p, p)).abs()).collect()
    }
}

/// The page on so many pixels.
fn page(size_px: u32) -> View {
    let px_from_du = Affine::scale(f64::from(size_px) / PAGE_DU);
    View { px_from_du, width_px: size_px, height_px: size_px }
}

fn solved(constraints: &Constraints) -> Vec<[f32; 4]> {
    let mut solver = GridSolver::new(constraints);
    solver.solve(1e-5);
    solver.pixels()
}

/// The values of the pixels that have a colour, with the places of their centres.
fn values(pixels: &[[f32; 4]], view: &View) -> Vec<(Point, f64)> {
    let width = view.width_px;
    let center = |i: u32| Point::new(f64::from(i % width) + 0.5, f64::from(i / width) + 0.5);
    let colored = (0..).zip(pixels).filter(|(_, pixel)| pixel[3] > 0.5);
    colored.map(|(i, pixel)| (view.px_from_du.inverse() * center(i), f64::from(pixel[0]))).collect()
}

/// The value of a triangle at its corners, in the middle of its edges, and at ten points between.
fn samples(triangle: &FieldTriangle) -> Vec<(Point, f64)> {
    let mut weights = vec![[1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0]];
    for [a, b, c] in [[0, 1, 2], [1, 2, 0], [2, 0, 1]] {
        for (wa, wb, wc) in [(1.0, 0.0, 0.0), (0.5, 0.5, 0.0), (0.75, 0.125, 0.125), (0.625, 0.375, 0.0)] {
            let mut weight = [0.0; 3];
            (weight[a], weight[b], weight[c]) = (wa, wb, wc);
            weights.push(weight);
        }
    }
    weights.into_iter().map(|weight| (at(triangle, weight), value(triangle, weight))).collect()
}

pub(crate) fn at(triangle: &FieldTriangle, weight: [f64; 3]) -> Point {
    let corners = triangle.corners.map(|[x, y]| Vec2::new(x.into(), y.into()));
    (weight[0] * corners[0] + weight[1] * corners[1] + weight[2] * corners[2]).to_point()
}

/// The value at a place that a triangle of the field has within it or on its edges.
pub(crate) fn value_at(field: &Field, p: Point) -> f64 {
    let weights = |triangle: &FieldTriangle| {
        let [a, b, c] =
            [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|corner| at(triangle, corner));
        let whole = (b - a).cross(c - a);
        [(c - b).cross(p - b), (a - c).cross(p - c), (b - a).cross(p - a)].map(|part| part / whole)
    };
    let mut holders = field.triangles.iter().map(|triangle| (triangle, weights(triangle)));
    let (triangle, weights) =
        holders.find(|(_, weights)| weights.iter().all(|w| *w >= 0.0)).expect("a place in it");
    value(triangle, weights)
}

fn value(triangle: &FieldTriangle, [a, b, c]: [f64; 3]) -> f64 {
    let shape = [
        a * (2.0 * a - 1.0),
        b * (2.0 * b - 1.0),
        c * (2.0 * c - 1.0),
        4.0 * a * b,
        4.0 * b * c,
        4.0 * c * a,
    ];
    shape.iter().zip(triangle.colors).map(|(shape, color)| shape * f64::from(color[0])).sum()
}
