//! An area, and whether a point is in it.

use std::ops::Range;

use kurbo::{BezPath, Line, ParamCurve, PathEl, Point, Rect, Shape};

use super::work::{TooMuch, Work};
use crate::outline;

/// How far from its curve a chord may be, in du.
const FLAT_DU: f64 = 0.01;

/// Bands of an area, at most.
const MOST_BANDS: f64 = 256.0;

/// Comparisons that it takes to make a chord.
const CHORD_WORK: u64 = 3;

/// Outlines, and whether what is within two of them is outside.
pub(crate) type Outlines = (Vec<BezPath>, bool);

/// An area with its outlines, each closed.
#[derive(Debug)]
pub(crate) struct Area {
    pub(super) outlines: Vec<BezPath>,
    even_odd: bool,
    pub(crate) bounds: Rect,
    /// The outlines, flattened: of each band of equal height, from the upper end of the bounds to the lower, the chords that
    /// reach it.
    pub(super) bands: Vec<Vec<Line>>,
}

impl Area {
    pub(super) fn new((subpaths, even_odd): Outlines, work: &mut Work) -> Result<Self, TooMuch> {
        let outlines: Vec<_> = subpaths.into_iter().map(outline::closed).collect();
        let mut chords = Vec::new();
        for outline in &outlines {
            flatten(outline, &mut chords, work)?;
        }
        let bounds = outlines.iter().map(BezPath::control_box).reduce(|a, b| a.union(b)).unwrap_or_default();
        let count = (chords.len() as f64).sqrt().min(MOST_BANDS) as usize + 1;
        let mut area = Self { outlines, even_odd, bounds, bands: vec![Vec::new(); count] };
        for chord in chords {
            let bands = area.bands_of(chord.bounding_box());
            work.spend(bands.len() as u64)?;
            bands.for_each(|band| area.bands[band].push(chord));
        }
        Ok(area)
    }

    pub(super) fn rectangle(rect: Rect) -> Self {
        let path = rect.to_path(FLAT_DU);
        let sides = path.segments().map(|side| Line::new(side.start(), side.end())).collect();
        Self { outlines: vec![path], even_odd: false, bounds: rect, bands: vec![sides] }
    }

    /// The bands that some bounds reach.
    pub(super) fn bands_of(&self, bounds: Rect) -> Range<usize> {
        let last = self.bands.len() - 1;
        let band = |y: f64| ((y - self.bounds.y0) / self.bounds.height() * self.bands.len() as f64) as usize;
        band(bounds.y0).min(last)..band(bounds.y1).min(last) + 1
    }

    pub(super) fn contains(&self, point: Point) -> bool {
        self.bounds.contains(point) && {
            let band = &self.bands[self.bands_of(Rect::from_points(point, point)).start];
            let winding = band.iter().map(|chord| turn(chord, point)).sum::<i32>();
            if self.even_odd { winding % 2 != 0 } else { winding != 0 }
        }
    }

    /// Whether a point at one side of an outline is in it and one at the other is not.
    pub(super) fn is_parted(&self, [left, right]: [Point; 2]) -> bool {
        self.contains(left) != self.contains(right)
    }

    /// Most comparisons that it takes to tell whether a point is in it.
    pub(super) fn size(&self) -> u64 {
        self.bands.iter().map(|band| 1 + band.len() as u64).max().unwrap_or(0)
    }
}

/// How often a chord goes round a point: whether, and in which sense, it crosses the ray from there to the right.
fn turn(chord: &Line, point: Point) -> i32 {
    let Line { p0, p1 } = chord;
    if (p0.y <= point.y) == (p1.y <= point.y) {
        return 0;
    }
    let is_right = (*p1 - *p0).cross(point - *p0) * (p1.y - p0.y) > 0.0;
    if is_right { (p1.y - p0.y).signum() as i32 } else { 0 }
}

/// Adds the chords of a closed outline, segment by segment, so that it ends where it takes too much work.
fn flatten(outline: &BezPath, chords: &mut Vec<Line>, work: &mut Work) -> Result<(), TooMuch> {
    for segment in outline.segments() {
        let (before, mut from) = (chords.len(), segment.start());
        let elements = [PathEl::MoveTo(from), segment.as_path_el()];
        kurbo::flatten(elements, FLAT_DU, |element| {
            if let PathEl::LineTo(to) = element {
                chords.push(Line::new(from, to));
                from = to;
            }
        });
        work.spend(CHORD_WORK * (chords.len() - before) as u64)?;
    }
    Ok(())
}
