//! What the page can ask for.

use kurbo::{Point, Vec2};
use scumble_core::{Blend, EngineKind, Paint, Settings, Srgb8, Swatch};

use crate::brush::{Ink, ModeChange};
use crate::solver::Solver;
use crate::view::Viewport;

/// Where a gesture of the pen is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Phase {
    /// It begins, with the tool of the moment.
    Down,
    /// It begins, and adds to what is selected, where the tool does that.
    Add,
    /// It begins, with the eraser at the other end of the pen.
    Erase,
    /// It begins, with the tool that picks a colour.
    Pick,
    /// It goes on.
    Move,
    /// It ends, and is kept.
    Up,
    /// It is abandoned, and leaves nothing.
    Cancel,
}

impl Phase {
    /// The phase of a name that the page uses.
    pub fn from_name(name: &str) -> Option<Self> {
        match name {
            "down" => Some(Self::Down),
            "add" => Some(Self::Add),
            "erase" => Some(Self::Erase),
            "pick" => Some(Self::Pick),
            "move" => Some(Self::Move),
            "up" => Some(Self::Up),
            "cancel" => Some(Self::Cancel),
            _ => None,
        }
    }
}

/// What the pen does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Tool {
    /// It draws scribbles.
    #[default]
    Scribble,
    /// It takes scribbles away that it touches, or what it touches of them.
    Erase,
    /// It chooses scribbles and lines, and moves and resizes what it has chosen.
    Select,
    /// It takes the colour that it is lifted from for the next scribbles.
    Pick,
    /// It moves the view.
    Hand,
}

/// One of the settings of a drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Setting {
    /// The space in which colours are blended.
    Blend(Blend),
    /// What labels the sides.
    Engine(EngineKind),
    /// How readily gaps count as closed, in `0..=1`.
    GapClosing(f64),
    /// Whether colours go on into what nobody scribbled.
    Spread(bool),
}

impl Setting {
    /// Whether it has a slider: its changes are one gesture until [`Command::Settle`].
    pub(crate) fn is_slid(self) -> bool {
        matches!(self, Self::GapClosing(_))
    }

    pub(crate) fn put_into(self, settings: Settings) -> Settings {
        match self {
            Self::Blend(blend) => Settings { blend, ..settings },
            Self::Engine(engine) => Settings { engine, ..settings },
            Self::GapClosing(gap_closing) => Settings { gap_closing, ..settings },
            Self::Spread(spread) => Settings { spread, ..settings },
        }
    }
}

/// What is to be selected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Selecting {
    /// All scribbles.
    All,
    /// Nothing.
    None,
    /// What lies under what is selected, or the uppermost scribble.
    Next,
    /// What lies over it, or the undermost thing.
    Previous,
}

/// What is to be done with what is selected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arranging {
    /// Scribbles go past the next one in the order.
    Forward,
    /// They go past the one before.
    Backward,
    /// There are two of each scribble.
    Duplicate,
    /// Take it away.
    Delete,
    /// Show no lines, or show them again.
    Hide,
}

