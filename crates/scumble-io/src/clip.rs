//! What clip paths, masks that cut as these do, or what is painted over them, leave of shapes, as the Bézier curves that they are.
//!
//! Each outline is parted where it crosses another one, and every part is asked for what lies at its two sides: of lines there
//! remain those that are seen, of an area what has the seen on one side alone. (Libraries that cut areas make polygons of
//! them, or fail on some.)
//!
//! | noun | file |
//! |---|---|
//! | an area, and whether a point is in it | `area` |
//! | the parts of a path between its crossings | `parts` |
//! | parts that are put together | `joining` |
//! | what all that may take | `work` |

mod area;
mod joining;
mod parts;
mod work;

use std::collections::HashSet;
use std::rc::Rc;

use kurbo::{BezPath, ParamCurve, PathSeg, Point, Rect};

pub(crate) use area::{Area, Outlines};
use joining::grown;
pub(crate) use parts::Parts;
use parts::parts;
pub(crate) use work::{TooMuch, Work};

use crate::outline::is_closed;

/// What is nearer to the border of the page is at it, in du.
const AT_PAGE_DU: f64 = 0.5;

/// Parts that are as near to each other meet, in du: where curves run along each other, crossings are told less well.
const MEET_DU: f64 = 0.5;

/// Outlines as near to each other as this, in du, are the same.
const ALIKE_DU: f64 = 0.1;

/// Parts with their middles in the same square of such a side, or in the next one, are the same, in du.
const SAME_DU: f64 = 0.04;

/// What is left of an area of which a part is hidden.
#[derive(Debug)]
pub(crate) struct Rest {
    /// Its outlines, to be filled by turns.
    pub(crate) area: Vec<BezPath>,
    /// The same without what is at the border of the page.
    pub(crate) outlines: Vec<BezPath>,
    /// What of these are outlines of clip paths.
    pub(crate) edges: Vec<BezPath>,
}

/// What shapes are cut by.
#[derive(Debug)]
struct Level {
    areas: Vec<Rc<Area>>,
    /// Whether they hide what is within any of them, as what is painted over it does; clip paths hide the rest.
    covers: bool,
}

/// Clip paths within each other, and what covers shapes.
#[derive(Debug)]
pub(crate) struct Clip {
    levels: Vec<Level>,
    /// What is not at its border.
    page: Area,
    work: Work,
}

impl Clip {
    /// With no clip path yet, for shapes on a page.
    pub(crate) fn new(page: Rect) -> Self {
        let page = Area::rectangle(page.inset(-AT_PAGE_DU));
        Self { levels: Vec::new(), page, work: Work::new() }
    }

    /// Adds a clip path that consists of some areas, or what covers these.
    ///
    /// # Errors
    /// When it takes too long to look at them.
    pub(crate) fn push(&mut self, areas: Vec<Outlines>, covers: bool) -> Result<(), TooMuch> {
        let areas = areas.into_iter().map(|area| self.shape(area)).collect::<Result<_, _>>()?;
        self.levels.push(Level { areas, covers });
        Ok(())
    }

    /// An area that may cover others.
    ///
    /// # Errors
    /// When it takes too long to look at it.
    pub(crate) fn shape(&mut self, outlines: Outlines) -> Result<Rc<Area>, TooMuch> {
        Area::new(outlines, &mut self.work).map(Rc::new)
    }

    /// Takes some comparisons from those that are left.
    ///
    /// # Errors
    /// When there are fewer.
    pub(crate) fn spend(&mut self, work: u64) -> Result<(), TooMuch> {
        self.work.spend(work)
    }

    /// Has some areas cover what is looked at next.
    pub(crate) fn cover(&mut self, areas: Vec<Rc<Area>>) {
        self.levels = vec![Level { areas, covers: true }];
    }

    /// How many there are.
    pub(crate) fn depth(&self) -> usize {
        self.levels.len()
    }

    /// Takes all away but so many.
    pub(crate) fn leave(&mut self, depth: usize) {
        self.levels.truncate(depth);
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.levels.is_empty()
    }

    /// What is seen of a line, and of one that runs along the outline of a clip path all.
    ///
    /// # Errors
    /// When it takes too long to find that.
    pub(crate) fn line(&mut self, path: &BezPath) -> Result<Vec<BezPath>, TooMuch> {
        let Self { levels, work, .. } = self;
        work.spend(levels.iter().map(|level| level.areas.len() as u64).sum())?;
        let areas: Vec<_> = areas(levels).collect();
        let bounds = bounds(levels);
        parts(path, bounds, &areas, work, |sides| sides.into_iter().any(|side| is_seen(levels, side)))
    }

    /// Whether a closed line is all that a clip path consists of, so that half of it is hidden.
    pub(crate) fn is_outline(&self, path: &BezPath) -> bool {
        let outline_of = |level: &Level| match &*level.areas {
            [area] if !level.covers => {
                <&[BezPath; 1]>::try_from(&*area.outlines).ok().map(|[outline]| are_alike(outline, path))
            }
            _ => None,
        };
        is_closed(path) && self.levels.iter().any(|level| outline_of(level).unwrap_or(false))
    }

