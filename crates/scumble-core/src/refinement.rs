//! Further nodes for a triangulation, until angles and areas are as wanted: Delaunay refinement (P. Chew, *Guaranteed-quality
//! mesh generation for curved surfaces*, 1993; J. Ruppert, *A Delaunay refinement algorithm for quality 2-dimensional mesh
//! generation*, 1995).
//!
//! A node is added in the middle of the circle around each triangle that is not as wanted, but where it would come too close
//! to a piece: Ruppert's refinement splits the piece then, at acute corners without end; here it is kept, and the triangle.

use std::collections::VecDeque;

use kurbo::Rect;
use spade::handles::{FaceHandle, FixedDirectedEdgeHandle, FixedFaceHandle, FixedVertexHandle, InnerTag};
use spade::{CdtEdge, Point2, PositionInTriangulation, Triangulation as _};

use crate::angle::unit_vector;
use crate::delaunay::{Cdt, EdgeTag};
use crate::pace;

/// Smallest angles, in degrees, that refinement aims at, each for triangles from so many squares of the spacing of nodes along
/// curves on. The larger one lets triangles grow more slowly with their distance from the curves, where colours still change;
/// small triangles are too many for it. From 1.0 on, a mesh of half the width changes more than a level at a place of the
/// drawings that quality is measured on.
const REFINED_ANGLES_DEG: [(f64, f64); 2] = [(20.0, 0.0), (29.0, 0.96)];

/// Largest triangle of the refined mesh, in squares of the spacing of nodes along curves: 30 du from corner to corner
/// at the default spacing. Angles alone let triangles grow with their distance from the curves, whatever the
/// spacing, and the solver's error with them.
const REFINED_AREA: f64 = 25.0;

/// Adds nodes until angles and areas are as wanted, or there are many times as many.
pub(crate) async fn refine(cdt: &mut Cdt, frame: Rect, spacing_du: f64) {
    let square_du2 = spacing_du * spacing_du;
    let largest_du2 = REFINED_AREA * square_du2;
    let empty_page = 4.0 * frame.area() / largest_du2;
    for (angle_deg, least_area) in REFINED_ANGLES_DEG {
        let most_nodes = 11 * cdt.num_vertices() + empty_page as usize;
        let limit = 0.5 / unit_vector(angle_deg).y;
        let wanted = Wanted { limit2: limit * limit, least_du2: least_area * square_du2, largest_du2 };
        let mut refinement =
            Refinement { waiting: cdt.fixed_inner_faces().collect(), wanted, edges: Vec::new() };
        pace::repeat(|| cdt.num_vertices() < most_nodes && refinement.next(cdt).is_some()).await;
    }
}

/// Which triangles are as wanted.
#[derive(Clone, Copy, Debug)]
struct Wanted {
    /// The square of the largest ratio of the radius of the circle around a triangle and its shortest edge.
    limit2: f64,
    /// The area from which on that counts, in du².
    least_du2: f64,
    largest_du2: f64,
}

type Face<'a> = FaceHandle<'a, InnerTag, Point2<f64>, (), CdtEdge<EdgeTag>, ()>;

impl Wanted {
    fn is_met(&self, face: Face<'_>) -> bool {
        let area_du2 = face.area();
        if area_du2 > self.largest_du2 {
            return false;
        }
        if area_du2 < self.least_du2 {
            return true;
        }
        let [a, b, c] = face.positions();
        let squares = [a.distance_2(b), b.distance_2(c), c.distance_2(a)];
        let shortest2 = squares.into_iter().fold(f64::INFINITY, f64::min);
        // The product of all edges is four times the area times the radius of the circle.
        squares.into_iter().product::<f64>() <= 16.0 * area_du2 * area_du2 * shortest2 * self.limit2
    }
}

/// A refinement on its way.
#[derive(Debug)]
struct Refinement {
    /// Triangles to be looked at.
    waiting: VecDeque<FixedFaceHandle<InnerTag>>,
    wanted: Wanted,
    /// Edges to be looked at around a node that may be added.
    edges: Vec<FixedDirectedEdgeHandle>,
}

impl Refinement {
    /// Looks at the next triangle; `None` where there is none.
    fn next(&mut self, cdt: &mut Cdt) -> Option<()> {
        let face = cdt.face(self.waiting.pop_front()?);
        if self.wanted.is_met(face) {
            return Some(());
        }
        let (center, first) = (face.circumcenter(), face.vertices()[0].fix());
        if let Some(hint) = self.place(cdt, center, first).filter(|_| self.is_free(cdt, center))
            && let Ok(node) = cdt.insert_with_hint(center, hint)
        {
            self.waiting.extend(cdt.vertex(node).out_edges().filter_map(|edge| edge.face().fix().as_inner()));
        }
        Some(())
    }

    /// Finds the place of a node that may be added, with the edges around it, from a node near it; gives a node that is
    /// nearer. `None` off the page, on a piece, and where there is a node.
    fn place(&mut self, cdt: &Cdt, p: Point2<f64>, near: FixedVertexHandle) -> Option<FixedVertexHandle> {
        self.edges.clear();
        match cdt.locate_with_hint(p, near) {
            PositionInTriangulation::OnFace(face) => {
                let edges = cdt.face(face).adjacent_edges();
                self.edges.extend(edges.map(|edge| edge.fix()));
                Some(edges[0].from().fix())
            }
            PositionInTriangulation::OnEdge(edge) => {
                let edge = cdt.directed_edge(edge);
                let around = [edge, edge.rev()].map(|edge| [edge.next().fix(), edge.prev().fix()]);
                self.edges.extend(around.as_flattened());
                Some(edge.from().fix())
                    .filter(|_| !edge.is_constraint_edge() && !edge.is_part_of_convex_hull())
            }
            _ => None,
        }
    }

    /// Whether no piece that would be an edge opposite to a node at a place has it in the circle over itself.
    fn is_free(&mut self, cdt: &Cdt, p: Point2<f64>) -> bool {
        while let Some(edge) = self.edges.pop() {
            let edge = cdt.directed_edge(edge);
            let [from, to] = edge.positions();
            if edge.is_constraint_edge() || edge.is_part_of_convex_hull() {
                if is_in_circle_over([from, to], p) {
                    return false;
                }
            } else if edge.rev().opposite_position().is_some_and(|beyond| is_flipped(from, to, beyond, p)) {
                self.edges.extend([edge.rev().next().fix(), edge.rev().prev().fix()]);
            }
        }
        true
    }
}

fn is_in_circle_over([a, b]: [Point2<f64>; 2], p: Point2<f64>) -> bool {
    let middle = Point2::new(0.5 * (a.x + b.x), 0.5 * (a.y + b.y));
    p.distance_2(middle) < 0.25 * a.distance_2(b)
}

/// Whether an edge would be flipped for a node on its left: that lies in the circle around the triangle on its right.
fn is_flipped(from: Point2<f64>, to: Point2<f64>, beyond: Point2<f64>, p: Point2<f64>) -> bool {
    let coord = |p: Point2<f64>| robust::Coord { x: p.x, y: p.y };
    robust::incircle(coord(from), coord(to), coord(beyond), coord(p)) < 0.0
}
