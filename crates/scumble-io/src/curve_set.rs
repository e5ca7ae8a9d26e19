//! Diffusion curves as XML, in the form of A. Orzan et al., *Diffusion Curves: A Vector Representation for Smooth-Shaded
//! Images* (2008), which others read and write too.
//!
//! What its names do not tell: a control point's `x` is its row and `y` its column; what is called `R` is blue and what
//! is called `B` is red; control points are cubics end to end, 3 n + 1 of them; `globalID` is ten times the place of a
//! colour, counted in cubics; left is to the left of the curve's direction, where y points down. A set of colours that is
//! empty, or whose `boundary` is `Neumann`, leaves its side without a colour.
//!
//! The form blends in sRGB; `blend` on the outermost element is ours, for pictures that do not. Blur is not read.

mod read;
mod write;

pub(crate) use read::{import, is_curve_set};
pub use write::write_curve_set;

/// The outermost element.
const ROOT: &str = "curve_set";

/// Steps of `globalID` in one cubic.
const IDS_PER_CUBIC: f64 = 10.0;

/// What `boundary` says of a set of colours that does not hold.
const BARRIER: &str = "Neumann";

/// What `blend` says of a picture that is blended in OKLab.
const OKLAB: &str = "oklab";
