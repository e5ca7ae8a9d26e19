//! A shape: its line, and whether its filling is ink that belongs to the lines or an area to be coloured.

use kurbo::{Affine, BezPath};
use scumble_core::{Line, Rgba8};
use usvg::FillRule;

use crate::{outline, paint};

/// Dark areas with a hue are lines up to this mean width, in du, and shapes beyond: navy trousers are to be coloured.
const WIDEST_LINE_DU: f64 = 24.0;

/// Areas of other colours that are as thin are lines where they are so many times as long as wide: a pencil's strokes that were
/// made outlines.
const LEAST_LENGTHS: f64 = 40.0;

/// A path of a clip path or a mask, and how it lies there.
pub(super) type Placed<'a> = (&'a usvg::Path, Affine);

/// A shape before it is cut.
#[derive(Debug)]
pub(super) struct Shape {
    pub(super) subpaths: Vec<BezPath>,
    pub(super) line: Option<Line>,
    pub(super) fill: Option<Filling>,
}

/// What a shape is filled with.
#[derive(Clone, Copy, Debug)]
pub(super) struct Filling {
    pub(super) color: Rgba8,
    pub(super) even_odd: bool,
    /// Whether it belongs to the lines.
    pub(super) is_ink: bool,
    /// Whether it hides lines that are painted before it, and ink.
    pub(super) hides: [bool; 2],
}

impl Filling {
    /// `None` where nothing of it shows, given what the groups around it leave of its opacity. For the lines that it hides within
    /// them that does not matter.
    pub(super) fn of(fill: &usvg::Fill, opacity: f32, subpaths: &[BezPath]) -> Option<Self> {
        let own = fill.opacity().get();
        let color = paint::color(fill.paint(), opacity * own)?;
        let even_odd = fill.rule() == FillRule::EvenOdd;
        let is_ink = is_ink(color, outline::mean_size_du(subpaths, even_odd));
        let [hides_lines, is_opaque] =
            [own, opacity * own].map(|opacity| paint::is_opaque(fill.paint(), opacity));
        // A light in an eye may be glassy.
        let hides_ink = !is_ink && (is_opaque || paint::is_light(color));
        Some(Self { color, even_odd, is_ink, hides: [hides_lines, hides_ink] })
    }
}

/// Whether an area of a mean width and length is a line, or as dark as lines are.
fn is_ink(color: Rgba8, [wide_du, long_du]: [f64; 2]) -> bool {
    let is_thin = wide_du <= WIDEST_LINE_DU;
    let is_line = is_thin && long_du >= LEAST_LENGTHS * wide_du && !paint::is_pale(color);
    is_line || paint::is_ink(color) && (is_thin || !paint::has_hue(color))
}

pub(super) fn affine(t: usvg::Transform) -> Affine {
    Affine::new([t.sx, t.ky, t.kx, t.sy, t.tx, t.ty].map(f64::from))
}