/// One wish of the page.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Work on another drawing.
    Open {
        /// Its exact bytes (see `scumble_core::exact`).
        work: Vec<u8>,
        /// What was left out of it, in words.
        notes: String,
    },
    /// Leave work that is made ready to be opened.
    StopPreparing,
    /// Takes back what asks for another picture of the drawing, which is on its way.
    StopMaking,
    /// What the pen does from here on.
    Tool(Tool),
    /// The colour of the next scribbles, or none, or a step from what they are drawn on.
    Color(Ink),
    /// The same while a colour is sought: its changes are one gesture until [`Command::Settle`].
    ColorSought(Ink),
    /// Another colour in the place of the one that was picked last, as on the way to one that is liked.
    TuneColor(Paint),
    /// The colour of the next scribbles alone, whatever is selected.
    BrushColor(Paint),
    /// Back to the colour before.
    SwapColors,
    /// How the next scribbles colour.
    Mode(ModeChange),
    /// The width of the next scribbles, or of those that are selected, in du. It has a slider, as [`Command::TracingOpacity`].
    BrushSize(f64),
    /// A step wider.
    BrushLarger,
    /// A step narrower.
    BrushSmaller,
    /// Select something.
    Select(Selecting),
    /// Do something with what is selected.
    Arrange(Arranging),
    /// An arrow key of a direction: move what is selected, or the view, and whether far.
    Arrow(Vec2, bool),
    /// Whether what presses is as broad as a finger.
    Finger(bool),
    /// Whether the eraser takes the parts of scribbles that it touches, not all of them.
    EraseParts(bool),
    /// The eraser, taking what it did not take.
    OtherErasing,
    /// Take the last gesture back.
    Undo,
    /// Do it again.
    Redo,
    /// Take back or do again, until so many gestures are not taken back.
    GoTo(usize),
    /// Another setting of the drawing.
    Set(Setting),
    /// Another palette for the drawing.
    Palette(Vec<Swatch>),
    /// A swatch's colour in the place of the one that it had: in the palette, and wherever the drawing is painted with it.
    /// It is picked as with a slider: the changes are one gesture until [`Command::Settle`].
    Repaint {
        /// The palette with the new colour.
        palette: Vec<Swatch>,
        /// The colour as the gesture began.
        from: Paint,
        /// The colour of the moment.
        to: Paint,
    },
    /// The picture of a number under the lines, or none.
    Trace(Option<u32>),
    /// Its opacity, in `0..=1`. It has a slider: its changes are one gesture until [`Command::Settle`].
    TracingOpacity(f64),
    /// A slider is let go.
    Settle,
    /// Which solver is to make the picture.
    Solver(Solver),
    /// Whether lines are shown.
    Lines(bool),
    /// Whether scribbles are shown.
    Scribbles(bool),
    /// Whether there is paper under the colours. Without it what lies under the canvas is seen.
    Paper(bool),
    /// Whether the colours are shown.
    Result(bool),
    /// Whether rooms and gaps are shown, in place of the colours.
    Regions(bool),
    /// Whether the drawing is shown as it was before it was coloured, to compare.
    Before(bool),
    /// The colour around the page.
    Desk(Srgb8),
    /// Another view.
    View(ViewChange),
}

/// One change of what the canvas shows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ViewChange {
    /// A step closer.
    ZoomIn,
    /// A step away.
    ZoomOut,
    /// One du is one CSS pixel.
    ZoomReset,
    /// All of the page.
    Fit,
    /// By a way in CSS pixels.
    Pan(Vec2),
    /// Closer by a factor, about a place in CSS pixels.
    ZoomAt(Point, f64),
    /// Rotated by an angle, clockwise in degrees, about a place in CSS pixels.
    RotateAt(Point, f64),
    /// A step clockwise, or the other way.
    RotateStep {
        /// Which.
        is_clockwise: bool,
    },
    /// Not rotated.
    RotateReset,
    /// Left where right was.
    Mirror,
    /// The canvas has a size and a place.
    Resize {
        /// Width and height in device pixels.
        size_px: [u32; 2],
        /// Device pixels of one CSS pixel.
        px_per_css: f64,
        /// Its top left corner in the window, in CSS pixels.
        corner_css: Point,
    },
}

impl ViewChange {
    /// Whether it is about the middle of the canvas, wherever the pen is.
    pub(crate) fn is_leap(self) -> bool {
        self.is_turn() || matches!(self, Self::ZoomIn | Self::ZoomOut | Self::ZoomReset | Self::Fit)
    }

    /// Whether it is a turn that a key asks for, of which people are told.
    pub(crate) fn is_turn(self) -> bool {
        matches!(self, Self::RotateStep { .. } | Self::RotateReset | Self::Mirror)
    }

    pub(crate) fn apply(self, viewport: &mut Viewport, is_pen_down: bool) {
        match self {
            Self::ZoomIn => viewport.zoom_in(),
            Self::ZoomOut => viewport.zoom_out(),
            Self::ZoomReset => viewport.zoom_to(1.0),
            Self::Fit => viewport.fit(),
            Self::Pan(way_css) => viewport.pan(way_css),
            Self::ZoomAt(at_css, factor) => viewport.zoom_at(at_css, factor),
            Self::RotateAt(at_css, degrees) => viewport.rotate_at(at_css, degrees),
            Self::RotateStep { is_clockwise } => viewport.rotate_step(is_clockwise),
            Self::RotateReset => viewport.rotate_reset(),
            Self::Mirror => viewport.mirror(),
            Self::Resize { size_px, px_per_css, corner_css } => {
                viewport.resize(size_px, px_per_css, corner_css, is_pen_down);
            }
        }
    }
}
