//! What an SVG drawing becomes.

use kurbo::{Affine, BezPath, Cap, Join, ParamCurve, ParamCurveArclen, PathEl, Point, Rect, Shape};
use scumble_core::{Curve, Document, Rgba8, Work};
use scumble_io::{Import, import_svg, read_file, write_file};

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
fn transforms_of_styles_are_followed_or_told() {
    let Import { drawing, notes, .. } = on_page(
        r#"<style>* { box-sizing: border-box } .turned { transform: rotate(90deg) scale(200%) }</style><g stroke="black">
            <line x2="8" class="turned"/><line x2="8" style="transform:translate(8px,8px)"/>
            <line x2="8" style="transform:translateX(50%)" transform="translate(0 8)"/></g>"#,
    );
    let expected = [[0.0, 0.0, 0.0, 256.0], [128.0, 128.0, 256.0, 128.0], [0.0, 128.0, 128.0, 128.0]];
    let found: Vec<_> = drawing.curves.iter().map(|curve| bounds(&curve.path)).collect();
    assert_eq!(found.len(), expected.len());
    found.into_iter().zip(expected).for_each(|(found, expected)| assert_close(found, expected));
    assert_eq!(notes.to_string(), "left out: 1 transform");
}

#[test]
fn what_is_turned_around_its_own_box_stays_and_is_told() {
    let Import { drawing, notes, .. } = on_page(
        r#"<g stroke="black" style="transform-box:fill-box;transform-origin:center;transform:translateX(8px)">
            <line x2="8" style="transform:rotate(90deg)"/></g>"#,
    );
    assert_close(bounds(&drawing.curves[0].path), [128.0, 0.0, 256.0, 0.0]);
    assert_eq!(notes.to_string(), "left out: 1 transform");
}

