//! The part of the plane that the canvas shows: pan, zoom, fit, rotate, mirror.
//!
//! *css* coordinates are CSS pixels from the canvas' top left corner, *px* are device pixels, *du* drawing units. *Turned*
//! coordinates are du along the sides of the canvas: those of the drawing, mirrored and rotated as it is shown. At a zoom
//! of 1 (100%) one du is one CSS pixel. Unless it is aslant, the origin of the drawing lies on a corner of a device pixel,
//! so that at 100% the canvas shows the pixels of the exported picture.

use kurbo::{Affine, Point, Rect, Size, Vec2};
use scumble_core::{nearest_in, unit_vector};
use scumble_solve::View;

/// Smallest and largest zoom.
pub const ZOOM_RANGE: [f64; 2] = [0.05, 64.0];

/// Where zoom in and zoom out stop.
const LEVELS: [f64; 18] =
    [0.05, 0.1, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 12.0, 16.0, 24.0, 32.0, 48.0, 64.0];

/// Free space around a page that fits, in CSS pixels.
const MARGIN_CSS: f64 = 24.0;

/// So much of the page stays in sight however the view is moved, in CSS pixels.
const KEPT_CSS: f64 = 64.0;

/// A canvas' far corner that moves less is where it was, in CSS pixels: its size comes in whole pixels, its place does not.
const FAR_CORNER_CSS: f64 = 1.5;

/// Keys rotate to the next multiple of this, in degrees.
const STEP_DEGREES: f64 = 15.0;

/// How a page lies on the canvas.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Turn {
    /// How far it is rotated, clockwise, within `-180..=180`.
    pub degrees: f64,
    /// Whether left and right were exchanged before that.
    pub is_mirrored: bool,
}

impl Turn {
    /// Takes du to turned ones.
    fn turned_from_du(self) -> Affine {
        rotation(self.degrees) * Affine::scale_non_uniform(if self.is_mirrored { -1.0 } else { 1.0 }, 1.0)
    }

    fn is_aslant(self) -> bool {
        self.degrees % 90.0 != 0.0
    }

    fn rotated_to(self, degrees: f64) -> Self {
        let turns = (degrees / 360.0).round();
        Self { degrees: degrees - 360.0 * turns, ..self }
    }

    /// What is seen in a mirror.
    fn mirrored(self) -> Self {
        Self { degrees: -self.degrees, is_mirrored: !self.is_mirrored }
    }
}

/// Clockwise where y goes down; exact for right angles.
fn rotation(degrees: f64) -> Affine {
    let Vec2 { x: a, y: b } = unit_vector(degrees);
    Affine::new([a, b, -b, a, 0.0, 0.0])
}

/// Pan, zoom and turn of a canvas over a page.
#[derive(Clone, Debug)]
pub struct Viewport {
    width_px: u32,
    height_px: u32,
    px_per_css: f64,
    /// Where the canvas' top left corner lies in the window, in CSS pixels.
    corner_css: Point,
    page: Rect,
    zoom: f64,
    turn: Turn,
    center_du: Point,
    /// Whether the view follows the canvas' size, because nobody has moved it.
    fitted: bool,
}

impl Viewport {
    /// Shows all of a page (in du) on a canvas that has no size as yet.
    pub fn new(page: Rect) -> Self {
        let mut viewport = Self {
            width_px: 1,
            height_px: 1,
            px_per_css: 1.0,
            corner_css: Point::ZERO,
            page,
            zoom: 1.0,
            turn: Turn::default(),
            center_du: page.center(),
            fitted: true,
        };
        viewport.fit();
        viewport
    }

