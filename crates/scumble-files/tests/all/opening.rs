//! What the page can open, and what it makes of it.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use kurbo::Point;
use scumble_core::{Paint, Scribble, ScribbleKind, Srgb8, Tracing, Work, exact};
use scumble_files::opening::{self, Content, OpenError};
use scumble_io::{ImageError, read_link, write_file, write_link};

const SVG: &[u8] = br#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 512 384">
    <path d="M100 75H340V315H100Z" stroke="black" fill="none"/><text>left out</text></svg>"#;

/// The work in a file, and what was left out.
fn work(file: &[u8]) -> (Work, String) {
    match opening::file(file, "").unwrap() {
        Content::Work(work, notes) => (*work, notes),
        Content::Palette(..) | Content::Image => panic!("work"),
    }
}

fn scribbled() -> Work {
    let mut work = work(SVG).0;
    work.document.scribbles.push(Scribble {
        color: Srgb8([1, 2, 3]).into(),
        kind: ScribbleKind::Fill,
        width_du: 4.0,
        points: vec![Point::new(200.0, 200.0), Point::new(210.0, 200.0)],
    });
    work
}

#[test]
fn an_svg_opens_with_a_word_about_what_was_left_out() {
    let (work, notes) = work(SVG);
    assert_eq!(work.document.drawing.curves.len(), 1);
    assert_eq!(notes, "left out: 1 text");
}

#[test]
fn what_was_saved_opens_as_it_was_whatever_stands_before_it() {
    let file = write_file(&scribbled()).unwrap();
    for before in ["", "\u{feff}", "\n "] {
        let (work, notes) = work(&[before.as_bytes(), &file].concat());
        assert_eq!(write_file(&work).unwrap(), file);
        assert_eq!(notes, "");
    }
}

#[test]
fn a_file_that_could_not_be_opened_again_is_not_saved() {
    let png = include_bytes!("../../../scumble-io/tests/foreign/sketch.png");
    let traced = || {
        let mut work = scribbled();
        work.document.tracing = Some(Tracing::faded(7));
        work
    };
    for image in [&png[..], &[]] {
        let file = opening::file_of(traced(), image.to_vec()).unwrap();
        assert_eq!(work(&file).0.image, image);
    }
    let saved = opening::file_of(traced(), png[..png.len() - 1].to_vec());
    assert!(matches!(saved, Err(OpenError::Image(ImageError::Damaged(_)))));
}

#[test]
fn a_palette_is_no_work() {
    let Ok(Content::Palette(swatches, notes)) = opening::file(b"#010203\n#ffffff\n", "") else {
        panic!("a palette")
    };
    let expected = [[1, 2, 3], [255; 3]].map(|rgb| Paint::Color(Srgb8(rgb)).into());
    assert_eq!((swatches, &*notes), (expected.to_vec(), ""));
    assert!(matches!(opening::file(b"#010203\nblue", ""), Err(OpenError::Palette(_))));
}

#[test]
fn diffusion_curves_open_with_their_colours() {
    let curves = r#"<curve_set image_width="9" image_height="9"><curve><control_points_set><p x="1" y="1"/><p x="1" y="2"/>
        <p x="1" y="3"/><p x="1" y="4"/></control_points_set><left_colors_set><c R="1" G="2" B="3" globalID="0"/>
        </left_colors_set><blur_points_set><b value="1" globalID="0"/></blur_points_set></curve></curve_set>"#;
    let (work, notes) = work(curves.as_bytes());
    assert_eq!((work.document.color_points.len(), &*notes), (1, "left out: 1 curve’s blur"));
}

#[test]
fn what_is_neither_is_an_error_of_the_kind_that_it_looks_like() {
    assert!(matches!(opening::file(b"{}", ""), Err(OpenError::File(_))));
    assert!(matches!(opening::file(b"<html/>", ""), Err(OpenError::Drawing(_))));
    assert!(matches!(opening::exact(b"{}"), Err(OpenError::Damaged)));
}

#[test]
fn what_does_not_tell_what_it_is_is_what_its_name_says() {
    let refused = |bytes: &[u8], name| opening::file(bytes, name).expect_err(name);
    for name in ["sea.gpl", "SEA.GPL", "a.b.ase", "sea.hex"] {
        assert!(matches!(refused(b"sea\n", name), OpenError::Palette(_)), "{name}");
        assert!(matches!(refused(b"\xff\0", name), OpenError::Palette(_)), "{name}");
    }
    assert!(matches!(refused(b"sea", "sea.scumble"), OpenError::File(_)));
    for name in ["sea.png", "sea.jpg", "sea.JPEG"] {
        assert_eq!(refused(b"sea", name), OpenError::Image(ImageError::NoImage));
    }
    assert!(matches!(refused(b"sea", "sea.svg"), OpenError::Drawing(_)));
    assert!(matches!(refused(b"sea", "gpl"), OpenError::Drawing(_)));
    assert_eq!(work(SVG).0.document.drawing.curves.len(), 1);
    assert!(matches!(opening::file(SVG, "sea.png"), Ok(Content::Work(..))), "its beginning tells more");
}

#[test]
fn pictures_to_trace_are_taken_where_they_are_whole() {
    let png = scumble_io::write_png(3, 2, &[9; 24]).unwrap();
    assert!(matches!(opening::file(&png, "sea.svg"), Ok(Content::Image)));
    let cut_off = opening::file(&png[..40], "sea.png").expect_err("cut off");
    assert!(matches!(cut_off, OpenError::Image(ImageError::Damaged(_))));
    let other = opening::file(b"GIF89a", "sea").expect_err("a GIF");
    assert_eq!(other, OpenError::Image(ImageError::OtherKind("GIF")));
}

#[test]
fn work_on_a_sample_goes_into_a_link_without_its_lines_and_gets_them_again() {
    let work = Work { sample: Some("square.svg".into()), ..scribbled() };
    assert_eq!(opening::lacking_sample(&work), None);
    let linked = read_link(&write_link(&work).unwrap().fragment).unwrap();
    assert_eq!(opening::lacking_sample(&linked).as_deref(), Some("square.svg"));
    let whole = opening::on_sample(linked, self::work(SVG).0);
    assert_eq!(exact::write(&whole), exact::write(&work));
}
