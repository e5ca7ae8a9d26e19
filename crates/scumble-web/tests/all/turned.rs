//! The page mirrored and rotated: what the pen and the keys do is as it is seen, and the drawing stays as it is.

use crate::page::{Page, SQUARE};
use kurbo::{Point, Rect, Vec2};
use scumble_core::{Scribble, Srgb8};
use scumble_web::command::{Arranging, Command, Phase, Selecting, Tool, ViewChange};
use scumble_web::effect::{Effect, SelectionState};

const RED: Srgb8 = Srgb8([220, 30, 30]);
const ACROSS: [(f64, f64); 3] = [(300.0, 300.0), (400.0, 340.0), (500.0, 300.0)];
const INSIDE: (f64, f64) = (250.0, 600.0);
const OUTSIDE: (f64, f64) = (700.0, 640.0);

/// Turns of all kinds: none, aslant, a right angle, in the mirror.
const TURNS: [(f64, bool); 5] = [(0.0, false), (30.0, false), (90.0, false), (0.0, true), (-130.0, true)];

fn turned(degrees: f64, is_mirrored: bool) -> Page {
    let mut page = Page::open(SQUARE);
    if is_mirrored {
        page.view(ViewChange::Mirror);
    }
    page.view(ViewChange::RotateAt(Point::new(600.0, 450.0), degrees));
    page
}

fn scribbled(degrees: f64, is_mirrored: bool) -> Page {
    let mut page = turned(degrees, is_mirrored);
    page.stroke(RED, &ACROSS);
    page.session.command(Command::Tool(Tool::Select));
    page.session.take_effects();
    page
}

fn points(page: &Page) -> Vec<Point> {
    page.session.document().scribbles.iter().flat_map(|scribble: &Scribble| scribble.points.clone()).collect()
}

fn selection(page: &mut Page) -> SelectionState {
    let effects = page.session.take_effects();
    effects
        .into_iter()
        .rev()
        .find_map(|e| if let Effect::Selection(state) = e { Some(state) } else { None })
        .expect("news")
}

/// A drag of the pen through places on the canvas.
fn drag(page: &mut Page, from_css: Point, to_css: Point) {
    for (phase, at) in [(Phase::Down, from_css), (Phase::Move, to_css), (Phase::Up, to_css)] {
        page.session.pointer(phase, &[at.x as f32, at.y as f32, 1.0]);
    }
}

fn assert_close(a: Point, b: Point) {
    assert!((a - b).hypot() < 5e-3, "{a} is not {b}");
}

#[test]
fn a_stroke_lies_where_the_pen_was_and_colours_what_it_colours_upright() {
    let upright = points(&scribbled(0.0, false));
    for (degrees, is_mirrored) in TURNS {
        let mut page = turned(degrees, is_mirrored);
        page.stroke(RED, &ACROSS);
        let drawn = points(&page);
        assert_eq!(drawn.len(), upright.len());
        drawn.into_iter().zip(&upright).for_each(|(drawn, upright)| assert_close(drawn, *upright));
        page.session.command(Command::Scribbles(false));
        assert_eq!(page.color_at(INSIDE), RED, "{degrees} {is_mirrored}");
        assert_eq!(page.color_at(OUTSIDE), Srgb8([255; 3]), "{degrees} {is_mirrored}");
    }
}

#[test]
fn the_drawing_and_its_pictures_stay_as_they_are() {
    let mut page = scribbled(0.0, false);
    let (work, picture) = (page.session.work(), page.thumbnail());
    page.view(ViewChange::Mirror);
    page.view(ViewChange::RotateStep { is_clockwise: true });
    assert_eq!(page.session.work(), work);
    assert_eq!(page.thumbnail(), picture);
}

#[test]
fn the_frame_lies_along_the_canvas_and_around_what_is_selected() {
    for (degrees, is_mirrored) in TURNS {
        let mut page = scribbled(degrees, is_mirrored);
        page.session.command(Command::Select(Selecting::All));
        let css = ACROSS.map(|at| page.session.css_from_du() * Point::from(at));
        let around =
            css.into_iter().map(|at| Rect::from_points(at, at)).reduce(|a, b| a.union(b)).expect("points");
        let frame = selection(&mut page).frame_css.expect("a frame");
        let rim = frame.x1 - around.x1;
        assert!(
            rim > 8.0 && (around.inflate(rim, rim).area() - frame.area()).abs() < 1.0,
            "{frame} around {around}"
        );
    }
}

#[test]
fn a_drag_moves_it_with_the_pen_and_an_arrow_as_it_points() {
    for (degrees, is_mirrored) in TURNS {
        let mut page = scribbled(degrees, is_mirrored);
        page.session.command(Command::Select(Selecting::All));
        // On the stroke, and at no handle of the frame.
        let third = points(&page).len() / 3;
        let css = |page: &Page| page.session.css_from_du() * points(page)[third];
        let at = css(&page);
        let way = Vec2::new(40.0, -25.0);
        drag(&mut page, at, at + way);
        assert_close(css(&page), at + way);
        page.session.command(Command::Arrow(Vec2::new(1.0, 0.0), true));
        assert_close(css(&page), at + way + Vec2::new(10.0, 0.0));
        page.session.command(Command::Arrange(Arranging::Duplicate));
        let places = points(&page);
        assert_close(
            page.session.css_from_du() * places[places.len() / 2 + third],
            at + way + Vec2::new(26.0, 16.0),
        );
    }
}

