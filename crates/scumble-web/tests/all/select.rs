//! The tool that selects, and what is done with what is selected; the eraser that takes parts.

use kurbo::{Point, Vec2};
use scumble_core::drawing::LONGER_SIDE_DU;
use scumble_core::work::MAX_PAGES;
use scumble_core::{Deed, EngineKind, Scribble, ScribbleKind, Shading, Srgb8, exact};
use scumble_web::command::{Arranging, Command, Phase, Selecting, Setting, Tool, ViewChange};
use scumble_web::effect::{Edit, Effect, SelectionState};
use scumble_web::painting::PAPER;

use crate::page::{self, Page, SQUARE};

const RED: Srgb8 = Srgb8([230, 25, 75]);
const BLUE: Srgb8 = Srgb8([0, 90, 200]);
const GREEN: Srgb8 = Srgb8([20, 160, 60]);
const WHITE: Srgb8 = Srgb8([255; 3]);

const INSIDE: (f64, f64) = (600.0, 560.0);
const OUTSIDE: (f64, f64) = (100.0, 100.0);

/// Two rooms side by side, and an arc of solid ink.
const ROOMS: &[u8] = br#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1024 768">
    <path d="M100 100H500V500H100Z" fill="none" stroke="black" stroke-width="4"/>
    <path d="M520 100H920V500H520Z" fill="none" stroke="black" stroke-opacity="0.5" stroke-width="4"/>
    <path d="M300 600H700V700H300Z" fill="black"/></svg>"#;

/// A square with a red and a blue scribble in it, beside one another, and the tool that selects.
fn two() -> Page {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &[(300.0, 300.0), (400.0, 300.0)]);
    page.stroke(BLUE, &[(300.0, 400.0), (400.0, 400.0)]);
    page.session.command(Command::Tool(Tool::Select));
    page.session.take_effects();
    page
}

fn drag(page: &mut Page, way_du: &[(f64, f64)]) {
    for (i, &place) in way_du.iter().enumerate() {
        page.pen(if i == 0 { Phase::Down } else { Phase::Move }, place);
    }
    page.session.pointer(Phase::Up, &[]);
}

/// What is selected; a frame that moves is told anew.
fn selection(page: &mut Page) -> SelectionState {
    page.session.take_effects();
    page.view(ViewChange::Pan(Vec2::new(1.0, 0.0)));
    let told = page.session.take_effects().into_iter().find_map(|effect| match effect {
        Effect::Selection(state) => Some(state),
        _ => None,
    });
    told.unwrap_or_default()
}

fn told(page: &mut Page) -> Option<Effect> {
    page.session.take_effects().into_iter().next_back()
}

fn scribbles(page: &Page) -> Vec<Scribble> {
    page.session.document().scribbles.clone()
}

fn deeds_of(page: &Page) -> Vec<Deed> {
    page.session.history().0.into_iter().map(|entry| entry.deed).collect()
}

fn colors(page: &Page) -> Vec<Srgb8> {
    let color = |scribble: &Scribble| scribble.color.to_string().parse().expect("a colour");
    page.session.document().scribbles.iter().map(color).collect()
}

fn bytes(page: &Page) -> Vec<u8> {
    page.session.work()
}

/// What is shown is what a session shows that opens the same work.
fn assert_as_if_opened(page: &mut Page) {
    page.session.command(Command::Select(Selecting::None));
    page.session.frame(&mut page.canvas);
    let mut fresh = Page::open(SQUARE);
    fresh.session.command(Command::Open { work: page.session.work(), notes: String::new() });
    let [here, there] = [&mut page.session, &mut fresh.session]
        .map(|session| session.export(512.0, true).rows(0, 384, Some(PAPER)).rgba);
    assert!(here == there, "the picture depends on the way to it");
}

#[test]
fn a_click_selects_the_uppermost_scribble_and_one_beside_all_nothing() {
    let mut page = two();
    drag(&mut page, &[(350.0, 300.0)]);
    let told = page.session.take_effects();
    assert!(told.contains(&Effect::Selected { scribbles: 1, lines: 0, place: 1, total: 2 }), "{told:?}");
    assert!(told.contains(&Effect::Color(RED.into())), "the controls show what is selected");
    drag(&mut page, &[OUTSIDE]);
    let told = page.session.take_effects();
    assert!(told.contains(&Effect::Selected { scribbles: 0, lines: 0, place: 0, total: 2 }), "{told:?}");
    assert!(told.contains(&Effect::Selection(SelectionState::default())));
}

