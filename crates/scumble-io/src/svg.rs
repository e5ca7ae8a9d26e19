//! An SVG drawing as curves: strokes along their centre line, areas by their outline.
//!
//! `usvg` resolves styles, units, shapes, transforms and references; what it gives is turned into curves in drawing
//! units here. Masks, filters and markers are ignored, text and images left out; all are counted.

use kurbo::{Affine, BezPath};
use roxmltree::Document;
use scumble_core::work::MAX_CURVES;
use scumble_core::{Curve, Drawing, Fill, Line, Rgba8};
use usvg::{BlendMode, FillRule, Node, Options, ShapeRendering};

use crate::clip::{Clip, Outlines, Rest, TooMuch};
use crate::css::{self, Mends};
use crate::doubles::without_doubles;
use crate::error::ImportError;
use crate::hidden::{Cover, without_hidden};
use crate::notes::ImportNotes;
use crate::page::{self, Page};
use crate::survey::{self, Survey};
use crate::{limits, look, outline, paint, style_sheet};

/// A drawing, and what was left out of its file.
#[derive(Clone, Debug)]
pub struct Import {
    /// The drawing; it has at least one curve.
    pub drawing: Drawing,
    /// What was left out or ignored.
    pub notes: ImportNotes,
}

/// Dark areas with a hue are lines up to this mean width, in du, and shapes beyond: navy trousers are to be coloured.
const WIDEST_LINE_DU: f64 = 24.0;

/// Areas of other colours that are as thin are lines where they are so many times as long as wide: a pencil's strokes that were
/// made outlines.
const LEAST_LENGTHS: f64 = 40.0;

/// Keeps `usvg` from everything that is ignored anyway, from the colours of an exported picture, and from patterns
/// within patterns. What is masked or filtered is taken for what others can be seen through.
const IGNORED: &str = "* { mask: none !important; filter: none !important;
    marker-start: none !important; marker-mid: none !important; marker-end: none !important }
    text, image, .scumble-colors { display: none !important }
    pattern * { fill: #808080 !important; stroke: none !important }
    [mask], [filter] { mix-blend-mode: multiply !important }
    clipPath, clipPath * { clip-path: none !important }";

/// Keeps it from clip paths.
const UNCLIPPED: &str = "* { clip-path: none !important }";

/// Reads an SVG drawing.
///
/// The page is the `viewBox` of the outermost element in its own units, or its width and height in pixels, or
/// what its shapes span. Answers within about a second, whatever the bytes.
///
/// # Errors
/// When the bytes are no SVG drawing, or one without anything to colour, or beyond the limits.
pub fn import_svg(bytes: &[u8]) -> Result<Import, ImportError> {
    let text = limits::readable_text(bytes)?;
    let xml = limits::parse_svg(text)?;
    let Survey { mut notes, broken } = survey::of(&xml);
    let Mends { mut edits, unreadable } = css::of(&xml);
    notes.bad_colors = unreadable;
    edits.extend(broken.into_iter().map(|shape| (shape, String::new())));
    if edits.is_empty() {
        return import_tree(&xml, notes);
    }
    let sound = css::edited(text, edits);
    import_tree(&limits::parse_svg(&sound)?, notes)
}

/// Imports a tree of which every shape has usable coordinates.
fn import_tree(xml: &Document, notes: ImportNotes) -> Result<Import, ImportError> {
    let is_clipped = limits::check_tree(xml)?;
    let unscaled = ["[vector-effect=non-scaling-stroke] {", css::UNSCALED, "}"].concat();
    let style_sheet = [IGNORED, if is_clipped { "" } else { UNCLIPPED }, &unscaled].concat();
    let options = Options { style_sheet: Some(style_sheet), ..Options::default() };
    let tree = usvg::Tree::from_xmltree(xml, &options).map_err(import_error)?;
    let size_px = [tree.size().width(), tree.size().height()].map(f64::from);
    let mut importer = Importer::new(page::of(xml, size_px)?, notes, is_clipped);
    importer.blends += usize::from(has_masking_style(xml));
    importer.group(tree.root(), 1.0);
    importer.finish()
}

/// Whether anything may be masked or filtered by its style.
fn has_masking_style(xml: &Document) -> bool {
    let styles = xml.descendants().filter_map(|node| node.attribute("style"));
    styles.chain(style_sheet::texts(xml)).any(|css| css.contains("mask:") || css.contains("filter:"))
}

fn import_error(error: usvg::Error) -> ImportError {
    match error {
        usvg::Error::InvalidSize => ImportError::NoPage,
        usvg::Error::ElementsLimitReached => ImportError::TooManyElements,
        error => ImportError::NotXml(error.to_string()),
    }
}

/// A shape before it is cut.
struct Shape {
    subpaths: Vec<BezPath>,
    line: Option<Line>,
    fill: Option<Filling>,
}

#[derive(Clone, Copy)]
struct Filling {
    color: Rgba8,
    even_odd: bool,
    /// Whether it belongs to the lines.
    is_ink: bool,
    /// Whether it hides lines that are painted before it, and ink.
    hides: [bool; 2],
}

struct Importer {
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
    fn new(page: Page, notes: ImportNotes, is_clipped: bool) -> Self {
        let drawing = Drawing::new(page.rect);
        let du_from_px = drawing.drawing_from_page() * page.page_from_px;
        let clip = Clip::new(drawing.frame());
        Self { drawing, notes, du_from_px, clip, is_clipped, is_dark: false, blends: 0, covers: Vec::new() }
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
        let is_scaled = path.rendering_mode() != ShapeRendering::OptimizeSpeed;
        let du_from_line = if is_scaled { du_from_path } else { self.du_from_px };
        let line = path.stroke().and_then(|stroke| look::line(stroke, opacity, du_from_line));
        let line = line.map(|line| if self.is_dark { look::darkened(line) } else { line });
        let fill = path.fill().filter(|_| subpaths.iter().any(outline::has_area));
        let fill = fill.and_then(|fill| self.filling(fill, opacity, &subpaths));
        Shape { subpaths, line, fill }
    }

    fn filling(&self, fill: &usvg::Fill, opacity: f32, subpaths: &[BezPath]) -> Option<Filling> {
        let opacity = opacity * fill.opacity().get();
        let color = paint::color(fill.paint(), opacity)?;
        let even_odd = fill.rule() == FillRule::EvenOdd;
        let [wide_du, long_du] = outline::mean_size_du(subpaths, even_odd);
        let is_thin = wide_du <= WIDEST_LINE_DU;
        let is_line = is_thin && long_du >= LEAST_LENGTHS * wide_du && !paint::is_pale(color);
        let is_ink = is_line || paint::is_ink(color) && (is_thin || !paint::has_hue(color));
        let is_opaque = paint::is_opaque(fill.paint(), opacity);
        // A light in an eye may be glassy.
        let hides_ink = !is_ink && (is_opaque || paint::is_light(color));
        let hides = [is_opaque, hides_ink].map(|hides| hides && self.blends == 0);
        Some(Filling { color, even_odd, is_ink, hides })
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

    fn finish(self) -> Result<Import, ImportError> {
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
            1..=MAX_CURVES => Ok(Import { drawing: drawing.kept(), notes }),
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
