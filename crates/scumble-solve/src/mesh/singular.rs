//! The element at a corner where the solution is singular.
//!
//! Around a node, in a sector of angle ω, a solution goes as the distance to the power of π / ω where both sides of the sector
//! are coloured or neither is, and of π / (2 ω) where one is. Where that power is below one, quadratics follow it badly, and the
//! error spoils the picture far around: with a power of 1/4, at a tip with one coloured side, it falls with the root of the mesh
//! width only. There an element has the power among its functions (after J. E. Akin, *The generation of elements with
//! singularities*, 1976; M. Stern, E. B. Becker, *A conforming crack tip element with quadratic variation in the singular
//! fields*, 1978). With ρ from 0 at the corner to 1 at the edge opposite, and t along that edge, they are 1,
//! ρ^α (1, t), and ρ (1, t, t²): one for each of the six unknowns that any element has. Linear functions are among them, and
//! along the edges nothing depends on what lies inside, so neighbours fit.
//!
//! Where a line crosses another by little, the elements beside its tip are flat: the edge opposite is a side of the other line,
//! many times as long as the tip is far from it. If that side has no colour, the solution follows a logarithm along it as along
//! the edge beside it, and a quadratic there would hold back both. No neighbour asks for one, so such an edge is bisected.

use std::array;
use std::f64::consts::LN_2;

use kurbo::{Point, Vec2};
use scumble_core::angle_part;

use super::cholesky::joined;
use super::dofs::{Corner, Dofs, NONE, Side};
use super::element::{LEAST_FLATNESS, Matrix, entry};

/// Powers from this on are well enough followed by quadratics: those of sides that turn a little.
const REGULAR: f64 = 0.9;

/// The powers of the solution at the corners of a region that have a singular one, by the unknown there; one elsewhere.
#[derive(Debug)]
pub(super) struct Powers {
    of_unknown: Vec<f32>,
    /// By the unknown in the middle of an edge whether that is a side without a colour.
    is_bare: Vec<bool>,
}

/// The corner of an element where the solution is singular.
#[derive(Clone, Copy, Debug)]
pub(super) struct Singular {
    k: usize,
    power: f64,
    /// Whether the edge opposite is a side without a colour.
    is_bare: bool,
}

impl Powers {
    /// Those of a region of which some sides are coloured.
    pub(super) fn new(dofs: &Dofs, is_colored: &[bool]) -> Self {
        let count = dofs.unknowns.count;
        let mut powers = Self { of_unknown: vec![1.0; count], is_bare: vec![false; count] };
        let mut colored = vec![0_u8; count];
        for (Side { dofs: [start, middle, end], .. }, &is_colored) in dofs.sides.iter().zip(is_colored) {
            [start, end].into_iter().for_each(|&dof| colored[dof as usize] += u8::from(is_colored));
            powers.is_bare[*middle as usize] = !is_colored;
        }
        let mut ranks = vec![NONE; count];
        for (rank, corner) in (0..).zip(&dofs.corners) {
            let power = corner.power(colored[corner.dof as usize] == 1);
            if power < REGULAR {
                powers.of_unknown[corner.dof as usize] = power as f32;
                ranks[corner.dof as usize] = rank;
            }
        }
        powers.keep_apart(&dofs.unknowns.of_element, &ranks);
        powers
    }

    /// Of corners of one element only that of the least power stays, of equal ones the first: on an edge, both elements are to
    /// have the same functions.
    fn keep_apart(&mut self, elements: &[[u32; 6]], ranks: &[u32]) {
        let key = |&dof: &u32| (self.of_unknown[dof as usize].to_bits(), ranks[dof as usize]);
        let is_singular = |dof: &&u32| ranks[**dof as usize] != NONE;
        let mut dropped = Vec::new();
        for corners in elements.iter().map(|dofs| &dofs[..3]) {
            if corners.iter().filter(is_singular).count() > 1 {
                let least = corners.iter().map(key).min();
                dropped.extend(corners.iter().filter(is_singular).filter(|dof| Some(key(dof)) != least));
            }
        }
        dropped.into_iter().for_each(|dof: u32| self.of_unknown[dof as usize] = 1.0);
    }

