//! The triangles of a region, to be bisected.
//!
//! A triangle is bisected at its longest edge, together with its neighbour there (M.-C. Rivara, *New longest-edge
//! algorithms for the refinement and/or improvement of unstructured triangulations*, 1997). Angles stay above half the
//! smallest of the region.

use kurbo::Point;
use scumble_core::Triangulation;

use super::dofs::{Dofs, Side};
use super::refine::{Refined, Shape};

/// No triangle, or no number yet.
const NONE: u32 = u32::MAX;

/// A triangle of the finer mesh.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    /// The triangle of the region that it is a part of.
    parent: u32,
    pub(super) corners: [u32; 3],
    /// From corner `i` to corner `i + 1`.
    edges: [u32; 3],
}

/// An edge of the finer mesh.
#[derive(Clone, Copy, Debug)]
struct Edge {
    /// The one or two triangles at it.
    cells: [u32; 2],
    /// The side of the region that it is a part of, and the part.
    side: u32,
    part: [f64; 2],
}

#[derive(Debug)]
pub(super) struct Cells {
    pub(super) points: Vec<Point>,
    /// For each point its distance from the sides, in du, as the edges go: never less than it is.
    pub(super) side_du: Vec<f64>,
    edges: Vec<Edge>,
    pub(super) cells: Vec<Cell>,
}

impl Cells {
    /// The region as it is. Its unknowns at corners are the points, those in the middle of edges the edges.
    pub(super) fn new(mesh: &Triangulation, dofs: &Dofs) -> Self {
        let mut points = vec![Point::ORIGIN; dofs.count];
        let mut edges = vec![Edge { cells: [NONE; 2], side: NONE, part: [0.0, 1.0] }; dofs.count];
        let mut cells = Vec::with_capacity(2 * dofs.triangles.len());
        for (i, (&t, &[a, b, c, ab, bc, ca])) in dofs.triangles.iter().zip(&dofs.of_triangle).enumerate() {
            for (corner, p) in [a, b, c].into_iter().zip(mesh.corners(t as usize)) {
                points[corner as usize] = p;
            }
            [ab, bc, ca].into_iter().for_each(|edge| edges[edge as usize].replace(NONE, i as u32));
            cells.push(Cell { parent: t, corners: [a, b, c], edges: [ab, bc, ca] });
        }
        for (i, side) in (0..).zip(&dofs.sides) {
            edges[side.dofs[1] as usize].side = i;
        }
        let side_du = vec![f64::INFINITY; points.len()];
        let mut cells = Self { points, side_du, edges, cells };
        cells.find_sides();
        cells
    }

    /// Starts from the edges with one triangle, and goes over the triangles until nothing comes nearer.
    fn find_sides(&mut self) {
        for cell in &self.cells {
            for k in 0..3 {
                if self.is_side(cell.edges[k]) {
                    self.side_du[cell.corners[k] as usize] = 0.0;
                    self.side_du[cell.corners[(k + 1) % 3] as usize] = 0.0;
                }
            }
        }
        let mut is_changed = true;
        while is_changed {
            is_changed = false;
            for corners in self.cells.iter().map(|cell| cell.corners) {
                for k in 0..3 {
                    let [a, b] = [corners[k] as usize, corners[(k + 1) % 3] as usize];
                    let way_du = self.side_du[a] + self.points[a].distance(self.points[b]);
                    if way_du < self.side_du[b] {
                        self.side_du[b] = way_du;
                        is_changed = true;
                    }
                }
            }
        }
    }

    fn is_side(&self, edge: u32) -> bool {
        self.edges[edge as usize].cells[1] == NONE
    }

