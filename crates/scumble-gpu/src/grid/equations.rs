//! The equations of pixels on the GPU, where they stay: what changes of them is drawn over them, point by point.

use scumble_solve::grid::{Constraints, Equation, Exits};

use super::kernels::Kernels;
use super::points::{Borders, Points};
use super::texels::{FORMAT, THIN_FORMAT, target};
use crate::gpu::Gpu;

/// How other equations differ from those before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Changes {
    /// Pixels with another equation.
    pub(super) pixels: usize,
    /// Whether there are others than right sides.
    pub(super) weights: bool,
}

/// What of equations is drawn.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Part {
    /// All, over plain ones everywhere.
    First,
    /// All, over those before.
    All,
    /// Right sides, over those before.
    Right,
}

/// Textures with a texel for each pixel, and what is in them.
#[derive(Debug)]
pub(crate) struct Equations {
    size_px: [u32; 2],
    pub(super) east: wgpu::TextureView,
    pub(super) south: wgpu::TextureView,
    pub(super) hold: wgpu::TextureView,
    pub(super) right: wgpu::TextureView,
    drawn: Vec<Equation>,
}

impl Equations {
    /// Those of constraints.
    pub(crate) fn new(gpu: &Gpu, kernels: &Kernels, constraints: &Constraints) -> Self {
        let size_px = [constraints.width_px, constraints.height_px];
        let [east, south, hold] = [(); 3].map(|()| target(gpu, size_px, THIN_FORMAT));
        let right = target(gpu, size_px, FORMAT);
        let drawn = constraints.equations();
        let equations = Self { size_px, east, south, hold, right, drawn };
        equations.draw(gpu, kernels, &equations.drawn, Part::First);
        equations
    }

    /// Draws what other constraints, of as many pixels, have otherwise.
    pub(super) fn update(&mut self, gpu: &Gpu, kernels: &Kernels, constraints: &Constraints) -> Changes {
        let after = constraints.equations();
        let changed = changes(&self.drawn, &after);
        let weights = !have_same_weights(&self.drawn, &after);
        self.drawn = after;
        self.draw(gpu, kernels, &changed, if weights { Part::All } else { Part::Right });
        Changes { pixels: changed.len(), weights }
    }

    /// Draws a part of some equations.
    fn draw(&self, gpu: &Gpu, kernels: &Kernels, equations: &[Equation], part: Part) {
        let plain = |number: f32| (part == Part::First).then_some(number);
        let points =
            Points::new(gpu, kernels, &equations.iter().map(|e| self.center(e.pixel)).collect::<Vec<_>>());
        let mut encoder = gpu.device.create_command_encoder(&Default::default());
        if part != Part::Right {
            points.draw(&mut encoder, &self.east, plain(1.0), &numbers(equations, |e| e.east));
            points.draw(&mut encoder, &self.south, plain(1.0), &numbers(equations, |e| e.south));
            points.draw(&mut encoder, &self.hold, plain(0.0), &numbers(equations, |e| e.hold));
        }
        points.draw(&mut encoder, &self.right, plain(0.0), &numbers(equations, |e| e.right));
        gpu.queue.submit([encoder.finish()]);
    }

    /// What holds pixels to what is beyond borders; none where there is nothing.
    pub(super) fn borders(&self, gpu: &Gpu, constraints: &Constraints) -> Option<Borders> {
        let exits = &constraints.exits;
        let right = |exits: &Exits| {
            let place = self.drawn.binary_search_by_key(&exits.pixel, |equation| equation.pixel);
            place.map_or([0.0; 4], |place| self.drawn[place].right)
        };
        let centers: Vec<_> = exits.iter().map(|exits| self.center(exits.pixel)).collect();
        let rights: Vec<_> = exits.iter().map(right).collect();
        let links: Vec<_> = exits.iter().map(|exits| exits.links).collect();
        (!exits.is_empty()).then(|| Borders::new(gpu, &centers, &rights, &links))
    }

    /// The centre of a pixel in clip space.
    fn center(&self, pixel: u32) -> [f32; 2] {
        let [width, height] = self.size_px;
        let part = |i: u32, count: u32| (2 * i + 1) as f32 / count as f32 - 1.0;
        [part(pixel % width, width), -part(pixel / width, height)]
    }
}

fn numbers<T>(equations: &[Equation], number: impl Fn(&Equation) -> T) -> Vec<T> {
    equations.iter().map(number).collect()
}

/// Whether equations of the same pixels differ in their right sides alone.
fn have_same_weights(before: &[Equation], after: &[Equation]) -> bool {
    let weights = |e: &Equation| [e.east, e.south, e.hold];
    let mut pairs = before.iter().zip(after);
    before.len() == after.len() && pairs.all(|(a, b)| a.pixel == b.pixel && weights(a) == weights(b))
}

/// The equations that are not as before, by pixel; some of them are plain.
fn changes(before: &[Equation], after: &[Equation]) -> Vec<Equation> {
    let (mut before, mut changed) = (before.iter().peekable(), Vec::new());
    let plain = |e: &Equation| Equation { pixel: e.pixel, ..Equation::PLAIN };
    for equation in after {
        while let Some(gone) = before.next_if(|old| old.pixel < equation.pixel) {
            changed.push(plain(gone));
        }
        if before.next_if(|old| old.pixel == equation.pixel) != Some(equation) {
            changed.push(*equation);
        }
    }
    changed.extend(before.map(plain));
    changed
}
