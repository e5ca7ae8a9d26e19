//! A finer mesh of one region, where sources need it.
//!
//! Triangles are bisected at their longest edges, each together with its neighbour there (M.-C. Rivara, *New
//! longest-edge algorithms for the refinement and/or improvement of unstructured triangulations*, 1997). Angles stay
//! above half the smallest of the region, sizes pass gradually into each other, and triangles away from the sources
//! stay as they are. Nodes are none of the source's: the mesh changes little where a stroke moves a little.

use kurbo::Point;
use scumble_core::Triangulation;

use super::brush::Brush;
use super::dofs::{Dofs, Side};

/// No triangle, or no number yet.
const NONE: u32 = u32::MAX;

/// Triangles of the finest mesh of a region beyond those of the region itself: more detail than that is left out.
const MAX_FINER: usize = 60_000;

/// Longest edge under a stroke, in widths of the layer at its rim, `R (4 w)^(−1/4)`, in which the colour turns into that
/// of the source.
fn RIM_EDGE() -> f64 {
    std::env::var("RIM_EDGE").map_or(1.0, |v| v.parse().unwrap())
}

/// The same in radii, where the layer is wider.
fn LONGEST_EDGE() -> f64 {
    std::env::var("LONGEST_EDGE").map_or(0.35, |v| v.parse().unwrap())
}

/// Longest edge along the side of a curve, in widths of the layer there, `√(1 / strength)`.
fn LAYER_EDGE() -> f64 {
    std::env::var("LAYER_EDGE").map_or(1.0, |v| v.parse().unwrap())
}

/// What the longest edge grows by beyond the radius, for each du of distance.
fn GROWTH() -> f64 {
    std::env::var("GROWTH").map_or(0.5, |v| v.parse().unwrap())
}

/// No point of a triangle is further from its centroid than this part of its longest edge.
fn REACH() -> f64 { std::env::var("REACH").map_or(0.333, |v| v.parse().unwrap()) }

/// A triangle of the finer mesh.
#[derive(Clone, Copy, Debug)]
struct Cell {
    /// The triangle of the region that it is a part of.
    parent: u32,
    corners: [u32; 3],
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

/// The elements of a region, refined.
#[derive(Debug)]
pub(super) struct Refined {
    pub(super) dofs: Dofs,
    pub(super) shapes: Vec<Shape>,
}

/// Where an element is.
#[derive(Clone, Copy, Debug)]
pub(super) struct Shape {
    pub(super) corners: [Point; 3],
    /// Bit `i` is set where the edge from corner `i` to corner `i + 1` bounds the region.
    pub(super) side_edges: u32,
}

/// Refines a region for sources.
pub(super) fn refine(mesh: &Triangulation, dofs: &Dofs, brushes: &[Brush]) -> Refined {
    let mut coarsening = 1.0;
    loop {
        let mut cells = Cells::new(mesh, dofs);
        if cells.refine(brushes, coarsening) {
            return cells.refined(dofs);
        }
        coarsening *= 1.5;
    }
}

#[derive(Debug)]
struct Cells {
    points: Vec<Point>,
    /// For each point whether it is on a side.
    is_on_side: Vec<bool>,
    edges: Vec<Edge>,
    cells: Vec<Cell>,
    most: usize,
}

impl Cells {
    /// The region as it is. Its unknowns at corners are the points, those in the middle of edges the edges.
    fn new(mesh: &Triangulation, dofs: &Dofs) -> Self {
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
        let is_on_side = vec![false; points.len()];
        let most = cells.len() + MAX_FINER;
        let mut cells = Self { points, is_on_side, edges, cells, most };
        cells.mark_sides();
        cells
    }

    fn mark_sides(&mut self) {
        for cell in &self.cells {
            for k in 0..3 {
                if self.edges[cell.edges[k] as usize].cells[1] == NONE {
                    self.is_on_side[cell.corners[k] as usize] = true;
                    self.is_on_side[cell.corners[(k + 1) % 3] as usize] = true;
                }
            }
        }
    }

