//! How long one more shading scribble takes, all in: on a drawing with all its scribbles, and among many others.

use kurbo::{Point, Rect, Shape as _, Vec2};
use scumble_core::{Curve, Drawing, Scribble, ScribbleKind, Settings, Shading, Srgb8};
use scumble_solve::Picture;

use crate::clock::{Times, print_head, print_row};
use crate::stages::{self, Opened, SpreadTimes};

/// Widths of the brush, in du: a thin one, and one that is a little thinner than the page opens with.
pub(super) const WIDTHS_DU: [f64; 2] = [16.0, 48.0];

const STRENGTH: f64 = 0.8;

/// The colours by turns.
const COLORS: [Srgb8; 2] = [Srgb8([255, 250, 235]), Srgb8([60, 20, 80])];

/// How far a stroke is moved.
const MOVE_DU: Vec2 = Vec2::new(3.1, 1.7);

/// Shades in one room, among which there is one more.
const CROWDS: [usize; 4] = [1, 20, 100, 200];

/// Their width.
const HATCH_DU: f64 = 24.0;

/// Frames in which one more comes to its end.
const FRAMES: usize = 8;

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
            let mut shade = shade(width_du, scribble.points.clone());
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

fn shade(width_du: f64, points: Vec<Point>) -> Scribble {
    Scribble {
        color: COLORS[0].into(),
        kind: ScribbleKind::Shade(Shading { strength: STRENGTH, ..Shading::default() }),
        width_du,
        points,
    }
}

/// Prints how long each move of a pen takes that shades a room among others, which cross each other there.
pub(super) fn print_crowds() -> anyhow::Result<()> {
    println!();
    print_head(&format!("each move of one more shade, {HATCH_DU} du wide"));
    for count in CROWDS {
        print_row(&format!("among {count}"), &crowd(count)?);
    }
    Ok(())
}

fn crowd(count: usize) -> anyhow::Result<Times> {
    let room = Rect::new(100.0, 100.0, 924.0, 668.0).to_path(0.1);
    let curves = vec![Curve { path: room, line: None }];
    let mut picture = Picture::new(&Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 768.0)) })?;
    let mut shades: Vec<_> = (0..=count).map(|i| hatch(i, FRAMES)).collect();
    let mut times = Times::default();
    for frame in 0..=FRAMES {
        shades[count] = hatch(count, frame);
        let taken = stages::spread(&mut picture, &shades, &[], &Settings::default())?;
        // The first one has all the others to do.
        if frame > 0 {
            times.push(taken.total_ms());
        }
    }
    Ok(times)
}

/// One of many strokes, as far as it is after so many frames.
fn hatch(i: usize, frame: usize) -> Scribble {
    let start = Point::new(160.0 + (i * 73 % 560) as f64, 160.0 + (i * 41 % 400) as f64);
    let way = [Vec2::new(14.0, 5.0), Vec2::new(-3.0, 7.0)][i % 2];
    shade(HATCH_DU, (0..=frame).map(|step| start + step as f64 * way).collect())
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
