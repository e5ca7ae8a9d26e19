//! A colour field: triangles with a quadratic of colour on each. It is the picture, at every zoom.

use std::ops::Range;

use bytemuck::{Pod, Zeroable};
use kurbo::Rect;
use scumble_core::{Blend, bounds};

use crate::scene::point;

/// The colours of the coloured regions of a drawing. Where there is no triangle, the paper shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Field {
    /// The space that the colours are in.
    pub blend: Blend,
    /// Triangles that meet edge to edge, without overlap. Neighbours have bit-equal corners.
    pub triangles: Vec<FieldTriangle>,
}

impl Field {
    /// The same as bytes, for another module of the page.
    pub fn to_bytes(&self) -> Vec<u8> {
        let is_oklab = u8::from(self.blend == Blend::Oklab);
        [&[is_oklab], bytemuck::cast_slice(&self.triangles)].concat()
    }

    /// What [`Field::to_bytes`] made; `None` for other bytes.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (&is_oklab, bytes) = bytes.split_first()?;
        let blend = if is_oklab == 1 { Blend::Oklab } else { Blend::Srgb };
        let is_whole = bytes.len().is_multiple_of(size_of::<FieldTriangle>());
        is_whole.then(|| Self { blend, triangles: bytemuck::pod_collect_to_vec(bytes) })
    }
}

/// Beyond all that can be drawn, in du.
pub const EVERYWHERE: Rect = Rect::new(-1e9, -1e9, 1e9, 1e9);

/// What of a field is not what it was.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FieldChange {
    /// Places in the list of its triangles, and maybe beyond.
    pub places: Range<usize>,
    /// All that looks another lies within, in du.
    pub within_du: Option<Rect>,
}

impl FieldChange {
    /// That of a field that has nothing to do with what was there before.
    pub const ALL: Self = Self { places: 0..usize::MAX, within_du: Some(EVERYWHERE) };

    /// Whether there is any.
    pub fn is_any(&self) -> bool {
        !self.places.is_empty()
    }

    /// Adds what has changed, too.
    pub fn add(&mut self, Self { places, within_du }: Self) {
        if !self.is_any() {
            self.places = places;
        } else if !places.is_empty() {
            self.places = self.places.start.min(places.start)..self.places.end.max(places.end);
        }
        self.within_du = bounds::union(self.within_du, within_du);
    }
}

/// Triangles that become others while they are written from the first to the last: a change that takes no time to add to.
pub(crate) struct Others {
    places: Range<usize>,
    /// Of all their corners, as they were and as they are.
    least: [f32; 2],
    most: [f32; 2],
}

impl Others {
    pub(crate) fn none() -> Self {
        Self { places: 0..0, least: [f32::INFINITY; 2], most: [f32::NEG_INFINITY; 2] }
    }

    pub(crate) fn add(&mut self, place: usize, corners: &[[f32; 2]; 3]) {
        if self.places.is_empty() {
            self.places.start = place;
        }
        self.places.end = place + 1;
        // `f32::min` has more to do, for what is no number.
        let less = |x: f32, y: f32| if x < y { x } else { y };
        let more = |x: f32, y: f32| if x > y { x } else { y };
        let [a, b, c] = corners;
        for i in 0..2 {
            self.least[i] = less(less(a[i], b[i]), less(c[i], self.least[i]));
            self.most[i] = more(more(a[i], b[i]), more(c[i], self.most[i]));
        }
    }

    pub(crate) fn change(self) -> FieldChange {
        let within_du = Rect::from_points(point(self.least), point(self.most));
        let within_du = (!self.places.is_empty()).then_some(within_du);
        FieldChange { places: self.places, within_du }
    }
}

/// A triangle with a colour at each corner and in the middle of each edge, blended quadratically between.
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
#[repr(C)]
pub struct FieldTriangle {
    /// Corners in du, turning left.
    pub corners: [[f32; 2]; 3],
    /// Blend-space colours times their opacity, and the opacity, at corners 0, 1, 2 and in the middle of edges 01,
    /// 12, 20.
    pub colors: [[f32; 4]; 6],
    /// Bit `i` is set where the edge from corner `i` to corner `i + 1` is a side of a curve: the picture may jump
    /// there, so painters anti-alias these edges and no others.
    pub side_edges: u32,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn changes_hold_all_that_is_added_to_them() {
        assert_eq!(Others::none().change(), FieldChange::default());
        let mut others = Others::none();
        others.add(7, &[[3.0, -2.0], [5.0, 1.0], [4.0, 9.0]]);
        others.add(9, &[[0.0, 0.0], [1.0, 1.0], [0.0, 1.0]]);
        let mut change = others.change();
        let within_du = Some(Rect::new(0.0, -2.0, 5.0, 9.0));
        assert_eq!(change, FieldChange { places: 7..10, within_du });
        change.add(FieldChange { places: 2..3, within_du: Some(Rect::new(-1.0, 0.0, 0.0, 0.0)) });
        change.add(FieldChange { places: 20..20, within_du: None });
        let within_du = Some(Rect::new(-1.0, -2.0, 5.0, 9.0));
        assert_eq!(change, FieldChange { places: 2..10, within_du });
    }

    #[test]
    fn bytes_lose_nothing_and_other_bytes_are_none() {
        let triangle = FieldTriangle {
            corners: [[0.1, -2.5], [1024.0, 3.0], [7.0, f32::MIN_POSITIVE]],
            colors: std::array::from_fn(|i| std::array::from_fn(|c| (4 * i + c) as f32 / 7.0)),
            side_edges: 5,
        };
        for blend in [Blend::Oklab, Blend::Srgb] {
            let field = Field { blend, triangles: vec![triangle; 3] };
            let bytes = field.to_bytes();
            assert_eq!(Field::from_bytes(&bytes), Some(field));
            assert_eq!(Field::from_bytes(&bytes[1..]), None);
        }
        assert_eq!(Field::from_bytes(&[]), None);
    }
}