#[test]
fn shift_adds_and_takes_away() {
    let mut page = two();
    drag(&mut page, &[(350.0, 300.0)]);
    page.pen(Phase::Add, (350.0, 400.0));
    page.session.pointer(Phase::Up, &[]);
    assert!(page.session.take_effects().contains(&Effect::Selected {
        scribbles: 2,
        lines: 0,
        place: 1,
        total: 2
    }));
    page.pen(Phase::Add, (350.0, 300.0));
    page.session.pointer(Phase::Up, &[]);
    assert!(page.session.take_effects().contains(&Effect::Selected {
        scribbles: 1,
        lines: 0,
        place: 2,
        total: 2
    }));
}

#[test]
fn a_rectangle_selects_what_it_touches() {
    let mut page = two();
    page.pen(Phase::Down, (250.0, 250.0));
    page.pen(Phase::Move, (350.0, 340.0));
    let live = page.session.take_effects();
    let of = |effects: &[Effect]| {
        effects.iter().find_map(|effect| match effect {
            Effect::Selection(state) => Some((state.scribbles, state.marquee_css.is_some())),
            _ => None,
        })
    };
    assert_eq!(of(&live), Some((1, true)));
    page.pen(Phase::Move, (350.0, 450.0));
    page.session.pointer(Phase::Up, &[]);
    assert_eq!(of(&page.session.take_effects()), Some((2, false)));
    assert!(!page.session.document().scribbles.is_empty());
}

#[test]
fn while_scribbles_are_selected_the_ink_stays_as_it_was_drawn() {
    let mut page = two();
    page.color_at(INSIDE);
    page.pen(Phase::Down, (250.0, 250.0));
    page.pen(Phase::Move, (450.0, 350.0));
    page.color_at(INSIDE);
    let drawn = page.canvas.frames.last().expect("a frame");
    assert!(drawn.scribbles && !drawn.ink, "{drawn:?}");
    page.session.pointer(Phase::Up, &[]);
    drag(&mut page, &[OUTSIDE]);
    drag(&mut page, &[(200.0, 500.0)]);
    page.color_at(INSIDE);
    let drawn = page.canvas.frames.last().expect("a frame");
    assert!(drawn.ink, "a line is: {drawn:?}");
}

#[test]
fn the_colours_of_hundreds_of_scribbles_follow_once_a_drag_of_them_ends() {
    let mut page = Page::open(SQUARE);
    let row = |y: f64| Scribble {
        color: RED.into(),
        kind: ScribbleKind::Fill,
        width_du: 2.0,
        points: vec![(60.0, y).into(), (80.0, y).into()],
    };
    let all: Vec<_> = (0..501).map(|i| row(200.0 + f64::from(i) / 2.0)).collect();
    page.session.command(page::open(SQUARE, &all));
    page.session.command(Command::Select(Selecting::All));
    assert_eq!([page.color_at(OUTSIDE), page.color_at(INSIDE)], [RED, WHITE]);
    page.pen(Phase::Down, (70.0, 300.0));
    page.pen(Phase::Move, (370.0, 300.0));
    assert_eq!([page.color_at(OUTSIDE), page.color_at(INSIDE)], [RED, WHITE], "on the way");
    assert_ne!(page.color_at((370.0, 300.0)), WHITE, "the scribbles themselves follow");
    page.session.pointer(Phase::Up, &[]);
    assert_eq!([page.color_at(OUTSIDE), page.color_at(INSIDE)], [WHITE, RED]);
}

