//! Engines: what turns scribbles into a label for each side of each piece of curve.

use crate::planar_map::PlanarMap;
use crate::scribble::Scribble;

/// For each side (indexed by [`crate::SideId`]) the scribble that gives it its colour, if any.
pub type Labels = Vec<Option<u32>>;

/// A way to tell which scribble colours which side.
///
/// Labels depend on the map and the scribbles alone, never on the calls before: an engine may keep what it worked
/// out for the scribbles of the last call, and redo only what differs.
pub trait Engine {
    /// Labels for all sides of the map. An engine serves one map all its life.
    fn label(&mut self, map: &PlanarMap, scribbles: &[Scribble]) -> Labels;
}
