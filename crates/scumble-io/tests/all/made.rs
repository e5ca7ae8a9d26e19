//! Scribbles as hands draw them, made from a seed.

use kurbo::Point;
use scumble_core::{Scribble, Srgb8};

use crate::dice::Dice;

/// A session of scribbling with a mouse on a page whose pixels are 1.37 du wide: to and fro in places all over it, fast
/// between the turns and slow at them, with a trembling hand, one point at each of 60 ticks a second that finds the mouse
/// on another pixel.
pub(crate) fn session(seed: u64, count: usize) -> Vec<Scribble> {
    let mut dice = Dice(seed * 2_654_435_761 + 1);
    let colors = [0; 8].map(|_| Srgb8([0; 3].map(|_| dice.below(256) as u8)));
    let mut color = colors[0];
    (0..count)
        .map(|_| {
            if dice.below(5) < 2 {
                color = colors[dice.below(8)];
            }
            Scribble {
                color: color.into(),
                kind: Default::default(),
                width_du: 16.0,
                points: zigzag(&mut dice),
            }
        })
        .collect()
}

fn zigzag(dice: &mut Dice) -> Vec<Point> {
    let middle = Point::new(within(dice, 100.0, 640.0), within(dice, 100.0, 640.0));
    let [across, along] = [0; 2].map(|_| (within(dice, -60.0, 60.0), within(dice, -60.0, 60.0)));
    let mut points: Vec<Point> = Vec::new();
    let (mut from, mut shake) = (middle, (0.0, 0.0));
    for turn in 0..2 + dice.below(5) {
        let side = if turn % 2 == 0 { 1.0 } else { -1.0 } * within(dice, 0.7, 1.2);
        let down = (turn as f64 / 3.0 - 1.0) * within(dice, 0.7, 1.2);
        let to =
            middle + kurbo::Vec2::new(across.0 * side + along.0 * down, across.1 * side + along.1 * down);
        let ticks = 7.0 + (to - from).hypot() / 8.0 * within(dice, 0.8, 1.3);
        for tick in 0..ticks as usize {
            let t = tick as f64 / ticks;
            let eased = 0.5 * t + 0.5 * t * t * (3.0 - 2.0 * t);
            shake = (0.9 * shake.0 + within(dice, -0.4, 0.4), 0.9 * shake.1 + within(dice, -0.4, 0.4));
            let p = from.lerp(to, eased);
            let pixel = Point::new((p.x + shake.0).round() * 1.37, (p.y + shake.1).round() * 1.37);
            if points.last() != Some(&pixel) {
                points.push(pixel);
            }
        }
        from = to;
    }
    points
}

/// A number from `from` to `to`.
fn within(dice: &mut Dice, from: f64, to: f64) -> f64 {
    from + (to - from) * dice.below(1 << 20) as f64 / f64::from(1 << 20)
}
