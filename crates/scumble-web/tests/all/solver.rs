//! Which solver makes the picture on the canvas, and what its painter is given for that.

use kurbo::{Point, Rect, Vec2};
use scumble_core::{Blend, Document, PlanarMap, Sampling, Srgb8, Work, exact};
use scumble_io::import_svg;
use scumble_solve::View;
use scumble_solve::grid::{Constraints, GridProblem};
use scumble_web::command::{Command, Phase, Setting, Tool, ViewChange};
use scumble_web::effect::Effect;
use scumble_web::painting::{Changed, Painter, Painting};
use scumble_web::session::Session;
use scumble_web::solver::{Grids, Solver, SolverState, Source};

use crate::zigzags::zigzags;

/// A painter that takes three frames for a grid, and notes what it is given.
#[derive(Default)]
struct Screen {
    frames_left: usize,
    /// Of each frame: the longer side of the grid, or 0 for a field; and whether it is another than before.
    frames: Vec<(u32, bool)>,
    constraints: Option<Constraints>,
    /// The part that is solved by itself, and how often it was another one.
    part: Option<GridProblem>,
    parts: usize,
}

impl Painter for Screen {
    fn paint(&mut self, painting: &Painting<'_>, changed: Changed) -> bool {
        self.part = painting.part.cloned();
        self.parts += usize::from(changed.part);
        let Some(problem) = painting.problem else {
            self.frames.push((0, changed.field.is_any()));
            return true;
        };
        let is_other = changed.problem && self.constraints.as_ref() != Some(&problem.constraints);
        self.frames.push((problem.view.width_px, is_other));
        self.constraints = Some(problem.constraints.clone());
        self.frames_left = if changed.problem { 2 } else { self.frames_left.saturating_sub(1) };
        self.frames_left == 0
    }
}

/// A square within a page of 1024 by 768 du.
const SQUARE: &[u8] = br#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1024 768">
    <path d="M200 150H680V630H200Z" fill="none" stroke="black" stroke-width="8"/></svg>"#;

/// A page whose painter can do this with grids.
fn page(grids: Grids) -> (Session, Screen) {
    page_with(SQUARE, grids)
}

fn page_with(svg: &[u8], grids: Grids) -> (Session, Screen) {
    let mut session = Session::new(Srgb8([90; 3])).expect("a blank page");
    let drawing = import_svg(svg).expect("a drawing").drawing;
    let work = exact::write(&Work::new(Document::new(drawing)));
    session.set_grids(grids);
    session.command(Command::View(ViewChange::Resize {
        size_px: [1200, 900],
        px_per_css: 1.0,
        corner_css: Point::ZERO,
    }));
    session.command(Command::Open { work, notes: String::new() });
    session.command(Command::View(ViewChange::ZoomReset));
    (session, Screen::default())
}

fn draw(session: &mut Session, phase: Phase, [x, y]: [f64; 2]) {
    let p = session.css_from_du() * Point::new(x, y);
    session.pointer(phase, &[p.x as f32, p.y as f32, 1.0]);
}

fn frames(session: &mut Session, screen: &mut Screen) -> Vec<(u32, bool)> {
    while session.frame(screen) {
        session.make_on();
    }
    std::mem::take(&mut screen.frames)
}

fn source(session: &mut Session) -> Option<SolverState> {
    let effects = session.take_effects();
    effects.into_iter().rev().find_map(|effect| match effect {
        Effect::Solver(state) => Some(state),
        _ => None,
    })
}

#[test]
fn the_mesh_solver_makes_the_picture_of_a_small_drawing() {
    let (mut session, mut screen) = page(Grids::Fast);
    assert_eq!(frames(&mut session, &mut screen), [(0, true)]);
    assert_eq!(source(&mut session), Some(SolverState { asked: Solver::Automatic, source: Source::Mesh }));
}

#[test]
fn a_grid_is_painted_until_it_is_solved_and_then_left() {
    let (mut session, mut screen) = page(Grids::Fast);
    session.command(Command::Solver(Solver::Gpu));
    assert_eq!(frames(&mut session, &mut screen), [(1024, true), (1024, false), (1024, false)]);
    assert_eq!(source(&mut session), Some(SolverState { asked: Solver::Gpu, source: Source::Grid }));
    assert_eq!(frames(&mut session, &mut screen), []);
    session.command(Command::Solver(Solver::Mesh));
    assert_eq!(frames(&mut session, &mut screen), [(0, true)]);
}

#[test]
fn a_grid_is_coarser_while_the_pen_is_down() {
    let (mut session, mut screen) = page(Grids::Fast);
    session.command(Command::Solver(Solver::Gpu));
    session.command(Command::Color(Srgb8([1, 2, 3]).into()));
    frames(&mut session, &mut screen);
    draw(&mut session, Phase::Down, [300.0, 300.0]);
    assert_eq!(frames(&mut session, &mut screen)[0], (512, true));
    draw(&mut session, Phase::Up, [400.0, 400.0]);
    assert_eq!(frames(&mut session, &mut screen)[0], (1024, true));
}

fn view_of_part(screen: &Screen) -> View {
    screen.part.as_ref().expect("a part").view
}

