//! An SVG drawing as curves: strokes along their centre line, areas by their outline.
//!
//! `usvg` resolves styles, units, shapes, transforms and references; what it gives is turned into curves in drawing
//! units here. Clip paths, masks, filters and markers are ignored, text and images left out; all are counted.

use kurbo::{Affine, BezPath, Cap, Join, Stroke};
use roxmltree::Document;
use scumble_core::work::MAX_CURVES;
use scumble_core::{Curve, Drawing, Fill, Line, Rgba8};
use usvg::{FillRule, LineCap, LineJoin, Node, Options};

use crate::error::ImportError;
use crate::notes::ImportNotes;
use crate::page::{self, Page};
use crate::survey::{self, Survey};
use crate::{limits, outline, paint};

/// A drawing, and what was left out of its file.
#[derive(Clone, Debug)]
pub struct Import {
    /// The drawing; it has at least one curve.
    pub drawing: Drawing,
    /// What was left out or ignored.
    pub notes: ImportNotes,
}

/// Width of the line drawn around an area that is not ink and has no stroke of its own, in du.
const OUTLINE_WIDTH_DU: f64 = 1.0;

/// Dark areas with a hue are lines up to this mean width, in du, and shapes beyond: navy trousers are to be coloured.
const WIDEST_LINE_DU: f64 = 24.0;

/// Keeps `usvg` from everything that is ignored anyway, from the colours of an exported picture, and from patterns
/// within patterns.
const IGNORED: &str = "* { clip-path: none !important; mask: none !important; filter: none !important;
    marker-start: none !important; marker-mid: none !important; marker-end: none !important }
    text, image, .scumble-colors { display: none !important }
    pattern * { fill: #808080 !important; stroke: none !important }";

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
    let Survey { notes, broken } = survey::of(&xml);
    if broken.is_empty() {
        return import_tree(&xml, notes);
    }
    let sound = survey::without(text, &broken);
    import_tree(&limits::parse_svg(&sound)?, notes)
}

/// Imports a tree of which every shape has usable coordinates.
fn import_tree(xml: &Document, notes: ImportNotes) -> Result<Import, ImportError> {
    limits::check_tree(xml)?;
    let options = Options { style_sheet: Some(IGNORED.to_owned()), ..Options::default() };
    let tree = usvg::Tree::from_xmltree(xml, &options).map_err(import_error)?;
    let size_px = [tree.size().width(), tree.size().height()].map(f64::from);
    let mut importer = Importer::new(page::of(xml, size_px)?, notes);
    importer.group(tree.root(), 1.0);
    importer.finish()
}

fn import_error(error: usvg::Error) -> ImportError {
    match error {
        usvg::Error::InvalidSize => ImportError::NoPage,
        usvg::Error::ElementsLimitReached => ImportError::TooManyElements,
        error => ImportError::NotXml(error.to_string()),
    }
}

struct Importer {
    drawing: Drawing,
    notes: ImportNotes,
    du_from_px: Affine,
}

impl Importer {
    fn new(page: Page, notes: ImportNotes) -> Self {
        let drawing = Drawing::new(page.rect);
        let du_from_px = drawing.drawing_from_page() * page.page_from_px;
        Self { drawing, notes, du_from_px }
    }

    fn group(&mut self, group: &usvg::Group, opacity: f32) {
        for child in group.children() {
            match child {
                Node::Group(group) => self.group(group, opacity * group.opacity().get()),
                Node::Path(path) if path.is_visible() => self.path(path, opacity),
                Node::Path(_) | Node::Image(_) | Node::Text(_) => {}
            }
        }
    }