    /// Where an element is singular, if it is.
    pub(super) fn of(&self, dofs: &[u32; 6]) -> Option<Singular> {
        let powers = [0, 1, 2].map(|i| self.of_unknown[dofs[i] as usize]);
        let k = powers.iter().position(|&power| power < 1.0)?;
        let opposite = dofs[3 + (k + 1) % 3];
        Some(Singular { k, power: powers[k].into(), is_bare: self.is_bare[opposite as usize] })
    }
}

impl Corner {
    /// The power of a solution, if one of two sides that are not alike has a colour, or else.
    fn power(&self, is_mixed: bool) -> f64 {
        let [first, last] = self.ways;
        let part = angle_part(first, last);
        let angle = if first.cross(last) > 0.0 { part } else { 2.0 - part };
        1.0 / if is_mixed { 2.0 * angle } else { angle }
    }
}

/// One of the five functions besides 1: the power of ρ, and for each place of a rule along the edge what it is to be multiplied
/// with and the slope of that.
type Function = (f64, [[f64; 2]; PLACES]);

/// Number of places of the rule along the edge: exact up to the fifth degree.
const PLACES: usize = 3;

/// Shorter edges are not bisected, in du: a corner may lie right on one.
const LEAST_EDGE_DU: f64 = 1e-3;

impl Singular {
    /// The matrix of Laplace's equation where the solution goes as a power of the distance from a corner. An edge opposite that
    /// has no colour is bisected as long as it is longer than the corner is far from the nearer of its ends.
    pub(super) fn stiffness(self, corners: [Point; 3]) -> Matrix {
        let [tip, a, b] = [0, 1, 2].map(|i| corners[(self.k + i) % 3]);
        let nearest2 = (a - tip).hypot2().min((b - tip).hypot2());
        if self.is_bare && (b - a).hypot2() > nearest2.max(LEAST_EDGE_DU * LEAST_EDGE_DU) {
            return self.bisected(corners);
        }
        stiffness(corners, self.k, self.power)
    }

    /// The same of two halves: where they meet on the edge opposite is the unknown in its middle. Those in the middle of its parts
    /// and between the halves are eliminated.
    fn bisected(self, corners: [Point; 3]) -> Matrix {
        let [a, b] = [1, 2].map(|i| (self.k + i) % 3);
        let half = |beyond: usize, own: usize, part: u32| {
            let (mut half, mut places) = (corners, [3, 4, 5, 6, 7, 8]);
            half[beyond] = corners[a].midpoint(corners[b]);
            (places[beyond], places[3 + a], places[3 + own]) = (places[3 + a], part, 2);
            (places, self.stiffness(half))
        };
        joined([half(b, b, 0), half(a, self.k, 1)])
    }
}

/// That of an element which is not bisected.
fn stiffness(corners: [Point; 3], k: usize, power: f64) -> Matrix {
    let turned = [0, 1, 2].map(|i| (k + i) % 3);
    let [tip, a, b] = turned.map(|i| corners[i]);
    let energies = energies([a - tip, b - a], power);
    let bend = 1.0 / (half_to(power) - 0.5);
    let unit = |i: usize| array::from_fn(|j| f64::from(u8::from(i == j)));
    let parts = [0, 1, 2, 3, 4, 5].map(|i| parts(unit(i), bend));
    let place = |i: usize| turned[i % 3] + i / 3 * 3;
    let mut matrix = [0.0; 21];
    for (i, j) in (0..6).flat_map(|i| (0..=i).map(move |j| (i, j))) {
        let products = (0..5).flat_map(|f| (0..5).map(move |g| (f, g)));
        matrix[entry(place(i), place(j))] =
            products.map(|(f, g)| parts[i][f] * energies[f][g] * parts[j][g]).sum();
    }
    matrix
}

