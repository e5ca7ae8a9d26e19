//! Rubbing out a part of a scribble: what an eraser leaves of the pen's way.
//!
//! The eraser sweeps a *capsule*: all places within some distance of a straight way. It is convex, so that it takes one
//! stretch, at most, of each straight stretch of the stroke.

use kurbo::{Line, Point};

use crate::scribble::Scribble;

/// What is left between two cuts and is shorter than this, in du, is a crumb, and goes too.
const CRUMB_DU: f64 = 1.0;

impl Scribble {
    /// The scribbles that are left when an eraser goes a straight way and takes what of the pen's way is within a distance
    /// of it, in du: in the order in which they were drawn, each like the whole. `None` where it takes nothing.
    pub fn rubbed(&self, way: Line, reach_du: f64) -> Option<Vec<Self>> {
        let mut left = Left::default();
        let dab =
            self.points.first().filter(|_| self.points.len() == 1).map(|&point| Line::new(point, point));
        let stretches = self.points.windows(2).map(|ends| Line::new(ends[0], ends[1]));
        for (i, stretch) in dab.into_iter().chain(stretches).enumerate() {
            left.go(i as f64, stretch, taken(stretch, way, reach_du));
        }
        left.drop_crumbs();
        left.is_cut.then(|| left.parts.iter().map(|part| self.through(part)).collect())
    }

    /// One like this, through some of its places.
    fn through(&self, places: &[Place]) -> Self {
        let points = places.iter().map(|place| place.point).collect();
        let along: Vec<_> = places.iter().map(|place| place.along).collect();
        Self { color: self.color, kind: self.kind.through(&along), width_du: self.width_du, points }
    }
}

/// A place on a stroke.
#[derive(Clone, Copy)]
struct Place {
    point: Point,
    /// The number of its point, or where it is between two of them.
    along: f64,
}

/// What is left of a stroke, as far as it has been followed.
#[derive(Default)]
struct Left {
    parts: Vec<Vec<Place>>,
    /// Whether the last part goes on.
    is_open: bool,
    is_cut: bool,
}

impl Left {
    /// Follows one more stretch, after so many, of which what is between two fractions is taken.
    fn go(&mut self, before: f64, stretch: Line, taken: Option<[f64; 2]>) {
        let cut = |t: f64| Place { point: stretch.p0.lerp(stretch.p1, t), along: before + t };
        let start = Place { point: stretch.p0, along: before };
        let end = Place { point: stretch.p1, along: before + 1.0 };
        let Some([from, to]) = taken else { return self.keep(start, end) };
        self.is_cut = true;
        if from > 0.0 {
            self.keep(start, cut(from));
        }
        self.is_open = false;
        if to < 1.0 {
            self.keep(cut(to), end);
        }
    }

    fn keep(&mut self, from: Place, to: Place) {
        match self.parts.last_mut() {
            Some(part) if self.is_open => part.push(to),
            _ if from.point == to.point => self.parts.push(vec![from]),
            _ => self.parts.push(vec![from, to]),
        }
        self.is_open = true;
    }

    fn drop_crumbs(&mut self) {
        self.parts.retain(|part| {
            part.windows(2).map(|ends| (ends[1].point - ends[0].point).hypot()).sum::<f64>() >= CRUMB_DU
        });
    }
}

/// Between which fractions of it a stretch is within a distance of a way, if anywhere.
fn taken(stretch: Line, way: Line, reach_du: f64) -> Option<[f64; 2]> {
    let discs = [way.p0, way.p1].map(|center| in_disc(stretch, center, reach_du));
    let all = discs.into_iter().chain([in_band(stretch, way, reach_du)]).flatten();
    all.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
}

