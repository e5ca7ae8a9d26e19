//! The ways to colour that are compared: engines by name, each as it serves one drawing.

use anyhow::bail;
use scumble_core::{Blend, Engine, PlanarMap, Scribble, Sight, color_spans, side_colors};
use scumble_solve::{MeshSolver, Pixmap};

use crate::clock::{Times, timed};
use crate::stages::{self, Opened};

/// A way to colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Method {
    /// All scribbles at once.
    Global,
    /// One scribble after the other.
    Progressive,
    /// What a scribble sees is its own.
    Sight,
}

/// All methods, by the names that the user writes.
const METHODS: [(&str, Method); 3] =
    [("global", Method::Global), ("progressive", Method::Progressive), ("sight", Method::Sight)];

impl Method {
    /// Reads a name.
    ///
    /// # Errors
    /// When there is no such method; the message names all.
    pub(crate) fn parse(name: &str) -> Result<Self, String> {
        let found = METHODS.iter().find(|(known, _)| *known == name);
        let names = || METHODS.map(|(name, _)| name).join(", ");
        found.map(|(_, method)| *method).ok_or_else(|| format!("give one of {}", names()))
    }

    /// As the user writes it.
    pub(crate) fn name(self) -> &'static str {
        METHODS.iter().find(|(_, method)| *method == self).map_or("", |(name, _)| name)
    }

    /// A new engine.
    fn engine(self, _manner: Manner) -> Box<dyn Engine> {
        match self {
            Self::Global | Self::Progressive | Self::Sight => Box::new(Sight::default()),
        }
    }
}

/// How far colours go.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Manner {
    /// How eagerly gaps between lines are closed, from 0 to 1.
    pub(crate) gap_closing: f64,
    /// Whether colours go on into areas without scribbles.
    pub(crate) spread: bool,
}

/// How long labelling took.
#[derive(Debug, Default)]
pub(crate) struct Latency {
    /// All scribbles of a drawing at once, by an engine that knows nothing of the drawing yet.
    pub(crate) at_once: Times,
    /// One more scribble, from the second on.
    pub(crate) one_more: Times,
    /// The last scribble of a drawing, all others being there.
    pub(crate) last: Times,
}

impl Latency {
    /// Times the labelling of one drawing.
    pub(crate) fn take(&mut self, method: Method, manner: Manner, map: &PlanarMap, scribbles: &[Scribble]) {
        let mut engine = method.engine(manner);
        self.at_once.push(timed(|| engine.label(map, scribbles)).1);
        let mut engine = method.engine(manner);
        for count in 1..=scribbles.len() {
            let (_, ms) = timed(|| engine.label(map, &scribbles[..count]));
            if count > 1 {
                self.one_more.push(ms);
            }
            if count == scribbles.len() {
                self.last.push(ms);
            }
        }
    }
}

/// The picture of some scribbles, transparent where nothing is coloured.
///
/// # Errors
/// When the solver fails.
pub(crate) fn paint(
    method: Method,
    manner: Manner,
    opened: &mut Opened,
    scribbles: &[Scribble],
    size_px: u32,
) -> anyhow::Result<Pixmap> {
    let view = stages::page_view(&opened.import.drawing, size_px);
    let map = opened.picture.map();
    let labels = method.engine(manner).label(map, scribbles);
    if labels.sides.len() != map.side_count() {
        bail!("the engine {} labels {} of {} sides", method.name(), labels.sides.len(), map.side_count());
    }
    let color_of = |side: scumble_core::SideId| {
        let label = labels.sides[side.index()]?;
        scribbles.get(label as usize).map(|scribble| scribble.color)
    };
    let colors = side_colors(map, &color_spans(map, color_of), Blend::Oklab);
    let mut solver = MeshSolver::new(map.refined());
    Ok(stages::paint_page(solver.solve(&colors, Blend::Oklab)?, &[], &view, None))
}