/// What a canvas shows, and what a part of the page is, in du.
fn seen_and_solved_du(session: &Session, part: &View) -> [Rect; 2] {
    let canvas_css = Rect::new(0.0, 0.0, 1200.0, 900.0);
    let part_px = Rect::new(0.0, 0.0, part.width_px.into(), part.height_px.into());
    [
        session.css_from_du().inverse().transform_rect_bbox(canvas_css),
        part.px_from_du.inverse().transform_rect_bbox(part_px),
    ]
}

#[test]
fn from_close_by_what_is_in_view_is_solved_on_pixels_that_stay_where_they_are_under_a_pan() {
    let (mut session, mut screen) = page(Grids::Fast);
    session.command(Command::Solver(Solver::Gpu));
    frames(&mut session, &mut screen);
    assert!(screen.part.is_none());

    look_closely(&mut session);
    assert_eq!(frames(&mut session, &mut screen)[0].0, 1024);
    assert_eq!(source(&mut session), Some(SolverState { asked: Solver::Gpu, source: Source::Grid }));
    let (first, parts) = (view_of_part(&screen), screen.parts);
    let [scale, .., x, y] = first.px_from_du.as_coeffs();
    assert_eq!(scale, 16.0);
    assert!(first.width_px.max(first.height_px) <= 2047, "textures of every device hold it");
    let [seen_du, solved_du] = seen_and_solved_du(&session, &first);
    assert_eq!(solved_du.inflate(-8.0, -8.0).union(seen_du), solved_du.inflate(-8.0, -8.0));

    session.command(Command::View(ViewChange::Pan(Vec2::new(-100.0, 50.0))));
    frames(&mut session, &mut screen);
    assert_eq!((view_of_part(&screen), screen.parts), (first, parts), "there was some around it");
    session.command(Command::View(ViewChange::Pan(Vec2::new(-100.0, 50.0))));
    frames(&mut session, &mut screen);
    let next = view_of_part(&screen);
    assert_eq!(screen.parts, parts + 1);
    let [next_scale, .., next_x, next_y] = next.px_from_du.as_coeffs();
    let shift = [next_x - x, next_y - y];
    assert!(next_scale == scale && shift.iter().all(|shift| *shift != 0.0 && shift.fract() == 0.0));

    session.command(Command::View(ViewChange::Fit));
    frames(&mut session, &mut screen);
    assert!(screen.part.is_none());
}

/// Looks at the lower right corner of the square from close by.
fn look_closely(session: &mut Session) {
    let corner = session.css_from_du() * Point::new(680.0, 630.0);
    session.command(Command::View(ViewChange::ZoomAt(corner, 16.0)));
}

#[test]
fn what_is_done_to_a_drawing_is_done_to_the_part_that_is_in_view() {
    let (mut session, mut screen) = page(Grids::Fast);
    session.command(Command::Solver(Solver::Gpu));
    session.command(Command::Color(Srgb8([1, 2, 3]).into()));
    look_closely(&mut session);
    frames(&mut session, &mut screen);
    let first = screen.part.clone().expect("a part");
    draw(&mut session, Phase::Down, [670.0, 620.0]);
    draw(&mut session, Phase::Up, [675.0, 622.0]);
    frames(&mut session, &mut screen);
    let colored = screen.part.clone().expect("a part");
    assert_eq!(colored.view, first.view);
    assert_ne!(colored.constraints, first.constraints);
    session.command(Command::Set(Setting::Blend(Blend::Srgb)));
    frames(&mut session, &mut screen);
    assert_eq!(screen.part.as_ref().map(|part| part.blend), Some(Blend::Srgb));
    for expected in [&colored, &first] {
        session.command(Command::Undo);
        frames(&mut session, &mut screen);
        let part = screen.part.as_ref().expect("a part");
        assert_eq!((part.view, part.blend), (expected.view, expected.blend));
        assert_eq!((&part.constraints, &part.curves), (&expected.constraints, &expected.curves));
    }
}

/// A circle of 20 du, which pieces of 6 du follow within a tenth.
const CIRCLE: &[u8] = br#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1024 768">
    <circle cx="680" cy="630" r="20" fill="none" stroke="black" stroke-width="1"/></svg>"#;

#[test]
fn from_close_by_a_part_has_curves_as_they_bend() {
    let (mut session, mut screen) = page_with(CIRCLE, Grids::Fast);
    session.command(Command::Solver(Solver::Gpu));
    look_closely(&mut session);
    frames(&mut session, &mut screen);
    let part = screen.part.expect("a part");
    let du_from_px = part.view.px_from_du.inverse();
    let mut count = 0;
    for [ax, ay, bx, by] in part.curves.pieces.iter().map(|piece| piece.map(f64::from)) {
        let middle = du_from_px * Point::new(ax, ay).midpoint(Point::new(bx, by));
        let off_px = 16.0 * ((middle - Point::new(680.0, 630.0)).hypot() - 20.0);
        assert!(off_px.abs() < 0.3, "{off_px} px off at {middle}");
        count += 1;
    }
    assert!(count > 100);
}

