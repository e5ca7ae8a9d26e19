//! Large drawings that are opened, or whose settings or lines change: their pictures are made step by step, and can be done
//! without.

use std::iter;

use kurbo::{BezPath, PathEl, Point, Rect, Stroke, Vec2};
use scumble_core::{Curve, Document, Drawing, EngineKind, Line, Rgba8, Srgb8, Tone, Work, exact};
use scumble_io::import_svg;
use scumble_solve::{Field, FieldTriangle, Picture};
use scumble_web::brush::Ink;
use scumble_web::command::{Arranging, Command, Phase, Setting, Tool, ViewChange};
use scumble_web::effect::{Effect, Wanted};
use scumble_web::painting::{Changed, Painter, Painting};
use scumble_web::session::Session;
use scumble_web::solver::{Grids, Solver};

use crate::followed::follow;
use crate::zigzags::zigzags;

/// Slices of a picture on its way that are made for a frame.
const SLICES: usize = 80;

/// A painter that keeps the field it is given.
#[derive(Default)]
struct Screen {
    field: Field,
    /// How many shapes of ink there are.
    ink: usize,
    is_on_pixels: bool,
}

impl Painter for Screen {
    fn paint(&mut self, painting: &Painting<'_>, changed: Changed) -> bool {
        if changed.field.is_any() {
            follow(&mut self.field, painting.field, &changed.field);
        }
        self.ink = painting.layers.ink().len();
        self.is_on_pixels = painting.problem.is_some();
        true
    }
}

struct Page {
    session: Session,
    screen: Screen,
}

impl Page {
    /// With a drawing of some 5,600 pieces and a scribble on it, as shown.
    fn open() -> Self {
        let drawing = import_svg(zigzags(5).as_bytes()).expect("a drawing").drawing;
        let mut page = Self::of(exact::write(&Work::new(Document::new(drawing))));
        page.stroke([(200.0, 60.0), (600.0, 60.0)]);
        page.rest();
        page
    }

    fn of(work: Vec<u8>) -> Self {
        let session = Session::new(Srgb8([90; 3])).expect("a blank page");
        let mut page = Self { session, screen: Screen::default() };
        page.resize([1200, 900]);
        page.lay(work);
        page.session.command(Command::View(ViewChange::ZoomReset));
        page.rest();
        page
    }

    fn resize(&mut self, size_px: [u32; 2]) {
        let corner_css = Point::ZERO;
        self.session.command(Command::View(ViewChange::Resize { size_px, px_per_css: 1.0, corner_css }));
    }

    /// Has a small part of the page in view.
    fn go_close(&mut self) {
        self.resize([600, 450]);
        self.session.command(Command::View(ViewChange::ZoomReset));
        let place = self.session.css_from_du() * Point::new(100.0, 229.0);
        self.session.command(Command::View(ViewChange::ZoomAt(place, 2.0)));
    }

    fn lay(&mut self, work: Vec<u8>) {
        self.session.command(Command::Open { work, notes: String::new() });
    }

    fn pen(&mut self, phase: Phase, point_du: (f64, f64)) {
        let point = self.session.css_from_du() * Point::from(point_du);
        self.session.pointer(phase, &[point.x as f32, point.y as f32, 1.0]);
    }

    fn stroke(&mut self, ends_du: [(f64, f64); 2]) {
        self.session.command(Command::Tool(Tool::Scribble));
        self.pen(Phase::Down, ends_du[0]);
        self.pen(Phase::Move, ends_du[1]);
        self.session.pointer(Phase::Up, &[]);
    }

    /// Moves the line over the zigzags.
    fn move_line(&mut self) {
        self.session.command(Command::Tool(Tool::Select));
        for phase in [Phase::Down, Phase::Up] {
            self.pen(phase, (400.0, 40.0));
        }
        self.pen(Phase::Down, (400.0, 40.0));
        self.pen(Phase::Move, (420.0, 50.0));
        self.pen(Phase::Move, (430.0, 54.0));
        self.session.pointer(Phase::Up, &[]);
    }

    /// The next frame, after some of what is on its way was done.
    fn frame(&mut self) -> bool {
        let _ = (0..SLICES).find(|_| !self.session.make_on());
        self.session.frame(&mut self.screen)
    }

