//! Shading scribbles on pixels, beside the mesh solver's.

use kurbo::{Affine, BezPath, Circle, Line, Point, Rect, Shape};
use scumble_core::{
    Bends, Boundary, Curve, Document, Drawing, PenPressure, Scribble, ScribbleKind, Shading, Srgb8,
};
use scumble_solve::grid::{Constraints, GridPicture, GridSolver};
use scumble_solve::{Picture, Pixmap, Scene, View, paint, paint_grid};

const YELLOW: Srgb8 = Srgb8([255, 230, 0]);
const BLUE: Srgb8 = Srgb8([0, 0, 255]);
const RED: Srgb8 = Srgb8([200, 30, 60]);
const PAPER: Option<Srgb8> = Some(Srgb8([255; 3]));

/// Two circles that overlap, in a rectangle that a line nearly divides.
fn document(scribbles: Vec<Scribble>) -> Document {
    let circles = [(400.0, 400.0), (640.0, 400.0)].map(|at| Circle::new(at, 220.0).to_path(1e-6));
    let frame = Rect::new(60.0, 60.0, 960.0, 960.0).to_path(1e-6);
    let lines = [(60.0, 500.0), (540.0, 960.0)].map(|(x0, x1)| Line::new((x0, 780.0), (x1, 780.0)));
    let paths: Vec<BezPath> =
        circles.into_iter().chain([frame]).chain(lines.map(|line| line.to_path(1e-6))).collect();
    let curves = paths.into_iter().map(|path| Curve { path, line: None }).collect();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
    Document { scribbles, ..Document::new(drawing) }
}

fn scribble(color: Srgb8, kind: ScribbleKind, width_du: f64, points: &[(f64, f64)]) -> Scribble {
    let points = points.iter().copied().map(Point::from).collect();
    Scribble { color: color.into(), kind, width_du, points }
}

fn fill(color: Srgb8, (x, y): (f64, f64)) -> Scribble {
    scribble(color, ScribbleKind::Fill, 8.0, &[(x, y), (x + 10.0, y)])
}

fn shade(strength: f64, crosses: bool, width_du: f64, points: &[(f64, f64)]) -> Scribble {
    scribble(RED, ScribbleKind::Shade(Shading { strength, crosses, ..Shading::default() }), width_du, points)
}

fn on_mesh(picture: &mut Picture, document: &Document, boundary: &Boundary, view: &View) -> Pixmap {
    let field = picture.mesh().solve(boundary, document.settings.blend).expect("a field");
    paint(&Scene { paper: PAPER, field, shapes: &[] }, view)
}

fn on_grid(picture: &Picture, document: &Document, boundary: &Boundary, view: &View) -> Pixmap {
    let mut solver = GridSolver::new(&Constraints::new(picture.map(), boundary, view).expect("solved"));
    solver.solve(1e-4);
    let pixels = solver.pixels().to_vec();
    let straight = Bends::default();
    let found = GridPicture::new(picture.map(), &straight, boundary, view, document.settings.blend, pixels);
    paint_grid(&found, &[], view, PAPER)
}

/// The pixels of the mesh solver's picture that shades change, and the grid solver's there. The gap is closed.
fn shaded(scribbles: &[Scribble], size_px: u32) -> Vec<[[u8; 4]; 2]> {
    let document = document(scribbles.to_vec());
    let scale = f64::from(size_px) / 1024.0;
    let view = View { px_from_du: Affine::scale(scale), width_px: size_px, height_px: size_px };
    let mut picture = Picture::new(&document.drawing).expect("a map");
    let gaps = picture.map().gaps().len();
    assert!(gaps > 0);
    let colors = picture.color(&document.scribbles, &[], &document.settings);
    let boundary = Boundary { closed_gaps: vec![true; gaps], ..colors.clone() };
    let grid = on_grid(&picture, &document, &boundary, &view);
    let mesh = on_mesh(&mut picture, &document, &boundary, &view);
    let bare = Boundary { sources: Vec::new(), ..boundary };
    let bare = on_mesh(&mut picture, &document, &bare, &view);
    let [grid, mesh, bare] = [&grid, &mesh, &bare].map(|pixmap| pixmap.rgba.as_chunks().0);
    let pixels = grid.iter().zip(mesh).zip(bare);
    pixels.filter(|((_, mesh), bare)| mesh != bare).map(|((grid, mesh), _)| [*grid, *mesh]).collect()
}

