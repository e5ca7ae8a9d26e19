//! A page on pixels. A large one is solved part by part: a small picture of the whole says what is beyond the borders of
//! each.

use std::ops::Range;

use kurbo::Affine;
use scumble_core::{Bends, Blend, Boundary, Drawing, Srgb8};
use scumble_solve::grid::{AROUND_PX, Constraints, GridPicture, Shades, Whole};
use scumble_solve::{Part, Picture, Pixmap, Shape, View, paint_grid};

/// Longest side of what is solved at once, in px: that takes up to 1.5 GB.
pub(crate) const MOST_PX: u32 = 2048;

/// All of a page, and how it is to look.
#[derive(Clone, Copy, Debug)]
pub(super) struct Page<'a> {
    pub(super) drawing: &'a Drawing,
    pub(super) picture: &'a Picture,
    pub(super) boundary: &'a Boundary,
    pub(super) blend: Blend,
    pub(super) view: View,
    pub(super) shapes: &'a [Shape],
    pub(super) paper: Option<Srgb8>,
    /// Longest side of what is solved at once, in px: [`MOST_PX`], but in tests.
    pub(super) most_px: u32,
}

impl Page<'_> {
    /// Paints it with what a solver finds.
    ///
    /// # Errors
    /// When the solver fails, or a shade cannot be solved.
    pub(super) fn paint(
        &self,
        mut solve: impl FnMut(&Constraints) -> anyhow::Result<Vec<[f32; 4]>>,
    ) -> anyhow::Result<Pixmap> {
        let (map, Self { boundary, view, .. }) = (self.picture.map(), self);
        let scale = f64::from(view.width_px.max(view.height_px)) / f64::from(self.most_px);
        if scale <= 1.0 {
            let bends = Bends::default();
            let constraints = Constraints::new(map, boundary, view)?.fitted(map, &bends, boundary, view);
            return Ok(self.painted(view, &bends, solve(&constraints)?));
        }
        let shades = Shades::new(map, boundary)?;
        let page_du = self.drawing.frame();
        let bends = self.picture.bends(self.drawing, page_du, view.px_from_du.as_coeffs()[0]);
        let whole = self.whole(scale, &bends, &mut solve)?;
        let mut all = blank(view);
        for Tile { inner, part } in tiles(view, self.most_px, (AROUND_PX * scale).ceil() as u32) {
            let of = view.part(&part);
            let constraints = Constraints::within(&whole, map, &bends, boundary, &shades, &of);
            let pixels = solve(&constraints.fitted(map, &bends, boundary, &of))?;
            copy(&self.painted(&of, &bends, pixels), &part, &inner, &mut all);
        }
        Ok(all)
    }

    /// All of it, so many times smaller, and without shades, which are laid over its parts.
    fn whole(
        &self,
        scale: f64,
        bends: &Bends,
        solve: &mut impl FnMut(&Constraints) -> anyhow::Result<Vec<[f32; 4]>>,
    ) -> anyhow::Result<Whole> {
        let map = self.picture.map();
        let boundary = &Boundary { sources: Vec::new(), ..self.boundary.clone() };
        let [width_px, height_px] = [self.view.width_px, self.view.height_px]
            .map(|side| (f64::from(side) / scale).round().max(1.0) as u32);
        let view =
            View { px_from_du: Affine::scale(1.0 / scale) * self.view.px_from_du, width_px, height_px };
        let constraints =
            Constraints::new(map, boundary, &view)?.fitted(map, &Bends::default(), boundary, &view);
        Ok(Whole::new(map, bends, boundary, &view, solve(&constraints)?))
    }

    fn painted(&self, view: &View, bends: &Bends, pixels: Vec<[f32; 4]>) -> Pixmap {
        let picture = GridPicture::new(self.picture.map(), bends, self.boundary, view, self.blend, pixels);
        paint_grid(&picture, self.shapes, view, self.paper)
    }
}

/// A part of a page, with what is solved around it.
struct Tile {
    inner: Part,
    part: Part,
}

/// Parts that cover a view, each with so many px around it where there are some, and then up to a size in px.
fn tiles(view: &View, size_px: u32, around_px: u32) -> Vec<Tile> {
    let ranges = |count: u32| -> Vec<[Range<u32>; 2]> {
        let step_px = size_px - 2 * around_px;
        let inner = (0..count).step_by(step_px as usize).map(|first| first..(first + step_px).min(count));
        let around = |range: Range<u32>| {
            let part = range.start.saturating_sub(around_px)..(range.end + around_px).min(count);
            [range, part]
        };
        inner.map(around).collect()
    };
    let rows = ranges(view.height_px);
    let columns = ranges(view.width_px);
    let tile = |[rows, rows_of_part]: &[Range<u32>; 2], [columns, columns_of_part]: &[Range<u32>; 2]| Tile {
        inner: Part { columns: columns.clone(), rows: rows.clone() },
        part: Part { columns: columns_of_part.clone(), rows: rows_of_part.clone() },
    };
    rows.iter().flat_map(|rows| columns.iter().map(move |columns| tile(rows, columns))).collect()
}

/// A transparent picture.
fn blank(view: &View) -> Pixmap {
    let (width_px, height_px) = (view.width_px, view.height_px);
    Pixmap { width_px, height_px, rgba: vec![0; 4 * width_px as usize * height_px as usize] }
}