#[test]
fn a_drag_moves_what_is_selected_live_in_one_step_and_undo_gives_it_back_bit_for_bit() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &[(300.1, 300.7), (400.3, 300.9)]);
    page.session.command(Command::Tool(Tool::Select));
    let (before, exact) = (scribbles(&page), bytes(&page));
    page.pen(Phase::Down, (350.0, 300.0));
    page.pen(Phase::Move, (300.0, 250.0));
    page.pen(Phase::Move, (100.0, 70.0));
    assert_eq!(page.color_at(OUTSIDE), RED, "it colours as it goes");
    assert_eq!(page.color_at(INSIDE), WHITE);
    page.session.pointer(Phase::Up, &[]);
    assert_eq!(told(&mut page), Some(Effect::Edited { edit: Edit::Moved, scribbles: 1, lines: 0 }));
    let way = scribbles(&page)[0].points[0] - before[0].points[0];
    assert!((way - Vec2::new(-250.0, -230.0)).hypot() < 1e-3, "{way:?}");
    assert_as_if_opened(&mut page);
    page.session.command(Command::Undo);
    assert_eq!(scribbles(&page), before);
    assert_eq!(bytes(&page), exact);
    assert_eq!(page.color_at(INSIDE), RED);
}

#[test]
fn a_move_that_is_dropped_or_comes_back_leaves_no_trace() {
    let mut page = two();
    let before = bytes(&page);
    page.pen(Phase::Down, (350.0, 300.0));
    page.pen(Phase::Move, (100.0, 70.0));
    page.session.pointer(Phase::Cancel, &[]);
    assert_eq!(bytes(&page), before);
    drag(&mut page, &[(350.0, 300.0), (351.0, 300.0)]);
    assert_eq!(bytes(&page), before, "a click does not move");
    for _ in 0..2 {
        page.session.command(Command::Undo);
    }
    assert!(page.session.document().scribbles.is_empty(), "there was nothing else to undo");
}

#[test]
fn what_is_moved_away_stays_at_the_rim_of_the_page() {
    let mut page = two();
    drag(&mut page, &[(350.0, 300.0), (-3000.0, -3000.0)]);
    let points = scribbles(&page)[0].points.clone();
    assert!(points.iter().any(|p| p.x >= -1e-9) && points.iter().any(|p| p.y >= -1e-9), "{points:?}");
}

#[test]
fn arrows_move_it_by_one_du_or_ten_and_the_view_without_it() {
    let mut page = two();
    let (view, before) = (page.session.css_from_du(), scribbles(&page));
    drag(&mut page, &[(350.0, 300.0)]);
    for _ in 0..3 {
        page.session.command(Command::Arrow(Vec2::new(1.0, 0.0), false));
    }
    page.session.command(Command::Settle);
    page.session.command(Command::Arrow(Vec2::new(0.0, -1.0), true));
    page.session.command(Command::Settle);
    let way = scribbles(&page)[0].points[0] - before[0].points[0];
    assert!((way - Vec2::new(3.0, -10.0)).hypot() < 1e-9, "{way:?}");
    assert_eq!(page.session.css_from_du(), view);
    page.session.command(Command::Undo);
    page.session.command(Command::Undo);
    assert_eq!(scribbles(&page), before, "a key that is held is one step");
    page.session.command(Command::Select(Selecting::None));
    page.session.command(Command::Arrow(Vec2::new(1.0, 0.0), false));
    assert_eq!(page.session.css_from_du().translation() - view.translation(), Vec2::new(-48.0, 0.0));
}

#[test]
fn a_corner_resizes_in_proportion_and_leaves_the_other_one() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &[(300.0, 300.0), (400.0, 350.0)]);
    page.session.command(Command::Tool(Tool::Select));
    drag(&mut page, &[(350.0, 325.0)]);
    let frame = selection(&mut page).frame_css.expect("a frame");
    let corner = page.session.css_from_du().inverse() * Point::new(frame.x1, frame.y1);
    drag(&mut page, &[(corner.x, corner.y), (corner.x + 100.0, corner.y + 50.0)]);
    let [a, b] = scribbles(&page)[0].points[..] else { panic!("two points") };
    assert!((a - Point::new(300.0, 300.0)).hypot() < 1e-3, "{a}");
    assert!((b - Point::new(500.0, 400.0)).hypot() < 1e-3, "{b}");
    assert_eq!(told(&mut page), Some(Effect::Edited { edit: Edit::Resized, scribbles: 1, lines: 0 }));
    assert_as_if_opened(&mut page);
}