    /// Bisects a triangle, or, first, a neighbour that has to be.
    pub(super) fn bisect(&mut self, i: usize) {
        let mut i = i as u32;
        loop {
            let edge = self.longest(i);
            let [a, b] = self.edges[edge as usize].cells;
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
        let Edge { cells, side, part } = self.edges[edge as usize];
        let cell = self.cells[cells[0] as usize];
        let k = place(&cell, edge);
        let [start, end] = [cell.corners[k], cell.corners[(k + 1) % 3]];
        let middle = self.points.len() as u32;
        self.points.push(self.points[start as usize].midpoint(self.points[end as usize]));
        self.side_du.push(self.middle_side_du(edge, [start, end]));
        let half = 0.5 * (part[0] + part[1]);
        let halves = [[part[0], half], [half, part[1]]].map(|part| self.new_edge(side, part));
        self.split_cell(cells[0], edge, middle, halves);
        if cells[1] != NONE {
            self.split_cell(cells[1], edge, middle, [halves[1], halves[0]]);
        }
    }

    /// The distance of the middle of an edge from the sides.
    fn middle_side_du(&self, edge: u32, [start, end]: [u32; 2]) -> f64 {
        let [start, end] = [start as usize, end as usize];
        let half_du = 0.5 * self.points[start].distance(self.points[end]);
        if self.is_side(edge) { 0.0 } else { self.side_du[start].min(self.side_du[end]) + half_du }
    }

    fn new_edge(&mut self, side: u32, part: [f64; 2]) -> u32 {
        self.edges.push(Edge { cells: [NONE; 2], side, part });
        self.edges.len() as u32 - 1
    }

    /// Bisects a triangle at an edge of which the halves are given in its direction of turn.
    fn split_cell(&mut self, i: u32, edge: u32, middle: u32, halves: [u32; 2]) {
        let Cell { parent, corners, edges } = self.cells[i as usize];
        let k = place(&self.cells[i as usize], edge);
        let [a, b, c] = [0, 1, 2].map(|j| corners[(k + j) % 3]);
        let [bc, ca] = [1, 2].map(|j| edges[(k + j) % 3]);
        let across = self.new_edge(NONE, [0.0, 1.0]);
        let new = self.cells.len() as u32;
        self.cells[i as usize] = Cell { parent, corners: [a, middle, c], edges: [halves[0], across, ca] };
        self.cells.push(Cell { parent, corners: [middle, b, c], edges: [halves[1], bc, across] });
        self.edges[bc as usize].replace(i, new);
        for (edge, cell) in [(halves[0], i), (halves[1], new), (across, i), (across, new)] {
            self.edges[edge as usize].replace(NONE, cell);
        }
    }

    /// Numbers the unknowns.
    pub(super) fn refined(self, coarse: &Dofs) -> Refined {
        let mut next = 0;
        let (mut corner_dofs, mut edge_dofs) = (vec![NONE; self.points.len()], vec![NONE; self.edges.len()]);
        let mut number = |dof: &mut u32| {
            if *dof == NONE {
                *dof = next;
                next += 1;
            }
        };
        self.cells
            .iter()
            .flat_map(|cell| cell.corners)
            .for_each(|corner| number(&mut corner_dofs[corner as usize]));
        let corner_count = corner_dofs.iter().filter(|&&dof| dof != NONE).count();
        self.cells.iter().flat_map(|cell| cell.edges).for_each(|edge| number(&mut edge_dofs[edge as usize]));
        let of_cell = |cell: &Cell| {
            let ([a, b, c], [ab, bc, ca]) =
                (cell.corners.map(|i| corner_dofs[i as usize]), cell.edges.map(|i| edge_dofs[i as usize]));
            [a, b, c, ab, bc, ca]
        };
        let of_triangle: Vec<_> = self.cells.iter().map(of_cell).collect();
        let dofs = Dofs {
            triangles: self.cells.iter().map(|cell| cell.parent).collect(),
            sides: self.sides(coarse, &of_triangle),
            of_triangle,
            gaps: coarse.gaps.clone(),
            corner_count,
            count: next as usize,
        };
        let shape = |cell: &Cell| Shape {
            corners: cell.corners.map(|i| self.points[i as usize]),
            side_edges: (0..3).map(|k| u32::from(self.is_side(cell.edges[k])) << k).sum(),
        };
        Refined { dofs, shapes: self.cells.iter().map(shape).collect() }
    }

    fn sides(&self, coarse: &Dofs, of_triangle: &[[u32; 6]]) -> Vec<Side> {
        let mut sides = Vec::new();
        for (cell, dofs) in self.cells.iter().zip(of_triangle) {
            for k in 0..3 {
                let Edge { side, part, .. } = self.edges[cell.edges[k] as usize];
                if let Some(coarse) = coarse.sides.get(side as usize) {
                    sides.push(Side { id: coarse.id, part, dofs: [dofs[k], dofs[3 + k], dofs[(k + 1) % 3]] });
                }
            }
        }
        sides
    }
}

impl Edge {
    fn replace(&mut self, old: u32, new: u32) {
        if let Some(cell) = self.cells.iter_mut().find(|cell| **cell == old) {
            *cell = new;
        }
    }
}

/// The place of an edge in a triangle.
fn place(cell: &Cell, edge: u32) -> usize {
    cell.edges.iter().position(|&e| e == edge).unwrap_or(0)
}
