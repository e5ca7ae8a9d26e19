//! Pictures to trace: what is taken as one, what is said of one that is not, and how files keep them.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use scumble_core::work::Item;
use scumble_core::{Tracing, Work};
use scumble_io::{
    FILE_IMAGE, FileError, ImageError, ImportError, MAX_FILE_BYTES, MAX_IMAGE_BYTES, check_image,
    import_drawing, read_file, write_file, write_png, write_svg_source,
};

const PNG: &[u8] = include_bytes!("../foreign/sketch.png");
const JPEG: &[u8] = include_bytes!("../foreign/sketch.jpg");

/// The same bytes with others from a place on.
fn with(bytes: &[u8], at: usize, others: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    bytes[at..at + others.len()].copy_from_slice(others);
    bytes
}

/// A PNG with another head, as somebody hostile would write it.
fn with_head(at: usize, others: &[u8]) -> Vec<u8> {
    let head = with(&PNG[12..29], at, others);
    let mut rest = !0_u32;
    for byte in &head {
        rest ^= u32::from(*byte);
        (0..8).for_each(|_| rest = (rest >> 1) ^ (0xedb8_8320 * (rest & 1)));
    }
    [&PNG[..12], &head, &(!rest).to_be_bytes(), &PNG[33..]].concat()
}

/// Where a JPEG says how large it is: behind the marker of its frame.
fn frame(jpeg: &[u8]) -> usize {
    jpeg.windows(2).position(|pair| pair == [0xff, 0xc0]).unwrap()
}

#[track_caller]
fn damaged(bytes: &[u8]) {
    assert!(matches!(check_image(bytes), Err(ImageError::Damaged(_))), "{:?}", check_image(bytes));
}

#[test]
fn png_and_jpeg_are_taken_with_what_others_put_behind_them() {
    for image in [PNG, JPEG, &write_png(3, 2, &[9; 24]).unwrap()] {
        assert_eq!(check_image(image), Ok(()));
        assert_eq!(check_image(&[image, b"and more"].concat()), Ok(()));
    }
}

#[test]
fn what_is_cut_off_is_damaged_wherever_that_is() {
    for image in [PNG, JPEG] {
        for end in 8..image.len() {
            damaged(&image[..end]);
        }
        for end in 0..3 {
            assert_eq!(check_image(&image[..end]), Err(ImageError::NoImage));
        }
    }
}

#[test]
fn sizes_are_read_before_anything_is_made_of_them() {
    let size = |width_px, height_px| Err(ImageError::TooManyPixels { width_px, height_px });
    assert_eq!(check_image(&with_head(4, &[0, 0, 0x40, 1])), size(16_385, 16));
    assert_eq!(check_image(&with_head(4, &[0, 0, 0x40, 0, 0, 0, 0x40, 0])), size(16_384, 16_384));
    assert_eq!(check_image(&with_head(4, &[0xff; 8])), size(u32::MAX, u32::MAX));
    assert_eq!(check_image(&with(JPEG, frame(JPEG) + 5, &[0x40, 0, 0x40, 0])), size(16_384, 16_384));
    damaged(&with_head(4, &[0; 8]));
    damaged(&with(JPEG, frame(JPEG) + 5, &[0; 4]));
}

#[test]
fn a_png_of_which_a_bit_was_changed_is_damaged() {
    for (at, byte) in PNG.iter().enumerate() {
        assert!(check_image(&with(PNG, at, &[byte ^ 4])).is_err(), "byte {at}");
    }
}

#[test]
fn heads_that_say_no_size_are_damaged() {
    damaged(&with_head(0, b"IHDX"));
    damaged(&with(JPEG, frame(JPEG), &[0xff, 0xe3]));
    damaged(&with(JPEG, frame(JPEG), &[0, 0]));
    damaged(&with(JPEG, frame(JPEG) + 2, &[0, 0]));
}

#[test]
fn other_pictures_are_called_by_their_names() {
    for (bytes, name) in [
        (&b"GIF89a....."[..], "GIF"),
        (b"RIFF\x10\0\0\0WEBPVP8 ", "WebP"),
        (b"II*\0........", "TIFF"),
        (b"\0\0\0\x18ftypheic....", "HEIC"),
        (b"\0\0\0\x18ftypavif....", "AVIF"),
    ] {
        assert_eq!(check_image(bytes), Err(ImageError::OtherKind(name)));
    }
    assert_eq!(check_image(b""), Err(ImageError::NoImage));
    assert_eq!(check_image(&vec![0xff; MAX_IMAGE_BYTES + 1]), Err(ImageError::TooLarge));
}

/// A file with a picture under the lines, as somebody else may write it.
fn file(image: &str, more: &str) -> String {
    format!(
        r#"{{"format": "scumble", "version": "1.1", "canvas": [0, 0, 9, 9], "tracing_image": "{image}"{more}}}"#
    )
}

/// 67 bytes, which end in padding: one pixel.
const DOT: &str =
    "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR4nGNoAAAAggCBd81ytgAAAABJRU5ErkJggg==";

