//! What a point sees: its visibility polygon in the triangulation, by triangular expansion.
//!
//! F. Bungiu et al., *Efficient computation of visibility polygons* (EuroCG 2014): from the triangle of the eye,
//! the wedge that each edge leaves open is narrowed from triangle to triangle until curves close it. All
//! decisions use exact orientation tests; only the ends of the visible intervals are rounded.

use kurbo::Point;
use robust::{Coord, orient2d};

use crate::triangulation::{HalfEdge, Triangulation};

/// The part of a curve's side, or of the border, that an eye sees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Visible {
    /// The half-edge that faces the eye.
    pub(crate) half_edge: HalfEdge,
    /// First and last visible place along it: 0 at its start, 1 at its end.
    pub(crate) interval: [f64; 2],
}

/// The visibility polygon of a point: calls `see` with the visible intervals of sides in the triangulation's sense of
/// turn.
///
/// `triangle` is the one that the eye lies in (see [`Triangulation::locate`]). The cost is proportional to the
/// number of triangles that are seen.
pub(crate) fn visibility_polygon(
    mesh: &Triangulation,
    eye: Point,
    triangle: usize,
    mut see: impl FnMut(Visible),
) {
    let mut wedges = Vec::new();
    for i in 0..3 {
        let through = HalfEdge::of(triangle, i);
        let [right, left] = mesh.segment(through);
        wedges.push(Wedge { through, right, left });
        while let Some(wedge) = wedges.pop() {
            wedge.follow(mesh, eye, &mut wedges, &mut see);
        }
    }
}

/// The rays from the eye between two nodes, as they arrive at an edge.
#[derive(Clone, Copy)]
struct Wedge {
    through: HalfEdge,
    /// The node that bounds it on the right, where the sense of turn begins.
    right: Point,
    left: Point,
}

impl Wedge {
    /// Goes on to where curves close it; where a node parts it, along its right part, and leaves its left part to later.
    fn follow(
        mut self,
        mesh: &Triangulation,
        eye: Point,
        later: &mut Vec<Self>,
        see: &mut impl FnMut(Visible),
    ) {
        while let Some(twin) = mesh.passage(self.through) {
            let apex = mesh.points()[mesh.origin(twin.prev()) as usize];
            let left_of_right_ray = turn(eye, self.right, apex) > 0.0;
            let right_of_left_ray = turn(eye, apex, self.left) > 0.0;
            let left_part = Self { through: twin.prev(), ..self };
            let right_part = Self { through: twin.next(), ..self };
            self = match (left_of_right_ray, right_of_left_ray) {
                (true, true) => {
                    later.push(Self { right: apex, ..left_part });
                    Self { left: apex, ..right_part }
                }
                (true, false) => right_part,
                (false, true) => left_part,
                (false, false) => return,
            }
        }
        see(self.seen(mesh, eye));
    }

    fn seen(self, mesh: &Triangulation, eye: Point) -> Visible {
        let [a, b] = mesh.segment(self.through);
        let at = |node: Point| {
            if node == a {
                0.0
            } else if node == b {
                1.0
            } else {
                ray_hit(eye, node, a, b)
            }
        };
        Visible { half_edge: self.through, interval: [at(self.right), at(self.left)] }
    }
}

/// Where the ray from the eye through a node meets the segment from `a` to `b`, in `0..=1`.
fn ray_hit(eye: Point, node: Point, a: Point, b: Point) -> f64 {
    let ray = node - eye;
    let (from, to) = (ray.cross(a - eye), ray.cross(b - eye));
    if from == to { 0.0 } else { (from / (from - to)).clamp(0.0, 1.0) }
}

/// Positive where `a`, `b`, `c` turn left; the sign is exact (Shewchuk 1997).
pub(crate) fn turn(a: Point, b: Point, c: Point) -> f64 {
    // As `orient2d` begins, but without branches on signs, of which half are guessed wrong.
    let (u, v) = (a - c, b - c);
    let (left, right) = (u.x * v.y, u.y * v.x);
    if (left - right).abs() > ROUNDING * (left.abs() + right.abs()) {
        return left - right;
    }
    let coord = |p: Point| Coord { x: p.x, y: p.y };
    orient2d(coord(a), coord(b), coord(c))
}

/// Bounds what rounding takes from a difference of products of differences, beside their sum: 3 ε + 16 ε², ε = 2⁻⁵³.
const ROUNDING: f64 = 3.3306690738754716e-16;

impl Triangulation {
    /// The triangle that a point lies in, walking from `hint`; one of them where it lies on an edge or a node,
    /// and `None` off the page.
    pub fn locate(&self, p: Point, hint: usize) -> Option<usize> {
        if !p.is_finite() || self.triangle_count() == 0 {
            return None;
        }
        let mut triangle = hint.min(self.triangle_count() - 1);
        for _ in 0..self.triangle_count() {
            let outward = (0..3).map(|i| HalfEdge::of(triangle, i)).find(|&h| self.is_right_of(h, p));
            match outward.map(|h| self.twin(h)) {
                None => return Some(triangle),
                Some(None) => return None,
                Some(Some(twin)) => triangle = twin.triangle(),
            }
        }
        // The walk can circle in a triangulation that is not Delaunay everywhere.
        (0..self.triangle_count()).find(|&t| (0..3).all(|i| !self.is_right_of(HalfEdge::of(t, i), p)))
    }

