//! The plain way to compare with: Laplace's equation on pixels, by multigrid.
//!
//! Coloured sides give their colour to the pixels beside them; all other pixels are unknown, and the border of the
//! grid lets nothing through. Geometric coarsening, full-multigrid start, W(2,2) cycles with red-black Gauss-Seidel
//! and bilinear interpolation (W. L. Briggs, V. E. Henson, S. F. McCormick, *A Multigrid Tutorial*, 2000), as a
//! correction scheme. What it lacks on purpose: sides without colour are no barriers, and edges are one pixel wide.

use kurbo::{Point, Vec2};
use scumble_core::{BlendColor, HalfEdge, SideColors, Triangulation};
use scumble_solve::quadratic;

/// The channels of a pixel: blend-space colour times opacity, and opacity.
type Pixel = [f32; 4];

/// Pixels with a given colour, and the unknown ones between them.
#[derive(Clone, Debug)]
pub(crate) struct PixelGrid {
    /// Pixels along one side; a power of two.
    side_px: usize,
    fixed: Vec<Option<Pixel>>,
}

/// The largest change of the last cycle that counts as solved: a quarter of one of 255 levels.
const SOLVED: f32 = 0.25 / 255.0;

/// Cycles after which a grid that is not solved is given up.
const MAX_CYCLES: usize = 60;

/// Coarsest grid, and the sweeps that solve it.
const COARSEST_PX: usize = 4;
const COARSEST_SWEEPS: usize = 32;

impl PixelGrid {
    pub(crate) fn new(side_px: usize) -> Self {
        Self { side_px, fixed: vec![None; side_px * side_px] }
    }

    /// Gives the pixels beside coloured sides their colours.
    pub(crate) fn draw(&mut self, mesh: &Triangulation, colors: &SideColors, px_per_du: f64) {
        for h in mesh.half_edges() {
            let color = mesh.side(h).and_then(|side| colors.get(side.index()).copied().flatten());
            if let Some(color) = color {
                self.draw_side(mesh, h, &color, px_per_du);
            }
        }
    }

    fn draw_side(&mut self, mesh: &Triangulation, h: HalfEdge, color: &[BlendColor; 3], px_per_du: f64) {
        let [a, b] = mesh.segment(h).map(|p| (p.to_vec2() * px_per_du).to_point());
        let [_, inside] = mesh.segment(h.next()).map(|p| (p.to_vec2() * px_per_du).to_point());
        let along = b - a;
        let turn = (inside - a).cross(along).signum();
        let outward = Vec2::new(-along.y, along.x) * (turn / along.hypot());
        let steps = (2.0 * along.hypot()).ceil().max(1.0) as usize;
        for i in 0..=steps {
            let t = i as f64 / steps as f64;
            self.fix(a.lerp(b, t) - outward, blended(color, t));
        }
    }

    /// Gives the pixel that holds a point a colour.
    pub(crate) fn fix(&mut self, p: Point, color: Pixel) {
        let [x, y] = [p.x, p.y].map(|c| c.floor().clamp(0.0, (self.side_px - 1) as f64) as usize);
        self.fixed[y * self.side_px + x] = Some(color);
    }

    /// The colours of all pixels, and the cycles that it took; `None` where it does not converge.
    pub(crate) fn solve(&self) -> Option<(Vec<Pixel>, usize)> {
        let mut grids = vec![self.clone()];
        while let Some(last) = grids.last().filter(|grid| grid.side_px > COARSEST_PX) {
            grids.push(last.coarser());
        }
        let levels: Vec<Level> = grids.iter().map(Level::of).collect();
        let mut pixels = vec![[0.0; 4]; COARSEST_PX * COARSEST_PX];
        for (depth, (grid, level)) in grids.iter().zip(&levels).enumerate().rev() {
            if let Some(coarse) = levels.get(depth + 1) {
                let mut finer = vec![[0.0; 4]; level.fixed.len()];
                coarse.add_to_finer(&pixels, level, &mut finer);
                pixels = finer;
            }
            grid.set_fixed(&mut pixels);
            cycle(&levels[depth..], &mut pixels, &vec![[0.0; 4]; level.fixed.len()]);
        }
        converge(&levels, pixels)
    }