/// Copies what is within a part of a picture to where it belongs.
fn copy(from: &Pixmap, part: &Part, inner: &Part, to: &mut Pixmap) {
    for row in inner.rows.clone() {
        let bytes = |pixmap: &Pixmap, first: u32, row: u32| {
            let start = 4 * (row as usize * pixmap.width_px as usize + first as usize);
            start..start + 4 * inner.columns.len()
        };
        let source = bytes(from, inner.columns.start - part.columns.start, row - part.rows.start);
        let target = bytes(to, inner.columns.start, row);
        to.rgba[target].copy_from_slice(&from.rgba[source]);
    }
}

#[cfg(test)]
mod tests {
    use kurbo::{Circle, Point, Rect, Shape as _};
    use scumble_core::source::weight;
    use scumble_core::{Curve, PlanarMap, Settings, SoftSource};
    use scumble_solve::Picture;
    use scumble_solve::grid::{GridSolver, TOLERANCE};

    use super::*;
    use crate::compare::uncolor_half;
    use crate::{made, stages};

    const SIZE_PX: u32 = 960;

    fn solved(constraints: &Constraints) -> anyhow::Result<Vec<[f32; 4]>> {
        let mut solver = GridSolver::new(constraints);
        solver.solve(TOLERANCE);
        Ok(solver.pixels())
    }

    /// A made drawing with its colours, changed, whole and of parts.
    fn painted(change: impl Fn(&PlanarMap, &mut Boundary)) -> [Pixmap; 2] {
        let drawing = made::drawing(3);
        let mut picture = Picture::new(&drawing).expect("a map");
        let Settings { blend, .. } = Settings::default();
        let mut boundary = picture.color(&made::scribbles(), &[], &Settings::default()).clone();
        change(picture.map(), &mut boundary);
        let view = stages::page_view(&drawing, SIZE_PX);
        let (drawing, picture, boundary) = (&drawing, &picture, &boundary);
        let page =
            Page { drawing, picture, boundary, blend, view, shapes: &[], paper: None, most_px: SIZE_PX };
        [SIZE_PX, SIZE_PX / 2].map(|most_px| Page { most_px, ..page }.paint(solved).expect("a picture"))
    }

    /// By how many levels bytes differ: at most, and in the mean.
    fn differences([whole, parts]: &[Pixmap; 2]) -> (u8, f64) {
        let all = || whole.rgba.iter().zip(&parts.rgba).map(|(a, b)| a.abs_diff(*b));
        (all().max().unwrap_or(0), all().map(f64::from).sum::<f64>() / whole.rgba.len() as f64)
    }

    #[test]
    fn parts_are_what_the_whole_is() {
        let pictures = painted(|_, _| {});
        assert!(pictures[0].rgba.iter().any(|byte| *byte != pictures[0].rgba[0]));
        let (most, mean) = differences(&pictures);
        assert!(most <= 2 && mean < 0.02, "{most} {mean}");
    }

    #[test]
    fn colours_pass_from_part_to_part_where_curves_have_none() {
        let pictures = painted(uncolor_half);
        let (most, mean) = differences(&pictures);
        assert!(most <= 3 && mean < 0.05, "{most} {mean}");
    }

    /// Paints a quarter of a circle in parts, at a scale at which the pieces of its curve are chords of some pixels off it, and
    /// checks how opaque it is within and beyond.
    fn check_quarter(boundary_of: impl Fn(&PlanarMap, Point) -> Boundary, least_alpha: u8) {
        let (middle, radius_du, px_per_du) = (Point::new(512.0, 512.0), 20.0, 32.0);
        let circle = Curve { path: Circle::new(middle, radius_du).to_path(1e-4), line: None };
        let page_du = Rect::new(0.0, 0.0, 1024.0, 1024.0);
        let drawing = &Drawing { curves: vec![circle], ..Drawing::new(page_du) };
        let picture = &Picture::new(drawing).expect("a map");
        let boundary = &boundary_of(picture.map(), middle);
        let px_from_du = Affine::scale(px_per_du) * Affine::translate(-middle.to_vec2());
        let view = View { px_from_du, width_px: 704, height_px: 704 };
        let blend = Blend::Srgb;
        let page = Page { drawing, picture, boundary, blend, view, shapes: &[], paper: None, most_px: 352 };
        let painted = page.paint(solved).expect("a picture");
        let alpha = |radius_px: f64, turn: f64| {
            let [x, y] = [turn.cos(), turn.sin()].map(|part| (radius_px * part) as usize);
            painted.rgba[4 * (704 * y + x) + 3]
        };
        for i in 1..100 {
            let turn = std::f64::consts::FRAC_PI_2 * f64::from(i) / 100.0;
            let [within, beyond] = [-2.0, 2.0].map(|off_px| alpha(radius_du * px_per_du + off_px, turn));
            assert!(within >= least_alpha && beyond == 0, "{i}: {within} {beyond}");
        }
    }

    #[test]
    fn parts_from_close_by_are_cut_at_curves_as_they_bend() {
        let red_within = |map: &PlanarMap, _| {
            let mut sides = vec![None; map.side_count()];
            map.steps(0).iter().for_each(|step| sides[step.left.index()] = Some([[1.0, 0.0, 0.0, 1.0]; 3]));
            sides.into()
        };
        check_quarter(red_within, 255);
    }

    #[test]
    fn from_close_by_shades_end_at_curves_as_they_bend() {
        let shade = |middle| SoftSource {
            points: vec![middle],
            radius_du: 20.0,
            weight: weight(1.0),
            color: [0.0, 0.0, 0.0, 1.0],
            crosses: false,
            parts: Vec::new(),
        };
        let of = |map: &PlanarMap, middle| Boundary {
            sources: vec![shade(middle)],
            ..vec![None; map.side_count()].into()
        };
        check_quarter(of, 100);
    }
}
