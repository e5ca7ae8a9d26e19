//! Diffusion curves as XML: what their names do not tell, and what cannot be used.

#![allow(clippy::unwrap_used, reason = "a test fails by panicking")]

use kurbo::{PathEl, Point, Shape};
use scumble_core::{Blend, ColorPoint, Document, Labels, Paint, PlanarMap, Sampling, Srgb8};
use scumble_io::{ImportError, import_drawing, import_svg, write_curve_set};

/// Two cubics straight to the right on row 30, then one curve down column 10; 200 pixels wide and 100 high.
const CURVES: &str = include_str!("../foreign/curves.xml");

fn read(text: &str) -> Document {
    import_drawing(text.as_bytes()).unwrap().0.document
}

/// What was left out of the curves with a change.
fn notes(from: &str, to: &str) -> String {
    assert!(CURVES.contains(from), "{from}");
    import_drawing(CURVES.replacen(from, to, 1).as_bytes()).unwrap().1
}

#[track_caller]
fn refused(text: &str, error: &ImportError) {
    assert_eq!(&import_drawing(text.as_bytes()).unwrap_err(), error);
}

#[test]
fn x_is_the_row_and_y_the_column() {
    let drawing = read(CURVES).drawing;
    assert_eq!((drawing.page.width(), drawing.page.height()), (200.0, 100.0));
    let du = 1024.0 / 200.0;
    let [across, down] = &drawing.curves[..] else { panic!("two curves") };
    let ends = |path: &kurbo::BezPath| {
        path.iter().map(|el| el.end_point().unwrap()).map(|p| [p.x / du, p.y / du]).collect::<Vec<_>>()
    };
    assert_eq!(ends(&across.path), [[10.0, 30.0], [40.0, 30.0], [130.0, 30.0]]);
    assert_eq!(ends(&down.path), [[10.0, 1.0], [10.0, 4.0]]);
    let handles = PathEl::CurveTo(
        Point::new(20.0 * du, 30.0 * du),
        Point::new(30.0 * du, 30.0 * du),
        Point::new(40.0 * du, 30.0 * du),
    );
    assert_eq!(across.path.elements()[1], handles);
    assert!(drawing.curves.iter().all(|curve| curve.line.is_none()));
}

#[test]
fn colours_lie_at_tenths_of_cubics_and_red_and_blue_change_places() {
    let document = read(CURVES);
    let du = 1024.0 / 200.0;
    let expected = [(true, 0.0, [1, 2, 3]), (true, 75.0, [10, 20, 30]), (true, 120.0, [100, 200, 250])];
    let expected = [&expected[..], &[(false, 30.0, [4, 5, 6])]].concat();
    assert_eq!(document.color_points.len(), expected.len());
    for (point, (is_left, at, rgb)) in document.color_points.iter().zip(expected) {
        let color = Paint::Color(Srgb8(rgb));
        assert!((point.at_du - at * du).abs() < 0.01, "{point:?}");
        assert_eq!(*point, ColorPoint { curve: 0, is_left, at_du: point.at_du, color });
    }
}

#[test]
fn they_are_blended_in_srgb_unless_they_say_otherwise_and_go_through_gaps() {
    let settings = read(CURVES).settings;
    assert_eq!((settings.blend, settings.gap_closing), (Blend::Srgb, 0.0));
    let ours = CURVES.replacen("nb_curves", "blend=\"oklab\" nb_curves", 1);
    assert_eq!(read(&ours).settings.blend, Blend::Oklab);
}

#[test]
fn a_set_that_does_not_hold_gives_no_colours() {
    let barrier = CURVES.replacen("<left_colors_set>", "<left_colors_set boundary=\"Neumann\">", 1);
    let points = read(&barrier).color_points;
    assert!(points.len() == 1 && !points[0].is_left);
}

#[test]
fn what_is_left_out_is_told() {
    assert_eq!(import_drawing(CURVES.as_bytes()).unwrap().1, "");
    assert_eq!(notes("value=\"0\"", "value=\"2.5\""), "left out: 1 curve’s blur");
    assert_eq!(notes("R=\"3\"", "R=\"red\""), "left out: 1 colour without all its numbers");
    assert_eq!(notes(" globalID=\"0\" B", " B"), "left out: 1 colour without all its numbers");
    for bad in ["NaN", "1e999", "", "3e300"] {
        let bad = format!("x=\"{bad}\" y=\"10\"");
        assert_eq!(notes("x=\"30\" y=\"10\"", &bad), "left out: 1 curve with unusable control points");
    }
}

