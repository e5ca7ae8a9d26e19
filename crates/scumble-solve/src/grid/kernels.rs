//! The passes of the grid solver: each computes a texel from the texels around it. `shaders/` has the same by the same
//! names.

use super::level::Level;
use super::texture::{Texel, Texture, minus, plus, times};

/// The matrix times a vector, by the differences along links: their rounding is as small as they are, and along a channel
/// between barriers all of it adds up.
pub fn multiply(level: &Level, values: &Texture, x: i32, y: i32) -> Texel {
    multiplied(level, |x, y| values.load(x, y), x, y)
}

#[inline]
fn multiplied(level: &Level, value_at: impl Fn(i32, i32) -> Texel, x: i32, y: i32) -> Texel {
    let [hold, ..] = level.holds.load(x, y);
    let value = value_at(x, y);
    let mut sum = times(value, hold);
    level.for_each_link(x, y, |weight, nx, ny| {
        sum = plus(sum, times(minus(value, value_at(nx, ny)), weight));
    });
    sum
}

/// What the equations lack.
pub fn residual(level: &Level, values: &Texture, right: &Texture, x: i32, y: i32) -> Texel {
    minus(right.load(x, y), multiply(level, values, x, y))
}

/// One step of Jacobi's method, by part `omega` of the way.
pub fn relax(level: &Level, values: &Texture, right: &Texture, omega: f32, x: i32, y: i32) -> Texel {
    let [_, diagonal, ..] = level.holds.load(x, y);
    let value = values.load(x, y);
    if diagonal > 0.0 {
        plus(value, times(residual(level, values, right, x, y), omega / diagonal))
    } else {
        value
    }
}

/// The first two steps of Jacobi's method from zero, by parts of the way.
pub fn start(level: &Level, right: &Texture, omegas: [f32; 2], x: i32, y: i32) -> Texel {
    let first = |x, y| {
        let [_, diagonal, ..] = level.holds.load(x, y);
        if diagonal > 0.0 { times(right.load(x, y), omegas[0] / diagonal) } else { [0.0; 4] }
    };
    let [_, diagonal, ..] = level.holds.load(x, y);
    if diagonal > 0.0 {
        let residual = minus(right.load(x, y), multiplied(level, first, x, y));
        plus(first(x, y), times(residual, omegas[1] / diagonal))
    } else {
        [0.0; 4]
    }
}

/// What an unknown adds to the right side of the coarser level: the transpose of [`interpolate`], applied to the residual.
pub fn restrict(level: &Level, residual: &Texture, x: i32, y: i32) -> Texel {
    let damped = |x, y| times(residual.load(x, y), level.holds.load(x, y)[2]);
    minus(residual.load(x, y), multiplied(level, damped, x, y))
}

/// The sum of what the unknowns add that one of the coarser level is made of.
pub fn collect(level: &Level, coarse: &Level, shares: &Texture, x: i32, y: i32) -> Texel {
    level.parts(coarse, x, y).fold([0.0; 4], |sum, (x, y)| plus(sum, shares.load(x, y)))
}

/// The value of the coarser unknown that an unknown is a part of.
#[inline]
fn parent_value(level: &Level, coarse: &Texture, x: i32, y: i32) -> Texel {
    let (cell, _) = level.cell_and_slot(x);
    match level.parent(x, y) {
        0 => [0.0; 4],
        slot => coarse.load((slot - 1) * level.columns.div_ceil(2) as i32 + cell / 2, y / 2),
    }
}

/// A value with the correction of the coarser level: that of its own part, made smooth by one damped step of Jacobi's method
/// (smoothed aggregation, see [`super`]).
pub fn interpolate(level: &Level, values: &Texture, coarse: &Texture, x: i32, y: i32) -> Texel {
    let [_, _, damping, _] = level.holds.load(x, y);
    let parts = |x, y| parent_value(level, coarse, x, y);
    let rough = times(multiplied(level, parts, x, y), damping);
    plus(values.load(x, y), minus(parts(x, y), rough))
}

/// The given colours that an unknown adds to those of the coarser level: its own, and those of the unknowns beside it that are
/// parts of none, as far as they reach its part.
pub fn gather(level: &Level, right: &Texture, x: i32, y: i32) -> Texel {
    let [hold, diagonal, ..] = level.holds.load(x, y);
    // Where there is no unknown, nothing is added.
    let mut sum = times(right.load(x, y), (diagonal - hold) / diagonal.max(1e-30));
    level.for_each_link(x, y, |weight, nx, ny| {
        let [_, diagonal, _, parent] = level.holds.load(nx, ny);
        if parent == 0.0 {
            sum = plus(sum, times(right.load(nx, ny), weight / diagonal));
        }
    });
    sum
}

/// A first value: that of the coarser unknown, or, for what is no part of any, the colours that hold it.
pub fn spread(level: &Level, right: &Texture, coarse: &Texture, x: i32, y: i32) -> Texel {
    let [hold, ..] = level.holds.load(x, y);
    match level.parent(x, y) {
        0 if hold > 0.0 => times(right.load(x, y), 1.0 / hold),
        _ => parent_value(level, coarse, x, y),
    }
}

/// What is seen where a layer of colours lies over a picture: that shows by what the last channel of `covers` leaves.
pub fn cover(under: &Texture, colors: &Texture, covers: &Texture, x: i32, y: i32) -> Texel {
    let [.., part] = covers.load(x, y);
    plus(times(under.load(x, y), 1.0 - part), colors.load(x, y))
}
