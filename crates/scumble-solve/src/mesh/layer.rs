//! The layer that strokes lay over a region: its finer elements, and what it has at their unknowns.
//!
//! Each stroke covers for itself. Where several do, their colours and what is under them are mixed by `α / (1 − α)` of each, and
//! one: a single stroke covers by its `α`, and the order of several makes no difference.

use std::mem;

use scumble_core::pace::{self, Pace};
use scumble_core::{BlendColor, SoftSource};

use super::SolveError;
use super::cells::Cells;
use super::refine::{Finer, Refined, Shape};
use super::stroke::{Seen, Stroke};
use super::substitution::TileColumn;

/// A layer over a region.
#[derive(Debug)]
pub(super) struct Layer {
    /// The region, fine enough for the sources that were there before: most often all but the one in hand.
    base: Finer,
    region: Refined,
    strokes: Vec<Stroke>,
    /// By the unknown of the region.
    covers: Vec<Cover>,
    is_solved: bool,
}

/// What a layer has at a place.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Cover {
    /// Blend-space colours times opacity, and opacity, each by how much its stroke counts.
    color: BlendColor,
    /// How much the strokes count, where what is under them counts one.
    weight: f64,
}

/// A stroke counts at most so much: then it leaves nothing that could be seen.
const MOST_WEIGHT: f64 = 1e6;

impl Layer {
    /// That of sources over a region of some cells; of a layer before it, it takes what is still the same.
    pub(super) async fn new(coarse: &Cells, sources: &[SoftSource], before: Option<Self>) -> Self {
        let (base, mut known) = before.map_or((None, Vec::new()), |layer| (Some(layer.base), layer.strokes));
        let (stay, come): (Vec<_>, Vec<_>) =
            sources.iter().partition(|source| known.iter().any(|stroke| stroke.is_alike(source)));
        let base = base.filter(|base| base.is_for_some_of(&stay));
        let mut base = base.unwrap_or_else(|| Finer::new(coarse));
        base.add(coarse, &stay).await;
        let mut whole = base.clone();
        whole.add(coarse, &come).await;
        let region = whole.refined();
        // What comes all at once, as when a drawing is opened, stays.
        let base = if stay.is_empty() { whole } else { base };
        let mut seen = Seen::new(region.dof_count);
        let mut strokes = Vec::with_capacity(sources.len());
        for source in sources {
            strokes.push(Stroke::new(source, &region, &mut known, &mut seen).await);
            pace::pause().await;
        }
        Self { base, region, strokes, covers: Vec::new(), is_solved: false }
    }

    /// All elements of the region.
    pub(super) fn shapes(&self) -> &[Shape] {
        &self.region.shapes
    }

    /// Number of unknowns of all strokes.
    pub(super) fn unknown_count(&self) -> usize {
        self.strokes.iter().map(Stroke::unknown_count).sum()
    }

    /// Whether it is that of some sources.
    pub(super) fn is_of(&self, sources: &[SoftSource]) -> bool {
        self.strokes.iter().map(Stroke::source).eq(sources)
    }

    /// Takes other colours, if nothing but these is another; `false` where more is.
    pub(super) fn recolor(&mut self, sources: &[SoftSource]) -> bool {
        let are_alike = self.strokes.len() == sources.len()
            && self.strokes.iter().zip(sources).all(|(stroke, source)| stroke.is_alike(source));
        if are_alike {
            self.strokes.iter_mut().zip(sources).for_each(|(stroke, source)| stroke.recolor(source));
            self.is_solved = false;
        }
        are_alike
    }

    /// The colours of its sources.
    pub(super) fn colors(&self) -> impl Iterator<Item = BlendColor> {
        self.strokes.iter().map(|stroke| stroke.source().color)
    }

    /// Finds how much the strokes cover that are new, in some memory for a factor.
    pub(super) async fn factor(&mut self, memory: &mut Vec<TileColumn>) -> Result<(), SolveError> {
        for stroke in &mut self.strokes {
            stroke.solve(memory).await?;
        }
        Ok(())
    }

    /// Adds up what the strokes do if that is not known, and says whether it was not.
    pub(super) async fn solve(&mut self) -> bool {
        let is_new = !mem::replace(&mut self.is_solved, true);
        if is_new {
            self.covers = vec![Cover::default(); self.region.dof_count];
            let mut pace = Pace::default();
            for stroke in &self.strokes {
                let color = stroke.source().color;
                stroke.covers().for_each(|(dof, part)| self.covers[dof as usize].add(color, part));
                pace.work(stroke.unknown_count()).await;
            }
        }
        is_new
    }

    /// What it has at the six places of an element of the region.
    pub(super) fn covers(&self, element: usize) -> [Cover; 6] {
        self.region.dofs[element].map(|dof| self.covers[dof as usize])
    }
}

impl Cover {
    fn add(&mut self, color: BlendColor, part: f64) {
        let weight = (part / (1.0 - part)).min(MOST_WEIGHT);
        self.weight += weight;
        self.color.iter_mut().zip(color).for_each(|(sum, c)| *sum += weight * c);
    }

    /// Whether it covers anything.
    pub(super) fn is_any(&self) -> bool {
        self.weight > 0.0
    }

    /// What is seen where it lies over something.
    pub(super) fn over(&self, under: BlendColor) -> BlendColor {
        [0, 1, 2, 3].map(|i| (under[i] + self.color[i]) / (1.0 + self.weight))
    }
}
