//! The equations of pixels near corners where the solution is steep without end, or jumps.
//!
//! | noun | file |
//! |---|---|
//! | the walls at nodes, and the corners between them | `walls` |
//! | a corner between two walls, and what the solution is like there | `corner`, `arcosh` |
//! | its region | `ground` |
//! | the pixels around it | `patch` |
//! | weights of links that the steep function satisfies | `fit` |
//! | what the jump lacks in the equations | `jump` |
//!
//! It is steep between two walls more than a right angle apart of which one gives a colour and one gives none, or more than two
//! where both do or neither; worst at the tip of a curve with one coloured side; and around a stretch with a colour that is far
//! shorter than a pixel, or a needle: the end of a curve that crosses a wall without colours by as little. It jumps where both
//! give one, and not the same.
//! What pixels get wrong at the corner is wrong in the whole region.

mod arcosh;
mod corner;
mod fit;
mod ground;
mod jump;
mod patch;
mod walls;

use scumble_core::{Bends, Boundary, PlanarMap};

use super::constraints::Constraints;
use super::wall::centers_from_du;
use crate::scene::View;
use ground::Ground;
use walls::Walls;

/// Fits constraints to the corners of a map.
pub(super) fn fit(
    constraints: &mut Constraints,
    map: &PlanarMap,
    bends: &Bends,
    boundary: &Boundary,
    view: &View,
) {
    let ground = Ground { map, closed_gaps: &boundary.closed_gaps, centers_from_du: centers_from_du(view) };
    let corners = Walls::new(&ground, bends, boundary).corners();
    let fractions: Vec<_> = constraints.cuts.iter().map(|cut| cut.fraction).collect();
    fit::fit(constraints, &corners, &ground);
    jump::supply(constraints, &fractions, &corners, &ground);
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use kurbo::{Affine, BezPath, Point, Rect, Vec2};
    use scumble_core::{Curve, Drawing, Sampling};

    use super::super::cut_links::{LEAST_FRACTION, WAYS};
    use super::corner::Corner;
    use super::patch::{Patch, Pixel, beside, center};
    use super::*;

    const SIZE_PX: u32 = 64;

    /// A straight line through some places, of which one side has a colour from some of them to the next.
    fn line(places_px: &[Point], colored: &[usize]) -> (PlanarMap, Boundary) {
        let du_from_centers = centers_from_du(&view()).inverse();
        let places: Vec<_> = places_px.iter().map(|place| du_from_centers * *place).collect();
        let mut path = BezPath::new();
        path.move_to(places[0]);
        places[1..].iter().for_each(|place| path.line_to(*place));
        let curves = vec![Curve { path, line: None }];
        let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
        let map = PlanarMap::build(&drawing, &Sampling::default()).expect("a map");
        let arc_du = |place: usize| places[place].distance(places[0]);
        let mut sides = vec![None; map.side_count()];
        for step in map.steps(0) {
            let middle_du = 0.5 * (step.arc_du[0] + step.arc_du[1]);
            if colored.iter().any(|&from| (arc_du(from)..arc_du(from + 1)).contains(&middle_du)) {
                sides[step.left.index()] = Some([[0.0; 4]; 3]);
            }
        }
        (map, sides.into())
    }

    /// What the equation of a pixel near a corner lacks where the steep function is put in.
    fn lack(constraints: &Constraints, corner: &Corner, patch: &Patch, pixel: &Pixel) -> f64 {
        let value = |to: Point| corner.steep(to, pixel.angle + corner.turned(center(pixel.at), to))[0];
        let own = value(center(pixel.at));
        let hold = |number: usize| {
            let cut = &constraints.cuts[number];
            cut.color.map_or(0.0, |_| -own / f64::from(cut.fraction))
        };
        let links = WAYS.map(|(link, way)| match patch.cut(pixel.at, link) {
            None => patch.width(pixel.at, link) * (value(center(beside(pixel.at, way))) - own),
            Some(number) => hold(number),
        });
        let pulls = constraints.pulls_of(constraints.pixel(pixel.at));
        links.iter().sum::<f64>() - pulls.iter().map(|pull| own * f64::from(pull.strength)).sum::<f64>()
    }

    /// Checks that the steep function of the corner at a place satisfies the equations around it, but for a part.
    fn assert_fitted((map, boundary): (PlanarMap, Boundary), tip_px: Point, part: f64, name: &str) {
        let (map, boundary, view) = (&map, &boundary, &view());
        let constraints = Constraints::new(map, boundary, view).expect("constraints");
        let constraints = constraints.fitted(map, &Bends::default(), boundary, view);
        let ground = Ground { map, closed_gaps: &[], centers_from_du: centers_from_du(view) };
        let corners = corner::with_stretches(&Walls::new(&ground, &Bends::default(), boundary).corners());
        let is_there = |c: &&Corner| c.is_singular() && c.tip.distance(tip_px) < 0.1;
        let corner = corners.iter().find(is_there).expect("a corner");
        let patch = Patch::around(corner, 5.0, &constraints, &ground);
        // A pixel on the wall has the value of the wall, whatever it lacks.
        let is_off_wall =
            |pixel: &&Pixel| corner.is_between(center(pixel.at), 2.0 * f64::from(LEAST_FRACTION));
        for pixel in patch.pixels.iter().filter(is_off_wall) {
            let lack = lack(&constraints, corner, &patch, pixel);
            assert!(lack.abs() < part, "{name}, {tip_px}: {pixel:?} {lack}");
        }
    }

    fn view() -> View {
        let px_from_du = Affine::scale(f64::from(SIZE_PX) / 1024.0);
        View { px_from_du, width_px: SIZE_PX, height_px: SIZE_PX }
    }

    /// Tilts, and places among the pixels.
    fn tilts_and_places() -> impl Iterator<Item = (f64, Point)> {
        let first = Point::new(30.013, 31.007);
        let places = (0..100).map(move |i| first + Vec2::new(f64::from(i % 10), f64::from(i / 10)) / 10.0);
        [0.0, 0.83, 2.5].into_iter().flat_map(move |tilt| places.clone().map(move |place| (tilt, place)))
    }

    #[test]
    fn what_is_steep_at_a_tip_solves_the_equations_wherever_that_lies_among_the_pixels() {
        for (tilt, tip_px) in tilts_and_places() {
            let end_px = tip_px + 20.0 * Vec2::from_angle(tilt);
            assert_fitted(line(&[tip_px, end_px], &[0]), tip_px, 0.25, &format!("tip, {tilt}"));
        }
    }

    /// What flows out of it is π.
    #[test]
    fn what_is_steep_around_a_short_stretch_with_a_colour_solves_the_equations_too() {
        for (half_px, (tilt, middle_px)) in
            [0.03, 0.1].into_iter().flat_map(|half| tilts_and_places().map(move |at| (half, at)))
        {
            let along = Vec2::from_angle(tilt);
            let places = [-12.0, -half_px, half_px, 12.0, 14.0].map(|t| middle_px + t * along);
            // With another colour, as one alone is that of all pixels however it holds them.
            let line = line(&places, &[1, 3]);
            assert_fitted(line, middle_px, 0.21 * PI, &format!("{half_px}, {tilt}"));
        }
    }
}
