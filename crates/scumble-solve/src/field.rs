//! A colour field: triangles with a quadratic of colour on each. It is the picture, at every zoom.

use scumble_core::Blend;

/// The colours of the coloured regions of a drawing. Where there is no triangle, the paper shows.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Field {
    /// The space that the colours are in.
    pub blend: Blend,
    /// Triangles that meet edge to edge, without overlap. Neighbours have bit-equal corners.
    pub triangles: Vec<FieldTriangle>,
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
