//! A scene on the GPU, and its drawing: the field, then shapes by depth, multisampled, resolved into a target.

use bytemuck::{Pod, Zeroable};
use kurbo::{Affine, Point};
use scumble_core::{Blend, Srgb8};
use scumble_solve::grid::GridProblem;
use scumble_solve::{Field, FieldChange, FieldTriangle, Pixmap, Shape, View};

use crate::error::GpuError;
use crate::gpu::Gpu;
use crate::grid::layer::{self, GridLayer};
use crate::grid::{GpuGridSolver, Kernels as GridKernels};
use crate::items::{self, Coming, Items};
use crate::pipelines;
use crate::read_back::{self, Copy};
use crate::samples::{self, Samples};

/// The longer side of a picture that is read back in one piece, at most: larger ones are tiled, so that their
/// samples stay below 160 MiB.
const TILE_PX: u32 = 2048;

/// Flat shapes that are changed together. Later layers lie over earlier ones, all of them over the field.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Layer {
    /// Scribbles.
    Scribbles,
    /// Fills and lines.
    Ink,
}

/// A scene on the GPU.
///
/// Field and layers stay as they were given until they are given anew; both start empty.
#[derive(Debug)]
pub struct Renderer {
    gpu: Gpu,
    format: wgpu::TextureFormat,
    field_pipeline: wgpu::RenderPipeline,
    shape_pipeline: wgpu::RenderPipeline,
    view_buffer: wgpu::Buffer,
    view_group: wgpu::BindGroup,
    view_layout: wgpu::BindGroupLayout,
    blend: Blend,
    field: Items,
    /// What is there of the next one.
    coming: Option<Coming>,
    /// What the grid solver found, in place of the field.
    solution: Option<Solution>,
    scribbles: Items,
    ink: Items,
    samples: Option<Samples>,
}

/// A solved grid, and what draws it.
#[derive(Debug)]
struct Solution {
    layout: wgpu::BindGroupLayout,
    pipeline: wgpu::RenderPipeline,
    layer: GridLayer,
    /// A part on smaller pixels, which is drawn in place of the whole.
    part: Option<GridLayer>,
}

/// The view as the shaders read it.
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
#[repr(C)]
struct ViewUniform {
    linear: [f32; 4],
    origin_du: [f32; 2],
    origin_clip: [f32; 2],
    oklab: u32,
    padding: [u32; 3],
}

