//! The tools that change nothing of the drawing: the hand, and the one that picks a colour; and the picture without its
//! colours.

use kurbo::Point;
use scumble_core::{Paint, Srgb8};
use scumble_web::brush::{Ink, Kind, ModeChange};
use scumble_web::command::{Command, Phase, Setting, Tool, ViewChange};
use scumble_web::effect::Effect;

use crate::page::{DESK, Page, SQUARE};

const RED: Srgb8 = Srgb8([230, 25, 75]);
const BLUE: Srgb8 = Srgb8([0, 90, 200]);
const WHITE: Srgb8 = Srgb8([255; 3]);
const BLACK: Srgb8 = Srgb8([0; 3]);

const ACROSS: [(f64, f64); 3] = [(300.0, 300.0), (340.0, 320.0), (380.0, 310.0)];
const INSIDE: (f64, f64) = (600.0, 560.0);
const OUTSIDE: (f64, f64) = (100.0, 100.0);
const ON_THE_LINE: (f64, f64) = (198.0, 400.0);
const BESIDE_THE_PAGE: (f64, f64) = (-20.0, 400.0);

/// A square filled with red, with a blue brush at hand.
fn filled() -> Page {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &ACROSS);
    page.session.command(Command::Color(BLUE.into()));
    page.session.take_effects();
    page
}

/// Presses the tool that picks at a place in du, and tells what the page is told.
fn pick(page: &mut Page, place_du: (f64, f64)) -> Vec<Effect> {
    page.session.command(Command::Tool(Tool::Pick));
    page.session.take_effects();
    page.pen(Phase::Down, place_du);
    page.pen(Phase::Up, place_du);
    page.session.take_effects()
}

fn picked(color: impl Into<Paint>) -> Vec<Effect> {
    let color = color.into();
    vec![Effect::Tool(Tool::Scribble), Effect::Color(Ink::Paint(color)), Effect::Picked(color)]
}

#[test]
fn the_colour_of_a_region_is_picked_exactly_and_scribbling_goes_on_with_it() {
    let mut page = filled();
    assert_eq!(pick(&mut page, INSIDE), picked(RED));
    page.pen(Phase::Down, OUTSIDE);
    assert_eq!(page.session.document().scribbles.last().map(|scribble| scribble.color), Some(RED.into()));
}

#[test]
fn what_lies_uppermost_is_picked() {
    let mut page = filled();
    page.stroke(BLUE, &[ACROSS[1], (340.0, 420.0)]);
    page.session.command(Command::Color(WHITE.into()));
    assert_eq!(pick(&mut page, ACROSS[1]), picked(BLUE));
    page.session.command(Command::Color(WHITE.into()));
    assert_eq!(pick(&mut page, ACROSS[0]), picked(RED));
    assert_eq!(pick(&mut page, ON_THE_LINE), picked(BLACK));
    assert_eq!(pick(&mut page, OUTSIDE), picked(WHITE));
}

#[test]
fn what_is_hidden_is_not_picked() {
    let mut page = filled();
    page.session.command(Command::Scribbles(false));
    page.session.command(Command::Lines(false));
    let beneath = page.color_at(ON_THE_LINE);
    assert_ne!(beneath, BLACK);
    assert_eq!(pick(&mut page, ON_THE_LINE), picked(beneath));
    page.session.command(Command::Result(false));
    assert_eq!(pick(&mut page, ACROSS[1]).last(), Some(&Effect::Picked(WHITE.into())));
    page.session.command(Command::Scribbles(true));
    assert_eq!(pick(&mut page, ACROSS[1]).last(), Some(&Effect::Picked(RED.into())));
}

#[test]
fn a_scribble_of_no_colour_gives_none_and_one_that_shades_gives_its_own() {
    let mut page = filled();
    page.session.command(Command::Color(Ink::Paint(Paint::Clear)));
    page.pen(Phase::Down, OUTSIDE);
    page.pen(Phase::Up, OUTSIDE);
    page.session.command(Command::Color(BLUE.into()));
    assert_eq!(pick(&mut page, OUTSIDE), picked(Paint::Clear));
    page.session.command(Command::Mode(ModeChange::Kind(Kind::Shade)));
    page.session.command(Command::Color(BLUE.into()));
    page.pen(Phase::Down, INSIDE);
    page.pen(Phase::Up, INSIDE);
    page.session.command(Command::Color(WHITE.into()));
    assert_eq!(pick(&mut page, INSIDE), picked(BLUE));
    let beside_its_spine = (INSIDE.0 + 10.0, INSIDE.1);
    assert_ne!(
        pick(&mut page, beside_its_spine).last(),
        Some(&Effect::Picked(BLUE.into())),
        "it is wider than drawn"
    );
}

#[test]
fn beside_the_page_there_is_no_colour_to_pick() {
    let mut page = filled();
    assert_eq!(page.color_at(BESIDE_THE_PAGE), DESK);
    assert_eq!(pick(&mut page, BESIDE_THE_PAGE), []);
}

#[test]
fn a_pick_that_is_dropped_or_has_no_place_leaves_the_colour() {
    let mut page = filled();
    page.session.command(Command::Tool(Tool::Pick));
    for phase in [Phase::Cancel, Phase::Up] {
        page.pen(Phase::Down, INSIDE);
        page.session.pointer(phase, &[]);
        page.session.pointer(Phase::Up, &[]);
    }
    assert_eq!(page.session.take_effects(), [Effect::Tool(Tool::Pick)]);
}

