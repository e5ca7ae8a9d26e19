//! The triangles of a region, to be bisected.
//!
//! A triangle is bisected at its longest edge, together with its neighbour there (M.-C. Rivara, *New longest-edge
//! algorithms for the refinement and/or improvement of unstructured triangulations*, 1997). Angles stay above half the
//! smallest of the region.

use kurbo::Point;
use scumble_core::Triangulation;

use super::dofs::{Dofs, NONE, Side};
use super::refine::{Refined, Shape};

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

#[derive(Clone, Debug)]
pub(super) struct Cells {
    pub(super) points: Vec<Point>,
    /// For each point its distance from the sides, in du, as the edges go: never less than it is.
    pub(super) side_du: Vec<f64>,
    edges: Vec<Edge>,
    pub(super) cells: Vec<Cell>,
}

impl Cells {
    /// The region as it is.
    pub(super) fn new(mesh: &Triangulation, dofs: &Dofs) -> Self {
        let (numbers, point_count) = numbers(dofs);
        let number = |dof: u32| numbers[dof as usize];
        let mut points = vec![Point::ORIGIN; point_count];
        let mut edges = vec![Edge::new(NONE, [0.0, 1.0]); dofs.count - point_count];
        let mut cells = Vec::with_capacity(2 * dofs.triangles.len());
        for (i, (&t, &[a, b, c, ab, bc, ca])) in dofs.triangles.iter().zip(&dofs.of_triangle).enumerate() {
            let cell = Cell { parent: t, corners: [a, b, c].map(number), edges: [ab, bc, ca].map(number) };
            for (corner, p) in cell.corners.into_iter().zip(mesh.corners(t as usize)) {
                points[corner as usize] = p;
            }
            cell.edges.into_iter().for_each(|edge| edges[edge as usize].replace(NONE, i as u32));
            cells.push(cell);
        }
        for (i, side) in (0..).zip(&dofs.sides) {
            edges[number(side.dofs[1]) as usize].side = i;
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
        self.edges[edge as usize].is_side()
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
        self.edges[edge as usize] = Edge::new(side, [part[0], half]);
        let halves = [edge, self.new_edge(Edge::new(side, [half, part[1]]))];
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

    fn new_edge(&mut self, edge: Edge) -> u32 {
        self.edges.push(edge);
        self.edges.len() as u32 - 1
    }

    /// Bisects a triangle at an edge of which the halves are given in its direction of turn.
    fn split_cell(&mut self, i: u32, edge: u32, middle: u32, halves: [u32; 2]) {
        let Cell { parent, corners, edges } = self.cells[i as usize];
        let k = place(&self.cells[i as usize], edge);
        let [a, b, c] = [0, 1, 2].map(|j| corners[(k + j) % 3]);
        let [bc, ca] = [1, 2].map(|j| edges[(k + j) % 3]);
        let across = self.new_edge(Edge::new(NONE, [0.0, 1.0]));
        let new = self.cells.len() as u32;
        self.cells[i as usize] = Cell { parent, corners: [a, middle, c], edges: [halves[0], across, ca] };
        self.cells.push(Cell { parent, corners: [middle, b, c], edges: [halves[1], bc, across] });
        self.edges[bc as usize].replace(i, new);
        for (edge, cell) in [(halves[0], i), (halves[1], new), (across, i), (across, new)] {
            self.edges[edge as usize].replace(NONE, cell);
        }
    }

    /// The points are the unknowns at corners, the edges those in the middle of edges.
    pub(super) fn refined(&self, coarse: &Dofs) -> Refined {
        let point_count = self.points.len() as u32;
        let mut dofs = Dofs {
            triangles: Vec::with_capacity(self.cells.len()),
            of_triangle: Vec::with_capacity(self.cells.len()),
            sides: Vec::with_capacity(2 * coarse.sides.len()),
            gaps: coarse.gaps.clone(),
            count: self.points.len() + self.edges.len(),
            group_ends: Vec::new(),
        };
        let mut shapes = Vec::with_capacity(self.cells.len());
        for cell in &self.cells {
            let [a, b, c] = cell.corners;
            let [ab, bc, ca] = cell.edges.map(|edge| point_count + edge);
            let corners = cell.corners.map(|i| self.points[i as usize]);
            let mut shape = Shape { corners, side_edges: 0 };
            for (k, side_dofs) in [[a, ab, b], [b, bc, c], [c, ca, a]].into_iter().enumerate() {
                let edge = &self.edges[cell.edges[k] as usize];
                shape.side_edges |= u32::from(edge.is_side()) << k;
                if let Some(side) = coarse.sides.get(edge.side as usize) {
                    dofs.sides.push(Side { id: side.id, part: edge.part, dofs: side_dofs });
                }
            }
            dofs.triangles.push(cell.parent);
            dofs.of_triangle.push([a, b, c, ab, bc, ca]);
            shapes.push(shape);
        }
        Refined { dofs, shapes }
    }
}

impl Edge {
    fn new(side: u32, part: [f64; 2]) -> Self {
        Self { cells: [NONE; 2], side, part }
    }

    fn is_side(&self) -> bool {
        self.cells[1] == NONE
    }

    fn replace(&mut self, old: u32, new: u32) {
        if let Some(cell) = self.cells.iter_mut().find(|cell| **cell == old) {
            *cell = new;
        }
    }
}

/// The numbers of a region's unknowns, those at corners and those in the middle of edges each from 0 on; and how many of
/// the former there are. They depend on the triangles alone.
fn numbers(dofs: &Dofs) -> (Vec<u32>, usize) {
    let mut numbers = vec![NONE; dofs.count];
    let mut next = [0, 0];
    for (k, &dof) in dofs.of_triangle.iter().flat_map(|dofs| dofs.iter().enumerate()) {
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
