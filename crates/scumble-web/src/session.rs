//! What the page does, without a browser: a document under gestures and commands, the view of it, and what there is
//! to paint.
//!
//! Calls only note what has become stale; the work is done once a frame, however many pointer events came between.

use std::mem::take;
use std::sync::Arc;

use kurbo::{Affine, Rect};
use scumble_core::drawing::LONGER_SIDE_DU;
use scumble_core::{Deed, Document, Drawing, Entry, MapError, Paint, Srgb8, Swatch, Tracing, Work, exact};
use scumble_solve::grid::GridProblem;
use scumble_solve::{Field, Picture, View};

use crate::brush::{Brush, Ink};
use crate::command::{Command, Setting, Tool, ViewChange};
use crate::effect::{Effect, State, TracingState, Wanted};
use crate::layers::{KnownInk, Layers};
use crate::painting::{Changed, Export, PAPER, Painter, Painting};
use crate::regions::Regions;
use crate::selection::Selection;
use crate::solver::{Grids, Solver, SolverState, Source};
use crate::view::Viewport;

mod arranging;
mod close;
mod coloring;
mod gestures;
mod ink;
mod making;
mod opening;
mod picker;
mod pointing;
mod preview;
mod selecting;
mod sharp;
mod sheet;
mod tools;

use close::CloseUp;
use gestures::{Held, Stroke};
use making::Making;
use opening::Coming;
use preview::Preview;
use sharp::Sharp;
use sheet::{Sheet, Shelf};

/// The page that is there before a drawing is opened, in du.
const BLANK: Rect = Rect::new(0.0, 0.0, 1024.0, 768.0);

/// The longer side of a drawing's picture in a list.
const THUMBNAIL_PX: f64 = 240.0;

/// A document in work.
#[derive(Debug)]
pub struct Session {
    sheet: Sheet,
    shelf: Shelf,
    /// The drawing on its way.
    coming: Option<Coming>,
    /// Another picture of the drawing in work, on its way.
    making: Option<Making>,
    /// How many drawings have been opened.
    opened: u32,
    /// What is shown until the picture has been made: of several the last one that serves.
    previews: Vec<Preview>,
    /// Which of them was shown in the last frame.
    preview: Option<usize>,
    /// How often what colours the picture has changed.
    colorings: u32,
    /// The picture from close by, as far as it is seen.
    close_up: Option<CloseUp>,
    /// What the grid solver is given, once it is to make the picture.
    problem: Option<GridProblem>,
    /// And for what is in view, where the pixels of that would be seen.
    sharp: Option<Sharp>,
    layers: Layers,
    ink: KnownInk,
    /// The revision of the lines that these show.
    inked: u32,
    viewport: Viewport,
    tool: Tool,
    /// What the pen is down as, where it draws no scribble.
    held: Option<Held>,
    /// Whether it is as broad as a finger.
    is_finger: bool,
    selection: Selection,
    /// Whether the eraser takes parts of scribbles.
    erases_parts: bool,
    brush: Brush,
    stroke: Stroke,
    lines_shown: bool,
    scribbles_shown: bool,
    paper: Option<Srgb8>,
    result_shown: bool,
    /// What is shown in place of the result.
    regions: Option<Regions>,
    /// Whether nothing is shown but the lines.
    is_before: bool,
    desk: Srgb8,
    solver: Solver,
    grids: Grids,
    source: Source,
    stale: Stale,
    changed: Changed,
    known: State,
    effects: Vec<Effect>,
}

/// What must be derived anew before the next frame is painted.
#[derive(Clone, Copy, Debug)]
struct Stale {
    boundary: bool,
    field: bool,
    problem: bool,
    scribbles: bool,
    lines: bool,
    view: bool,
}

impl Stale {
    const ALL: Self =
        Self { boundary: true, field: true, problem: true, scribbles: true, lines: true, view: true };