    /// Takes the canvas' size in device pixels, the device pixels of one CSS pixel, and where its top left corner lies in
    /// the window, in CSS pixels. What is no size or place is ignored.
    ///
    /// Under a pen that is down, the drawing stays where it is in the window; and where a bar above or to the left of the
    /// canvas comes or goes, as it may be soon. But a page that fits goes on doing so where a bar takes room.
    pub fn resize(&mut self, size_px: [u32; 2], px_per_css: f64, corner_css: Point, is_pen_down: bool) {
        let is_size = !size_px.contains(&0) && px_per_css > 0.0 && px_per_css.is_finite();
        if !is_size || !corner_css.is_finite() {
            return;
        }
        let before_css = self.place_css();
        ([self.width_px, self.height_px], self.px_per_css, self.corner_css) =
            (size_px, px_per_css, corner_css);
        let place_css = self.place_css();
        let is_beside_bar =
            (place_css.x1 - before_css.x1).hypot(place_css.y1 - before_css.y1) < FAR_CORNER_CSS;
        let has_shrunk = place_css.x0 > before_css.x0 || place_css.y0 > before_css.y0;
        if !is_pen_down && self.fitted && (!is_beside_bar || has_shrunk) {
            self.fit();
        } else if is_pen_down || is_beside_bar {
            self.center_du += self.way_du(place_css.center() - before_css.center());
        }
        self.keep_in_sight();
    }

    /// Shows all of another page, as it is.
    pub fn show_page(&mut self, page: Rect) {
        self.page = page;
        self.turn = Turn::default();
        self.fit();
    }

    /// Shows all of the page, with a margin, as it is turned.
    pub fn fit(&mut self) {
        let room = self.size_css() - Size::new(2.0 * MARGIN_CSS, 2.0 * MARGIN_CSS);
        let page = self.turned_from_du().transform_rect_bbox(self.page);
        let zoom = (room.width / page.width()).min(room.height / page.height());
        self.zoom = within_range(zoom);
        self.center_du = self.page.center();
        self.fitted = true;
    }

    /// Moves what is shown, by a way in CSS pixels.
    pub fn pan(&mut self, way_css: Vec2) {
        if way_css.is_finite() {
            self.center_du -= self.way_du(way_css);
            self.fitted = false;
            self.keep_in_sight();
        }
    }

    /// Multiplies the zoom; the place under a CSS pixel stays where it is.
    pub fn zoom_at(&mut self, at_css: Point, factor: f64) {
        if factor.is_finite() && factor > 0.0 {
            let zoom = within_range(self.zoom * factor);
            self.change_about(at_css, |viewport| viewport.zoom = zoom);
        }
    }

    /// Rotates the page by an angle, clockwise, about the place under a CSS pixel.
    pub fn rotate_at(&mut self, at_css: Point, degrees: f64) {
        if degrees.is_finite() {
            self.turn_about(at_css, self.turn.rotated_to(self.turn.degrees + degrees));
        }
    }

    /// Rotates it about the middle of the canvas to the next of some even angles, clockwise or the other way.
    pub fn rotate_step(&mut self, is_clockwise: bool) {
        let steps = self.turn.degrees / STEP_DEGREES;
        let next = if is_clockwise { (steps + 0.001).floor() + 1.0 } else { (steps - 0.001).ceil() - 1.0 };
        self.turn_about(self.canvas_css().center(), self.turn.rotated_to(next * STEP_DEGREES));
    }

    /// Rotates it back to how it is.
    pub fn rotate_reset(&mut self) {
        self.turn_about(self.canvas_css().center(), self.turn.rotated_to(0.0));
    }

    /// Exchanges left and right of what is shown.
    pub fn mirror(&mut self) {
        self.turn_about(self.canvas_css().center(), self.turn.mirrored());
    }

    fn turn_about(&mut self, at_css: Point, turn: Turn) {
        self.change_about(at_css, |viewport| viewport.turn = turn);
    }

    /// Changes zoom or turn; the place under a CSS pixel stays where it is.
    fn change_about(&mut self, at_css: Point, change: impl FnOnce(&mut Self)) {
        if at_css.is_finite() {
            let from_center_css = at_css - self.canvas_css().center();
            let place_du = self.center_du + self.way_du(from_center_css);
            change(self);
            self.center_du = place_du - self.way_du(from_center_css);
            self.fitted = false;
            self.keep_in_sight();
        }
    }

    /// Sets the zoom about the middle of the canvas.
    pub fn zoom_to(&mut self, zoom: f64) {
        self.zoom_at(self.canvas_css().center(), zoom / self.zoom);
    }