/// Checks the worst channels of the pixels that shades change: their mean difference, in levels, and what one in twenty
/// is above.
fn assert_near(name: &str, scribbles: &[Scribble], size_px: u32) {
    let pixels = shaded(scribbles, size_px);
    let worst = |[a, b]: &[[u8; 4]; 2]| a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).fold(0, u8::max);
    let mut levels: Vec<_> = pixels.iter().map(worst).map(f64::from).collect();
    levels.sort_by(f64::total_cmp);
    let differences = [levels.iter().sum::<f64>() / levels.len() as f64, levels[levels.len() * 95 / 100]];
    println!("{name}: {differences:?} of {} px", levels.len());
    assert!(differences[0] <= NEAR[0] && differences[1] <= NEAR[1], "{name}: {differences:?}");
}

/// What a picture on pixels may differ by.
const NEAR: [f64; 2] = [0.6, 1.0];

const BENT: [(f64, f64); 4] = [(220.0, 380.0), (260.0, 300.0), (330.0, 320.0), (520.0, 420.0)];

#[test]
fn strokes_within_coloured_shapes_are_those_of_the_mesh() {
    let fills =
        || vec![fill(YELLOW, (260.0, 400.0)), fill(BLUE, (500.0, 400.0)), fill(YELLOW, (800.0, 400.0))];
    for (strength, width_du, size_px) in
        [(0.2, 90.0, 256), (0.5, 30.0, 256), (1.0, 60.0, 256), (1.0, 12.0, 512)]
    {
        let with = |shade| fills().into_iter().chain([shade]).collect::<Vec<_>>();
        assert_near("stroke", &with(shade(strength, false, width_du, &BENT)), size_px);
        assert_near("dab", &with(shade(strength, false, width_du, &BENT[..1])), size_px);
        assert_near("crossing", &with(shade(strength, true, width_du, &BENT)), size_px);
    }
}

#[test]
fn strokes_of_a_pen_that_presses_more_or_less_are_those_of_the_mesh() {
    let parts = vec![0.2, 1.0, 0.6, 0.1];
    for pressure in [PenPressure::Radius(parts.clone()), PenPressure::Strength(parts)] {
        let kind = ScribbleKind::Shade(Shading { strength: 0.9, crosses: true, pressure });
        let scribbles =
            vec![fill(YELLOW, (260.0, 400.0)), fill(BLUE, (500.0, 400.0)), scribble(RED, kind, 80.0, &BENT)];
        assert_near("pressed", &scribbles, 512);
    }
}

#[test]
fn strokes_thinner_than_a_pixel_are_those_of_the_mesh() {
    let scribbles =
        vec![fill(YELLOW, (260.0, 400.0)), shade(1.0, false, 3.0, &BENT), fill(BLUE, (500.0, 400.0))];
    assert_near("thin", &scribbles, 256);
}

#[test]
fn a_shade_where_nothing_has_a_colour_fades_into_the_paper() {
    let way = [(120.0, 120.0), (150.0, 300.0), (140.0, 600.0), (300.0, 700.0)];
    assert_near("around", &[shade(0.8, false, 50.0, &way), fill(BLUE, (500.0, 400.0))], 512);
    assert_near("across", &[shade(0.8, true, 50.0, &BENT)], 512);
}

#[test]
fn a_closed_gap_keeps_a_shade_on_its_side() {
    let near_gap = [(480.0, 740.0), (560.0, 745.0)];
    let scribbles =
        vec![shade(0.8, false, 90.0, &near_gap), fill(YELLOW, (300.0, 700.0)), fill(BLUE, (300.0, 860.0))];
    assert_near("gap", &scribbles, 512);
}