#[test]
fn a_colour_that_is_picked_is_for_what_is_selected() {
    let mut page = two();
    page.session.command(Command::Select(Selecting::All));
    page.session.command(Command::Color(GREEN.into()));
    assert_eq!(colors(&page), [GREEN, GREEN]);
    assert_eq!(page.color_at(INSIDE), GREEN);
    page.session.command(Command::ColorSought(RED.into()));
    page.session.command(Command::ColorSought(BLUE.into()));
    page.session.command(Command::Settle);
    assert_eq!(colors(&page), [BLUE, BLUE]);
    page.session.command(Command::Undo);
    assert_eq!(colors(&page), [GREEN, GREEN], "seeking a colour is one step");
    page.session.command(Command::Undo);
    assert_eq!(colors(&page), [RED, BLUE]);
    page.session.command(Command::Select(Selecting::None));
    page.session.command(Command::Color(RED.into()));
    assert_eq!(colors(&page), [RED, BLUE], "it is for the next one");
}

#[test]
fn the_brush_size_is_the_width_of_what_is_selected() {
    let mut page = two();
    drag(&mut page, &[(350.0, 300.0)]);
    for size_du in [20.0, 30.0, 1e9] {
        page.session.command(Command::BrushSize(size_du));
    }
    page.session.command(Command::Settle);
    assert_eq!(scribbles(&page).iter().map(|s| s.width_du).collect::<Vec<_>>(), [96.0, 16.0]);
    assert!(page.session.take_effects().contains(&Effect::BrushSize(96.0)));
    page.session.command(Command::BrushSmaller);
    assert_eq!(scribbles(&page)[0].width_du, 77.0);
    page.session.command(Command::Undo);
    page.session.command(Command::Undo);
    assert_eq!(scribbles(&page)[0].width_du, 16.0);
    page.session.command(Command::BrushSize(f64::NAN));
    assert!(scribbles(&page).iter().all(|s| s.width_du.is_finite()));
}

#[test]
fn the_order_changes_by_one_and_with_it_what_the_progressive_engine_makes_of_it() {
    let mut page = Page::open(SQUARE);
    page.session.command(Command::Set(Setting::Engine(EngineKind::Progressive)));
    page.stroke(RED, &[(300.0, 300.0), (600.0, 500.0)]);
    page.stroke(BLUE, &[(300.0, 300.0), (600.0, 500.0)]);
    page.stroke(GREEN, &[(50.0, 50.0), (150.0, 50.0)]);
    let before = page.color_at(INSIDE);
    page.session.command(Command::Select(Selecting::All));
    page.session.command(Command::Arrange(Arranging::Forward));
    assert_eq!(told(&mut page), Some(Effect::Edited { edit: Edit::Foremost, scribbles: 3, lines: 0 }));
    page.session.command(Command::Select(Selecting::None));
    for _ in 0..3 {
        page.session.command(Command::Select(Selecting::Next));
    }
    page.session.command(Command::Arrange(Arranging::Forward));
    assert_eq!(colors(&page), [BLUE, RED, GREEN]);
    assert_ne!(page.color_at(INSIDE), before);
    page.session.command(Command::Arrange(Arranging::Forward));
    assert_eq!(colors(&page), [BLUE, GREEN, RED]);
    page.session.command(Command::Arrange(Arranging::Backward));
    page.session.command(Command::Arrange(Arranging::Backward));
    assert_eq!(colors(&page), [RED, BLUE, GREEN]);
    assert_as_if_opened(&mut page);
}

#[test]
fn copies_lie_beside_and_over_everything_and_are_selected() {
    let mut page = two();
    let before = scribbles(&page);
    page.session.command(Command::Select(Selecting::All));
    page.session.command(Command::Arrange(Arranging::Duplicate));
    assert_eq!(colors(&page), [RED, BLUE, RED, BLUE]);
    assert_eq!(scribbles(&page)[..2], before);
    assert_eq!(scribbles(&page)[3].points[0] - before[1].points[0], Vec2::new(16.0, 16.0));
    assert_eq!(selection(&mut page).scribbles, 2);
    page.session.command(Command::Arrange(Arranging::Delete));
    assert_eq!(scribbles(&page), before);
    page.session.command(Command::Undo);
    page.session.command(Command::Undo);
    assert_eq!(scribbles(&page), before);
}

