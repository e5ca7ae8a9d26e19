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

/// Lines of no more elements are looked at with one area after the other first, where these are large beside them: mostly the first
/// few hide all.
const SHORT: usize = 20;

/// An area is large beside a line if what they share of their bounds has more than this part of the line's diagonal.
const LARGE: f64 = 0.25;

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

    /// The parts of a line that are seen: of what large areas leave, one after the other, what all together leave, as a line between
    /// two areas is hidden by both.
    fn parts(&self, i: usize, path: &BezPath, clip: &mut Clip) -> Result<Vec<BezPath>, TooMuch> {
        let bounds = path.control_box();
        let above = self.above(i, bounds, clip)?;
        let is_large = |area: &&Rc<Area>| {
            path.elements().len() <= SHORT
                && diagonal_du(area.bounds.intersect(bounds)) > LARGE * diagonal_du(bounds)
        };
        let mut paths = vec![path.clone()];
        for area in above.iter().filter(is_large) {
            let (under, beside): (Vec<_>, _) =
                paths.into_iter().partition(|path| path.control_box().overlaps(area.bounds));
            paths = beside;
            clip.cover(vec![Rc::clone(area)]);
            paths.extend(seen(&under, clip)?);
        }
        clip.cover(above);
        seen(&paths, clip)
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

fn seen(paths: &[BezPath], clip: &mut Clip) -> Result<Vec<BezPath>, TooMuch> {
    Ok(paths.iter().map(|path| clip.line(path)).collect::<Result<Vec<_>, _>>()?.concat())
}

fn diagonal_du(rect: Rect) -> f64 {
    rect.width().hypot(rect.height())
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
