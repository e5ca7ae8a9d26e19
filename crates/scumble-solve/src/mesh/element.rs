//! The quadratic element for Laplace's equation on a straight triangle.
//!
//! Its stiffness matrix depends on the three cotangents alone. With `w` half the cotangent of the angle opposite
//! an edge, two ends of the edge are coupled by `w / 3`, an end and the middle by `−4 w / 3`, and the middles of
//! the two other edges by `−8 w / 3`; a corner and the middle of the opposite edge are not coupled at all.

use kurbo::Point;

/// Twice the area of a triangle is taken to be at least this times the square of its longest edge, so that
/// triangles without area neither overflow nor drown the others in rounding.
const LEAST_FLATNESS: f64 = 1e-6;

/// Half the cotangents of the angles opposite edges 01, 12, 20.
pub(super) fn weights(corners: [Point; 3]) -> [f64; 3] {
    let edges = [0, 1, 2].map(|i| corners[(i + 1) % 3] - corners[i]);
    let longest2 = edges.iter().map(|edge| edge.hypot2()).fold(0.0, f64::max);
    let area2 = edges[0].cross(edges[1]).max(LEAST_FLATNESS * longest2);
    [0, 1, 2].map(|i| -0.5 * edges[(i + 1) % 3].dot(edges[(i + 2) % 3]) / area2)
}

/// The entries on the diagonal, for the unknowns in the order of [`super::dofs::Dofs::of_triangle`].
pub(super) fn diagonal([a, b, c]: [f64; 3]) -> [f64; 6] {
    let middle = 8.0 / 3.0 * (a + b + c);
    [c + a, a + b, b + c, middle, middle, middle]
}

/// The entries off the diagonal: two unknowns of the triangle and what couples them.
pub(super) fn couplings(weights: [f64; 3]) -> [(usize, usize, f64); 12] {
    let mut couplings = [(0, 0, 0.0); 12];
    for (i, (w, four)) in weights.into_iter().zip(couplings.as_chunks_mut::<4>().0).enumerate() {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        *four = [
            (i, j, w / 3.0),
            (i, 3 + i, -4.0 / 3.0 * w),
            (j, 3 + i, -4.0 / 3.0 * w),
            (3 + j, 3 + k, -8.0 / 3.0 * w),
        ];
    }
    couplings
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
        let values = nodes.map(f);
        let weights = weights(corners);
        let diagonal: f64 = diagonal(weights).iter().zip(values).map(|(k, v)| k * v * v).sum();
        let off: f64 = couplings(weights).iter().map(|&(i, j, k)| 2.0 * k * values[i] * values[j]).sum();
        diagonal + off
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
