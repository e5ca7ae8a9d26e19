//! The samples that come coloured, as the program makes them, beside pictures that somebody looked at and found right:
//! one pixel a unit of the drawing, and a part of it eight times as large.
//!
//! A picture that differs is written where the message says. Where it is right, it belongs in `tests/samples/`.

use std::fs::{self, File};
use std::io::{BufReader, BufWriter};
use std::path::{Path, PathBuf};

use crate::folder::{Folder, stderr};

/// Longer side of either sample in its own units.
const SIDE: usize = 360;

/// Pixels of a unit in the larger picture.
const CLOSE: usize = 8;

/// How far a picture may be from the one that was found right, in 8-bit levels of each channel.
const LEVELS: u8 = 2;

struct Picture {
    width: usize,
    rgb: Vec<u8>,
}

fn read(path: &Path) -> Option<Picture> {
    let mut reader = png::Decoder::new(BufReader::new(File::open(path).ok()?)).read_info().ok()?;
    let mut pixels = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut pixels).ok()?;
    let rgb = pixels.chunks(info.color_type.samples()).flat_map(|pixel| pixel[..3].to_vec()).collect();
    Some(Picture { width: info.width as usize, rgb })
}

fn write(path: &Path, picture: &Picture) {
    let height = picture.rgb.len() / 3 / picture.width;
    let file = BufWriter::new(File::create(path).unwrap());
    let mut encoder = png::Encoder::new(file, picture.width as u32, height as u32);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    encoder.write_header().unwrap().write_image_data(&picture.rgb).unwrap();
}

/// A sample with its lines, at so many pixels a unit.
fn colored(name: &str, px_per_unit: usize) -> Picture {
    let samples = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../web/samples");
    let text = |extension: &str| fs::read_to_string(samples.join(format!("{name}.{extension}"))).unwrap();
    let folder = Folder::new(&format!("{name}-{px_per_unit}"));
    let folder = folder.with("d.svg", text("svg")).with("s.json", text("json"));
    let size = (SIDE * px_per_unit).to_string();
    let output =
        folder.run(&["color", "d.svg", "--scribbles", "s.json", "-o", "o.png", "--lines", "--size", &size]);
    assert!(output.status.success() && stderr(&output).is_empty(), "{}", stderr(&output));
    read(&folder.path().join("o.png")).unwrap()
}

/// The square of some pixels whose upper left corner is here.
fn part(picture: &Picture, [left, top]: [usize; 2], side: usize) -> Picture {
    let row = |y: usize| 3 * (y * picture.width + left);
    let rgb = (top..top + side).flat_map(|y| picture.rgb[row(y)..row(y) + 3 * side].to_vec()).collect();
    Picture { width: side, rgb }
}

fn assert_right(file: &str, found: &Picture) {
    let right = read(&Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/samples").join(file));
    let same = |right: &Picture| {
        right.rgb.len() == found.rgb.len()
            && right.rgb.iter().zip(&found.rgb).all(|(a, b)| a.abs_diff(*b) <= LEVELS)
    };
    if !right.as_ref().is_some_and(same) {
        let place = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(file);
        write(&place, found);
        panic!("see {}", place.display());
    }
}

/// `corner` is that of the part that is looked at closely, in units of the drawing.
fn assert_sample(name: &str, corner: [usize; 2]) {
    assert_right(&format!("{name}.png"), &colored(name, 1));
    let close = colored(name, CLOSE);
    assert_right(&format!("{name}-close.png"), &part(&close, corner.map(|x| CLOSE * x), SIDE));
}

#[test]
fn a_fruit_has_its_highlight() {
    assert_sample("pear", [88, 200]);
}

#[test]
fn a_sphere_has_its_core_shadow_and_its_rim_light() {
    assert_sample("sphere", [222, 150]);
}
