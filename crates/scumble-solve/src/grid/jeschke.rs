//! The solver of S. Jeschke, D. Cline, P. Wonka, *A GPU Laplacian solver for diffusion curves and Poisson image
//! editing* (2009): a pixel becomes the mean of four on the largest circle around it that touches no curve.
//!
//! It is there to compare with: it is what the paper on scribbles renders with. It knows no shading. Pixels with a cut link are the curve:
//! those that a side gives a colour keep it, those beside a side without colour take the mean of their neighbours. The
//! circles come from a jump flood (G. Rong, T.-S. Tan, 2006), as does the first picture: the nearest given colour at each
//! pixel, save in regions that have none.

use super::constraints::Constraints;
use super::cut_links::Cut;
use super::level::Level;
use super::texture::{Texel, Texture, plus, times};

/// A picture on its way to the solution.
#[derive(Clone, Debug)]
pub struct JeschkeSolver {
    level: Level,
    /// The colours of pixels at curves, times how strongly they are held.
    right: Texture,
    /// Column and row of the nearest pixel with a cut link; −1 where there is none.
    nearest: Texture,
    values: Texture,
}

impl JeschkeSolver {
    /// With the nearest given colour at each pixel.
    pub fn new(constraints: &Constraints) -> Self {
        let constraints = &Constraints { pulls: Vec::new(), sources: Vec::new(), ..constraints.clone() };
        let (level, right) = Level::finest(constraints);
        let nearest = nearest_of(constraints, |cut| cut.color.is_some() || constraints.leads_within(cut));
        let nearest_given = nearest_of(constraints, |cut| cut.color.is_some());
        let is_unreached = constraints.unreached();
        let mut values = right.clone();
        values.draw(|x, y| {
            let [column, row, ..] = nearest_given.load(x, y).map(|c| c as i32);
            let is_unreached = is_unreached[y as usize * level.columns + x as usize];
            if is_unreached { [0.0; 4] } else { given(&level, &right, column, row) }
        });
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

/// Column and row of the pixel nearest to each among those with cuts that count; −1 where there is none.
fn nearest_of(constraints: &Constraints, counts: impl Fn(&Cut) -> bool) -> Texture {
    let mut nearest = Texture::new(constraints.width_px as usize, constraints.height_px as usize);
    nearest.draw(|_, _| [-1.0; 4]);
    for cut in constraints.cuts.iter().filter(|cut| counts(cut)) {
        let [column, row] =
            [cut.pixel % constraints.width_px, cut.pixel / constraints.width_px].map(|c| c as f32);
        nearest.texels[cut.pixel as usize] = [column, row, 0.0, 0.0];
    }
    let mut reach = constraints.width_px.max(constraints.height_px).next_power_of_two() as i32 / 2;
    while reach > 0 {
        let before = nearest.clone();
        nearest.draw(|x, y| jump(&before, reach, x, y));
        reach /= 2;
    }
    nearest
}

/// One pass of the jump flood.
fn jump(nearest: &Texture, reach: i32, x: i32, y: i32) -> Texel {
    let mut best = nearest.load(x, y);
    for (dx, dy) in [(-1, -1), (0, -1), (1, -1), (-1, 0), (1, 0), (-1, 1), (0, 1), (1, 1)] {
        let (nx, ny) = (x + dx * reach, y + dy * reach);
        let is_within = nx >= 0 && ny >= 0 && nx < nearest.width as i32 && ny < nearest.height as i32;
        let other = nearest.load(nx, ny);
        if is_within && distance2(other, x, y) < distance2(best, x, y) {
            best = other;
        }
    }
    best
}

/// Squared distance to a place; infinite to none.
fn distance2([px, py, ..]: Texel, x: i32, y: i32) -> f32 {
    let (dx, dy) = (px - x as f32, py - y as f32);
    if px < 0.0 { f32::INFINITY } else { dx * dx + dy * dy }
}

fn given(level: &Level, right: &Texture, x: i32, y: i32) -> Texel {
    times(right.load(x, y), 1.0 / level.holds.load(x, y)[0])
}

/// The mean over the largest circle that touches no curve; at a curve the given colour, or the mean of the neighbours.
fn stencil(level: &Level, right: &Texture, nearest: &Texture, values: &Texture, x: i32, y: i32) -> Texel {
    let radius =
        distance2(nearest.load(x, y), x, y).sqrt().min(values.width.min(values.height) as f32) as i32;
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
    level
        .for_each_link(x, y, |weight, nx, ny| sum = plus(sum, times(values.load(nx, ny), weight / diagonal)));
    sum
}

/// A column or a row within the picture: beyond its border the picture is mirrored.
fn mirrored(i: i32, count: usize) -> i32 {
    let count = count as i32;
    if i < 0 { -1 - i } else { i.min(2 * count - 1 - i) }
}