    /// Frames until there is nothing more to show; how many.
    fn rest(&mut self) -> usize {
        (1..1000).find(|_| !self.frame()).expect("it comes to rest")
    }

    /// Frames until a drawing that has just been opened, or come back to, has its first colours.
    fn first_colors(&mut self) -> Field {
        self.frame();
        assert!(self.screen.field.triangles.is_empty());
        while self.screen.field.triangles.is_empty() {
            assert!(self.frame());
        }
        self.screen.field.clone()
    }

    /// Whether the page was told last that a picture is on its way, if it was told anything of that.
    fn told(&mut self) -> Option<bool> {
        let told =
            |effect| if let Effect::Making(wanted) = effect { Some(wanted != Wanted::Nothing) } else { None };
        self.session.take_effects().into_iter().filter_map(told).next_back()
    }

    fn set_spread(&mut self, spread: bool) {
        self.session.command(Command::Set(Setting::Spread(spread)));
    }

    /// The picture shown is that of the work when it is opened anew.
    fn assert_right(&mut self) {
        let fresh = Self::of(self.session.work());
        assert!(self.screen.field == fresh.screen.field);
    }
}

#[test]
fn other_settings_are_seen_some_frames_later_and_colours_follow_meanwhile() {
    let each = [
        Setting::GapClosing(1.0),
        Setting::GapClosing(0.0),
        Setting::Spread(true),
        Setting::Engine(EngineKind::Progressive),
    ];
    let mut page = Page::open();
    for (setting, x) in each.into_iter().zip([100.0, 300.0, 500.0, 700.0]) {
        page.told();
        page.session.command(Command::Set(setting));
        let before = page.screen.field.clone();
        assert!(page.frame() && page.frame());
        assert_eq!(page.told(), Some(true));
        assert!(page.screen.field == before);
        page.session.command(Command::Color(Srgb8([1, 90, 200]).into()));
        page.stroke([(x, 97.0), (x + 100.0, 97.0)]);
        page.frame();
        assert!(page.screen.field != before, "what is scribbled close to lines shows at once");
        assert!(page.rest() < 20);
        assert_eq!(page.told(), Some(false));
        page.assert_right();
    }
}

#[test]
fn a_slider_that_is_dragged_on_shows_what_was_begun_and_ends_where_it_stops() {
    let mut page = Page::open();
    for i in 1..=12 {
        page.session.command(Command::Set(Setting::GapClosing(0.5 + 0.04 * f64::from(i))));
        page.frame();
    }
    page.session.command(Command::Settle);
    page.rest();
    page.assert_right();
}

#[test]
fn moved_lines_are_seen_some_frames_later() {
    let mut page = Page::open();
    page.move_line();
    let before = page.screen.field.clone();
    assert_eq!(page.told(), Some(true));
    assert!(page.frame());
    page.stroke([(100.0, 500.0), (900.0, 500.0)]);
    assert!(page.frame());
    assert!(page.screen.field == before);
    page.rest();
    assert_eq!(page.told(), Some(false));
    page.assert_right();
}

#[test]
fn what_asked_for_a_picture_is_taken_back_and_the_one_before_is_still_there() {
    for change in [Page::move_line as fn(&mut Page), |page| page.set_spread(true)] {
        let mut page = Page::open();
        let (work, picture) = (page.session.work(), page.screen.field.clone());
        change(&mut page);
        assert!(page.frame() && page.frame());
        page.told();
        page.session.command(Command::StopMaking);
        let effects = page.session.take_effects();
        assert!(
            effects.contains(&Effect::Making(Wanted::Nothing)) && effects.contains(&Effect::MakingStopped)
        );
        assert_eq!(page.rest(), 1, "nothing is made anew");
        assert!(page.session.work() == work && page.screen.field == picture);
        page.session.command(Command::Redo);
        page.rest();
        assert!(page.screen.field != picture);
        page.assert_right();
    }
}

