//! Drawings of other programs, and pictures that were exported: SVG, or diffusion curves as XML.

use scumble_core::Work;

use crate::curve_set;
use crate::error::ImportError;
use crate::svg_source::open_svg;

/// Reads a drawing, of whichever kind it is, or the work that an exported SVG keeps; and what was left out, in one line
/// without a full stop.
///
/// # Errors
/// When the bytes are none, or beyond the limits.
pub fn import_drawing(bytes: &[u8]) -> Result<(Work, String), ImportError> {
    if curve_set::is_curve_set(bytes) {
        let (document, notes) = curve_set::import(bytes)?;
        return Ok((Work::new(document), notes.to_string()));
    }
    open_svg(bytes)
}
