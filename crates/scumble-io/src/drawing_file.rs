//! Drawings of other programs: SVG, or diffusion curves as XML.

use scumble_core::Document;

use crate::curve_set;
use crate::error::ImportError;
use crate::svg::import_svg;

/// Reads a drawing, of whichever kind it is; and what was left out, in one line without a full stop.
///
/// # Errors
/// When the bytes are none, or beyond the limits.
pub fn import_drawing(bytes: &[u8]) -> Result<(Document, String), ImportError> {
    if curve_set::is_curve_set(bytes) {
        let (document, notes) = curve_set::import(bytes)?;
        return Ok((document, notes.to_string()));
    }
    let import = import_svg(bytes)?;
    Ok((Document::new(import.drawing), import.notes.to_string()))
}
