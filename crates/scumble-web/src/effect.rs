//! What the page must know, as a short list after each call: what of its state has changed, and what happened.

use kurbo::{Affine, Rect, Size};
use scumble_core::{Paint, Settings, Swatch, Tracing};

use crate::brush::{Ink, Mode};
use crate::command::Tool;
use crate::solver::SolverState;
use crate::view::Turn;

/// One thing that the page must know.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect {
    /// Which drawing is shown, and as which revision of it.
    Sheet(SheetState),
    /// Neither undo nor redo comes back to the drawing of this number any more.
    Closed(u32),
    /// Whether there is something to undo.
    Undo(bool),
    /// Whether there is something to redo.
    Redo(bool),
    /// CSS pixels of one du.
    Zoom(f64),
    /// Takes du to CSS pixels of the canvas.
    View(Affine),
    /// How the page lies on the canvas.
    Turn(Turn),
    /// What the pen does.
    Tool(Tool),
    /// How the next scribble colours, or those do that are selected.
    Mode(Mode),
    /// The colour of the next scribble, or none, or a step from what it is drawn on.
    Color(Ink),
    /// The width of the next scribble, in du.
    BrushSize(f64),
    /// What is selected.
    Selection(SelectionState),
    /// Whether the eraser takes parts of scribbles.
    EraseParts(bool),
    /// Whether lines are shown.
    Lines(bool),
    /// Whether scribbles are shown.
    Scribbles(bool),
    /// Whether the colours are shown.
    Result(bool),
    /// Whether rooms and gaps are shown.
    Regions(bool),
    /// How the drawing is coloured.
    Settings(Settings),
    /// The picture under the lines. Told before the sheet whose it is.
    Tracing(TracingState),
    /// What of its picture is on its way, in steps. Told before the sheet whose it is.
    Making(Wanted),
    /// Which solver makes the picture.
    Solver(SolverState),
    /// A drawing was opened.
    Opened {
        /// What was left out of it, in words.
        notes: String,
    },
    /// The palette of the drawing that is shown; empty for the page's own.
    Palette(Vec<Swatch>),
    /// A scribble was kept.
    ScribbleAdded {
        /// How many there are with it.
        count: usize,
        /// Whether it fills; else it shades.
        is_fill: bool,
    },
    /// Scribbles were taken away.
    ScribblesErased {
        /// How many; 0 where the eraser came to none.
        erased: usize,
        /// How many are left.
        count: usize,
    },
    /// The eraser is to take something else.
    EraserTurned {
        /// Whether that is parts of scribbles.
        parts: bool,
    },
    /// The eraser took parts of scribbles.
    ScribblesRubbed {
        /// How many scribbles there are then.
        count: usize,
    },
    /// Something was selected, or nothing.
    Selected {
        /// How many scribbles.
        scribbles: usize,
        /// How many lines.
        lines: usize,
        /// The place of the first scribble in the order, counted from 1; 0 where there is none.
        place: usize,
        /// How many scribbles there are in all.
        total: usize,
    },
    /// Something was done with what was selected.
    Edited {
        /// What.
        edit: Edit,
        /// To how many scribbles.
        scribbles: usize,
        /// To how many lines.
        lines: usize,
    },
    /// A colour was taken from the picture.
    Picked(Paint),
    /// A scribble was abandoned.
    ScribbleDropped,
    /// The page lies otherwise on the canvas.
    Turned(Turn),
    /// What asked for the picture that was on its way was taken back.
    MakingStopped,
    /// A gesture was taken back.
    Undone,
    /// A gesture was done again.
    Redone,
    /// Something could not be done: a sentence for people.
    Failed(String),
    /// The drawing of this number, which was shown, has no picture: a sentence that says why. It is closed.
    Unopened(u32, String),
    /// The canvas is served by the renderer of this name.
    Renderer(&'static str),
    /// The canvas is served no more. On a new one, the renderer of this name is to be asked for; `None` where all
    /// have failed.
    Lost(Option<&'static str>),
}

/// A drawing among those that were opened, and its state.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SheetState {
    /// Which one: a number of its own.
    pub sheet: u32,
    /// See [`scumble_core::Editor::revision`].
    pub revision: u32,
}