    fn set_fixed(&self, pixels: &mut [Pixel]) {
        for (pixel, fixed) in pixels.iter_mut().zip(&self.fixed) {
            *pixel = fixed.unwrap_or(*pixel);
        }
    }

    /// Half the size; a pixel is given if one of its four is, and has their mean colour.
    fn coarser(&self) -> Self {
        let mut coarse = Self::new(self.side_px / 2);
        for (i, pixel) in coarse.fixed.iter_mut().enumerate() {
            let (x, y) = (i % coarse.side_px, i / coarse.side_px);
            let four = [(0, 0), (1, 0), (0, 1), (1, 1)];
            let given =
                four.iter().filter_map(|(dx, dy)| self.fixed[(2 * y + dy) * self.side_px + 2 * x + dx]);
            let (count, sum) = given.fold((0.0, [0.0; 4]), |(n, sum), color| (n + 1.0, plus(sum, color)));
            *pixel = (count > 0.0).then(|| sum.map(|c| c / count));
        }
        coarse
    }
}

fn converge(levels: &[Level], mut pixels: Vec<Pixel>) -> Option<(Vec<Pixel>, usize)> {
    let nothing = vec![[0.0; 4]; pixels.len()];
    for cycles in 1..=MAX_CYCLES {
        let before = pixels.clone();
        cycle(levels, &mut pixels, &nothing);
        let changes = pixels.as_flattened().iter().zip(before.as_flattened()).map(|(a, b)| (a - b).abs());
        if changes.fold(0.0, f32::max) < SOLVED {
            return Some((pixels, cycles));
        }
    }
    None
}

/// Which pixels of a grid are given.
struct Level {
    side_px: usize,
    fixed: Vec<bool>,
}

/// One W cycle for the equation "sum of differences to the neighbours = right side".
fn cycle(levels: &[Level], pixels: &mut [Pixel], right: &[Pixel]) {
    let [level, coarser @ ..] = levels else { return };
    let Some(coarse) = coarser.first() else {
        (0..COARSEST_SWEEPS).for_each(|_| level.sweep(pixels, right));
        return;
    };
    (0..2).for_each(|_| level.sweep(pixels, right));
    let coarse_right = level.residual_on(coarse, pixels, right);
    let mut correction = vec![[0.0; 4]; coarse_right.len()];
    (0..2).for_each(|_| cycle(coarser, &mut correction, &coarse_right));
    coarse.add_to_finer(&correction, level, pixels);
    (0..2).for_each(|_| level.sweep(pixels, right));
}

impl Level {
    fn of(grid: &PixelGrid) -> Self {
        Self { side_px: grid.side_px, fixed: grid.fixed.iter().map(Option::is_some).collect() }
    }

    /// Sum and number of the neighbours of a pixel.
    fn neighbours(&self, pixels: &[Pixel], x: usize, y: usize) -> (Pixel, f32) {
        let n = self.side_px;
        let i = y * n + x;
        let (mut sum, mut count) = ([0.0; 4], 0.0);
        let mut add = |within: bool, j: usize| {
            if within {
                sum = plus(sum, pixels[j]);
                count += 1.0;
            }
        };
        add(x > 0, i.wrapping_sub(1));
        add(x + 1 < n, i + 1);
        add(y > 0, i.wrapping_sub(n));
        add(y + 1 < n, i + n);
        (sum, count)
    }

    /// Red-black Gauss-Seidel.
    fn sweep(&self, pixels: &mut [Pixel], right: &[Pixel]) {
        for parity in 0..2 {
            for y in 0..self.side_px {
                for x in ((y + parity) % 2..self.side_px).step_by(2) {
                    let i = y * self.side_px + x;
                    if !self.fixed[i] {
                        let (sum, count) = self.neighbours(pixels, x, y);
                        pixels[i] = minus(sum, right[i]).map(|c| c / count);
                    }
                }
            }
        }
    }