#[test]
fn scribbles_that_are_too_long_already_can_be_erased() {
    let mut page = Page::open(SQUARE);
    let far = 1.1 * f64::from(MAX_PAGES) * LONGER_SIDE_DU;
    let points = vec![Point::new(250.0, 300.0), Point::new(far, 300.0)];
    let long = Scribble { color: RED.into(), kind: ScribbleKind::Fill, width_du: 8.0, points };
    page.session.command(page::open(SQUARE, &[long]));
    assert_eq!(scribbles(&page).len(), 1);
    page.stroke(BLUE, &[(250.0, 500.0), (650.0, 500.0)]);
    assert_eq!(scribbles(&page).len(), 1, "there is no room for more");
    page.session.command(Command::Tool(Tool::Erase));
    drag(&mut page, &[(450.0, 300.0)]);
    page.session.command(Command::Tool(Tool::Scribble));
    page.stroke(BLUE, &[(250.0, 500.0), (650.0, 500.0)]);
    assert_eq!(colors(&page), [BLUE]);
}

#[test]
fn what_would_be_too_long_for_a_file_is_dropped_and_said() {
    let mut page = Page::open(SQUARE);
    let most = (f64::from(MAX_PAGES) * LONGER_SIDE_DU / 400.0) as usize;
    let points = (0..=most).map(|i| Point::new(if i % 2 == 0 { 250.0 } else { 650.0 }, 300.0));
    let long =
        Scribble { color: RED.into(), kind: ScribbleKind::Fill, width_du: 8.0, points: points.collect() };
    page.session.command(page::open(SQUARE, &[long]));
    let before = bytes(&page);
    let assert_is_dropped = |page: &mut Page| {
        let too_long = Effect::Failed("the scribbles are too long in all; erase some of them".into());
        assert_eq!(told(page), Some(too_long));
        assert_eq!(bytes(page), before);
    };
    page.stroke(BLUE, &[(250.0, 500.0), (750.0, 500.0)]);
    assert_is_dropped(&mut page);
    page.session.command(Command::Select(Selecting::All));
    page.session.command(Command::Arrange(Arranging::Duplicate));
    assert_is_dropped(&mut page);
    let frame = selection(&mut page).frame_css.expect("a frame");
    let corner = page.session.css_from_du().inverse() * Point::new(frame.x1, frame.y1);
    drag(&mut page, &[(corner.x, corner.y), (corner.x + 50.0, corner.y)]);
    assert_is_dropped(&mut page);
    page.pen(Phase::Down, (corner.x, corner.y));
    page.pen(Phase::Move, (corner.x + 50.0, corner.y));
    assert_ne!(bytes(&page), before);
    page.session.command(Command::Select(Selecting::All));
    assert_eq!(bytes(&page), before, "what ends in the middle is no longer either");
    page.session.pointer(Phase::Up, &[]);
    drag(&mut page, &[(450.0, 300.0), (450.0, 400.0)]);
    assert_ne!(bytes(&page), before, "to move it makes it no longer");
    assert!(exact::read(&bytes(&page)).is_some());
}

#[test]
fn no_more_shades_are_copied_than_there_is_memory_for() {
    let mut page = Page::open(SQUARE);
    let kind = ScribbleKind::Shade(Shading::default());
    let dab = Scribble { color: RED.into(), kind, width_du: 20.0, points: vec![Point::new(500.0, 500.0)] };
    page.session.command(page::open(SQUARE, &[dab]));
    for _ in 0..10 {
        page.session.command(Command::Select(Selecting::All));
        page.session.command(Command::Arrange(Arranging::Duplicate));
    }
    assert_eq!(scribbles(&page).len(), 512, "not 1,024");
    assert!(matches!(told(&mut page), Some(Effect::Failed(_))));
}

#[test]
fn what_is_deleted_comes_back_and_what_vanishes_is_not_selected() {
    let mut page = two();
    let before = bytes(&page);
    page.session.command(Command::Select(Selecting::All));
    page.session.command(Command::Undo);
    assert_eq!(selection(&mut page).scribbles, 1, "the one that is left stays selected");
    page.session.command(Command::Redo);
    page.session.command(Command::Select(Selecting::All));
    page.session.command(Command::Arrange(Arranging::Delete));
    assert_eq!(told(&mut page), Some(Effect::ScribblesErased { erased: 2, count: 0 }));
    page.session.command(Command::Arrange(Arranging::Delete));
    page.session.command(Command::Arrange(Arranging::Duplicate));
    page.session.command(Command::Undo);
    assert_eq!(bytes(&page), before);
    assert_eq!(selection(&mut page), SelectionState::default());
    page.session.command(Command::Arrange(Arranging::Duplicate));
    page.session.command(Command::Redo);
    assert!(scribbles(&page).is_empty(), "where there is nothing to copy, nothing is in the way");
}

