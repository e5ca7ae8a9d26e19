//! The triangles of a region, to be bisected.
//!
//! A triangle is bisected at its longest edge, together with its neighbour there (M.-C. Rivara, *New longest-edge
//! algorithms for the refinement and/or improvement of unstructured triangulations*, 1997). Angles stay above half the
//! smallest of the region.

use kurbo::Point;
use scumble_core::Triangulation;

use super::dofs::{Dofs, NONE, Unknowns};
use super::refine::{Refined, Shape};

/// A triangle of the finer mesh.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    /// The triangle of the region that it is a part of, by its index there.
    parent: u32,
    /// Where in that its corners are: the weights of that one's corners. Halves of halves, so all are exact.
    weights: [[f32; 3]; 3],
    pub(super) corners: [u32; 3],
    /// From corner `i` to corner `i + 1`.
    edges: [u32; 3],
    /// The one that follows in the region's order, in which halves stand where the whole stood.
    next: u32,
}

/// The weights of corners in themselves.
pub(super) const WHOLE: [[f32; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The one or two triangles at an edge of the finer mesh.
#[derive(Clone, Copy, Debug)]
struct Edge([u32; 2]);

#[derive(Clone, Debug)]
pub(super) struct Cells {
    pub(super) points: Vec<Point>,
    edges: Vec<Edge>,
    pub(super) cells: Vec<Cell>,
    /// Those that have come of bisections and have not been looked at.
    pub(super) open: Vec<u32>,
}

impl Cells {
    /// The region as it is.
    pub(super) fn new(mesh: &Triangulation, dofs: &Dofs) -> Self {
        let Dofs { triangles, unknowns, .. } = dofs;
        let (numbers, point_count) = numbers(unknowns);
        let number = |dof: u32| numbers[dof as usize];
        let mut points = vec![Point::ORIGIN; point_count];
        let mut edges = vec![Edge::NEW; unknowns.count - point_count];
        let mut cells = Vec::with_capacity(2 * triangles.len());
        for (i, (&t, &[a, b, c, ab, bc, ca])) in triangles.iter().zip(&unknowns.of_element).enumerate() {
            let (corners, borders) = ([a, b, c].map(number), [ab, bc, ca].map(number));
            let next = if i + 1 < triangles.len() { i as u32 + 1 } else { NONE };
            let cell = Cell { parent: i as u32, weights: WHOLE, corners, edges: borders, next };
            for (corner, p) in cell.corners.into_iter().zip(mesh.corners(t as usize)) {
                points[corner as usize] = p;
            }
            cell.edges.into_iter().for_each(|edge| edges[edge as usize].replace(NONE, i as u32));
            cells.push(cell);
        }
        Self { points, edges, cells, open: Vec::new() }
    }

    /// Bisects a triangle, or, first, a neighbour that has to be.
    pub(super) fn bisect(&mut self, mut i: u32) {
        loop {
            let edge = self.longest(i);
            let Edge([a, b]) = self.edges[edge as usize];
            let twin = if a == i { b } else { a };
            if twin == NONE || self.longest(twin) == edge {
                return self.split(edge);
            }
            i = twin;
        }
    }

    /// The longest edge of a triangle; of equal ones, one that its neighbour and any numbering agree on.
    fn longest(&self, i: u32) -> u32 {
        let Cell { corners, edges, .. } = self.cells[i as usize];
        let key = |k: usize| {
            let [a, b] =
                [corners[k], corners[(k + 1) % 3]].map(|corner| self.points[corner as usize].to_vec2());
            [(b - a).hypot2(), (a + b).x, (a + b).y]
        };
        let larger = |j: usize, k: usize| if key(k) > key(j) { k } else { j };
        edges[larger(larger(0, 1), 2)]
    }

    /// Bisects an edge and the triangles at it.
    fn split(&mut self, edge: u32) {
        let Edge(cells) = self.edges[edge as usize];
        let cell = self.cells[cells[0] as usize];
        let k = place(&cell, edge);
        let [start, end] = [cell.corners[k], cell.corners[(k + 1) % 3]];
        let middle = self.points.len() as u32;
        self.points.push(self.points[start as usize].midpoint(self.points[end as usize]));
        self.edges[edge as usize] = Edge::NEW;
        let halves = [edge, self.new_edge()];
        self.split_cell(cells[0], edge, middle, halves);
        if cells[1] != NONE {
            self.split_cell(cells[1], edge, middle, [halves[1], halves[0]]);
        }
    }

    fn new_edge(&mut self) -> u32 {
        self.edges.push(Edge::NEW);
        self.edges.len() as u32 - 1
    }

    /// Bisects a triangle at an edge of which the halves are given in its direction of turn.
    fn split_cell(&mut self, i: u32, edge: u32, middle: u32, halves: [u32; 2]) {
        let Cell { parent, weights, corners, edges, next } = self.cells[i as usize];
        let k = place(&self.cells[i as usize], edge);
        let [a, b, c] = [0, 1, 2].map(|j| corners[(k + j) % 3]);
        let [of_a, of_b, of_c] = [0, 1, 2].map(|j| weights[(k + j) % 3]);
        let of_middle = [0, 1, 2].map(|j| 0.5 * (of_a[j] + of_b[j]));
        let [bc, ca] = [1, 2].map(|j| edges[(k + j) % 3]);
        let across = self.new_edge();
        let new = self.cells.len() as u32;
        let halves_of_cell = [
            ([a, middle, c], [of_a, of_middle, of_c], [halves[0], across, ca], new),
            ([middle, b, c], [of_middle, of_b, of_c], [halves[1], bc, across], next),
        ];
        let [first, second] = halves_of_cell.map(|(corners, weights, edges, next)| Cell {
            parent,
            weights,
            corners,
            edges,
            next,
        });
        self.open.extend([i, new]);
        self.cells[i as usize] = first;
        self.cells.push(second);
        self.edges[bc as usize].replace(i, new);
        for (edge, cell) in [(halves[0], i), (halves[1], new), (across, i), (across, new)] {
            self.edges[edge as usize].replace(NONE, cell);
        }
    }

    /// The points are the unknowns at corners, the edges those in the middle of edges: each kind in the order of the cells, so
    /// that a mesh is the same in whatever order it was bisected.
    pub(super) fn refined(&self) -> Refined {
        let point_count = self.points.len() as u32;
        let mut numbers = [self.points.len(), self.edges.len()].map(|count| vec![NONE; count]);
        let mut next = [0, point_count];
        let mut number = |kind: usize, i: u32| {
            let number = &mut numbers[kind][i as usize];
            if *number == NONE {
                *number = next[kind];
                next[kind] += 1;
            }
            *number
        };
        let mut dofs = |cell: &Cell| {
            let [a, b, c] = cell.corners.map(|point| number(0, point));
            let [ab, bc, ca] = cell.edges.map(|edge| number(1, edge));
            [a, b, c, ab, bc, ca]
        };
        let dofs: Vec<_> = self.in_order().map(&mut dofs).collect();
        let shapes: Vec<_> = self.in_order().map(|cell| self.shape(cell)).collect();
        Refined::new(shapes, dofs, self.points.len() + self.edges.len())
    }

    fn in_order(&self) -> impl Iterator<Item = &Cell> {
        std::iter::successors(self.cells.first(), |cell| self.cells.get(cell.next as usize))
    }

    fn shape(&self, cell: &Cell) -> Shape {
        let side = |k: usize| u32::from(self.edges[cell.edges[k] as usize].is_side()) << k;
        Shape {
            parent: cell.parent,
            weights: cell.weights,
            corners: cell.corners.map(|i| self.points[i as usize]),
            side_edges: (0..3).map(side).sum(),
        }
    }
}

impl Edge {
    const NEW: Self = Self([NONE; 2]);

    fn is_side(&self) -> bool {
        self.0[1] == NONE
    }

    fn replace(&mut self, old: u32, new: u32) {
        if let Some(cell) = self.0.iter_mut().find(|cell| **cell == old) {
            *cell = new;
        }
    }
}

/// The numbers of a region's unknowns, those at corners and those in the middle of edges each from 0 on; and how many of
/// the former there are. They depend on the triangles alone.
fn numbers(unknowns: &Unknowns) -> (Vec<u32>, usize) {
    let mut numbers = vec![NONE; unknowns.count];
    let mut next = [0, 0];
    for (k, &dof) in unknowns.of_element.iter().flat_map(|dofs| dofs.iter().enumerate()) {
        if numbers[dof as usize] == NONE {
            numbers[dof as usize] = next[k / 3];
            next[k / 3] += 1;
        }
    }
    (numbers, next[0] as usize)
}

/// The place of an edge in a triangle.
fn place(cell: &Cell, edge: u32) -> usize {
    cell.edges.iter().position(|&e| e == edge).unwrap_or(0)
}
