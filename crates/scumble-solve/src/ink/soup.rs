//! Lines as loose triangles: a quad for each segment, joins between them, caps at the ends. They overlap.

use std::f64::consts::{FRAC_PI_2, PI};

use kurbo::{Cap, Join, Point, Vec2};
use scumble_core::unit_vector;

/// How a line is drawn along its points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Pen {
    /// Half the width, in du; positive and finite.
    pub(super) half_width_du: f64,
    pub(super) join: Join,
    pub(super) miter_limit: f64,
    pub(super) start_cap: Cap,
    pub(super) end_cap: Cap,
    /// How far a round join or cap may lie off its circle, in du; positive.
    pub(super) tolerance_du: f64,
}

/// A point along a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stop {
    pub(super) point: Point,
    /// Whether the line's own join goes here; a stop within a smooth curve is always joined round.
    pub(super) is_corner: bool,
}

/// Triangles in du, turning either way.
pub(super) type Soup = Vec<[[f32; 2]; 3]>;

/// A segment: where it starts and ends, its direction (of length 1).
#[derive(Clone, Copy, Debug)]
struct Segment {
    start: Point,
    end: Point,
    direction: Vec2,
    ends_in_corner: bool,
}

impl Segment {
    fn length(&self) -> f64 {
        (self.end - self.start).hypot()
    }
}

/// Steps that half a turn may have; a circle then has a corner every 1.4 degrees.
const MAX_HALF_TURN_STEPS: f64 = 128.0;

impl Pen {
    /// Adds a line along stops. Those that lie on one spot make a dot, unless the caps are butt ends.
    pub(super) fn draw(&self, stops: &[Stop], closed: bool, soup: &mut Soup) {
        let segments = segments(stops, closed);
        let (Some(first), Some(last)) = (segments.first(), segments.last()) else {
            return self.dot(stops, soup);
        };
        for segment in &segments {
            self.quad(segment.start, segment.end, segment.direction, soup);
        }
        for pair in segments.windows(2) {
            self.join(&pair[0], &pair[1], soup);
        }
        if closed {
            self.join(last, first, soup);
        } else {
            self.cap(self.start_cap, first.start, -first.direction, first.length(), soup);
            self.cap(self.end_cap, last.end, last.direction, last.length(), soup);
        }
    }

    fn dot(&self, stops: &[Stop], soup: &mut Soup) {
        if let Some(stop) = stops.first().filter(|stop| stop.point.is_finite()) {
            self.cap(self.start_cap, stop.point, Vec2::new(-1.0, 0.0), 0.0, soup);
            self.cap(self.end_cap, stop.point, Vec2::new(1.0, 0.0), 0.0, soup);
        }
    }

    fn quad(&self, start: Point, end: Point, direction: Vec2, soup: &mut Soup) {
        let side = direction.turn_90() * self.half_width_du;
        soup.push(triangle(start + side, start - side, end - side));
        soup.push(triangle(start + side, end - side, end + side));
    }

    /// `length` is that of the segment that ends here.
    fn cap(&self, cap: Cap, end: Point, direction: Vec2, length: f64, soup: &mut Soup) {
        let reach = direction * self.half_width_du;
        let side = reach.turn_90();
        match cap {
            Cap::Butt => {}
            Cap::Square => self.quad(end, end + reach, direction, soup),
            Cap::Round => {
                let apex = end - direction * self.overlap(length);
                self.fan(apex, end, [-side, side], PI, soup);
            }
        }
    }

    /// Fills the wedge on the outer side of a turn.
    fn join(&self, from: &Segment, to: &Segment, soup: &mut Soup) {
        let (d0, d1) = (from.direction, to.direction);
        let turn = d0.cross(d1).atan2(d0.dot(d1));
        if turn == 0.0 {
            return;
        }
        let outer = -self.half_width_du * turn.signum();
        let sides = [d0, d1].map(|d| d.turn_90() * outer);
        let bisector = sides[0] + sides[1];
        let back = bisector * (self.overlap(from.length().min(to.length())) / bisector.hypot());
        let center = to.start;
        let apex = if back.is_finite() { center - back } else { center };
        match self.join {
            Join::Miter if from.ends_in_corner && self.is_miter(d0.dot(d1)) => {
                let tip = center + bisector / (1.0 + d0.dot(d1));
                soup.push(triangle(apex, center + sides[0], tip));
                soup.push(triangle(apex, tip, center + sides[1]));
            }
            Join::Miter | Join::Bevel if from.ends_in_corner => {
                soup.push(triangle(apex, center + sides[0], center + sides[1]));
            }
            _ => self.fan(apex, center, sides, turn, soup),
        }
    }