/// How much of each of the five functions there is where the six unknowns have some values: at the corner, at the ends of the edge
/// opposite, and in the middle of the edges, from the corner on. (Six times in line it would be more for every visitor to load.)
#[inline(never)]
fn parts([tip, a, b, to_a, across, to_b]: [f64; 6], bend: f64) -> [f64; 5] {
    let [of_a, of_b] = [(a, to_a), (b, to_b)].map(|(end, middle)| bend * (middle - 0.5 * (end + tip)));
    [of_a, of_b, a - tip - of_a, across - tip - 0.5 * (of_a + of_b), b - tip - of_b]
}

/// The integrals of products of two functions' gradients, where the edge opposite begins so far from the corner and is so long.
fn energies([start, edge]: [Vec2; 2], power: f64) -> [[f64; 5]; 5] {
    let root = 0.15_f64.sqrt();
    let [places, weights] = [[0.5 - root, 0.5, 0.5 + root], [5.0 / 18.0, 4.0 / 9.0, 5.0 / 18.0]];
    let functions = functions(places, power);
    let longest2 = edge.hypot2().max(start.hypot2()).max((start + edge).hypot2());
    let area2 = start.cross(edge).max(LEAST_FLATNESS * longest2);
    functions.map(|(p, f)| {
        functions.map(|(q, g)| {
            let sum = (0..PLACES).map(|i| {
                let out = start + places[i] * edge;
                let along = p * f[i][0] * edge - f[i][1] * out;
                weights[i] * along.dot(q * g[i][0] * edge - g[i][1] * out)
            });
            sum.sum::<f64>() / ((p + q) * area2)
        })
    })
}

fn functions(places: [f64; PLACES], power: f64) -> [Function; 5] {
    [
        (power, places.map(|t| [1.0 - t, -1.0])),
        (power, places.map(|t| [t, 1.0])),
        (1.0, places.map(|t| [(1.0 - t) * (1.0 - 2.0 * t), 4.0 * t - 3.0])),
        (1.0, places.map(|t| [4.0 * t * (1.0 - t), 4.0 - 8.0 * t])),
        (1.0, places.map(|t| [t * (2.0 * t - 1.0), 4.0 * t - 1.0])),
    ]
}

/// A power of one half, by arithmetic alone: the library's own may differ from machine to machine.
fn half_to(power: f64) -> f64 {
    let x = -LN_2 * power;
    (1..=16).rev().fold(1.0, |sum, i| 1.0 + x / f64::from(i) * sum)
}

#[cfg(test)]
mod tests {
    use super::super::element;
    use super::*;

    /// A matrix applied to values, dotted with them.
    fn energy(matrix: &Matrix, values: [f64; 6]) -> f64 {
        let pairs = (0..6).flat_map(|i| (0..6).map(move |j| (i, j)));
        pairs.map(|(i, j)| matrix[entry(i, j)] * values[i] * values[j]).sum()
    }

    /// The values of a function at the six unknowns of a triangle.
    fn values(corners: [Point; 3], f: impl Fn(Point) -> f64) -> [f64; 6] {
        let middle = |i: usize| corners[i].midpoint(corners[(i + 1) % 3]);
        [0, 1, 2, 3, 4, 5].map(|i| f(if i < 3 { corners[i] } else { middle(i - 3) }))
    }

    #[test]
    fn linear_functions_have_the_energy_that_they_have_anywhere() {
        let corners = [(3.0, 1.0), (5.0, 2.0), (2.5, 4.0)].map(Point::from);
        for (k, power) in [(0, 0.25), (1, 0.5), (2, 0.7)] {
            let matrix = Singular { k, power, is_bare: false }.stiffness(corners);
            for f in [(|_| 7.0) as fn(Point) -> f64, |p| p.x, |p| p.x - 2.0 * p.y] {
                let values = values(corners, f);
                let found = energy(&matrix, values);
                let expected = energy(&element::stiffness(corners), values);
                assert!((found - expected).abs() < 1e-11, "{k} {power}: {found} {expected}");
            }
        }
    }