fn in_disc(stretch: Line, center: Point, radius_du: f64) -> Option<[f64; 2]> {
    let (along, from) = (stretch.p1 - stretch.p0, stretch.p0 - center);
    let length_sq = along.hypot2();
    let excess = from.hypot2() - radius_du * radius_du;
    if length_sq == 0.0 {
        return (excess <= 0.0).then_some([0.0, 1.0]);
    }
    let middle = -along.dot(from) / length_sq;
    let half_sq = middle * middle - excess / length_sq;
    (half_sq >= 0.0).then(|| [middle - half_sq.sqrt(), middle + half_sq.sqrt()]).and_then(within_stretch)
}

/// Where a stretch lies between the ends of a way, and at most so far from it to either side.
fn in_band(stretch: Line, way: Line, reach_du: f64) -> Option<[f64; 2]> {
    let along = way.p1 - way.p0;
    let length_du = along.hypot();
    let [from, to] = [stretch.p0 - way.p0, stretch.p1 - way.p0];
    let [ahead, aside] = [along.dot(from), along.cross(from)].map(|x| x / length_du);
    let [ahead_to, aside_to] = [along.dot(to), along.cross(to)].map(|x| x / length_du);
    let a = between(ahead, ahead_to, 0.0, length_du)?;
    let b = between(aside, aside_to, -reach_du, reach_du)?;
    within_stretch([a[0].max(b[0]), a[1].min(b[1])])
}

/// At which fractions a number that goes evenly from one value to another is between two limits; not for a way of no
/// length, along which there is nothing.
fn between(from: f64, to: f64, least: f64, most: f64) -> Option<[f64; 2]> {
    if from == to {
        return (least <= from && from <= most).then_some([0.0, 1.0]);
    }
    let [a, b] = [least, most].map(|limit| (limit - from) / (to - from));
    within_stretch([a.min(b), a.max(b)])
}