    /// Bisects all that is too large; `false` where that is too much.
    fn refine(&mut self, brushes: &[Brush], coarsening: f64) -> bool {
        for brush in brushes {
            let mut i = 0;
            while i < self.cells.len() {
                while self.is_too_large(i, brush, coarsening) {
                    if self.cells.len() >= self.most {
                        return false;
                    }
                    self.bisect(i);
                }
                i += 1;
            }
        }
        true
    }

    fn is_too_large(&self, i: usize, brush: &Brush, coarsening: f64) -> bool {
        let [a, b, c] = self.cells[i].corners.map(|corner| self.points[corner as usize]);
        let longest_du =
            [a - b, b - c, c - a].map(|edge| edge.hypot2()).into_iter().fold(0.0, f64::max).sqrt();
        let excess_du = longest_du - coarsening * rim_edge_du(brush);
        let is_at_side = self.is_at_side(i);
        // Beyond this distance from the stroke's rim the edges are short enough.
        let reach_du = excess_du.max(0.0) / GROWTH() + REACH() * longest_du;
        let middle = ((a.to_vec2() + b.to_vec2() + c.to_vec2()) / 3.0).to_point();
        if (excess_du <= 0.0 && !is_at_side) || !brush.bounds().inflate(reach_du, reach_du).contains(middle) {
            return false;
        }
        let far_du = brush.radius_du + reach_du;
        let near_du = (brush.distance_du(middle, far_du) - REACH() * longest_du).max(0.0);
        excess_du > GROWTH() * (near_du - brush.radius_du).max(0.0)
            || (is_at_side && longest_du > coarsening * layer_edge_du(brush, near_du))
    }

    fn is_at_side(&self, i: usize) -> bool {
        self.cells[i].corners.iter().any(|&corner| self.is_on_side[corner as usize])
    }

    fn is_side(&self, edge: u32) -> bool {
        self.edges[edge as usize].cells[1] == NONE
    }

    /// Bisects a triangle, or, first, a neighbour that has to be.
    fn bisect(&mut self, i: usize) {
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

    /// The longest edge of a triangle; of equal ones, the one that is so for its neighbour as well.
    fn longest(&self, i: u32) -> u32 {
        let Cell { corners, edges, .. } = self.cells[i as usize];
        let length_sq = |k: usize| {
            let [a, b] = [corners[k], corners[(k + 1) % 3]].map(|corner| self.points[corner as usize]);
            (b - a).hypot2()
        };
        let keys = [0, 1, 2].map(|k| (length_sq(k), edges[k]));
        let larger =
            |a: (f64, u32), b: (f64, u32)| if b.0 > a.0 || (b.0 == a.0 && b.1 > a.1) { b } else { a };
        larger(larger(keys[0], keys[1]), keys[2]).1
    }

    /// Bisects an edge and the triangles at it.
    fn split(&mut self, edge: u32) {
        let Edge { cells, side, part } = self.edges[edge as usize];
        let cell = self.cells[cells[0] as usize];
        let k = place(&cell, edge);
        let [start, end] = [cell.corners[k], cell.corners[(k + 1) % 3]];
        let middle = self.points.len() as u32;
        self.points.push(self.points[start as usize].midpoint(self.points[end as usize]));
        self.is_on_side.push(cells[1] == NONE);
        let half = 0.5 * (part[0] + part[1]);
        let halves = [[part[0], half], [half, part[1]]].map(|part| self.new_edge(side, part));
        self.split_cell(cells[0], edge, middle, halves);
        if cells[1] != NONE {
            self.split_cell(cells[1], edge, middle, [halves[1], halves[0]]);
        }
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
    fn refined(self, coarse: &Dofs) -> Refined {
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

/// Longest edge under a stroke.
fn rim_edge_du(brush: &Brush) -> f64 {
    brush.radius_du * (RIM_EDGE() / (4.0 * brush.weight).sqrt().sqrt()).min(LONGEST_EDGE())
}

/// Longest edge along a side at a distance from the stroke.
fn layer_edge_du(brush: &Brush, near_du: f64) -> f64 {
    LAYER_EDGE() / brush.strength_at(near_du * near_du).sqrt()
}
