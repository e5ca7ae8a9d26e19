//! Other people's ways to colour, on pixels, to compare with. Nothing else uses them.
//!
//! | noun | file |
//! |---|---|
//! | lines and scribbles as pixels | `sketch` |
//! | each pixel takes the nearest scribble's colour | `nearest` |
//! | flood fill without gap closing | `flood` |
//! | LazyBrush: minimum cuts | `lazybrush` |
//! | … the minimum cut of a grid | `grid_cut` |

mod flood;
mod grid_cut;
mod lazybrush;
mod nearest;
mod sketch;

pub(crate) use flood::flood;
pub(crate) use lazybrush::{HARD, SOFT, lazybrush};
pub(crate) use nearest::nearest;
pub(crate) use sketch::{Sketch, SketchPixel, neighbors};