/// Rotated and on a large canvas, where a part would have more pixels than textures of every device.
#[test]
fn a_part_is_never_coarser_than_the_whole_would_be_and_turns_with_the_page() {
    let (mut session, mut screen) = page(Grids::Fast);
    let (size_px, corner_css) = ([3840, 2160], Point::ZERO);
    session.command(Command::View(ViewChange::Resize { size_px, px_per_css: 1.0, corner_css }));
    session.command(Command::Solver(Solver::Gpu));
    let middle = Point::new(1920.0, 1080.0);
    for _ in 0..40 {
        session.command(Command::View(ViewChange::ZoomAt(middle, 1.1)));
        session.command(Command::View(ViewChange::RotateAt(middle, 5.0)));
        let whole_px = frames(&mut session, &mut screen)[0].0;
        let scale = |view: &View| view.px_from_du.as_coeffs()[0];
        let Some(part) = screen.part.as_ref().map(|part| part.view) else { continue };
        assert!(scale(&part) > 2.0 * 1.18, "{part:?}");
        assert!(whole_px <= 1024 && part.width_px.max(part.height_px) <= 2047, "{part:?}");
    }
    assert!(screen.part.is_some());
}

#[test]
fn without_a_graphics_card_a_part_has_few_pixels_too() {
    let (mut session, mut screen) = page(Grids::Slow);
    session.command(Command::Solver(Solver::Gpu));
    frames(&mut session, &mut screen);
    assert!(screen.part.is_none(), "nothing is won");
    look_closely(&mut session);
    assert_eq!(frames(&mut session, &mut screen)[0].0, 256);
    let part = view_of_part(&screen);
    assert!(part.width_px.max(part.height_px) <= 256, "{part:?}");
}

#[test]
fn a_picture_for_a_file_leaves_the_grid_as_it_is() {
    let (mut session, mut screen) = page(Grids::Fast);
    session.command(Command::Solver(Solver::Gpu));
    session.command(Command::Color(Srgb8([1, 2, 3]).into()));
    draw(&mut session, Phase::Down, [300.0, 300.0]);
    draw(&mut session, Phase::Up, [400.0, 400.0]);
    frames(&mut session, &mut screen);
    assert!(!session.export(64.0, false).field.triangles.is_empty());
    assert!(
        frames(&mut session, &mut screen).iter().all(|(side_px, is_other)| *side_px == 1024 && !is_other)
    );
}

#[test]
fn a_painter_that_comes_in_the_place_of_a_lost_one_is_given_everything() {
    let (mut session, mut screen) = page(Grids::Fast);
    session.command(Command::Solver(Solver::Gpu));
    session.frame(&mut screen);
    session.repaint();
    let mut next = Screen::default();
    assert_eq!(frames(&mut session, &mut next), [(1024, true), (1024, false), (1024, false)]);
    session.set_grids(Grids::No);
    session.repaint();
    assert_eq!(frames(&mut session, &mut next), [(0, true)]);
    let state = SolverState { asked: Solver::Gpu, source: Source::MeshWithoutGpu };
    assert_eq!(source(&mut session), Some(state));
}

/// The frames while the line above the zigzags is moved, and those after.
fn moved(session: &mut Session, screen: &mut Screen) -> [Vec<(u32, bool)>; 2] {
    session.command(Command::Tool(Tool::Select));
    draw(session, Phase::Down, [400.0, 40.0]);
    session.pointer(Phase::Up, &[]);
    frames(session, screen);
    draw(session, Phase::Down, [400.0, 40.0]);
    let mut in_motion = Vec::new();
    for i in 1..=5 {
        draw(session, Phase::Move, [400.0 + 9.0 * f64::from(i), 44.0]);
        session.frame(screen);
        in_motion.extend(std::mem::take(&mut screen.frames));
    }
    session.pointer(Phase::Up, &[]);
    [in_motion, frames(session, screen)]
}

#[test]
fn lines_among_5_000_pieces_are_followed_on_a_grid_and_meshed_when_they_rest() {
    let drawing = import_svg(zigzags(5).as_bytes()).expect("a drawing").drawing;
    let piece_count = PlanarMap::build(&drawing, &Sampling::default()).expect("a map").pieces().len();
    assert!((5000..8000).contains(&piece_count), "{piece_count}");
    let (mut session, mut screen) = page_with(zigzags(5).as_bytes(), Grids::Fast);
    let [in_motion, after] = moved(&mut session, &mut screen);
    assert_eq!(in_motion, [(512, true); 5], "another picture in each frame, by the grid solver");
    let (last, on_pixels) = after.split_last().expect("frames");
    assert_eq!(*last, (0, true), "the mesh solver's, once there is a mesh");
    assert!(!on_pixels.is_empty() && on_pixels.iter().all(|(side_px, _)| *side_px > 0), "{on_pixels:?}");
}

#[test]
fn lines_are_followed_by_the_mesh_solver_where_it_can() {
    let (mut session, mut screen) = page_with(zigzags(2).as_bytes(), Grids::Fast);
    let [in_motion, _] = moved(&mut session, &mut screen);
    assert_eq!(in_motion, [(0, true); 5]);
}
