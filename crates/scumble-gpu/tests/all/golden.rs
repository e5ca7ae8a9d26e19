//! The renderer draws what the painter on the CPU paints. Needs a graphics driver; Mesa's software one is enough.

#[path = "../../../../tests/golden/scenes.rs"]
mod scenes;

use kurbo::Affine;
use scenes::Golden;
use scumble_core::{Blend, Rgba8, Srgb8};
use scumble_gpu::wgpu::TextureFormat::{self, Bgra8Unorm, Rgba8Unorm};
use scumble_gpu::{Gpu, GpuError, Layer, Renderer, probe};
use scumble_solve::{Field, FieldChange, FieldTriangle, Pixmap, Shape, View};

/// An open device, or `None`, said aloud, where there is none.
fn gpu() -> Option<Gpu> {
    let failed = |error: GpuError| panic!("{error}");
    pollster::block_on(Gpu::headless(failed)).map_err(|error| eprintln!("skipped: {error}")).ok()
}

fn renderer(format: TextureFormat) -> Option<Renderer> {
    Some(Renderer::new(&gpu()?, format))
}

fn drawn(renderer: &mut Renderer, golden: &Golden) -> Pixmap {
    renderer.set_field(&golden.field, &FieldChange::ALL);
    renderer.set_shapes(Layer::Ink, &golden.ink);
    renderer.set_shapes(Layer::Scribbles, &golden.scribbles);
    read(renderer, &golden.view, golden.paper)
}

fn read(renderer: &mut Renderer, view: &View, paper: Option<Srgb8>) -> Pixmap {
    pollster::block_on(renderer.read_back(view, paper)).expect("the pixels come back")
}

fn pixel(picture: &Pixmap, x: u32, y: u32) -> [u8; 4] {
    let start = 4 * (y * picture.width_px + x) as usize;
    std::array::from_fn(|c| picture.rgba[start + c])
}

/// A triangle of one colour that covers all of a picture whose corner is the origin.
fn cover(blend: Blend, color: Srgb8) -> Field {
    let corners = [[-1.0, -1.0], [9000.0, -1.0], [-1.0, 9000.0]];
    let color = blend.from_srgb8(color).map(|c| c as f32);
    Field { blend, triangles: vec![FieldTriangle { corners, colors: [color; 6], side_edges: 7 }] }
}

fn plain_view(width_px: u32, height_px: u32) -> View {
    View { px_from_du: Affine::IDENTITY, width_px, height_px }
}

#[test]
fn golden_scenes_are_drawn_as_they_are_painted() {
    for format in [Rgba8Unorm, Bgra8Unorm] {
        let Some(mut renderer) = renderer(format) else { return };
        let wrong: Vec<String> = scenes::all()
            .iter()
            .filter_map(|golden| golden.differences(&drawn(&mut renderer, golden)))
            .collect();
        assert!(wrong.is_empty(), "{format:?}: {wrong:#?}");
    }
}

#[test]
fn the_probe_passes_and_leaves_nothing_behind() {
    let Some(mut renderer) = renderer(Rgba8Unorm) else { return };
    assert_eq!(pollster::block_on(probe(&mut renderer)), Ok(()));
    let picture = read(&mut renderer, &plain_view(40, 40), None);
    assert_eq!(picture.rgba, vec![0; 4 * 40 * 40]);
}

#[test]
fn the_probe_notices_a_format_that_converts() {
    let Some(mut renderer) = renderer(TextureFormat::Rgba8UnormSrgb) else { return };
    assert!(matches!(pollster::block_on(probe(&mut renderer)), Err(GpuError::Probe(_))));
}

#[test]
fn flat_regions_have_the_picked_colour_to_the_last_bit() {
    let Some(mut renderer) = renderer(Rgba8Unorm) else { return };
    for blend in [Blend::Oklab, Blend::Srgb] {
        for rgb in (0..=0xff_ffff_u32).step_by(65_793 * 3 + 1) {
            let [_, r, g, b] = rgb.to_be_bytes();
            renderer.set_field(&cover(blend, Srgb8([r, g, b])), &FieldChange::ALL);
            let picture = read(&mut renderer, &plain_view(8, 8), None);
            assert_eq!(picture.rgba, [r, g, b, 255].repeat(64), "{blend:?}");
        }
    }
}

#[test]
fn a_pixel_whose_centre_is_outside_takes_the_nearest_colour_inside() {
    let Some(mut renderer) = renderer(Rgba8Unorm) else { return };
    let corners = [[10.6, -50.0], [10.9, 10.0], [10.6, 70.0]];
    let grey = |level: f32| [level / 255.0, level / 255.0, level / 255.0, 1.0];
    let [dark, mid, light] = [100.0, 140.0, 180.0].map(grey);
    let colors = [dark, light, dark, mid, mid, dark];
    renderer.set_field(
        &Field { blend: Blend::Srgb, triangles: vec![FieldTriangle { corners, colors, side_edges: 7 }] },
        &FieldChange::ALL,
    );
    let picture = read(&mut renderer, &plain_view(20, 20), None);
    let [level, _, _, alpha] = pixel(&picture, 10, 10);
    assert!(level.abs_diff(100) <= 2 && alpha > 0 && alpha < 255, "{level} at {alpha}");
}

