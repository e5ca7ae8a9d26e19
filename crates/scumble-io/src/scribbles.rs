//! Scribbles as JSON: `{"scribbles":[{"color":"#rrggbb","width":1.5,"points":[[x,y],…]},…]}`, in page units and in
//! drawing order. The colour `none` is that of a scribble that keeps its place free. With `"kind":"shade"` a scribble
//! shades, with a `"strength"` from 0 to 1, and with `"crosses":true` beyond the region that it begins in. The third number
//! of a point, if it has one, is how hard a pen pressed there, from 0 to 1: the part that is left of the radius, or with
//! `"pressure":"strength"` of the strength.

use std::collections::BTreeMap;

use kurbo::{Affine, Point, Rect};
use scumble_core::drawing::LONGER_SIDE_DU;
use scumble_core::work::{MAX_PAGES, are_too_long, are_too_many_shades};
use scumble_core::{Drawing, Paint, PenPressure, Scribble, ScribbleKind, Shading, nearest_in};
use serde::Deserialize;
use serde::de::IgnoredAny;

use crate::MAX_FILE_BYTES;
use crate::error::ScribblesError;
use crate::notes::ScribbleNotes;

/// The scribbles of a file that can be used, and what was left out.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ReadScribbles {
    /// In drawing order, in du.
    pub scribbles: Vec<Scribble>,
    /// What was left out or changed.
    pub notes: ScribbleNotes,
}

/// Points further outside the page than this, in du, are moved to that distance.
const REACH_DU: f64 = LONGER_SIDE_DU;

#[derive(Deserialize)]
#[serde(expecting = "an object with \"scribbles\"")]
struct FileText {
    scribbles: Vec<ScribbleText>,
    #[serde(flatten)]
    unknown: BTreeMap<String, IgnoredAny>,
}

#[derive(Deserialize)]
#[serde(expecting = "a scribble: an object with \"color\", \"width\" and \"points\"")]
struct ScribbleText {
    color: String,
    width: f64,
    kind: Option<String>,
    strength: Option<f64>,
    #[serde(default)]
    crosses: bool,
    #[serde(default)]
    pressure: PressureText,
    points: Vec<PointText>,
    #[serde(flatten)]
    unknown: BTreeMap<String, IgnoredAny>,
}

/// What pressure is a part of.
#[derive(Clone, Copy, Default, Deserialize)]
#[serde(rename_all = "lowercase")]
enum PressureText {
    #[default]
    Radius,
    Strength,
}

/// A point, maybe with pressure.
#[derive(Clone, Copy, Deserialize)]
#[serde(untagged, expecting = "expected points of two or three numbers")]
enum PointText {
    Plain([f64; 2]),
    Pressed([f64; 3]),
}

impl PointText {
    fn place(self) -> Point {
        let (Self::Plain([x, y]) | Self::Pressed([x, y, _])) = self;
        Point::new(x, y)
    }

    /// As it is given, or that of a mouse.
    fn pressure(self) -> f64 {
        if let Self::Pressed([.., pressure]) = self { pressure } else { 1.0 }
    }

    fn has_pressure(self) -> bool {
        (0.0..=1.0).contains(&self.pressure())
    }
}

/// Reads the scribbles on a drawing.
///
/// Faulty scribbles are left out and counted. A file without any scribble is a picture without colour, not an error.
///
/// # Errors
/// When the bytes are no such JSON, when there are scribbles but none that can be used, or beyond the limits.
pub fn read_scribbles(json: &[u8], drawing: &Drawing) -> Result<ReadScribbles, ScribblesError> {
    if json.trim_ascii().is_empty() {
        return Err(ScribblesError::Empty);
    }
    if json.len() > MAX_FILE_BYTES {
        return Err(ScribblesError::TooLarge);
    }
    let json = json.strip_prefix(b"\xef\xbb\xbf").unwrap_or(json);
    let file: FileText =
        serde_json::from_slice(json).map_err(|error| ScribblesError::NotScribbles(error.to_string()))?;
    let given = file.scribbles.len();
    let mut reader = Reader::new(drawing);
    reader.notes.unknown_fields = file.unknown.len();
    let scribbles: Vec<_> = file.scribbles.into_iter().filter_map(|text| reader.scribble(text)).collect();
    if scribbles.is_empty() && given > 0 {
        return Err(ScribblesError::NoneUsable(reader.notes));
    }
    if are_too_long(&scribbles) {
        return Err(ScribblesError::TooLong { limit_pages: MAX_PAGES });
    }
    if are_too_many_shades(&scribbles) {
        return Err(ScribblesError::TooManyShades);
    }
    Ok(ReadScribbles { scribbles: scribbles.into_iter().map(Scribble::kept).collect(), notes: reader.notes })
}

