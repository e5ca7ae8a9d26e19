//! The painter on the CPU, for a canvas that keeps what it has shown. What has changed is painted; of a large drawing in
//! strips, one at a time, so that the page goes on in between.

use std::ops::Range;

use scumble_core::Srgb8;
use scumble_solve::{Part, Pixmap, Repainter, Scene, View};

use crate::painting::{Changed, Painting};

/// A strip has up to twice as many triangles: they take some 20 ms.
const STRIP_TRIANGLES: usize = 32_768;

/// Each strip looks at all triangles: more of them gain nothing.
const MOST_STRIPS: usize = 32;

/// Paints what is not as it was the time before.
#[derive(Debug, Default)]
pub struct StripPainter {
    look: Option<Look>,
    /// From the top.
    strips: Vec<Strip>,
    /// Which of them has its turn.
    next: usize,
    /// What is there of a picture until all of it can be shown.
    hidden: Option<Vec<Painted>>,
}

/// What is painted, but for its colours and shapes.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Look {
    view: View,
    paper: Option<Srgb8>,
    strip_count: usize,
}

/// Some rows of a view.
#[derive(Debug)]
struct Strip {
    part: Part,
    painter: Repainter,
    /// What of it is not as it was painted.
    stale: Option<Part>,
}

/// A part of a picture, and where it begins, in pixels.
pub type Painted = ([u32; 2], Pixmap);

/// What there is to show after a frame.
#[derive(Debug)]
pub struct Frame {
    /// Size of the picture, in pixels; where it is another than before, the parts are all of it.
    pub size_px: [u32; 2],
    /// What of it is new.
    pub parts: Vec<Painted>,
    /// Whether there is no more to paint.
    pub is_all: bool,
}

impl StripPainter {
    /// Paints a strip of what has changed, and others while there is time. Where all has changed it is shown once there is all of
    /// it; what has changed meanwhile comes in strips.
    pub fn paint(
        &mut self,
        painting: &Painting<'_>,
        changed: &Changed,
        has_time: impl Fn() -> bool,
    ) -> Frame {
        let scene = painting.scene();
        let look = Look { view: painting.view, paper: painting.paper, strip_count: strip_count(&scene) };
        if self.look != Some(look) && self.may_turn(look, changed) {
            self.turn_to(look);
        } else {
            self.note(changed);
        }
        let mut parts = self.paint_next(&scene);
        while self.is_stale() && has_time() {
            parts.extend(self.paint_next(&scene));
        }
        let is_all = self.look == Some(look) && !self.is_stale();
        let size_px = self.look.map_or([0; 2], |Look { view, .. }| [view.width_px, view.height_px]);
        Frame { size_px, parts, is_all }
    }

    /// A view that changes with each frame would never be seen if each began anew. But a field may be of what is in view alone.
    fn may_turn(&self, look: Look, changed: &Changed) -> bool {
        self.hidden.is_none() || changed.field.is_any() || look.strip_count == 1
    }

    fn turn_to(&mut self, look: Look) {
        self.look = Some(look);
        self.strips = strips(&look.view, look.strip_count);
        self.begin();
    }

    /// Everything is stale, and shown once it is painted.
    fn begin(&mut self) {
        self.next = 0;
        self.hidden = self.is_stale().then(Vec::new);
    }

    fn note(&mut self, changed: &Changed) {
        let Some((view, part)) = self.look.and_then(|look| Some((look.view, changed.part(&look.view)?)))
        else {
            return;
        };
        for strip in &mut self.strips {
            let of_strip = intersection(&part, &strip.part);
            strip.stale = [strip.stale.take(), of_strip].into_iter().flatten().reduce(|a, b| hull(&a, &b));
        }
        if part == view.whole() && self.hidden.is_none() {
            self.begin();
        }
    }

    fn is_stale(&self) -> bool {
        self.strips.iter().any(|strip| strip.stale.is_some())
    }

