//! Elements at curves as they are seen from close by: between two nodes of the mesh a curve bends.
//!
//! What is solved on straight elements is painted on bent ones: a place in an element goes along with its edges, and takes its
//! colour with it.

use kurbo::{Point, Rect};
use scumble_core::{Bends, HalfEdge, SideId, Triangulation};

use super::MeshSolver;
use crate::field::{Field, FieldTriangle};
use crate::quadratic;

impl MeshSolver {
    /// What comes near a part of the page, in du, of the field of the last solve; edges bend as curves do.
    pub fn bent(&self, bends: &Bends, part_du: Rect) -> Field {
        let (mut triangles, mut all) = (Vec::new(), self.field.triangles.iter());
        for region in &self.regions {
            for (i, triangle) in all.by_ref().take(region.emitted_count()).enumerate() {
                if meets(triangle, part_du) {
                    let (element, weights) = region.part(i);
                    Bent { mesh: &self.mesh, bends, element, weights, triangle }.push_to(&mut triangles);
                }
            }
        }
        Field { blend: self.field.blend, triangles }
    }
}

/// Whether a triangle comes near a part of the page.
fn meets(triangle: &FieldTriangle, part_du: Rect) -> bool {
    let [a, b, c] = triangle.corners;
    let is_within = |i: usize, from: f64, to: f64| {
        f64::from(a[i].min(b[i]).min(c[i])) <= to && f64::from(a[i].max(b[i]).max(c[i])) >= from
    };
    is_within(0, part_du.x0, part_du.x1) && is_within(1, part_du.y0, part_du.y1)
}

/// A triangle of the field, and where it is in its element of the mesh.
struct Bent<'a> {
    mesh: &'a Triangulation,
    bends: &'a Bends,
    element: usize,
    /// Of the element's corners, at the corners of the triangle.
    weights: [[f32; 3]; 3],
    triangle: &'a FieldTriangle,
}

/// A place in the triangle, by the weights of its corners, and where that is painted, in du.
#[derive(Clone, Copy)]
struct Spot {
    weights: [f64; 3],
    at: Point,
}

impl Bent<'_> {
    /// Fans out from a hub to the knots of the edges that bend.
    fn push_to(&self, triangles: &mut Vec<FieldTriangle>) {
        let (rim, corners) = self.rim();
        if rim.len() == 3 {
            let corners = [single(rim[0]), single(rim[1]), single(rim[2])];
            return triangles.push(FieldTriangle { corners, ..*self.triangle });
        }
        let hub = hub(&rim, corners);
        for i in 0..rim.len() {
            let spots = [hub, rim[i], rim[(i + 1) % rim.len()]];
            // Where the hub is a corner, what lies beside it is flat.
            if (spots[1].at - hub.at).cross(spots[2].at - hub.at) > 0.0 {
                triangles.push(self.between(spots));
            }
        }
    }

    /// Its corners and knots in its direction of turn; and where in that list each edge begins, and the last one ends.
    fn rim(&self) -> (Vec<Spot>, [usize; 4]) {
        let (mut rim, mut ends) = (Vec::new(), [0; 4]);
        for k in 0..3 {
            rim.push(self.corner(k));
            self.push_knots(k, &mut rim);
            ends[k + 1] = rim.len();
        }
        (rim, ends)
    }

    /// Where corner `k` is: it may lie in the middle of a side.
    fn corner(&self, k: usize) -> Spot {
        let [x, y] = self.triangle.corners[k].map(f64::from);
        let mut spot = Spot { weights: [0.0; 3], at: Point::new(x, y) };
        spot.weights[k] = 1.0;
        if let Some(Along { side, from, .. }) = self.along([k; 2]) {
            spot.at += self.bends.off_du(side, from);
        }
        spot
    }

    /// Adds the knots between corner `k` and the next one.
    fn push_knots(&self, k: usize, rim: &mut Vec<Spot>) {
        let next = (k + 1) % 3;
        let Some(Along { side, ends: [a, b], from, to }) = self.along([k, next]) else { return };
        for i in 0..self.bends.knot_count(side) {
            let part = self.bends.knot(side, i);
            if part > from && part < to {
                let mut weights = [0.0; 3];
                weights[next] = (part - from) / (to - from);
                weights[k] = 1.0 - weights[next];
                rim.push(Spot { weights, at: a.lerp(b, part) + self.bends.off_du(side, part) });
            }
        }
    }

    /// The side that two corners lie on, if they do.
    fn along(&self, corners: [usize; 2]) -> Option<Along> {
        let [from, to] = corners.map(|k| self.weights[k]);
        for i in 0..3 {
            let [next, across] = [(i + 1) % 3, (i + 2) % 3];
            let edge = HalfEdge::of(self.element, i);
            if let Some(side) = self.mesh.side(edge)
                && from[across] == 0.0
                && to[across] == 0.0
            {
                let [from, to] = [from[next].into(), to[next].into()];
                return Some(Along { side, ends: self.mesh.segment(edge), from, to });
            }
        }
        None
    }

    /// The part of it between three places.
    fn between(&self, spots: [Spot; 3]) -> FieldTriangle {
        let mut part = FieldTriangle { corners: spots.map(single), ..FieldTriangle::default() };
        for i in 0..3 {
            let [a, b] = [spots[i].weights, spots[(i + 1) % 3].weights];
            part.colors[i] = quadratic::color(&self.triangle.colors, a);
            part.colors[3 + i] = quadratic::color(&self.triangle.colors, middle(a, b));
            part.side_edges |= u32::from(self.is_side(a, b)) << i;
        }
        part
    }

    /// Whether what lies between two places is on one of its edges that are sides.
    fn is_side(&self, a: [f64; 3], b: [f64; 3]) -> bool {
        let is_on = |i: usize| a[(i + 2) % 3] == 0.0 && b[(i + 2) % 3] == 0.0;
        (0..3).any(|i| self.triangle.side_edges >> i & 1 == 1 && is_on(i))
    }
}