    /// The colours are to be found anew.
    fn colors(&mut self) {
        (self.boundary, self.field, self.problem) = (true, true, true);
    }
}

impl Session {
    /// A blank page on a desk of a colour.
    ///
    /// # Errors
    /// Where even a blank page has no map.
    pub fn new(desk: Srgb8) -> Result<Self, MapError> {
        let drawing = Drawing::new(BLANK);
        let picture = Picture::new(&drawing)?;
        Ok(Self {
            viewport: Viewport::new(drawing.frame()),
            sheet: Sheet::new(0, Work::new(Document::new(drawing)), picture),
            shelf: Shelf::default(),
            coming: None,
            making: None,
            opened: 0,
            previews: Vec::new(),
            preview: None,
            colorings: 0,
            close_up: None,
            problem: None,
            sharp: None,
            layers: Layers::default(),
            ink: KnownInk::default(),
            inked: 0,
            tool: Tool::default(),
            held: None,
            is_finger: false,
            selection: Selection::default(),
            erases_parts: false,
            brush: Brush::default(),
            stroke: Stroke::default(),
            lines_shown: true,
            scribbles_shown: true,
            paper: Some(PAPER),
            result_shown: true,
            regions: None,
            is_before: false,
            desk,
            solver: Solver::default(),
            grids: Grids::default(),
            source: Source::default(),
            stale: Stale::ALL,
            changed: Changed::ALL,
            known: State::default(),
            effects: Vec::new(),
        })
    }

    /// The document, with the scribble in hand.
    pub fn document(&self) -> &Document {
        self.sheet.editor.document()
    }

    /// The gestures that can be undone or done again in this drawing, and how many of them are not taken back.
    pub fn history(&self) -> (Vec<Entry>, usize) {
        (self.sheet.editor.history().collect(), self.sheet.editor.place())
    }

    /// The exact bytes of the work: the document, and what was opened with it.
    pub fn work(&self) -> Vec<u8> {
        exact::write(&self.sheet.work())
    }

    /// Takes du to CSS pixels of the canvas.
    pub fn css_from_du(&self) -> Affine {
        self.viewport.css_from_du()
    }

    /// What the page has not been told yet.
    pub fn take_effects(&mut self) -> Vec<Effect> {
        self.settle_shelf();
        let state = self.state();
        let mut effects = state.news_since(&self.known);
        effects.append(&mut self.effects);
        self.known = state;
        effects
    }

    /// Does what a control of the page asks for.
    pub fn command(&mut self, command: Command) {
        match command {
            Command::Open { work, notes } => self.open(&work, notes),
            Command::StopPreparing => self.stop_preparing(),
            Command::StopMaking => self.stop_making(),
            Command::Tool(tool) => self.set_tool(tool),
            Command::Color(ink) => self.take_ink(ink, false),
            Command::ColorSought(ink) => self.take_ink(ink, true),
            Command::TuneColor(color) => self.tune_color(color),
            Command::BrushColor(color) => self.brush.set_ink(Ink::Paint(color)),
            Command::SwapColors => self.take_ink(Ink::Paint(self.brush.color_before()), false),
            Command::Mode(change) => self.change_mode(change),
            Command::BrushSize(size_du) => self.set_size(true, |_| size_du),
            Command::BrushLarger => self.set_size(false, Brush::wider),
            Command::BrushSmaller => self.set_size(false, Brush::narrower),
            Command::Select(selecting) => self.choose(selecting),
            Command::Arrange(arranging) => self.arrange(arranging),
            Command::Arrow(direction, is_far) => self.arrow(direction, is_far),
            Command::Finger(is_finger) => self.is_finger = is_finger,
            Command::EraseParts(parts) => self.erases_parts = parts,
            Command::OtherErasing => self.turn_eraser(),
            Command::Undo => self.undo(),
            Command::Redo => self.redo(),
            Command::GoTo(place) => self.go_to(place),
            Command::Set(setting) => self.set(setting),
            Command::Palette(palette) => self.set_palette(palette),
            Command::Repaint { palette, from, to } => self.repaint_swatch(palette, from, to),
            Command::Trace(image) => self.trace(image),
            Command::TracingOpacity(opacity) => self.fade_tracing(opacity),
            Command::Settle => self.settle(),
            Command::Solver(solver) => self.solver = solver,
            Command::Lines(shown) => self.show_lines(shown),
            Command::Scribbles(shown) => self.show_scribbles(shown),
            Command::Paper(shown) => {
                self.paper = shown.then_some(PAPER);
                self.stale.view = true;
            }
            Command::Result(shown) => self.show_result(shown),
            Command::Regions(shown) => self.show_regions(shown),
            Command::Before(shown) => self.show_before(shown),
            Command::Desk(desk) => self.set_desk(desk),
            Command::View(change) => self.change_view(change),
        }
    }

