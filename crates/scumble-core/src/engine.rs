//! Engines: what turns scribbles into a label for each side of each piece of curve.

use std::fmt;

use crate::pace::{Slices, now};
use crate::planar_map::PlanarMap;
use crate::scribble::Scribble;

/// What an engine makes of scribbles.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Labels {
    /// For each side (indexed by [`crate::SideId`]) the scribble that gives it its colour, if any.
    pub sides: Vec<Option<u32>>,
    /// For each gap of the map whether no colour goes through it.
    pub closed_gaps: Vec<bool>,
}

impl Labels {
    /// No side has a colour, and all gaps are open.
    pub fn none(map: &PlanarMap) -> Self {
        Self { sides: vec![None; map.side_count()], closed_gaps: vec![false; map.gaps().len()] }
    }
}

/// A way to tell which scribble colours which side.
///
/// It is given the scribbles that fill; those that shade colour no sides. Labels depend on the map and the scribbles
/// alone, never on the calls before: an engine may keep what it worked out for the scribbles of the last call, and redo
/// only what differs.
pub trait Engine {
    /// Labels for all sides and gaps of the map. An engine serves one map all its life.
    fn label(&mut self, map: &PlanarMap, scribbles: &[Scribble]) -> Labels {
        now(self.labelling(map, scribbles))
    }

    /// The same in slices. What is left of an engine that was not let finish is of no use.
    fn labelling<'a>(&'a mut self, map: &'a PlanarMap, scribbles: &'a [Scribble]) -> Slices<'a, Labels>;
}

/// Tells nothing of what an engine holds: a page that never asks would carry the code for all of it.
impl fmt::Debug for dyn Engine {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Engine")
    }
}