    fn path(&mut self, path: &usvg::Path, opacity: f32) {
        let du_from_path = self.du_from_px * affine(path.abs_transform());
        let subpaths = self.usable(outline::subpaths(path.data(), du_from_path));
        let stroke = path.stroke().and_then(|stroke| line(stroke, opacity, du_from_path));
        let shown_fill = path.fill().filter(|_| subpaths.iter().any(outline::has_area));
        let fill = shown_fill.and_then(|fill| {
            let color = paint::color(fill.paint(), opacity * fill.opacity().get())?;
            Some((color, fill.rule() == FillRule::EvenOdd))
        });
        let is_shape = |color, even_odd| {
            paint::has_hue(color) && outline::mean_width_du(&subpaths, even_odd) > WIDEST_LINE_DU
        };
        let ink = fill.filter(|&(color, even_odd)| paint::is_ink(color) && !is_shape(color, even_odd));
        if let Some((color, even_odd)) = ink {
            self.drawing.fills.push(Fill { path: joined(&subpaths), even_odd, color });
        }
        match (stroke, fill) {
            (Some(line), _) => {
                let gaps = if ink.is_some() { outline::gaps(&subpaths) } else { Vec::new() };
                self.curves(subpaths, Some(line));
                self.curves(gaps, None);
            }
            (None, Some(_)) => self.outlines(subpaths, ink.is_some()),
            (None, None) => {}
        }
    }

    /// The subpaths whose coordinates are within reach.
    fn usable(&mut self, mut subpaths: Vec<BezPath>) -> Vec<BezPath> {
        let all = subpaths.len();
        subpaths.retain(outline::is_within_reach);
        self.notes.broken += all - subpaths.len();
        subpaths
    }

    fn curves(&mut self, subpaths: Vec<BezPath>, line: Option<Line>) {
        self.drawing.curves.extend(subpaths.into_iter().map(|path| Curve { path, line: line.clone() }));
    }

    /// The outlines of an area without a stroke. A rectangle over the whole page that is no ink is paper, not a shape.
    fn outlines(&mut self, subpaths: Vec<BezPath>, is_ink: bool) {
        let frame = self.drawing.frame();
        if !is_ink && matches!(&*subpaths, [path] if outline::is_rectangle_over(path, frame)) {
            return;
        }
        let outlines = subpaths.into_iter().filter(outline::has_area).map(outline::closed).collect();
        let thin = Line { stroke: Stroke::new(OUTLINE_WIDTH_DU), color: Rgba8([0, 0, 0, 255]) };
        self.curves(outlines, (!is_ink).then_some(thin));
    }

    fn finish(self) -> Result<Import, ImportError> {
        let Self { drawing, notes, .. } = self;
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

/// The drawn line of a stroke. Under a transform that is no similarity its width is scaled as areas are, by the
/// square root of the determinant.
fn line(stroke: &usvg::Stroke, opacity: f32, du_from_path: Affine) -> Option<Line> {
    let color = paint::color(stroke.paint(), opacity * stroke.opacity().get())?;
    let scale = du_from_path.determinant().abs().sqrt();
    let width_du = f64::from(stroke.width().get()) * scale;
    if !width_du.is_finite() || width_du <= 0.0 {
        return None;
    }
    let dashes = stroke.dasharray().unwrap_or_default().iter().map(|dash| f64::from(*dash) * scale);
    let stroke = Stroke::new(width_du)
        .with_join(join(stroke.linejoin()))
        .with_miter_limit(f64::from(stroke.miterlimit().get()))
        .with_caps(cap(stroke.linecap()))
        .with_dashes(f64::from(stroke.dashoffset()) * scale, dashes);
    Some(Line { stroke, color })
}

fn join(join: LineJoin) -> Join {
    match join {
        LineJoin::Miter | LineJoin::MiterClip => Join::Miter,
        LineJoin::Round => Join::Round,
        LineJoin::Bevel => Join::Bevel,
    }
}

fn cap(cap: LineCap) -> Cap {
    match cap {
        LineCap::Butt => Cap::Butt,
        LineCap::Round => Cap::Round,
        LineCap::Square => Cap::Square,
    }
}
