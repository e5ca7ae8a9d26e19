//! The canvas of the page and what paints it: a renderer on the GPU, that of the other build, or the painter on the CPU.
//!
//! A canvas takes one kind of context in its life. WebGPU claims it only after its device is there; WebGL cannot be
//! had without claiming it, and after a failure wants another canvas.

use js_sys::Date;
use scumble_core::Srgb8;
use scumble_gpu::wgpu::{self, CurrentSurfaceTexture};
use scumble_gpu::{
    Gpu, GpuError, GpuGridSolver, GridKernels, Layer, Renderer, instance, probe, surface_format,
};
use scumble_solve::grid::{FRAME_STEPS, GridProblem, PAGE_STEPS};
use scumble_solve::{Field, FieldChange, Pixmap, Shape, View};
use thiserror::Error;
use wasm_bindgen::{Clamped, JsCast};
use web_sys::{CanvasRenderingContext2d, HtmlCanvasElement, ImageData};

#[cfg(feature = "webgpu")]
use crate::beside::BesideScreen;
use crate::painting::{Changed, Painter, Painting};
use crate::solver::Grids;
use crate::strips::{Frame, Painted, StripPainter};

/// The name of the painter on the CPU.
pub const CPU: &str = "cpu";
/// The name of the renderer with WebGL 2, which is in a build of its own.
const WEBGL: &str = "webgl";
/// The name of the renderer on the GPU that this build has.
pub const GPU: &str = if cfg!(feature = "webgl") { WEBGL } else { "webgpu" };

/// The name of the renderer that follows one of a name, once that is given up.
pub fn after(renderer: &str) -> Option<&'static str> {
    match renderer {
        CPU => None,
        WEBGL => Some(CPU),
        _ => Some(WEBGL),
    }
}

/// Why a canvas cannot be painted.
#[derive(Debug, Error)]
pub enum ScreenError {
    /// No device, or none that draws as it should.
    #[error(transparent)]
    Gpu(#[from] GpuError),
    /// The browser gave no context for the canvas.
    #[error("the canvas cannot be painted ({0}); try another browser")]
    Canvas(String),
}

/// A canvas with what paints it.
#[derive(Debug)]
pub enum Screen {
    /// A renderer on the GPU.
    Gpu(Box<GpuScreen>),
    /// The renderer of the other build.
    #[cfg(feature = "webgpu")]
    Beside(BesideScreen),
    /// The painter on the CPU.
    Cpu(CpuScreen),
}

impl Screen {
    /// Claims a canvas for the renderer of a name. `on_failure` is called when its device is lost.
    ///
    /// # Errors
    /// When there is no such renderer here, or it draws wrong colours; the canvas may be spoilt then.
    pub async fn open(
        canvas: HtmlCanvasElement,
        renderer: &str,
        on_failure: impl Fn(GpuError) + Send + Sync + 'static,
    ) -> Result<Self, ScreenError> {
        match renderer {
            CPU => Ok(Self::Cpu(CpuScreen::open(canvas)?)),
            GPU => Ok(Self::Gpu(Box::new(GpuScreen::open(canvas, on_failure).await?))),
            _ => Err(ScreenError::Canvas(format!("no {renderer} here"))),
        }
    }

    /// The name of what paints.
    pub fn renderer(&self) -> &'static str {
        match self {
            Self::Gpu(_) => GPU,
            #[cfg(feature = "webgpu")]
            Self::Beside(_) => WEBGL,
            Self::Cpu(_) => CPU,
        }
    }

    /// What it can do with grids.
    pub fn grids(&self) -> Grids {
        match self {
            Self::Gpu(screen) => screen.grids(),
            _ => Grids::No,
        }
    }
}

impl Painter for Screen {
    fn paint(&mut self, painting: &Painting<'_>, changed: Changed) -> bool {
        match self {
            Self::Gpu(screen) => screen.paint(painting, changed),
            #[cfg(feature = "webgpu")]
            Self::Beside(painter) => {
                painter.show(painting, changed);
                true
            }
            Self::Cpu(screen) => screen.paint(painting, &changed),
        }
    }
}

/// A canvas that a GPU paints.
#[derive(Debug)]
pub struct GpuScreen {
    canvas: HtmlCanvasElement,
    gpu: Gpu,
    surface: wgpu::Surface<'static>,
    config: wgpu::SurfaceConfiguration,
    renderer: Renderer,
    /// Once there has been a problem to solve.
    kernels: Option<GridKernels>,
    solving: Option<Solving>,
    /// The part in view.
    part: Option<Solving>,
}

