//! What is selected, and the frame around it, by whose handles it is resized.

use kurbo::{Affine, Point, Rect, Vec2};
use scumble_core::sort;

/// What is selected shrinks and grows to sides within this range, in du.
const SIDES_DU: [f64; 2] = [1.0, 4096.0];

/// What is selected, by the numbers that the editor knows scribbles and curves by.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Selection {
    /// In ascending order.
    ids: Vec<u32>,
}

impl Selection {
    pub(crate) fn of(mut ids: Vec<u32>) -> Self {
        sort::sort_unique(&mut ids);
        Self { ids }
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.ids.is_empty()
    }

    pub(crate) fn has(&self, id: u32) -> bool {
        self.ids.binary_search(&id).is_ok()
    }

    /// The same with one more, or with one less.
    pub(crate) fn toggled(&self, id: u32) -> Self {
        let mut ids = self.ids.clone();
        match ids.binary_search(&id) {
            Ok(place) => drop(ids.remove(place)),
            Err(place) => ids.insert(place, id),
        }
        Self { ids }
    }

    pub(crate) fn with(&self, more: Vec<u32>) -> Self {
        Self::of([self.ids.clone(), more].concat())
    }

    /// The places in a list of what is selected.
    pub(crate) fn places_in(&self, ids: &[u32]) -> Vec<usize> {
        ids.iter().enumerate().filter(|(_, id)| self.has(**id)).map(|(place, _)| place).collect()
    }
}

/// A place on a frame: its left or right side (0 or 1), or half-way between (0.5); likewise from top to bottom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Handle(pub(crate) Vec2);

/// Corners first: they are what is wanted where handles lie close together.
pub(crate) const HANDLES: [Handle; 8] = {
    const fn at(x: f64, y: f64) -> Handle {
        Handle(Vec2::new(x, y))
    }
    [
        at(0.0, 0.0),
        at(1.0, 0.0),
        at(1.0, 1.0),
        at(0.0, 1.0),
        at(0.5, 0.0),
        at(1.0, 0.5),
        at(0.5, 1.0),
        at(0.0, 0.5),
    ]
};

impl Handle {
    pub(crate) fn on(self, frame: Rect) -> Point {
        let Self(place) = self;
        frame.origin() + Vec2::new(place.x * frame.width(), place.y * frame.height())
    }

    fn opposite(self) -> Self {
        Self(Vec2::new(1.0, 1.0) - self.0)
    }

    pub(crate) fn is_corner(self) -> bool {
        self.0.x != 0.5 && self.0.y != 0.5
    }

    /// What a drag of this handle does to what is in a frame: the opposite one stays; a corner keeps the proportions.
    pub(crate) fn resize(self, frame: Rect, way: Vec2) -> Affine {
        let anchor = self.opposite().on(frame);
        let before = self.on(frame) - anchor;
        let after = before + way;
        let [x, y] = if self.is_corner() {
            [factor(before.hypot(), after.dot(before) / before.hypot()); 2]
        } else {
            [
                factor(before.x.abs(), after.x * before.x.signum()),
                factor(before.y.abs(), after.y * before.y.signum()),
            ]
        };
        Affine::translate(anchor.to_vec2())
            * Affine::scale_non_uniform(x, y)
            * Affine::translate(-anchor.to_vec2())
    }
}

/// What takes one length to another; what has no length keeps none.
fn factor(before_du: f64, after_du: f64) -> f64 {
    if before_du > 0.0 { after_du.clamp(SIDES_DU[0], SIDES_DU[1]) / before_du } else { 1.0 }
}

/// What moves a rectangle to the page, so far that the two touch.
pub(crate) fn way_to_page(bounds: Rect, page: Rect) -> Vec2 {
    let back = |low: f64, high: f64, least: f64, most: f64| (least - high).max(0.0) + (most - low).min(0.0);
    Vec2::new(back(bounds.x0, bounds.x1, page.x0, page.x1), back(bounds.y0, bounds.y1, page.y0, page.y1))
}

#[cfg(test)]
mod tests {
    use super::*;

    const FRAME: Rect = Rect::new(100.0, 100.0, 300.0, 200.0);

    fn resized(handle: Handle, way: (f64, f64)) -> Rect {
        handle.resize(FRAME, way.into()).transform_rect_bbox(FRAME)
    }

    #[test]
    fn a_corner_keeps_proportions_and_an_edge_goes_one_way() {
        assert_eq!(resized(HANDLES[2], (200.0, 100.0)), Rect::new(100.0, 100.0, 500.0, 300.0));
        assert_eq!(resized(HANDLES[0], (100.0, 50.0)), Rect::new(200.0, 150.0, 300.0, 200.0));
        assert_eq!(resized(HANDLES[5], (50.0, 999.0)), Rect::new(100.0, 100.0, 350.0, 200.0));
        assert_eq!(resized(HANDLES[4], (999.0, -50.0)), Rect::new(100.0, 50.0, 300.0, 200.0));
    }

    #[test]
    fn it_neither_turns_over_nor_vanishes_nor_grows_without_end() {
        for handle in HANDLES {
            for way in [(1e6, 1e6), (-1e6, -1e6), (1e6, -1e6), (-1e6, 1e6)] {
                let frame = resized(handle, way);
                assert!(frame.width() > 0.0 && frame.height() > 0.0, "{handle:?} {frame}");
                assert!(frame.width().max(frame.height()) < 4097.0, "{handle:?} {frame}");
            }
        }
        let line = Rect::new(50.0, 0.0, 50.0, 100.0);
        for handle in HANDLES {
            assert!(handle.resize(line, (7.0, 9.0).into()).is_finite(), "{handle:?}");
            assert!(handle.resize(Rect::ZERO, (7.0, 9.0).into()).is_finite(), "{handle:?}");
        }
    }

    #[test]
    fn what_leaves_the_page_is_brought_back_to_its_rim() {
        let page = Rect::new(0.0, 0.0, 1024.0, 768.0);
        assert_eq!(way_to_page(FRAME, page), Vec2::ZERO);
        assert_eq!(way_to_page(FRAME - Vec2::new(350.0, 0.0), page), Vec2::new(50.0, 0.0));
        assert_eq!(way_to_page(FRAME + Vec2::new(0.0, 700.0), page), Vec2::new(0.0, -32.0));
    }
}
