//! Whether a device draws what it should: a known picture, drawn and read back.
//!
//! It holds one of everything: paper, a flat, a curved and a fading triangle, the edge between them, a shape that
//! overlaps itself, a layer over another. Drivers differ most in rounding, multisampling and depth; each has its pixel here.

use kurbo::Affine;
use scumble_core::{Blend, Rgba8, Srgb8};
use scumble_solve::{Field, FieldChange, FieldTriangle, Pixmap, Scene, Shape, View, paint};

use crate::error::GpuError;
use crate::renderer::{Layer, Renderer};

const PAPER: Srgb8 = Srgb8([250, 240, 200]);
const RED: Srgb8 = Srgb8([230, 25, 75]);
const SIDE_PX: u32 = 40;

/// How far from the painter on the CPU a channel may be, in 8-bit levels.
const LEVELS: u8 = 2;

/// What is looked at: a name, and a pixel well inside of it or on an edge that halves it.
const SPOTS: [(&str, [u32; 2]); 8] = [
    ("paper", [37, 37]),
    ("a flat triangle", [3, 20]),
    ("a smooth triangle", [20, 3]),
    ("a fading triangle", [36, 3]),
    ("an edge", [8, 28]),
    ("a translucent shape", [3, 5]),
    ("a shape that overlaps itself", [9, 5]),
    ("ink over a scribble", [14, 5]),
];

/// Draws a picture with a renderer, compares it with the painter on the CPU, and leaves the renderer empty.
///
/// The drawing is done when this returns; the future waits for the pixels and borrows nothing.
pub fn probe(renderer: &mut Renderer) -> impl Future<Output = Result<(), GpuError>> + use<> {
    let (field, shapes) = (field(), shapes());
    let view = View { px_from_du: Affine::IDENTITY, width_px: SIDE_PX, height_px: SIDE_PX };
    renderer.set_field(&field, &FieldChange::ALL);
    renderer.set_shapes(Layer::Ink, &shapes[1..]);
    renderer.set_shapes(Layer::Scribbles, &shapes[..1]);
    let drawn = renderer.read_back(&view, Some(PAPER));
    renderer.set_field(&Field::default(), &FieldChange::ALL);
    renderer.set_shapes(Layer::Ink, &[]);
    renderer.set_shapes(Layer::Scribbles, &[]);
    let expected = paint(&Scene { paper: Some(PAPER), field: &field, shapes: &shapes }, &view);
    async move { compare(&expected, &drawn.await?) }
}

/// A square of two triangles, one red, one from blue over red to green; its lower edge halves pixels. And beside it a
/// triangle from red to nothing.
fn field() -> Field {
    let oklab = |rgb| Blend::Oklab.from_srgb8(Srgb8(rgb)).map(|c| c as f32);
    let (red, blue, green) = (oklab(RED.0), oklab([0, 130, 200]), oklab([60, 180, 75]));
    let flat = FieldTriangle {
        corners: [[0.0, 0.0], [28.5, 28.5], [0.0, 28.5]],
        colors: [red; 6],
        side_edges: 0b111,
    };
    let smooth = FieldTriangle {
        corners: [[0.0, 0.0], [28.5, 0.0], [28.5, 28.5]],
        colors: [blue, green, red, red, green, blue],
        side_edges: 0b111,
    };
    let (half, clear) = (red.map(|c| 0.5 * c), [0.0; 4]);
    let fading = FieldTriangle {
        corners: [[29.5, 0.5], [39.5, 0.5], [39.5, 10.5]],
        colors: [red, half, clear, half, half, half],
        side_edges: 0b111,
    };
    Field { blend: Blend::Oklab, triangles: vec![flat, smooth, fading] }
}

/// A band of two triangles that overlap around x = 9, and a triangle over its right part.
fn shapes() -> [Shape; 2] {
    let low_left = [[1.0, 1.0], [17.0, 1.0], [1.0, 17.0]];
    let low_right = [[17.0, 1.0], [1.0, 1.0], [17.0, 17.0]];
    let cover = [[12.0, 1.0], [18.0, 1.0], [18.0, 30.0]];
    [
        Shape { triangles: [low_left, low_right].into(), color: Rgba8([0, 0, 0, 120]) },
        Shape { triangles: [cover].into(), color: Rgba8([255, 225, 25, 200]) },
    ]
}

fn compare(expected: &Pixmap, drawn: &Pixmap) -> Result<(), GpuError> {
    let wrong = SPOTS.iter().find_map(|&(name, place)| {
        let (want, got) = (pixel(expected, place), pixel(drawn, place));
        let same = want.iter().zip(&got).all(|(a, b)| a.abs_diff(*b) <= LEVELS);
        (!same).then(|| format!("{name} is {got:?} instead of {want:?}"))
    });
    wrong.map_or(Ok(()), |text| Err(GpuError::Probe(text)))
}

fn pixel(picture: &Pixmap, [x, y]: [u32; 2]) -> [u8; 4] {
    let start = 4 * (y * picture.width_px + x) as usize;
    let bytes = picture.rgba.get(start..start + 4).and_then(|bytes| bytes.try_into().ok());
    bytes.unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_wrong_pixel_is_named() {
        let field = field();
        let view = View { px_from_du: Affine::IDENTITY, width_px: SIDE_PX, height_px: SIDE_PX };
        let right = paint(&Scene { paper: Some(PAPER), field: &field, shapes: &shapes() }, &view);
        assert_eq!(compare(&right, &right), Ok(()));
        for (name, [x, y]) in SPOTS {
            let mut wrong = right.clone();
            wrong.rgba[4 * (y * SIDE_PX + x) as usize] ^= 4;
            let Err(GpuError::Probe(text)) = compare(&right, &wrong) else { panic!("{name} went by") };
            assert!(text.starts_with(name), "{text}");
        }
    }
}