#[test]
fn a_command_in_the_middle_of_a_drag_ends_it() {
    let mut page = two();
    page.pen(Phase::Down, (350.0, 300.0));
    page.pen(Phase::Move, (400.0, 300.0));
    page.session.command(Command::Arrange(Arranging::Duplicate));
    page.pen(Phase::Move, (500.0, 300.0));
    page.pen(Phase::Move, (600.0, 300.0));
    page.session.pointer(Phase::Up, &[]);
    assert_eq!(scribbles(&page).len(), 3);
    for _ in 0..4 {
        page.session.command(Command::Undo);
    }
    assert!(scribbles(&page).is_empty());
    page.pen(Phase::Down, (350.0, 300.0));
    page.session.command(Command::Tool(Tool::Scribble));
    page.pen(Phase::Move, (500.0, 300.0));
    page.session.pointer(Phase::Up, &[]);
    assert!(scribbles(&page).is_empty());
}

/// The rooms with a red and a blue one, and the tool that selects.
fn rooms() -> Page {
    let mut page = Page::open(ROOMS);
    page.stroke(RED, &[(200.0, 200.0), (300.0, 300.0)]);
    page.stroke(BLUE, &[(700.0, 200.0), (800.0, 300.0)]);
    page.session.command(Command::Tool(Tool::Select));
    page.session.take_effects();
    page
}

fn alphas(page: &Page) -> Vec<u8> {
    let curves = &page.session.document().drawing.curves;
    curves.iter().filter_map(|curve| curve.line.as_ref()).map(|line| line.color.0[3]).collect()
}

#[test]
fn a_line_is_hidden_and_parts_colours_as_before() {
    let mut page = rooms();
    let before = bytes(&page);
    drag(&mut page, &[(500.0, 400.0)]);
    assert!(page.session.take_effects().contains(&Effect::Selected {
        scribbles: 0,
        lines: 1,
        place: 0,
        total: 2
    }));
    page.session.command(Command::Arrange(Arranging::Hide));
    assert_eq!(told(&mut page), Some(Effect::Edited { edit: Edit::Hidden, scribbles: 0, lines: 1 }));
    assert_eq!(alphas(&page), [0, 128]);
    assert_as_if_opened(&mut page);
    let at_line = |page: &mut Page| [(490.0, 300.0), (530.0, 300.0)].map(|place| page.color_at(place));
    assert_eq!(at_line(&mut page), [RED, BLUE]);
    drag(&mut page, &[(500.0, 400.0)]);
    page.session.command(Command::Arrange(Arranging::Hide));
    assert_eq!(alphas(&page), [255, 128]);
    page.session.command(Command::Undo);
    page.session.command(Command::Undo);
    assert_eq!(bytes(&page), before);
}

#[test]
fn a_line_is_deleted_and_colours_flow_as_in_a_drawing_without_it() {
    let mut page = rooms();
    let before = bytes(&page);
    drag(&mut page, &[(100.0, 400.0)]);
    page.session.command(Command::Arrange(Arranging::Delete));
    assert_eq!(told(&mut page), Some(Effect::Edited { edit: Edit::Deleted, scribbles: 0, lines: 1 }));
    assert_eq!(page.color_at((490.0, 490.0)), page.color_at((50.0, 50.0)), "there is one region");
    assert_as_if_opened(&mut page);
    page.session.command(Command::Undo);
    assert_eq!(bytes(&page), before);
    assert_eq!(page.color_at((490.0, 490.0)), RED);
    assert_as_if_opened(&mut page);
}