    /// To the next larger level.
    pub fn zoom_in(&mut self) {
        let next = LEVELS.into_iter().find(|level| *level > self.zoom * 1.001);
        self.zoom_to(next.unwrap_or(ZOOM_RANGE[1]));
    }

    /// To the next smaller level.
    pub fn zoom_out(&mut self) {
        let next = LEVELS.into_iter().rfind(|level| *level < self.zoom * 0.999);
        self.zoom_to(next.unwrap_or(ZOOM_RANGE[0]));
    }

    /// CSS pixels of one du.
    pub fn zoom(&self) -> f64 {
        self.zoom
    }

    /// Device pixels of one du.
    pub fn px_per_du(&self) -> f64 {
        self.zoom * self.px_per_css
    }

    /// How the page lies on the canvas.
    pub fn turn(&self) -> Turn {
        self.turn
    }

    /// Takes du to turned ones; it has no shift.
    pub fn turned_from_du(&self) -> Affine {
        self.turn.turned_from_du()
    }

    /// A way on the canvas, in du of the drawing.
    pub fn way_du(&self, way_css: Vec2) -> Vec2 {
        (self.turned_from_du().inverse() * way_css.to_point()).to_vec2() / self.zoom
    }

    /// What to paint.
    pub fn view(&self) -> View {
        View { px_from_du: self.px_from_du(), width_px: self.width_px, height_px: self.height_px }
    }

    /// Takes du to CSS pixels.
    pub fn css_from_du(&self) -> Affine {
        Affine::scale(self.px_per_css.recip()) * self.px_from_du()
    }

    fn px_from_du(&self) -> Affine {
        let linear = Affine::scale(self.px_per_du()) * self.turned_from_du();
        let middle_px = Vec2::new(f64::from(self.width_px), f64::from(self.height_px)) / 2.0;
        let origin_px = middle_px - (linear * self.center_du).to_vec2();
        Affine::translate(if self.turn.is_aslant() { origin_px } else { origin_px.round() }) * linear
    }

    /// The canvas in CSS pixels.
    pub(crate) fn canvas_css(&self) -> Rect {
        self.size_css().to_rect()
    }

    /// The canvas in the window.
    fn place_css(&self) -> Rect {
        self.canvas_css() + self.corner_css.to_vec2()
    }

    fn size_css(&self) -> Size {
        Size::new(f64::from(self.width_px), f64::from(self.height_px)) / self.px_per_css
    }

    /// The place of the page that is nearest to the middle of the canvas stays in sight.
    fn keep_in_sight(&mut self) {
        let reach = (self.size_css() / 2.0 - Size::new(KEPT_CSS, KEPT_CSS)).max(Size::ZERO) / self.zoom;
        let nearest = nearest_in(self.page, self.center_du);
        let turned_from_du = self.turned_from_du();
        let way = turned_from_du * (self.center_du - nearest).to_point();
        let kept = nearest_in(Rect::from_center_size(Point::ZERO, 2.0 * reach), way);
        if kept != way {
            self.center_du = nearest + (turned_from_du.inverse() * kept).to_vec2();
        }
    }
}

