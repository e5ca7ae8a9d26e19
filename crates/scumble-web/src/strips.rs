//! The painter on the CPU, for a canvas that keeps what it has shown. What has changed is painted; of a large drawing in
//! strips, one at a time, so that the page goes on in between.

use std::ops::Range;

use scumble_core::Srgb8;
use scumble_solve::{Part, Pixmap, Repainter, Scene, View};

use crate::painting::{Changed, Painting};

/// About so many triangles are painted at once: for them it takes some 20 ms.
const STRIP_TRIANGLES: usize = 32_768;

/// Paints what is not as it was the time before.
#[derive(Debug, Default)]
pub struct StripPainter {
    look: Option<Look>,
    /// From the top.
    strips: Vec<Strip>,
    /// Which of them has its turn.
    next: usize,
    /// What is there of a look until all of it can be shown.
    hidden: Option<Vec<Painted>>,
}

/// A part of a picture, and where it begins, in pixels.
pub type Painted = ([u32; 2], Pixmap);

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

impl StripPainter {
    /// Paints a strip of what has changed, and tells whether that is all. Gives what can be shown now, of pictures of the size
    /// that [`StripPainter::size_px`] tells: all of another view or other paper comes at once.
    pub fn paint(&mut self, painting: &Painting<'_>, changed: &Changed) -> (Vec<Painted>, bool) {
        let scene = painting.scene();
        let look = Look { view: painting.view, paper: painting.paper, strip_count: strip_count(&scene) };
        // Else a view that changes with each frame would never come to be seen.
        if self.look != Some(look) && (self.hidden.is_none() || look.strip_count == 1) {
            self.turn_to(look);
        } else {
            self.note(changed);
        }
        let painted = self.paint_next(&scene);
        (painted, self.look == Some(look) && self.strips.iter().all(|strip| strip.stale.is_none()))
    }

    /// Of the picture that is painted.
    pub fn size_px(&self) -> [u32; 2] {
        self.look.map_or([0; 2], |Look { view, .. }| [view.width_px, view.height_px])
    }

    fn turn_to(&mut self, look: Look) {
        self.look = Some(look);
        self.strips = strips(&look.view, look.strip_count);
        self.next = 0;
        self.hidden = (!self.strips.is_empty()).then(Vec::new);
    }

    fn note(&mut self, changed: &Changed) {
        let Some(part) = self.look.and_then(|look| changed.part(&look.view)) else { return };
        for strip in &mut self.strips {
            let of_strip = intersection(&part, &strip.part);
            strip.stale = [strip.stale.take(), of_strip].into_iter().flatten().reduce(|a, b| hull(&a, &b));
        }
    }

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
    ((scene.field.triangles.len() + of_shapes) / STRIP_TRIANGLES).next_power_of_two()
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
    use scumble_solve::{Field, paint};

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
        /// A frame, which may show something; tells whether that is all.
        fn frame(&mut self, painting: &Painting<'_>, changed: Option<Rect>) -> bool {
            let (painted, is_all) =
                self.painter.paint(painting, &Changed { within_du: changed, ..Changed::default() });
            for ([x_px, y_px], part) in painted {
                let [width_px, height_px] = self.painter.size_px();
                let blank =
                    || Pixmap { width_px, height_px, rgba: vec![0; 4 * (width_px * height_px) as usize] };
                let shown = self
                    .shown
                    .take()
                    .filter(|shown| [shown.width_px, shown.height_px] == [width_px, height_px]);
                let shown = self.shown.insert(shown.unwrap_or_else(blank));
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
        Painting { field, problem: None, layers, view, paper: Some(Srgb8([255; 3])) }
    }

    fn whole(painting: &Painting<'_>) -> Pixmap {
        paint(&painting.scene(), &painting.view)
    }

    #[test]
    fn a_large_drawing_is_painted_in_strips_and_shown_whole() {
        let (field, layers, mut canvas) = (Field::default(), rings(), Canvas::default());
        let painting = painting(&field, &layers, 0.3);
        let mut frames = 1;
        while !canvas.frame(&painting, None) {
            assert_eq!(canvas.shown, None);
            frames += 1;
        }
        assert!(frames > 1);
        assert!(canvas.shown == Some(whole(&painting)));
        assert!(canvas.frame(&painting, None));
    }

    #[test]
    fn a_view_that_changes_with_each_frame_is_seen_all_the_same() {
        let (field, layers, mut canvas) = (Field::default(), rings(), Canvas::default());
        let mut shown = Vec::new();
        for i in 0..12 {
            canvas.frame(&painting(&field, &layers, 0.3 + 0.01 * f64::from(i)), None);
            shown.extend(canvas.shown.take());
        }
        assert!(shown.len() > 2);
        let is_one = |picture: &Pixmap| {
            (0..12).any(|i| *picture == whole(&painting(&field, &layers, 0.3 + 0.01 * f64::from(i))))
        };
        assert!(shown.iter().all(is_one), "of one view, from top to bottom");
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
            let changed = layers.set_scribbles(&[(&scribble(10.0 + f64::from(i)), false)]);
            canvas.frame(&painting(&field, &layers, 0.3), changed);
        }
        assert!(canvas.shown.is_some());
        while !canvas.frame(&painting(&field, &layers, 0.3), None) {}
        assert!(canvas.shown == Some(whole(&painting(&field, &layers, 0.3))));
    }
}