    /// Paints the stale strip whose turn it is, and gives what can be shown.
    fn paint_next(&mut self, scene: &Scene<'_>) -> Vec<Painted> {
        let Some(Look { view, paper, .. }) = self.look else { return Vec::new() };
        let count = self.strips.len();
        let stale =
            (self.next..self.next + count).map(|i| i % count).find(|&i| self.strips[i].stale.is_some());
        let Some(i) = stale else { return Vec::new() };
        self.next = (i + 1) % count;
        let painted = self.strips[i].paint(&Scene { paper, ..scene.clone() }, &view);
        let Some(mut hidden) = self.hidden.take() else { return vec![painted] };
        hidden.push(painted);
        if self.next == 0 {
            return hidden;
        }
        self.hidden = Some(hidden);
        Vec::new()
    }
}

impl Strip {
    /// Paints what is stale of it.
    fn paint(&mut self, scene: &Scene<'_>, view: &View) -> Painted {
        let Part { columns, rows } = self.stale.take().unwrap_or_else(|| self.part.clone());
        let corner = [columns.start, rows.start];
        let top = self.part.rows.start;
        let within = Part { columns, rows: rows.start - top..rows.end - top };
        (corner, self.painter.paint(scene, &view.part(&self.part), &within))
    }
}

/// In how many strips a scene is painted: a power of two, so that it is seldom another.
fn strip_count(scene: &Scene<'_>) -> usize {
    let of_shapes: usize = scene.shapes.iter().map(|shape| shape.triangles.len()).sum();
    let triangles = scene.field.triangles.len() + of_shapes;
    (triangles / STRIP_TRIANGLES).next_power_of_two().min(MOST_STRIPS)
}

/// All of a view, of which nothing is painted.
fn strips(view: &View, count: usize) -> Vec<Strip> {
    let rows_each = (view.height_px as usize).div_ceil(count).max(1);
    let rows =
        (0..view.height_px).step_by(rows_each).map(|top| top..view.height_px.min(top + rows_each as u32));
    let part = rows.map(|rows| Part { rows, ..view.whole() });
    part.map(|part| Strip { stale: Some(part.clone()), part, painter: Repainter::default() }).collect()
}

/// What both have, if anything.
fn intersection(a: &Part, b: &Part) -> Option<Part> {
    let both = |a: &Range<u32>, b: &Range<u32>| a.start.max(b.start)..a.end.min(b.end);
    let (columns, rows) = (both(&a.columns, &b.columns), both(&a.rows, &b.rows));
    (!columns.is_empty() && !rows.is_empty()).then_some(Part { columns, rows })
}

/// The least part that has all of both.
fn hull(a: &Part, b: &Part) -> Part {
    let all = |a: &Range<u32>, b: &Range<u32>| a.start.min(b.start)..a.end.max(b.end);
    Part { columns: all(&a.columns, &b.columns), rows: all(&a.rows, &b.rows) }
}

#[cfg(test)]
mod tests {
    use kurbo::{Affine, Circle, Point, Rect, Shape, Stroke};
    use scumble_core::{Curve, Drawing, Line, Rgba8, Scribble, ScribbleKind};
    use scumble_solve::{Field, FieldChange, paint};

    use super::*;
    use crate::layers::Layers;