/// A problem on its way to its solution, a few steps a frame: nothing is waited for, so their number is given.
#[derive(Debug)]
struct Solving {
    solver: GpuGridSolver,
    steps_left: usize,
}

impl Solving {
    /// Takes other constraints, as far as can be with what is there of a problem.
    fn begun(before: Option<Self>, gpu: &Gpu, kernels: &GridKernels, problem: &GridProblem) -> Option<Self> {
        // Grids of the page fit into the textures of every device.
        let solver = match before {
            Some(Self { mut solver, .. }) => solver.update(kernels, &problem.constraints).map(|_| solver),
            None => GpuGridSolver::new(gpu, kernels, &problem.constraints),
        };
        solver.ok().map(|solver| Self { solver, steps_left: PAGE_STEPS })
    }

    /// Goes on for a frame; tells whether that was the last.
    fn go_on(&mut self) -> bool {
        let steps = FRAME_STEPS.min(self.steps_left);
        (0..steps).for_each(|_| self.solver.step());
        self.steps_left -= steps;
        steps > 0 && self.steps_left == 0
    }
}

/// Whether what goes to the GPU is copied in the page first, which takes its time.
const IS_COPIED: bool = cfg!(feature = "webgl");

impl GpuScreen {
    pub(crate) async fn open(
        canvas: HtmlCanvasElement,
        on_failure: impl Fn(GpuError) + Send + Sync + 'static,
    ) -> Result<Self, ScreenError> {
        let instance = instance();
        let claim = || {
            let target = wgpu::SurfaceTarget::Canvas(canvas.clone());
            instance.create_surface(target).map_err(|error| ScreenError::Canvas(error.to_string()))
        };
        let (gpu, surface) = if cfg!(feature = "webgl") {
            let surface = claim()?;
            (Gpu::open(&instance, Some(&surface), on_failure).await?, surface)
        } else {
            (Gpu::open(&instance, None, on_failure).await?, claim()?)
        };
        let config = configuration(&surface, &gpu)?;
        let mut renderer = Renderer::new(&gpu, config.format);
        probe(&mut renderer).await?;
        Ok(Self { canvas, gpu, surface, config, renderer, kernels: None, solving: None, part: None })
    }

    fn grids(&self) -> Grids {
        match self.gpu.adapter.get_info().device_type {
            wgpu::DeviceType::Cpu => Grids::Slow,
            _ => Grids::Fast,
        }
    }

    fn paint(&mut self, painting: &Painting<'_>, changed: Changed) -> bool {
        self.upload(painting, changed);
        self.solve_on();
        if self.awaits_field() {
            // What else is new would lie over another field; and drawing that keeps the rest from coming.
            return false;
        }
        self.show(&painting.view, painting.paper);
        self.solving.iter().chain(&self.part).all(|solving| solving.steps_left == 0)
    }

    /// Draws what there is of a view.
    pub(crate) fn show(&mut self, view: &View, paper: Option<Srgb8>) {
        self.resize(view);
        // A frame that cannot be had is dropped: a lost device is reported by itself.
        if let CurrentSurfaceTexture::Success(frame) | CurrentSurfaceTexture::Suboptimal(frame) =
            self.surface.get_current_texture()
        {
            let target = frame.texture.create_view(&wgpu::TextureViewDescriptor::default());
            self.renderer.draw(view, paper, &target);
            self.gpu.queue.present(frame);
        }
    }

    pub(crate) fn set_field(&mut self, field: &Field, change: &FieldChange) {
        (self.solving, self.part) = (None, None);
        self.renderer.set_field(field, change);
    }

    /// [`GpuScreen::set_field`], as far as there is time for in a frame.
    fn set_field_on(&mut self, field: &Field, change: &FieldChange) {
        if IS_COPIED {
            (self.solving, self.part) = (None, None);
            self.renderer.set_field_on(field, change);
        } else {
            self.set_field(field, change);
        }
    }

    fn awaits_field(&self) -> bool {
        IS_COPIED && self.renderer.awaits_field()
    }

    pub(crate) fn set_shapes(&mut self, layer: Layer, shapes: &[Shape]) {
        self.renderer.set_shapes(layer, shapes);
    }

    /// Takes a problem, if it is another one, to its first picture, and a part of it.
    fn begin(&mut self, problem: &GridProblem, part: Option<&GridProblem>, is_other: bool) {
        let kernels = self.kernels.get_or_insert_with(|| GridKernels::new(&self.gpu));
        let begun = |before, problem| Solving::begun(before, &self.gpu, kernels, problem);
        if is_other {
            self.renderer.set_problem(problem);
            self.solving = begun(self.solving.take(), problem);
        }
        self.renderer.set_part(part);
        let part = part.filter(|_| self.solving.is_some());
        self.part = part.and_then(|part| begun(self.part.take(), part));
    }

