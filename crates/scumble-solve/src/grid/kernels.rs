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

/// A residual damped as the interpolation is.
#[inline]
fn damped(level: &Level, residual: &Texture, x: i32, y: i32) -> Texel {
    times(residual.load(x, y), level.holds.load(x, y)[2])
}

/// The right side of the coarser level: the transpose of [`interpolate`], applied to the residual.
pub fn restrict(level: &Level, coarse: &Level, residual: &Texture, x: i32, y: i32) -> Texel {
    let mut sum = [0.0; 4];
    for (fx, fy) in level.parts(coarse, x, y) {
        let [_, diagonal, damping, _] = level.holds.load(fx, fy);
        let mut smooth = times(residual.load(fx, fy), 1.0 - diagonal * damping);
        level.for_each_link(fx, fy, |weight, nx, ny| {
            smooth = plus(smooth, times(damped(level, residual, nx, ny), weight));
        });
        sum = plus(sum, smooth);
    }
    sum
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

/// A value with the correction of the coarser level: that of its own part, and of those that it is linked to.
pub fn interpolate(level: &Level, values: &Texture, coarse: &Texture, x: i32, y: i32) -> Texel {
    let [_, diagonal, damping, _] = level.holds.load(x, y);
    let mut sum = times(parent_value(level, coarse, x, y), 1.0 - diagonal * damping);
    level.for_each_link(x, y, |weight, nx, ny| {
        sum = plus(sum, times(parent_value(level, coarse, nx, ny), weight * damping));
    });
    plus(values.load(x, y), sum)
}

/// The given colours of a coarser level, by how strongly they hold it, and what is added.
pub fn gather(level: &Level, coarse: &Level, right: &Texture, x: i32, y: i32) -> Texel {
    let mut sum = [0.0; 4];
    level.for_each_hold(coarse, x, y, |part, fx, fy| sum = plus(sum, times(right.load(fx, fy), part)));
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