#[test]
fn a_handle_resizes_along_the_canvas_and_leaves_the_other_side() {
    for (degrees, is_mirrored) in TURNS {
        let mut page = scribbled(degrees, is_mirrored);
        page.session.command(Command::Select(Selecting::All));
        let frame = selection(&mut page).frame_css.expect("a frame");
        let right = Point::new(frame.x1, frame.center().y);
        drag(&mut page, right, right + Vec2::new(50.0, 33.0));
        let after = selection(&mut page).frame_css.expect("a frame");
        assert_close(after.origin(), frame.origin());
        assert_close(Point::new(after.x1, after.y1), Point::new(frame.x1 + 50.0, frame.y1));
    }
}

#[test]
fn a_rectangle_selects_what_is_seen_in_it() {
    for (degrees, is_mirrored) in TURNS {
        let mut page = scribbled(degrees, is_mirrored);
        let css = ACROSS.map(|at| page.session.css_from_du() * Point::from(at));
        let line = [(200.0, 150.0), (680.0, 630.0)].map(|at| page.session.css_from_du() * Point::from(at));
        let beside = css[0] - (css[2] - css[0]) * 0.3;
        drag(&mut page, beside, beside.lerp(css[0], 0.8));
        assert_eq!(page.session.take_effects().len(), 0, "it ends before the scribble");
        drag(&mut page, beside, css[1]);
        let state = selection(&mut page);
        assert_eq!((state.scribbles, state.lines), (1, 0), "{degrees} {is_mirrored}");
        page.session.command(Command::Arrange(Arranging::Delete));
        let [a, b] = line;
        let all = Rect::from_points(a, b).inflate(400.0, 400.0);
        drag(&mut page, all.origin(), Point::new(all.x1, all.y1));
        assert_eq!(selection(&mut page).lines, 1);
    }
}

#[test]
fn the_hand_holds_the_page_where_it_took_it() {
    for (degrees, is_mirrored) in TURNS {
        let mut page = turned(degrees, is_mirrored);
        page.session.command(Command::Tool(Tool::Hand));
        let (from, to) = (Point::new(500.0, 400.0), Point::new(560.0, 330.0));
        let place = page.session.css_from_du().inverse() * from;
        drag(&mut page, from, to);
        assert!((page.session.css_from_du() * place - to).hypot() < 0.8, "to half a pixel each way");
    }
}

#[test]
fn what_it_is_turned_to_is_told_once() {
    let mut page = Page::open(SQUARE);
    page.session.take_effects();
    page.view(ViewChange::RotateStep { is_clockwise: false });
    let effects = page.session.take_effects();
    let turns = effects.iter().filter_map(|effect| match effect {
        Effect::Turn(turn) | Effect::Turned(turn) => Some((turn.degrees, turn.is_mirrored)),
        _ => None,
    });
    assert_eq!(turns.collect::<Vec<_>>(), [(-15.0, false), (-15.0, false)]);
    page.view(ViewChange::RotateAt(Point::ORIGIN, 3.0));
    assert!(!page.session.take_effects().iter().any(|effect| matches!(effect, Effect::Turned(_))));
}

#[test]
fn a_page_neither_turns_nor_leaps_under_a_pen_that_is_down() {
    let mut page = Page::open(SQUARE);
    page.session.command(Command::Color(RED.into()));
    let leaps = [
        ViewChange::Mirror,
        ViewChange::RotateStep { is_clockwise: true },
        ViewChange::ZoomIn,
        ViewChange::Fit,
    ];
    for (phase, place) in [Phase::Down, Phase::Move, Phase::Move, Phase::Up].into_iter().zip([0, 1, 2, 2]) {
        let at = Point::from(ACROSS[place]);
        let before = page.session.css_from_du();
        page.pen(phase, ACROSS[place]);
        for leap in leaps.into_iter().filter(|_| phase != Phase::Up) {
            page.view(leap);
            assert_eq!(page.session.css_from_du() * at, before * at, "{leap:?}");
        }
        if phase != Phase::Up {
            page.session.command(Command::Arrow(Vec2::new(1.0, 0.0), true));
            assert_eq!(page.session.css_from_du() * at, before * at, "an arrow key");
        }
    }
    let ends = [ACROSS[0], ACROSS[2]].map(Point::from);
    let drawn = points(&page);
    assert_close(drawn[0], ends[0]);
    assert_close(*drawn.last().expect("an end"), ends[1]);
    assert!(drawn.iter().all(|point| point.y <= 341.0), "{drawn:?}");
    let before = page.session.css_from_du();
    page.view(ViewChange::Mirror);
    assert_ne!(page.session.css_from_du(), before);
}