/// What an edge of a part of an element runs along.
struct Along {
    side: SideId,
    /// Where the side starts and ends, in du.
    ends: [Point; 2],
    /// Where on it the edge starts and ends.
    from: f64,
    to: f64,
}

/// The corner across from the one edge that bends, or else the centroid; from where on the rim the corners are.
fn hub(rim: &[Spot], corners: [usize; 4]) -> Spot {
    for k in 0..3 {
        let alone = corners[k + 1] - corners[k] + 2;
        if alone == rim.len() {
            return rim[corners[(k + 2) % 3]];
        }
    }
    let [a, b, c] = [0, 1, 2].map(|k| rim[corners[k]].at.to_vec2());
    Spot { weights: [1.0 / 3.0; 3], at: ((a + b + c) / 3.0).to_point() }
}

fn middle(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|i| 0.5 * (a[i] + b[i]))
}

fn single(spot: Spot) -> [f32; 2] {
    [spot.at.x as f32, spot.at.y as f32]
}

#[cfg(test)]
mod tests {
    use std::iter;

    use super::*;
    use kurbo::{Circle, Line, Shape, Vec2};
    use scumble_core::{Blend, Boundary, Curve, Drawing, PlanarMap, Sampling, SoftSource};

    const CENTER: Point = Point::new(500.0, 500.0);
    const RADIUS_DU: f64 = 60.0;
    const CHORD_DU: f64 = 0.002;