    /// What the equation lacks, summed over four pixels: the right side of the correction on the coarser grid.
    fn residual_on(&self, coarse: &Self, pixels: &[Pixel], right: &[Pixel]) -> Vec<Pixel> {
        let mut residual = vec![[0.0; 4]; coarse.fixed.len()];
        for y in 0..self.side_px {
            for x in 0..self.side_px {
                let i = y * self.side_px + x;
                if !self.fixed[i] {
                    let (sum, count) = self.neighbours(pixels, x, y);
                    let lack = minus(right[i], minus(sum, pixels[i].map(|c| c * count)));
                    let below = &mut residual[y / 2 * coarse.side_px + x / 2];
                    *below = plus(*below, lack);
                }
            }
        }
        residual
    }

    /// Adds this grid's pixels, interpolated, to the unknown pixels of the finer grid.
    fn add_to_finer(&self, pixels: &[Pixel], finer: &Self, fine_pixels: &mut [Pixel]) {
        let n = self.side_px;
        let beside = |at: usize| {
            let near = at / 2;
            (near, if at.is_multiple_of(2) { near.saturating_sub(1) } else { (near + 1).min(n - 1) })
        };
        for y in 0..finer.side_px {
            let (near_y, far_y) = beside(y);
            for x in 0..finer.side_px {
                let i = y * finer.side_px + x;
                if finer.fixed[i] {
                    continue;
                }
                let (near_x, far_x) = beside(x);
                let corners = [(near_x, near_y), (far_x, near_y), (near_x, far_y), (far_x, far_y)];
                for ((cx, cy), weight) in corners.into_iter().zip([9.0, 3.0, 3.0, 1.0]) {
                    let part = pixels[cy * n + cx].map(|c| c * weight / 16.0);
                    fine_pixels[i] = plus(fine_pixels[i], part);
                }
            }
        }
    }
}

/// The colour along a side, quadratic between its start, middle and end.
fn blended(color: &[BlendColor; 3], t: f64) -> Pixel {
    let weights = quadratic::edge(t);
    [0, 1, 2, 3]
        .map(|c| color.iter().zip(weights).map(|(color, weight)| color[c] * weight).sum::<f64>() as f32)
}

fn plus(a: Pixel, b: Pixel) -> Pixel {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2], a[3] + b[3]]
}

fn minus(a: Pixel, b: Pixel) -> Pixel {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2], a[3] - b[3]]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn between_two_lines_the_colour_is_linear() {
        let mut grid = PixelGrid::new(64);
        for y in 0..64 {
            grid.fix(Point::new(3.5, f64::from(y)), [0.0, 1.0, 0.5, 1.0]);
            grid.fix(Point::new(53.5, f64::from(y)), [1.0, 0.0, 0.5, 0.0]);
        }
        let (pixels, _) = grid.solve().expect("it converges");
        for (i, pixel) in pixels.iter().enumerate() {
            let red = ((i % 64) as f32 - 3.0).clamp(0.0, 50.0) / 50.0;
            let expected = [red, 1.0 - red, 0.5, 1.0 - red];
            assert!(minus(*pixel, expected).iter().all(|c| c.abs() < 1.0 / 255.0), "{pixel:?} at {i}");
        }
    }

    #[test]
    fn one_colour_fills_the_page() {
        let mut grid = PixelGrid::new(32);
        grid.fix(Point::new(20.0, 9.0), [0.25, 0.5, 0.75, 1.0]);
        let (pixels, _) = grid.solve().expect("it converges");
        assert!(
            pixels.iter().all(|&pixel| minus(pixel, [0.25, 0.5, 0.75, 1.0]).iter().all(|c| c.abs() < 1e-3))
        );
    }
}