    /// How far joins and caps reach back into segments at least so long, in du: without an overlap, rounding would
    /// leave hairline gaps.
    fn overlap(&self, length: f64) -> f64 {
        0.5 * length.min(self.half_width_du)
    }

    /// Whether the tip of a miter stays within the limit, given the cosine of the turn: that of half of it is √((1 + cos)/2).
    fn is_miter(&self, cos: f64) -> bool {
        (0.5 * (1.0 + cos)).max(0.0).sqrt() * self.miter_limit >= 1.0
    }

    /// Triangles from an apex to an arc around a center, given by its end spokes and its angle in radians.
    fn fan(&self, apex: Point, center: Point, [first, last]: [Vec2; 2], angle: f64, soup: &mut Soup) {
        let steps = self.fan_steps(angle.abs());
        let mut spoke = first;
        for i in 1..steps {
            let turn = unit_vector((angle * f64::from(i) / f64::from(steps)).to_degrees());
            let next = turn.rotate_scale(first);
            soup.push(triangle(apex, center + spoke, center + next));
            spoke = next;
        }
        soup.push(triangle(apex, center + spoke, center + last));
    }

    /// A chord of angle φ lies r (1 − cos φ/2) off the circle, which is r φ²/8 at most. It never spans more than a quarter of it.
    fn fan_steps(&self, angle: f64) -> u32 {
        let step = (8.0 * self.tolerance_du / self.half_width_du).sqrt();
        let step = step.clamp(PI / MAX_HALF_TURN_STEPS, FRAC_PI_2);
        (angle / step).ceil().max(1.0) as u32
    }
}

/// The segments between stops that lie apart.
fn segments(stops: &[Stop], closed: bool) -> Vec<Segment> {
    let mut stops = stops.iter().filter(|stop| stop.point.is_finite());
    let Some(&first) = stops.next() else { return Vec::new() };
    let mut segments: Vec<Segment> = Vec::new();
    let mut start = first.point;
    for &stop in stops.chain(closed.then_some(&first)) {
        let way = stop.point - start;
        let direction = way / way.hypot();
        if direction.is_finite() {
            segments.push(Segment { start, end: stop.point, direction, ends_in_corner: stop.is_corner });
            start = stop.point;
        } else if let Some(last) = segments.last_mut() {
            last.ends_in_corner |= stop.is_corner;
        }
    }
    segments
}

