//! Made drawings: pages of any richness, the same at every run, to see how times grow.
//!
//! A page is a square grid of cells. By turns a cell holds a wavy outline that stays open, shapes within each other,
//! or a box with hatching that ends short of it. In a finer grid the same things are smaller, as in a richer drawing,
//! and more of them lie under a scribble.

use std::f64::consts::TAU;

use kurbo::{BezPath, Ellipse, Point, Rect, Shape, Stroke, Vec2};
use scumble_core::drawing::LONGER_SIDE_DU;
use scumble_core::{Curve, Drawing, Line, Rgba8, Scribble, ScribbleKind, Srgb8};

/// Number of scribbles on a made drawing, in columns and rows.
const SCRIBBLES: [u32; 2] = [10, 6];

/// Points of a scribble.
const SCRIBBLE_POINTS: u32 = 40;

/// Distance of the points of a scribble along the page, in du.
const STEP_DU: f64 = 1.5;

/// Corners of a wavy outline, and waves around it.
const OUTLINE: [u32; 2] = [48, 5];

/// Hatching lines in a box.
const HATCHES: u32 = 3;

/// A drawing with so many cells in a row and in a column.
pub(crate) fn drawing(cells: u32) -> Drawing {
    let page = Rect::new(0.0, 0.0, LONGER_SIDE_DU, LONGER_SIDE_DU);
    let size_du = LONGER_SIDE_DU / f64::from(cells);
    let line = Line { stroke: Stroke::new((0.03 * size_du).min(4.0)), color: Rgba8([0, 0, 0, 255]) };
    let places = (0..cells).flat_map(|row| (0..cells).map(move |column| (row, column)));
    let paths = places.flat_map(|(row, column)| {
        let center = Point::new(f64::from(column) + 0.5, f64::from(row) + 0.5).to_vec2() * size_du;
        cell((row + column) % 3, center.to_point(), 0.5 * size_du)
    });
    let curves = paths.map(|path| Curve { path, line: Some(line.clone()) }).collect();
    Drawing { curves, ..Drawing::new(page) }
}

/// Scribbles all over a made drawing: wavy strokes in rows.
pub(crate) fn scribbles() -> Vec<Scribble> {
    let [columns, rows] = SCRIBBLES;
    let places = (0..rows).flat_map(|row| (0..columns).map(move |column| (row, column)));
    places.map(|(row, column)| scribble(row, column)).collect()
}

fn scribble(row: u32, column: u32) -> Scribble {
    let [columns, rows] = SCRIBBLES.map(f64::from);
    let start = Point::new(
        (f64::from(column) + 0.2) / columns * LONGER_SIDE_DU,
        (f64::from(row) + 0.45) / rows * LONGER_SIDE_DU,
    );
    let point = |i: u32| start + Vec2::new(f64::from(i) * STEP_DU, 8.0 * (f64::from(i) * 0.4).sin());
    let color = Srgb8([40 + 20 * column as u8, 40 + 30 * row as u8, 128]);
    Scribble {
        color: color.into(),
        kind: ScribbleKind::Fill,
        width_du: 8.0,
        points: (0..SCRIBBLE_POINTS).map(point).collect(),
    }
}

/// The curves of one cell, given its middle and half its size.
fn cell(kind: u32, center: Point, half_du: f64) -> Vec<BezPath> {
    match kind {
        0 => vec![open_outline(center, half_du)],
        1 => nested_shapes(center, half_du),
        _ => hatched_box(center, half_du),
    }
}

/// Nearly all the way around in waves.
fn open_outline(center: Point, half_du: f64) -> BezPath {
    let [corners, waves] = OUTLINE.map(f64::from);
    let corner = |i: u32| {
        let angle = f64::from(i) / corners * TAU;
        center + half_du * (0.6 + 0.1 * (angle * waves).sin()) * Vec2::from_angle(angle)
    };
    let mut path = BezPath::new();
    path.move_to(corner(0));
    (1..OUTLINE[0] - 2).for_each(|i| path.line_to(corner(i)));
    path
}

fn nested_shapes(center: Point, half_du: f64) -> Vec<BezPath> {
    let shape = |part: f64| {
        Ellipse::new(center, (part * half_du, 0.8 * part * half_du), part).to_path(1e-3 * half_du)
    };
    [0.8, 0.4].map(shape).into()
}

fn hatched_box(center: Point, half_du: f64) -> Vec<BezPath> {
    let outline = Rect::from_center_size(center, (1.4 * half_du, 1.2 * half_du)).to_path(1.0);
    let hatch = |i: u32| {
        let x_du = ((f64::from(i) + 0.5) / f64::from(HATCHES) - 0.5) * half_du;
        let lean = Vec2::new(0.1, 0.4) * half_du;
        let middle = center + Vec2::new(x_du, 0.0);
        kurbo::Line::new(middle - lean, middle + lean).to_path(1.0)
    };
    std::iter::once(outline).chain((0..HATCHES).map(hatch)).collect()
}

#[cfg(test)]
mod tests {
    #[test]
    fn a_made_drawing_is_the_same_every_time_and_grows_with_its_cells() {
        assert_eq!(super::drawing(3).curves, super::drawing(3).curves);
        assert!(super::drawing(4).curves.len() > super::drawing(3).curves.len());
    }

    #[test]
    fn scribbles_lie_on_the_page() {
        let page = super::drawing(1).frame();
        let scribbles = super::scribbles();
        assert_eq!(scribbles.len(), 60);
        assert!(scribbles.iter().flat_map(|scribble| &scribble.points).all(|&point| page.contains(point)));
    }
}
