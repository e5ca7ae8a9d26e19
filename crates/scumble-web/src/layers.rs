//! What lies over the colour field, back to front: scribbles, the ink of the drawing, the desk around the page.

use kurbo::Rect;
use scumble_core::{Drawing, Paint, PlanarMap, Rgba8, Scribble, Srgb8};
use scumble_solve::{Shape, line_shapes, scribble_shape};

/// Largest distance of a drawn edge from its true place, in device pixels.
const TOLERANCE_PX: f64 = 0.1;

/// A scribble has a rim this wide, in device pixels: without one it is not to be seen on what it coloured.
const RIM_PX: f64 = 1.5;

/// Opacity of the rim, where it is light and where it is dark.
const RIM_OPACITIES: [u8; 2] = [128, 80];

/// What is selected has a rim this wide, in device pixels, of this colour.
pub(crate) const MARK_PX: f64 = 3.0;
pub(crate) const MARK: Srgb8 = Srgb8([0x4c, 0x4c, 0xd0]);

/// A scribble that shades is drawn this wide, in du: its colours are to be seen.
const SPINE_DU: f64 = 4.0;

/// The desk reaches so far beyond the page, in du: past the widest canvas at the smallest zoom.
const DESK_REACH_DU: f64 = 262_144.0;

/// Shapes of a scribble: its rim, and it.
const EACH: usize = 2;

/// The shapes of a scene.
#[derive(Clone, Debug, Default)]
pub struct Layers {
    /// Scribbles, [`EACH`] for each, then ink, then the desk.
    shapes: Vec<Shape>,
    /// What the first shapes are of: a long scribbling draws only what is new.
    scribbles: Vec<Scribble>,
    /// Which of them are marked as selected.
    are_selected: Vec<bool>,
    tolerance_du: f64,
}

impl Layers {
    /// No shapes; those to come will look right at this many device pixels a du.
    pub(crate) fn at_scale(px_per_du: f64) -> Self {
        Self { tolerance_du: tolerance_du(px_per_du), ..Self::default() }
    }

    /// All shapes, back to front.
    pub fn shapes(&self) -> &[Shape] {
        &self.shapes
    }

    /// The layer of scribbles.
    pub fn scribbles(&self) -> &[Shape] {
        self.shapes.get(..EACH * self.scribbles.len()).unwrap_or_default()
    }

    /// The layer of ink, with the desk.
    pub fn ink(&self) -> &[Shape] {
        self.shapes.get(EACH * self.scribbles.len()..).unwrap_or_default()
    }

    /// Whether shapes would be drawn with the same tolerance at this many device pixels a du.
    pub(crate) fn suit_scale(&self, px_per_du: f64) -> bool {
        self.tolerance_du == tolerance_du(px_per_du)
    }

    /// Draws other scribbles, and tells within what the picture of them is another, in du.
    pub(crate) fn set_scribbles(&mut self, scribbles: &[&Scribble], are_selected: Vec<bool>) -> Option<Rect> {
        let mark = |i: usize| are_selected.get(i) == Some(&true);
        let is_kept = |i: &usize| {
            self.scribbles.get(*i) == Some(scribbles[*i]) && self.are_selected.get(*i) == are_selected.get(*i)
        };
        let kept = (0..scribbles.len()).take_while(is_kept).count();
        let fresh = scribbles.get(kept..).unwrap_or_default();
        let shapes: Vec<_> = (kept..)
            .zip(fresh)
            .flat_map(|(i, scribble)| shapes(scribble, mark(i), self.tolerance_du))
            .collect();
        let added = bounds(&shapes);
        let removed: Vec<_> = self.shapes.splice(EACH * kept..EACH * self.scribbles.len(), shapes).collect();
        self.scribbles.splice(kept.., fresh.iter().copied().cloned());
        self.are_selected = are_selected;
        [added, bounds(&removed)].into_iter().flatten().reduce(|a, b| a.union(b))
    }

    pub(crate) fn clear_ink(&mut self) {
        self.shapes.truncate(EACH * self.scribbles.len());
    }

    pub(crate) fn add_lines(&mut self, drawing: &Drawing, map: Option<&PlanarMap>) {
        self.shapes.extend(line_shapes(drawing, map, self.tolerance_du));
    }

    /// Covers everything but the page.
    pub(crate) fn add_desk(&mut self, page: Rect, color: Srgb8) {
        let far = page.inflate(DESK_REACH_DU, DESK_REACH_DU);
        let around = [
            Rect::new(far.x0, far.y0, far.x1, page.y0),
            Rect::new(far.x0, page.y1, far.x1, far.y1),
            Rect::new(far.x0, page.y0, page.x0, page.y1),
            Rect::new(page.x1, page.y0, far.x1, page.y1),
        ];
        let Srgb8([r, g, b]) = color;
        let triangles = around.into_iter().flat_map(halves).collect();
        self.shapes.push(Shape { triangles, color: Rgba8([r, g, b, 255]) });
    }
}

fn bounds(shapes: &[Shape]) -> Option<Rect> {
    shapes.iter().filter_map(Shape::bounds).reduce(|a, b| a.union(b))
}

/// How wide a scribble is drawn, in du.
pub(crate) fn drawn_width_du(scribble: &Scribble) -> f64 {
    if scribble.is_fill() { scribble.width_du } else { SPINE_DU.min(scribble.width_du) }
}

fn shapes(scribble: &Scribble, is_selected: bool, tolerance_du: f64) -> [Shape; EACH] {
    let width_du = drawn_width_du(scribble);
    let drawn = Scribble { width_du, ..scribble.clone() };
    let is_pale = is_pale(scribble.color);
    let (rim_px, color, opacity) = if is_selected {
        (MARK_PX, MARK, 255)
    } else {
        (RIM_PX, Srgb8([if is_pale { 0 } else { 255 }; 3]), RIM_OPACITIES[usize::from(is_pale)])
    };
    let rim_du = rim_px * tolerance_du / TOLERANCE_PX;
    let rim = Scribble { width_du: width_du + 2.0 * rim_du, color: color.into(), ..drawn.clone() };
    [scribble_shape(&rim, opacity, tolerance_du), scribble_shape(&drawn, 255, tolerance_du)]
}

/// Whether a dark rim is seen better around a colour than a light one.
fn is_pale(color: Paint) -> bool {
    let Paint::Color(Srgb8([r, g, b])) = color else { return false };
    let [r, g, b] = [r, g, b].map(u32::from);
    2 * r + 7 * g + b > 10 * 190
}

/// Steps of two, so that shapes are drawn anew only once in a while as the zoom changes.
fn tolerance_du(px_per_du: f64) -> f64 {
    TOLERANCE_PX / px_per_du.log2().ceil().exp2()
}

fn halves(rect: Rect) -> [[[f32; 2]; 3]; 2] {
    let corner = |x: f64, y: f64| [x as f32, y as f32];
    let [a, b] = [corner(rect.x0, rect.y0), corner(rect.x1, rect.y0)];
    let [c, d] = [corner(rect.x1, rect.y1), corner(rect.x0, rect.y1)];
    [[a, b, c], [a, c, d]]
}
