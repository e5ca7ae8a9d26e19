//! The walk through a tree of `usvg` in painting order, which makes a drawing of it.

use kurbo::{Affine, BezPath};
use scumble_core::work::MAX_CURVES;
use scumble_core::{Curve, Drawing, Fill, Line};
use usvg::{BlendMode, FillRule, Node, PaintOrder, ShapeRendering};

use super::shape::{Filling, Shape};
use crate::clip::{Clip, Outlines, Rest, TooMuch};
use crate::doubles::without_doubles;
use crate::error::ImportError;
use crate::hidden::{Cover, without_hidden};
use crate::notes::ImportNotes;
use crate::page::Page;
use crate::{look, outline, paint};

#[derive(Debug)]
pub(super) struct Importer {
    drawing: Drawing,
    notes: ImportNotes,
    du_from_px: Affine,
    clip: Clip,
    /// Whether no clip path was left out.
    is_clipped: bool,
    /// Whether the paper is dark: here it is white, so light lines are black.
    is_dark: bool,
    /// Groups within each other that are mixed with what is painted before them.
    blends: usize,
    /// In painting order.
    covers: Vec<Cover>,
}

impl Importer {
    pub(super) fn new(page: Page, notes: ImportNotes, is_clipped: bool) -> Self {
        let drawing = Drawing::new(page.rect);
        let du_from_px = drawing.drawing_from_page() * page.page_from_px;
        let clip = Clip::new(drawing.frame());
        Self { drawing, notes, du_from_px, clip, is_clipped, is_dark: false, blends: 0, covers: Vec::new() }
    }

    /// Takes all shapes of a tree. Where masks or filters may be at work that are not known, none of them hides others.
    pub(super) fn walk(&mut self, root: &usvg::Group, is_masked: bool) {
        self.blends += usize::from(is_masked);
        self.group(root, 1.0);
    }

    fn group(&mut self, group: &usvg::Group, opacity: f32) {
        let is_clipped = group.clip_path().is_some_and(|clip_path| self.enter(group, clip_path));
        let blends = usize::from(group.blend_mode() != BlendMode::Normal);
        self.blends += blends;
        self.children(group, opacity);
        self.blends -= blends;
        if is_clipped {
            self.clip.pop();
        }
    }

    /// Whether a clip path hides anything; then it is one of those that shapes are cut by.
    fn enter(&mut self, group: &usvg::Group, clip_path: &usvg::ClipPath) -> bool {
        let du_from_clip = self.du_from_px * affine(group.abs_transform()) * affine(clip_path.transform());
        let mut areas = Vec::new();
        if self.clip_areas(clip_path.root(), du_from_clip, &mut areas).is_err() {
            self.is_clipped = false;
            return false;
        }
        let frame = self.drawing.frame();
        let is_page = matches!(&*areas, [(path, _)] if matches!(&**path, [path] if outline::is_rectangle_over(path, frame)));
        let is_pushed = !is_page && self.clip.push(areas).is_ok();
        self.is_clipped &= is_pushed || is_page;
        is_pushed
    }

    /// The areas of a clip path.
    fn clip_areas(
        &mut self,
        group: &usvg::Group,
        du_from_clip: Affine,
        areas: &mut Vec<Outlines>,
    ) -> Result<(), TooMuch> {
        for child in group.children() {
            match child {
                Node::Group(group) => self.clip_areas(group, du_from_clip, areas)?,
                Node::Path(path) if path.is_visible() => {
                    self.clip.spend(path.data().verbs().len() as u64)?;
                    let subpaths =
                        outline::subpaths(path.data(), du_from_clip * affine(path.abs_transform()));
                    let even_odd = path.fill().is_some_and(|fill| fill.rule() == FillRule::EvenOdd);
                    areas.push((subpaths, even_odd));
                }
                Node::Path(_) | Node::Image(_) | Node::Text(_) => {}
            }
        }
        Ok(())
    }

    fn children(&mut self, group: &usvg::Group, opacity: f32) {
        for child in group.children() {
            match child {
                Node::Group(group) => self.group(group, opacity * group.opacity().get()),
                Node::Path(path) if path.is_visible() => self.path(path, opacity),
                Node::Path(_) | Node::Image(_) | Node::Text(_) => {}
            }
        }
    }

    fn path(&mut self, path: &usvg::Path, opacity: f32) {
        let shape = self.shape(path, opacity);
        let is_seen = shape.fill.is_some() || shape.line.is_some();
        self.notes.patterns += usize::from(is_seen && paint::has_pattern(path));
        let rest = self.rest(&shape);
        if rest.is_none() && self.is_paper(&shape) {
            return;
        }
        if let Some(fill) = shape.fill {
            let area = match &rest {
                Some(rest) => (rest.area.clone(), true),
                None => (shape.subpaths.clone(), fill.even_odd),
            };
            self.fill(fill, area);
        }
        self.draw(shape, rest);
    }

    fn shape(&mut self, path: &usvg::Path, opacity: f32) -> Shape {
        let du_from_path = self.du_from_px * affine(path.abs_transform());
        let subpaths = self.usable(outline::subpaths(path.data(), du_from_path));
        let fill = path.fill().filter(|_| subpaths.iter().any(outline::has_area));
        let fill = fill.and_then(|fill| Filling::of(fill, opacity, &subpaths, self.blends > 0));
        let is_under = path.paint_order() == PaintOrder::StrokeAndFill;
        let is_half_hidden = is_under && fill.is_some_and(|fill| fill.hides[0] && !fill.is_ink);
        let line = self.line(path, opacity, du_from_path);
        let line = line.map(|line| if is_half_hidden { look::halved(line) } else { line });
        Shape { subpaths, line, fill }
    }