fn within_stretch([from, to]: [f64; 2]) -> Option<[f64; 2]> {
    (from <= to && to >= 0.0 && from <= 1.0).then_some([from.max(0.0), to.min(1.0)])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Paint;
    use crate::scribble::{PenPressure, ScribbleKind, Shading};
    use proptest::prelude::*;

    fn scribble(points: &[(f64, f64)]) -> Scribble {
        let points = points.iter().map(|&p| p.into()).collect();
        Scribble { color: Paint::Clear, kind: ScribbleKind::Fill, width_du: 10.0, points }
    }

    fn ways(parts: Option<Vec<Scribble>>) -> Option<Vec<Vec<(f64, f64)>>> {
        let round = |p: &Point| ((p.x * 1e6).round() / 1e6, (p.y * 1e6).round() / 1e6);
        parts.map(|parts| parts.iter().map(|part| part.points.iter().map(round).collect()).collect())
    }

    fn across(x: f64) -> Line {
        Line::new((x, -50.0), (x, 50.0))
    }

    #[test]
    fn what_lies_within_reach_goes_and_splits_the_rest() {
        let stroke = scribble(&[(0.0, 0.0), (60.0, 0.0), (100.0, 0.0)]);
        let left = vec![vec![(0.0, 0.0), (20.0, 0.0)], vec![(40.0, 0.0), (60.0, 0.0), (100.0, 0.0)]];
        assert_eq!(ways(stroke.rubbed(across(30.0), 10.0)), Some(left));
        assert_eq!(
            ways(stroke.rubbed(across(0.0), 10.0)),
            Some(vec![vec![(10.0, 0.0), (60.0, 0.0), (100.0, 0.0)]])
        );
        assert_eq!(ways(stroke.rubbed(across(120.0), 10.0)), None);
    }

    #[test]
    fn a_click_takes_a_disc() {
        let stroke = scribble(&[(0.0, 0.0), (100.0, 0.0)]);
        let click = Line::new((50.0, 3.0), (50.0, 3.0));
        let left = vec![vec![(0.0, 0.0), (46.0, 0.0)], vec![(54.0, 0.0), (100.0, 0.0)]];
        assert_eq!(ways(stroke.rubbed(click, 5.0)), Some(left));
    }

    #[test]
    fn the_ends_of_the_way_are_round() {
        let stroke = scribble(&[(0.0, 0.0), (100.0, 0.0)]);
        let short_of_it = Line::new((50.0, -50.0), (50.0, -8.0));
        let left = vec![vec![(0.0, 0.0), (44.0, 0.0)], vec![(56.0, 0.0), (100.0, 0.0)]];
        assert_eq!(ways(stroke.rubbed(short_of_it, 10.0)), Some(left));
    }

    #[test]
    fn a_dab_goes_or_stays_and_crumbs_go() {
        let dab = scribble(&[(5.0, 5.0)]);
        assert_eq!(ways(dab.rubbed(across(10.0), 5.0)), Some(vec![]));
        assert_eq!(ways(dab.rubbed(across(11.0), 5.0)), None);
        let stroke = scribble(&[(0.0, 0.0), (20.4, 0.0)]);
        assert_eq!(ways(stroke.rubbed(across(10.0), 10.0)), Some(vec![]));
        assert_eq!(ways(scribble(&[]).rubbed(across(10.0), 10.0)), None);
        let still = scribble(&[(5.0, 5.0), (5.0, 5.0), (5.0, 5.0)]);
        assert_eq!(ways(still.rubbed(across(5.0), 5.0)), Some(vec![]));
        assert_eq!(ways(still.rubbed(across(50.0), 5.0)), None);
    }

    fn place() -> impl Strategy<Value = (f64, f64)> {
        (-20..120_i32, -20..120_i32).prop_map(|(x, y)| (f64::from(x), f64::from(y)))
    }

    fn distance_du(point: Point, way: Line) -> f64 {
        use kurbo::ParamCurveNearest;
        way.nearest(point, 0.0).distance_sq.sqrt()
    }

    #[test]
    fn what_is_left_is_as_hard_pressed_as_it_was() {
        let pressure = PenPressure::Radius(vec![0.2, 0.6, 1.0]);
        let kind = ScribbleKind::Shade(Shading { pressure, ..Shading::default() });
        let whole = Scribble { kind, ..scribble(&[(0.0, 0.0), (100.0, 0.0), (200.0, 0.0)]) };
        let parts = whole.rubbed(Line::new((50.0, 0.0), (50.0, 0.0)), 10.0).expect("a cut");
        let pressed = |part: &Scribble| {
            let Some(Shading { pressure: PenPressure::Radius(parts), .. }) = part.shading() else { panic!() };
            parts.iter().map(|part| (100.0 * part).round()).collect::<Vec<_>>()
        };
        assert_eq!(
            parts.iter().map(pressed).collect::<Vec<_>>(),
            [vec![20.0, 36.0], vec![44.0, 60.0, 100.0]]
        );
    }

    proptest! {
        #[test]
        fn what_is_left_is_out_of_reach_and_of_the_stroke(
            points in prop::collection::vec(place(), 1..12), from in place(), to in place(), reach_du in 1.0..40.0_f64,
        ) {
            let (stroke, way) = (scribble(&points), Line::new(from, to));
            let touched = stroke.is_touched(way, reach_du - 0.5 * stroke.width_du);
            let left = stroke.rubbed(way, reach_du);
            prop_assert_eq!(left.is_some(), touched);
            for part in left.iter().flatten() {
                for ends in part.points.windows(2) {
                    for t in [0.0, 0.3, 0.5, 0.8, 1.0] {
                        let point = ends[0].lerp(ends[1], t);
                        prop_assert!(distance_du(point, way) >= reach_du - 1e-6);
                        let at = Line::new(point, point);
                        prop_assert!(stroke.is_touched(at, 1e-6 - 0.5 * stroke.width_du));
                    }
                }
            }
        }

        #[test]
        fn an_eraser_that_reaches_everywhere_leaves_nothing(points in prop::collection::vec(place(), 1..12), at in place()) {
            prop_assert_eq!(scribble(&points).rubbed(Line::new(at, at), 300.0), Some(vec![]));
        }
    }
}