    fn is_right_of(&self, h: HalfEdge, p: Point) -> bool {
        let [a, b] = self.segment(h);
        turn(a, b, p) < 0.0
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::{Curve, Drawing};
    use crate::planar_map::{PlanarMap, Sampling};
    use kurbo::{BezPath, Circle, Rect, Shape};
    use proptest::prelude::*;

    fn map(paths: impl IntoIterator<Item = BezPath>) -> PlanarMap {
        let curves = paths.into_iter().map(|path| Curve { path, line: None }).collect();
        let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
        PlanarMap::build(&drawing, &Sampling::default()).expect("a map")
    }

    fn segment(a: (f64, f64), b: (f64, f64)) -> BezPath {
        kurbo::Line::new(a, b).to_path(0.1)
    }

    fn seen_from(map: &PlanarMap, eye: Point) -> Vec<Visible> {
        let mesh = map.triangulation();
        let mut polygon = Vec::new();
        visibility_polygon(mesh, eye, mesh.locate(eye, 0).expect("on the page"), |seen| polygon.push(seen));
        polygon
    }

    /// The visible intervals as a closed polygon around the eye.
    fn area(mesh: &Triangulation, eye: Point, polygon: &[Visible]) -> f64 {
        let triangle = |seen: &Visible| {
            let [a, b] = mesh.segment(seen.half_edge);
            let [p, q] = seen.interval.map(|t| a.lerp(b, t));
            0.5 * (p - eye).cross(q - eye)
        };
        polygon.iter().map(triangle).sum()
    }

    #[test]
    fn all_of_an_empty_page_is_seen() {
        let map = map([]);
        let eye = Point::new(300.0, 200.0);
        let polygon = seen_from(&map, eye);
        assert!((area(map.triangulation(), eye, &polygon) - 1024.0 * 1024.0).abs() < 1e-6);
    }

    #[test]
    fn inside_a_circle_its_inner_sides_are_seen_and_nothing_else() {
        let map = map([Circle::new((500.0, 500.0), 100.0).to_path(1e-6)]);
        let seen = seen_from(&map, Point::new(520.0, 470.0));
        let mut sides: Vec<_> = seen.iter().filter_map(|s| map.triangulation().side(s.half_edge)).collect();
        sides.sort_unstable();
        let mut inner: Vec<_> = map.steps(0).iter().map(|step| step.left).collect();
        inner.sort_unstable();
        assert_eq!(sides, inner);
        assert!(seen.iter().all(|s| s.interval == [0.0, 1.0]));
    }

    #[test]
    fn a_wall_casts_the_shadow_that_geometry_says() {
        let map = map([segment((400.0, 500.0), (600.0, 500.0))]);
        let eye = Point::new(500.0, 600.0);
        let polygon = seen_from(&map, eye);
        let trapezoid = 0.5 * (200.0 + 1200.0) * 500.0 - 0.5 * (100.0 * 100.0 + 76.0 * 76.0);
        let expected = 1024.0 * 1024.0 - trapezoid;
        assert!((area(map.triangulation(), eye, &polygon) - expected).abs() < 2.0);
    }

    /// What the ray from the eye through a place at `angle` hits first, by testing every side.
    fn first_hit(map: &PlanarMap, eye: Point, angle: f64) -> Option<HalfEdge> {
        let mesh = map.triangulation();
        let ray = kurbo::Line::new(eye, eye + 3000.0 * kurbo::Vec2::from_angle(angle));
        let distance = |h: HalfEdge| {
            let [a, b] = mesh.segment(h);
            let hit = ray.crossing_point(kurbo::Line::new(a, b))?;
            let within = (hit - a).dot(b - a) / (b - a).hypot2();
            let ahead = (hit - eye).dot(ray.p1 - ray.p0) > 0.0 && turn(a, b, eye) > 0.0;
            (ahead && (0.0..=1.0).contains(&within)).then(|| (hit - eye).hypot())
        };
        let sides = mesh.half_edges().filter(|&h| mesh.side(h).is_some());
        let hits = sides.filter_map(|h| distance(h).map(|d| (d, h)));
        hits.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, h)| h)
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(24))]

        #[test]
        fn rays_hit_what_the_polygon_says(
            walls in proptest::collection::vec(((50.0..970.0_f64, 50.0..970.0_f64), (50.0..970.0_f64, 50.0..970.0_f64)), 1..12),
            x in 60.0..960.0_f64, y in 60.0..960.0_f64,
        ) {
            let map = map(walls.into_iter().map(|(a, b)| segment(a, b)));
            let (mesh, eye) = (map.triangulation(), Point::new(x, y));
            let polygon = seen_from(&map, eye);
            for seen in &polygon {
                let [a, b] = mesh.segment(seen.half_edge);
                let middle = a.lerp(b, 0.5 * (seen.interval[0] + seen.interval[1])) - eye;
                if (seen.interval[1] - seen.interval[0]) * (b - a).hypot() > 1e-3 && middle.hypot() > 1e-3 {
                    prop_assert_eq!(first_hit(&map, eye, middle.atan2()), Some(seen.half_edge));
                }
            }
            let angle = |seen: &Visible| {
                let [a, b] = mesh.segment(seen.half_edge);
                let [p, q] = seen.interval.map(|t| a.lerp(b, t) - eye);
                p.cross(q).atan2(p.dot(q))
            };
            let around: f64 = polygon.iter().map(angle).sum();
            prop_assert!((around - 2.0 * std::f64::consts::PI).abs() < 1e-6, "{}", around);
        }
    }
}