    fn line(&self, path: &usvg::Path, opacity: f32, du_from_path: Affine) -> Option<Line> {
        let is_scaled = path.rendering_mode() != ShapeRendering::OptimizeSpeed;
        let du_from_line = if is_scaled { du_from_path } else { self.du_from_px };
        let line = look::line(path.stroke()?, opacity, du_from_line)?;
        Some(if self.is_dark { look::darkened(line) } else { line })
    }

    /// What is filled hides what is painted before it, and may belong to the lines.
    fn fill(&mut self, Filling { color, is_ink, hides, .. }: Filling, area: Outlines) {
        let Drawing { curves, fills, .. } = &mut self.drawing;
        if area.0.is_empty() {
            // Clip paths hide all of it.
            return;
        }
        if hides != [false; 2] {
            self.covers.push(Cover { area: area.clone(), hides, under: [curves.len(), fills.len()] });
        }
        if is_ink {
            fills.push(Fill { path: joined(&area.0), even_odd: area.1, color });
        }
    }

    /// The curves of a shape of which clip paths leave a part or, without that, all.
    fn draw(&mut self, Shape { subpaths, line, fill }: Shape, rest: Option<Rest>) {
        let is_ink = fill.is_some_and(|fill| fill.is_ink);
        let edge = (!is_ink).then(look::thin);
        match (line, rest) {
            (Some(line), rest) => {
                let gaps = if is_ink { outline::gaps(&subpaths) } else { Vec::new() };
                self.lines(subpaths, Some(line));
                self.lines(gaps, None);
                self.curves(rest.map_or_else(Vec::new, |rest| rest.edges), edge);
            }
            (None, Some(rest)) => self.curves(rest.outlines, edge),
            (None, None) if fill.is_some() => {
                self.curves(
                    subpaths.into_iter().filter(outline::has_area).map(outline::closed).collect(),
                    edge,
                );
            }
            (None, None) => {}
        }
    }

    /// Whether an area is no shape: a rectangle over the whole page, if it is ink the first of all. Lines upon dark paper are
    /// light.
    fn is_paper(&mut self, Shape { subpaths, line, fill }: &Shape) -> bool {
        let Some(Filling { color, is_ink, .. }) = fill.filter(|_| line.is_none()) else { return false };
        let is_first = self.drawing.curves.is_empty() && self.drawing.fills.is_empty();
        let frame = self.drawing.frame();
        let is_over_page = matches!(&**subpaths, [path] if outline::is_rectangle_over(path, frame));
        let is_paper = is_over_page && (is_first || !is_ink);
        if is_paper && is_first {
            self.is_dark = paint::is_ink(color);
        }
        is_paper
    }

    /// What clip paths leave of an area, where they hide any of it.
    fn rest(&mut self, Shape { subpaths, fill, .. }: &Shape) -> Option<Rest> {
        let Filling { even_odd, .. } = fill.filter(|_| !self.clip.is_empty())?;
        let rest = self.clip.area((subpaths.clone(), even_odd));
        self.is_clipped &= rest.is_ok();
        rest.ok().flatten()
    }

    /// The subpaths whose coordinates are within reach.
    fn usable(&mut self, mut subpaths: Vec<BezPath>) -> Vec<BezPath> {
        let all = subpaths.len();
        subpaths.retain(outline::is_within_reach);
        self.notes.broken += all - subpaths.len();
        subpaths
    }

    /// Lines, as far as clip paths do not hide them.
    fn lines(&mut self, subpaths: Vec<BezPath>, line: Option<Line>) {
        if self.clip.is_empty() {
            return self.curves(subpaths, line);
        }
        for path in subpaths {
            let seen = self.clip.line(&path);
            self.is_clipped &= seen.is_ok();
            self.curves(seen.unwrap_or_else(|TooMuch| vec![path]), line.clone());
        }
    }

    fn curves(&mut self, subpaths: Vec<BezPath>, line: Option<Line>) {
        self.drawing.curves.extend(subpaths.into_iter().map(|path| Curve { path, line: line.clone() }));
    }

    pub(super) fn finish(self) -> Result<(Drawing, ImportNotes), ImportError> {
        let Self { drawing, mut notes, is_clipped, covers, .. } = self;
        notes.clip_paths *= usize::from(!is_clipped);
        // Of what is not clipped it is not known what it covers.
        let seen = if is_clipped { without_hidden(&drawing, &covers).ok() } else { None };
        let drawing = seen.filter(|seen| !seen.curves.is_empty()).unwrap_or(drawing);
        let mut drawing = without_doubles(&drawing).unwrap_or(drawing);
        // What the drawing has no line for is not drawn over its lines.
        let thin = Some(look::thin());
        drawing.curves.sort_by_key(|curve| curve.line != thin);
        match drawing.curves.len() {
            0 => Err(ImportError::NoCurves(notes)),
            1..=MAX_CURVES => Ok((drawing.kept(), notes)),
            _ => Err(ImportError::TooManyCurves),
        }
    }
}

fn affine(t: usvg::Transform) -> Affine {
    Affine::new([t.sx, t.ky, t.kx, t.sy, t.tx, t.ty].map(f64::from))
}

fn joined(subpaths: &[BezPath]) -> BezPath {
    subpaths.iter().flatten().collect()
}
