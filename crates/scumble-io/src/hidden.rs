//! What opaque areas hide of lines and ink that are painted before them.

use std::rc::Rc;

use kurbo::{BezPath, Rect};
use scumble_core::{Curve, Drawing, Fill};

use crate::clip::{Area, Clip, Outlines, Rest, TooMuch};

/// An opaque area, and how many curves and fills are painted before it.
#[derive(Debug)]
pub(crate) struct Cover {
    pub(crate) area: Outlines,
    pub(crate) curves: usize,
    pub(crate) fills: usize,
}

/// A drawing without what is hidden by areas, which are in painting order.
///
/// # Errors
/// When it takes too long to find that.
pub(crate) fn without_hidden(drawing: &Drawing, covers: &[Cover]) -> Result<Drawing, TooMuch> {
    let mut clip = Clip::new(drawing.frame());
    let areas = covers.iter().map(|cover| clip.shape(cover.area.clone())).collect::<Result<Vec<_>, _>>()?;
    let mut seen = Drawing::new(drawing.page);
    for (i, curve) in drawing.curves.iter().enumerate() {
        let first = covers.partition_point(|cover| cover.curves <= i);
        let above = overlapping(&areas[first..], curve.path.control_box(), &mut clip)?;
        let paths = if above.is_empty() {
            vec![curve.path.clone()]
        } else {
            uncovered(&curve.path, above, &mut clip)?
        };
        seen.curves.extend(paths.into_iter().map(|path| Curve { path, line: curve.line.clone() }));
    }
    for (i, fill) in drawing.fills.iter().enumerate() {
        let first = covers.partition_point(|cover| cover.fills <= i);
        let above = overlapping(&areas[first..], fill.path.control_box(), &mut clip)?;
        seen.fills.extend(if above.is_empty() { Some(fill.clone()) } else { rest(fill, above, &mut clip)? });
    }
    Ok(seen)
}

fn overlapping(areas: &[Rc<Area>], bounds: Rect, clip: &mut Clip) -> Result<Vec<Rc<Area>>, TooMuch> {
    // It takes less to compare bounds than anything else.
    clip.spend(areas.len() as u64 / 8)?;
    Ok(areas.iter().filter(|area| area.bounds.overlaps(bounds)).cloned().collect())
}

fn uncovered(path: &BezPath, above: Vec<Rc<Area>>, clip: &mut Clip) -> Result<Vec<BezPath>, TooMuch> {
    clip.cover(above);
    clip.line(path)
}

/// What is left of ink; `None` where all of it is hidden.
fn rest(fill: &Fill, above: Vec<Rc<Area>>, clip: &mut Clip) -> Result<Option<Fill>, TooMuch> {
    clip.cover(above);
    let subpaths = fill.path.subpaths().map(|subpath| BezPath::from_vec(subpath.to_vec())).collect();
    Ok(match clip.area((subpaths, fill.even_odd))? {
        None => Some(fill.clone()),
        Some(Rest { area, .. }) if area.is_empty() => None,
        Some(Rest { area, .. }) => {
            Some(Fill { path: area.iter().flatten().collect(), even_odd: true, ..*fill })
        }
    })
}
