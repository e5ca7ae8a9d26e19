//! What an SVG drawing becomes.

use kurbo::{BezPath, Cap, Join, ParamCurveArclen, PathEl, Point, Rect, Shape};
use scumble_core::{Curve, Rgba8};
use scumble_io::{Import, import_svg};

fn import(svg: &str) -> Import {
    import_svg(svg.as_bytes()).unwrap_or_else(|error| panic!("{error}: {svg}"))
}

/// Shapes on a page of 64 × 64, so that one page unit is 16 du.
fn on_page(shapes: &str) -> Import {
    import(&format!(r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 64 64">{shapes}</svg>"#))
}

fn stroked(shapes: &str) -> Vec<Curve> {
    on_page(&format!(r#"<g fill="none" stroke="black">{shapes}</g>"#)).drawing.curves
}

fn bounds(path: &BezPath) -> [f64; 4] {
    let Rect { x0, y0, x1, y1 } = path.bounding_box();
    [x0, y0, x1, y1]
}

#[track_caller]
fn assert_close(values: [f64; 4], expected: [f64; 4]) {
    let close = values.iter().zip(expected).all(|(value, expected)| (value - expected).abs() < 1e-3);
    assert!(close, "{values:?} instead of {expected:?}");
}

#[test]
fn a_stroke_becomes_its_centre_line_with_its_look() {
    let import = on_page(
        r##"<path d="M 8 8 L 24 8" fill="none" stroke="#ff8000" stroke-opacity="0.5" stroke-width="2" stroke-linecap="round"
            stroke-linejoin="bevel" stroke-dasharray="3 1" stroke-dashoffset="0.5"/>"##,
    );
    let [curve] = &*import.drawing.curves else { panic!("one curve") };
    assert_eq!(curve.path, BezPath::from_svg("M 128 128 L 384 128").unwrap());
    let line = curve.line.as_ref().unwrap();
    assert_eq!(line.color, Rgba8([0xff, 0x80, 0, 128]));
    assert_eq!(line.stroke.width, 32.0);
    assert_eq!(
        (line.stroke.start_cap, line.stroke.end_cap, line.stroke.join),
        (Cap::Round, Cap::Round, Join::Bevel)
    );
    assert_eq!((&*line.stroke.dash_pattern, line.stroke.dash_offset), (&[48.0, 16.0][..], 8.0));
    assert!(import.notes.is_empty());
}

#[test]
fn every_subpath_is_one_curve() {
    let curves = stroked(r#"<path d="M1 1h4 M2 2h4v4z l 8 8 M9 9"/>"#);
    let paths: Vec<_> = curves.iter().map(|curve| curve.path.to_svg()).collect();
    assert_eq!(paths, ["M16,16 L80,16", "M32,32 L96,32 L96,96 Z", "M32,32 L160,160"]);
    for curve in &curves {
        let elements = curve.path.elements();
        assert!(matches!(elements[0], PathEl::MoveTo(_)));
        assert!(elements[1..].iter().all(|el| !matches!(el, PathEl::MoveTo(_) | PathEl::QuadTo(..))));
    }
}

#[test]
fn a_subpath_that_is_closed_where_it_starts_is_no_part_of_the_next() {
    let [curve] = &*stroked(r#"<path d="M 8 8 Z C 9 8 10 9 10 10"/>"#) else { panic!("one curve") };
    assert_eq!(curve.path, BezPath::from_svg("M 128 128 C 144 128 160 144 160 160").unwrap());
}

#[test]
fn quadratics_and_arcs_become_cubics() {
    let curves = stroked(r#"<path d="M8 8 Q 16 0 24 8"/><path d="M 8 32 A 8 8 0 0 1 24 32"/>"#);
    assert_close(bounds(&curves[0].path), [128.0, 64.0, 384.0, 128.0]);
    assert_close(bounds(&curves[1].path), [128.0, 384.0, 384.0, 512.0]);
    assert!(matches!(curves[0].path.elements()[1], PathEl::CurveTo(..)));
}

#[test]
fn every_basic_shape_is_a_curve() {
    let curves = stroked(
        r#"<rect x="8" y="8" width="16" height="8"/><rect x="8" y="8" width="16" height="8" rx="2"/>
           <circle cx="32" cy="32" r="8"/><ellipse cx="32" cy="32" rx="8" ry="4"/>
           <line x1="8" y1="8" x2="16" y2="24"/><polyline points="8,8 16,8 16,16"/><polygon points="8,8 16,8 16,16"/>"#,
    );
    let expected = [
        [128.0, 128.0, 384.0, 256.0],
        [128.0, 128.0, 384.0, 256.0],
        [384.0, 384.0, 640.0, 640.0],
        [384.0, 448.0, 640.0, 576.0],
        [128.0, 128.0, 256.0, 384.0],
        [128.0, 128.0, 256.0, 256.0],
        [128.0, 128.0, 256.0, 256.0],
    ];
    assert_eq!(curves.len(), expected.len());
    for (curve, expected) in curves.iter().zip(expected) {
        assert_close(bounds(&curve.path), expected);
    }
    let is_closed = |curve: &Curve| curve.path.elements().last() == Some(&PathEl::ClosePath);
    assert_eq!(
        curves.iter().map(is_closed).collect::<Vec<_>>(),
        [true, true, true, true, false, false, true]
    );
}

#[test]
fn transforms_move_curves_and_scale_widths() {
    let curves = stroked(
        r#"<g transform="translate(8 0)"><g transform="scale(2 0.5)"><line x1="0" y1="8" x2="8" y2="8" stroke-width="3"/></g></g>
           <line x2="8" transform="rotate(90) scale(2)"/>"#,
    );
    assert_close(bounds(&curves[0].path), [128.0, 64.0, 384.0, 64.0]);
    let width = |i: usize| curves[i].line.as_ref().unwrap().stroke.width;
    assert!((width(0) - 48.0).abs() < 1e-3, "the square root of 2 × 0.5 is 1");
    assert_close(bounds(&curves[1].path), [0.0, 0.0, 0.0, 256.0]);
    assert!((width(1) - 32.0).abs() < 1e-3);
}

#[test]
fn use_symbols_styles_and_units_are_resolved() {
    let import = import(
        r##"<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" viewBox="0 0 64 64">
            <style>/* classes */ .pen { stroke: #123456; fill: none } g > .wide { stroke-width: 2px }</style>
            <defs><path id="p" d="M0 0h8"/></defs>
            <symbol id="s" viewBox="0 0 8 8"><path d="M0 4h8" class="pen"/></symbol>
            <g class="pen"><use href="#p" x="8" y="8"/><use xlink:href="#p" class="wide" transform="translate(0 32)"/></g>
            <use href="#s" width="16" height="16"/>
            <line x2="1in" y1="50%" y2="50%" style="stroke: green"/>
        </svg>"##,
    );
    let curves = import.drawing.curves;
    assert_eq!(curves.len(), 4);
    assert_close(bounds(&curves[0].path), [128.0, 128.0, 256.0, 128.0]);
    assert_close(bounds(&curves[1].path), [0.0, 512.0, 128.0, 512.0]);
    assert_close(bounds(&curves[2].path), [0.0, 128.0, 256.0, 128.0]);
    assert_close(bounds(&curves[3].path), [0.0, 512.0, 96.0 * 16.0, 512.0]);
    let line = curves[1].line.as_ref().unwrap();
    assert_eq!((line.stroke.width, line.color), (32.0, Rgba8([0x12, 0x34, 0x56, 255])));
}

#[test]
fn a_dark_area_is_ink_with_an_outline() {
    let import = on_page(r##"<path d="M8 8h16v16z M32 8h8v8z" fill="#202020" fill-rule="evenodd"/>"##);
    assert_eq!(import.drawing.curves.len(), 2);
    assert!(import.drawing.curves.iter().all(|curve| curve.line.is_none()));
    let [fill] = &*import.drawing.fills else { panic!("one fill") };
    assert_eq!((fill.color, fill.even_odd), (Rgba8([0x20, 0x20, 0x20, 255]), true));
    assert_eq!(fill.path.segments().count(), 6);
}

#[test]
fn a_dark_area_with_a_hue_is_ink_if_it_is_as_thin_as_a_line() {
    // On a page of 64 units, 1024 du.
    for (path, is_ink) in [
        ("M8 8h32v1h-32z", true),
        ("M8 8h32v32h-32z", false),
        ("M8 8h32v32h-32z M9 9h30v30h-30z", true),
        ("M8 8h32v32h-32z M20 20h4v4h-4z", false),
        ("M24 8a16 16 0 0 1 0 32a16 16 0 0 1 0 -32z", false),
    ] {
        for (color, is_gray) in [("navy", false), ("black", true)] {
            let import = on_page(&format!(r#"<path d="{path}" fill="{color}" fill-rule="evenodd"/>"#));
            let is_filled = !import.drawing.fills.is_empty();
            assert_eq!(is_filled, is_ink || is_gray, "{color}: {path}");
            assert!(import.drawing.curves.iter().all(|curve| curve.line.is_none() == is_filled));
        }
    }
}

#[test]
fn a_light_area_gets_a_thin_outline() {
    let import = on_page(r##"<path d="M8 8h16v16" fill="#fed"/><path d="M8 8h16v16z" opacity="0.2"/>"##);
    assert!(import.drawing.fills.is_empty());
    assert_eq!(import.drawing.curves.len(), 2);
    for curve in &import.drawing.curves {
        let line = curve.line.as_ref().unwrap();
        assert_eq!((line.stroke.width, line.color), (1.0, Rgba8([0, 0, 0, 255])));
        assert_eq!(curve.path.elements().last(), Some(&PathEl::ClosePath), "an area is closed");
    }
}

#[test]
fn an_area_with_a_stroke_has_one_curve() {
    let import = on_page(
        r##"<circle cx="16" cy="16" r="8" fill="white" stroke="black"/><circle cx="16" cy="16" r="4" stroke="red"/>"##,
    );
    assert_eq!(import.drawing.curves.len(), 2);
    assert!(import.drawing.curves.iter().all(|curve| curve.line.is_some()));
    assert_eq!(import.drawing.fills.len(), 1, "the black one");
}

#[test]
fn an_open_stroke_around_ink_is_closed_without_a_line() {
    let import = on_page(r##"<path d="M8 8h16v16" stroke="red"/><path d="M8 8h16v16z" stroke="red"/>"##);
    let curves = import.drawing.curves;
    assert_eq!(curves.iter().map(|curve| curve.line.is_some()).collect::<Vec<_>>(), [true, false, true]);
    assert_eq!(curves[1].path.to_svg(), "M384,384 L128,128");
}

#[test]
fn what_is_not_painted_is_no_curve() {
    let import = on_page(
        r##"<path d="M8 8h8" stroke="black"/><path d="M8 8h8v8" fill="none"/><path d="M9 9h9" stroke="red" opacity="0"/>
            <g display="none"><path d="M8 8h8v8"/></g><path d="M8 8h8v8" visibility="hidden"/><line x2="9" fill="black"/>
            <rect width="64" height="64" fill="white"/>"##,
    );
    assert_eq!(import.drawing.curves.len(), 1, "the page-wide white rectangle is paper");
}

#[test]
fn gradients_and_patterns_stand_as_one_colour() {
    let import = on_page(
        r##"<linearGradient id="dark"><stop stop-color="#000"/><stop offset="1" stop-color="#406080"/></linearGradient>
            <pattern id="hatch" width="4" height="4" patternUnits="userSpaceOnUse"><path d="M0 0h4" stroke="black"/></pattern>
            <path d="M8 8h16v16z" fill="url(#dark)"/><path d="M8 8h16v16z" fill="url(#hatch)"/>"##,
    );
    let [fill] = &*import.drawing.fills else { panic!("the dark one is ink") };
    assert_eq!(fill.color, Rgba8([0x20, 0x30, 0x40, 255]));
    assert_eq!(import.drawing.curves.iter().map(|c| c.line.is_some()).collect::<Vec<_>>(), [false, true]);
}

#[test]
fn what_is_left_out_is_counted() {
    let import = on_page(
        r##"<clipPath id="c"><rect width="8" height="8"/></clipPath><mask id="m"><rect width="8" height="8"/></mask>
            <filter id="f"/><marker id="k"><path d="M0 0h4v4z"/></marker><text>one</text><text>two</text><image href="x.png"/>
            <path d="M0 32h64" stroke="black" clip-path="url(#c)" mask="url(#m)" filter="url(#f)" marker-end="url(#k)"/>"##,
    );
    let notes = import.notes.to_string();
    assert_eq!(notes, "left out: 2 texts, 1 image, 1 clip path, 1 mask, 1 filter, 1 marker");
    assert_eq!(import.drawing.curves.len(), 1);
    assert_close(bounds(&import.drawing.curves[0].path), [0.0, 512.0, 1024.0, 512.0]);
}

#[test]
fn shapes_with_unusable_coordinates_are_left_out_and_counted() {
    let import = on_page(
        r##"<g stroke="black"><path d="M8 8h8"/><path d="M NaN 8 h 8"/><path d="M8 8 L1e308 8"/><circle r="NaN"/>
            <line x2="1e308"/><polyline points="1,1 NaN,2"/><path d="M8 8 L1e30 8"/><path d="M0 0h9" transform="scale(NaN)"/></g>"##,
    );
    assert_eq!(import.notes.broken, 7);
    for curve in &import.drawing.curves {
        assert!(curve.path.segments().all(|segment| segment.arclen(1e-3).is_finite()));
    }
}

/// Where the point (20, 40) of the page ends up in du.
fn du_of_mark(svg_attributes: &str) -> (Import, Point) {
    let import = import(&format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" {svg_attributes}><path d="M 20 40 h 1" stroke="black"/></svg>"#
    ));
    let PathEl::MoveTo(p) = import.drawing.curves[0].path.elements()[0] else {
        panic!("a path starts with a move")
    };
    (import, p)
}

#[test]
fn the_page_is_the_view_box_in_its_own_units() {
    for rest in [
        "",
        r#"width="144""#,
        r#"width="144" height="144""#,
        r#"width="1000" height="10""#,
        r#"width="300" height="100" preserveAspectRatio="none""#,
        r#"width="300" height="100" preserveAspectRatio="xMinYMax slice""#,
        r#"width="100" height="300" preserveAspectRatio="xMaxYMin meet""#,
        r#"width="10cm" height="50%""#,
    ] {
        let (import, p) = du_of_mark(&format!(r#"viewBox="10 20 72 36" {rest}"#));
        assert_eq!(import.drawing.page, Rect::new(10.0, 20.0, 82.0, 56.0), "{rest}");
        let expected = import.drawing.drawing_from_page() * Point::new(20.0, 40.0);
        assert!((p - expected).hypot() < 1e-3, "{rest}: {p} instead of {expected}");
        let width_du = import.drawing.curves[0].line.as_ref().unwrap().stroke.width;
        assert!((width_du - 1024.0 / 72.0).abs() < 1e-3, "{rest}: line width {width_du}");
    }
}

#[test]
fn without_a_view_box_the_page_is_the_size() {
    let (import, p) = du_of_mark(r#"width="128" height="64""#);
    assert_eq!(import.drawing.page, Rect::new(0.0, 0.0, 128.0, 64.0));
    assert!((p - Point::new(160.0, 320.0)).hypot() < 1e-3);
    let (import, _) = du_of_mark("");
    assert!(
        (import.drawing.page.width() - 21.0).abs() < 0.6,
        "what the shapes span: {}",
        import.drawing.page
    );
}

#[test]
fn entities_for_name_spaces_are_read() {
    let import = import(
        r##"<!DOCTYPE svg PUBLIC "-//W3C//DTD SVG 1.1//EN" "http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd" [
            <!ENTITY ns_svg "http://www.w3.org/2000/svg">]>
            <svg xmlns="&ns_svg;" viewBox="0 0 8 8"><path d="M1 1h6" stroke="#000"/></svg>"##,
    );
    assert_eq!(import.drawing.curves.len(), 1);
}