    fn change_view(&mut self, change: ViewChange) {
        // The drawing does not leap away from under a pen that is down: what it does would go on elsewhere.
        let is_pen_down = self.is_pen_down();
        if is_pen_down && change.is_leap() {
            return;
        }
        change.apply(&mut self.viewport, is_pen_down);
        self.stale.view = true;
        if change.is_turn() {
            self.tell(Effect::Turned(self.viewport.turn()));
        }
    }

    /// Derives what is stale and shows it; does nothing where nothing has changed. Tells whether there is more to show.
    pub fn frame(&mut self, painter: &mut dyn Painter) -> bool {
        self.refresh_colors();
        self.refresh_close_up();
        self.refresh_previews();
        self.refresh_regions();
        self.refresh_ink();
        if take(&mut self.stale.view) {
            let (blank, changed) = (Field::default(), take(&mut self.changed));
            let regions = self.regions_shown().map(Regions::field);
            let is_result = self.result_shown && regions.is_none() && !self.is_before;
            let problem = self.problem.as_ref().filter(|_| self.source == Source::Grid && is_result);
            let painting = Painting {
                field: if is_result { self.field_shown() } else { regions }.unwrap_or(&blank),
                problem,
                part: problem.and(self.sharp.as_ref()).map(|sharp| &sharp.problem),
                layers: &self.layers,
                view: self.viewport.view(),
                paper: self.paper,
            };
            let is_all = painter.paint(&painting, changed);
            self.stale.view = !is_all || self.choice() != self.source;
        }
        self.stale.view || self.wanted() != Wanted::Nothing
    }

    /// Everything is to be painted anew, by a painter that has nothing yet.
    pub fn repaint(&mut self) {
        self.changed = Changed::ALL;
        self.stale.view = true;
    }

    /// What the painter to come can do with grids.
    pub fn set_grids(&mut self, grids: Grids) {
        self.grids = grids;
    }

    /// The picture for a list of drawings: as in a file, but small, and with lines if they are shown.
    pub fn thumbnail(&mut self) -> Export {
        self.export(THUMBNAIL_PX, self.lines_shown)
    }

    /// The picture for a file: the whole page without scribbles, with so many pixels on its longer side.
    pub fn export(&mut self, size_px: f64, lines: bool) -> Export {
        self.finish_making();
        self.refresh_field();
        let drawing = &self.sheet.editor.document().drawing;
        let px_per_du = size_px / LONGER_SIDE_DU;
        let mut layers = Layers::at_scale(px_per_du);
        if lines {
            layers.add_lines(drawing, self.sheet.ink_map());
        }
        let close_up = self.sheet.picture.close_up(drawing, drawing.frame(), px_per_du);
        let field =
            close_up.map(Arc::new).or_else(|| self.sheet.picture.field().cloned()).unwrap_or_default();
        Export { layers, field, view: self.page(px_per_du) }
    }

