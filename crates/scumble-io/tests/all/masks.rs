//! What masks leave of an SVG drawing: those of plain shapes are followed as clip paths are.

use kurbo::{BezPath, Point, Rect, Shape};
use scumble_core::{Curve, Drawing};
use scumble_io::{Import, import_svg};

/// Shapes on a page of 64 × 64, so that one page unit is 16 du.
fn on_page(shapes: &str) -> Import {
    let svg = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 64 64">{shapes}</svg>"#
    );
    import_svg(svg.as_bytes()).unwrap_or_else(|error| panic!("{error}: {svg}"))
}

/// A line across the page, and one down, in a group with the mask `m`.
const LINES: &str =
    r#"<g mask="url(#m)" fill="none" stroke="black"><path d="M0 16H64"/><path d="M32 0V64"/></g>"#;

/// A mask with a square from 8 to 24.
const MASK: &str = r#"<mask id="m" fill="white"><path d="M8 8h16v16h-16z"/></mask>"#;

fn bounds(path: &BezPath) -> [f64; 4] {
    let Rect { x0, y0, x1, y1 } = path.bounding_box();
    [x0, y0, x1, y1]
}

#[track_caller]
fn assert_bounds(drawing: &Drawing, expected: &[[f64; 4]]) {
    let found: Vec<_> = drawing.curves.iter().map(|curve| bounds(&curve.path)).collect();
    let is_close = |(a, b): (&[f64; 4], &[f64; 4])| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-2);
    let are_close = found.len() == expected.len() && found.iter().zip(expected).all(is_close);
    assert!(are_close, "{found:?} instead of {expected:?}");
}

/// The line across, and the one down, from end to end.
const WHOLE: [[f64; 4]; 2] = [[0.0, 256.0, 1024.0, 256.0], [512.0, 0.0, 512.0, 1024.0]];

#[test]
fn lines_end_where_a_mask_of_plain_shapes_does() {
    for mask in [
        MASK,
        // Figma
        r##"<mask id="m" style="mask-type:alpha" maskUnits="userSpaceOnUse" x="8" y="8" width="16" height="16">
            <rect x="8" y="8" width="16" height="16" fill="#D9D9D9"/></mask>"##,
        // Sketch
        r##"<defs><rect id="path-1" x="8" y="8" width="16" height="16"/></defs>
            <mask id="m" fill="white"><use xlink:href="#path-1"/></mask>"##,
        r#"<mask id="m" maskUnits="userSpaceOnUse" x="8" y="8" width="16" height="16"><path d="M0 0H64V64H0z" fill="white"/></mask>"#,
        r#"<style>.w{fill:#fff}</style><mask id="m"><g class="w"><path d="M8 8h8v16h-8z"/><path d="M16 8h8v16h-8z"/></g></mask>"#,
        r#"<mask id="m"><rect x="8" y="8" width="16" height="16" fill="white"/><path d="M0 0h64v64z" display="none"/></mask>"#,
        r##"<symbol id="s" viewBox="0 0 4 4" overflow="visible"><path d="M0 0h4v4h-4z"/></symbol>
            <mask id="m" fill="white"><g transform="translate(8)"><use href="#s" width="16" height="16" transform="translate(0 8)"/></g></mask>"##,
    ] {
        let import = on_page(&[mask, LINES].concat());
        assert_bounds(&import.drawing, &[[128.0, 256.0, 384.0, 256.0]]);
        assert!(import.notes.is_empty(), "{}: {mask}", import.notes);
    }
}

#[test]
fn a_shape_is_cut_where_a_mask_ends_and_hides_what_is_under_the_rest_of_it() {
    let under = r#"<path d="M0 16H64" stroke="black"/>"#;
    let disk = r#"<circle cx="24" cy="16" r="4" fill="gold" mask="url(#m)"/>"#;
    let drawing = on_page(&[MASK, under, disk].concat()).drawing;
    assert_bounds(
        &drawing,
        &[[320.0, 192.0, 384.0, 320.0], [0.0, 256.0, 320.0, 256.0], [384.0, 256.0, 1024.0, 256.0]],
    );
}

/// A mask as Figma has it around a stroke outside of its shape, a square of 16 at some place.
fn outside(name: &str, x: u32, region: &str) -> String {
    format!(
        r#"<mask id="{name}" maskUnits="userSpaceOnUse" {region} fill="black"><rect fill="white" {region}/>
        <path d="M{x} 8h16v16h-16z"/></mask>"#
    )
}

const PAGE: &str = r#"x="0" y="0" width="64" height="64""#;

const PART: &str = r#"x="4" y="4" width="40" height="40""#;

