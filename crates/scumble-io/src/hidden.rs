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
    /// Those that it hides: the first, and how many curves and fills are painted before it.
    pub(crate) since: [usize; 2],
    pub(crate) under: [usize; 2],
}

/// Areas that hide curves, or fills, in painting order.
struct Covers {
    areas: Vec<Rc<Area>>,
    bounds: Vec<Rect>,
    /// The first of those that each hides, and how many are painted before it.
    since: Vec<usize>,
    under: Vec<usize>,
}

impl Covers {
    fn new(covers: &[Cover], areas: &[Rc<Area>], kind: usize) -> Self {
        let hiding = || covers.iter().zip(areas).filter(|(cover, _)| cover.hides[kind]);
        Self {
            areas: hiding().map(|(_, area)| Rc::clone(area)).collect(),
            bounds: hiding().map(|(_, area)| area.bounds).collect(),
            since: hiding().map(|(cover, _)| cover.since[kind]).collect(),
            under: hiding().map(|(cover, _)| cover.under[kind]).collect(),
        }
    }

    /// The parts of a line that are seen. One area is looked at after the other first, as what one of them hides is nothing to the
    /// others; but a line between two areas is hidden by both together.
    fn parts(&self, i: usize, path: &BezPath, clip: &mut Clip) -> Result<Vec<BezPath>, TooMuch> {
        let above = self.above(i, path.control_box(), clip)?;
        let mut paths = vec![path.clone()];
        let one_by_one = above.iter().map(|area| vec![Rc::clone(area)]);
        for areas in one_by_one.chain([above.clone()]) {
            clip.cover(areas);
            paths = paths.iter().map(|path| clip.line(path)).collect::<Result<Vec<_>, _>>()?.concat();
        }
        Ok(paths)
    }

    /// What is left of ink; `None` where all of it is hidden.
    fn rest(&self, i: usize, fill: &Fill, clip: &mut Clip) -> Result<Option<Fill>, TooMuch> {
        let above = self.above(i, fill.path.control_box(), clip)?;
        if above.is_empty() {
            return Ok(Some(fill.clone()));
        }
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

    /// The areas that are painted over something.
    fn above(&self, i: usize, bounds: Rect, clip: &mut Clip) -> Result<Vec<Rc<Area>>, TooMuch> {
        let first = self.under.partition_point(|&under| under <= i);
        let later = self.bounds[first..].iter().zip(&self.areas[first..]);
        clip.spend(later.len() as u64 / 2)?;
        let above = later
            .zip(&self.since[first..])
            .filter(|((area_bounds, _), since)| **since <= i && area_bounds.overlaps(bounds));
        Ok(above.map(|((_, area), _)| Rc::clone(area)).collect())
    }
}

/// A drawing without what is hidden by areas, which are in painting order, and how many of its lines and fills may be shown more
/// than they are seen, as it would take too long to find that.
pub(crate) fn without_hidden(drawing: &Drawing, covers: &[Cover]) -> (Drawing, usize) {
    let mut clip = Clip::new(drawing.frame());
    let areas: Result<Vec<_>, _> = covers.iter().map(|cover| clip.shape(cover.area.clone())).collect();
    let Ok(areas) = areas else { return (drawing.clone(), drawing.curves.len() + drawing.fills.len()) };
    let [of_lines, of_ink] = [0, 1].map(|kind| Covers::new(covers, &areas, kind));
    let (mut seen, mut whole) = (Drawing::new(drawing.page), 0);
    for (i, curve) in drawing.curves.iter().enumerate() {
        let paths = of_lines.parts(i, &curve.path, &mut clip).unwrap_or_else(|TooMuch| {
            whole += 1;
            vec![curve.path.clone()]
        });
        seen.curves.extend(paths.into_iter().map(|path| Curve { path, line: curve.line.clone() }));
    }
    for (i, fill) in drawing.fills.iter().enumerate() {
        seen.fills.extend(of_ink.rest(i, fill, &mut clip).unwrap_or_else(|TooMuch| {
            whole += 1;
            Some(fill.clone())
        }));
    }
    (seen, whole)
}
