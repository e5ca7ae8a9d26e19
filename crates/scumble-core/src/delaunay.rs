//! The constrained Delaunay triangulation of a planar map, and its refinement: all that is left to `spade`.

use kurbo::Rect;
use spade::handles::FixedVertexHandle;
use spade::{ConstrainedDelaunayTriangulation, Point2, RefinementParameters, Triangulation as _};

use crate::grading::graded;
use crate::planar_map::{MapError, Piece, Sampling};
use crate::sample::LatticePoint;
use crate::triangulation::{Edge, SideId, Triangulation};

pub(crate) type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>, (), EdgeTag>;

/// What an edge is.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) enum EdgeTag {
    #[default]
    Plain,
    Piece(u32),
    Gap(u32),
}

/// Smallest angles, in degrees, that refinement aims at, each for triangles from so many squares of the spacing of nodes along
/// curves on. The larger one lets triangles grow more slowly with their distance from the curves, where colours still change;
/// small triangles are too many for it.
const REFINED_ANGLES_DEG: [(f64, f64); 2] = [(20.0, 0.0), (29.0, 1.0)];

/// Largest triangle of the refined mesh, in squares of the spacing of nodes along curves: 30 du from corner to corner
/// at the default spacing. Angles alone let triangles grow with their distance from the curves, whatever the
/// spacing, and the solver's error with them.
const REFINED_AREA: f64 = 25.0;

/// The edges along a gap are this many times as long as the spacing of nodes along curves, at most: as one long edge
/// it would spoil the triangles beside it.
const GAP_COARSENING: f64 = 4.0;

/// `spade` refuses coordinates within 1e-43 of zero: it works on du + 1024, which is exact on the lattice.
const SHIFT_DU: f64 = 1024.0;

/// Triangulates pieces that meet only at nodes.
pub(crate) fn triangulate(nodes: &[LatticePoint], pieces: &[Piece]) -> Result<Cdt, MapError> {
    let vertices =
        nodes.iter().map(|node| node.to_point()).map(|p| Point2::new(p.x + SHIFT_DU, p.y + SHIFT_DU));
    let edges = pieces.iter().map(|piece| piece.nodes.map(|node| node as usize)).collect();
    let mut conflicts = 0;
    let mut cdt = Cdt::try_bulk_load_cdt(vertices.collect(), edges, |_| conflicts += 1)
        .map_err(|_| MapError::Triangulation)?;
    for (i, piece) in (0..).zip(pieces) {
        tag(&mut cdt, piece.nodes.map(vertex), EdgeTag::Piece(i)).ok_or(MapError::Triangulation)?;
    }
    let complete =
        conflicts == 0 && cdt.num_constraints() == pieces.len() && cdt.num_vertices() == nodes.len();
    complete.then_some(cdt).ok_or(MapError::Triangulation)
}

fn vertex(node: u32) -> FixedVertexHandle {
    FixedVertexHandle::from_index(node as usize)
}

/// Tags the edge between two vertices, if there is one.
fn tag(cdt: &mut Cdt, [a, b]: [FixedVertexHandle; 2], tag: EdgeTag) -> Option<()> {
    let edge = cdt.get_edge_from_neighbors(a, b)?.as_undirected().fix();
    *cdt.undirected_edge_data_mut(edge).data_mut() = tag;
    Some(())
}

/// Turns the gaps of the flat form of a triangulation into chains of edges that refinement keeps.
pub(crate) fn keep_gaps(cdt: &mut Cdt, mesh: &Triangulation, sampling: &Sampling) {
    for h in mesh.half_edges().filter(|&h| mesh.twin(h).is_some_and(|twin| h < twin)) {
        if let Some(gap) = mesh.gap(h) {
            keep_gap(cdt, mesh.ends(h).map(vertex), gap, sampling);
        }
    }
}

/// Gaps are edges of the triangulation, so that no constraint crosses them. Nodes on them lie in an empty circle:
/// the edges between are there already, but for rounding.
fn keep_gap(cdt: &mut Cdt, [start, end]: [FixedVertexHandle; 2], gap: u32, sampling: &Sampling) {
    let [a, b] = [start, end].map(|v| cdt.vertex(v).position());
    let length_du = kurbo::Vec2::new(b.x - a.x, b.y - a.y).hypot();
    let at_ends_du = [start, end].map(|v| shortest_piece_du(cdt, v).max(sampling.tip_du));
    let longest_du = GAP_COARSENING * sampling.spacing_du;
    let mut from = start;
    for t in graded(length_du, at_ends_du, longest_du).into_iter().skip(1) {
        let between = Point2::new(a.x + t * (b.x - a.x), a.y + t * (b.y - a.y));
        let to = if t < 1.0 { cdt.insert(between).unwrap_or(from) } else { end };
        if from != to {
            cdt.try_add_constraint(from, to);
            tag(cdt, [from, to], EdgeTag::Gap(gap));
        }
        from = to;
    }
}

fn shortest_piece_du(cdt: &Cdt, v: FixedVertexHandle) -> f64 {
    let edges = cdt.vertex(v).out_edges();
    let pieces = edges.filter(|edge| matches!(edge.as_undirected().data().data(), EdgeTag::Piece(_)));
    pieces.map(|edge| edge.length_2().sqrt()).fold(f64::INFINITY, f64::min)
}

/// Adds nodes until angles and areas are as wanted.
///
/// Ruppert's refinement would split the pieces at acute corners without end; it is told to keep them.
pub(crate) fn refine(cdt: &mut Cdt, frame: Rect, spacing_du: f64) {
    let square_du2 = spacing_du * spacing_du;
    let largest_du2 = REFINED_AREA * square_du2;
    let empty_page = 4.0 * frame.area() / largest_du2;
    for (angle_deg, least_area) in REFINED_ANGLES_DEG {
        let parameters = RefinementParameters::new()
            .keep_constraint_edges()
            .with_max_additional_vertices(10 * cdt.num_vertices() + empty_page as usize)
            .with_min_required_area(least_area * square_du2)
            .with_max_allowed_area(largest_du2)
            .with_angle_limit(spade::AngleLimit::from_deg(angle_deg));
        cdt.refine(parameters);
    }
}

/// The triangles of `spade`'s structure as flat arrays, in its order.
pub(crate) fn flatten(cdt: &Cdt, pieces: &[Piece]) -> Triangulation {
    let points = cdt.vertices().map(|v| v.position());
    let points = points.map(|p| kurbo::Point::new(p.x - SHIFT_DU, p.y - SHIFT_DU)).collect();
    let mut half_edge_of = vec![u32::MAX; cdt.num_directed_edges()];
    let edges = || cdt.inner_faces().flat_map(|face| face.adjacent_edges());
    for (h, edge) in edges().enumerate() {
        half_edge_of[edge.fix().index()] = h as u32;
    }
    Triangulation::from_half_edges(
        points,
        edges().map(|edge| {
            let from = edge.from().fix().index() as u32;
            let kind = match *edge.as_undirected().data().data() {
                EdgeTag::Plain => Edge::Plain,
                EdgeTag::Gap(gap) => Edge::Gap(gap),
                EdgeTag::Piece(i) => Edge::Side(SideId::of(i as usize, pieces[i as usize].nodes[0] != from)),
            };
            (from, half_edge_of[edge.rev().fix().index()], kind)
        }),
    )
}
