//! The walk through a tree of `usvg` in painting order, which makes a drawing of it.

use kurbo::{Affine, BezPath, Rect, Shape as _};
use scumble_core::work::MAX_CURVES;
use scumble_core::{Curve, Drawing, Fill, Line, Rgba8};
use usvg::{BlendMode, FillRule, Node, PaintOrder, ShapeRendering};

use super::mask;
use super::shape::{Filling, Placed, Shape, affine};
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
    /// How many masks cut as clip paths do.
    masks: usize,
    /// The colour of the paper: here it is white, so what shows on the other one only is black.
    paper: Rgba8,
    /// In painting order.
    covers: Vec<Cover>,
}

/// Where something is, and what all groups around it leave of its opacity. The transforms of groups tell that: what `usvg` says
/// of the whole way, it says wrongly within symbols.
#[derive(Clone, Copy, Debug)]
struct Place {
    du_from_user: Affine,
    opacity: f32,
    /// The first curve and fill of the innermost groups that are painted as a whole over what is before them: of that, nothing
    /// hides lines where they are translucent, nor ink where they are mixed with it.
    since: [usize; 2],
}

impl Place {
    /// That of what is in a group.
    fn within(self, group: &usvg::Group) -> Self {
        let du_from_user = self.du_from_user * affine(group.transform());
        Self { du_from_user, opacity: self.opacity * group.opacity().get(), ..self }
    }
}

impl Importer {
    pub(super) fn new(page: Page, notes: ImportNotes, is_clipped: bool) -> Self {
        let drawing = Drawing::new(page.rect);
        let du_from_px = drawing.drawing_from_page() * page.page_from_px;
        let clip = Clip::new(drawing.frame());
        let (covers, paper) = (Vec::new(), paint::WHITE);
        Self { drawing, notes, du_from_px, clip, is_clipped, masks: 0, paper, covers }
    }

    /// Takes all shapes of a tree.
    pub(super) fn walk(&mut self, root: &usvg::Group) {
        self.group(root, Place { du_from_user: self.du_from_px, opacity: 1.0, since: [0; 2] });
    }

    fn group(&mut self, group: &usvg::Group, around: Place) {
        let mut place = around.within(group);
        let outer = self.clip.depth();
        self.clip_by_path(group, place);
        let is_followed = self.clip_by_mask(group, place);
        let [curves, fills] = self.counts();
        if group.blend_mode() != BlendMode::Normal || !is_followed {
            place.since = [curves, fills];
        } else if group.opacity().get() < 1.0 {
            place.since[0] = curves;
        }
        self.children(group, place);
        self.clip.leave(outer);
    }

    /// Has shapes cut by the clip path of a group.
    fn clip_by_path(&mut self, group: &usvg::Group, place: Place) {
        let Some(clip_path) = group.clip_path() else { return };
        let mut shapes = Vec::new();
        add_shapes(clip_path.root(), affine(clip_path.transform()), &mut shapes);
        self.is_clipped &= self.clip_by(&shapes, place.du_from_user).is_ok();
    }

    /// Has shapes cut by the mask of a group, and tells whether that is all that it does.
    fn clip_by_mask(&mut self, group: &usvg::Group, place: Place) -> bool {
        let Some(mask) = group.mask() else { return true };
        let outer = self.clip.depth();
        let region = mask.rect().to_rect();
        let is_followed = mask::shapes(mask)
            .is_some_and(|shapes| self.clip_by_shapes(&shapes, region, place.du_from_user).is_ok());
        if is_followed {
            self.masks += 1;
        } else {
            self.notes.masks += 1;
            self.clip.leave(outer);
        }
        is_followed
    }

    fn clip_by_shapes(
        &mut self,
        shapes: &mask::Shapes,
        region: usvg::Rect,
        du_from_mask: Affine,
    ) -> Result<(), TooMuch> {
        let [left, top, right, bottom] =
            [region.left(), region.top(), region.right(), region.bottom()].map(f64::from);
        let region = du_from_mask * Rect::new(left, top, right, bottom).to_path(0.0);
        self.push(vec![(vec![region], false)])?;
        self.clip_by(&shapes.shown, du_from_mask)?;
        if shapes.hidden.is_empty() {
            return Ok(());
        }
        let hidden = self.areas(&shapes.hidden, du_from_mask)?;
        self.clip.push(hidden, true)
    }