#[test]
fn large_pictures_are_put_together_from_tiles() {
    let Some(mut renderer) = renderer(Rgba8Unorm) else { return };
    let dot = |x: f32, y: f32| Shape {
        triangles: [[[x, y], [x + 8.0, y], [x, y + 8.0]]].into(),
        color: Rgba8([x as u8, y as u8, 9, 255]),
    };
    renderer.set_field(&cover(Blend::Oklab, Srgb8([230, 25, 75])), &FieldChange::ALL);
    renderer.set_shapes(Layer::Ink, &[dot(10.0, 20.0), dot(2047.0, 30.0), dot(2050.0, 2100.0)]);
    let picture = read(&mut renderer, &plain_view(2100, 2110), None);
    assert_eq!(pixel(&picture, 11, 21), [10, 20, 9, 255]);
    assert_eq!(pixel(&picture, 2047, 31), [255, 30, 9, 255]);
    assert_eq!(pixel(&picture, 2048, 31), [255, 30, 9, 255]);
    assert_eq!(pixel(&picture, 2051, 2101), [255, 255, 9, 255]);
    assert_eq!(pixel(&picture, 2099, 2109), [230, 25, 75, 255]);
}

/// A triangle at the top, from `x` px on.
fn dot(x: f32, color: [f32; 4]) -> FieldTriangle {
    FieldTriangle { corners: [[x, 0.0], [x + 8.0, 0.0], [x, 8.0]], colors: [color; 6], side_edges: 0 }
}

#[test]
fn triangles_that_have_changed_are_drawn_anew_also_beyond_the_first_buffer() {
    const LAST: usize = 600_000;
    let Some(mut renderer) = renderer(Rgba8Unorm) else { return };
    let [red, blue] = [[1.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0]];
    let mut field = Field { blend: Blend::Srgb, triangles: vec![FieldTriangle::default(); LAST + 1] };
    (field.triangles[0], field.triangles[LAST]) = (dot(0.0, red), dot(20.0, red));
    renderer.set_field(&field, &FieldChange::ALL);
    let mut seen = |field: &Field, places| {
        renderer.set_field(field, &FieldChange { places, within_du: None });
        let picture = read(&mut renderer, &plain_view(40, 10), None);
        [1, 21].map(|x| pixel(&picture, x, 1))
    };
    let [was, is] = [[255, 0, 0, 255], [0, 0, 255, 255]];
    assert_eq!(seen(&field, 0..0), [was, was]);
    (field.triangles[0], field.triangles[LAST]) = (dot(0.0, blue), dot(20.0, blue));
    assert_eq!(seen(&field, LAST..LAST + 1), [was, is], "the first one is not said to have changed");
    assert_eq!(seen(&field, 0..1), [is, is]);
    field.triangles.truncate(1);
    assert_eq!(seen(&field, 1..usize::MAX), [is, [0; 4]]);
}

#[test]
fn a_field_that_comes_in_slices_is_drawn_once_all_of_it_is_there() {
    const LAST: usize = 200_000;
    let Some(mut renderer) = renderer(Rgba8Unorm) else { return };
    let [red, green, blue] = [0, 1, 2].map(|i| [0, 1, 2, 3].map(|k| f32::from(k == i || k == 3)));
    let large = |color| {
        let mut triangles = vec![FieldTriangle::default(); LAST + 1];
        (triangles[0], triangles[LAST]) = (dot(0.0, color), dot(20.0, color));
        triangles
    };
    let mut field = Field { blend: Blend::Srgb, triangles: vec![dot(0.0, red)] };
    let mut seen = |field: &Field, places| {
        renderer.set_field_on(field, &FieldChange { places, within_du: None });
        let picture = read(&mut renderer, &plain_view(40, 10), None);
        (!renderer.awaits_field(), [1, 21].map(|x| pixel(&picture, x, 1)))
    };
    let [was, between, is] = [red, green, blue].map(|color| color.map(|c| (c * 255.0) as u8));
    let none = [0; 4];
    assert_eq!(seen(&field, 0..usize::MAX), (true, [was, none]), "one slice is enough");
    field.triangles = large(green);
    assert_eq!(seen(&field, 0..usize::MAX), (false, [was, none]));
    (field.triangles[0], field.triangles[LAST]) = (dot(0.0, blue), dot(20.0, blue));
    assert_eq!(seen(&field, 0..1), (false, [was, none]), "what has changed meanwhile goes along");
    for _ in 2..5 {
        assert_eq!(seen(&field, 0..0), (false, [was, none]));
    }
    assert_eq!(seen(&field, 0..0), (true, [is, is]), "the sixth slice is the last one");
    field.triangles[0] = dot(0.0, red);
    assert_eq!(seen(&field, 0..1), (true, [was, is]), "a small change comes at once");
    field.triangles = large(blue);
    for _ in 0..5 {
        assert_eq!(seen(&field, 0..usize::MAX), (false, [was, is]));
    }
    field.triangles = large(green);
    assert_eq!(seen(&field, 0..usize::MAX), (true, [between; 2]), "all at once, or it would never be there");
    field.triangles[LAST] = dot(20.0, red);
    assert_eq!(seen(&field, 0..usize::MAX), (false, [between; 2]));
    field.triangles.truncate(1);
    assert_eq!(seen(&field, 1..usize::MAX), (true, [between, none]), "what is gone need not come");
}

#[test]
fn what_is_set_again_replaces_what_was_there() {
    let Some(mut renderer) = renderer(Rgba8Unorm) else { return };
    let mut goldens = scenes::all();
    for golden in &goldens {
        drawn(&mut renderer, golden);
    }
    goldens.reverse();
    for golden in &goldens {
        assert_eq!(golden.differences(&drawn(&mut renderer, golden)), None);
    }
}