#[test]
fn the_phase_of_picking_does_so_with_any_tool_at_hand() {
    let mut page = filled();
    for tool in [Tool::Scribble, Tool::Hand] {
        page.session.command(Command::Color(BLUE.into()));
        page.session.command(Command::Tool(tool));
        page.session.take_effects();
        page.pen(Phase::Pick, OUTSIDE);
        page.pen(Phase::Move, INSIDE);
        page.pen(Phase::Up, INSIDE);
        assert_eq!(page.session.take_effects().last(), Some(&Effect::Picked(RED.into())));
    }
    assert_eq!(page.session.document().scribbles.len(), 1);
}

#[test]
fn the_hand_keeps_its_place_under_the_pen_and_draws_nothing() {
    let mut page = filled();
    page.view(ViewChange::ZoomIn);
    page.session.command(Command::Tool(Tool::Hand));
    let css_of_inside = |page: &Page| page.session.css_from_du() * Point::from(INSIDE);
    let start = css_of_inside(&page);
    let at = |x: f64, y: f64| [(start.x + x) as f32, (start.y + y) as f32, 1.0];
    page.session.pointer(Phase::Down, &at(0.0, 0.0));
    page.session.pointer(Phase::Move, &[at(5.0, 5.0), at(30.0, -20.0)].concat());
    assert!((css_of_inside(&page) - start - (30.0, -20.0).into()).hypot() <= 1.0);
    page.session.pointer(Phase::Up, &at(40.0, -10.0));
    assert!((css_of_inside(&page) - start - (40.0, -10.0).into()).hypot() <= 1.0);
    page.session.pointer(Phase::Move, &at(90.0, 90.0));
    assert!((css_of_inside(&page) - start - (40.0, -10.0).into()).hypot() <= 1.0, "it is lifted");
    assert_eq!(page.session.document().scribbles.len(), 1);
}

#[test]
fn the_picture_without_its_colours_has_lines_and_scribbles_alone() {
    let mut page = filled();
    assert_eq!(page.color_at(INSIDE), RED);
    page.session.command(Command::Result(false));
    assert_eq!(page.session.take_effects(), [Effect::Result(false)]);
    let colors = [INSIDE, ACROSS[1], ON_THE_LINE].map(|place| page.color_at(place));
    assert_eq!(colors, [WHITE, RED, BLACK]);
    page.stroke(BLUE, &[OUTSIDE]);
    assert_eq!(page.color_at((60.0, 700.0)), WHITE);
    page.session.command(Command::Result(true));
    assert_eq!(page.color_at(INSIDE), RED);
    assert_eq!(page.color_at((60.0, 700.0)), BLUE);
}

/// A room of 512 × 512 du with a doorway of 64 du into another one, at x = 512 du.
const DOORWAY: &[u8] = br##"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1024 512">
    <path fill="none" stroke="#000" stroke-width="4" d="M512 0V224M512 288V512"/>
</svg>"##;

#[test]
fn rooms_and_gaps_are_shown_in_place_of_the_colours_and_follow_gap_closing() {
    let mut page = Page::open(DOORWAY);
    let rooms = [(256.0, 256.0), (768.0, 256.0)];
    page.session.command(Command::Set(Setting::GapClosing(1.0)));
    page.stroke(RED, &[rooms[0], (256.0, 300.0)]);
    page.session.command(Command::Scribbles(false));
    page.session.take_effects();
    page.session.command(Command::Regions(true));
    assert_eq!(page.session.take_effects(), [Effect::Regions(true)]);
    let doorway = (512.0, 256.0);
    let [left, right] = rooms.map(|place| page.color_at(place));
    assert!(left != right && ![left, right].contains(&RED), "{left:?} {right:?}");
    assert!(![left, right].contains(&page.color_at(doorway)), "a mark");
    page.session.command(Command::Set(Setting::GapClosing(0.0)));
    let [left, right] = rooms.map(|place| page.color_at(place));
    assert!(left == right && page.color_at(doorway) == left, "the doorway is open");
    page.session.command(Command::Regions(false));
    assert_eq!(page.color_at(rooms[0]), RED);
}

#[test]
fn a_picture_for_a_list_has_the_colours_also_while_rooms_are_shown() {
    let mut page = filled();
    let before = page.thumbnail();
    page.session.command(Command::Regions(true));
    assert_ne!(page.color_at(INSIDE), RED);
    assert_eq!(page.thumbnail(), before);
    page.session.command(Command::Undo);
    assert_ne!(page.color_at(INSIDE), WHITE, "rooms have nothing to do with scribbles");
}

#[test]
fn before_is_the_drawing_without_scribbles_and_colours_whatever_is_shown() {
    let mut page = filled();
    for hide in [Command::Lines(true), Command::Lines(false), Command::Regions(true)] {
        page.session.command(hide);
        let shown = [INSIDE, ACROSS[1], ON_THE_LINE].map(|place| page.color_at(place));
        page.session.command(Command::Before(true));
        let before = [INSIDE, ACROSS[1], ON_THE_LINE].map(|place| page.color_at(place));
        assert_eq!(before, [WHITE, WHITE, BLACK]);
        page.session.command(Command::Before(false));
        assert_eq!([INSIDE, ACROSS[1], ON_THE_LINE].map(|place| page.color_at(place)), shown);
    }
}