fn triangle(a: Point, b: Point, c: Point) -> [[f32; 2]; 3] {
    [a, b, c].map(|p| [p.x as f32, p.y as f32])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pen(join: Join, cap: Cap) -> Pen {
        Pen { half_width_du: 2.0, join, miter_limit: 4.0, start_cap: cap, end_cap: cap, tolerance_du: 0.01 }
    }

    fn draw(pen: &Pen, points: &[(f64, f64)], closed: bool) -> Soup {
        let stops: Vec<_> = points.iter().map(|&p| Stop { point: p.into(), is_corner: true }).collect();
        let mut soup = Soup::new();
        pen.draw(&stops, closed, &mut soup);
        assert!(soup.as_flattened().as_flattened().iter().all(|c| c.is_finite()));
        soup
    }

    fn covers(soup: &Soup, x: f64, y: f64) -> bool {
        soup.iter().any(|t| {
            let p = t.map(|[x, y]| Point::new(x.into(), y.into()));
            let turns = [0, 1, 2].map(|i| (p[(i + 1) % 3] - p[i]).cross(Point::new(x, y) - p[i]));
            turns.iter().all(|&t| t >= 0.0) || turns.iter().all(|&t| t <= 0.0)
        })
    }

    /// The area that a soup covers, counted on a fine grid around the place where the tests draw.
    fn area(soup: &Soup) -> f64 {
        let at = |i: u32| f64::from(i) * 0.05 - 3.0123;
        let points = (0..320).flat_map(|i| (0..320).map(move |j| (at(i), at(j))));
        points.filter(|&(x, y)| covers(soup, x, y)).count() as f64 * 0.05 * 0.05
    }

    #[test]
    fn a_segment_is_a_rectangle_with_its_caps() {
        let line = [(0.0, 0.0), (6.0, 8.0)];
        assert!((area(&draw(&pen(Join::Miter, Cap::Butt), &line, false)) - 40.0).abs() < 0.1);
        assert!((area(&draw(&pen(Join::Miter, Cap::Square), &line, false)) - 56.0).abs() < 0.1);
        let round = area(&draw(&pen(Join::Miter, Cap::Round), &line, false));
        assert!((round - 40.0 - 4.0 * PI).abs() < 0.2, "{round}");
    }

    #[test]
    fn joins_fill_the_outer_side_of_a_corner_either_way() {
        for mirror in [1.0, -1.0] {
            let corner = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0 * mirror)];
            let inside =
                |join, x: f64, y: f64| covers(&draw(&pen(join, Cap::Butt), &corner, false), x, y * mirror);
            assert!(inside(Join::Miter, 11.9, -1.9));
            assert!(inside(Join::Round, 11.4, -1.4) && !inside(Join::Round, 11.5, -1.5));
            assert!(inside(Join::Bevel, 10.9, -0.9) && !inside(Join::Bevel, 11.1, -1.1));
        }
    }

    #[test]
    fn a_miter_beyond_its_limit_is_a_bevel() {
        // A turn back by 2 asin(1/4) is where a limit of 4 ends.
        for (angle, is_miter) in [(29.1_f64, true), (28.8, false)] {
            let back = Vec2::from_angle((180.0 - angle).to_radians()) * 50.0;
            let soup =
                draw(&pen(Join::Miter, Cap::Butt), &[(-50.0, 0.0), (0.0, 0.0), (back.x, back.y)], false);
            let tip = Vec2::from_angle(-0.5 * angle.to_radians()) * 7.9;
            assert_eq!(covers(&soup, tip.x, tip.y), is_miter, "{angle}");
        }
    }

    #[test]
    fn a_closed_line_joins_at_its_closing_point_and_has_no_caps() {
        let square = [(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)];
        let soup = draw(&pen(Join::Miter, Cap::Round), &square, true);
        for (x, y) in [(-1.9, -1.9), (11.9, -1.9), (11.9, 11.9), (-1.9, 11.9), (-1.9, 5.0)] {
            assert!(covers(&soup, x, y), "{x} {y}");
        }
        assert!(!covers(&soup, 5.0, 5.0));
        let repeated = [&square[..], &square[..1]].concat();
        assert_eq!(draw(&pen(Join::Miter, Cap::Round), &repeated, true), soup);
    }

    #[test]
    fn turning_straight_back_is_joined_round_over_the_end() {
        let back = [(0.0, 0.0), (10.0, 0.0), (5.0, 0.0)];
        assert!(covers(&draw(&pen(Join::Round, Cap::Butt), &back, false), 11.9, 0.0));
        assert!(!covers(&draw(&pen(Join::Miter, Cap::Butt), &back, false), 10.1, 0.0));
    }

    #[test]
    fn points_on_one_spot_are_a_dot_of_the_cap() {
        for spot in [&[(5.0, 5.0)][..], &[(5.0, 5.0), (5.0, 5.0), (5.0, 5.0)]] {
            assert!(draw(&pen(Join::Round, Cap::Butt), spot, false).is_empty());
            assert!((area(&draw(&pen(Join::Round, Cap::Square), spot, false)) - 16.0).abs() < 0.1);
            let disc = draw(&pen(Join::Round, Cap::Round), spot, false);
            assert!((area(&disc) - 4.0 * PI).abs() < 0.2);
        }
    }

    #[test]
    fn points_that_nearly_coincide_or_are_not_finite_do_no_harm() {
        let points =
            [(0.0, 0.0), (1e-300, 0.0), (5e-324, 1e-310), (f64::NAN, 1.0), (4.0, 0.0), (4.0, 1e-200)];
        for join in [Join::Miter, Join::Round, Join::Bevel] {
            let soup = draw(&pen(join, Cap::Round), &points, false);
            assert!(covers(&soup, 2.0, 1.9) && covers(&soup, 5.9, 0.0) && covers(&soup, -1.9, 0.0));
        }
    }

    #[test]
    fn round_parts_have_the_steps_that_the_tolerance_asks_for_and_no_more() {
        let dot = |tolerance_du: f64| {
            draw(&Pen { tolerance_du, ..pen(Join::Round, Cap::Round) }, &[(0.0, 0.0)], false).len()
        };
        assert_eq!(dot(5.0), 4);
        assert_eq!(dot(0.01), 2 * 16);
        assert_eq!(dot(1e-12), 2 * 128);
    }
}