    /// A circle with a small one in it, both cut by a line.
    fn drawing() -> Drawing {
        let circles = [RADIUS_DU, 3.0].map(|radius| Circle::new(CENTER, radius).to_path(1e-6));
        let line = Line::new((300.0, 480.0), (800.0, 520.0)).to_path(1e-6);
        let curves = circles.into_iter().chain(iter::once(line)).map(|path| Curve { path, line: None });
        Drawing { curves: curves.collect(), ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) }
    }

    fn bent(sources: Vec<SoftSource>, part_du: Rect) -> (Field, Field) {
        let drawing = drawing();
        let map = PlanarMap::build(&drawing, &Sampling::default()).expect("a map");
        let sides = (0..map.side_count()).map(|i| Some([[(i % 7) as f64 / 7.0; 4]; 3])).collect::<Vec<_>>();
        let boundary = Boundary { sources, ..sides.into() };
        let mut solver = MeshSolver::new(map.refined().clone());
        let straight = solver.solve(&boundary, Blend::Oklab).expect("a field").clone();
        let bends = Bends::within(&drawing, &map, part_du, CHORD_DU);
        (straight, solver.bent(&bends, part_du))
    }

    const PAGE: Rect = Rect::new(0.0, 0.0, 1024.0, 1024.0);

    fn stroke() -> SoftSource {
        let points = vec![CENTER, CENTER + Vec2::new(80.0, 30.0)];
        SoftSource { points, radius_du: 9.0, weight: 4.0, color: [1.0; 4], crosses: true, parts: Vec::new() }
    }

    fn corners(triangle: &FieldTriangle) -> [Point; 3] {
        triangle.corners.map(|[x, y]| Point::new(x.into(), y.into()))
    }

    /// The largest distance of what runs along the circles in a part of the page from them, away from where the line cuts them.
    fn most_off_du(field: &Field, part_du: Rect) -> f64 {
        let edges = field.triangles.iter().flat_map(|triangle| {
            let corners = corners(triangle);
            (0..3)
                .filter(|i| triangle.side_edges >> i & 1 == 1)
                .map(move |i| [corners[i], corners[(i + 1) % 3]])
        });
        let off_du = |p: Point| {
            let from_center = (p - CENTER).hypot();
            (from_center - RADIUS_DU).abs().min((from_center - 3.0).abs())
        };
        let is_on_circle = |p: &Point| off_du(*p) < 0.15 && (p.y - 480.0 - 0.08 * (p.x - 300.0)).abs() > 5.0;
        let ways = edges.filter(|ends| ends.iter().all(|p| part_du.contains(*p) && is_on_circle(p)));
        ways.map(|[a, b]| off_du(a.midpoint(b)).max(off_du(a))).fold(0.0, f64::max)
    }

    #[test]
    fn sides_are_as_round_as_their_curves() {
        for sources in [vec![], vec![stroke()]] {
            let (straight, bent) = bent(sources, PAGE);
            assert!(most_off_du(&straight, PAGE) > 0.04, "{}", most_off_du(&straight, PAGE));
            // A node lies on the lattice.
            assert!(most_off_du(&bent, PAGE) < CHORD_DU + 0.001, "{}", most_off_du(&bent, PAGE));
        }
    }

    #[test]
    fn nothing_is_covered_twice_or_left_out() {
        let area = |triangle: &FieldTriangle| {
            let [a, b, c] = corners(triangle);
            0.5 * (b - a).cross(c - a)
        };
        for sources in [vec![], vec![stroke()]] {
            let (_, bent) = bent(sources, PAGE);
            let areas = bent.triangles.iter().map(area);
            assert!((areas.clone().sum::<f64>() - PAGE.area()).abs() < 0.01, "{}", areas.sum::<f64>());
        }
    }

    #[test]
    fn edges_meet_edge_to_edge() {
        let (straight, bent) = bent(vec![], PAGE);
        let edges = |field: &Field| {
            let key = |[x, y]: [f32; 2]| (x.to_bits(), y.to_bits());
            let edges = field
                .triangles
                .iter()
                .flat_map(|triangle| [0, 1, 2].map(|i| [i, (i + 1) % 3].map(|k| key(triangle.corners[k]))));
            edges.collect::<std::collections::BTreeSet<_>>()
        };
        let alone = |field: &Field| {
            let edges = edges(field);
            edges.iter().filter(|[a, b]| !edges.contains(&[*b, *a])).count()
        };
        assert!(bent.triangles.len() > straight.triangles.len());
        assert_eq!(alone(&bent), alone(&straight), "only the border of the page is met from one side");
    }

    #[test]
    fn colours_go_along() {
        let (straight, bent) = bent(vec![stroke()], PAGE);
        let view = crate::View { px_from_du: kurbo::Affine::scale(0.5), width_px: 500, height_px: 500 };
        let [straight, bent] = [straight, bent].map(|field| crate::centers::colors(&field, &view));
        let differences =
            straight.iter().zip(&bent).map(|(a, b)| (0..4).map(|i| (a[i] - b[i]).abs()).fold(0.0, f32::max));
        let far = differences.clone().filter(|difference| *difference > 0.02).count();
        assert!(far < 20, "{far}");
        assert!(differences.fold(0.0, f32::max) > 0.0);
    }

    #[test]
    fn only_what_comes_near_the_part_is_there() {
        let part_du = Rect::new(540.0, 540.0, 560.0, 560.0);
        let (straight, bent) = bent(vec![], part_du);
        assert!(bent.triangles.len() < straight.triangles.len() / 4);
        assert!(most_off_du(&bent, part_du) < CHORD_DU + 0.001, "{}", most_off_du(&bent, part_du));
    }
}
