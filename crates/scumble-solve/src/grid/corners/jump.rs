//! What equations lack around a corner where one colour passes into another.
//!
//! There the solution goes evenly from the one to the other as the direction turns from wall to wall, whatever the distance: no
//! pixels follow that near the tip. But it is known, and harmonic, so what it lacks in their equations is given to them: what is
//! left to be found is without a jump. (Subtraction of the singularity, as in H. Motz, *The treatment of singularities of partial
//! differential equations by relaxation methods*, 1947.)

use scumble_core::clamped;

use super::super::constraints::{Constraints, Source};
use super::super::cut_links::{Cut, LEAST_FRACTION, WAYS};
use super::corner::{self, Corner};
use super::ground::Ground;
use super::patch::{Patch, Pixel, beside, center};

/// Farther than this from the tip pixels follow the jump well enough, in px.
const REACH_PX: f64 = 8.0;

/// Walls that do not go on as they are for so many px are not what the jump is known for; and which of their colours pixels see
/// is chance.
const LEAST_APART_PX: f64 = 2.0;

/// Gives constraints the sources of the corners that jump. Cuts were at some places before they were fitted: `fractions`.
pub(super) fn supply(
    constraints: &mut Constraints,
    fractions: &[f32],
    corners: &[Corner],
    ground: &Ground<'_>,
) {
    let mut sources = Vec::new();
    let special = corners.iter().copied().filter(|corner| corner.jump().is_some() || corner.is_singular());
    for (corner, apart_px) in corner::apart(special, REACH_PX) {
        let Some(jump) = corner.jump().filter(|_| apart_px >= LEAST_APART_PX) else { continue };
        let patch = Patch::around(&corner, REACH_PX, constraints, ground);
        for pixel in &patch.pixels {
            let lack = Jump { constraints, fractions, corner: &corner, patch: &patch }.lack(pixel) as f32;
            let color = jump.map(|c| lack * c);
            sources.push(Source { pixel: constraints.pixel(pixel.at), color });
        }
    }
    constraints.sources = sources;
}

/// A corner that jumps.
struct Jump<'a> {
    constraints: &'a Constraints,
    fractions: &'a [f32],
    corner: &'a Corner,
    patch: &'a Patch,
}

impl Jump<'_> {
    /// What the equation of a pixel lacks where the picture is the part of the way from wall to wall.
    fn lack(&self, pixel: &Pixel) -> f64 {
        let links = WAYS.into_iter().map(|(link, way)| match self.patch.cut(pixel.at, link) {
            None => self.patch.width(pixel.at, link) * self.turned(pixel, way, 1.0),
            Some(number) => self.turned_to_wall(pixel, way, number),
        });
        let pulls = self.constraints.pulls_of(self.constraints.pixel(pixel.at)).iter();
        let holds = pulls.filter_map(|pull| {
            let wall_angle = self.corner.angle_of_color(pull.color)?;
            Some(f64::from(pull.strength) * (wall_angle - pixel.angle))
        });
        -links.chain(holds).sum::<f64>() / self.corner.angle
    }

    /// How far the direction turns up to what cuts a link, times how strongly that holds the pixel.
    fn turned_to_wall(&self, pixel: &Pixel, way: [i64; 2], number: usize) -> f64 {
        let (Cut { fraction, color, .. }, before) = (self.constraints.cuts[number], self.fractions[number]);
        if color.is_none() {
            return 0.0;
        }
        let turned = self.turned(pixel, way, before.into());
        // A wall nearer than that is not where the cut says.
        let is_at_wall = before <= LEAST_FRACTION;
        let walls = [0.0, self.corner.angle].map(|angle| angle - pixel.angle);
        let turned = if is_at_wall { clamped(turned, walls) } else { turned };
        turned / f64::from(fraction)
    }

    /// How far the direction turns on a part of the way to the pixel beside.
    fn turned(&self, pixel: &Pixel, way: [i64; 2], part: f64) -> f64 {
        let (from, to) = (center(pixel.at), center(beside(pixel.at, way)));
        self.corner.turned(from, from.lerp(to, part))
    }
}
