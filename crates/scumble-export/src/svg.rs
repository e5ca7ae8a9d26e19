//! A picture as SVG 1.1 (Second Edition), in the parts of it that every program shows alike: paths, and pixels for
//! shades. One unit is a du.

use kurbo::{Cap, Join, Stroke};
use scumble_core::{Rgba8, Srgb8};
use scumble_io::{COLORS_CLASS, FileError, base64, write_svg_source};

use crate::export::Export;
use crate::ink::{Ink, Manner, ink};
use crate::numbers::{number, svg_path};
use crate::regions::{Flat, SEAM_DU};
use crate::sheet::Sheet;

/// The document.
pub(crate) fn written(export: &Export, raster: Option<&[u8]>) -> Result<String, FileError> {
    let source = write_svg_source(export.work)?;
    let sheet = export.sheet();
    let [width, height] = &sheet.sides;
    let [width_du, height_du] = sheet.sides_du().map(number);
    let mut text = String::from("<svg xmlns=\"http://www.w3.org/2000/svg\"");
    text.push_str(" xmlns:xlink=\"http://www.w3.org/1999/xlink\"");
    text.extend([" width=\"", width, "\" height=\"", height]);
    text.extend(["\" viewBox=\"0 0 ", &width_du, " ", &height_du, "\">\n", &source]);
    if let Some(paper) = export.look.paper {
        let paper = paper.to_string();
        text.extend([
            "<rect width=\"",
            &width_du,
            "\" height=\"",
            &height_du,
            "\" fill=\"",
            &paper,
            "\"/>\n",
        ]);
    }
    text.extend(["<g class=\"", COLORS_CLASS, "\">\n"]);
    push_colors(&mut text, export, raster);
    text.push_str("</g>\n");
    if export.look.lines {
        ink(&export.work.document.drawing).for_each(|ink| push_ink(&mut text, &ink));
    }
    text.push_str("</svg>\n");
    Ok(text)
}

/// Pixels hold the colours of all regions, so that nothing shines through between them and the areas over them. Where
/// there are none, lines along the seams do that.
fn push_colors(text: &mut String, export: &Export, raster: Option<&[u8]>) {
    let flats = &export.regions.flats;
    match (raster, export.raster_view()) {
        (Some(png), Some(view)) => push_raster(text, png, Sheet::of_view(&view).sides_du()),
        _ => flats.iter().for_each(|flat| push_seams(text, flat)),
    }
    for Flat { color, path, .. } in flats {
        text.extend([
            "<path fill=\"",
            &color.to_string(),
            "\" fill-rule=\"evenodd\" d=\"",
            &svg_path(path),
            "\"/>\n",
        ]);
    }
}

fn push_raster(text: &mut String, png: &[u8], size_du: [f64; 2]) {
    let [width_du, height_du] = size_du.map(number);
    text.extend(["<image width=\"", &width_du, "\" height=\"", &height_du]);
    text.push_str("\" preserveAspectRatio=\"none\" xlink:href=\"data:image/png;base64,");
    text.extend([&base64(png), "\"/>\n"]);
}

fn push_seams(text: &mut String, Flat { color, seams, .. }: &Flat) {
    if !seams.is_empty() {
        text.extend([
            "<path fill=\"none\" stroke=\"",
            &color.to_string(),
            "\" stroke-width=\"",
            &number(SEAM_DU),
        ]);
        text.extend(["\" d=\"", &svg_path(seams), "\"/>\n"]);
    }
}

fn push_ink(text: &mut String, Ink { path, color: Rgba8([r, g, b, alpha]), manner }: &Ink) {
    let color = Srgb8([*r, *g, *b]).to_string();
    text.push_str("<path");
    let opacity = match manner {
        Manner::Fill { even_odd } => {
            push_attribute(text, "fill", &color);
            if *even_odd {
                push_attribute(text, "fill-rule", "evenodd");
            }
            "fill-opacity"
        }
        Manner::Line(stroke) => {
            push_attribute(text, "fill", "none");
            push_attribute(text, "stroke", &color);
            push_stroke(text, stroke);
            "stroke-opacity"
        }
    };
    if *alpha < 255 {
        push_attribute(text, opacity, &number(f64::from(*alpha) / 255.0));
    }
    push_attribute(text, "d", &svg_path(path));
    text.push_str("/>\n");
}

/// What is not as SVG has it where nothing is said.
fn push_stroke(text: &mut String, stroke: &Stroke) {
    push_attribute(text, "stroke-width", &number(stroke.width));
    match stroke.end_cap {
        Cap::Butt => {}
        Cap::Round => push_attribute(text, "stroke-linecap", "round"),
        Cap::Square => push_attribute(text, "stroke-linecap", "square"),
    }
    match stroke.join {
        Join::Miter => push_attribute(text, "stroke-miterlimit", &number(stroke.miter_limit.max(1.0))),
        Join::Round => push_attribute(text, "stroke-linejoin", "round"),
        Join::Bevel => push_attribute(text, "stroke-linejoin", "bevel"),
    }
    if !stroke.dash_pattern.is_empty() {
        let dashes: Vec<_> = stroke.dash_pattern.iter().map(|&dash| number(dash)).collect();
        push_attribute(text, "stroke-dasharray", &dashes.join(" "));
        push_attribute(text, "stroke-dashoffset", &number(stroke.dash_offset));
    }
}

fn push_attribute(text: &mut String, name: &str, value: &str) {
    text.extend([" ", name, "=\"", value, "\""]);
}
