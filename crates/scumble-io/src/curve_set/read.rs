//! Diffusion curves in: curves without lines, and colours set by hand on their sides.

use kurbo::{BezPath, Point, Rect};
use roxmltree::Node;
use scumble_core::measured_path::MeasuredPath;
use scumble_core::work::{MAX_CURVES, is_page};
use scumble_core::{Blend, ColorPoint, Curve, Document, Drawing, Settings, Srgb8};

use super::{BARRIER, IDS_PER_CUBIC, OKLAB, ROOT};
use crate::error::ImportError;
use crate::notes::CurveNotes;
use crate::page::kept;
use crate::{limits, outline};

/// Whether a file is meant as diffusion curves: it names them before it names an SVG.
pub(crate) fn is_curve_set(bytes: &[u8]) -> bool {
    let opening = |name: &str| {
        let tag = ["<", name].concat();
        bytes.windows(tag.len()).position(|window| window == tag.as_bytes())
    };
    opening(ROOT).is_some_and(|at| opening("svg").is_none_or(|svg| at < svg))
}

/// Reads diffusion curves. What cannot be used of them is left out and counted.
///
/// # Errors
/// When the bytes are none, or beyond the limits of drawings.
pub(crate) fn import(bytes: &[u8]) -> Result<(Document, CurveNotes), ImportError> {
    let xml = parsed(limits::readable_text(bytes)?)?;
    let root = xml.root_element();
    if root.tag_name().name() != ROOT {
        return Err(ImportError::NotSvg(limits::shortened(root.tag_name().name())));
    }
    if elements(root, "curve").count() > MAX_CURVES {
        return Err(ImportError::TooManyCurves);
    }
    let mut reader = Reader { document: document(root)?, notes: CurveNotes::default() };
    elements(root, "curve").for_each(|curve| reader.curve(curve));
    let Reader { document, notes } = reader;
    if document.drawing.curves.is_empty() {
        Err(ImportError::NoDiffusionCurves)
    } else {
        Ok((document.kept(), notes))
    }
}

fn parsed(text: &str) -> Result<roxmltree::Document<'_>, ImportError> {
    limits::parse_xml(text).map_err(|error| match error {
        ImportError::NotXml(fault) => ImportError::CurvesNotXml(fault),
        other => other,
    })
}

/// A document with the page, whose colours go wherever no curve is.
fn document(root: Node) -> Result<Document, ImportError> {
    let side = |name| number(root, name).unwrap_or_default();
    let [width, height] = [side("image_width"), side("image_height")];
    if !is_page([0.0, 0.0, width, height]) {
        return Err(ImportError::NoImageSize);
    }
    let blend = if root.attribute("blend") == Some(OKLAB) { Blend::Oklab } else { Blend::Srgb };
    let settings = Settings { blend, gap_closing: 0.0, ..Settings::default() };
    Ok(Document { settings, ..Document::new(Drawing::new(kept(Rect::new(0.0, 0.0, width, height)))) })
}

struct Reader {
    document: Document,
    notes: CurveNotes,
}

impl Reader {
    fn curve(&mut self, curve: Node) {
        let Some(path) = self.path(curve) else {
            self.notes.broken += 1;
            return;
        };
        let measured = MeasuredPath::new(&path);
        let index = self.document.drawing.curves.len() as u32;
        for (set, is_left) in [("left_colors_set", true), ("right_colors_set", false)] {
            let sets = elements(curve, set).filter(|set| set.attribute("boundary") != Some(BARRIER));
            for color in sets.flat_map(|set| set.children().filter(Node::is_element)) {
                match place_and_color(color) {
                    Some((place, color)) => self.document.color_points.push(ColorPoint {
                        curve: index,
                        is_left,
                        at_du: measured.at_du(place),
                        color: color.into(),
                    }),
                    None => self.notes.bad_colors += 1,
                }
            }
        }
        self.notes.blurred += usize::from(is_blurred(curve));
        self.document.drawing.curves.push(Curve { path, line: None });
    }

    /// The cubics of a curve, as far as their control points go.
    fn path(&self, curve: Node) -> Option<BezPath> {
        let du_from_page = self.document.drawing.drawing_from_page();
        let set = elements(curve, "control_points_set").next()?;
        let points = set.children().filter(Node::is_element);
        let points: Option<Vec<_>> =
            points.map(|p| Some(du_from_page * Point::new(number(p, "y")?, number(p, "x")?))).collect();
        let points = points?;
        let (start, cubics) = points.split_first()?;
        let mut path = BezPath::new();
        path.move_to(*start);
        cubics.as_chunks().0.iter().for_each(|&[a, b, c]| path.curve_to(a, b, c));
        (cubics.len() >= 3 && outline::is_within_reach(&path)).then_some(path)
    }
}

/// Where a colour is, counted in cubics, and what it is.
fn place_and_color(node: Node) -> Option<(f64, Srgb8)> {
    let channel = |name| number(node, name).map(|level| level.clamp(0.0, 255.0).round() as u8);
    let color = Srgb8([channel("B")?, channel("G")?, channel("R")?]);
    Some((number(node, "globalID")? / IDS_PER_CUBIC, color))
}

fn is_blurred(curve: Node) -> bool {
    let scales = elements(curve, "blur_points_set").flat_map(|set| set.children());
    scales.filter_map(|scale| number(scale, "value")).any(|value| value > 0.0)
}

fn elements<'a, 'input>(
    node: Node<'a, 'input>,
    name: &'static str,
) -> impl Iterator<Item = Node<'a, 'input>> {
    node.children().filter(move |child| child.has_tag_name(name))
}

/// An attribute that is a finite number.
fn number(node: Node, name: &str) -> Option<f64> {
    node.attribute(name)?.trim().parse().ok().filter(|number: &f64| number.is_finite())
}