#[test]
fn a_file_says_where_a_picture_lies_and_how_faded() {
    let work = read_file(file(DOT, "").as_bytes()).unwrap();
    assert_eq!(work.document.tracing, Some(Tracing::faded(FILE_IMAGE)));
    assert_eq!((work.image.len(), check_image(&work.image)), (67, Ok(())));
    for (opacity, expected) in [("0.25", 0.25), ("-1", 0.0), ("7", 1.0)] {
        let work = read_file(file(DOT, &format!(", \"tracing_opacity\": {opacity}")).as_bytes()).unwrap();
        assert_eq!(work.document.tracing, Some(Tracing { image: FILE_IMAGE, opacity: expected }));
    }
    let slashed = file(&DOT.replace('/', "\\/"), "");
    assert_eq!(read_file(slashed.as_bytes()).unwrap().image, work.image);
    let written = String::from_utf8(write_file(&work).unwrap()).unwrap();
    assert!(
        written.contains(&format!("\"tracing_opacity\": 0.5,\n\"tracing_image\": \"{DOT}\"")),
        "{written}"
    );
}

#[test]
fn only_files_with_a_picture_need_a_reader_of_version_1_1() {
    let mut work = read_file(file(DOT, "").as_bytes()).unwrap();
    let version =
        |work: &Work| String::from_utf8(write_file(work).unwrap()).unwrap().contains("\"version\": \"1.1\"");
    assert!(version(&work));
    work.image.clear();
    assert!(!version(&work));
    let opacity_alone =
        r#"{"format": "scumble", "version": "1.1", "canvas": [0, 0, 9, 9], "tracing_opacity": 0.5}"#;
    assert_eq!(read_file(opacity_alone.as_bytes()).unwrap().document.tracing, None);
}

#[test]
fn a_picture_that_an_older_page_kept_as_unknown_comes_back_unless_there_is_another() {
    let mut kept = read_file(file(DOT, "").as_bytes()).unwrap();
    let dot = std::mem::take(&mut kept.image);
    kept.document.tracing = None;
    let field = format!("\"tracing_opacity\": 1,\"tracing_image\": \"{DOT}\"");
    kept.unknown.keep(Item::Work, 0, &field);
    let read_again = |work: &Work| {
        let work = read_file(&write_file(work).unwrap()).unwrap();
        (work.image, work.document.tracing)
    };
    assert_eq!(read_again(&kept), (dot, Some(Tracing { image: FILE_IMAGE, opacity: 1.0 })));
    kept.image = JPEG.to_vec();
    kept.document.tracing = Some(Tracing::faded(2));
    assert_eq!(read_again(&kept), (JPEG.to_vec(), Some(Tracing::faded(FILE_IMAGE))));
}

#[test]
fn a_file_with_a_damaged_picture_is_refused_with_its_line() {
    let pixels = with_head(4, &[0xff; 8]);
    let too_large = "A".repeat(MAX_IMAGE_BYTES / 3 * 4 + 8);
    for bad in [
        "",
        "iVBO",
        &DOT[..DOT.len() - 4],
        &DOT[..DOT.len() - 1],
        &DOT.replace('B', "*"),
        &too_large,
        &text(&pixels),
    ] {
        let error = read_file(file(bad, "").replace(", \"tracing", ",\n\"tracing").as_bytes()).unwrap_err();
        assert!(matches!(error, FileError::Damaged { line: 2, .. }), "{error}");
        assert!(error.to_string().contains("PNG or JPEG"), "{error}");
    }
}

/// Base64 with padding, the slow way.
fn text(bytes: &[u8]) -> String {
    let digits = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let bits: Vec<_> =
        bytes.iter().flat_map(|byte| (0..8).rev().map(move |bit| usize::from(byte >> bit & 1))).collect();
    let digit = |bits: &[usize]| {
        let value = (0..6).fold(0, |value, i| value << 1 | bits.get(i).copied().unwrap_or_default());
        char::from(digits[value])
    };
    let text: String = bits.chunks(6).map(digit).collect();
    let padding = "=".repeat((4 - text.len() % 4) % 4);
    text + &padding
}

#[test]
fn an_exported_svg_does_not_give_the_picture_away() {
    let work = read_file(file(DOT, "").as_bytes()).unwrap();
    let source = write_svg_source(&work).unwrap();
    assert!(!source.contains("tracing"), "{source}");
}

#[test]
fn an_exported_svg_opens_however_large_its_picture_is() {
    let work = read_file(file(DOT, "").as_bytes()).unwrap();
    let source = write_svg_source(&work).unwrap();
    let svg = |picture_bytes: usize| {
        let picture = " ".repeat(picture_bytes);
        format!("<svg xmlns=\"http://www.w3.org/2000/svg\">\n{source}{picture}</svg>\n")
    };
    let [small, large] = [0, MAX_FILE_BYTES].map(|picture_bytes| {
        let (opened, notes) = import_drawing(svg(picture_bytes).as_bytes()).unwrap();
        assert_eq!(notes, "");
        write_file(&opened).unwrap()
    });
    assert!(small == large);
    let foreign = svg(MAX_FILE_BYTES).replace("urn:scumble:1", "urn:scumble:none");
    assert_eq!(import_drawing(foreign.as_bytes()).unwrap_err(), ImportError::TooLarge);
}
