//! What other programs show of a PDF, and that it is sound.

use std::path::Path;
use std::process::Command;

use crate::made::{Made, WHITE, assert_same};
use miniz_oxide::inflate::decompress_to_vec_zlib;
use scumble_export::Look;
use scumble_io::write_png;
use scumble_solve::Pixmap;

const LOOK: Look = Look { size_px: 800, lines: true, paper: Some(WHITE) };

/// What poppler makes of a file; `None` where it is not installed.
fn shown(pdf: &[u8], name: &str) -> Option<Pixmap> {
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("{name}.pdf"));
    std::fs::write(&path, pdf).unwrap();
    let shown = path.with_extension("shown");
    let mut program = Command::new("pdftoppm");
    program.args(["-r", "96", "-png", "-singlefile"]).args([&path, &shown]);
    let Ok(output) = program.output() else {
        println!("skipped: pdftoppm is missing; on Debian it is in the package poppler-utils");
        return None;
    };
    assert_eq!(String::from_utf8_lossy(&output.stderr), "", "poppler has nothing to complain of");
    let file = std::fs::File::open(shown.with_extension("shown.png")).unwrap();
    let mut reader = png::Decoder::new(std::io::BufReader::new(file)).read_info().unwrap();
    let mut rgb = vec![0; reader.output_buffer_size().unwrap()];
    let info = reader.next_frame(&mut rgb).unwrap();
    let rgba = rgb.chunks(3).flat_map(|c| [c[0], c[1], c[2], 255]).collect();
    Some(Pixmap { width_px: info.width, height_px: info.height, rgba })
}

#[test]
fn it_shows_what_the_painter_paints() {
    for (name, made) in Made::all() {
        let looks = [LOOK, Look { lines: false, ..LOOK }, Look { paper: None, ..LOOK }];
        for (i, look) in looks.into_iter().enumerate() {
            let Some(shown) = shown(&made.export(look).pdf(), &format!("{name} {i}")) else { return };
            assert_same(&shown, &made.painted(look), 1.0, name);
        }
    }
}

#[test]
fn nothing_shines_through_between_regions() {
    let look = Look { lines: false, ..LOOK };
    for made in [Made::flat(), Made::mixed()] {
        let Some(picture) = shown(&made.export(look).pdf(), "seam") else { return };
        let row = 4 * (200 * picture.width_px as usize);
        let wall = picture.rgba[row + 4 * 395..row + 4 * 405].chunks(4);
        assert!(
            wall.clone().all(|pixel| pixel[..3].iter().min() < Some(&140)),
            "{:?}",
            wall.collect::<Vec<_>>()
        );
    }
}

#[test]
fn a_flat_one_is_smaller_than_its_picture() {
    let look = Look { size_px: 2048, ..LOOK };
    let made = Made::flat();
    let pixmap = made.painted(look);
    let png = write_png(pixmap.width_px, pixmap.height_px, &pixmap.rgba).unwrap();
    let pdf = made.export(look).pdf();
    assert!(5 * pdf.len() < png.len(), "{} bytes of PDF, {} of PNG", pdf.len(), png.len());
}

/// The objects that the table names, in its order.
fn objects(pdf: &[u8]) -> Vec<&[u8]> {
    let find =
        |from: usize, what: &[u8]| from + pdf[from..].windows(what.len()).position(|w| w == what).unwrap();
    let text = |range: std::ops::Range<usize>| std::str::from_utf8(&pdf[range]).unwrap();
    let end = pdf.len() - b"\n%%EOF\n".len();
    let start_line = pdf[..end].iter().rposition(|&b| b == b'\n').unwrap() + 1;
    let table: usize = text(start_line..end).parse().unwrap();
    assert!(pdf[table..].starts_with(b"xref\n0 "));
    let count_end = find(table + 7, b"\n");
    let count: usize = text(table + 7..count_end).parse().unwrap();
    let entry = |n: usize| count_end + 1 + 20 * n;
    assert!(pdf[entry(count)..].starts_with(b"trailer"));
    let object = |n: usize| {
        let offset: usize = text(entry(n)..entry(n) + 10).parse().unwrap();
        assert!(pdf[offset..].starts_with(format!("{n} 0 obj\n").as_bytes()));
        &pdf[offset..find(offset, b"\nendobj\n")]
    };
    (1..count).map(object).collect()
}

/// What is in a stream.
fn inflated(object: &[u8]) -> Option<Vec<u8>> {
    let start = object.windows(8).position(|w| w == b"\nstream\n")? + 8;
    let dictionary = std::str::from_utf8(&object[..start]).unwrap();
    let (_, length) = dictionary.split_once("/Length ").unwrap();
    let length: usize = length.split('>').next().unwrap().parse().unwrap();
    assert_eq!(&object[start + length..], b"\nendstream");
    Some(decompress_to_vec_zlib(&object[start..start + length]).unwrap())
}

#[test]
fn its_table_and_its_streams_are_sound() {
    for (name, made) in Made::all() {
        for paper in [None, Some(WHITE)] {
            let pdf = made.export(Look { paper, ..LOOK }).pdf();
            let objects = objects(&pdf);
            let streams: Vec<_> = objects.iter().filter_map(|object| inflated(object)).collect();
            let shadings =
                objects.iter().filter(|object| object.windows(14).any(|w| w == b"/ShadingType 4")).count();
            let expected = match (name, paper) {
                ("flat" | "lined", _) => 0,
                ("fading", None) => 2,
                _ => 1,
            };
            assert_eq!(shadings, expected, "{name}");
            assert!(streams.iter().all(|stream| !stream.is_empty()));
        }
    }
}

#[test]
fn the_same_picture_is_the_same_bytes() {
    assert_eq!(Made::mixed().export(LOOK).pdf(), Made::mixed().export(LOOK).pdf());
}
