//! The equations of pixels near corners where the solution is steep without end, or jumps.
//!
//! | noun | file |
//! |---|---|
//! | a corner between two walls, and what the solution is like there | `corner` |
//! | its region | `ground` |
//! | the pixels around it | `patch` |
//! | weights of links that the steep function satisfies | `fit` |
//! | what the jump lacks in the equations | `jump` |
//!
//! It is steep between two walls more than a right angle apart of which one gives a colour and one gives none, or more than two
//! where both do or neither; worst at the tip of a curve with one coloured side. It jumps where both give one, and not the same.
//! What pixels get wrong at the corner is wrong in the whole region.

mod corner;
mod fit;
mod ground;
mod jump;
mod patch;

use scumble_core::{Bends, Boundary, PlanarMap, SideId, sort};

use super::constraints::Constraints;
use super::straights::{Straight, straights};
use super::wall::centers_from_du;
use crate::scene::View;
use corner::{Corner, Face, Ray};
use ground::Ground;

/// Fits constraints to the corners of a map.
pub(super) fn fit(
    constraints: &mut Constraints,
    map: &PlanarMap,
    bends: &Bends,
    boundary: &Boundary,
    view: &View,
) {
    let ground = Ground { map, closed_gaps: &boundary.closed_gaps, centers_from_du: centers_from_du(view) };
    let corners = corners(&ground, bends, boundary);
    let fractions: Vec<_> = constraints.cuts.iter().map(|cut| cut.fraction).collect();
    fit::fit(constraints, &corners, &ground);
    jump::supply(constraints, &fractions, &corners, &ground);
}

fn corners(ground: &Ground<'_>, bends: &Bends, boundary: &Boundary) -> Vec<Corner> {
    let rays = rays(ground, bends, boundary);
    let mut corners = Vec::new();
    for around in rays.chunk_by(|a, b| a.node == b.node) {
        let tip = ground.place(around[0].node);
        let nexts = around.iter().cycle().skip(1);
        corners.extend(around.iter().zip(nexts).map(|(ray, next)| Corner::between(tip, ray, next)));
    }
    corners
}

/// The walls at all nodes: by node, and by their angles there.
fn rays(ground: &Ground<'_>, bends: &Bends, boundary: &Boundary) -> Vec<Ray> {
    let face = |side: SideId, end: usize| {
        let colors = boundary.sides.get(side.index()).copied().flatten();
        Face { side: Some(side), color: colors.map(|colors| colors[end]) }
    };
    let piece = |Straight { piece, parts, ends: [a, b] }: Straight| {
        let nodes = ground.map.pieces()[piece].nodes;
        let [left, right] = [false, true].map(|is_right| SideId::of(piece, is_right));
        let first = Ray { node: nodes[0], along: b - a, faces: [face(left, 0), face(right, 2)] };
        let last = Ray { node: nodes[1], along: a - b, faces: [face(right, 0), face(left, 2)] };
        [(parts[0] == 0.0).then_some(first), (parts[1] == 1.0).then_some(last)].into_iter().flatten()
    };
    let gap = |nodes: [u32; 2]| {
        let along = ground.place(nodes[1]) - ground.place(nodes[0]);
        let ray = |node, along| Ray { node, along, faces: [Face::default(); 2] };
        [ray(nodes[0], along), ray(nodes[1], -along)]
    };
    let closed = ground.map.closed_gaps(ground.closed_gaps);
    let pieces = straights(ground.map, bends, ground.centers_from_du).flat_map(piece);
    let mut rays: Vec<_> = pieces.chain(closed.flat_map(|closed| gap(closed.nodes))).collect();
    sort::sort_copies_by_key(&mut rays, |ray| sort::float(ray.along.atan2()));
    sort::sort_copies_by_key(&mut rays, |ray| ray.node.into());
    rays
}

#[cfg(test)]
mod tests {
    use kurbo::{Affine, BezPath, Point, Rect, Vec2};
    use scumble_core::{Curve, Drawing, Sampling};

    use super::super::cut_links::{LEAST_FRACTION, WAYS};
    use super::patch::{Patch, Pixel, beside, center};
    use super::*;

    const SIZE_PX: u32 = 64;

    /// A line from a place on, one side of which has a colour.
    fn line(tip_px: Point, tilt: f64, view: &View) -> (PlanarMap, Boundary) {
        let du_from_centers = centers_from_du(view).inverse();
        let mut path = BezPath::new();
        path.move_to(du_from_centers * tip_px);
        path.line_to(du_from_centers * (tip_px + 20.0 * Vec2::from_angle(tilt)));
        let curves = vec![Curve { path, line: None }];
        let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
        let map = PlanarMap::build(&drawing, &Sampling::default()).expect("a map");
        let mut sides = vec![None; map.side_count()];
        map.steps(0).iter().for_each(|step| sides[step.left.index()] = Some([[0.0; 4]; 3]));
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

    #[test]
    fn what_is_steep_at_a_tip_solves_the_equations_wherever_that_lies_among_the_pixels() {
        let px_from_du = Affine::scale(f64::from(SIZE_PX) / 1024.0);
        let view = View { px_from_du, width_px: SIZE_PX, height_px: SIZE_PX };
        let places = (0..10).flat_map(|x| (0..10).map(move |y| Vec2::new(x.into(), y.into()) / 10.0));
        for (tilt, place) in
            [0.0, 0.83, 2.5].into_iter().flat_map(|tilt| places.clone().map(move |p| (tilt, p)))
        {
            let tip_px = Point::new(30.0, 31.0) + place + Vec2::new(0.013, 0.007);
            let (map, boundary) = line(tip_px, tilt, &view);
            let constraints = Constraints::new(&map, &boundary, &view).expect("constraints");
            let constraints = constraints.fitted(&map, &Bends::default(), &boundary, &view);
            let ground = Ground { map: &map, closed_gaps: &[], centers_from_du: centers_from_du(&view) };
            let corners = corners(&ground, &Bends::default(), &boundary);
            let corner =
                corners.iter().find(|c| c.is_singular() && c.tip.distance(tip_px) < 0.1).expect("a corner");
            let patch = Patch::around(corner, 5.0, &constraints, &ground);
            // A pixel on the wall has the value of the wall, whatever it lacks.
            let is_off_wall =
                |pixel: &&Pixel| corner.is_between(center(pixel.at), 2.0 * f64::from(LEAST_FRACTION));
            for pixel in patch.pixels.iter().filter(is_off_wall) {
                let lack = lack(&constraints, corner, &patch, pixel);
                assert!(lack.abs() < 0.25, "{tilt} {tip_px}: {pixel:?} {lack}");
            }
        }
    }
}
