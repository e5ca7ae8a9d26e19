//! Pictures of colouring scenes, from scribbles to pixels, beside those that somebody looked at and found right.
//!
//! A picture that differs is written where the message says. Where it is what a person would expect, it belongs in
//! `tests/coloring/`.

#[path = "../../../../tests/coloring/scenes.rs"]
mod scenes;

use std::fs::{self, File};
use std::io::{BufReader, BufWriter};
use std::path::{Path, PathBuf};

use kurbo::Affine;
use scenes::Coloring;
use scumble_core::{Document, EngineKind, Paint, Scribble, Srgb8};
use scumble_solve::{Picture, Pixmap, Scene, Shape, View, line_shapes, paint, scribble_shape};

const SIZE_PX: u32 = 256;

/// How far a picture may be from the one that was found right, in 8-bit levels of each channel.
const LEVELS: u8 = 2;

/// How much wider than a scribble its rim is drawn, in du.
const RIM_DU: f64 = 10.0;

fn painted(scene: &Coloring) -> Pixmap {
    let scribbles = scene.scribbles.clone();
    let document = Document { scribbles, settings: scene.settings, ..Document::new(scene.drawing()) };
    let mut picture = Picture::new(&document.drawing).expect("a map");
    let field = picture.update(&document).expect("a field").clone();
    let mut shapes = line_shapes(&document.drawing, Some(picture.map()), 0.1);
    shapes.extend(document.scribbles.iter().flat_map(rimmed));
    let px_from_du = Affine::scale(f64::from(SIZE_PX) / 1024.0);
    let view = View { px_from_du, width_px: SIZE_PX, height_px: SIZE_PX };
    paint(&Scene { paper: Some(Srgb8([255; 3])), field: &field, shapes: &shapes }, &view)
}

/// A scribble with a dark rim, to be seen on its own colour.
fn rimmed(scribble: &Scribble) -> [Shape; 2] {
    let rim = Paint::Color(Srgb8([60, 60, 60]));
    let wide = Scribble { color: rim, width_du: scribble.width_du + RIM_DU, ..scribble.clone() };
    [&wide, scribble].map(|scribble| scribble_shape(scribble, 255, 0.1))
}

/// Red, green and blue of each pixel; all pictures are opaque.
fn rgb(pixmap: &Pixmap) -> Vec<u8> {
    pixmap.rgba.as_chunks::<4>().0.iter().flat_map(|&[r, g, b, _]| [r, g, b]).collect()
}

fn read(path: &Path) -> Option<Vec<u8>> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path).ok()?)).read_info().ok()?;
    let mut rgb = vec![0; reader.output_buffer_size()?];
    reader.next_frame(&mut rgb).ok()?;
    Some(rgb)
}

fn write(path: &Path, rgb: &[u8]) {
    let mut encoder =
        png::Encoder::new(BufWriter::new(File::create(path).expect("a file")), SIZE_PX, SIZE_PX);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    encoder.write_header().expect("a header").write_image_data(rgb).expect("a picture");
}

/// Where a scene's picture differs from the one that was found right, if it does.
fn difference(scene: &Coloring, folder: &str) -> Option<String> {
    let file = format!("{}.png", scene.name);
    let found = rgb(&painted(scene));
    let right =
        read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/coloring").join(folder).join(&file));
    let same = |right: &Vec<u8>| {
        right.len() == found.len() && right.iter().zip(&found).all(|(a, b)| a.abs_diff(*b) <= LEVELS)
    };
    if right.as_ref().is_some_and(same) {
        return None;
    }
    let place: PathBuf = Path::new(env!("CARGO_TARGET_TMPDIR")).join(folder);
    fs::create_dir_all(&place).expect("a folder");
    write(&place.join(&file), &found);
    Some(format!("{}: see {}", scene.name, place.join(&file).display()))
}

fn assert_pictures(engine: EngineKind, folder: &str) {
    let scenes = scenes::all().into_iter().map(|scene| scene.by(engine));
    let scenes = scenes.filter(|scene| scene.is_known() && !scene.falls_short());
    let wrong: Vec<_> = scenes.filter_map(|scene| difference(&scene, folder)).collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn global_makes_the_pictures_that_were_found_right() {
    assert_pictures(EngineKind::Global, "global");
}

#[test]
fn progressive_makes_the_pictures_that_were_found_right() {
    assert_pictures(EngineKind::Progressive, "progressive");
}
