//! What JavaScript calls. Opening a renderer takes time: it goes on beside the calls, and `wake` asks the page for a
//! frame, with whose effects its outcome comes.

use std::cell::{Cell, RefCell};
use std::rc::Rc;

use js_sys::{Array, Function};
use scumble_core::Srgb8;
use scumble_gpu::GpuError;
use wasm_bindgen::prelude::wasm_bindgen;
use wasm_bindgen::{JsCast, JsError, JsValue};
use wasm_bindgen_futures::spawn_local;
use web_sys::{HtmlCanvasElement, console};

#[cfg(feature = "webgpu")]
use crate::beside::BesideScreen;
use crate::boundary::{
    color, color_model_from_name, command_from_js, field, js_from_effects, js_from_history,
};
use crate::command::Phase;
use crate::effect::Effect;
use crate::painting::PAPER;
use crate::screen::{self, GPU, Screen};
use crate::session::Session;

/// A device that is lost or not had this often while nobody draws is not asked for again: it may be lost by what is drawn.
const LOSSES_BORNE: u32 = 3;

thread_local! {
    /// Set from callbacks of the GPU, which may own nothing of JavaScript.
    static DEVICE_LOST: Cell<bool> = const { Cell::new(false) };
    static WAKE: RefCell<Option<Function>> = const { RefCell::new(None) };
}

/// The editor behind the page.
#[wasm_bindgen]
#[derive(Debug)]
pub struct App {
    shared: Rc<RefCell<Shared>>,
}

struct Shared {
    session: Session,
    /// `None` while a renderer is being opened.
    screen: Option<Screen>,
    /// How often the renderer of the moment was lost or not had since the pen did something.
    losses: u32,
}

#[wasm_bindgen]
impl App {
    /// Claims a canvas. Options: `renderer` ("webgpu", "webgl" or "cpu"), `desk` (the colour around the page, as
    /// #rrggbb), `wake` (called when there is a frame to ask for).
    ///
    /// # Errors
    /// When the renderer does not start here; the canvas may be spoilt then.
    pub async fn create(canvas: HtmlCanvasElement, options: JsValue) -> Result<App, JsError> {
        std::panic::set_hook(Box::new(|panic| console::error_1(&panic.to_string().into())));
        let desk = color(&field(&options, "desk")).ok_or_else(|| missing("desk"))?;
        let renderer = field(&options, "renderer").as_string().ok_or_else(|| missing("renderer"))?;
        let wake = field(&options, "wake").dyn_into().map_err(|_| missing("wake"))?;
        WAKE.with_borrow_mut(|slot| *slot = Some(wake));
        let mut session = Session::new(desk)?;
        let screen = Screen::open(canvas, &renderer, on_device_failure).await?;
        session.tell(Effect::Renderer(screen.renderer()));
        session.set_grids(screen.grids());
        let shared = Shared { session, screen: Some(screen), losses: 0 };
        Ok(Self { shared: Rc::new(RefCell::new(shared)) })
    }

    /// Takes pointer samples (see [`Session::pointer`]) of a phase: "down", "add", "erase", "pick", "move", "up"
    /// or "cancel".
    ///
    /// # Errors
    /// For a phase of another name.
    pub fn pointer(&self, phase: &str, samples: &[f32]) -> Result<Array, JsError> {
        let phase = Phase::from_name(phase).ok_or_else(|| missing(phase))?;
        let mut shared = self.shared.borrow_mut();
        shared.losses = 0;
        shared.session.pointer(phase, samples);
        Ok(shared.effects())
    }

    /// Does what a control asks for; see `boundary.rs` for names and arguments. "lost" says that the canvas has lost
    /// its context. "canvas" (`canvas`, `renderer`: the next ones; `painter`: that of the other build, where
    /// the renderer is not this one's) takes longer than the call where there is no painter.
    ///
    /// # Errors
    /// For a command that does not exist with these arguments.
    pub fn command(&self, name: &str, args: &JsValue) -> Result<Array, JsError> {
        match name {
            "canvas" => self.reopen(args)?,
            "lost" => self.shared.borrow_mut().lose(),
            _ => {
                let command = command_from_js(name, args).ok_or_else(|| missing(name))?;
                self.shared.borrow_mut().session.command(command);
            }
        }
        Ok(self.shared.borrow_mut().effects())
    }

    /// Begins to make work ready for the command "open", by its exact bytes.
    pub fn prepare(&self, work: &[u8]) {
        self.shared.borrow_mut().session.prepare(work);
    }

    /// Goes on with that by one slice, and tells whether there are more.
    #[wasm_bindgen(js_name = prepareOn)]
    pub fn prepare_on(&self) -> bool {
        self.shared.borrow_mut().session.prepare_on()
    }

    /// Goes on by one slice with another picture of the drawing, if one is wanted, and tells whether there are more.
    #[wasm_bindgen(js_name = makeOn)]
    pub fn make_on(&self) -> bool {
        self.shared.borrow_mut().session.make_on()
    }

    /// Paints, if anything has changed since the last frame.
    pub fn frame(&self) -> Array {
        let mut shared = self.shared.borrow_mut();
        shared.paint();
        shared.effects()
    }

    /// The way through the history of the drawing: `steps`, what gestures did, as keys of the page's messages; and `place`,
    /// how many of them are not taken back.
    pub fn history(&self) -> JsValue {
        js_from_history(self.shared.borrow().session.history())
    }

    /// The exact bytes of the work, with what the pen has done since it came down.
    pub fn work(&self) -> Vec<u8> {
        self.shared.borrow().session.work()
    }

    /// A small picture of the drawing as it is.
    pub fn thumbnail(&self) -> Export {
        Export(self.shared.borrow_mut().session.thumbnail())
    }