    /// What is seen of an area of which a part is hidden.
    ///
    /// # Errors
    /// When it takes too long to find that.
    pub(crate) fn area(&mut self, outlines: Outlines) -> Result<Option<Rest>, TooMuch> {
        let area = Area::new(outlines, &mut self.work)?;
        let [own, edges] = self.border(&area)?;
        if edges.is_empty() && own == area.outlines {
            return Ok(None);
        }
        let edges_on_page = self.on_page(&edges)?;
        Ok(Some(Rest {
            // What is filled is closed in any case: better by the nearest way.
            area: self.joined([&*own, &edges].concat(), f64::INFINITY)?,
            outlines: self.joined([&*own, &edges_on_page].concat(), MEET_DU)?,
            edges: self.joined(edges_on_page, MEET_DU)?,
        }))
    }

    /// Parts of the outlines of an area, and of those of clip paths, around what is seen of it.
    fn border(&mut self, area: &Area) -> Result<[Vec<BezPath>; 2], TooMuch> {
        let Self { levels, work, .. } = self;
        let areas: Vec<_> = std::iter::once(area).chain(areas(levels)).collect();
        let bounds = border_bounds(levels, area);
        let mut border = [Vec::new(), Vec::new()];
        let mut known = HashSet::new();
        for (i, of) in areas.iter().enumerate() {
            // Where borders run along each other, the part is that of the first.
            let mut is_border = |sides: [Point; 2]| {
                let [left, right] = sides.map(|side| area.contains(side) && is_seen(levels, side));
                let is_first = || areas[..=i].iter().position(|area| area.is_parted(sides)) == Some(i);
                left != right && is_first() && is_new(&mut known, sides[0].midpoint(sides[1]))
            };
            for outline in &of.outlines {
                border[usize::from(i > 0)].extend(parts(outline, bounds, &areas, work, &mut is_border)?);
            }
        }
        Ok(border)
    }

    /// What of some paths is on the page, and not at its border.
    fn on_page(&mut self, paths: &[BezPath]) -> Result<Vec<BezPath>, TooMuch> {
        let Self { page, work, .. } = self;
        let parts =
            paths.iter().map(|path| parts(path, page.bounds, &[page], work, |sides| page.contains(sides[0])));
        Ok(parts.collect::<Result<Vec<_>, _>>()?.concat())
    }

    /// Parts of outlines put together where they come as near as this: closed, where nothing is missing.
    fn joined(&mut self, parts: Vec<BezPath>, meet_du: f64) -> Result<Vec<BezPath>, TooMuch> {
        self.spend((parts.len() as u64).pow(2))?;
        let (mut joined, mut open): (Vec<_>, Vec<_>) = parts.into_iter().partition(is_closed);
        while let Some(first) = open.pop() {
            joined.push(grown(first, &mut open, meet_du));
        }
        Ok(joined)
    }
}

/// Whether a part with this middle is not known yet: an outline may run along itself.
fn is_new(known: &mut HashSet<[i64; 2]>, middle: Point) -> bool {
    let [column, row] = [middle.x, middle.y].map(|along| (along / SAME_DU).floor() as i64);
    let mut beside = (-1..=1).flat_map(|x| (-1..=1).map(move |y| [column + x, row + y]));
    !beside.any(|square| known.contains(&square)) && known.insert([column, row])
}

/// Whether two paths run the same way, and at the same places.
fn are_alike(one: &BezPath, other: &BezPath) -> bool {
    let near = |(a, b): (PathSeg, PathSeg)| {
        [0.0, 0.25, 0.75, 1.0].into_iter().all(|t| a.eval(t).distance(b.eval(t)) < ALIKE_DU)
    };
    one.elements().len() == other.elements().len() && one.segments().zip(other.segments()).all(near)
}

fn areas(levels: &[Level]) -> impl Iterator<Item = &Area> {
    levels.iter().flat_map(|level| &level.areas).map(Rc::as_ref)
}

fn is_seen(levels: &[Level], point: Point) -> bool {
    levels.iter().all(|level| level.areas.iter().any(|area| area.contains(point)) != level.covers)
}

/// Where outlines may be around what is seen of an area: beyond clip paths nothing is seen, but beyond what covers it all of it.
fn border_bounds(levels: &[Level], area: &Area) -> Rect {
    let is_covered = levels.iter().any(|level| level.covers);
    if is_covered { area.bounds } else { bounds(levels).intersect(area.bounds) }
}

/// Beyond these bounds nothing is seen, or all where there is nothing but what covers it.
fn bounds(levels: &[Level]) -> Rect {
    let bounds_of = |level: &Level| level.areas.iter().map(|area| area.bounds).reduce(|a, b| a.union(b));
    let clips = levels.iter().filter(|level| !level.covers).filter_map(bounds_of);
    let covers = levels.iter().filter_map(bounds_of);
    clips.reduce(|a, b| a.intersect(b)).or_else(|| covers.reduce(|a, b| a.union(b))).unwrap_or_default()
}