#[test]
fn lines_that_come_back_are_seen_some_frames_later_and_can_be_done_without() {
    let mut page = Page::open();
    page.session.command(Command::Scribbles(false));
    page.session.command(Command::Tool(Tool::Select));
    page.pen(Phase::Down, (0.5, 0.5));
    page.pen(Phase::Move, (1023.5, 1023.5));
    page.session.pointer(Phase::Up, &[]);
    page.session.command(Command::Arrange(Arranging::Delete));
    page.rest();
    assert_eq!(page.session.document().drawing.curves.len(), 0);
    page.told();
    page.session.command(Command::Undo);
    let before = page.screen.field.clone();
    page.session.frame(&mut page.screen);
    assert_eq!(page.told(), Some(true));
    assert!(page.screen.field == before);
    page.session.command(Command::StopMaking);
    assert_eq!(page.session.document().drawing.curves.len(), 0, "the picture is the one without them");
    page.session.command(Command::Undo);
    page.rest();
    assert_eq!(page.told(), Some(false));
    page.assert_right();
}

#[test]
fn undo_ends_what_is_on_its_way() {
    let mut page = Page::open();
    page.set_spread(true);
    assert!(page.frame() && page.frame());
    page.session.command(Command::Undo);
    assert_eq!(page.rest(), 1);
    assert_eq!(page.told(), Some(false));
    page.assert_right();
}

#[test]
fn another_drawing_is_not_given_the_picture_of_the_one_before() {
    let mut page = Page::open();
    let picture = page.screen.field.clone();
    let other = Page::open().session.work();
    page.lay(other);
    page.set_spread(true);
    assert!(page.frame() && page.frame());
    page.session.command(Command::Undo);
    page.session.command(Command::Undo);
    page.rest();
    assert!(page.screen.field == picture);
    page.assert_right();
}

#[test]
fn a_picture_for_a_file_is_that_of_the_document() {
    let mut page = Page::open();
    page.set_spread(true);
    page.frame();
    let exported = page.session.export(64.0, false).field;
    assert_eq!(page.told(), Some(false));
    page.rest();
    assert!(page.screen.field == *exported);
    page.assert_right();
}

/// The work of a drawing that takes long, with a scribble.
fn large() -> Vec<u8> {
    let drawing = import_svg(zigzags(100).as_bytes()).expect("a drawing").drawing;
    let scribble = Page::open().session.document().scribbles[0].clone();
    exact::write(&Work::new(Document { scribbles: vec![scribble], ..Document::new(drawing) }))
}

#[test]
fn the_lines_of_a_large_drawing_are_there_at_once_and_the_pen_with_them() {
    let mut page = Page::open();
    let ink = page.screen.ink;
    page.lay(large());
    assert!(page.frame() && page.frame());
    assert_eq!(page.told(), Some(true));
    assert!(page.screen.ink > ink + 90, "lines and all");
    let blank = page.screen.field.clone();
    page.stroke([(100.0, 97.0), (200.0, 97.0)]);
    assert!(page.frame());
    assert!(page.screen.field == blank);
    page.rest();
    assert_eq!(page.told(), Some(false));
    let document = page.session.document();
    assert_eq!(document.scribbles.len(), 2);
    let mut picture = Picture::new(&document.drawing).expect("a map");
    assert!(page.screen.field == *picture.update(document).expect("a field"));
}

#[test]
fn a_rough_picture_of_a_large_drawing_is_there_before_the_right_one_and_stays_while_somebody_scribbles() {
    let mut page = Page::open();
    page.lay(large());
    let rough = page.first_colors();
    page.stroke([(100.0, 97.0), (200.0, 97.0)]);
    assert!(page.frame());
    assert!(page.screen.field == rough);
    page.rest();
    assert!(page.screen.field.triangles.len() > rough.triangles.len());
    page.assert_right();
}

/// A page on which a drawing with regions takes long, with a scribble in view, from close by, and one elsewhere.
fn close_by() -> Page {
    let ends = r#"<path d="M12 90V1300M993 90V1300" fill="none" stroke="black"/></svg>"#;
    let svg = zigzags(100).replace("</svg>", ends);
    let drawing = import_svg(svg.as_bytes()).expect("a drawing").drawing;
    let mut page = Page::of(exact::write(&Work::new(Document::new(drawing))));
    page.stroke([(40.0, 685.0), (80.0, 685.0)]);
    page.stroke([(40.0, 229.0), (80.0, 229.0)]);
    page.go_close();
    page.rest();
    page
}