    /// The picture of the drawing as it is, with so many pixels on its longer side.
    pub fn export(&self, size_px: f64, lines: bool) -> Export {
        Export(self.shared.borrow_mut().session.export(size_px, lines))
    }

    /// Colours of numbers, three each, of a model, "oklch" or "hsv" (see [`ColorModel`]): 0xrrggbb, with 1 << 24 for those
    /// that are not in sRGB.
    ///
    /// # Errors
    /// For a model of another name.
    pub fn colors(&self, model: &str, numbers: &[f64]) -> Result<Vec<u32>, JsError> {
        let model = color_model_from_name(model).ok_or_else(|| missing(model))?;
        let (all, _) = numbers.as_chunks();
        Ok(all.iter().map(|numbers| packed(model.color(*numbers))).collect())
    }

    /// The numbers of a colour, 0xrrggbb, in a model.
    ///
    /// # Errors
    /// For a model of another name.
    #[wasm_bindgen(js_name = colorNumbers)]
    pub fn color_numbers(&self, model: &str, rgb: u32) -> Result<Vec<f64>, JsError> {
        let model = color_model_from_name(model).ok_or_else(|| missing(model))?;
        let [_, r, g, b] = rgb.to_be_bytes();
        Ok(model.numbers(Srgb8([r, g, b])).to_vec())
    }

    fn reopen(&self, args: &JsValue) -> Result<(), JsError> {
        let canvas = field(args, "canvas").dyn_into().map_err(|_| missing("canvas"))?;
        let renderer = field(args, "renderer").as_string().ok_or_else(|| missing("renderer"))?;
        let shared = Rc::clone(&self.shared);
        #[cfg(feature = "webgpu")]
        if field(args, "painter").is_object() {
            // Its class is another module's, by which it cannot be known here.
            let painter = BesideScreen::new(field(args, "painter").unchecked_into(), note_failure);
            shared.borrow_mut().reopened(Some(Screen::Beside(painter)), &renderer);
            return Ok(());
        }
        spawn_local(async move {
            let screen = Screen::open(canvas, &renderer, on_device_failure).await;
            shared.borrow_mut().reopened(screen.ok(), &renderer);
            wake();
        });
        Ok(())
    }
}

/// A picture for a file, which stays as it is while the drawing is worked on.
#[wasm_bindgen]
#[derive(Debug)]
pub struct Export(crate::painting::Export);

#[wasm_bindgen]
impl Export {
    /// Pixels of a row.
    #[wasm_bindgen(getter)]
    pub fn width(&self) -> u32 {
        self.0.view.width_px
    }

    /// Rows.
    #[wasm_bindgen(getter)]
    pub fn height(&self) -> u32 {
        self.0.view.height_px
    }

    /// The pixels of some rows: red, green, blue and straight alpha.
    pub fn rows(&self, first: u32, count: u32, transparent: bool) -> Vec<u8> {
        self.0.rows(first, count, (!transparent).then_some(PAPER)).rgba
    }

    /// The field, for the module that writes other files than pictures.
    pub fn field(&self) -> Vec<u8> {
        self.0.field.to_bytes()
    }
}

impl Shared {
    fn paint(&mut self) {
        if DEVICE_LOST.take() && !matches!(self.screen, Some(Screen::Cpu(_))) {
            self.lose();
        }
        if let Some(screen) = &mut self.screen
            && self.session.frame(screen)
        {
            wake();
        }
    }

    /// Everything that was on the device is dropped; the document has all that it takes to draw it again.
    fn lose(&mut self) {
        if let Some(screen) = self.screen.take() {
            self.ask_after(screen.renderer());
        }
    }

    /// Has the page ask for a renderer once more, or for what there is in its place.
    fn ask_after(&mut self, renderer: &'static str) {
        self.losses += 1;
        if self.losses < LOSSES_BORNE {
            self.session.tell(Effect::Lost(Some(renderer)));
        } else {
            self.give_up(renderer);
        }
    }

    fn give_up(&mut self, renderer: &str) {
        self.losses = 0;
        self.session.tell(Effect::Lost(screen::after(renderer)));
    }

    fn reopened(&mut self, screen: Option<Screen>, renderer: &str) {
        let Some(screen) = screen else {
            // What takes the place of another is not tried twice.
            return if renderer == GPU { self.ask_after(GPU) } else { self.give_up(renderer) };
        };
        self.session.set_grids(screen.grids());
        self.session.tell(Effect::Renderer(screen.renderer()));
        self.session.repaint();
        self.screen = Some(screen);
    }

    fn effects(&mut self) -> Array {
        js_from_effects(self.session.take_effects())
    }
}

impl std::fmt::Debug for Shared {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Shared").field("losses", &self.losses).finish_non_exhaustive()
    }
}

/// May be called in the middle of drawing, so it only leaves a mark and asks for a frame.
fn on_device_failure(error: GpuError) {
    console::warn_1(&error.to_string().into());
    note_failure();
}

fn note_failure() {
    DEVICE_LOST.set(true);
    wake();
}

fn wake() {
    WAKE.with_borrow(|wake| {
        if let Some(wake) = wake {
            // The page's function asks for an animation frame; that it throws would be its own fault to report.
            let _ = wake.call0(&JsValue::NULL);
        }
    });
}

fn packed((Srgb8([r, g, b]), is_srgb): (Srgb8, bool)) -> u32 {
    u32::from_be_bytes([(!is_srgb).into(), r, g, b])
}

fn missing(name: &str) -> JsError {
    JsError::new(&format!("“{name}” is missing, unknown, or has other arguments"))
}
