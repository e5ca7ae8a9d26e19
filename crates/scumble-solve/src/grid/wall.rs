//! Straight lines among pixels: which rows and columns they cross, and where.
//!
//! All decisions of what lies on which side are exact, so that the cuts along a curve never leave a way through.

use std::ops::Range;

use kurbo::{Affine, Line, Point, Rect, Vec2};
use robust::{Coord, orient2d};
use scumble_core::{Bends, BlendColor, Boundary, PlanarMap, SideId};

use super::straights::{Straight, closed_gaps, straights};
use crate::quadratic;
use crate::scene::View;

/// Links and faces are within this of the centres of pixels, in px.
const RIM_PX: f64 = 2.0;

/// A straight line in px, pixel centres having whole coordinates.
#[derive(Clone, Copy)]
pub(super) struct Segment(pub(super) [Point; 2]);

/// Where a segment crosses a row or a column.
pub(super) struct Place {
    /// How far along the segment, from 0 to 1.
    pub(super) t: f64,
    /// Column or row of the last pixel before it, and how far beyond the centre of that one it is, in px.
    pub(super) before: i64,
    pub(super) fraction: f64,
}

/// A straight piece of something that no colour crosses.
pub(super) struct Wall {
    pub(super) segment: Segment,
    /// Where on the whole piece it starts and ends, from 0 to 1.
    parts: [f64; 2],
    /// The colours of the left and the right side of the piece at its start, middle and end.
    sides: [Option<[BlendColor; 3]>; 2],
}

/// Takes du to px, pixel centres having whole coordinates.
pub(super) fn centers_from_du(view: &View) -> Affine {
    view.px_from_du.then_translate(Vec2::new(-0.5, -0.5))
}

/// The pieces of a map, as they bend, and its closed gaps, in the pixels of a view.
pub(super) fn walls<'a>(
    map: &'a PlanarMap,
    bends: &'a Bends,
    boundary: &'a Boundary,
    view: &View,
) -> impl Iterator<Item = Wall> + use<'a> {
    let centers_from_du = centers_from_du(view);
    let color = |side: SideId| boundary.sides.get(side.index()).copied().flatten();
    let wall = move |Straight { piece, parts, ends }: Straight| {
        let right = color(SideId::of(piece, true)).map(|[start, middle, end]| [end, middle, start]);
        Wall { segment: Segment(ends), parts, sides: [color(SideId::of(piece, false)), right] }
    };
    let gaps = closed_gaps(map, boundary, centers_from_du).into_iter().map(|Line { p0, p1 }| Wall {
        segment: Segment([p0, p1]),
        parts: [0.0, 1.0],
        sides: [None; 2],
    });
    straights(map, bends, centers_from_du).map(wall).chain(gaps)
}

impl Segment {
    pub(super) fn moved(self, by: Vec2) -> Self {
        Self(self.0.map(|p| p + by))
    }

    /// Whether it leads on to further rows.
    pub(super) fn is_down(self) -> bool {
        self.0[1].y > self.0[0].y
    }

    /// Whether it leads to columns before.
    pub(super) fn is_back(self) -> bool {
        self.0[1].x < self.0[0].x
    }

    /// The rows that it crosses. A point on a row lies above it.
    pub(super) fn rows(self, height_px: u32) -> Range<i64> {
        let [a, b] = self.0;
        whole_numbers(a.y.min(b.y).ceil(), a.y.max(b.y).ceil(), height_px)
    }

    /// Whether it crosses a row.
    pub(super) fn crosses_row(self, row: i64) -> bool {
        let [a, b] = self.0;
        (a.y > row as f64) != (b.y > row as f64)
    }

    /// Where it crosses one of these rows.
    pub(super) fn on_row(self, row: i64) -> Place {
        let [a, b] = self.0;
        let t = (row as f64 - a.y) / (b.y - a.y);
        let x = a.x + t * (b.x - a.x);
        let before = last_where(x, |column| self.has_on_left(column, row) == self.is_down());
        Place { t, before, fraction: x - before as f64 }
    }

    /// The columns that it crosses. A point on a column lies to the right of it.
    pub(super) fn columns(self, width_px: u32) -> Range<i64> {
        let [a, b] = self.0;
        whole_numbers(a.x.min(b.x).floor() + 1.0, a.x.max(b.x).floor() + 1.0, width_px)
    }

    /// Where it crosses one of these columns.
    pub(super) fn on_column(self, column: i64) -> Place {
        let [a, b] = self.0;
        let t = (column as f64 - a.x) / (b.x - a.x);
        let y = a.y + t * (b.y - a.y);
        let before = last_where(y, |row| self.has_on_left(column, row) == self.is_back());
        Place { t, before, fraction: y - before as f64 }
    }

    /// Whether the centre of a pixel lies to the left of the line through it. A centre on the line does not: the line is
    /// taken to be moved by next to nothing in x, and by next to nothing of that in −y.
    fn has_on_left(self, column: i64, row: i64) -> bool {
        let [a, b] = self.0;
        let turn = orient2d(coord(a), coord(b), Coord { x: column as f64, y: row as f64 });
        let along = b - a;
        let sign = if turn != 0.0 {
            turn
        } else if along.y != 0.0 {
            along.y
        } else {
            along.x
        };
        sign > 0.0
    }
}

impl Wall {
    /// The colour of its left or right side, `t` of the way from its start to its end.
    pub(super) fn color(&self, is_left: bool, t: f64) -> Option<[f32; 4]> {
        let [left, right] = self.sides;
        let colors = if is_left { left } else { right }?;
        let [start, end] = self.parts;
        let weights = quadratic::edge(start + t * (end - start));
        Some([0, 1, 2, 3].map(|c| (0..3).map(|i| weights[i] * colors[i][c]).sum::<f64>() as f32))
    }
}

fn coord(p: Point) -> Coord<f64> {
    Coord { x: p.x, y: p.y }
}

/// What lies beyond this, in px, is at no pixel of a view, and cuts no link of one.
pub(super) fn around(view: &View) -> Rect {
    Rect::new(-RIM_PX, -RIM_PX, f64::from(view.width_px) + RIM_PX, f64::from(view.height_px) + RIM_PX)
}

/// The whole numbers of a half-open range that count a picture's rows or columns.
fn whole_numbers(first: f64, end: f64, count: u32) -> Range<i64> {
    first.max(0.0) as i64..end.min(f64::from(count)) as i64
}

/// The last whole number for which something holds that holds up to `near`, give or take a rounding.
fn last_where(near: f64, holds: impl Fn(i64) -> bool) -> i64 {
    let first = near.floor() as i64 - 1;
    (first + 1..=first + 2).rev().find(|&i| holds(i)).unwrap_or(first)
}