#[test]
fn control_points_past_the_last_whole_cubic_are_of_no_account() {
    let longer = CURVES.replacen(
        "  </control_points_set>",
        "<control_point x=\"9\" y=\"9\"/></control_points_set>",
        1,
    );
    assert_eq!(read(&longer).drawing.curves, read(CURVES).drawing.curves);
}

#[test]
fn colours_out_of_range_are_the_nearest() {
    let odd = CURVES.replacen(
        "G=\"2\" R=\"3\" globalID=\"0\" B=\"1\"",
        "G=\"-9\" R=\"1e300\" globalID=\"-5\" B=\"12.6\"",
        1,
    );
    let point = read(&odd).color_points[0];
    assert_eq!((point.at_du, point.color), (0.0, Paint::Color(Srgb8([13, 0, 255]))));
}

#[test]
fn the_page_has_as_many_digits_as_files_have() {
    let text = CURVES.replacen("image_width=\"200\"", "image_width=\"0.12345678912\"", 1);
    assert_eq!(read(&text).drawing.page.width(), 0.123456789);
}

#[test]
fn what_are_no_diffusion_curves_says_so() {
    refused(&CURVES.replacen("image_width=\"200\"", "", 1), &ImportError::NoImageSize);
    refused(&CURVES.replacen("image_height=\"100\"", "image_height=\"0\"", 1), &ImportError::NoImageSize);
    refused(&CURVES.replacen("image_height=\"100\"", "image_height=\"1e99\"", 1), &ImportError::NoImageSize);
    refused(&CURVES.replace("control_points_set", "points"), &ImportError::NoDiffusionCurves);
    refused("<curve_set image_width=\"9\" image_height=\"9\"/>", &ImportError::NoDiffusionCurves);
    refused("<scene><curve_set/></scene>", &ImportError::NotSvg("scene".into()));
    let broken = import_drawing(CURVES.replacen("</control_points_set>", "", 1).as_bytes()).unwrap_err();
    assert!(matches!(&broken, ImportError::CurvesNotXml(_)));
    // Row and column, as the parser tells them.
    let text = broken.to_string();
    assert!(
        text.starts_with(
            "the diffusion curves are damaged: expected 'control_points_set' tag, not 'curve' at "
        ),
        "{text}"
    );
}

#[test]
fn curves_made_to_hurt_are_refused() {
    let head = "<curve_set image_width=\"9\" image_height=\"9\">";
    refused(&[head, &"<curve/>".repeat(200_001), "</curve_set>"].concat(), &ImportError::TooManyCurves);
    refused(&[head, &" ".repeat(20_000_000), "</curve_set>"].concat(), &ImportError::TooLarge);
    let deep = [head, &"<curve>".repeat(400_000), &"</curve>".repeat(400_000), "</curve_set>"].concat();
    refused(&deep, &ImportError::NoDiffusionCurves);
    let bomb = ["<!DOCTYPE a [<!ENTITY a \"aa\"><!ENTITY b \"&a;&a;\">]>", head, "&b;</curve_set>"].concat();
    refused(&bomb, &ImportError::Entities);
}

#[test]
fn an_svg_that_speaks_of_curves_is_an_svg() {
    let svg = r#"<svg viewBox="0 0 9 9"><!-- <curve_set> --><path d="M1 1h6" stroke="black"/></svg>"#;
    assert_eq!(read(svg).drawing.curves.len(), 1);
}

#[test]
fn what_ends_at_the_border_of_a_page_ends_there_in_the_file() {
    for [width, height] in [[600, 250], [600, 300], [600, 400], [49, 30], [1000, 7]] {
        let svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}">
                <path d="M30 0V{height}" stroke="black"/></svg>"#
        );
        let document = Document::new(import_svg(svg.as_bytes()).unwrap().drawing);
        let map = PlanarMap::build(&document.drawing, &Sampling::default()).unwrap();
        let (text, _) = write_curve_set(&document, &map, &Labels::none(&map));
        assert!(text.contains("image_width=\"1024\""));
        let drawing = read(&text).drawing;
        let bounds = drawing.curves[0].path.bounding_box();
        assert!(bounds.y0 <= 0.0 && bounds.y1 >= drawing.size_du().height, "{height}: {bounds:?}");
    }
}