    /// The part begins with the first picture of the whole, and anew with the last.
    fn solve_on(&mut self) {
        let Some(whole) = &mut self.solving else { return };
        let is_last = whole.go_on();
        self.renderer.update_solution(&whole.solver);
        if let (Some(part), Some(kernels)) = (&mut self.part, &self.kernels) {
            let has_begun = part.steps_left < PAGE_STEPS;
            if is_last || !has_begun {
                self.renderer.begin_part(kernels, &whole.solver, &mut part.solver);
                part.steps_left = PAGE_STEPS;
            }
            part.go_on();
            self.renderer.update_part(&part.solver);
        }
    }

    fn resize(&mut self, view: &View) {
        if (self.config.width, self.config.height) != (view.width_px, view.height_px) {
            (self.config.width, self.config.height) = (view.width_px, view.height_px);
            set_size(&self.canvas, [view.width_px, view.height_px]);
            self.surface.configure(&self.gpu.device, &self.config);
        }
    }

    fn upload(&mut self, painting: &Painting<'_>, changed: Changed) {
        match painting.problem {
            Some(problem) if changed.problem || changed.part => {
                self.begin(problem, painting.part, changed.problem);
            }
            None if changed.field.is_any() || self.awaits_field() => {
                self.set_field_on(painting.field, &changed.field);
            }
            _ => {}
        }
        if changed.scribbles {
            self.set_shapes(Layer::Scribbles, painting.layers.scribbles());
        }
        if changed.ink {
            self.set_shapes(Layer::Ink, painting.layers.ink());
        }
    }
}

/// Bytes are shown as they are written; the size is set with the first painting.
fn configuration(surface: &wgpu::Surface<'_>, gpu: &Gpu) -> Result<wgpu::SurfaceConfiguration, ScreenError> {
    let missing = || ScreenError::Canvas("the GPU has no format for it".into());
    let format = surface_format(&surface.get_capabilities(&gpu.adapter)).ok_or_else(missing)?;
    let config = surface.get_default_config(&gpu.adapter, 1, 1).ok_or_else(missing)?;
    // What lies under the canvas is seen where there is no paper: a canvas of WebGL is so by itself.
    let alpha_mode =
        if cfg!(feature = "webgl") { config.alpha_mode } else { wgpu::CompositeAlphaMode::PreMultiplied };
    Ok(wgpu::SurfaceConfiguration { format, width: 0, height: 0, alpha_mode, ..config })
}

/// While a frame has not taken longer, another strip is painted.
const FRAME_MS: f64 = 8.0;

/// A canvas that the painter on the CPU fills.
#[derive(Debug)]
pub struct CpuScreen {
    canvas: HtmlCanvasElement,
    context: CanvasRenderingContext2d,
    painter: StripPainter,
}

impl CpuScreen {
    fn open(canvas: HtmlCanvasElement) -> Result<Self, ScreenError> {
        let context = canvas.get_context("2d").ok().flatten().and_then(|context| context.dyn_into().ok());
        let context = context.ok_or_else(|| ScreenError::Canvas("no 2D context".into()))?;
        Ok(Self { canvas, context, painter: StripPainter::default() })
    }

    fn paint(&mut self, painting: &Painting<'_>, changed: &Changed) -> bool {
        let start_ms = Date::now();
        let Frame { size_px, parts, is_all } =
            self.painter.paint(painting, changed, || Date::now() < start_ms + FRAME_MS);
        if !parts.is_empty() && [self.canvas.width(), self.canvas.height()] != size_px {
            set_size(&self.canvas, size_px);
        }
        parts.iter().for_each(|painted| self.show(painted));
        is_all
    }

    fn show(&self, ([x_px, y_px], Pixmap { width_px, height_px, rgba }): &Painted) {
        let image = ImageData::new_with_u8_clamped_array_and_sh(Clamped(rgba), *width_px, *height_px);
        if let Ok(image) = image {
            // Fails for a detached buffer only, which a fresh one is not.
            let _ = self.context.put_image_data(&image, (*x_px).into(), (*y_px).into());
        }
    }
}

fn set_size(canvas: &HtmlCanvasElement, [width_px, height_px]: [u32; 2]) {
    canvas.set_width(width_px);
    canvas.set_height(height_px);
}