    /// The whole page.
    fn page(&self, px_per_du: f64) -> View {
        let size_px = self.sheet.editor.document().drawing.size_du() * px_per_du;
        View {
            px_from_du: Affine::scale(px_per_du),
            width_px: size_px.width.round().max(1.0) as u32,
            height_px: size_px.height.round().max(1.0) as u32,
        }
    }

    /// Tells the page something with the next effects.
    pub fn tell(&mut self, effect: Effect) {
        self.effects.push(effect);
    }

    fn set(&mut self, setting: Setting) {
        if setting.is_slid() {
            self.slide(Deed::GapClosing);
        } else {
            self.commit();
        }
        let editor = &mut self.sheet.editor;
        let before = editor.document().settings;
        editor.set_settings(setting.put_into(before));
        if editor.document().settings != before {
            self.colors_changed();
        }
    }

    fn set_palette(&mut self, palette: Vec<Swatch>) {
        self.commit();
        self.sheet.editor.set_palette(palette);
    }

    /// Each colour on the way takes the place of the first one, not of the one before: what it passes by stays.
    fn repaint_swatch(&mut self, palette: Vec<Swatch>, from: Paint, to: Paint) {
        if self.held.is_some() {
            return;
        }
        self.slide(Deed::Repainted);
        let editor = &mut self.sheet.editor;
        editor.restart();
        editor.set_palette(palette);
        editor.repaint(from, to);
        self.scribbles_changed();
    }

    /// Lays a picture under the lines, as faded as the one before it, or takes it away.
    fn trace(&mut self, image: Option<u32>) {
        self.commit();
        let editor = &mut self.sheet.editor;
        let before = editor.document().tracing;
        editor.set_tracing(image.map(|image| Tracing { image, ..before.unwrap_or(Tracing::faded(image)) }));
    }

    fn fade_tracing(&mut self, opacity: f64) {
        self.slide(Deed::Faded);
        let editor = &mut self.sheet.editor;
        editor.set_tracing(editor.document().tracing.map(|tracing| Tracing { opacity, ..tracing }));
    }

    /// A slider is dragged, which is one gesture.
    fn slide(&mut self, deed: Deed) {
        if self.sheet.editor.deed_in_hand() != Some(deed) {
            self.commit();
            self.sheet.editor.begin(deed);
        }
    }

    /// Ends the drag of a slider, not what the pen does meanwhile.
    fn settle(&mut self) {
        if !self.is_pen_down() {
            self.sheet.editor.commit();
        }
    }

    fn is_pen_down(&self) -> bool {
        self.held.is_some() || self.sheet.editor.is_scribbling()
    }

    fn scribbles_changed(&mut self) {
        self.colors_changed();
        self.stale.scribbles = true;
    }

    fn colors_changed(&mut self) {
        self.colorings += 1;
        self.stale.colors();
    }

    fn px_per_du(&self) -> f64 {
        self.viewport.px_per_du()
    }

    fn state(&self) -> State {
        State {
            sheet: Some(self.sheet.state()),
            undo: Some(self.can_undo()),
            redo: Some(self.can_redo()),
            zoom: Some(self.viewport.zoom()),
            view: Some(self.viewport.css_from_du()),
            turn: Some(self.viewport.turn()),
            tool: Some(self.tool),
            mode: Some(self.mode_shown()),
            color: Some(self.ink_shown()),
            brush_du: Some(self.size_shown_du()),
            selection: Some(self.selection_state()),
            erase_parts: Some(self.erases_parts),
            lines: Some(self.lines_shown),
            scribbles: Some(self.scribbles_shown),
            result: Some(self.result_shown),
            regions: Some(self.regions.is_some()),
            settings: Some(self.document().settings),
            tracing: Some(TracingState {
                tracing: self.document().tracing,
                page: self.document().drawing.size_du(),
            }),
            palette: Some(self.document().palette.clone()),
            making: Some(self.wanted()),
            solver: Some(SolverState { asked: self.solver, source: self.source }),
        }
    }
}