#[test]
fn a_line_that_does_not_scale_is_as_wide_as_in_the_picture() {
    let look = [
        r#"vector-effect="non-scaling-stroke""#,
        r#"style="vector-effect:non-scaling-stroke;fill:none""#,
        "",
        r#"shape-rendering="optimizeSpeed""#,
        r#"style="shape-rendering:optimizeSpeed""#,
    ];
    let widths_du = look.map(|look| {
        let path = format!(r#"<path transform="scale(4)" d="M2 2h9" stroke="black" stroke-width="2" {look}/>"#);
        let svg = format!(r#"<svg xmlns="http://www.w3.org/2000/svg" width="640" height="640" viewBox="0 0 64 64">{path}</svg>"#);
        import(&svg).drawing.curves[0].line.as_ref().unwrap().stroke.width
    });
    // Two of 640 pixels; otherwise four times two of 64 units.
    assert_eq!(widths_du, [3.2, 3.2, 128.0, 128.0, 128.0]);
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
fn symbols_with_a_size_of_their_own_lie_where_their_transforms_take_them() {
    for overflow in ["", r#"overflow="visible""#] {
        // From (0, -4) to (0, 4), in Illustrator's way upside down, then turned and moved.
        let symbol = format!(
            r##"<symbol id="s" viewBox="-5 -5 10 10" {overflow}><path d="M0-4V4" stroke="black"/></symbol>
            <g transform="translate(16 0)"><use href="#s" width="10" height="10" x="-5" y="-5" transform="matrix(1 0 0 -1 0 32)"/>
            <use href="#s" width="20" height="20" x="-10" y="-10" transform="translate(16 32) rotate(90)"/></g>"##
        );
        let curves = on_page(&symbol).drawing.curves;
        assert_eq!(curves.len(), 2);
        assert_close(bounds(&curves[0].path), [256.0, 448.0, 256.0, 576.0]);
        assert_close(bounds(&curves[1].path), [384.0, 512.0, 640.0, 512.0]);
    }
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
fn a_long_thin_area_is_a_line_of_its_colour() {
    let ring = |side: u32| format!("M8 8h{side}v{side}h-{side}z M9 9v{0}h{0}v-{0}z", side - 2);
    let [long, short] = [ring(48), ring(8)];
    for (path, color, is_line) in
        [(&long, "#39f", true), (&long, "gray", true), (&long, "white", false), (&short, "#39f", false)]
    {
        let drawing = on_page(&format!(r#"<path d="{path}" fill="{color}"/>"#)).drawing;
        assert_eq!(drawing.fills.len(), usize::from(is_line), "{path} {color}");
        assert!(drawing.curves.iter().all(|curve| curve.line.is_none() == is_line), "{path} {color}");
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
    assert_eq!(import.drawing.curves.iter().map(|c| c.line.is_some()).collect::<Vec<_>>(), [true, false]);
}

/// The colours of the lines of shapes, and whether there is ink.
fn line_colors(shapes: &str) -> (Vec<[u8; 4]>, bool) {
    let drawing = on_page(shapes).drawing;
    let colors = drawing.curves.iter().filter_map(|curve| Some(curve.line.as_ref()?.color.0));
    (colors.collect(), !drawing.fills.is_empty())
}

#[test]
fn colours_are_read_as_browsers_read_them() {
    for (attributes, color) in [
        (r#"stroke="currentcolor""#, [0, 0, 0, 255]),
        (r##"color="rgb(0 0 255 / 100%)" stroke="currentcolor""##, [0, 0, 255, 255]),
        (r#"stroke="rgba(0,0,0,50%)""#, [0, 0, 0, 128]),
        (r#"stroke="rgb(0 0 0 / 50%)" stroke-opacity="0.5""#, [0, 0, 0, 64]),
        (r#"stroke="rebeccapurple""#, [0x66, 0x33, 0x99, 255]),
        (r#"stroke="CanvasText""#, [0, 0, 0, 255]),
        (r#"stroke="oklch(0.628 0.2577 29.23)""#, [255, 0, 0, 255]),
        (r#"stroke="var(--stroke-0, black)""#, [0, 0, 0, 255]),
        (r#"stroke="var(--a, var(--b, color(display-p3 0 0 0)))""#, [0, 0, 0, 255]),
        (r#"style="stroke: light-dark(rgb(1,2,3), rgb(255,255,255));""#, [1, 2, 3, 255]),
        (r##"style="--x:1;fill:none;stroke:#00f""##, [0, 0, 255, 255]),
        (r##"style="fill:;stroke:#00f""##, [0, 0, 255, 255]),
        (
            r##"style="font:12px/1.5 'A';stroke:color-mix(in srgb, red, rgb(0 0 255)) !important""##,
            [128, 0, 128, 255],
        ),
        (
            r##"stroke="#1E1E1E" style="stroke:#1E1E1E;stroke:color(display-p3 .1176 .1176 .1176)""##,
            [0x1e, 0x1e, 0x1e, 255],
        ),
    ] {
        let read = line_colors(&format!(r#"<g fill="none"><path d="M8 8h16v16" {attributes}/></g>"#));
        assert_eq!(read, (vec![color], false), "{attributes}");
    }
    let drawn = r#"<rect x="8" y="8" width="9" height="9" style="fill: light-dark(#ffffff, #121212); stroke: light-dark(rgb(0, 0, 0), rgb(255, 255, 255));"/>"#;
    assert_eq!(line_colors(drawn), (vec![[0, 0, 0, 255]], false));
}

#[test]
fn a_declaration_that_cannot_be_read_leaves_the_one_before_it() {
    for attributes in [
        r##"fill="none" stroke="#123" style="stroke:nothing""##,
        r##"fill="none" style="stroke:#123;stroke:contrast-color(red)""##,
        r##"fill="nothing" style="fill:none;stroke:#123""##,
    ] {
        let import = on_page(&format!(r#"<path d="M8 8h16v16" {attributes}/>"#));
        assert!(import.drawing.fills.is_empty(), "{attributes}");
        let line = import.drawing.curves[0].line.as_ref().unwrap();
        assert_eq!(line.color, Rgba8([0x11, 0x22, 0x33, 255]), "{attributes}");
    }
}

#[test]
fn style_sheets_with_variables_are_read() {
    let sheet = r##"/* { */ :root { --ink: #123; --w: 2px } @media (prefers-color-scheme: dark) { :root { --ink: #eee } }
        .a{--y:2;fill:none;stroke:var(--ink);stroke-width:var(--w)} g > .b { fill : NONE ; stroke : oklab(0 0 0) }"##;
    let shapes = r#"<g><path class="a" d="M8 8h16v16"/><path class="b" d="M9 9h16v16"/></g>"#;
    for sheet in
        [sheet.replace('>', "&gt;"), format!("<![CDATA[{sheet}]]>"), format!("\n<![CDATA[{sheet}]]>\n")]
    {
        let import = on_page(&format!(r#"<style type="text/css">{sheet}</style>{shapes}"#));
        assert!(import.drawing.fills.is_empty() && import.notes.is_empty());
        let lines = import.drawing.curves.iter().filter_map(|curve| curve.line.as_ref());
        let looks: Vec<_> = lines.map(|line| (line.color.0, line.stroke.width)).collect();
        assert_eq!(looks, [([0x11, 0x22, 0x33, 255], 32.0), ([0, 0, 0, 255], 16.0)]);
    }
}

#[test]
fn colours_that_nobody_can_read_are_lines_and_counted() {
    let import = on_page(
        r#"<linearGradient id="g"><stop stop-color="nothing"/></linearGradient><path d="M8 8h8v8z" fill="url(#g)"/>
           <path d="M8 8h16" stroke="var(--gone)"/><path d="M8 8h16v16" fill="nothing"/><path d="M0 NaN" fill="?"/>
           <path d="M8 8h16" style="stroke:nothing"/><g fill="none"><path d="M8 8h16v9" fill="" stroke="red"/></g>"#,
    );
    assert_eq!(
        import.notes.to_string(),
        "left out: 1 shape with unusable coordinates, 5 colours that cannot be read"
    );
    assert!(import.drawing.fills.is_empty());
    let widths: Vec<_> =
        import.drawing.curves.iter().map(|curve| curve.line.as_ref().unwrap().stroke.width).collect();
    assert_eq!(widths, [1.0, 1.0, 16.0, 16.0, 16.0]);
}

#[test]
fn entities_for_styles_are_read() {
    let import = import(
        r##"<!DOCTYPE svg [<!ENTITY st "fill:none;--x:1;stroke:color(srgb 0 0 1)"><!ENTITY p "<path fill='' style=';stroke:red' d='M1 1h6'/>">]>
            <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 8 8"><path style="&st;" d="M1 1h6v6"/>&p;&p;</svg>"##,
    );
    let colors: Vec<_> =
        import.drawing.curves.iter().map(|curve| curve.line.as_ref().unwrap().color.0).collect();
    assert_eq!(colors, [[0, 0, 255, 255], [255, 0, 0, 255], [255, 0, 0, 255]]);
}

#[test]
fn what_is_left_out_is_counted() {
    let import = on_page(
        r##"<clipPath id="c"><rect width="8" height="8" clip-path="url(#c)"/></clipPath><mask id="m"><rect width="8" height="8"/></mask>
            <filter id="f"/><marker id="k"><path d="M0 0h4v4z"/></marker><switch><foreignObject/></switch><text>one</text><text>two</text><image href="x.png"/>
            <path d="M0 32h64" stroke="black" clip-path="url(#c)" mask="url(#m)" filter="url(#f)" marker-end="url(#k)"/>"##,
    );
    let notes = import.notes.to_string();
    assert_eq!(notes, "left out: 2 texts, 1 image, 1 clip path, 1 mask, 1 filter, 1 marker");
    assert_eq!(import.drawing.curves.len(), 1);
    assert_close(bounds(&import.drawing.curves[0].path), [0.0, 512.0, 1024.0, 512.0]);
}

#[test]
fn patterns_are_counted_by_the_shapes_that_they_are_seen_on() {
    const HATCHES: &str = r##"<pattern id="a" width="4" height="4" patternUnits="userSpaceOnUse"><path d="M0 0h4" stroke="black"/></pattern>
        <pattern id="b" href="#a" patternTransform="rotate(45)"/><pattern id="unused" href="#a"/>"##;
    for (shapes, notes) in [
        (r##"<path d="M8 8h8v8"/>"##, ""),
        (r##"<path d="M8 8h8v8" fill="url(#b)"/>"##, "left out: 1 pattern"),
        (r##"<path d="M8 8h8v8" fill="none" stroke="url(#a)"/>"##, "left out: 1 pattern"),
        (
            r##"<g fill="url(#a)"><path d="M8 8h8v8" stroke="url(#b)"/><path d="M9 8h8v8"/></g>"##,
            "left out: 2 patterns",
        ),
        (r##"<path d="M0 0h9"/><path d="M8 8h8v8" stroke="black" fill="url(#none) red"/>"##, ""),
        (r##"<path d="M8 8h8v8"/><path d="M8 8h8v8" fill="url(#a)" opacity="0"/>"##, ""),
    ] {
        assert_eq!(on_page(&[HATCHES, shapes].concat()).notes.to_string(), notes, "{shapes}");
    }
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
fn the_page_is_the_same_when_it_is_opened_again() {
    for view_box in ["0 0 1e-5 7.1234567e-6", "0 0 1.2345678e-6 1e-6", "1 2 0.33333333333 0.1"] {
        let svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="{view_box}"><path d="M0 0h1e-6v1e-6" stroke="red"/></svg>"#
        );
        let work = Work::new(Document::new(import_svg(svg.as_bytes()).unwrap().drawing));
        let read = read_file(&write_file(&work).unwrap()).unwrap();
        assert_eq!(read.document.drawing.size_du(), work.document.drawing.size_du(), "{view_box}");
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

/// Shapes in a group that a path in page units clips.
fn clipped(clip: &str, shapes: &str) -> Import {
    on_page(&format!(r##"<clipPath id="c">{clip}</clipPath><g clip-path="url(#c)">{shapes}</g>"##))
}

const SQUARE: &str = r#"<rect x="8" y="8" width="16" height="16"/>"#;

#[test]
fn lines_end_where_a_clip_path_does() {
    let import = clipped(
        SQUARE,
        r#"<path d="M 0 16 H 64 M 16 0 C 16 4 16 12 16 16 M 32 0 V 64" fill="none" stroke="black"/>"#,
    );
    let [across, curved] = &*import.drawing.curves else { panic!("{:?}", import.drawing.curves) };
    assert_close(bounds(&across.path), [128.0, 256.0, 384.0, 256.0]);
    assert_close(bounds(&curved.path), [256.0, 128.0, 256.0, 256.0]);
    assert!(matches!(curved.path.elements()[1], PathEl::CurveTo(..)));
    assert!(import.notes.is_empty());
}

#[test]
fn a_shape_is_cut_where_a_clip_path_ends_and_is_one_outline() {
    let import = clipped(SQUARE, r#"<circle cx="24" cy="16" r="4" fill="gold"/>"#);
    let [outline] = &*import.drawing.curves else { panic!("{:?}", import.drawing.curves) };
    assert_close(bounds(&outline.path), [320.0, 192.0, 384.0, 320.0]);
    assert_eq!(outline.path.elements().last(), Some(&PathEl::ClosePath));
    let half_disk = std::f64::consts::PI * 64.0 * 64.0 / 2.0;
    assert!((outline.path.area().abs() - half_disk).abs() < 4.0, "{}", outline.path.area());
}

#[test]
fn ink_is_cut_with_its_outline() {
    let import = clipped(
        SQUARE,
        r#"<path d="M 16 2 L 30 16 L 16 30 L 2 16 Z M 16 14 L 18 16 L 16 18 L 14 16 Z" fill-rule="evenodd"/>"#,
    );
    let [fill] = &*import.drawing.fills else { panic!("{:?}", import.drawing.fills) };
    assert_close(bounds(&fill.path), [128.0, 128.0, 384.0, 384.0]);
    for (point, winding) in [
        ((140.0, 140.0), 0),
        ((200.0, 200.0), 1),
        ((256.0, 256.0), 0),
        ((130.0, 256.0), 1),
        ((100.0, 256.0), 0),
    ] {
        assert_eq!(fill.path.winding(Point::from(point)) % 2 != 0, winding != 0, "{point:?}");
    }
    assert!(import.drawing.curves.iter().all(|curve| curve.line.is_none()));
}

#[test]
fn a_line_along_a_clip_path_stays_whole() {
    let disk = r#"<circle cx="32" cy="32" r="20"/>"#;
    let import =
        clipped(disk, r#"<circle cx="32" cy="32" r="20" fill="gold" stroke="black" stroke-width="2"/>"#);
    let [outline] = &*import.drawing.curves else { panic!("{:?}", import.drawing.curves) };
    assert_eq!(outline.path.elements().last(), Some(&PathEl::ClosePath));
    assert_close(bounds(&outline.path), [192.0, 192.0, 832.0, 832.0]);
}

#[test]
fn a_line_along_its_own_clip_path_is_half_as_wide() {
    let square = r#"<path d="M16 16H48V48H16Z""#;
    let shape = format!(r#"{square} fill="white" stroke="black" stroke-width="4""#);
    for (within, expected) in [
        (format!(r#"<mask id="m" fill="white">{square}/></mask>{shape} mask="url(#m)"/>"#), 32.0),
        (format!(r#"<clipPath id="m">{square}/></clipPath>{shape} clip-path="url(#m)"/>"#), 32.0),
        (
            format!(r#"<clipPath id="m"><path d="M8 8H48V48H8Z"/></clipPath>{shape} clip-path="url(#m)"/>"#),
            64.0,
        ),
    ] {
        let curves = on_page(&within).drawing.curves;
        let [curve] = &*curves else { panic!("{curves:?}") };
        assert_eq!(curve.line.as_ref().map(|line| line.stroke.width), Some(expected), "{within}");
    }
}

#[test]
fn clip_paths_within_each_other_hide_what_either_does() {
    let inner = format!(
        r##"<clipPath id="d" transform="translate(8 0)">{SQUARE}<rect x="8" y="40" width="4" height="4"/></clipPath>
            <g clip-path="url(#d)"><path d="M0 12h64 M0 42h64" stroke="black"/></g>"##
    );
    let curves = clipped(SQUARE, &inner).drawing.curves;
    let [line] = &*curves else { panic!("{curves:?}") };
    assert_close(bounds(&line.path), [256.0, 192.0, 384.0, 192.0]);
}

#[test]
fn what_a_clip_path_cuts_at_the_border_of_the_page_has_no_line_there() {
    let page = r#"<path d="M 0 0 H 64 V 64 H 4 L 0 60 Z"/>"#;
    let import = clipped(page, r#"<rect x="-8" y="32" width="80" height="40" fill="gold"/>"#);
    let [corner, top] = &*import.drawing.curves else { panic!("{:?}", import.drawing.curves) };
    assert_close(bounds(&top.path), [0.0, 512.0, 1024.0, 512.0]);
    assert!(bounds(&corner.path)[2] < 64.0 && bounds(&corner.path)[1] > 960.0, "{}", corner.path.to_svg());
}

#[test]
fn a_clip_path_in_units_of_what_it_clips_is_followed() {
    let import = on_page(
        r##"<clipPath id="c" clipPathUnits="objectBoundingBox"><rect width="0.5" height="1"/></clipPath>
            <path d="M8 8h16v16" fill="none" stroke="black" clip-path="url(#c)"/>"##,
    );
    let [line] = &*import.drawing.curves else { panic!("{:?}", import.drawing.curves) };
    assert_close(bounds(&line.path), [128.0, 128.0, 256.0, 128.0]);
}

#[test]
fn clip_paths_that_cannot_be_followed_are_counted() {
    for clip in
        ["<text>A</text>", r##"<use href="#t"/>"##, r##"<rect width="8" height="8" clip-path="url(#c)"/>"##]
    {
        let import = clipped(clip, r#"<text id="t">A</text><path d="M0 32h64" stroke="black"/>"#);
        assert_eq!(import.drawing.curves.len(), 1, "{clip}");
        assert_eq!(import.notes.clip_paths, 1, "{clip}");
    }
}

#[test]
fn lines_under_a_shape_are_hidden_where_it_is_opaque() {
    let under = r#"<path d="M 0 32 H 64" stroke="black"/>"#;
    let over = r#"<rect x="16" y="16" width="32" height="32" stroke="black" fill="white"/>"#;
    let curves = on_page(&[under, over].concat()).drawing.curves;
    let [left, right, square] = &*curves else { panic!("{curves:?}") };
    assert_close(bounds(&left.path), [0.0, 512.0, 256.0, 512.0]);
    assert_close(bounds(&right.path), [768.0, 512.0, 1024.0, 512.0]);
    assert_close(bounds(&square.path), [256.0, 256.0, 768.0, 768.0]);
    for seen_through in [
        "fill-opacity=\"0.9\"",
        "style=\"mix-blend-mode:multiply\"",
        "opacity=\"0.5\"",
        "mask=\"url(#m)\"",
        "style=\"filter: url(#m)\"",
        "style=\"Filter: blur(2px)!important\"",
        "class=\"m\"",
    ] {
        let over = over.replace("fill=", &[seen_through, " fill="].concat());
        let mask = r#"<mask id="m"><rect width="8" height="8"/></mask>"#;
        let mask =
            if seen_through.starts_with("class") { "<style>.m { mask: url(#m) }</style>" } else { mask };
        assert_eq!(on_page(&[mask, under, &over].concat()).drawing.curves.len(), 2, "{seen_through}");
    }
    assert_eq!(
        on_page(&[over, under].concat()).drawing.curves.len(),
        2,
        "what is painted later is not hidden"
    );
    let between =
        r#"<path d="M32 20V44" stroke="black"/><path d="M16 16H32V48H16Z M32 16H48V48H32Z" fill="white"/>"#;
    let two = r#"<path d="M32 20V44" stroke="black"/><path d="M16 16H32V48H16Z" fill="white"/><path d="M32 16H48V48H32Z" fill="white"/>"#;
    for shapes in [between, two] {
        let curves = on_page(shapes).drawing.curves;
        assert_eq!(
            curves.iter().filter(|curve| bounds(&curve.path)[0] == bounds(&curve.path)[2]).count(),
            0,
            "{shapes}"
        );
    }
    for elsewhere in [
        "<style>.m:hover, .n { filter: brightness(2) }</style>",
        r#"<path class="n" style="mask:url(#m)" d="M0 8H8" stroke="black"/>"#,
    ] {
        let curves = on_page(&[elsewhere, under, over].concat()).drawing.curves;
        assert!(curves.len() > 2 && curves.iter().any(|curve| curve.path == left.path), "{elsewhere}");
    }
    for group in ["opacity=\".5\"", "style=\"mix-blend-mode:multiply\"", "style=\"filter:blur(1px)\""] {
        let before = r#"<path d="M0 30H64" stroke="black"/>"#;
        let curves = on_page(&[before, "<g ", group, ">", under, over, "</g>"].concat()).drawing.curves;
        let within =
            curves.iter().filter(|curve| curve.path == left.path || curve.path == right.path).count();
        assert_eq!((curves.len(), within), (4, 2), "a group with {group}");
    }
    for nothing in ["filter:none;mask:none !important", "filter:NONE;mask:unset"] {
        let over = over.replace("fill=", &["style=\"", nothing, "\" fill="].concat());
        assert_eq!(on_page(&[under, &over].concat()).drawing.curves.len(), 3, "{nothing}");
    }
}

/// Circles on a page of 64 × 64, whose places and radii look random: x, y and radius.
fn bubbles(count: u32, radius: f64) -> Vec<[f64; 3]> {
    let part = |i: u32, step: f64| (f64::from(i) * step).fract();
    (0..count)
        .map(|i| [64.0 * part(i, 0.618_034), 64.0 * part(i, 0.414_214), radius * (0.4 + part(i, 0.732_051))])
        .collect()
}

fn painted(bubbles: &[[f64; 3]]) -> Import {
    let circle =
        |[x, y, r]: &[f64; 3]| format!(r#"<circle cx="{x}" cy="{y}" r="{r}" fill="white" stroke="black"/>"#);
    on_page(&bubbles.iter().map(circle).collect::<String>())
}

#[test]
fn of_thousands_of_shapes_upon_each_other_only_what_is_seen_is_left() {
    let bubbles = bubbles(2000, 6.0);
    let import = painted(&bubbles);
    assert!(import.notes.is_empty() && (100..1000).contains(&import.drawing.curves.len()));
    for curve in &import.drawing.curves {
        for segment in curve.path.segments() {
            let place = segment.eval(0.5);
            let inside = |&[x, y, r]: &[f64; 3]| r * 16.0 - place.distance(Point::new(x * 16.0, y * 16.0));
            let own = bubbles.iter().rposition(|bubble| inside(bubble).abs() < 0.1).expect("a circle");
            assert!(bubbles[own..].iter().all(|bubble| inside(bubble) < 0.2), "{place}");
        }
    }
}

#[test]
fn what_would_take_too_long_to_hide_is_told() {
    let ridge = |y: u32| {
        let way: String = (0..800).map(|x| format!("L{} {}", 0.08 * f64::from(x), y + x % 2 * 8)).collect();
        format!(r#"<path d="M0 {y}{way}L64 60H0Z" fill="white" stroke="black"/>"#)
    };
    let import = on_page(&(4..44).map(ridge).collect::<String>());
    assert!((1..40).contains(&import.notes.covers), "{}", import.notes);
    let expected = format!("left out: {} covers of lines that are shown whole", import.notes.covers);
    assert_eq!(import.notes.to_string(), expected);
}

#[test]
fn declarations_after_a_filter_that_cannot_be_read_are() {
    for odd in [
        "filter:drop-shadow(0 0 1px rgba(0,0,0,.5))",
        "filter:progid:x(y='1')",
        "mask:url(#a) 0 / 3",
        "background:linear-gradient(rgba(0,0,0,.5),red)",
        "background:",
    ] {
        for style in [
            format!("<g style=\"{odd};stroke:#f00;fill:none\"><path"),
            format!("<style>.a{{{odd};stroke:#f00;fill:none}}</style><g><path class=\"a\""),
        ] {
            let drawing = on_page(&format!(r#"{style} d="M8 8H40V40Z"/></g>"#)).drawing;
            let [curve] = &*drawing.curves else { panic!("{style}: {:?}", drawing.curves) };
            assert_eq!(curve.line.as_ref().map(|line| line.color.0), Some([255, 0, 0, 255]), "{style}");
        }
    }
}

#[test]
fn haze_over_dark_paper_is_no_paper() {
    for haze in ["opacity=\".1\"", "style=\"mix-blend-mode:multiply\""] {
        let import = on_page(&format!(
            r#"<rect width="64" height="64"/><path d="M8 4h8" stroke="white"/><rect width="64" height="64" fill="white" {haze}/>
                <path d="M8 8h8" stroke="white"/>"#
        ));
        let lines = import.drawing.curves.iter().flat_map(|curve| &curve.line);
        assert_eq!(lines.map(|line| line.color.0).collect::<Vec<_>>(), [[0, 0, 0, 255]; 2], "{haze}");
    }
}

#[test]
fn paper_hides_what_is_painted_before_it() {
    let import = on_page(
        r##"<rect width="64" height="64"/><circle cx="32" cy="32" r="20" stroke="#f00"/><rect width="64" height="64" fill="white"/>
            <path d="M8 8h8v8" fill="none" stroke="#ff8"/>"##,
    );
    let [line] = &*import.drawing.curves else { panic!("{:?}", import.drawing.curves) };
    assert_eq!(line.line.as_ref().map(|line| line.color), Some(Rgba8([0xff, 0xff, 0x88, 255])));
    assert_eq!(import.drawing.fills, []);
}

#[test]
fn a_light_shape_is_cut_out_of_the_ink_under_it() {
    let import = on_page(r#"<circle cx="32" cy="32" r="20"/><circle cx="40" cy="24" r="6" fill="white"/>"#);
    let [fill] = &*import.drawing.fills else { panic!("{:?}", import.drawing.fills) };
    let is_ink = |x: f64, y: f64| fill.path.winding(Point::new(x * 16.0, y * 16.0)) % 2 != 0;
    assert!(fill.even_odd && is_ink(32.0, 40.0) && !is_ink(40.0, 24.0) && is_ink(40.0, 32.0));
    let [light, pupil] = &*import.drawing.curves else { panic!("{:?}", import.drawing.curves) };
    assert!(pupil.line.is_none() && light.line.is_some());
    let hidden =
        on_page(r#"<circle cx="32" cy="32" r="4"/><circle cx="32" cy="32" r="6" fill="white"/>"#).drawing;
    assert_eq!((hidden.fills.len(), hidden.curves.len()), (0, 1));
}

#[test]
fn light_lines_upon_dark_paper_are_dark_upon_white() {
    for paper in ["#111", "navy"] {
        let import = on_page(&format!(
            r##"<rect x="-1" width="66" height="64" fill="{paper}"/><g fill="none"><path d="M8 8h8v8" stroke="white"
                stroke-opacity="0.5"/><path d="M8 8h8v8" stroke="#820"/></g>"##
        ));
        assert_eq!(import.drawing.fills, []);
        let lines = import.drawing.curves.iter().flat_map(|curve| &curve.line);
        let colors: Vec<_> = lines.map(|line| line.color).collect();
        assert_eq!(colors, [Rgba8([0, 0, 0, 128]), Rgba8([0x88, 0x22, 0, 255])]);
    }
}

#[test]
fn pale_lines_upon_paper_of_a_colour_are_dark_upon_white() {
    let lines = r##"<path d="M8 8h8v8" fill="none" stroke="white"/><path d="M8 9h8" stroke="#fc0"/>"##;
    let first = |svg: String| import(&svg).drawing.curves.swap_remove(0).line.map(|line| line.color);
    for (paper, expected) in [("#1e6fd9", 0), ("#c8a878", 0), ("#222", 0), ("#f4f4f0", 255)] {
        for paper in [
            format!(r#"viewBox="0 0 64 64"><rect width="64" height="64" fill="{paper}"/>"#),
            format!(r#"viewBox="0 0 64 64" style="background: {paper}">"#),
        ] {
            let svg = format!(r#"<svg xmlns="http://www.w3.org/2000/svg" {paper}{lines}</svg>"#);
            assert_eq!(first(svg), Some(Rgba8([expected, expected, expected, 255])), "{paper}");
        }
    }
}

#[test]
fn quadratic_curves_are_cut_where_they_cross() {
    // Raised to cubics they have a third power that is nothing but rounding.
    let import = clipped(
        r#"<circle cx="21.3" cy="23.5" r="10.7"/>"#,
        r#"<path d="M7.1 17.8Q21.3 14.2 35.6 17.8L35.6 20.6Q21.3 17.1 7.1 20.6Z" fill="none" stroke="black"/>"#,
    );
    let within = |p: Point| p.distance(Point::new(21.3 * 16.0, 23.5 * 16.0)) < 10.7 * 16.0 + 0.1;
    let curves = &import.drawing.curves;
    assert_eq!(curves.len(), 2);
    for segment in curves.iter().flat_map(|curve| curve.path.segments()) {
        assert!((0..=10).all(|i| within(segment.eval(f64::from(i) / 10.0))), "{segment:?}");
    }
    let long = curves.iter().map(|curve| curve.path.bounding_box().width()).fold(0.0, f64::max);
    assert!((315.0..325.0).contains(&long), "{long}");
}

#[test]
fn a_curve_that_comes_back_to_a_crossing_is_seen_between() {
    let import = on_page(
        r##"<clipPath id="c"><path d="M20.9 35.4H60V18.6H20.9Z"/></clipPath>
            <path clip-path="url(#c)" d="M28.9 19.7C37.4 -2.3 18.8 50.3 30.9 -3.4" fill="none" stroke="black"/>"##,
    );
    assert_eq!(import.drawing.curves.len(), 2, "{:?}", import.drawing.curves);
}

#[test]
fn ink_stays_whole_beside_what_is_cut_out_of_it() {
    for path in [
        // Overlapping bars, squares that share a part of an edge, and a square that is there twice.
        "M8 8h40v8h-40z M16 4h8v56h-8z",
        "M4 4h20v20h-20z M4 16h40v20h-40z",
        "M8 8h48v48h-48z M8 8h48v48h-48z",
    ] {
        let drawing =
            on_page(&format!(r#"<path d="{path}"/><circle cx="20" cy="12" r="2" fill="white"/>"#)).drawing;
        let [fill] = &*drawing.fills else { panic!("{:?}", drawing.fills) };
        let mut whole = BezPath::from_svg(path).unwrap();
        whole.apply_affine(Affine::scale(16.0));
        for (column, row) in (0..64).flat_map(|column| (0..64).map(move |row| (column, row))) {
            let point = Point::new(f64::from(column) * 16.0 + 5.0, f64::from(row) * 16.0 + 3.0);
            let is_cut = point.distance(Point::new(320.0, 192.0)) < 32.0;
            let is_ink = whole.winding(point) != 0 && !is_cut;
            assert_eq!(fill.path.winding(point) % 2 != 0, is_ink, "{path} at {point:?}");
        }
    }
}

#[test]
fn a_clipped_circle_stays_few_curves() {
    let import = clipped(
        r#"<rect x="32" width="32" height="64"/>"#,
        r#"<circle cx="32" cy="32" r="20" fill="gold"/>"#,
    );
    let [half] = &*import.drawing.curves else { panic!("{:?}", import.drawing.curves) };
    assert!(half.path.elements().len() <= 6, "{}", half.path.to_svg());
}

#[test]
fn very_large_shapes_are_cut_as_well() {
    let import = on_page(r#"<circle cx="32" cy="782" r="750"/><circle cx="32" cy="50" r="6" fill="white"/>"#);
    let [fill] = &*import.drawing.fills else { panic!("{:?}", import.drawing.fills) };
    let is_ink = |x: f64, y: f64| fill.path.winding(Point::new(x * 16.0, y * 16.0)) % 2 != 0;
    assert!(is_ink(32.0, 34.0) && !is_ink(32.0, 50.0) && is_ink(32.0, 60.0) && !is_ink(32.0, 30.0));
}

#[test]
fn a_background_that_is_clipped_is_a_shape() {
    let import = clipped(r#"<circle cx="32" cy="32" r="20"/>"#, r#"<rect width="64" height="64"/>"#);
    assert_eq!(import.drawing.fills.len(), 1);
    let lines = on_page(
        r#"<rect width="64" height="64"/><rect width="64" height="64" fill="white"/><path stroke="yellow" d="M1 1h50"/>"#,
    );
    let color = lines.drawing.curves[0].line.as_ref().map(|line| line.color);
    assert_eq!(color, Some(Rgba8([255, 255, 0, 255])), "white paper lies over the dark one");
}

#[test]
fn ink_hides_lines_and_a_glassy_light_hides_ink() {
    let curves = on_page(
        r##"<path d="M0 32h64" stroke="red"/><rect x="16" y="16" width="32" height="32" fill="#444"/>"##,
    )
    .drawing
    .curves;
    assert_eq!(curves.iter().filter(|curve| curve.line.is_some()).count(), 2);
    let fills = on_page(
        r#"<circle cx="32" cy="32" r="20"/><circle cx="32" cy="32" r="4" fill="white" fill-opacity="0.8"/>"#,
    )
    .drawing
    .fills;
    assert_eq!(fills[0].path.winding(Point::new(512.0, 512.0)) % 2, 0);
}

#[test]
fn outlines_without_a_line_are_drawn_under_lines() {
    let curves = on_page(
        r#"<path d="M0 32h64" stroke="red"/><circle cx="32" cy="32" r="4" fill="gold" fill-opacity="0.5"/>"#,
    )
    .drawing
    .curves;
    let colors: Vec<_> = curves.iter().flat_map(|curve| &curve.line).map(|line| line.color).collect();
    assert_eq!(colors, [Rgba8([0, 0, 0, 255]), Rgba8([255, 0, 0, 255])]);
}

#[test]
fn an_outline_is_left_to_the_line_that_runs_along_it() {
    let shirt = r#"<path d="M10 60L16 20C20 8 44 8 48 20L54 60Z" fill="white" stroke="black"/>"#;
    let clip = shirt.replace(" fill=\"white\" stroke=\"black\"", "");
    let stripes = r#"<g clip-path="url(#c)"><path d="M0 20h64v4h-64z" fill="red" fill-opacity="0.9"/></g>"#;
    let curves = on_page(&format!(r#"<clipPath id="c">{clip}</clipPath>{shirt}{stripes}"#)).drawing.curves;
    let widths: Vec<_> = curves.iter().flat_map(|curve| &curve.line).map(|line| line.stroke.width).collect();
    assert_eq!(widths, [1.0, 1.0, 16.0], "the stripe has an upper and a lower edge");
    let colored = r#"<circle cx="32" cy="32" r="9" fill="gold"/><circle cx="32" cy="32" r="9" fill="none" stroke="black"/>"#;
    assert_eq!(on_page(colored).drawing.curves.len(), 1);
    let apart = colored.replace(r#"r="9" fill="gold""#, r#"r="8.9" fill="gold""#);
    assert_eq!(on_page(&apart).drawing.curves.len(), 2);
}

#[test]
fn rules_that_hold_for_a_light_screen_are_taken() {
    let colors = |style: &str| {
        let svg = [style, r#"<path class="a" fill="none" stroke="blue" d="M1 1H50"/>"#].concat();
        let drawing = on_page(&svg).drawing;
        drawing.curves[0].line.as_ref().map(|line| line.color.0[..3].to_vec())
    };
    let [red, blue] = [vec![255, 0, 0], vec![0, 0, 255]].map(Some);
    for (style, expected) in [
        ("<style>@media (prefers-color-scheme: dark){.a{stroke:red}}</style>", &blue),
        ("<style>@media (prefers-color-scheme: light){.a{stroke:red}}</style>", &red),
        ("<style>@media print{.a{stroke:red}}</style>", &blue),
        ("<style>@media screen and (min-width:400px){.a{stroke:red}}</style>", &red),
        ("<style>@supports (stroke:red){@layer x{.a{stroke:red}}}</style>", &red),
        ("<style>@import url('x?a;b');.a{stroke:red}</style>", &red),
        (r#"<style media="print">.a{stroke:red}</style>"#, &blue),
        (r#"<style media="print">.b{--c:red}</style><style>.b{--c:blue} .a{stroke:var(--c)}</style>"#, &blue),
        (r#"<style media="screen">.a{stroke:red}</style>"#, &red),
        ("<style>@media screen{.b{--c:red}} .a{stroke:var(--c)}</style>", &red),
    ] {
        assert_eq!(&colors(style), expected, "{style}");
    }
}

#[test]
fn a_line_under_its_own_area_is_half_as_wide() {
    for (look, width_du) in [
        (r#"fill="white""#, 64.0),
        (r#"fill="white" paint-order="normal""#, 64.0),
        (r#"fill="white" paint-order="stroke""#, 32.0),
        (r#"fill="white" style="paint-order: markers stroke""#, 32.0),
        (r#"fill="white" fill-opacity="0.5" paint-order="stroke""#, 64.0),
        (r#"fill="none" paint-order="stroke""#, 64.0),
        (r#"fill="black" paint-order="stroke""#, 64.0),
    ] {
        let svg = format!(r#"<path {look} stroke="black" stroke-width="4" d="M8 8H40V40H8Z"/>"#);
        let curves = on_page(&svg).drawing.curves;
        assert_eq!(curves[0].line.as_ref().map(|line| line.stroke.width), Some(width_du), "{look}");
    }
}
