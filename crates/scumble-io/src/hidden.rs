//! What opaque areas hide of lines and ink that are painted before them.

use std::rc::Rc;

use kurbo::{BezPath, Rect};
use scumble_core::{Curve, Drawing, Fill};

use crate::clip::{Area, Clip, Outlines, Rest, TooMuch};

/// An area that hides lines and ink, or either.
#[derive(Debug)]
pub(crate) struct Cover {
    pub(crate) area: Outlines,
    /// Whether it hides lines, and ink.
    pub(crate) hides: [bool; 2],
    /// How many curves and fills are painted before it.
    pub(crate) under: [usize; 2],
}

/// Areas that hide curves, or fills, in painting order.
struct Covers {
    areas: Vec<Rc<Area>>,
    bounds: Vec<Rect>,
    /// How many of those that they hide are painted before each.
    under: Vec<usize>,
}

impl Covers {
    fn new(covers: &[Cover], areas: &[Rc<Area>], kind: usize) -> Self {
        let hiding = || covers.iter().zip(areas).filter(|(cover, _)| cover.hides[kind]);
        Self {
            areas: hiding().map(|(_, area)| Rc::clone(area)).collect(),
            bounds: hiding().map(|(_, area)| area.bounds).collect(),
            under: hiding().map(|(cover, _)| cover.under[kind]).collect(),
        }
    }

    /// Has what is painted over something cover what is looked at next, and tells whether there is any.
    fn cover(&self, i: usize, bounds: Rect, clip: &mut Clip) -> Result<bool, TooMuch> {
        let first = self.under.partition_point(|&under| under <= i);
        let later = &self.bounds[first..];
        clip.spend(later.len() as u64 / 2)?;
        let above =
            later.iter().zip(&self.areas[first..]).filter(|(area_bounds, _)| area_bounds.overlaps(bounds));
        let above: Vec<_> = above.map(|(_, area)| Rc::clone(area)).collect();
        let is_under = !above.is_empty();
        clip.cover(above);
        Ok(is_under)
    }
}

/// A drawing without what is hidden by areas, which are in painting order.
///
/// # Errors
/// When it takes too long to find that.
pub(crate) fn without_hidden(drawing: &Drawing, covers: &[Cover]) -> Result<Drawing, TooMuch> {
    let mut clip = Clip::new(drawing.frame());
    let areas = covers.iter().map(|cover| clip.shape(cover.area.clone())).collect::<Result<Vec<_>, _>>()?;
    let [of_lines, of_ink] = [0, 1].map(|kind| Covers::new(covers, &areas, kind));
    let mut seen = Drawing::new(drawing.page);
    for (i, curve) in drawing.curves.iter().enumerate() {
        let paths = match of_lines.cover(i, curve.path.control_box(), &mut clip)? {
            true => clip.line(&curve.path)?,
            false => vec![curve.path.clone()],
        };
        seen.curves.extend(paths.into_iter().map(|path| Curve { path, line: curve.line.clone() }));
    }
    for (i, fill) in drawing.fills.iter().enumerate() {
        let is_under = of_ink.cover(i, fill.path.control_box(), &mut clip)?;
        seen.fills.extend(if is_under { rest(fill, &mut clip)? } else { Some(fill.clone()) });
    }
    Ok(seen)
}

/// What is left of ink; `None` where all of it is hidden.
fn rest(fill: &Fill, clip: &mut Clip) -> Result<Option<Fill>, TooMuch> {
    let subpaths = fill.path.subpaths().map(|subpath| BezPath::from_vec(subpath.to_vec())).collect();
    Ok(match clip.area((subpaths, fill.even_odd))? {
        None => Some(fill.clone()),
        Some(Rest { area, .. }) if area.is_empty() => None,
        Some(Rest { area, .. }) => {
            Some(Fill { path: area.iter().flatten().collect(), even_odd: true, ..*fill })
        }
    })
}
