//! Coloured drawings of a few kinds, as the painter paints them, and how far another program's picture is from that.

use kurbo::Point;
use scumble_core::{Blend, Document, Paint, Scribble, ScribbleKind, Srgb8, Work};
use scumble_export::{Export, Look};
use scumble_io::{import_svg, write_png};
use scumble_solve::{Field, Picture, Pixmap, Scene, View, line_shapes, paint};

pub(crate) const WHITE: Srgb8 = Srgb8([255; 3]);

/// Neighbours that differ by more than this, in levels, are at an edge.
const EDGE_LEVELS: u8 = 12;

/// An edge reaches this far, in pixels.
const EDGE_PX: usize = 2;

/// Two rooms beside each other.
const ROOMS: &str = r#"<path d="M40 40H200V210H40Z"/><path d="M200 40H360V210H200"/>"#;

/// A room with a curve in it that ends within, so that the colours of its sides meet around its end.
const ARM: &str = r#"<path d="M30 30H370V270H30Z"/><path d="M30 150C110 60 150 240 220 130"/>"#;

/// A drawing with scribbles, and its field.
pub(crate) struct Made {
    pub(crate) work: Work,
    pub(crate) field: Field,
}

impl Made {
    fn new(content: &str, blend: Blend, scribbles: &[(Paint, [(f64, f64); 2])]) -> Self {
        let svg = format!(
            r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300">
            <g fill="none" stroke="black" stroke-width="2">{content}</g></svg>"#
        );
        let mut document = Document::new(import_svg(svg.as_bytes()).unwrap().drawing);
        document.settings.blend = blend;
        document.scribbles = scribbles.iter().map(|(color, points)| scribble(*color, points)).collect();
        let field = Picture::new(&document.drawing).unwrap().update(&document).unwrap().clone();
        Self { work: Work::new(document), field }
    }

    /// Regions of one colour each.
    pub(crate) fn flat() -> Self {
        let [red, blue] = [Srgb8([230, 25, 75]), Srgb8([0, 130, 200])].map(Paint::from);
        let scribbles = [(red, [(80.0, 90.0), (150.0, 150.0)]), (blue, [(250.0, 90.0), (310.0, 150.0)])];
        Self::new(ROOMS, Blend::Oklab, &scribbles)
    }

