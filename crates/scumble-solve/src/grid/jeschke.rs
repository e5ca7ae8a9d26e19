//! The solver of S. Jeschke, D. Cline, P. Wonka, *A GPU Laplacian solver for diffusion curves and Poisson image
//! editing* (2009): a pixel becomes the mean of four on the largest circle around it that touches no curve.
//!
//! It is there to compare with: it is what the paper on scribbles renders with. Pixels with a cut link are the curve:
//! those that a side gives a colour keep it, those beside a side without colour take the mean of their neighbours. The
//! circles come from a jump flood (G. Rong, T.-S. Tan, 2006), and the first picture from the nearest given colours.

use super::cut_links::CutLinks;
use super::level::Level;
use super::texture::{Texel, Texture, plus, times};

/// A picture on its way to the solution.
#[derive(Clone, Debug)]
pub struct JeschkeSolver {
    level: Level,
    /// The colours of pixels at curves, times how strongly they are held.
    right: Texture,
    /// Column and row of the nearest pixel with a cut link, and of the nearest with a given colour; −1 where none is.
    nearest: Texture,
    values: Texture,
}

impl JeschkeSolver {
    /// With the nearest given colour at each pixel.
    pub fn new(cuts: &CutLinks) -> Self {
        let (level, right) = Level::finest(cuts);
        let mut nearest = seeds(cuts, &level);
        let mut reach = level.columns.max(level.rows).next_power_of_two() as i32 / 2;
        while reach > 0 {
            let before = nearest.clone();
            nearest.draw(|x, y| jump(&before, reach, x, y));
            reach /= 2;
        }
        let mut values = right.clone();
        values.draw(|x, y| nearest_color(&level, &right, &nearest, x, y));
        Self { level, right, nearest, values }
    }

    /// One pass over all pixels.
    pub fn step(&mut self) {
        let Self { level, right, nearest, values } = &*self;
        let mut next = Texture::new(values.width, values.height);
        next.draw(|x, y| stencil(level, right, nearest, values, x, y));
        self.values = next;
    }

    /// Blend-space colours times opacity, and opacity, row by row.
    pub fn pixels(&self) -> &[[f32; 4]] {
        &self.values.texels
    }
}

fn seeds(cuts: &CutLinks, level: &Level) -> Texture {
    let mut seeds = Texture::new(level.columns, level.rows);
    seeds.draw(|_, _| [-1.0; 4]);
    for cut in &cuts.cuts {
        let pixel = cut.pixel as usize;
        let place = [pixel % level.columns, pixel / level.columns].map(|c| c as f32);
        seeds.texels[pixel][..2].copy_from_slice(&place);
        if level.holds.texels[pixel][0] > 0.0 {
            seeds.texels[pixel][2..].copy_from_slice(&place);
        }
    }
    seeds
}

/// One pass of the jump flood.
fn jump(nearest: &Texture, reach: i32, x: i32, y: i32) -> Texel {
    let mut best = nearest.load(x, y);
    for (dx, dy) in [(-1, -1), (0, -1), (1, -1), (-1, 0), (1, 0), (-1, 1), (0, 1), (1, 1)] {
        let (nx, ny) = (x + dx * reach, y + dy * reach);
        if nx < 0 || ny < 0 || nx >= nearest.width as i32 || ny >= nearest.height as i32 {
            continue;
        }
        let [a, b, c, d] = nearest.load(nx, ny);
        let [best_a, best_b, best_c, best_d] = best;
        let near = nearer([a, b], [best_a, best_b], x, y);
        let near_color = nearer([c, d], [best_c, best_d], x, y);
        best = [near[0], near[1], near_color[0], near_color[1]];
    }
    best
}

/// The nearer of two places, the second where they are equally near.
fn nearer(a: [f32; 2], b: [f32; 2], x: i32, y: i32) -> [f32; 2] {
    if distance2(a, x, y) < distance2(b, x, y) { a } else { b }
}

/// Squared distance to a place; infinite to none.
fn distance2([px, py]: [f32; 2], x: i32, y: i32) -> f32 {
    let (dx, dy) = (px - x as f32, py - y as f32);
    if px < 0.0 { f32::INFINITY } else { dx * dx + dy * dy }
}

fn nearest_color(level: &Level, right: &Texture, nearest: &Texture, x: i32, y: i32) -> Texel {
    let [_, _, column, row] = nearest.load(x, y).map(|c| c as i32);
    if column < 0 { [0.0; 4] } else { given(level, right, column, row) }
}

fn given(level: &Level, right: &Texture, x: i32, y: i32) -> Texel {
    times(right.load(x, y), 1.0 / level.holds.load(x, y)[0])
}

/// The mean over the largest circle that touches no curve; at a curve the given colour, or the mean of the neighbours.
fn stencil(level: &Level, right: &Texture, nearest: &Texture, values: &Texture, x: i32, y: i32) -> Texel {
    let [column, row, ..] = nearest.load(x, y);
    let radius = distance2([column, row], x, y).sqrt().min(values.width.min(values.height) as f32) as i32;
    if radius > 0 {
        let load = |dx: i32, dy: i32| {
            values.load(mirrored(x + dx * radius, values.width), mirrored(y + dy * radius, values.height))
        };
        return times(plus(plus(load(1, 0), load(-1, 0)), plus(load(0, 1), load(0, -1))), 0.25);
    }
    let [hold, diagonal, ..] = level.holds.load(x, y);
    if hold > 0.0 {
        return given(level, right, x, y);
    }
    let mut sum = [0.0; 4];
    level.for_each_link(x, y, |weight, nx, ny| sum = plus(sum, times(values.load(nx, ny), weight / diagonal)));
    sum
}

/// A column or a row within the picture: beyond its border the picture is mirrored.
fn mirrored(i: i32, count: usize) -> i32 {
    let count = count as i32;
    if i < 0 { -1 - i } else { i.min(2 * count - 1 - i) }
}