fn within_range(zoom: f64) -> f64 {
    zoom.clamp(ZOOM_RANGE[0], ZOOM_RANGE[1])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn viewport() -> Viewport {
        let mut viewport = Viewport::new(Rect::new(0.0, 0.0, 1024.0, 768.0));
        viewport.resize([1600, 1200], 2.0, Point::ZERO, false);
        viewport
    }

    fn close(a: Point, b: Point, by: f64) -> bool {
        (a - b).hypot() <= by
    }

    #[test]
    fn a_fitting_page_lies_in_the_middle_with_its_margin() {
        let mut viewport = viewport();
        let shown = viewport.css_from_du().transform_rect_bbox(Rect::new(0.0, 0.0, 1024.0, 768.0));
        assert!(close(shown.center(), Point::new(400.0, 300.0), 0.5), "{shown}");
        assert!((shown.y0 - MARGIN_CSS).abs() <= 0.5 && shown.x0 >= MARGIN_CSS, "{shown}");
        viewport.resize([800, 600], 1.0, Point::ZERO, false);
        assert_eq!(viewport.view().width_px, 800);
        assert!(close(viewport.css_from_du() * viewport.page.center(), Point::new(400.0, 300.0), 0.5));
    }

    #[test]
    fn the_drawing_stays_in_the_window_as_a_bar_beside_it_goes_and_fits_again_with_the_window() {
        for (way, below) in [(None, (60.0, 40.0)), (Some(Vec2::new(30.0, -50.0)), (60.0, 40.4))] {
            let mut viewport = viewport();
            let below = Point::from(below);
            viewport.resize([800, 560], 1.0, below, false);
            way.into_iter().for_each(|way| viewport.pan(way));
            let place_css = viewport.css_from_du() * Point::ZERO + below.to_vec2();
            let zoom = viewport.zoom();
            viewport.resize([860, 600], 1.0, Point::ZERO, false);
            assert_eq!(viewport.zoom(), zoom);
            assert!(close(viewport.css_from_du() * Point::ZERO, place_css, 1.0), "{way:?}");
            way.into_iter().for_each(|way| viewport.pan(way));
            let place_css = viewport.css_from_du() * Point::ZERO;
            viewport.resize([800, 560], 1.0, below, false);
            let came_css = viewport.css_from_du() * Point::ZERO + below.to_vec2();
            assert!(close(came_css, place_css, 1.0), "{way:?}, as the bar comes again");
        }
        let mut viewport = viewport();
        let place_css = viewport.css_from_du() * Point::ZERO;
        viewport.resize([1400, 900], 2.0, Point::ZERO, true);
        assert!(close(viewport.css_from_du() * Point::ZERO, place_css, 1.0), "under a pen");
        viewport.resize([800, 560], 1.0, Point::new(0.0, 40.0), false);
        viewport.resize([800, 600], 1.0, Point::ZERO, false);
        let zoom = viewport.zoom();
        viewport.resize([1600, 1200], 1.0, Point::ZERO, false);
        assert!(viewport.zoom() > 1.5 * zoom, "a page that nobody has moved fits a larger window");
    }

    #[test]
    fn the_place_under_the_pointer_stays() {
        let mut viewport = viewport();
        let at = Point::new(123.0, 456.0);
        for factor in [3.0, 0.5, 7.0, 0.9] {
            let place = viewport.css_from_du().inverse() * at;
            viewport.zoom_at(at, factor);
            assert!(close(viewport.css_from_du() * place, at, 0.36), "a half device pixel each way at most");
        }
    }

    #[test]
    fn zoom_goes_from_5_to_6400_percent_through_100_and_800() {
        let mut viewport = viewport();
        let mut levels = Vec::new();
        viewport.zoom_to(0.0001);
        assert_eq!(viewport.zoom(), 0.05);
        while viewport.zoom() < 64.0 {
            viewport.zoom_in();
            levels.push(viewport.zoom());
        }
        let near = |level: f64| levels.iter().any(|zoom| (zoom / level - 1.0).abs() < 1e-12);
        assert!(near(1.0) && near(8.0), "{levels:?}");
        for _ in &levels {
            viewport.zoom_out();
        }
        assert_eq!(viewport.zoom(), 0.05);
    }

    #[test]
    fn at_100_percent_one_du_is_one_css_pixel_on_the_pixel_grid() {
        let mut viewport = viewport();
        viewport.resize([801, 603], 1.0, Point::ZERO, false);
        viewport.pan(Vec2::new(0.3, -7.7));
        viewport.zoom_to(1.0);
        let [a, b, c, d, e, f] = viewport.view().px_from_du.as_coeffs();
        assert_eq!([a, b, c, d], [1.0, 0.0, 0.0, 1.0]);
        assert_eq!([e.fract(), f.fract()], [0.0, 0.0]);
    }

    #[test]
    fn the_page_cannot_be_lost() {
        for degrees in [0.0, 30.0, 45.0, 90.0, -135.0] {
            let mut viewport = viewport();
            viewport.rotate_at(Point::ORIGIN, degrees);
            viewport.pan(Vec2::new(1e9, -1e9));
            let mut places = (0..=32)
                .flat_map(|i| (0..=24).map(move |j| Point::new(32.0 * f64::from(i), 32.0 * f64::from(j))));
            let canvas = Rect::new(0.0, 0.0, 800.0, 600.0);
            let is_seen = |place: Point| canvas.contains(viewport.css_from_du() * place);
            assert!(places.any(is_seen), "at {degrees} degrees");
            viewport.pan(Vec2::new(f64::NAN, 0.0));
            viewport.rotate_at(Point::ORIGIN, f64::NAN);
            assert!(viewport.css_from_du().is_finite());
        }
    }

    #[test]
    fn the_place_that_it_is_rotated_about_stays_and_lengths_do() {
        let mut viewport = viewport();
        let at = Point::new(223.0, 156.0);
        viewport.mirror();
        for degrees in [20.0, -55.0, 35.0, 170.0, 170.0] {
            let place = viewport.css_from_du().inverse() * at;
            viewport.rotate_at(at, degrees);
            assert!(close(viewport.css_from_du() * place, at, 0.36), "{degrees}");
            assert!((viewport.css_from_du().determinant().abs().sqrt() - viewport.zoom()).abs() < 1e-12);
        }
        assert!((viewport.turn().degrees - -20.0).abs() < 1e-9, "{:?}", viewport.turn());
    }

    #[test]
    fn steps_go_to_multiples_of_15_degrees_and_round_to_where_they_began() {
        let mut viewport = viewport();
        let before = viewport.css_from_du();
        viewport.rotate_at(Point::ORIGIN, 7.0);
        viewport.rotate_step(false);
        assert_eq!(viewport.turn().degrees, 0.0);
        viewport.rotate_at(Point::ORIGIN, 7.0);
        viewport.rotate_step(true);
        assert_eq!(viewport.turn().degrees, 15.0);
        for _ in 0..24 {
            viewport.rotate_step(true);
        }
        assert_eq!(viewport.turn().degrees, 15.0);
        viewport.rotate_reset();
        viewport.fit();
        assert_eq!(viewport.css_from_du(), before);
    }

    #[test]
    fn in_the_mirror_left_is_right_and_a_lean_to_the_right_is_one_to_the_left() {
        let mut viewport = viewport();
        viewport.rotate_step(true);
        let at = viewport.css_from_du() * Point::new(300.0, 200.0);
        viewport.mirror();
        let mirrored = viewport.css_from_du() * Point::new(300.0, 200.0);
        assert!(close(mirrored, Point::new(800.0 - at.x, at.y), 1e-9), "{at} {mirrored}");
        assert_eq!(viewport.turn(), Turn { degrees: -15.0, is_mirrored: true });
    }

    #[test]
    fn what_is_not_aslant_lies_on_the_pixel_grid() {
        for quarters in 0..4 {
            let mut viewport = viewport();
            viewport.resize([801, 603], 1.0, Point::ZERO, false);
            viewport.zoom_to(1.0);
            viewport.rotate_at(Point::new(3.3, 7.7), 90.0 * f64::from(quarters));
            viewport.mirror();
            assert!(viewport.view().px_from_du.as_coeffs().into_iter().all(|v| v.fract() == 0.0));
        }
    }

    #[test]
    fn all_of_a_page_fits_as_it_is_turned() {
        let mut viewport = viewport();
        viewport.rotate_at(Point::ORIGIN, 60.0);
        viewport.fit();
        let shown = viewport.css_from_du().transform_rect_bbox(viewport.page);
        assert!(close(shown.center(), Point::new(400.0, 300.0), 0.5), "{shown}");
        assert!((shown.height() - (600.0 - 2.0 * MARGIN_CSS)).abs() < 1e-6, "{shown}");
        viewport.show_page(viewport.page);
        assert_eq!(viewport.turn(), Turn::default());
    }
}
