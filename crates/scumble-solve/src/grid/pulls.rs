//! The layer that shading scribbles lay over pixels: each that is under a stroke is drawn towards its colour, and all of
//! the region towards nothing.

use std::{iter, mem};

use kurbo::{Affine, Point, Vec2};
use scumble_core::SoftSource;

use super::regions::{PixelRegions, Span};
use super::wall::centers_from_du;
use crate::brush::{Brush, Segment};
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

/// Places in a row along a radius of a stroke where its strength is looked at: a strong one ends suddenly.
const SAMPLES: f64 = 24.0;

/// Most of these places in a row of a pixel.
const MOST_SAMPLES: f64 = 8.0;

/// What a brush has to draw a pixel against: its links, and so many times what its layer fades by. So thin strokes come
/// nearest to the mesh solver's; measured for radii from a third of a pixel up.
const LINKS: f64 = 4.0;
const FADES: f64 = 2.0;

/// How strongly pixels are drawn to nothing where a layer has ended, against a link.
const HOLD: f64 = 1.0;

/// The least length in which a layer fades, in px.
const LEAST_LENGTH_PX: f64 = 0.25;

/// The pulls of the layer of some sources in what a view shows, in the regions that each reaches: those of their colours,
/// and where some are not opaque, those of how much they cover.
pub(super) fn layers(regions: &PixelRegions<'_>, sources: &[SoftSource], view: &View) -> Vec<Vec<Pull>> {
    if sources.is_empty() {
        return Vec::new();
    }
    let Canvas { pulls, fades, .. } = drawn(regions, sources, view);
    let is_opaque = sources.iter().all(|source| source.color[3] == 1.0);
    let covering = |pull: &Pull| Pull { color: [1.0; 4], ..*pull };
    let covers = (!is_opaque).then(|| pulls.iter().map(covering).collect());
    let layers = iter::once(pulls).chain(covers);
    layers.map(|pulls: Vec<_>| [pulls, fades.clone()].concat()).collect()
}

fn drawn(regions: &PixelRegions<'_>, sources: &[SoftSource], view: &View) -> Canvas {
    let all = regions.triangles();
    let places = reach::Regions::new(regions.mesh, &mut all.iter().map(Vec::as_slice));
    let shades: Vec<_> = sources.iter().map(|source| Shade::new(&places, source)).collect();
    let mut canvas = Canvas::new(view);
    for (i, triangles) in (0..).zip(&all) {
        let shades: Vec<_> =
            shades.iter().filter(|shade| shade.reach.meets(regions.mesh, i, triangles)).collect();
        if !shades.is_empty() {
            let spans = regions.spans(triangles);
            shades.iter().for_each(|shade| canvas.shade(shade, &spans));
            canvas.fade(&spans);
        }
    }
    canvas
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
    /// Towards the colours of sources.
    pulls: Vec<Pull>,
    /// Towards nothing.
    fades: Vec<Pull>,
    /// By the pixel of the region that is looked at, the length in which layers fade, in px; zero where none is.
    lengths_px: Vec<f64>,
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
            fades: Vec::new(),
            lengths_px: vec![0.0; view.width_px as usize * view.height_px as usize],
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
                shade.brush.near(self.du_from_centers * center, self.du_per_px, &mut near);
                if !near.is_empty() {
                    self.pull(shade, self.pixel([column, span.row]), center, &near);
                }
            }
        }
    }

    /// Adds what a source does to a pixel that some of its segments are near.
    fn pull(&mut self, shade: &Shade, pixel: u32, center: Point, near: &[Segment]) {
        let length_du = shade.brush.pull(self.du_from_centers * center, near).length_du;
        let length_px = (length_du / self.du_per_px).max(LEAST_LENGTH_PX);
        let longest_px = &mut self.lengths_px[pixel as usize];
        *longest_px = longest_px.max(length_px);
        let held = LINKS + FADES / (length_px * length_px);
        let strength = self.strength(&shade.brush, center, near, held);
        if strength > 0.0 {
            self.pulls.push(Pull { pixel, strength: strength as f32, color: shade.color });
        }
    }

    /// Adds what draws the pixels of a region to nothing.
    fn fade(&mut self, spans: &[Span]) {
        for span in spans {
            for column in span.columns.clone() {
                let pixel = self.pixel([column, span.row]);
                let length_px = mem::take(&mut self.lengths_px[pixel as usize]);
                let strength = if length_px > 0.0 { (length_px * length_px).recip() } else { HOLD };
                self.fades.push(Pull { pixel, strength: strength as f32, color: [0.0; 4] });
            }
        }
    }

    fn pixel(&self, [x, y]: [i64; 2]) -> u32 {
        (y * i64::from(self.width_px) + x) as u32
    }

    /// How strong a brush is in a pixel that is held so strongly, both against a link: it draws the pixel as far as it
    /// would draw those that lie around places in it, in the mean.
    fn strength(&self, brush: &Brush, center: Point, near: &[Segment], held: f64) -> f64 {
        let samples = (SAMPLES * self.du_per_px / brush.radii_du[0]).ceil().clamp(1.0, MOST_SAMPLES);
        let offset = |i: u32| (f64::from(i) + 0.5) / samples - 0.5;
        let places = (0..samples as u32).flat_map(|i| (0..samples as u32).map(move |j| [i, j]));
        let part = |[i, j]: [u32; 2]| {
            let at = self.du_from_centers * (center + Vec2::new(offset(i), offset(j)));
            let strength = self.du_per_px * self.du_per_px * brush.pull(at, near).strength;
            strength / (strength + held)
        };
        let part = places.map(part).sum::<f64>() / (samples * samples);
        held * part / (1.0 - part)
    }
}