#[test]
fn what_is_black_upon_white_in_a_mask_is_hidden() {
    let first = [[0.0, 256.0, 128.0, 256.0], [384.0, 256.0, 640.0, 256.0], [896.0, 256.0, 1024.0, 256.0]];
    let below = [0.0, 768.0, 1024.0, 768.0];
    let in_part = [[64.0, 256.0, 128.0, 256.0], [384.0, 256.0, 640.0, 256.0]];
    for (region, expected) in [(PAGE, &[first.as_slice(), &[below]].concat()), (PART, &in_part.to_vec())] {
        let masks = [outside("m", 8, region), outside("n", 40, region)].concat();
        let line = r#"<path d="M0 16H64M0 48H64" fill="none" stroke="black" mask="url(#m)"/>"#;
        let import = on_page(&[&masks, r#"<g mask="url(#n)">"#, line, "</g>"].concat());
        assert_bounds(&import.drawing, expected);
        assert!(import.notes.is_empty(), "{region}");
    }
}

#[test]
fn what_is_black_under_white_in_a_mask_hides_nothing() {
    let mask = r#"<mask id="m"><path d="M0 0h64v64h-64z"/><path d="M8 8h16v16h-16z" fill="white"/></mask>"#;
    assert_bounds(&on_page(&[mask, LINES].concat()).drawing, &[[128.0, 256.0, 384.0, 256.0]]);
}

#[test]
fn ink_is_cut_by_what_is_black_in_a_mask() {
    for region in [PAGE, PART] {
        let band = r#"<path d="M6 6h20v20h-20z M10 10h12v12h-12z" fill-rule="evenodd" mask="url(#m)"/>"#;
        let drawing = on_page(&[&outside("m", 8, region), band].concat()).drawing;
        let [fill] = &*drawing.fills else { panic!("{:?}", drawing.fills) };
        let is_ink = |x: f64| fill.path.winding(Point::new(x * 16.0, 256.0)) % 2 != 0;
        assert_eq!(
            [5.0, 7.0, 9.0, 16.0, 23.0, 25.0, 27.0].map(is_ink),
            [false, true, false, false, false, true, false]
        );
    }
}

#[test]
fn a_mask_that_hides_all_is_ignored_and_counted() {
    let import = on_page(&[&MASK.replace("white", "black"), LINES].concat());
    assert_bounds(&import.drawing, &WHOLE);
    assert_eq!(import.notes.to_string(), "left out: 1 mask");
}

#[test]
fn a_mask_moves_with_what_it_masks() {
    let masked =
        r#"<g transform="translate(8 0)" mask="url(#m)"><path d="M-8 16H56M0 8V64" stroke="black"/></g>"#;
    let import = on_page(&[MASK, masked].concat());
    assert_bounds(&import.drawing, &[[256.0, 256.0, 512.0, 256.0]]);
}

#[test]
fn masks_and_clip_paths_hide_what_either_does() {
    let clip = r#"<clipPath id="c"><rect x="16" width="32" height="64"/></clipPath>"#;
    let import = on_page(&[clip, MASK, &LINES.replace("fill=", r#"clip-path="url(#c)" fill="#)].concat());
    assert_bounds(&import.drawing, &[[256.0, 256.0, 384.0, 256.0]]);
    let second = MASK.replace("M8 8", "M16 8").replace("\"m\"", "\"n\"");
    let import = on_page(&[&second, MASK, r#"<g mask="url(#n)">"#, LINES, "</g>"].concat());
    assert_bounds(&import.drawing, &[[256.0, 256.0, 384.0, 256.0]]);
}

/// What is no clip path, in a mask that is white elsewhere.
const MORE_THAN_SHAPES: [&str; 14] = [
    r#"<path d="M8 8h8v8z" fill="gray"/>"#,
    r#"<path d="M8 8h8v8z" fill="black"/><path d="M8 8h8v8z"/>"#,
    r#"<path d="M8 8h8v8z" fill-opacity="0.5"/>"#,
    r#"<path d="M8 8h8v8z" stroke="white"/>"#,
    r#"<path d="M8 8h8v8z" fill="none" stroke="white"/>"#,
    r#"<g opacity="0.5"><path d="M8 8h8v8z"/></g>"#,
    r#"<g style="mix-blend-mode:difference"><path d="M8 8h8v8z"/></g>"#,
    r##"<linearGradient id="g"><stop stop-color="white"/><stop offset="1"/></linearGradient><path d="M8 8h8v8z" fill="url(#g)"/>"##,
    r#"<path d="M8 8h8v8z" clip-path="url(#c)"/>"#,
    r#"<path d="M8 8h8v8z" mask="url(#plain)"/>"#,
    r##"<use href="#masked"/>"##,
    r#"<path d="M8 8h8v8z" filter="url(#f)"/>"#,
    r#"<image href="a.png" width="8" height="8"/>"#,
    "<text>A</text>",
];

#[test]
fn masks_that_are_more_than_shapes_are_ignored_and_counted() {
    let others = r#"<mask id="plain"><path d="M0 0h9v9z" fill="white"/></mask>
        <defs><path id="masked" d="M8 8h8v8z" mask="url(#plain)"/></defs><clipPath id="c"><path d="M8 8h8v8z"/></clipPath>"#;
    for content in MORE_THAN_SHAPES {
        let mask =
            format!(r#"{others}<mask id="m" fill="white"><path d="M8 24h16v8h-16z"/>{content}</mask>"#);
        let import = on_page(&[&mask, LINES].concat());
        assert_bounds(&import.drawing, &WHOLE);
        assert_eq!(import.notes.masks, 1, "{content}");
    }
    for alpha in [
        r#"<path d="M8 8h8v8z" fill="gray" fill-opacity="0.5"/>"#,
        r#"<path d="M8 8h8v8z" stroke="red"/>"#,
        r##"<path d="M8 8h8v8z" fill="#00000080"/>"##,
    ] {
        let mask = format!(r#"<mask id="m" style="mask-type:alpha">{alpha}</mask>"#);
        let import = on_page(&[&mask, LINES].concat());
        assert_bounds(&import.drawing, &WHOLE);
        assert_eq!(import.notes.to_string(), "left out: 1 mask", "{alpha}");
    }
}

#[test]
fn masks_that_are_followed_are_not_counted_beside_others() {
    let gray = r#"<mask id="n" fill="gray"><path d="M8 8h16v16h-16z"/></mask>"#;
    let gradient =
        r#"<linearGradient id="g"/><mask id="n"><path d="M8 8h16v16h-16z" fill="url(#g)"/></mask>"#;
    for other in [gray, gradient] {
        let line = r#"<path d="M0 48H64V49" fill="none" stroke="black" mask="url(#n)"/>"#;
        let import = on_page(&[MASK, other, LINES, line].concat());
        assert_bounds(&import.drawing, &[[128.0, 256.0, 384.0, 256.0], [0.0, 768.0, 1024.0, 784.0]]);
        assert_eq!(import.notes.to_string(), "left out: 1 mask", "{other}");
    }
}

#[test]
fn what_is_masked_by_something_else_than_a_mask_is_shown() {
    for value in ["url(#none)", "url(#p)", "none", "url()", "?"] {
        let lines = LINES.replace("url(#m)", value);
        let import = on_page(&[r#"<defs><path id="p" d="M0 0h9v9z"/></defs>"#, &lines].concat());
        assert_bounds(&import.drawing, &WHOLE);
    }
}

#[test]
fn masks_in_styles_are_ignored_and_counted() {
    for (sheet, attribute) in [
        ("", r#"style="mask:url(#m)""#),
        ("", r#"style="mask : url(#m)""#),
        ("<style>.a{mask:url(#m)}</style>", r#"class="a""#),
        ("<style>.a{mask:url(#m)}</style>", r#"mask="url(#m)""#),
        ("<style>path{mask:inherit}</style>", r#"mask="url(#m)""#),
    ] {
        let lines = LINES.replace(r#"mask="url(#m)""#, attribute);
        let import = on_page(&[sheet, MASK, &lines].concat());
        assert_bounds(&import.drawing, &WHOLE);
        assert_eq!(import.notes.to_string(), "left out: 1 mask", "{attribute}");
    }
}

/// Nothing can be told by the size of such a line.
#[test]
fn masks_in_units_of_a_line_without_height_are_ignored_and_counted() {
    let content = r#"<mask id="m" maskUnits="userSpaceOnUse" maskContentUnits="objectBoundingBox"><path d="M0 0h1v1h-1z" fill="white"/></mask>"#;
    for mask in [MASK, content] {
        let line = r#"<path d="M0 16H64" stroke="black" mask="url(#m)"/>"#;
        let import = on_page(&[mask, line].concat());
        assert_bounds(&import.drawing, &WHOLE[..1]);
        assert_eq!(import.notes.masks, 1, "{mask}");
    }
}

#[test]
fn ink_is_cut_by_a_mask() {
    let drawing = on_page(&[MASK, r#"<circle cx="24" cy="16" r="6" mask="url(#m)"/>"#].concat()).drawing;
    let [fill] = &*drawing.fills else { panic!("{:?}", drawing.fills) };
    let is_ink = |x: f64, y: f64| fill.path.winding(Point::new(x * 16.0, y * 16.0)) % 2 != 0;
    assert!(is_ink(22.0, 16.0) && !is_ink(26.0, 16.0));
    assert!(drawing.curves.iter().all(|Curve { line, .. }| line.is_none()));
}
