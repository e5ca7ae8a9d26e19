//! A mesh of half the width: to see what a finer one would change.

use super::{Edge, HalfEdge, NONE, SideId, Triangulation, some};

impl Triangulation {
    /// The same with each triangle as four and each edge as two. The halves of side `s` of piece `p`, from its start on, are
    /// the same side of piece `2 p`, and of `2 p + 1`, where the side is left, and the other way round where it is right.
    pub fn halved(&self) -> Self {
        let (middles, points) = self.middles();
        let mut halved = Self {
            points,
            origins: vec![NONE; 4 * self.origins.len()],
            twins: vec![NONE; 4 * self.origins.len()],
            edges: vec![Edge::Plain; 4 * self.origins.len()],
        };
        for h in self.half_edges() {
            let halves = halves(h);
            let twins = some(self.twins[h.index()]).map(|twin| self::halves(HalfEdge(twin)));
            for (i, half) in halves.into_iter().enumerate() {
                halved.origins[half.index()] = [self.origin(h), middles[h.index()]][i];
                halved.twins[half.index()] = twins.map_or(NONE, |twins| twins[1 - i].0);
                halved.edges[half.index()] = half_of(self.edges[h.index()], i == 1);
            }
            let [outer, inner] = across(h);
            for [half, twin] in [[outer, inner], [inner, outer]] {
                halved.twins[half.index()] = twin.0;
            }
            halved.origins[outer.index()] = middles[h.index()];
            halved.origins[inner.index()] = middles[h.prev().index()];
        }
        halved
    }

    /// The node in the middle of each half-edge, and all nodes.
    fn middles(&self) -> (Vec<u32>, Vec<kurbo::Point>) {
        let mut middles = vec![NONE; self.origins.len()];
        let mut points = self.points.clone();
        for h in self.half_edges() {
            if middles[h.index()] == NONE {
                let [a, b] = self.segment(h);
                middles[h.index()] = points.len() as u32;
                if let Some(twin) = self.twin(h) {
                    middles[twin.index()] = points.len() as u32;
                }
                points.push(a.midpoint(b));
            }
        }
        (middles, points)
    }
}

/// Triangle `t` becomes `4 t + i`, which has its corner `i` as its own first, and `4 t + 3` between these.
fn halves(h: HalfEdge) -> [HalfEdge; 2] {
    [(h, 0), (h.next(), 2)].map(|(h, i)| HalfEdge::of(4 * h.triangle() + h.index() % 3, i))
}

/// The edge across from the middle of a half-edge to that of the one before it, in the triangle at its start; and its twin.
fn across(h: HalfEdge) -> [HalfEdge; 2] {
    let (t, i) = (h.triangle(), h.index() % 3);
    [HalfEdge::of(4 * t + i, 1), HalfEdge::of(4 * t + 3, (i + 2) % 3)]
}

fn half_of(edge: Edge, is_second: bool) -> Edge {
    match edge {
        Edge::Side(side) => {
            let is_later = is_second != side.is_right();
            Edge::Side(SideId::of(2 * side.piece() + usize::from(is_later), side.is_right()))
        }
        Edge::Plain | Edge::Gap(_) => edge,
    }
}