    /// Has shapes cut by those of a clip path or a mask.
    fn clip_by(&mut self, shapes: &[Placed<'_>], du_from_clip: Affine) -> Result<(), TooMuch> {
        let areas = self.areas(shapes, du_from_clip)?;
        self.push(areas)
    }

    /// Has shapes cut by some areas, unless these are the page.
    fn push(&mut self, areas: Vec<Outlines>) -> Result<(), TooMuch> {
        let frame = self.drawing.frame();
        let is_page = matches!(&*areas, [(path, _)] if matches!(&**path, [path] if outline::is_rectangle_over(path, frame)));
        if is_page { Ok(()) } else { self.clip.push(areas, false) }
    }

    fn areas(&mut self, shapes: &[Placed<'_>], du_from_clip: Affine) -> Result<Vec<Outlines>, TooMuch> {
        let area = |(path, clip_from_user): &Placed<'_>| {
            self.clip.spend(path.data().verbs().len() as u64)?;
            let subpaths = outline::subpaths(path.data(), du_from_clip * *clip_from_user);
            Ok((subpaths, path.fill().is_some_and(|fill| fill.rule() == FillRule::EvenOdd)))
        };
        shapes.iter().map(area).collect()
    }

    fn children(&mut self, group: &usvg::Group, place: Place) {
        for child in group.children() {
            match child {
                Node::Group(group) => self.group(group, place),
                Node::Path(path) if path.is_visible() => self.path(path, place),
                Node::Path(_) | Node::Image(_) | Node::Text(_) => {}
            }
        }
    }

    fn path(&mut self, path: &usvg::Path, place: Place) {
        let shape = self.shape(path, place);
        let is_seen = shape.fill.is_some() || shape.line.is_some();
        self.notes.patterns += usize::from(is_seen && paint::has_pattern(path));
        let rest = self.rest(&shape);
        let is_paper = rest.is_none() && self.is_paper(&shape, place);
        if let Some(fill) = shape.fill {
            let area = match &rest {
                Some(rest) => (rest.area.clone(), true),
                None => (shape.subpaths.clone(), fill.even_odd),
            };
            self.fill(Filling { is_ink: fill.is_ink && !is_paper, ..fill }, area, place.since);
        }
        if is_paper {
            return;
        }
        self.draw(shape, rest);
    }

    fn shape(&mut self, path: &usvg::Path, Place { du_from_user, opacity, .. }: Place) -> Shape {
        let subpaths = self.usable(outline::subpaths(path.data(), du_from_user));
        let fill = path.fill().filter(|_| subpaths.iter().any(outline::has_area));
        let fill = fill.and_then(|fill| Filling::of(fill, opacity, &subpaths));
        let is_under = path.paint_order() == PaintOrder::StrokeAndFill;
        let is_half_hidden = is_under && fill.is_some_and(|fill| fill.hides[0] && !fill.is_ink);
        let line = self.line(path, opacity, du_from_user);
        let line = line.map(|line| if is_half_hidden { look::halved(line) } else { line });
        Shape { subpaths, line, fill }
    }

    fn line(&self, path: &usvg::Path, opacity: f32, du_from_user: Affine) -> Option<Line> {
        let is_scaled = path.rendering_mode() != ShapeRendering::OptimizeSpeed;
        let du_from_line = if is_scaled { du_from_user } else { self.du_from_px };
        Some(look::upon_white(look::line(path.stroke()?, opacity, du_from_line)?, self.paper))
    }

    /// What is filled hides what is painted before it, and may belong to the lines.
    fn fill(&mut self, Filling { color, is_ink, hides, .. }: Filling, area: Outlines, since: [usize; 2]) {
        if area.0.is_empty() {
            // Clip paths hide all of it.
            return;
        }
        if hides != [false; 2] {
            self.covers.push(Cover { area: area.clone(), hides, since, under: self.counts() });
        }
        if is_ink {
            self.drawing.fills.push(Fill { path: joined(&area.0), even_odd: area.1, color });
        }
    }

    /// How many curves and fills there are so far.
    fn counts(&self) -> [usize; 2] {
        [self.drawing.curves.len(), self.drawing.fills.len()]
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

    /// Whether an area is no shape: a rectangle over the whole page, if it is ink the first of all.
    fn is_paper(&mut self, Shape { subpaths, line, fill }: &Shape, place: Place) -> bool {
        let Some(Filling { color, is_ink, hides, .. }) = fill.filter(|_| line.is_none()) else {
            return false;
        };
        let is_first = self.drawing.curves.is_empty() && self.drawing.fills.is_empty();
        let frame = self.drawing.frame();
        let is_over_page = matches!(&**subpaths, [path] if outline::is_rectangle_over(path, frame));
        let is_paper = is_over_page && (is_first || !is_ink);
        let hides_all = hides[0] && place.since == [0; 2] && place.opacity == 1.0;
        if is_paper && (is_first || hides_all) {
            self.paper = paint::over_white(color);
        }
        is_paper
    }

    /// What clip paths leave of an area, where they hide any of it.
    fn rest(&mut self, Shape { subpaths, fill, .. }: &Shape) -> Option<Rest> {
        let Filling { even_odd, .. } = fill.filter(|_| !self.clip.is_empty())?;
        let rest = self.clip.area((subpaths.clone(), even_odd));
        rest.unwrap_or_else(|TooMuch| {
            self.give_up();
            None
        })
    }

    /// What it takes too long to cut stays whole.
    fn give_up(&mut self) {
        self.is_clipped = false;
        self.notes.masks += std::mem::take(&mut self.masks);
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
            let line =
                if self.clip.is_outline(&path) { line.clone().map(look::halved) } else { line.clone() };
            let seen = self.clip.line(&path).unwrap_or_else(|TooMuch| {
                self.give_up();
                vec![path]
            });
            self.curves(seen, line);
        }
    }

    fn curves(&mut self, subpaths: Vec<BezPath>, line: Option<Line>) {
        self.drawing.curves.extend(subpaths.into_iter().map(|path| Curve { path, line: line.clone() }));
    }

    pub(super) fn finish(self) -> Result<(Drawing, ImportNotes), ImportError> {
        let Self { drawing, mut notes, is_clipped, covers, .. } = self;
        notes.clip_paths *= usize::from(!is_clipped);
        // Of what is not clipped it is not known what it covers.
        let covers = if is_clipped { covers } else { Vec::new() };
        let (seen, whole) = without_hidden(&drawing, &covers);
        notes.covers = whole;
        let drawing = if seen.curves.is_empty() { drawing } else { seen };
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

/// Adds the shapes of a clip path.
fn add_shapes<'a>(group: &'a usvg::Group, clip_from_user: Affine, shapes: &mut Vec<Placed<'a>>) {
    for child in group.children() {
        match child {
            Node::Group(group) => add_shapes(group, clip_from_user * affine(group.transform()), shapes),
            Node::Path(path) if path.is_visible() => shapes.push((path, clip_from_user)),
            Node::Path(_) | Node::Image(_) | Node::Text(_) => {}
        }
    }
}

fn joined(subpaths: &[BezPath]) -> BezPath {
    subpaths.iter().flatten().collect()
}
