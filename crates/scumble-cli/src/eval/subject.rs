//! One drawing of a quality set with all that belongs to it, and its pictures.

use anyhow::{Context, ensure};
use kurbo::Affine;
use scumble_core::drawing::LONGER_SIDE_DU;
use scumble_core::{Blend, Boundary, Engine, EngineKind, Scribble, Settings, Sight, Srgb8, boundary};
use scumble_solve::{Field, Pixmap, Scene, Shape, View, line_shapes, paint, scribble_shape};

use super::method::{Method, Way};
use super::truth::{PALETTE, Truth, palette_index};
use crate::files;
use crate::rivals::{Sketch, SketchPixel};
use crate::set::{Entry, Kind};
use crate::stages::{self, Opened, PAPER};

/// Largest distance of a drawn line from its true place, in du.
const LINE_TOLERANCE_DU: f64 = 0.2;

/// A drawing, its scribbles, and what is expected of them.
pub(crate) struct Subject {
    pub(crate) opened: Opened,
    /// In drawing order; their colours are in the palette.
    pub(crate) scribbles: Vec<Scribble>,
    pub(crate) truth: Truth,
    /// The drawn lines.
    lines: Vec<Shape>,
    /// How dark they make each pixel at the size of the truth: 0 white, 255 black.
    darkness: Vec<u8>,
}

impl Subject {
    /// Reads a drawing of a set.
    ///
    /// # Errors
    /// When a file is missing or faulty, a scribble's colour is not in the palette, or the truth has another shape
    /// than the page.
    pub(crate) fn read(entry: &Entry, kind: Kind) -> anyhow::Result<Self> {
        let opened = stages::open(&entry.svg()?)?;
        let scribbles = entry.scribbles(kind, &opened.document.drawing)?;
        scribbles.iter().try_for_each(|scribble| palette_index(scribble).map(|_| ()))?;
        let path = entry.path("truth.png");
        let truth = Truth::read(&files::read(&path)?).with_context(|| format!("{}", path.display()))?;
        let view = stages::page_view(&opened.document.drawing, truth.longer_side_px());
        let fits = (view.width_px, view.height_px) == (truth.width_px, truth.height_px);
        ensure!(fits, "{} has not the shape of the drawing", path.display());
        let lines = line_shapes(&opened.document.drawing, Some(opened.picture.map()), LINE_TOLERANCE_DU);
        let darkness = darkness(&lines, &view);
        Ok(Self { opened, scribbles, truth, lines, darkness })
    }

    /// The picture that a method makes of some scribbles, of the size of the truth, transparent where nothing is
    /// coloured.
    ///
    /// # Errors
    /// When the solver fails.
    pub(crate) fn paint(
        &mut self,
        method: Method,
        settings: Settings,
        scribbles: &[Scribble],
    ) -> anyhow::Result<Pixmap> {
        match method.way {
            Way::Engine(kind) => self.paint_sides(kind, settings, scribbles),
            Way::Sight => self.paint_sight(scribbles),
            Way::Pixels(label) => Ok(self.paint_pixels(&label(&self.sketch(scribbles), settings))),
        }
    }

    fn paint_sides(
        &mut self,
        kind: EngineKind,
        settings: Settings,
        scribbles: &[Scribble],
    ) -> anyhow::Result<Pixmap> {
        let settings = Settings { engine: kind, ..settings };
        let boundary = self.opened.picture.color(scribbles, &[], &settings).clone();
        self.paint_boundary(&boundary)
    }

    fn paint_sight(&mut self, scribbles: &[Scribble]) -> anyhow::Result<Pixmap> {
        let map = self.opened.picture.map();
        let labels = Sight::default().label(map, scribbles);
        let boundary = boundary(map, &labels, scribbles, &[], Blend::Oklab);
        self.paint_boundary(&boundary)
    }

    fn paint_boundary(&mut self, boundary: &Boundary) -> anyhow::Result<Pixmap> {
        let view = self.view(self.truth.longer_side_px());
        let field = self.opened.picture.mesh().solve(boundary, Blend::Oklab)?;
        Ok(stages::paint_page(field, &[], &view, None))
    }

    fn paint_pixels(&self, labels: &[SketchPixel]) -> Pixmap {
        let Truth { width_px, height_px, .. } = self.truth;
        let rgba = labels.iter().flat_map(|label| label.map_or([0; 4], palette_rgba)).collect();
        Pixmap { width_px, height_px, rgba }
    }

    /// Lines and scribbles as pixels, at the size of the truth.
    pub(crate) fn sketch(&self, scribbles: &[Scribble]) -> Sketch {
        let Truth { width_px, height_px, .. } = self.truth;
        let mut sketch = Sketch::new(width_px as usize, height_px as usize, self.darkness.clone());
        for scribble in scribbles {
            if let Ok(label) = palette_index(scribble) {
                sketch.draw(scribble, label, self.px_from_du());
            }
        }
        sketch
    }

    /// Takes du to pixels of the truth.
    pub(crate) fn px_from_du(&self) -> Affine {
        Affine::scale(f64::from(self.truth.longer_side_px()) / LONGER_SIDE_DU)
    }

    /// The whole page with a longer side of so many pixels.
    pub(crate) fn view(&self, size_px: u32) -> View {
        stages::page_view(&self.opened.document.drawing, size_px)
    }

    /// The drawn lines on nothing.
    pub(crate) fn lines_picture(&self, size_px: u32) -> Pixmap {
        shapes_picture(&self.lines, &self.view(size_px), None)
    }

    /// The scribbles on nothing.
    pub(crate) fn scribbles_picture(&self, size_px: u32) -> Pixmap {
        let shapes: Vec<_> =
            self.scribbles.iter().map(|scribble| scribble_shape(scribble, 255, LINE_TOLERANCE_DU)).collect();
        shapes_picture(&shapes, &self.view(size_px), None)
    }
}

/// A colour of the palette as an opaque pixel; transparent for what is not in it.
pub(crate) fn palette_rgba(index: u8) -> [u8; 4] {
    PALETTE.get(usize::from(index)).map_or([0; 4], |Srgb8([r, g, b])| [*r, *g, *b, 255])
}

fn shapes_picture(shapes: &[Shape], view: &View, paper: Option<Srgb8>) -> Pixmap {
    paint(&Scene { paper, field: &Field::default(), shapes }, view)
}

/// How dark lines make each pixel of white paper, by the mean of the channels.
fn darkness(lines: &[Shape], view: &View) -> Vec<u8> {
    let picture = shapes_picture(lines, view, Some(PAPER));
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    pixels
        .iter()
        .map(|[r, g, b, _]| 255 - ((u16::from(*r) + u16::from(*g) + u16::from(*b)) / 3) as u8)
        .collect()
}