struct Reader {
    du_from_page: Affine,
    du_per_page_unit: f64,
    frame: Rect,
    notes: ScribbleNotes,
}

impl Reader {
    fn new(drawing: &Drawing) -> Self {
        Self {
            du_from_page: drawing.drawing_from_page(),
            du_per_page_unit: drawing.du_per_page_unit(),
            frame: drawing.frame(),
            notes: ScribbleNotes::default(),
        }
    }

    /// A scribble in du, or a note on why there is none.
    fn scribble(&mut self, text: ScribbleText) -> Option<Scribble> {
        self.notes.unknown_fields += text.unknown.len();
        let color = count_none(text.color.parse::<Paint>().ok(), &mut self.notes.bad_colors)?;
        let kind = self.kind(&text)?;
        let width_du = text.width * self.du_per_page_unit;
        let usable_width = (width_du > 0.0 && width_du <= LONGER_SIDE_DU).then_some(width_du);
        let width_du = count_none(usable_width, &mut self.notes.bad_widths)?;
        let points = count_none((!text.points.is_empty()).then_some(text.points), &mut self.notes.no_points)?;
        self.notes.bad_pressures += points.iter().filter(|point| !point.has_pressure()).count();
        let points: Vec<_> = points.iter().map(|point| self.du_from_page * point.place()).collect();
        let on_page = self.touches_page(&points, width_du).then_some(points);
        let points = count_none(on_page, &mut self.notes.off_page)?;
        let points = points.into_iter().map(|p| self.within_reach(p)).collect();
        Some(Scribble { color, kind, width_du, points })
    }

    fn kind(&mut self, text: &ScribbleText) -> Option<ScribbleKind> {
        let strength = text.strength.unwrap_or(Shading::default().strength);
        let strength = (0.0..=1.0).contains(&strength).then_some(strength);
        match text.kind.as_deref() {
            None | Some("fill") => Some(ScribbleKind::Fill),
            Some("shade") => {
                let strength = count_none(strength, &mut self.notes.bad_strengths)?;
                let pressure = pressure(text);
                Some(ScribbleKind::Shade(Shading { strength, crosses: text.crosses, pressure }))
            }
            Some(_) => count_none(None, &mut self.notes.bad_kinds),
        }
    }

    fn touches_page(&self, points: &[Point], width_du: f64) -> bool {
        let first = points.first().copied().unwrap_or_default();
        let bounds = points.iter().fold(Rect::from_points(first, first), |bounds, p| bounds.union_pt(*p));
        bounds.inflate(0.5 * width_du, 0.5 * width_du).overlaps(self.frame)
    }

    /// The point itself, or the nearest one that is not far outside.
    fn within_reach(&mut self, p: Point) -> Point {
        let nearest = nearest_in(self.frame.inflate(REACH_DU, REACH_DU), p);
        self.notes.far_points += usize::from(nearest != p);
        nearest
    }
}

fn pressure(text: &ScribbleText) -> PenPressure {
    let parts: Vec<_> = text.points.iter().map(|point| point.pressure().clamp(0.0, 1.0)).collect();
    match text.pressure {
        _ if parts.iter().all(|&part| part == 1.0) => PenPressure::Even,
        PressureText::Radius => PenPressure::Radius(parts),
        PressureText::Strength => PenPressure::Strength(parts),
    }
}

fn count_none<T>(value: Option<T>, count: &mut usize) -> Option<T> {
    *count += usize::from(value.is_none());
    value
}
