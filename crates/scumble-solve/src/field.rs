//! A colour field: triangles with a quadratic of colour on each. It is the picture, at every zoom.

use kurbo::Rect;
use scumble_core::Blend;

use crate::scene::bounds;

/// The colours of the coloured regions of a drawing. Where there is no triangle, the paper shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Field {
    /// The space that the colours are in.
    pub blend: Blend,
    /// Triangles that meet edge to edge, without overlap. Neighbours have bit-equal corners.
    pub triangles: Vec<FieldTriangle>,
}

/// What a triangle takes as bytes: corners, colours and edges, four for each number.
const TRIANGLE_BYTES: usize = 4 * 31;

impl Field {
    /// What all triangles lie within, in du, that are not the same in another field at their places in the list; `None`
    /// where there are none.
    pub fn changed_within(&self, other: &Self) -> Option<Rect> {
        if self.blend != other.blend || self.triangles.len() != other.triangles.len() {
            return bounds(self.triangles.iter().chain(&other.triangles).map(|triangle| &triangle.corners));
        }
        let pairs = self.triangles.iter().zip(&other.triangles).filter(|(a, b)| a != b);
        bounds(pairs.flat_map(|(a, b)| [&a.corners, &b.corners]))
    }

    /// The same as bytes, for another module of the page.
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut bytes = Vec::with_capacity(1 + TRIANGLE_BYTES * self.triangles.len());
        bytes.push(u8::from(self.blend == Blend::Oklab));
        for FieldTriangle { corners, colors, side_edges } in &self.triangles {
            for number in corners.as_flattened().iter().chain(colors.as_flattened()) {
                bytes.extend(number.to_le_bytes());
            }
            bytes.extend(side_edges.to_le_bytes());
        }
        bytes
    }

    /// What [`Field::to_bytes`] made; `None` for other bytes.
    pub fn from_bytes(bytes: &[u8]) -> Option<Self> {
        let (&is_oklab, bytes) = bytes.split_first()?;
        let (triangles, []) = bytes.as_chunks::<TRIANGLE_BYTES>() else { return None };
        let blend = if is_oklab == 1 { Blend::Oklab } else { Blend::Srgb };
        Some(Self { blend, triangles: triangles.iter().map(FieldTriangle::from_bytes).collect() })
    }
}

/// A triangle with a colour at each corner and in the middle of each edge, blended quadratically between.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
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

impl FieldTriangle {
    fn from_bytes(bytes: &[u8; TRIANGLE_BYTES]) -> Self {
        let (words, _) = bytes.as_chunks::<4>();
        let number = |i: usize| f32::from_le_bytes(words[i]);
        Self {
            corners: std::array::from_fn(|i| std::array::from_fn(|c| number(2 * i + c))),
            colors: std::array::from_fn(|i| std::array::from_fn(|c| number(6 + 4 * i + c))),
            side_edges: u32::from_le_bytes(words[30]),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