impl Page {
    /// See [`Page::assert_right`].
    fn assert_right_from_afar(&mut self) {
        self.session.command(Command::View(ViewChange::Fit));
        self.rest();
        self.assert_right();
    }

    /// Another setting, and frames until another picture is seen; that one, and the one before.
    fn other_field(&mut self, setting: Setting) -> [Field; 2] {
        let before = self.screen.field.clone();
        self.session.command(Command::Set(setting));
        while self.screen.field == before {
            assert!(self.frame());
        }
        [self.screen.field.clone(), before]
    }
}

#[test]
fn what_is_in_view_from_close_by_is_there_before_the_rest_and_is_the_same() {
    let mut page = close_by();
    let [part, before] = page.other_field(Setting::Spread(true));
    let away = |page: &mut Page, way: f64| {
        page.session.command(Command::View(ViewChange::Pan(Vec2::new(0.0, way))));
        assert!(page.session.frame(&mut page.screen), "the rest is on its way");
    };
    away(&mut page, -900.0);
    assert!(page.screen.field == before);
    away(&mut page, 900.0);
    assert!(page.screen.field == part);
    page.rest();
    let whole = &page.screen.field;
    assert!(whole.triangles.len() > part.triangles.len());
    let canvas = Rect::new(0.0, 0.0, 600.0, 450.0);
    let seen_du = page.session.css_from_du().inverse().transform_rect_bbox(canvas);
    let seen = |field: &Field| -> Vec<FieldTriangle> {
        let is_seen =
            |triangle: &&FieldTriangle| triangle.corners.iter().any(|&[x, y]| seen_du.contains((x, y)));
        field.triangles.iter().filter(is_seen).copied().collect()
    };
    let (part, whole) = (seen(&part), seen(whole));
    assert!(part.len() > 10_000);
    assert_eq!(part.len(), whole.len());
    for (part, whole) in part.iter().zip(&whole) {
        assert_eq!((part.corners, part.side_edges), (whole.corners, whole.side_edges));
        let pairs = part.colors.as_flattened().iter().zip(whole.colors.as_flattened());
        pairs.for_each(|(a, b)| assert!((a - b).abs() < 1e-4, "{a} {b}"));
    }
}

#[test]
fn who_scribbles_before_the_rest_is_there_sees_it_in_the_picture_before() {
    let mut page = close_by();
    let [part, before] = page.other_field(Setting::Spread(true));
    page.stroke([(100.0, 241.0), (140.0, 241.0)]);
    assert!(page.session.frame(&mut page.screen));
    assert!(page.screen.field != part && page.screen.field.triangles.len() > before.triangles.len());
    page.session.command(Command::Undo);
    assert!(page.session.frame(&mut page.screen));
    assert!(page.screen.field == before);
    page.rest();
    page.assert_right_from_afar();
}

#[test]
fn what_is_in_view_of_another_picture_is_there_once_for_each_and_goes_with_what_asked_for_it() {
    let mut page = close_by();
    let before = page.screen.field.clone();
    for leave in [Command::StopMaking, Command::Undo] {
        let [part, _] = page.other_field(Setting::Spread(true));
        assert!(part.triangles.len() > before.triangles.len());
        page.session.command(leave);
        assert!(!page.session.frame(&mut page.screen));
        assert!(page.screen.field == before);
    }
}

#[test]
fn a_slider_that_stops_shows_what_is_in_view_and_goes_on_showing_it_when_let_go_of() {
    let mut page = close_by();
    let [part, _] = page.other_field(Setting::GapClosing(1.0));
    page.session.command(Command::Settle);
    assert!(page.session.frame(&mut page.screen));
    assert!(page.screen.field == part);
    page.session.command(Command::Set(Setting::GapClosing(0.25)));
    assert!(page.session.frame(&mut page.screen));
    assert!(page.screen.field != part);
    page.session.command(Command::Settle);
    page.rest();
    page.assert_right_from_afar();
}