/// What is selected, and how that is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SelectionState {
    /// How many scribbles.
    pub scribbles: usize,
    /// How many lines.
    pub lines: usize,
    /// Whether all these lines are hidden.
    pub are_hidden: bool,
    /// The frame around it, in CSS pixels of the canvas.
    pub frame_css: Option<Rect>,
    /// How many handles that has: at no, at all 4 corners, or at its 4 sides, too.
    pub handles: usize,
    /// The rectangle in which things are being selected, likewise.
    pub marquee_css: Option<Rect>,
}

/// What can be done with what is selected, or come of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Edit {
    /// It is elsewhere.
    Moved,
    /// It is larger or smaller.
    Resized,
    /// It is drawn wider or narrower.
    Widened,
    /// It shades otherwise.
    Reshaded,
    /// It has another colour.
    Recolored,
    /// There is more of it.
    Duplicated,
    /// It lies one further up.
    Forward,
    /// It lies one further down.
    Backward,
    /// Nothing lies over it.
    Foremost,
    /// Nothing lies under it.
    Hindmost,
    /// It is no more.
    Deleted,
    /// It is not drawn.
    Hidden,
    /// It is drawn again.
    Shown,
}

/// What is on its way beside what is shown.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Wanted {
    /// Nothing: what is shown is the picture of the drawing.
    #[default]
    Nothing,
    /// Another picture.
    Picture,
    /// The mesh of a picture on pixels.
    Mesh,
}

/// The picture under the lines of the drawing that is shown, and the page into which it is fitted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TracingState {
    /// Which picture, if there is one.
    pub tracing: Option<Tracing>,
    /// The size of the page in du; its corner is at the origin.
    pub page: Size,
}

/// All that the page shows of the state. `None` is what it has never been told.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct State {
    pub(crate) sheet: Option<SheetState>,
    pub(crate) undo: Option<bool>,
    pub(crate) redo: Option<bool>,
    pub(crate) zoom: Option<f64>,
    pub(crate) view: Option<Affine>,
    pub(crate) turn: Option<Turn>,
    pub(crate) tool: Option<Tool>,
    pub(crate) mode: Option<Mode>,
    pub(crate) color: Option<Ink>,
    pub(crate) brush_du: Option<f64>,
    pub(crate) selection: Option<SelectionState>,
    pub(crate) erase_parts: Option<bool>,
    pub(crate) lines: Option<bool>,
    pub(crate) scribbles: Option<bool>,
    pub(crate) result: Option<bool>,
    pub(crate) regions: Option<bool>,
    pub(crate) settings: Option<Settings>,
    pub(crate) tracing: Option<TracingState>,
    pub(crate) palette: Option<Vec<Swatch>>,
    pub(crate) making: Option<Wanted>,
    pub(crate) solver: Option<SolverState>,
}

impl State {
    /// What is not as it was.
    pub(crate) fn news_since(&self, known: &Self) -> Vec<Effect> {
        let each = [
            news(self.tracing, known.tracing, Effect::Tracing),
            news(self.making, known.making, Effect::Making),
            news(self.sheet, known.sheet, Effect::Sheet),
            news(self.undo, known.undo, Effect::Undo),
            news(self.redo, known.redo, Effect::Redo),
            news(self.zoom, known.zoom, Effect::Zoom),
            news(self.view, known.view, Effect::View),
            news(self.turn, known.turn, Effect::Turn),
            news(self.tool, known.tool, Effect::Tool),
            news(self.mode, known.mode, Effect::Mode),
            news(self.color, known.color, Effect::Color),
            news(self.brush_du, known.brush_du, Effect::BrushSize),
            news(self.selection, known.selection, Effect::Selection),
            news(self.erase_parts, known.erase_parts, Effect::EraseParts),
            news(self.lines, known.lines, Effect::Lines),
            news(self.scribbles, known.scribbles, Effect::Scribbles),
            news(self.result, known.result, Effect::Result),
            news(self.regions, known.regions, Effect::Regions),
            news(self.settings, known.settings, Effect::Settings),
            news(self.solver, known.solver, Effect::Solver),
        ];
        let palette = self.palette.as_ref().filter(|_| self.palette != known.palette);
        each.into_iter().flatten().chain(palette.cloned().map(Effect::Palette)).collect()
    }
}

fn news<T: PartialEq>(now: Option<T>, known: Option<T>, effect: fn(T) -> Effect) -> Option<Effect> {
    if now == known { None } else { now.map(effect) }
}
