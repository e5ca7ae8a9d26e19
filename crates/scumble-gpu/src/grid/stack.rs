//! The picture and what lies over it.

use scumble_solve::grid::{Constraints, Covers, Size, Texture};

use super::equations::{Changes, Equations};
use super::error::GridError;
use super::gradients::Gradients;
use super::kernels::{Kernel, Kernels};
use super::levels::GpuLevels;
use super::points::Borders;
use super::tape::{Recorder, Tape};
use super::texels::{alike, uploaded, write_rows};
use crate::gpu::Gpu;

/// A step, and what comes of it.
#[derive(Debug)]
pub(super) struct Step {
    pub(super) tape: Tape,
    /// Finds out how large the change was.
    pub(super) measure: Tape,
    /// The picture without its layer.
    pub(super) under: wgpu::TextureView,
    pub(super) seen: wgpu::TextureView,
}

/// A picture that is solved, and its layer.
#[derive(Debug)]
pub(super) struct Stack {
    size_px: [u32; 2],
    equations: Equations,
    borders: Option<Borders>,
    picture: Gradients,
    layer: Option<Layer>,
}

/// What lies over a picture, and the picture under it.
#[derive(Debug)]
struct Layer {
    colors: wgpu::TextureView,
    parts: wgpu::TextureView,
    covered: wgpu::TextureView,
    uploaded: Covers,
}

impl Layer {
    fn new(gpu: &Gpu, covers: &Covers) -> Self {
        let colors = uploaded(gpu, &covers.colors);
        let parts = covers.parts.as_ref().map_or_else(|| colors.clone(), |parts| uploaded(gpu, parts));
        Self { covered: alike(gpu, &colors), colors, parts, uploaded: covers.clone() }
    }

    /// Whether other covers have room in the same textures.
    fn has_room_for(&self, covers: &Covers) -> bool {
        covers.parts.is_some() == self.uploaded.parts.is_some()
    }

    fn update(&mut self, gpu: &Gpu, covers: &Covers) {
        update_rows(gpu, &self.colors, &self.uploaded.colors, &covers.colors);
        if let [Some(before), Some(after)] = [&self.uploaded.parts, &covers.parts] {
            update_rows(gpu, &self.parts, before, after);
        }
        self.uploaded.clone_from(covers);
    }
}

/// Uploads the rows from the first that has changed to the last.
fn update_rows(gpu: &Gpu, view: &wgpu::TextureView, before: &Texture, after: &Texture) {
    let row = |texel: usize| texel / after.width.max(1);
    let mut pairs = before.texels.iter().zip(&after.texels);
    let first = pairs.position(|(a, b)| a != b).map(row);
    let mut pairs = before.texels.iter().zip(&after.texels);
    let last = pairs.rposition(|(a, b)| a != b).map(row);
    if let (Some(first), Some(last)) = (first, last) {
        write_rows(gpu, view, after, first..last + 1);
    }
}

impl Stack {
    /// With what builds its levels, and what makes a first picture.
    pub(super) fn new(
        gpu: &Gpu,
        kernels: &Kernels,
        constraints: &Constraints,
        recorder: &mut Recorder<'_>,
    ) -> Result<(Self, [Tape; 2]), GridError> {
        let sizes = Size::levels(constraints);
        check(gpu, &sizes)?;
        let equations = Equations::new(gpu, kernels, constraints);
        let levels = GpuLevels::new(gpu, kernels, &equations, &sizes);
        levels.build(recorder);
        let build = recorder.take();
        let picture = Gradients::new(gpu, levels, recorder);
        let layer = constraints.covers.as_ref().map(|covers| Layer::new(gpu, covers));
        let size_px = [constraints.width_px, constraints.height_px];
        let borders = equations.borders(gpu, constraints);
        let stack = Self { size_px, equations, borders, picture, layer };
        stack.cover(recorder);
        Ok((stack, [build, recorder.take()]))
    }

    /// Uploads what other constraints have otherwise, where they have room in the same textures.
    pub(super) fn update(
        &mut self,
        gpu: &Gpu,
        kernels: &Kernels,
        constraints: &Constraints,
    ) -> Option<Changes> {
        if self.size_px != [constraints.width_px, constraints.height_px] {
            return None;
        }
        match (&mut self.layer, &constraints.covers) {
            (None, None) => {}
            (Some(layer), Some(covers)) if layer.has_room_for(covers) => layer.update(gpu, covers),
            _ => return None,
        }
        let changes = self.equations.update(gpu, kernels, constraints);
        self.borders = self.equations.borders(gpu, constraints);
        Some(changes)
    }

    /// Has equations at the borders of a part take what a grid of the whole has beyond.
    pub(super) fn look_beyond(&self, gpu: &Gpu, kernels: &Kernels, whole: &wgpu::BindGroup) {
        if let Some(borders) = &self.borders {
            borders.draw(gpu, kernels, whole, &self.equations.right);
        }
    }

    /// A single texel that [`Step::measure`] draws: by how much the last step changed each channel most.
    pub(super) fn change(&self) -> &wgpu::TextureView {
        self.picture.change()
    }

    /// Records a step. After two of them, what is kept lies where it lay before.
    pub(super) fn step(&mut self, recorder: &mut Recorder<'_>) -> Step {
        self.picture.step(recorder);
        let seen = self.cover(recorder).clone();
        let tape = recorder.take();
        self.picture.measure(recorder);
        Step { tape, measure: recorder.take(), under: self.picture.values().clone(), seen }
    }

    /// Records what is seen.
    fn cover(&self, recorder: &mut Recorder<'_>) -> &wgpu::TextureView {
        let under = self.picture.values();
        let Some(Layer { colors, parts, covered, .. }) = &self.layer else { return under };
        recorder.pass(Kernel::Cover, &[under, colors, parts], covered);
        covered
    }
}

/// Whether textures hold what the solver needs.
fn check(gpu: &Gpu, sizes: &[Size]) -> Result<(), GridError> {
    let longest = sizes.iter().map(|size| (size.columns * size.slots).max(size.rows)).max().unwrap_or(0);
    let most = gpu.device.limits().max_texture_dimension_2d;
    if longest > most as usize { Err(GridError::TooLarge { most_px: most }) } else { Ok(()) }
}