#[test]
fn what_comes_into_view_while_a_large_drawing_is_opened_is_there_first() {
    let mut page = Page::open();
    page.lay(close_by().session.work());
    let rough = page.first_colors();
    page.go_close();
    while page.screen.field == rough {
        assert!(page.frame());
    }
    assert!(page.session.take_effects().contains(&Effect::Making(Wanted::Picture)));
    let part = page.screen.field.clone();
    page.rest();
    assert_eq!(page.told(), Some(false));
    assert!(page.screen.field.triangles.len() > part.triangles.len());
    page.assert_right_from_afar();
}

#[test]
fn a_stroke_that_is_cancelled_leaves_nothing_in_a_picture_that_was_begun_with_it() {
    let mut page = Page::open();
    page.lay(large());
    page.session.command(Command::Tool(Tool::Scribble));
    page.pen(Phase::Down, (100.0, 97.0));
    page.pen(Phase::Move, (200.0, 97.0));
    page.first_colors();
    page.session.pointer(Phase::Cancel, &[]);
    page.rest();
    page.assert_right();
}

#[test]
fn a_drawing_can_be_left_while_its_rough_picture_is_shown() {
    for leave in [Command::StopMaking, Command::Undo] {
        let mut page = Page::of(Page::open().session.work());
        let picture = page.screen.field.clone();
        page.lay(large());
        page.first_colors();
        page.session.command(leave);
        page.rest();
        assert!(page.screen.field == picture);
        page.session.command(Command::Redo);
        page.first_colors();
        page.rest();
        page.assert_right();
    }
}

#[test]
fn a_rough_picture_comes_before_one_on_pixels_too() {
    let mut page = Page::open();
    page.session.set_grids(Grids::Fast);
    page.session.command(Command::Solver(Solver::Gpu));
    page.rest();
    assert!(page.screen.is_on_pixels);
    page.lay(large());
    page.first_colors();
    assert!(!page.screen.is_on_pixels);
    page.rest();
    assert!(page.screen.is_on_pixels);
}

#[test]
fn a_large_drawing_is_left_for_the_one_before_and_can_be_come_back_to() {
    for leave in [Command::StopMaking, Command::Undo] {
        for is_worked_on in [false, true] {
            let mut page = Page::of(Page::open().session.work());
            if is_worked_on {
                page.stroke([(100.0, 97.0), (200.0, 97.0)]);
                page.rest();
            }
            let (before, picture) = (page.session.work(), page.screen.field.clone());
            page.lay(large());
            assert!(page.frame() && page.frame());
            page.session.command(leave.clone());
            page.rest();
            assert_eq!(page.told(), Some(false));
            assert!(page.session.work() == before && page.screen.field == picture);
            page.session.command(Command::Redo);
            page.rest();
            assert!(page.session.work() == large());
            page.told();
            page.session.command(Command::Undo);
            assert!((page.session.work() == before) == is_worked_on, "nobody's work is let go of");
        }
    }
}

/// A line of too many pieces.
fn endless() -> Drawing {
    let mut drawing = Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0));
    let corner = |i: u32| Point::new(f64::from(i / 1000) + 0.5 * f64::from(i % 2), f64::from(i % 1000));
    let path = BezPath::from_iter(
        iter::once(PathEl::MoveTo(corner(0))).chain((1..1_010_000).map(|i| PathEl::LineTo(corner(i)))),
    );
    drawing.curves.push(Curve { path, line: None });
    drawing
}

#[test]
fn a_drawing_of_too_many_pieces_is_closed_once_that_is_known() {
    let mut page = Page::open();
    let (before, picture) = (page.session.work(), page.screen.field.clone());
    page.lay(exact::write(&Work::new(Document::new(endless()))));
    page.rest();
    let effects = page.session.take_effects();
    assert!(
        effects.iter().any(|effect| matches!(effect, Effect::Unopened(_, why) if why.contains("pieces")))
    );
    assert!(page.session.work() == before && page.screen.field == picture);
    page.session.command(Command::Redo);
    assert!(page.session.work() == before, "it does not come back");
}

/// A line to and fro, the other way round or not, within a square of 440 du.
fn comb(corner: f64, is_upright: bool) -> Curve {
    let place = |i: u32| {
        let [along, across] = [440.0 * f64::from(i.div_ceil(2) % 2), 0.4 * f64::from(i / 2)];
        let [x, y] = if is_upright { [across, along] } else { [along, across] };
        Point::new(corner + x, corner + y)
    };
    let path =
        iter::once(PathEl::MoveTo(place(0))).chain((1..2200).map(|i| PathEl::LineTo(place(i)))).collect();
    Curve { path, line: Some(Line { stroke: Stroke::new(0.1), color: Rgba8([0, 0, 0, 255]) }) }
}

