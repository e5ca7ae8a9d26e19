//! The part of the plane that the canvas shows: pan, zoom, fit.
//!
//! *css* coordinates are CSS pixels from the canvas' top left corner, *px* are device pixels, *du* drawing units.
//! At a zoom of 1 (100%) one du is one CSS pixel. The origin of the drawing always lies on a corner of a device
//! pixel, so that at 100% the canvas shows the pixels of the exported picture.

use kurbo::{Affine, Point, Rect, Size, Vec2};
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

/// Pan and zoom of a canvas over a page.
#[derive(Clone, Debug)]
pub struct Viewport {
    width_px: u32,
    height_px: u32,
    px_per_css: f64,
    page: Rect,
    zoom: f64,
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
            page,
            zoom: 1.0,
            center_du: page.center(),
            fitted: true,
        };
        viewport.fit();
        viewport
    }

    /// Takes the canvas' size in device pixels and the device pixels of one CSS pixel. What is no size is ignored.
    pub fn resize(&mut self, width_px: u32, height_px: u32, px_per_css: f64) {
        if width_px == 0 || height_px == 0 || !px_per_css.is_finite() || px_per_css <= 0.0 {
            return;
        }
        (self.width_px, self.height_px, self.px_per_css) = (width_px, height_px, px_per_css);
        if self.fitted {
            self.fit();
        }
        self.keep_in_sight();
    }

    /// Shows all of another page.
    pub fn show_page(&mut self, page: Rect) {
        self.page = page;
        self.fit();
    }

    /// Shows all of the page, with a margin.
    pub fn fit(&mut self) {
        let room = self.size_css() - Size::new(2.0 * MARGIN_CSS, 2.0 * MARGIN_CSS);
        let zoom = (room.width / self.page.width()).min(room.height / self.page.height());
        self.zoom = within_range(zoom);
        self.center_du = self.page.center();
        self.fitted = true;
    }

    /// Moves what is shown, by a way in CSS pixels.
    pub fn pan(&mut self, way_css: Vec2) {
        if way_css.is_finite() {
            self.center_du -= way_css / self.zoom;
            self.fitted = false;
            self.keep_in_sight();
        }
    }

    /// Multiplies the zoom; the place under a CSS pixel stays where it is.
    pub fn zoom_at(&mut self, at_css: Point, factor: f64) {
        if !at_css.is_finite() || !factor.is_finite() || factor <= 0.0 {
            return;
        }
        let zoom = within_range(self.zoom * factor);
        let from_center_css = at_css - self.size_css().to_rect().center();
        self.center_du += from_center_css * (1.0 / self.zoom - 1.0 / zoom);
        self.zoom = zoom;
        self.fitted = false;
        self.keep_in_sight();
    }

    /// Sets the zoom about the middle of the canvas.
    pub fn zoom_to(&mut self, zoom: f64) {
        self.zoom_at(self.size_css().to_rect().center(), zoom / self.zoom);
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

    /// What to paint.
    pub fn view(&self) -> View {
        View { px_from_du: self.px_from_du(), width_px: self.width_px, height_px: self.height_px }
    }

    /// Takes du to CSS pixels.
    pub fn css_from_du(&self) -> Affine {
        Affine::scale(self.px_per_css.recip()) * self.px_from_du()
    }

    fn px_from_du(&self) -> Affine {
        let px_per_du = self.zoom * self.px_per_css;
        let middle_px = Vec2::new(f64::from(self.width_px), f64::from(self.height_px)) / 2.0;
        let origin_px = middle_px - self.center_du.to_vec2() * px_per_du;
        Affine::translate(origin_px.round()) * Affine::scale(px_per_du)
    }

    /// The canvas in CSS pixels.
    pub(crate) fn canvas_css(&self) -> Rect {
        self.size_css().to_rect()
    }

    fn size_css(&self) -> Size {
        Size::new(f64::from(self.width_px), f64::from(self.height_px)) / self.px_per_css
    }

    fn keep_in_sight(&mut self) {
        let reach = (self.size_css() / 2.0 - Size::new(KEPT_CSS, KEPT_CSS)).max(Size::ZERO) / self.zoom;
        let allowed = self.page.inflate(reach.width, reach.height);
        self.center_du.x = self.center_du.x.clamp(allowed.x0, allowed.x1);
        self.center_du.y = self.center_du.y.clamp(allowed.y0, allowed.y1);
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
        viewport.resize(1600, 1200, 2.0);
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
        viewport.resize(800, 600, 1.0);
        assert_eq!(viewport.view().width_px, 800);
        assert!(close(viewport.css_from_du() * viewport.page.center(), Point::new(400.0, 300.0), 0.5));
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
        viewport.resize(801, 603, 1.0);
        viewport.pan(Vec2::new(0.3, -7.7));
        viewport.zoom_to(1.0);
        let [a, b, c, d, e, f] = viewport.view().px_from_du.as_coeffs();
        assert_eq!([a, b, c, d], [1.0, 0.0, 0.0, 1.0]);
        assert_eq!([e.fract(), f.fract()], [0.0, 0.0]);
    }

    #[test]
    fn the_page_cannot_be_lost() {
        let mut viewport = viewport();
        viewport.pan(Vec2::new(1e9, -1e9));
        let shown = viewport.css_from_du().transform_rect_bbox(viewport.page);
        let canvas = Rect::new(0.0, 0.0, 800.0, 600.0);
        assert!(!shown.intersect(canvas).is_zero_area());
        viewport.pan(Vec2::new(f64::NAN, 0.0));
        assert!(viewport.css_from_du().is_finite());
    }
}