impl Renderer {
    /// A renderer of an empty scene, for targets of one format: `Rgba8Unorm` or `Bgra8Unorm`.
    pub fn new(gpu: &Gpu, format: wgpu::TextureFormat) -> Self {
        let device = &gpu.device;
        let view_layout = device.create_bind_group_layout(&pipelines::VIEW_LAYOUT);
        let view_buffer = device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("view"),
            size: size_of::<ViewUniform>() as u64,
            usage: wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        let view_group = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: Some("view"),
            layout: &view_layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: view_buffer.as_entire_binding() }],
        });
        Self {
            gpu: gpu.clone(),
            format,
            field_pipeline: pipelines::field(device, &view_layout, format),
            shape_pipeline: pipelines::shape(device, &view_layout, format),
            view_buffer,
            view_group,
            view_layout,
            blend: Blend::default(),
            field: Items::default(),
            coming: None,
            solution: None,
            scribbles: Items::default(),
            ink: Items::default(),
            samples: None,
        }
    }

    /// Has what a solver finds for a problem drawn in place of the field, from the next [`Renderer::update_solution`] on.
    pub fn set_problem(&mut self, problem: &GridProblem) {
        self.coming = None;
        self.blend = problem.blend;
        let layer = GridLayer::new(&self.gpu, problem);
        match &mut self.solution {
            Some(solution) => (solution.layer, solution.part) = (layer, None),
            None => self.solution = Some(Solution::new(&self.gpu, &self.view_layout, self.format, layer)),
        }
    }

    /// Takes the picture that a solver has come to.
    pub fn update_solution(&mut self, solver: &GpuGridSolver) {
        if let Some(Solution { layout, layer, .. }) = &mut self.solution {
            layer.group = Some(layer.with_values(&self.gpu, layout, solver.values()));
        }
    }

    /// Has a part of the picture drawn, in place of the whole, as a solver for that finds it, from the next
    /// [`Renderer::update_part`] on.
    pub fn set_part(&mut self, part: Option<&GridProblem>) {
        if let Some(solution) = &mut self.solution {
            solution.part = part.map(|part| GridLayer::new(&self.gpu, part));
        }
    }

    /// Has the solver for the part begin anew, with what that for the whole has beyond its borders.
    pub fn begin_part(&self, kernels: &GridKernels, whole: &GpuGridSolver, solver: &mut GpuGridSolver) {
        if let Some(Solution { layout, layer, part: Some(part), .. }) = &self.solution {
            layer.look(&self.gpu.queue, part.px_from_du);
            solver.begin_within(kernels, &layer.with_values(&self.gpu, layout, whole.under()));
        }
    }

    /// Takes the picture that the solver for the part has come to.
    pub fn update_part(&mut self, solver: &GpuGridSolver) {
        if let Some(Solution { layout, part: Some(part), .. }) = &mut self.solution {
            part.group = Some(part.with_values(&self.gpu, layout, solver.values()));
        }
    }

    /// Replaces the field, which is as the one before but for some changes, and draws it again if it was not drawn.
    pub fn set_field(&mut self, field: &Field, change: &FieldChange) {
        (self.solution, self.coming) = (None, None);
        self.blend = field.blend;
        self.field.write(&self.gpu, &field.triangles, &change.places);
    }

    /// [`Renderer::set_field`], a slice at a time where much has changed: then this is to be called again, with what has
    /// changed since the last call, until all of it is there. What is drawn before is the field as it was.
    pub fn set_field_on(&mut self, field: &Field, change: &FieldChange) {
        let Field { blend, triangles } = field;
        let changed = change.places.start..change.places.end.min(triangles.len());
        if self.coming.is_none() && !items::is_long::<FieldTriangle>(&changed) {
            return self.set_field(field, change);
        }
        let mut coming = self.coming.take().unwrap_or_default();
        if coming.go_on(&self.gpu, triangles, &change.places) {
            (self.field, self.blend, self.solution) = (coming.items, *blend, None);
        } else {
            self.coming = Some(coming);
            // Else all slices would come with the next picture.
            self.gpu.queue.submit([]);
        }
    }

    /// Whether [`Renderer::set_field_on`] is to be called again.
    pub fn awaits_field(&self) -> bool {
        self.coming.is_some()
    }

    /// Replaces the shapes of a layer; later ones lie over earlier ones.
    pub fn set_shapes(&mut self, layer: Layer, shapes: &[Shape]) {
        let (layer, depth_below) = match layer {
            Layer::Scribbles => (&mut self.scribbles, 0.0),
            Layer::Ink => (&mut self.ink, 0.5),
        };
        let items = items::shape_items(shapes, depth_below);
        layer.write(&self.gpu, &items, &(0..items.len()));
    }

    /// Draws what a view shows into a target of the view's size, and hands the commands to the device.
    ///
    /// Without paper, what nothing covers is transparent; colours are premultiplied. The sides of the view must be
    /// 1 px or more and at most the device's largest texture.
    pub fn draw(&mut self, view: &View, paper: Option<Srgb8>, target: &wgpu::TextureView) {
        let uniform = ViewUniform::new(view, self.blend);
        self.gpu.queue.write_buffer(&self.view_buffer, 0, bytemuck::bytes_of(&uniform));
        if let Some(solution) = &self.solution {
            solution.seen().look(&self.gpu.queue, view.px_from_du);
        }
        let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
        self.encode(&mut encoder, view, paper, target);
        self.gpu.queue.submit([encoder.finish()]);
    }

    /// Draws what a view shows into textures of its own, in tiles where it is large, and fetches the pixels.
    ///
    /// Drawing is done when this returns; the future borrows nothing. On the web it never blocks; elsewhere it
    /// waits for the device when it is first polled.
    pub fn read_back(
        &mut self,
        view: &View,
        paper: Option<Srgb8>,
    ) -> impl Future<Output = Result<Pixmap, GpuError>> + use<> {
        let tiles = read_back::tiles(view, TILE_PX);
        let copies =
            tiles.into_iter().map(|(x_px, y_px, tile)| self.draw_copy(x_px, y_px, &tile, paper)).collect();
        let (width_px, height_px) = (view.width_px, view.height_px);
        read_back::collect(self.gpu.device.clone(), copies, width_px, height_px)
    }

    fn draw_copy(&mut self, x_px: u32, y_px: u32, tile: &View, paper: Option<Srgb8>) -> Copy {
        let usage = wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC;
        let texture = samples::texture(&self.gpu.device, tile, 1, self.format, usage);
        self.draw(tile, paper, &texture.create_view(&Default::default()));
        Copy::new(&self.gpu, &texture, x_px, y_px)
    }

    fn encode(
        &mut self,
        encoder: &mut wgpu::CommandEncoder,
        view: &View,
        paper: Option<Srgb8>,
        target: &wgpu::TextureView,
    ) {
        let samples = self.samples.take().filter(|samples| samples.fit(view));
        let samples = samples.unwrap_or_else(|| Samples::new(&self.gpu.device, view, self.format));
        let mut pass = samples.begin(encoder, paper, target);
        pass.set_bind_group(0, &self.view_group, &[]);
        match &self.solution {
            Some(solution) => solution.draw(&mut pass),
            None => self.draw_field(&mut pass),
        }
        pass.set_pipeline(&self.shape_pipeline);
        for (buffer, count) in self.scribbles.parts().chain(self.ink.parts()) {
            pass.set_vertex_buffer(0, buffer.slice(..));
            pass.draw(0..3 * count, 0..1);
        }
        drop(pass);
        self.samples = Some(samples);
    }

    fn draw_field(&self, pass: &mut wgpu::RenderPass<'_>) {
        pass.set_pipeline(&self.field_pipeline);
        for (buffer, count) in self.field.parts() {
            pass.set_vertex_buffer(0, buffer.slice(..));
            pass.draw(0..3, 0..count);
        }
    }
}