    #[test]
    fn energies_of_powers_are_exact() {
        for power in [0.25, 0.5, 2.0 / 3.0] {
            for k in 0..3 {
                let mut corners = [(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)].map(Point::from);
                corners.rotate_right(k);
                let matrix = Singular { k, power, is_bare: false }.stiffness(corners);
                let found = energy(&matrix, values(corners, |p| (p.x + p.y).powf(power)));
                assert!((found - power).abs() < 1e-12, "{k}: {found} for a power of {power}");
            }
        }
    }

    #[test]
    fn flat_triangles_have_finite_energies_that_are_not_negative() {
        for y in [0.0, -1e-12, 1e-12, 1e-300] {
            let corners = [Point::new(0.0, 0.0), Point::new(2.0, 0.0), Point::new(1.3, y)];
            for (k, is_bare) in (0..3).flat_map(|k| [(k, false), (k, true)]) {
                let matrix = Singular { k, power: 0.25, is_bare }.stiffness(corners);
                for f in [(|p| p.x) as fn(Point) -> f64, |p| p.x * p.x, |_| 1.0] {
                    assert!(energy(&matrix, values(corners, f)) >= -1e-6);
                }
            }
        }
    }

    #[test]
    fn behind_a_tip_a_bare_edge_follows_what_is_no_quadratic() {
        for k in 0..3 {
            let mut corners = [(0.0, 0.05), (0.0, 0.0), (4.0, 0.0)].map(Point::from);
            corners.rotate_right(k);
            let [whole, parts] =
                [false, true].map(|is_bare| Singular { k, power: 0.5, is_bare }.stiffness(corners));
            let along = values(corners, |p| 3.0 * p.x);
            // Nothing flows out of it: nothing has less energy.
            assert!((energy(&parts, along) - 0.9).abs() < 1e-9);
            // About what a needle has beside it.
            let potential = values(corners, |p| (p.x / 0.05).asinh());
            let energies = [whole, parts].map(|matrix| energy(&matrix, potential));
            assert!(energies[1] < 0.05 * energies[0], "{k}: {energies:?}");
        }
    }

    #[test]
    fn a_power_of_one_half_is_the_librarys() {
        for power in [0.0, 0.25, 0.5, 0.9, 1.0] {
            assert!((half_to(power) - 0.5_f64.powf(power)).abs() < 1e-15, "{power}");
        }
    }

    #[test]
    fn powers_are_those_of_angles_and_of_kinds_of_sides() {
        let corner = |degrees: f64| Corner {
            dof: 0,
            ways: [Vec2::new(3.0, 0.0), Vec2::from_angle(degrees.to_radians())],
        };
        for (degrees, alike, mixed) in [(360.0, 0.5, 0.25), (180.0, 1.0, 0.5), (270.0, 2.0 / 3.0, 1.0 / 3.0)]
        {
            let powers = [false, true].map(|is_mixed| corner(degrees).power(is_mixed));
            assert!((powers[0] - alike).abs() < 1e-4 && (powers[1] - mixed).abs() < 1e-4, "{powers:?}");
        }
    }

    #[test]
    fn of_neighbours_the_worse_is_singular_and_of_equals_the_first() {
        let elements = [[0, 1, 2, 9, 9, 9], [1, 3, 4, 9, 9, 9], [5, 4, 3, 9, 9, 9]];
        let kept = |of_unknown: [f32; 6], ranks: [u32; 6]| {
            let mut powers = Powers { of_unknown: of_unknown.to_vec(), is_bare: Vec::new() };
            powers.keep_apart(&elements, &ranks);
            powers.of_unknown
        };
        let found = kept([0.25, 0.5, 1.0, 1.0, 0.75, 1.0], [0, 1, NONE, NONE, 2, NONE]);
        assert_eq!(found, [0.25, 1.0, 1.0, 1.0, 1.0, 1.0]);
        let found = kept([1.0, 1.0, 1.0, 0.5, 0.5, 0.5], [NONE, NONE, NONE, 2, 1, 0]);
        assert_eq!(found, [1.0, 1.0, 1.0, 1.0, 1.0, 0.5]);
    }
}
