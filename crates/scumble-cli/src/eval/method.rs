//! The ways to colour that are compared: engines and, on pixels, other people's methods; each by its name.

use scumble_core::{Engine, Progressive, Sight};

use crate::rivals::{self, Sketch, SketchPixel};

/// How far colours go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Manner {
    /// How eagerly gaps between lines are closed, from 0 to 1.
    pub(crate) gap_closing: f64,
    /// Whether colours go on into areas without scribbles.
    pub(crate) spread: bool,
}

/// A way to colour.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Method {
    /// As the user writes it.
    pub(crate) name: &'static str,
    pub(crate) way: Way,
}

/// What a method works on.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Way {
    /// The planar map: makes an engine that knows nothing of any drawing yet.
    Engine(fn(Manner) -> Box<dyn Engine>),
    /// Pixels: labels all pixels of a sketch.
    Pixels(fn(&Sketch, Manner) -> Vec<SketchPixel>),
}

/// All scribbles at once.
const GLOBAL: Method = Method { name: "global", way: Way::Engine(|_| Box::new(Sight::default())) };

/// What a scribble sees is its own.
pub(crate) const SIGHT: Method = Method { name: "sight", way: Way::Engine(|_| Box::new(Sight::default())) };

/// Flood fill without gap closing.
pub(crate) const FLOOD: Method =
    Method { name: "flood", way: Way::Pixels(|sketch, manner| rivals::flood(sketch, manner.spread)) };

/// All methods. The last two spread colours in either manner: they leave no pixel out.
const METHODS: [Method; 6] = [
    GLOBAL,
    Method { name: "progressive", way: Way::Engine(|_| Box::new(Progressive::default())) },
    SIGHT,
    FLOOD,
    Method { name: "lazybrush", way: Way::Pixels(|sketch, _| rivals::lazybrush(sketch)) },
    Method { name: "nearest", way: Way::Pixels(|sketch, _| rivals::nearest(sketch)) },
];

impl Default for Method {
    fn default() -> Self {
        GLOBAL
    }
}

impl Method {
    /// Reads a name.
    ///
    /// # Errors
    /// When there is no such method; the message names all.
    pub(crate) fn parse(name: &str) -> Result<Self, String> {
        let names = || METHODS.map(|method| method.name).join(", ");
        let found = METHODS.into_iter().find(|method| method.name == name);
        found.ok_or_else(|| format!("give one of {}", names()))
    }
}