impl Solution {
    fn new(
        gpu: &Gpu,
        view_layout: &wgpu::BindGroupLayout,
        format: wgpu::TextureFormat,
        layer: GridLayer,
    ) -> Self {
        let layout = layer::layout(&gpu.device);
        let pipeline = pipelines::solution(&gpu.device, [view_layout, &layout], format);
        Self { layout, pipeline, layer, part: None }
    }

    /// What is drawn.
    fn seen(&self) -> &GridLayer {
        self.part.as_ref().filter(|part| part.group.is_some()).unwrap_or(&self.layer)
    }

    fn draw(&self, pass: &mut wgpu::RenderPass<'_>) {
        if let Some(group) = &self.seen().group {
            pass.set_pipeline(&self.pipeline);
            pass.set_bind_group(1, group, &[]);
            pass.draw(0..3, 0..1);
        }
    }
}

impl ViewUniform {
    /// Positions are taken relative to a place in the middle of the view that `f32` holds exactly.
    fn new(view: &View, blend: Blend) -> Self {
        let (width, height) = (f64::from(view.width_px), f64::from(view.height_px));
        let clip_from_px = Affine::new([2.0 / width, 0.0, 0.0, -2.0 / height, -1.0, 1.0]);
        let clip_from_du = clip_from_px * view.px_from_du;
        let center = view.px_from_du.inverse() * Point::new(width / 2.0, height / 2.0);
        let origin_du = [center.x, center.y].map(|c| if c.is_finite() { c as f32 } else { 0.0 });
        let origin_clip = clip_from_du * Point::new(f64::from(origin_du[0]), f64::from(origin_du[1]));
        let [a, b, c, d, ..] = clip_from_du.as_coeffs();
        Self {
            linear: [a, b, c, d].map(|v| v as f32),
            origin_du,
            origin_clip: [origin_clip.x as f32, origin_clip.y as f32],
            oklab: u32::from(blend == Blend::Oklab),
            padding: [0; 3],
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the vertex shader does.
    fn clip(uniform: &ViewUniform, position_du: [f32; 2]) -> [f32; 2] {
        let ViewUniform { linear: [a, b, c, d], origin_du, origin_clip, .. } = *uniform;
        let [x, y] = [position_du[0] - origin_du[0], position_du[1] - origin_du[1]];
        [origin_clip[0] + a * x + c * y, origin_clip[1] + b * x + d * y]
    }

    #[test]
    fn positions_are_right_to_a_thousandth_of_a_pixel_at_the_largest_zoom() {
        let px_from_du = Affine::scale(64.0) * Affine::rotate(0.1) * Affine::translate((-1015.3, -1016.7));
        let view = View { px_from_du, width_px: 1000, height_px: 600 };
        let uniform = ViewUniform::new(&view, Blend::Oklab);
        for position_du in [[1015.3_f32, 1016.9], [1023.0, 1023.0], [1024.0, 1018.0]] {
            let [x, y] = clip(&uniform, position_du).map(f64::from);
            let exact = px_from_du * Point::new(f64::from(position_du[0]), f64::from(position_du[1]));
            let drawn = Point::new((x + 1.0) * 500.0, (1.0 - y) * 300.0);
            assert!(drawn.distance(exact) < 1e-3, "{drawn} {exact}");
        }
    }

    #[test]
    fn a_view_of_nothing_is_still_a_view() {
        let view = View { px_from_du: Affine::scale(0.0), width_px: 10, height_px: 10 };
        assert_eq!(ViewUniform::new(&view, Blend::Srgb).origin_du, [0.0; 2]);
    }
}
