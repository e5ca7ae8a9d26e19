//! What was left out of a file that could be used otherwise.

use std::fmt;

/// What was left out of a drawing.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ImportNotes {
    /// Text elements.
    pub texts: usize,
    /// Raster images.
    pub images: usize,
    /// Clip paths, where what they hide is shown.
    pub clip_paths: usize,
    /// Masks, where what they hide is shown.
    pub masks: usize,
    /// Filters: what they change is shown unchanged.
    pub filters: usize,
    /// Markers, such as arrow heads.
    pub markers: usize,
    /// Transforms of styles in percent, in space, or around a shape's own box: what they move stays.
    pub transforms: usize,
    /// Shapes with a pattern for a paint: lines are grey, areas empty.
    pub patterns: usize,
    /// Lines and areas under others that are shown whole, as it would take too long to find what is hidden of them.
    pub covers: usize,
    /// Shapes and subpaths with coordinates that are no numbers or far too large.
    pub broken: usize,
    /// Colours that cannot be read: lines are black, areas have an outline.
    pub bad_colors: usize,
}

impl ImportNotes {
    /// Whether nothing was left out.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}

impl fmt::Display for ImportNotes {
    /// One line without a full stop; empty if nothing was left out.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts = [
            (self.texts, "text", "texts"),
            (self.images, "image", "images"),
            (self.clip_paths, "clip path", "clip paths"),
            (self.masks, "mask", "masks"),
            (self.filters, "filter", "filters"),
            (self.markers, "marker", "markers"),
            (self.transforms, "transform", "transforms"),
            (self.patterns, "pattern", "patterns"),
            (self.covers, "cover of a line that is shown whole", "covers of lines that are shown whole"),
            (self.broken, "shape with unusable coordinates", "shapes with unusable coordinates"),
            (self.bad_colors, "colour that cannot be read", "colours that cannot be read"),
        ];
        write_counts(f, "left out: ", &counts)
    }
}

/// What was left out of diffusion curves that were read.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CurveNotes {
    /// Curves that are blurred: they are shown sharp.
    pub blurred: usize,
    /// Curves without four control points, or with some that are no numbers or far too large.
    pub broken: usize,
    /// Colours without numbers for all channels and their place.
    pub bad_colors: usize,
}

impl fmt::Display for CurveNotes {
    /// One line without a full stop; empty if nothing was left out.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts = [
            (self.blurred, "curve’s blur", "curves’ blur"),
            (self.broken, "curve with unusable control points", "curves with unusable control points"),
            (self.bad_colors, "colour without all its numbers", "colours without all their numbers"),
        ];
        write_counts(f, "left out: ", &counts)
    }
}

/// What diffusion curves that were written leave out of a picture.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CurveSetNotes {
    /// Scribbles that shade.
    pub shades: usize,
    /// Stretches of sides that fade to no colour: they fade to white.
    pub clear: usize,
}

impl fmt::Display for CurveSetNotes {
    /// One line without a full stop; empty if nothing was left out.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts = [
            (self.shades, "scribble that shades", "scribbles that shade"),
            (self.clear, "side without colour, which is white", "sides without colour, which are white"),
        ];
        write_counts(f, "left out: ", &counts)
    }
}

/// What was left out of a list of scribbles.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ScribbleNotes {
    /// Fields that no scribble has.
    pub unknown_fields: usize,
    /// Scribbles whose colour is neither `#rrggbb` nor `none`.
    pub bad_colors: usize,
    /// Scribbles whose kind is neither `fill` nor `shade`.
    pub bad_kinds: usize,
    /// Scribbles that shade with a strength outside `0..=1`.
    pub bad_strengths: usize,
    /// Points with a pressure outside `0..=1`: the nearest one of these is taken.
    pub bad_pressures: usize,
    /// Scribbles whose width is zero, negative, or wider than the page.
    pub bad_widths: usize,
    /// Scribbles without points.
    pub no_points: usize,
    /// Scribbles that lie off the page.
    pub off_page: usize,
    /// Points far outside the page, brought nearer to it.
    pub far_points: usize,
}

impl ScribbleNotes {
    /// Whether everything could be used as it is.
    pub fn is_empty(&self) -> bool {
        *self == Self::default()
    }
}

impl fmt::Display for ScribbleNotes {
    /// One line without a full stop; empty if everything could be used as it is.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let counts = [
            (self.unknown_fields, "unknown field", "unknown fields"),
            (self.bad_colors, "scribble without a colour #rrggbb", "scribbles without a colour #rrggbb"),
            (
                self.bad_kinds,
                "scribble that is neither fill nor shade",
                "scribbles that are neither fill nor shade",
            ),
            (
                self.bad_strengths,
                "shade with a strength not from 0 to 1",
                "shades with a strength not from 0 to 1",
            ),
            (self.bad_pressures, "pressure not from 0 to 1", "pressures not from 0 to 1"),
            (self.bad_widths, "scribble of unusable width", "scribbles of unusable width"),
            (self.no_points, "scribble without points", "scribbles without points"),
            (self.off_page, "scribble off the page", "scribbles off the page"),
            (self.far_points, "stretch far outside the page", "stretches far outside the page"),
        ];
        write_counts(f, "left out: ", &counts)
    }
}

fn write_counts(f: &mut fmt::Formatter<'_>, lead: &str, counts: &[(usize, &str, &str)]) -> fmt::Result {
    let mut separator = lead;
    for &(count, one, many) in counts.iter().filter(|(count, ..)| *count > 0) {
        write!(f, "{separator}{count} {}", if count == 1 { one } else { many })?;
        separator = ", ";
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn notes_read_as_a_sentence() {
        assert_eq!(ImportNotes::default().to_string(), "");
        let notes = ImportNotes { texts: 1, images: 2, ..ImportNotes::default() };
        assert_eq!(notes.to_string(), "left out: 1 text, 2 images");
        let notes = ScribbleNotes { off_page: 2, far_points: 1, ..ScribbleNotes::default() };
        assert_eq!(notes.to_string(), "left out: 2 scribbles off the page, 1 stretch far outside the page");
    }
}