#[test]
fn a_selected_line_moves_live_and_takes_its_colours_along() {
    let mut page = rooms();
    let before = bytes(&page);
    drag(&mut page, &[(100.0, 400.0)]);
    page.pen(Phase::Down, (100.0, 400.0));
    page.pen(Phase::Move, (130.0, 420.0));
    assert_eq!(page.color_at((110.0, 110.0)), WHITE, "the corner has come in");
    page.session.pointer(Phase::Up, &[]);
    assert_eq!(told(&mut page), Some(Effect::Edited { edit: Edit::Moved, scribbles: 0, lines: 1 }));
    assert_as_if_opened(&mut page);
    page.session.command(Command::Undo);
    assert_eq!(bytes(&page), before);
    assert_eq!(page.color_at((110.0, 110.0)), RED);
}

#[test]
fn a_drag_that_begins_on_a_line_that_is_not_selected_moves_nothing() {
    let mut page = rooms();
    let before = bytes(&page);
    drag(&mut page, &[(100.0, 400.0), (250.0, 90.0), (510.0, 110.0)]);
    assert_eq!(bytes(&page), before);
    assert_eq!(selection(&mut page).scribbles, 1, "it is a rectangle");
}

#[test]
fn a_rectangle_without_scribbles_selects_the_lines_that_lie_in_it_but_no_outlines_of_ink() {
    let mut page = rooms();
    page.session.command(Command::Select(Selecting::All));
    page.session.command(Command::Arrange(Arranging::Delete));
    drag(&mut page, &[(50.0, 50.0), (510.0, 510.0)]);
    assert_eq!(selection(&mut page).lines, 1);
    drag(&mut page, &[(10.0, 10.0), (1000.0, 760.0)]);
    assert_eq!(selection(&mut page).lines, 2);
    drag(&mut page, &[(300.0, 650.0)]);
    assert_eq!(selection(&mut page).lines, 0);
}

#[test]
fn everything_can_be_chosen_from_the_keyboard() {
    let mut page = rooms();
    let mut seen = Vec::new();
    for _ in 0..5 {
        page.session.command(Command::Select(Selecting::Next));
        let state = selection(&mut page);
        seen.push([state.scribbles, state.lines]);
    }
    assert_eq!(seen, [[1, 0], [1, 0], [0, 1], [0, 1], [1, 0]]);
    page.session.command(Command::Select(Selecting::None));
    page.session.command(Command::Select(Selecting::Previous));
    assert_eq!(selection(&mut page).lines, 1);
}

/// An eraser that takes parts, and a red scribble across the square.
fn rubbing() -> Page {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &[(300.0, 300.0), (600.0, 300.0)]);
    page.stroke(BLUE, &[(100.0, 50.0), (200.0, 50.0)]);
    page.session.command(Command::EraseParts(true));
    page.session.command(Command::Tool(Tool::Erase));
    page.session.take_effects();
    page
}

#[test]
fn a_part_that_is_rubbed_out_leaves_two_like_the_whole_in_its_place() {
    let mut page = rubbing();
    let (before, exact) = (scribbles(&page), bytes(&page));
    drag(&mut page, &[(450.0, 250.0), (450.0, 350.0)]);
    assert_eq!(told(&mut page), Some(Effect::ScribblesRubbed { count: 3 }));
    assert_eq!(colors(&page), [RED, RED, BLUE]);
    let ends = |i: usize| {
        let Scribble { points, .. } = &scribbles(&page)[i];
        [points[0].x, points[points.len() - 1].x].map(f64::round)
    };
    // Half the width of the scribble and the reach of the eraser.
    assert_eq!([ends(0), ends(1)], [[300.0, 437.0], [463.0, 600.0]]);
    assert!(
        scribbles(&page)
            .iter()
            .all(|part| part.width_du == before[0].width_du && part.kind == before[0].kind)
    );
    assert_as_if_opened(&mut page);
    page.session.command(Command::Undo);
    assert_eq!(bytes(&page), exact);
}

#[test]
fn rubbing_is_live_and_one_step_however_often_it_goes_over() {
    let mut page = rubbing();
    let exact = bytes(&page);
    page.pen(Phase::Down, (300.0, 300.0));
    assert_eq!(scribbles(&page)[0].points[0].x.round(), 313.0);
    for x in 31..60 {
        page.pen(Phase::Move, (f64::from(x) * 10.0, 300.0));
    }
    page.session.pointer(Phase::Cancel, &[]);
    assert_eq!(bytes(&page), exact);
    let all: Vec<_> = (29..=61).map(|x| (f64::from(x) * 10.0, 300.0)).collect();
    drag(&mut page, &all);
    assert_eq!(colors(&page), [BLUE], "to rub out everything is to delete it");
    page.session.command(Command::Undo);
    assert_eq!(bytes(&page), exact);
}

