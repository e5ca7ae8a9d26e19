//! What lies over the colour field, back to front: scribbles, the ink of the drawing, the desk around the page.

use kurbo::Rect;
use scumble_core::{Drawing, Paint, PlanarMap, Rgba8, Scribble, Srgb8, bounds};
use scumble_solve::{Shape, fill_shapes, line_shapes, scribble_shape};

use crate::regions::MapKey;

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

/// Of which map the ink is, and which lines there are.
pub(crate) type InkKey = (MapKey, u32);

/// Ink that has been drawn: lines for one scale, fills, which are cut by the map, for all, as they take the longest.
#[derive(Debug, Default)]
pub(crate) struct KnownInk {
    fills: Known<InkKey>,
    lines: Known<([u32; 2], f64)>,
}

/// Shapes that stay as long as what they are drawn of.
#[derive(Debug)]
struct Known<Key> {
    of: Option<Key>,
    shapes: Vec<Shape>,
}

impl<Key> Default for Known<Key> {
    fn default() -> Self {
        Self { of: None, shapes: Vec::new() }
    }
}

impl<Key: Copy + PartialEq> Known<Key> {
    fn follow(&mut self, of: Key, draw: impl FnOnce() -> Vec<Shape>) -> &[Shape] {
        if self.of.replace(of) != Some(of) {
            self.shapes = draw();
        }
        &self.shapes
    }
}

/// The shapes of a scene.
#[derive(Clone, Debug, Default)]
pub struct Layers {
    /// Scribbles, [`EACH`] for each, then ink, then the desk.
    shapes: Vec<Shape>,
    /// What the first shapes are of, and whether it is marked as selected.
    scribbles: Vec<(Scribble, bool)>,
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

    /// Draws other scribbles, each with whether it is marked as selected. Those that are as they were stay. Tells within what
    /// the picture of them is another, in du.
    pub(crate) fn set_scribbles(&mut self, scribbles: &[(&Scribble, bool)]) -> Option<Rect> {
        let ink = self.shapes.split_off(EACH * self.scribbles.len());
        self.scribbles.truncate(scribbles.len());
        let mut others: Vec<_> = self.shapes.drain(EACH * self.scribbles.len()..).collect();
        for (i, &(scribble, is_selected)) in scribbles.iter().enumerate() {
            if self.scribbles.get(i).is_none_or(|before| (&before.0, before.1) != (scribble, is_selected)) {
                let shapes = shapes(scribble, is_selected, self.tolerance_du);
                others.extend(shapes.iter().cloned());
                let count = self.scribbles.len();
                others.extend(self.shapes.splice(EACH * i..EACH * count.min(i + 1), shapes));
                self.scribbles.splice(i..count.min(i + 1), [(scribble.clone(), is_selected)]);
            }
        }
        self.shapes.extend(ink);
        bounds_of(&others)
    }

    pub(crate) fn clear_ink(&mut self) {
        self.shapes.truncate(EACH * self.scribbles.len());
    }

    pub(crate) fn add_lines(&mut self, drawing: &Drawing, map: Option<&PlanarMap>) {
        self.shapes.extend(line_shapes(drawing, map, self.tolerance_du));
    }

    /// The same with what is known of it.
    pub(crate) fn add_ink(
        &mut self,
        key: InkKey,
        drawing: &Drawing,
        map: Option<&PlanarMap>,
        known: &mut KnownInk,
    ) {
        let KnownInk { fills, lines } = known;
        let draw = || map.map_or_else(Vec::new, |map| fill_shapes(drawing, map));
        self.shapes.extend_from_slice(fills.follow(key, draw));
        let draw = || line_shapes(drawing, None, self.tolerance_du);
        let ((number, ..), revision) = key;
        self.shapes.extend_from_slice(lines.follow(([number, revision], self.tolerance_du), draw));
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

fn bounds_of(shapes: &[Shape]) -> Option<Rect> {
    shapes.iter().fold(None, |all, shape| bounds::union(all, shape.bounds()))
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

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use kurbo::{BezPath, Point, Shape as _, Stroke};
    use scumble_core::{Curve, Fill, Line, Sampling, ScribbleKind};

    use super::*;

    const BLACK: Rgba8 = Rgba8([0, 0, 0, 255]);

    fn scribble(y: f64) -> Scribble {
        let points = vec![Point::new(100.0, y), Point::new(200.0, y)];
        Scribble { color: Srgb8([1, 2, 3]).into(), kind: ScribbleKind::Fill, width_du: 9.0, points }
    }

    fn are_same(a: &[Shape], b: &[Shape]) -> bool {
        a.len() == b.len() && a.iter().zip(b).all(|(a, b)| Arc::ptr_eq(&a.triangles, &b.triangles))
    }

    #[test]
    fn scribbles_are_drawn_again_alone() {
        let [a, b, c] = [100.0, 200.0, 300.0].map(scribble);
        let mut layers = Layers::at_scale(1.0);
        layers.set_scribbles(&[(&a, false), (&b, false), (&c, false)]);
        layers.add_desk(Rect::new(0.0, 0.0, 1024.0, 1024.0), MARK);
        let before = layers.clone();
        let changed = layers.set_scribbles(&[(&a, false), (&b, true), (&c, false)]).expect("a change");
        assert!((185.0..195.0).contains(&changed.y0) && (205.0..215.0).contains(&changed.y1), "{changed}");
        for (part, is_kept) in [(0..2, true), (2..4, false), (4..7, true)] {
            let [now, then] = [&layers, &before].map(|layers| &layers.shapes()[part.clone()]);
            assert_eq!(are_same(now, then), is_kept, "{part:?}");
        }
        let changed = layers.set_scribbles(&[(&a, false)]).expect("a change");
        assert!(changed.y0 > 185.0 && changed.y1 > 300.0, "what has gone: {changed}");
        assert!(are_same(layers.shapes(), &[&before.shapes()[..2], before.ink()].concat()));
    }

    #[test]
    fn fills_are_found_once_for_all_scales_and_lines_for_each() {
        let path: BezPath = Rect::new(100.0, 100.0, 300.0, 300.0).to_path(0.1);
        let line = Line { stroke: Stroke::new(4.0), color: BLACK };
        let drawing = Drawing {
            curves: vec![Curve { path: path.clone(), line: Some(line) }],
            fills: vec![Fill { path, even_odd: false, color: BLACK }],
            ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0))
        };
        let map = PlanarMap::build(&drawing, &Sampling::default()).expect("a map");
        let mut known = KnownInk::default();
        let mut drawn = |key: InkKey, scale: f64| {
            let mut layers = Layers::at_scale(scale);
            layers.add_ink(key, &drawing, Some(&map), &mut known);
            layers.shapes
        };
        let key = ((0, Some(0), 0.5), 0);
        let first = drawn(key, 1.0);
        assert_eq!(first, line_shapes(&drawing, Some(&map), tolerance_du(1.0)));
        assert!(are_same(&drawn(key, 1.0), &first));
        let closer = drawn(key, 8.0);
        assert!(are_same(&closer[..1], &first[..1]) && !are_same(&closer[1..], &first[1..]));
        assert!(!are_same(&drawn((key.0, 1), 8.0)[..1], &first[..1]), "of other lines");
    }
}
