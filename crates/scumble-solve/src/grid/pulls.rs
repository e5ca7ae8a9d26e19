//! What shading scribbles do to pixels: each that is under a stroke is drawn towards its colour.

use kurbo::{Affine, Point, Vec2};
use scumble_core::SoftSource;

use super::regions::{PixelRegions, Span};
use super::wall::centers_from_du;
use crate::brush::{self, Brush, Segment};
use crate::reach::{self, Reach};
use crate::scene::View;

/// A term on the diagonal of a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pull {
    /// The pixel: row times width plus column.
    pub pixel: u32,
    /// How strong it is against a link to a pixel beside.
    pub strength: f32,
    /// Blend-space colour, times its opacity, and the opacity, that it draws towards.
    pub color: [f32; 4],
}

/// A stroke of a lesser radius, in px, is looked at at several places of a pixel.
const LEAST_RADIUS_PX: f64 = 2.0;

/// Most of these places, in a row.
const MOST_SAMPLES: f64 = 8.0;

/// The pulls of the sources of a boundary in what a view shows: in the regions that each of them reaches.
pub(super) fn pulls(regions: &PixelRegions<'_>, sources: &[SoftSource], view: &View) -> Vec<Pull> {
    if sources.is_empty() {
        return Vec::new();
    }
    let all = regions.triangles();
    let places = reach::Regions::new(regions.mesh, &mut all.iter().map(Vec::as_slice));
    let shades: Vec<_> = sources.iter().map(|source| Shade::new(&places, source)).collect();
    let mut canvas = Canvas::new(view);
    for (i, triangles) in (0..).zip(&all) {
        let meets = |shade: &&Shade| shade.reach.meets(regions.mesh, i, triangles);
        let shades: Vec<_> = shades.iter().filter(meets).collect();
        if !shades.is_empty() {
            let spans = regions.spans(triangles);
            shades.iter().for_each(|shade| canvas.shade(shade, &spans));
            if regions.colors(triangles).next().is_none() {
                canvas.fade(brush::fade_strength(shades.iter().map(|shade| &shade.brush)), &spans);
            }
        }
    }
    canvas.pulls
}

/// A source, where it shows and with which colour.
struct Shade {
    reach: Reach,
    brush: Brush,
    color: [f32; 4],
}

impl Shade {
    fn new(places: &reach::Regions<'_>, source: &SoftSource) -> Self {
        let color = source.color.map(|c| c as f32);
        Self { reach: places.reach(source), brush: Brush::new(source), color }
    }
}

/// The pixels of a view, and what pulls at them.
struct Canvas {
    width_px: u32,
    centers_from_du: Affine,
    du_from_centers: Affine,
    du_per_px: f64,
    pulls: Vec<Pull>,
}

impl Canvas {
    fn new(view: &View) -> Self {
        let centers_from_du = centers_from_du(view);
        Self {
            width_px: view.width_px,
            centers_from_du,
            du_from_centers: centers_from_du.inverse(),
            du_per_px: centers_from_du.determinant().abs().sqrt().recip(),
            pulls: Vec::new(),
        }
    }

    /// Adds what a source does to pixels.
    fn shade(&mut self, shade: &Shade, spans: &[Span]) {
        let bounds = self.centers_from_du.transform_rect_bbox(shade.brush.bounds()).inflate(0.5, 0.5);
        let mut near = Vec::new();
        let columns = bounds.x0.ceil() as i64..bounds.x1.floor() as i64 + 1;
        for span in spans.iter().filter(|span| bounds.y0 <= span.row as f64 && span.row as f64 <= bounds.y1) {
            for column in span.columns.start.max(columns.start)..span.columns.end.min(columns.end) {
                let center = Point::new(column as f64, span.row as f64);
                let strength = self.strength(&shade.brush, center, &mut near);
                if strength > 0.0 {
                    self.pull([column, span.row], strength, shade.color);
                }
            }
        }
    }

    /// Adds a pull of the paper, in 1/du².
    fn fade(&mut self, strength: f64, spans: &[Span]) {
        for span in spans {
            span.columns.clone().for_each(|column| self.pull([column, span.row], strength, [0.0; 4]));
        }
    }

    fn pull(&mut self, [x, y]: [i64; 2], strength: f64, color: [f32; 4]) {
        let pixel = (y * i64::from(self.width_px) + x) as u32;
        let strength = (strength * self.du_per_px * self.du_per_px) as f32;
        self.pulls.push(Pull { pixel, strength, color });
    }

    /// How strong a brush is in a pixel, in 1/du²: the mean over places in it, if one does not do.
    fn strength(&self, brush: &Brush, center: Point, near: &mut Vec<Segment>) -> f64 {
        brush.near(self.du_from_centers * center, self.du_per_px, near);
        if near.is_empty() {
            return 0.0;
        }
        let samples = (LEAST_RADIUS_PX * self.du_per_px / brush.radii_du[0]).ceil().clamp(1.0, MOST_SAMPLES);
        let offset = |i: u32| (f64::from(i) + 0.5) / samples - 0.5;
        let places = (0..samples as u32).flat_map(|i| (0..samples as u32).map(move |j| [i, j]));
        let strength = |[i, j]: [u32; 2]| {
            brush.strength(self.du_from_centers * (center + Vec2::new(offset(i), offset(j))), near)
        };
        places.map(strength).sum::<f64>() / (samples * samples)
    }
}