#[test]
fn lines_that_were_changed_are_no_longer_those_of_the_sample() {
    let mut page = rooms();
    let mut work = exact::read(&page.session.work()).expect("it is read");
    work.sample = Some("rooms.svg".into());
    page.session.command(Command::Open { work: exact::write(&work), notes: String::new() });
    let sample = |page: &Page| exact::read(&page.session.work()).expect("it is read").sample;
    page.session.command(Command::Select(Selecting::Previous));
    page.session.command(Command::Arrange(Arranging::Hide));
    assert_eq!(sample(&page), None);
    page.session.command(Command::Undo);
    assert_eq!(sample(&page), Some("rooms.svg".into()));
    page.session.command(Command::Select(Selecting::All));
    page.session.command(Command::Arrange(Arranging::Delete));
    assert_eq!(sample(&page), Some("rooms.svg".into()));
}

#[test]
fn what_is_chosen_by_a_key_comes_into_sight() {
    let mut page = two();
    for _ in 0..8 {
        page.view(ViewChange::ZoomIn);
    }
    page.view(ViewChange::Pan(Vec2::new(-1e6, -1e6)));
    page.session.command(Command::Select(Selecting::Next));
    let middle = page.session.css_from_du() * Point::new(350.0, 400.0);
    assert!((0.0..=1200.0).contains(&middle.x) && (0.0..=900.0).contains(&middle.y), "{middle}");
}

#[test]
fn the_history_names_what_was_done_and_one_goes_to_any_step_of_it() {
    let mut page = two();
    page.session.command(Command::Set(Setting::Spread(true)));
    page.session.command(Command::Select(Selecting::All));
    page.session.command(Command::Color(GREEN.into()));
    page.session.command(Command::Arrow(Vec2::new(1.0, 0.0), false));
    page.session.command(Command::Settle);
    page.session.command(Command::BrushSize(30.0));
    page.session.command(Command::Settle);
    page.session.command(Command::Arrange(Arranging::Duplicate));
    page.session.command(Command::Arrange(Arranging::Delete));
    let deeds = [
        Deed::Added,
        Deed::Added,
        Deed::Spread,
        Deed::Recolored,
        Deed::Moved,
        Deed::Widened,
        Deed::Duplicated,
        Deed::Deleted,
    ];
    assert_eq!((deeds_of(&page), page.session.history().1), (deeds.to_vec(), 8));
    page.session.command(Command::GoTo(1));
    assert_eq!((deeds_of(&page), page.session.history().1), (deeds.to_vec(), 1));
    assert_eq!(colors(&page), [RED]);
    assert_eq!(page.color_at(INSIDE), RED);
    page.session.command(Command::GoTo(4));
    assert_eq!(colors(&page), [GREEN, GREEN]);
    assert_as_if_opened(&mut page);
    page.session.command(Command::GoTo(usize::MAX));
    assert_eq!(page.session.history().1, 8);
}

#[test]
fn a_colour_that_is_picked_while_something_is_dragged_goes_to_it_where_it_is() {
    let mut page = two();
    let before = page.session.document().scribbles[0].points[0];
    page.pen(Phase::Down, (350.0, 300.0));
    page.pen(Phase::Move, (350.0, 320.0));
    page.pen(Phase::Move, (350.0, 330.0));
    page.session.command(Command::Color(GREEN.into()));
    page.pen(Phase::Move, (600.0, 600.0));
    page.pen(Phase::Up, (600.0, 600.0));
    assert_eq!(colors(&page), [GREEN, BLUE]);
    let way = page.session.document().scribbles[0].points[0] - before;
    assert!((way - Vec2::new(0.0, 30.0)).hypot() < 0.01, "{way}");
    assert_eq!(deeds_of(&page)[2..], [Deed::Moved, Deed::Recolored]);
    assert_as_if_opened(&mut page);
}