#[test]
fn lines_that_become_too_many_pieces_are_taken_back_with_what_was_done_since() {
    let mut drawing = Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0));
    drawing.curves = vec![comb(20.0, false), comb(560.0, true)];
    let mut page = Page::of(exact::write(&Work::new(Document::new(drawing))));
    let before = page.session.work();
    page.told();
    page.session.command(Command::Tool(Tool::Select));
    for phase in [Phase::Down, Phase::Up, Phase::Down] {
        page.pen(phase, (560.0, 700.0));
    }
    page.pen(Phase::Move, (20.0, 160.0));
    page.session.pointer(Phase::Up, &[]);
    assert!(page.session.work() != before);
    assert!(page.frame());
    page.stroke([(700.0, 100.0), (800.0, 100.0)]);
    assert_eq!(page.session.document().scribbles.len(), 1);
    page.rest();
    let effects = page.session.take_effects();
    assert!(effects.iter().any(|effect| matches!(effect, Effect::Failed(why) if why.contains("pieces"))));
    assert!(page.session.work() == before);
}

#[test]
fn a_large_drawing_under_another_can_still_be_left_or_found_to_have_too_many_pieces() {
    let too_many = exact::write(&Work::new(Document::new(endless())));
    for work in [large(), too_many.clone()] {
        let is_endless = work == too_many;
        let mut page = Page::of(Page::open().session.work());
        let before = page.session.work();
        page.lay(work);
        page.stroke([(100.0, 97.0), (200.0, 97.0)]);
        page.told();
        page.lay(Page::open().session.work());
        page.told();
        page.session.command(Command::Undo);
        assert_eq!(page.told(), Some(true));
        if is_endless {
            page.rest();
        } else {
            page.session.command(Command::StopMaking);
        }
        assert!(page.session.work() == before);
        page.rest();
        page.session.command(Command::Redo);
        assert_eq!(page.session.document().scribbles.len(), if is_endless { 1 } else { 2 });
    }
}

#[test]
fn what_is_done_while_a_large_drawing_is_made_is_made_in_slices_too() {
    let mut page = Page::open();
    page.lay(large());
    page.frame();
    while page.session.make_on() {
        if page.session.document().scribbles.len() == 1 {
            page.stroke([(100.0, 600.0), (800.0, 610.0)]);
        }
    }
    let document = page.session.document().clone();
    assert_eq!(document.scribbles.len(), 2);
    page.session.frame(&mut page.screen);
    let mut picture = Picture::new(&document.drawing).expect("a map");
    assert!(page.screen.field == *picture.update(&document).expect("a field"));
}

#[test]
fn a_tone_on_a_large_drawing_is_one_of_the_colour_that_is_to_come() {
    let mut pages = [false, true].map(|waits| {
        let mut page = Page::open();
        page.lay(large());
        page.frame();
        if waits {
            page.rest();
        }
        page.session.command(Command::Color(Ink::Tone(Tone::Darker)));
        page.stroke([(300.0, 60.0), (400.0, 60.0)]);
        page.rest();
        page
    });
    let colors = pages.each_ref().map(|page| page.session.document().scribbles[1].color);
    assert_eq!(colors[0], colors[1]);
    pages[0].assert_right();
}

#[test]
fn the_mesh_of_a_picture_on_pixels_is_made_in_slices() {
    let mut page = Page::open();
    page.session.set_grids(Grids::Fast);
    page.session.command(Command::Solver(Solver::Gpu));
    page.lay(Page::open().session.work());
    page.rest();
    page.session.take_effects();
    let on_pixels = page.screen.field.clone();
    page.session.command(Command::Solver(Solver::Mesh));
    assert!(page.session.frame(&mut page.screen));
    let wanted = Effect::Making(Wanted::Mesh);
    assert!(page.session.take_effects().contains(&wanted));
    assert!(page.screen.field == on_pixels);
    page.rest();
    assert_eq!(page.told(), Some(false));
    page.assert_right();
}
