//! What other programs show of an SVG, and what of the work is in it.

use crate::made::{Made, WHITE, assert_same};
use resvg::{tiny_skia, usvg};
use scumble_core::exact;
use scumble_export::{Look, RASTER_PX};
use scumble_io::{import_drawing, read_file, write_file};
use scumble_solve::Pixmap;

const LOOK: Look = Look { size_px: 800, lines: true, paper: Some(WHITE) };

/// What `resvg` makes of a document, so many times as large as it says.
fn shown_at(svg: &str, scale: f32) -> Pixmap {
    let tree = usvg::Tree::from_str(svg, &usvg::Options::default()).unwrap();
    let size = tree.size().to_int_size().scale_by(scale).unwrap();
    let mut pixmap = tiny_skia::Pixmap::new(size.width(), size.height()).unwrap();
    resvg::render(&tree, tiny_skia::Transform::from_scale(scale, scale), &mut pixmap.as_mut());
    let straight = pixmap.pixels().iter().map(|pixel| pixel.demultiply());
    let rgba = straight.flat_map(|c| [c.red(), c.green(), c.blue(), c.alpha()]).collect();
    Pixmap { width_px: size.width(), height_px: size.height(), rgba }
}

fn shown(svg: &str) -> Pixmap {
    shown_at(svg, 1.0)
}

#[test]
fn it_shows_the_same_larger_and_smaller() {
    for (name, made) in Made::all() {
        for scale in [0.75, 1.5] {
            let size_px = (800.0 * scale) as u32;
            let expected = made.painted(Look { size_px, ..LOOK });
            assert_same(&shown_at(&made.svg(LOOK), scale), &expected, 0.5, name);
        }
    }
}

#[test]
fn it_shows_what_the_painter_paints() {
    for (name, made) in Made::all() {
        for look in [LOOK, Look { lines: false, ..LOOK }, Look { paper: None, ..LOOK }] {
            assert_same(&shown(&made.svg(look)), &made.painted(look), 0.5, name);
        }
    }
}

#[test]
fn regions_of_one_colour_are_paths_alone_and_nothing_shines_through_between_them() {
    let made = Made::flat();
    let look = Look { lines: false, ..LOOK };
    assert!(made.export(look).raster_view().is_none());
    let svg = made.svg(look);
    assert!(!svg.contains("<image"));
    assert_eq!(svg.matches("<path").count(), 3, "two rooms, and the seam between them");
    let picture = shown(&svg);
    let row = 4 * (250 * picture.width_px as usize);
    let greens = picture.rgba[row + 4 * 300..row + 4 * 500].chunks(4).map(|pixel| pixel[1]);
    assert!(greens.max() <= Some(130), "no paper at the wall");
}

#[test]
fn a_fading_picture_without_paper_fades() {
    let look = Look { paper: None, ..LOOK };
    let [shown, painted] = [shown(&Made::fading().svg(look)), Made::fading().painted(look)];
    let alphas = |picture: &Pixmap| picture.rgba.chunks(4).map(|pixel| u64::from(pixel[3])).sum::<u64>();
    let pixels = u64::from(shown.width_px * shown.height_px);
    assert!(alphas(&shown).abs_diff(alphas(&painted)) < pixels / 2, "half a level of alpha");
    assert!(alphas(&shown) < 230 * pixels);
}

#[test]
fn pixels_have_a_limit() {
    let made = Made::fading();
    for (size_px, raster_px) in [(1, *RASTER_PX.start()), (3000, 3000), (16_384, *RASTER_PX.end())] {
        let view = made.export(Look { size_px, ..LOOK }).raster_view().unwrap();
        assert_eq!([view.width_px, view.height_px], [raster_px, raster_px * 3 / 4]);
    }
}

#[test]
fn the_work_in_it_opens_as_from_its_own_file() {
    for (name, made) in Made::all() {
        let (work, notes) = import_drawing(made.svg(LOOK).as_bytes()).unwrap();
        let kept = read_file(&write_file(&made.work).unwrap()).unwrap();
        assert_eq!((exact::write(&work), &*notes), (exact::write(&kept), ""), "{name}");
    }
}

#[test]
fn whatever_is_in_the_work_the_document_stays_sound() {
    let mut work = Made::flat().work;
    let odd = r#""odd": "<work> & ]]> \u0000 \ufffe""#.replace("\\ufffe", "\u{fffe}\u{ffff}");
    work.unknown.keep(scumble_core::work::Item::Work, 0, &odd);
    let made = Made { work, ..Made::flat() };
    let svg = made.svg(LOOK);
    usvg::Tree::from_str(&svg, &usvg::Options::default()).unwrap();
    let (opened, _) = import_drawing(svg.as_bytes()).unwrap();
    let fields = opened.unknown.of(scumble_core::work::Item::Work, 0);
    assert_eq!(fields, odd.replace("\u{fffe}\u{ffff}", "\\ufffe\\uffff"));
}

#[test]
fn what_is_no_size_is_not_written() {
    for sides in ["[\"40in\\\" x=\\\"\", \"30in\"]", "[\"4in\"]", "[\"4in\", \"4in\"]", "[4, 3]", "{}"] {
        let mut work = Made::flat().work;
        work.unknown.keep(scumble_core::work::Item::Work, 0, &["\"size\": ", sides].concat());
        let svg = Made { work, ..Made::flat() }.svg(Look { size_px: 384, ..LOOK });
        assert!(svg.contains(r#"width="384" height="288""#), "{sides}");
    }
}

#[test]
fn a_damaged_source_leaves_the_lines() {
    let svg = Made::shaded(Default::default()).svg(LOOK);
    for (from, to, message) in [
        ("\"points\"", "\"pints\"", "line"),
        ("\"version\": \"1.0\"", "\"version\": \"2.0\"", "newer"),
        ("\"format\"", "\"farmat\"", "not a Scumble file"),
    ] {
        let (work, notes) = import_drawing(svg.replacen(from, to, 1).as_bytes()).unwrap();
        let document = &work.document;
        assert_eq!(
            [document.drawing.curves.len(), document.drawing.fills.len(), document.scribbles.len()],
            [2, 0, 0]
        );
        assert!(notes.contains("without the scribbles") && notes.contains(message), "{notes}");
    }
}

#[test]
fn the_same_picture_is_the_same_bytes() {
    assert_eq!(Made::mixed().svg(LOOK), Made::mixed().svg(LOOK));
}
