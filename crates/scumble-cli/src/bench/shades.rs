//! How long one more shading scribble takes, all in, on a drawing with all its scribbles.

use kurbo::Vec2;
use scumble_core::{Scribble, ScribbleKind, Settings, Shading, Srgb8};

use crate::clock::{Times, print_head, print_row};
use crate::stages::{self, Opened, SpreadTimes};

/// Widths of the brush, in du: a thin one, and one that is a little thinner than the page opens with.
pub(super) const WIDTHS_DU: [f64; 2] = [16.0, 48.0];

const STRENGTH: f64 = 0.8;

/// The colours by turns.
const COLORS: [Srgb8; 2] = [Srgb8([255, 250, 235]), Srgb8([60, 20, 80])];

/// How far a stroke is moved.
const MOVE_DU: Vec2 = Vec2::new(3.1, 1.7);

/// Times of one width of brush, one for each stroke.
#[derive(Debug, Default)]
pub(super) struct ShadeTimes {
    drawn: Times,
    analyse: Times,
    factor: Times,
    moved: Times,
    recolored: Times,
    erased: Times,
}

impl ShadeTimes {
    /// Draws a stroke along each scribble of a drawing in turn, moves it, recolours it, and erases it.
    pub(super) fn take(
        &mut self,
        opened: &mut Opened,
        scribbles: &[Scribble],
        width_du: f64,
    ) -> anyhow::Result<()> {
        let mut spread = |more: &[Scribble]| -> anyhow::Result<SpreadTimes> {
            let all = [scribbles, more].concat();
            Ok(stages::spread(&mut opened.picture, &all, &[], &Settings::default())?)
        };
        spread(&[])?;
        for scribble in scribbles {
            let mut shade = Scribble {
                color: COLORS[0].into(),
                kind: ScribbleKind::Shade(Shading { strength: STRENGTH, ..Shading::default() }),
                width_du,
                points: scribble.points.clone(),
            };
            let times = spread(std::slice::from_ref(&shade))?;
            self.drawn.push(times.total_ms());
            self.analyse.push(times.analyse_ms);
            self.factor.push(times.factor_ms);
            shade.points.iter_mut().for_each(|p| *p += MOVE_DU);
            self.moved.push(spread(std::slice::from_ref(&shade))?.total_ms());
            shade.color = COLORS[1].into();
            self.recolored.push(spread(std::slice::from_ref(&shade))?.total_ms());
            self.erased.push(spread(&[])?.total_ms());
        }
        Ok(())
    }
}

/// Prints the table of one width of brush.
pub(super) fn print(times: &ShadeTimes, width_du: f64) {
    println!();
    print_head(&format!("{} shades, {width_du} du wide", times.drawn.len()));
    for (name, times) in [
        ("one more shade (color to solve)", &times.drawn),
        ("… of which analyse, with its mesh", &times.analyse),
        ("… of which factor", &times.factor),
        ("it is moved", &times.moved),
        ("it is recoloured", &times.recolored),
        ("it is erased", &times.erased),
    ] {
        print_row(name, times);
    }
}
