//! The constrained Delaunay triangulation of a planar map: what is left to `spade`.

use spade::handles::FixedVertexHandle;
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation as _};

use crate::grading::graded;
use crate::pace;
use crate::planar_map::{MapError, Piece, Sampling};
use crate::sample::LatticePoint;
use crate::triangulation::{Edge, HalfEdge, SideId, Triangulation};

pub(crate) type Cdt = ConstrainedDelaunayTriangulation<Point2<f64>, (), EdgeTag>;

/// What an edge is.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) enum EdgeTag {
    #[default]
    Plain,
    Piece(u32),
    Gap(u32),
}

/// The edges along a gap are this many times as long as the spacing of nodes along curves, at most: as one long edge
/// it would spoil the triangles beside it.
const GAP_COARSENING: f64 = 4.0;

/// `spade` refuses coordinates within 1e-43 of zero: it works on du + 1024, which is exact on the lattice.
const SHIFT_DU: f64 = 1024.0;

/// Triangulates pieces that meet only at nodes, which are added one by one: each should lie near the one before it.
pub(crate) async fn triangulate(nodes: &[LatticePoint], pieces: &[Piece]) -> Result<Cdt, MapError> {
    let mut cdt = Cdt::with_capacity(nodes.len(), 3 * nodes.len(), 2 * nodes.len());
    let mut is_complete = true;
    pace::for_each((0..).zip(nodes), |(node, place)| is_complete &= add(&mut cdt, node, *place).is_some())
        .await;
    if !is_complete {
        return Err(MapError::Triangulation);
    }
    pace::for_each((0..).zip(pieces), |(i, piece)| is_complete &= constrain(&mut cdt, i, piece).is_some())
        .await;
    is_complete &= cdt.num_constraints() == pieces.len();
    is_complete.then_some(cdt).ok_or(MapError::Triangulation)
}

/// Adds a node at the end; `None` if there is one already where it is.
fn add(cdt: &mut Cdt, node: u32, place: LatticePoint) -> Option<()> {
    let p = place.to_point();
    let hint = vertex(node.saturating_sub(1));
    let added = cdt.insert_with_hint(Point2::new(p.x + SHIFT_DU, p.y + SHIFT_DU), hint).ok()?;
    (added == vertex(node)).then_some(())
}

/// Makes a piece an edge that stays; `None` if others are in its way.
fn constrain(cdt: &mut Cdt, i: u32, piece: &Piece) -> Option<()> {
    let ends = piece.nodes.map(vertex);
    cdt.try_add_constraint(ends[0], ends[1]);
    tag(cdt, ends, EdgeTag::Piece(i))
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
pub(crate) async fn keep_gaps(cdt: &mut Cdt, mesh: &Triangulation, sampling: &Sampling) {
    let gap = |h: HalfEdge| mesh.gap(h).filter(|_| mesh.twin(h).is_some_and(|twin| h < twin));
    let mut keep = |h| gap(h).map(|gap| keep_gap(cdt, mesh.ends(h).map(vertex), gap, sampling));
    pace::for_each(mesh.half_edges(), |h| keep(h).unwrap_or_default()).await;
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

/// The triangles of `spade`'s structure as flat arrays, in its order.
pub(crate) async fn flatten(cdt: &Cdt, pieces: &[Piece]) -> Triangulation {
    let points = cdt.vertices().map(|v| v.position());
    let points = points.map(|p| kurbo::Point::new(p.x - SHIFT_DU, p.y - SHIFT_DU)).collect();
    pace::pause().await;
    let half_edges = cdt.inner_faces().flat_map(|face| face.adjacent_edges()).map(|edge| {
        let from = edge.from().fix().index() as u32;
        let kind = match *edge.as_undirected().data().data() {
            EdgeTag::Plain => Edge::Plain,
            EdgeTag::Gap(gap) => Edge::Gap(gap),
            EdgeTag::Piece(i) => Edge::Side(SideId::of(i as usize, pieces[i as usize].nodes[0] != from)),
        };
        (from, [edge.fix().index(), edge.fix().rev().index()], kind)
    });
    let name_count = cdt.num_directed_edges();
    Triangulation::from_half_edges(points, 3 * cdt.num_inner_faces(), name_count, half_edges).await
}
