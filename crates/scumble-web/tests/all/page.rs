//! A page without a browser: pen and controls in, pictures out.

use kurbo::Point;
use scumble_core::{Document, Scribble, Srgb8, Work, exact};
use scumble_io::import_svg;
use scumble_solve::{Pixmap, paint};
use scumble_web::command::{Command, Phase, ViewChange};
use scumble_web::painting::{Changed, PAPER, Painter, Painting};
use scumble_web::session::Session;
use scumble_web::strips::{Frame, StripPainter};

pub(crate) const DESK: Srgb8 = Srgb8([90, 91, 92]);

/// A square of 480 du within a page of 1024 by 768 du.
pub(crate) const SQUARE: &[u8] = br#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1024 768">
    <path d="M200 150H680V630H200Z" fill="none" stroke="black" stroke-width="8"/></svg>"#;

/// A canvas that the painter on the CPU fills.
#[derive(Default)]
pub(crate) struct Canvas {
    pub(crate) frames: Vec<Changed>,
    pub(crate) shown: Option<Pixmap>,
    painter: StripPainter,
}

impl Painter for Canvas {
    fn paint(&mut self, painting: &Painting<'_>, changed: Changed) -> bool {
        let frame = self.painter.paint(painting, &changed, || true);
        self.frames.push(changed);
        self.show(&frame);
        let whole = paint(&painting.scene(), &painting.view);
        assert_eq!(self.shown.as_ref(), Some(&whole), "what has changed, painted alone");
        frame.is_all
    }
}

impl Canvas {
    fn show(&mut self, Frame { size_px: [width_px, height_px], parts, .. }: &Frame) {
        for ([x, y], part) in parts {
            let blank = || Pixmap {
                width_px: *width_px,
                height_px: *height_px,
                rgba: vec![0; 4 * (width_px * height_px) as usize],
            };
            let is_same = |shown: &Pixmap| [shown.width_px, shown.height_px] == [*width_px, *height_px];
            let shown = self.shown.take().filter(is_same).unwrap_or_else(blank);
            let shown = self.shown.insert(shown);
            for (row, pixels) in (*y..).zip(part.rgba.chunks(4 * part.width_px as usize)) {
                let first = 4 * (row * width_px + x) as usize;
                shown.rgba[first..first + pixels.len()].copy_from_slice(pixels);
            }
        }
    }
}

/// What opens a drawing with scribbles on it.
pub(crate) fn open(svg: &[u8], scribbles: &[Scribble]) -> Command {
    let drawing = import_svg(svg).expect("a drawing").drawing;
    let document = Document { scribbles: scribbles.to_vec(), ..Document::new(drawing) };
    Command::Open { work: exact::write(&Work::new(document)), notes: String::new() }
}

/// A page of 1200 by 900 CSS pixels with a drawing open.
pub(crate) struct Page {
    pub(crate) session: Session,
    pub(crate) canvas: Canvas,
}

impl Page {
    pub(crate) fn open(svg: &[u8]) -> Self {
        let mut page = Self { session: Session::new(DESK).expect("a blank page"), canvas: Canvas::default() };
        page.view(ViewChange::Resize { size_px: [1200, 900], px_per_css: 1.0, corner_css: Point::ZERO });
        page.session.command(open(svg, &[]));
        page.view(ViewChange::ZoomReset);
        page
    }

    /// The small picture of the drawing, whole.
    pub(crate) fn thumbnail(&mut self) -> Pixmap {
        let picture = self.session.thumbnail();
        picture.rows(0, picture.view.height_px, Some(PAPER))
    }

    pub(crate) fn view(&mut self, change: ViewChange) {
        self.session.command(Command::View(change));
    }

    /// A stroke of the pen through places in du, one batch of samples each.
    pub(crate) fn stroke(&mut self, color: Srgb8, points_du: &[(f64, f64)]) {
        self.session.command(Command::Color(color.into()));
        for (i, &point) in points_du.iter().enumerate() {
            self.pen(if i == 0 { Phase::Down } else { Phase::Move }, point);
        }
        self.session.pointer(Phase::Up, &[]);
    }

    pub(crate) fn pen(&mut self, phase: Phase, point_du: (f64, f64)) {
        let Point { x, y } = self.session.css_from_du() * Point::from(point_du);
        self.session.pointer(phase, &[x as f32, y as f32, 1.0]);
    }

    /// The colour on the canvas at a place in du, after a frame.
    pub(crate) fn color_at(&mut self, point_du: (f64, f64)) -> Srgb8 {
        self.session.frame(&mut self.canvas);
        let place_px = self.session.css_from_du() * Point::from(point_du);
        pixel(self.canvas.shown.as_ref().expect("a painting"), place_px)
    }
}

pub(crate) fn pixel(picture: &Pixmap, place_px: Point) -> Srgb8 {
    let i = 4 * (place_px.y as usize * picture.width_px as usize + place_px.x as usize);
    Srgb8([picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]])
}
