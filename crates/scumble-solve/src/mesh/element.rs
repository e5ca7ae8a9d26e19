//! The quadratic element for Laplace's equation, and for what sources add to it, on a straight triangle.
//!
//! Its stiffness matrix depends on the three cotangents alone. With `w` half the cotangent of the angle opposite
//! an edge, two ends of the edge are coupled by `w / 3`, an end and the middle by `−4 w / 3`, and the middles of
//! the two other edges by `−8 w / 3`; a corner and the middle of the opposite edge are not coupled at all.

use kurbo::Point;

use crate::quadratic;

/// Twice the area of a triangle is taken to be at least this times the square of its longest edge, so that
/// triangles without area neither overflow nor drown the others in rounding.
pub(super) const LEAST_FLATNESS: f64 = 1e-6;

/// Half the cotangents of the angles opposite edges 01, 12, 20.
fn weights(corners: [Point; 3]) -> [f64; 3] {
    let edges = [0, 1, 2].map(|i| corners[(i + 1) % 3] - corners[i]);
    let longest2 = edges.iter().map(|edge| edge.hypot2()).fold(0.0, f64::max);
    let area2 = edges[0].cross(edges[1]).max(LEAST_FLATNESS * longest2);
    [0, 1, 2].map(|i| -0.5 * edges[(i + 1) % 3].dot(edges[(i + 2) % 3]) / area2)
}

/// A symmetric matrix for the six unknowns of a triangle, in the order of [`super::dofs::Unknowns::of_element`]: its lower
/// half, column by column.
pub(super) type Matrix = [f64; 21];

/// Where the entry of a row and a column is.
pub(super) const fn entry(row: usize, column: usize) -> usize {
    let [least, most] = if row < column { [row, column] } else { [column, row] };
    least * 6 - least * (least + 1) / 2 + most
}

/// The matrix of Laplace's equation.
pub(super) fn stiffness(corners: [Point; 3]) -> Matrix {
    let mut matrix = [0.0; 21];
    let weights = weights(corners);
    let middle = 8.0 / 3.0 * (weights[0] + weights[1] + weights[2]);
    for i in 0..3 {
        let (j, k, w) = ((i + 1) % 3, (i + 2) % 3, weights[i]);
        matrix[entry(i, i)] = w + weights[k];
        matrix[entry(3 + i, 3 + i)] = middle;
        matrix[entry(i, j)] = w / 3.0;
        matrix[entry(i, 3 + i)] = -4.0 / 3.0 * w;
        matrix[entry(j, 3 + i)] = -4.0 / 3.0 * w;
        matrix[entry(3 + j, 3 + k)] = -8.0 / 3.0 * w;
    }
    matrix
}

/// Number of places at which a rule needs values.
pub(super) const PLACES: usize = 7;

/// A rule for integrals over a triangle, exact up to the fifth degree (J. Radon, 1948).
#[derive(Debug)]
pub(super) struct Quadrature {
    points: [QuadraturePoint; PLACES],
}

#[derive(Clone, Copy, Debug)]
struct QuadraturePoint {
    /// Barycentric coordinates.
    place: [f64; 3],
    /// The six functions there, times the part of the area that the point stands for.
    functions: [f64; 6],
    /// The products of two of them, likewise.
    products: Matrix,
}

impl Quadrature {
    pub(super) fn new() -> Self {
        let root = 15_f64.sqrt();
        let triple = |s: f64| {
            let (a, part) = ((6.0 + s * root) / 21.0, (155.0 + s * root) / 1200.0);
            let b = 1.0 - 2.0 * a;
            [[b, a, a], [a, b, a], [a, a, b]].map(|place| QuadraturePoint::new(place, part))
        };
        let ([a, b, c], [d, e, f]) = (triple(1.0), triple(-1.0));
        Self { points: [QuadraturePoint::new([1.0 / 3.0; 3], 9.0 / 40.0), a, b, c, d, e, f] }
    }

    /// The places at which it needs values.
    pub(super) fn places(&self, corners: [Point; 3]) -> [Point; PLACES] {
        let [a, b, c] = corners.map(Point::to_vec2);
        self.points.map(|QuadraturePoint { place: [u, v, w], .. }| (u * a + v * b + w * c).to_point())
    }

    /// The integrals of products of two of the six functions, times a factor that depends on the place.
    pub(super) fn mass(&self, corners: [Point; 3], factors: &[f64; PLACES]) -> Matrix {
        self.sum(corners, factors, |point| &point.products)
    }