    /// A flat room, and a shaded one that shares a wall with it.
    pub(crate) fn mixed() -> Self {
        let [red, blue, yellow] =
            [Srgb8([230, 25, 75]), Srgb8([0, 130, 200]), Srgb8([255, 225, 25])].map(Paint::from);
        let content = [ROOMS, r#"<path d="M200 125C240 80 270 170 310 120"/>"#].concat();
        let scribbles = [
            (red, [(80.0, 90.0), (150.0, 150.0)]),
            (blue, [(240.0, 60.0), (300.0, 70.0)]),
            (yellow, [(240.0, 180.0), (300.0, 190.0)]),
        ];
        Self::new(&content, Blend::Oklab, &scribbles)
    }

    /// Two colours that meet, and pass into each other.
    pub(crate) fn shaded(blend: Blend) -> Self {
        let [orange, violet] = [Srgb8([245, 130, 48]), Srgb8([66, 20, 160])].map(Paint::from);
        Self::new(
            ARM,
            blend,
            &[(orange, [(90.0, 60.0), (260.0, 70.0)]), (violet, [(90.0, 230.0), (260.0, 240.0)])],
        )
    }

    /// A colour that fades into the paper.
    pub(crate) fn fading() -> Self {
        let orange = Srgb8([245, 130, 48]).into();
        let scribbles =
            [(orange, [(90.0, 60.0), (260.0, 70.0)]), (Paint::Clear, [(90.0, 230.0), (260.0, 240.0)])];
        Self::new(ARM, Blend::Oklab, &scribbles)
    }

    /// Lines of every kind, over colours.
    pub(crate) fn lined() -> Self {
        let teal = Srgb8([18, 165, 148]).into();
        let content = r##"<path d="M40 40H360V210H40Z" stroke-width="9" stroke-linejoin="round"/>
            <path d="M60 250L120 220L180 260L240 220" stroke-width="7" stroke="#a52" stroke-linecap="square"/>
            <path d="M70 70L90 180L110 70" stroke-width="8" stroke-miterlimit="20" stroke-opacity="0.5"/>
            <path d="M150 70L170 180L190 70" stroke-width="8" stroke-linejoin="bevel"/>
            <path d="M220 60C320 60 200 190 330 190" stroke-width="5" stroke-linecap="round"
                stroke-dasharray="10 8 0" stroke-dashoffset="-3" stroke="#048"/>
            <path d="M280 240H380V290H280ZM300 250H350V280H300Z" fill="#222" fill-rule="evenodd" stroke="none"/>"##;
        Self::new(content, Blend::Oklab, &[(teal, [(60.0, 195.0), (340.0, 200.0)])])
    }

    pub(crate) fn all() -> [(&'static str, Self); 6] {
        [
            ("flat", Self::flat()),
            ("mixed", Self::mixed()),
            ("shaded", Self::shaded(Blend::Oklab)),
            ("shaded in sRGB", Self::shaded(Blend::Srgb)),
            ("fading", Self::fading()),
            ("lined", Self::lined()),
        ]
    }

    pub(crate) fn export(&self, look: Look) -> Export<'_> {
        Export::new(&self.work, &self.field, look)
    }

    /// The SVG, with pixels where it needs some.
    pub(crate) fn svg(&self, look: Look) -> String {
        let export = self.export(look);
        let raster = export.raster_view().map(|view| {
            let pixmap = paint(&Scene { paper: look.paper, field: &self.field, shapes: &[] }, &view);
            write_png(pixmap.width_px, pixmap.height_px, &pixmap.rgba).unwrap()
        });
        export.svg(raster.as_deref()).unwrap()
    }

    /// The picture as it should be.
    pub(crate) fn painted(&self, look: Look) -> Pixmap {
        let drawing = &self.work.document.drawing;
        let scale = f64::from(look.size_px) / 1024.0;
        let size = drawing.size_du() * scale;
        let view = View {
            px_from_du: kurbo::Affine::scale(scale),
            width_px: size.width.round() as u32,
            height_px: size.height.round() as u32,
        };
        let shapes = if look.lines {
            line_shapes(drawing, Some(Picture::new(drawing).unwrap().map()), 0.1)
        } else {
            Vec::new()
        };
        paint(&Scene { paper: look.paper, field: &self.field, shapes: &shapes }, &view)
    }
}

fn scribble(color: Paint, points: &[(f64, f64); 2]) -> Scribble {
    let du = 1024.0 / 400.0;
    let points = points.iter().map(|&(x, y)| Point::new(du * x, du * y)).collect();
    Scribble { color, kind: ScribbleKind::Fill, width_du: 10.0, points }
}

/// Asserts that two pictures differ by at most so many levels in the mean, and nowhere much, where neither has an edge.
#[track_caller]
pub(crate) fn assert_same(shown: &Pixmap, expected: &Pixmap, mean_levels: f64, name: &str) {
    assert_eq!([shown.width_px, shown.height_px], [expected.width_px, expected.height_px], "{name}");
    let [a, b] = [shown, expected].map(over_white);
    let width = expected.width_px as usize;
    let inner = inner(&[&a, &b], width);
    assert!(inner.len() * 4 > 3 * a.len(), "{name}: most pixels are away from edges");
    let differences: Vec<_> = inner
        .iter()
        .flat_map(|&i| (0..3).map(move |c| (c, i)))
        .map(|(c, i)| a[i][c].abs_diff(b[i][c]))
        .collect();
    let mean = differences.iter().copied().map(f64::from).sum::<f64>() / differences.len() as f64;
    let most = differences.iter().copied().max().unwrap();
    println!("{name}: {mean:.3} levels in the mean, {most} at most");
    assert!(mean <= mean_levels, "{name}: {mean} levels in the mean, {most} at most");
    assert!(most <= 2 * EDGE_LEVELS, "{name}: {most} levels");
}

fn over_white(picture: &Pixmap) -> Vec<[u8; 3]> {
    let (pixels, _) = picture.rgba.as_chunks::<4>();
    let over = |c: u8, alpha: u8| {
        ((u32::from(c) * u32::from(alpha) + 255 * (255 - u32::from(alpha)) + 127) / 255) as u8
    };
    pixels.iter().map(|&[r, g, b, alpha]| [r, g, b].map(|c| over(c, alpha))).collect()
}

/// The pixels that no edge of any picture is near.
fn inner(pictures: &[&Vec<[u8; 3]>], width: usize) -> Vec<usize> {
    let height = pictures[0].len() / width;
    let mut is_inner = vec![true; pictures[0].len()];
    for picture in pictures {
        let differ = |i: usize, j: usize| (0..3).any(|c| picture[i][c].abs_diff(picture[j][c]) > EDGE_LEVELS);
        for i in 0..picture.len() {
            let [x, y] = [i % width, i / width];
            let is_edge = x + 1 < width && differ(i, i + 1) || y + 1 < height && differ(i, i + width);
            if is_edge {
                for row in y.saturating_sub(EDGE_PX)..(y + EDGE_PX + 1).min(height) {
                    let columns = x.saturating_sub(EDGE_PX)..(x + EDGE_PX + 1).min(width);
                    is_inner[row * width..][columns].fill(false);
                }
            }
        }
    }
    (0..is_inner.len()).filter(|&i| is_inner[i]).collect()
}