    /// Rings whose lines are of more triangles than are painted at once.
    fn rings() -> Layers {
        let mut drawing = Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0));
        let line = Line { stroke: Stroke::new(2.0), color: Rgba8([10, 20, 30, 255]) };
        let ring =
            |i: u32| Circle::new((f64::from(i % 40) * 25.0 + 20.0, f64::from(i / 40) * 25.0 + 20.0), 11.0);
        let curve = |i| Curve { path: ring(i).to_path(0.1), line: Some(line.clone()) };
        drawing.curves = (0..1600).map(curve).collect();
        let mut layers = Layers::at_scale(1.0);
        layers.add_lines(&drawing, None);
        layers
    }

    /// A canvas that is painted so.
    #[derive(Default)]
    struct Canvas {
        painter: StripPainter,
        shown: Option<Pixmap>,
    }

    impl Canvas {
        /// A frame of one strip, which may show something; tells whether that is all.
        fn frame(&mut self, painting: &Painting<'_>, changed: &Changed) -> bool {
            let Frame { size_px: [width_px, height_px], parts, is_all } =
                self.painter.paint(painting, changed, || false);
            for ([x_px, y_px], part) in parts {
                let blank =
                    || Pixmap { width_px, height_px, rgba: vec![0; 4 * (width_px * height_px) as usize] };
                let shown = self.shown.get_or_insert_with(blank);
                for (y, row) in (y_px..).zip(part.rgba.chunks(4 * part.width_px as usize)) {
                    let first = 4 * (y * width_px + x_px) as usize;
                    shown.rgba[first..first + row.len()].copy_from_slice(row);
                }
            }
            is_all
        }
    }

    fn painting<'a>(field: &'a Field, layers: &'a Layers, px_per_du: f64) -> Painting<'a> {
        let view = View { px_from_du: Affine::scale(px_per_du), width_px: 300, height_px: 301 };
        Painting { field, problem: None, part: None, layers, view, paper: Some(Srgb8([255; 3])) }
    }

    fn whole(painting: &Painting<'_>) -> Pixmap {
        paint(&painting.scene(), &painting.view)
    }

    const NOTHING: Changed = Changed {
        field: FieldChange { places: 0..0, within_du: None },
        problem: false,
        part: false,
        scribbles: false,
        ink: false,
        within_du: None,
    };

    #[test]
    fn a_large_drawing_is_painted_in_strips_and_shown_whole() {
        let (field, layers, mut canvas) = (Field::default(), rings(), Canvas::default());
        let painting = painting(&field, &layers, 0.3);
        for changed in [NOTHING, Changed::ALL] {
            let (before, mut frames) = (canvas.shown.clone(), 1);
            let mut is_all = canvas.frame(&painting, &changed);
            while !is_all {
                assert!(canvas.shown == before);
                is_all = canvas.frame(&painting, &NOTHING);
                frames += 1;
            }
            assert!(frames > 1);
            assert!(canvas.shown == Some(whole(&painting)));
        }
        let frame = StripPainter::default().paint(&painting, &NOTHING, || true);
        assert!(frame.is_all && frame.parts.len() > 1, "as many as there is time for");
    }

    #[test]
    fn a_view_that_changes_with_each_frame_is_seen_all_the_same() {
        let (field, layers, mut canvas) = (Field::default(), rings(), Canvas::default());
        let scale = |i: u32| 0.3 + 0.01 * f64::from(i);
        let mut shown = Vec::new();
        for i in 0..12 {
            canvas.frame(&painting(&field, &layers, scale(i)), &NOTHING);
            shown.extend(canvas.shown.take());
        }
        assert!(shown.len() > 2);
        let is_one =
            |picture: &Pixmap| (0..12).any(|i| *picture == whole(&painting(&field, &layers, scale(i))));
        assert!(shown.iter().all(is_one), "of one view, from top to bottom");
    }

    #[test]
    fn a_view_with_a_field_of_its_own_is_not_painted_for_another() {
        let (field, layers, mut canvas) = (Field::default(), rings(), Canvas::default());
        canvas.frame(&painting(&field, &layers, 0.3), &NOTHING);
        let close = painting(&field, &layers, 4.0);
        let mut is_all = canvas.frame(&close, &Changed { field: FieldChange::ALL, ..NOTHING });
        while !is_all {
            assert!(canvas.shown.is_none());
            is_all = canvas.frame(&close, &NOTHING);
        }
        assert!(canvas.shown == Some(whole(&close)));
    }

    #[test]
    fn what_changes_meanwhile_is_painted_again_and_keeps_no_strip_from_its_turn() {
        let (field, mut layers, mut canvas) = (Field::default(), rings(), Canvas::default());
        let scribble = |width_du| Scribble {
            color: Srgb8([200, 30, 90]).into(),
            kind: ScribbleKind::Fill,
            width_du,
            points: vec![Point::new(30.0, 30.0), Point::new(90.0, 40.0)],
        };
        for i in 0..12 {
            let within_du = layers.set_scribbles(&[(&scribble(10.0 + f64::from(i)), false)]);
            canvas.frame(&painting(&field, &layers, 0.3), &Changed { within_du, ..NOTHING });
        }
        assert!(canvas.shown.is_some());
        while !canvas.frame(&painting(&field, &layers, 0.3), &NOTHING) {}
        assert!(canvas.shown == Some(whole(&painting(&field, &layers, 0.3))));
    }
}