    /// The integrals of the six functions, times a factor that depends on the place.
    pub(super) fn load(&self, corners: [Point; 3], factors: &[f64; PLACES]) -> [f64; 6] {
        self.sum(corners, factors, |point| &point.functions)
    }

    fn sum<const COUNT: usize>(
        &self,
        [a, b, c]: [Point; 3],
        factors: &[f64; PLACES],
        values: impl Fn(&QuadraturePoint) -> &[f64; COUNT],
    ) -> [f64; COUNT] {
        let area = 0.5 * (b - a).cross(c - a);
        let mut sums = [0.0; COUNT];
        for (point, factor) in self.points.iter().zip(factors) {
            let scale = area * factor;
            sums.iter_mut().zip(values(point)).for_each(|(sum, value)| *sum += scale * value);
        }
        sums
    }
}

impl QuadraturePoint {
    fn new(place: [f64; 3], part: f64) -> Self {
        let shape = quadratic::triangle(place);
        let mut products = [0.0; 21];
        for (i, j) in (0..6).flat_map(|i| (0..=i).map(move |j| (i, j))) {
            products[entry(i, j)] = part * shape[i] * shape[j];
        }
        Self { place, functions: shape.map(|f| part * f), products }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The matrix applied to the values of a function at the six nodes, dotted with them: the integral of its
    /// squared gradient.
    fn energy(corners: [Point; 3], f: impl Fn(Point) -> f64) -> f64 {
        let nodes = [0, 1, 2, 3, 4, 5].map(|i| match i {
            0..3 => corners[i],
            _ => corners[i % 3].midpoint(corners[(i + 1) % 3]),
        });
        dotted(&stiffness(corners), nodes.map(f))
    }

    /// A matrix applied to values, dotted with them.
    fn dotted(matrix: &Matrix, values: [f64; 6]) -> f64 {
        let pairs = (0..6).flat_map(|i| (0..6).map(move |j| (i, j)));
        pairs.map(|(i, j)| matrix[entry(i, j)] * values[i] * values[j]).sum()
    }

    #[test]
    fn energies_of_quadratics_are_exact() {
        let corners = [Point::new(0.0, 0.0), Point::new(2.0, 0.0), Point::new(0.0, 1.0)];
        for (f, exact) in [
            ((|_| 7.0) as fn(Point) -> f64, 0.0),
            (|p| p.x, 1.0),
            (|p| p.x - 2.0 * p.y, 5.0),
            (|p| p.x * p.x, 8.0 / 3.0),
            (|p| p.x * p.y, 5.0 / 6.0),
        ] {
            assert!((energy(corners, f) - exact).abs() < 1e-12, "{} {exact}", energy(corners, f));
        }
    }

    #[test]
    fn products_of_quadratics_are_integrated_exactly() {
        let corners = [Point::new(0.0, 0.0), Point::new(2.0, 0.0), Point::new(0.0, 1.0)];
        let nodes = [(0.0, 0.0), (2.0, 0.0), (0.0, 1.0), (1.0, 0.0), (1.0, 0.5), (0.0, 0.5)].map(Point::from);
        let integral = |f: fn(Point) -> f64, factor: f64| {
            dotted(&Quadrature::new().mass(corners, &[factor; PLACES]), nodes.map(f))
        };
        assert!((integral(|_| 1.0, 3.0) - 3.0).abs() < 1e-14);
        assert!((integral(|p| p.x, 1.0) - 2.0 / 3.0).abs() < 1e-14);
        assert!((integral(|p| p.x * p.x, 1.0) - 32.0 / 30.0).abs() < 1e-14);
        assert!((integral(|p| p.x * p.y, 1.0) - 4.0 / 90.0).abs() < 1e-14);
        let rule = Quadrature::new();
        let cubic: f64 = rule.load(corners, &rule.places(corners).map(|p| p.x * p.y * p.y)).iter().sum();
        assert!((cubic - 1.0 / 15.0).abs() < 1e-14);
    }

    #[test]
    fn flat_triangles_have_finite_weights_and_no_negative_energy() {
        for y in [0.0, -1e-12, 1e-12, 1e-300] {
            let corners = [Point::new(0.0, 0.0), Point::new(2.0, 0.0), Point::new(1.3, y)];
            assert!(weights(corners).iter().all(|w| w.is_finite()));
            for f in [(|p| p.x) as fn(Point) -> f64, |p| p.x * p.x, |_| 1.0] {
                assert!(energy(corners, f) >= -1e-6);
            }
        }
    }
}
