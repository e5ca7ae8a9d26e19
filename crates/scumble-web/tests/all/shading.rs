//! Scribbles that shade, as a person draws them: where they show, how strongly, in which colour.

use scumble_core::{Paint, PenPressure, Scribble, ScribbleKind, Shading, Srgb8, Tone};
use scumble_web::brush::{Ink, Kind, Mode, ModeChange, Pressure};
use scumble_web::command::{Command, Phase, Selecting, Tool};
use scumble_web::effect::Effect;

use crate::page::{Page, SQUARE, open};

const RED: Srgb8 = Srgb8([230, 25, 75]);
const BLUE: Srgb8 = Srgb8([0, 90, 200]);
const WHITE: Srgb8 = Srgb8([255; 3]);

const MIDDLE: (f64, f64) = (440.0, 390.0);
const CORNER: (f64, f64) = (215.0, 615.0);
const OUTSIDE: (f64, f64) = (730.0, 390.0);

/// A red square, scribbles hidden, a brush that shades at full strength.
fn page() -> Page {
    let mut page = Page::open(SQUARE);
    page.session.command(Command::Scribbles(false));
    page.stroke(RED, &[(260.0, 200.0), (300.0, 210.0)]);
    set(&mut page, ModeChange::Kind(Kind::Shade));
    set(&mut page, ModeChange::Strength(1.0));
    page
}

fn set(page: &mut Page, change: ModeChange) {
    page.session.command(Command::Mode(change));
}

fn last(page: &Page) -> &Scribble {
    page.session.document().scribbles.last().expect("a scribble")
}

/// Red, green and blue are as close as nobody tells apart.
fn assert_close(found: Srgb8, expected: Srgb8) {
    assert!(found.0.iter().zip(expected.0).all(|(a, b)| a.abs_diff(b) <= 2), "{found}, not {expected}");
}

#[test]
fn a_dab_colours_its_place_and_leaves_the_rim_of_the_region() {
    let mut page = page();
    page.stroke(BLUE, &[MIDDLE]);
    assert_close(page.color_at(MIDDLE), BLUE);
    assert_close(page.color_at(CORNER), RED);
    page.session.command(Command::Undo);
    assert_eq!(page.color_at(MIDDLE), RED);
}

#[test]
fn the_picture_follows_the_pen_and_escape_takes_it_back() {
    let mut page = page();
    page.session.command(Command::Color(BLUE.into()));
    page.pen(Phase::Down, (340.0, 390.0));
    let before = page.color_at(MIDDLE);
    page.pen(Phase::Move, MIDDLE);
    assert_ne!(page.color_at(MIDDLE), before);
    assert_close(page.color_at(MIDDLE), BLUE);
    page.session.pointer(Phase::Cancel, &[]);
    assert_eq!(page.color_at(MIDDLE), RED);
}

#[test]
fn without_strength_nothing_changes_and_undo_brings_back_every_pixel() {
    let mut page = page();
    page.color_at(MIDDLE);
    let before = page.canvas.shown.clone();
    set(&mut page, ModeChange::Strength(0.0));
    page.stroke(BLUE, &[MIDDLE]);
    page.color_at(MIDDLE);
    assert!(page.canvas.shown == before, "without strength");
    set(&mut page, ModeChange::Strength(0.4));
    page.stroke(BLUE, &[MIDDLE]);
    page.color_at(MIDDLE);
    assert!(page.canvas.shown != before);
    page.session.command(Command::Undo);
    page.color_at(MIDDLE);
    assert!(page.canvas.shown == before, "undone");
}

#[test]
fn of_a_scribble_that_shades_a_thin_spine_is_drawn_over_the_picture() {
    let mut page = page();
    page.session.command(Command::Scribbles(true));
    set(&mut page, ModeChange::Strength(0.0));
    page.stroke(BLUE, &[MIDDLE]);
    assert_ne!(page.color_at(MIDDLE), RED);
    assert_eq!(page.color_at((MIDDLE.0 + 8.0, MIDDLE.1)), RED);
}

#[test]
fn a_stroke_stays_in_its_region_unless_it_crosses() {
    for crosses in [false, true] {
        let mut page = page();
        set(&mut page, ModeChange::Crosses(crosses));
        page.stroke(BLUE, &[MIDDLE, OUTSIDE]);
        assert_eq!(page.color_at(OUTSIDE) != WHITE, crosses);
    }
}

#[test]
fn a_tone_is_a_step_from_what_is_under_the_first_point() {
    let mut page = page();
    for tone in [Tone::Lighter, Tone::Darker, Tone::Warmer, Tone::Cooler] {
        page.session.command(Command::Color(Ink::Tone(tone)));
        page.pen(Phase::Down, MIDDLE);
        page.pen(Phase::Move, OUTSIDE);
        page.session.pointer(Phase::Up, &[]);
        assert_eq!(last(&page).color, Paint::Color(tone.step(RED)));
        page.session.command(Command::Undo);
    }
    page.session.command(Command::Color(Ink::Tone(Tone::Darker)));
    page.pen(Phase::Down, OUTSIDE);
    assert_eq!(last(&page).color, Paint::Color(Tone::Darker.step(WHITE)), "on paper");
}

#[test]
fn a_tone_is_taken_from_the_stroke_that_was_drawn_just_before() {
    let mut page = page();
    page.stroke(BLUE, &[MIDDLE]);
    page.session.command(Command::Color(Ink::Tone(Tone::Lighter)));
    page.pen(Phase::Down, MIDDLE);
    let Paint::Color(color) = last(&page).color else { panic!("a colour") };
    assert_close(color, Tone::Lighter.step(BLUE));
}

#[test]
fn a_tone_goes_when_a_colour_is_picked_and_does_not_fill() {
    let mut page = page();
    let tone = Ink::Tone(Tone::Warmer);
    let told = |page: &mut Page, command: Command| {
        page.session.take_effects();
        page.session.command(command);
        page.session.take_effects().into_iter().find_map(|effect| match effect {
            Effect::Color(ink) => Some(ink),
            _ => None,
        })
    };
    assert_eq!(told(&mut page, Command::Color(tone)), Some(tone));
    assert_eq!(told(&mut page, Command::Color(tone)), None, "it stays");
    assert_eq!(told(&mut page, Command::SwapColors), Some(RED.into()));
    told(&mut page, Command::Color(tone));
    assert_eq!(told(&mut page, Command::Mode(ModeChange::OtherKind)), Some(RED.into()));
    assert_eq!(told(&mut page, Command::Mode(ModeChange::OtherKind)), Some(tone));
    assert_eq!(told(&mut page, Command::Color(BLUE.into())), Some(BLUE.into()));
}

#[test]
fn each_kind_has_a_size_of_its_own_and_is_for_scribbling() {
    let mut page = Page::open(SQUARE);
    page.session.command(Command::BrushSize(30.0));
    page.session.command(Command::Tool(Tool::Erase));
    page.session.take_effects();
    set(&mut page, ModeChange::OtherKind);
    let shade = Mode { kind: Kind::Shade, ..Mode::default() };
    let told = page.session.take_effects();
    assert_eq!(told, [Effect::Tool(Tool::Scribble), Effect::Mode(shade), Effect::BrushSize(64.0)]);
    page.session.command(Command::BrushSize(1e9));
    assert_eq!(page.session.take_effects(), [Effect::BrushSize(256.0)]);
    set(&mut page, ModeChange::OtherKind);
    assert_eq!(page.session.take_effects(), [Effect::Mode(Mode::default()), Effect::BrushSize(30.0)]);
}

/// Samples of a pen that goes down the canvas, with these pressures.
fn samples(from_y: f32, pressures: &[f32]) -> Vec<f32> {
    let places = (0..).map(|i| from_y + 20.0 * i as f32);
    places.zip(pressures).flat_map(|(y, &pressure)| [500.0, y, pressure]).collect()
}

#[test]
fn the_pressure_at_each_point_is_a_part_of_the_radius_or_of_the_strength() {
    let press = |pressure: Pressure, pressures: &[f32]| {
        let mut page = page();
        set(&mut page, ModeChange::Strength(0.5));
        set(&mut page, ModeChange::Pressure(pressure));
        page.session.pointer(Phase::Down, &samples(400.0, &pressures[..1]));
        page.session.pointer(Phase::Move, &samples(420.0, &pressures[1..]));
        page.session.pointer(Phase::Up, &samples(480.0, &[0.0]));
        let scribble = last(&page);
        let shading = scribble.shading().expect("a shade");
        assert_eq!((scribble.width_du, shading.strength), (64.0, 0.5), "as they are set");
        shading.pressure.clone()
    };
    let rising = [0.25, 0.75, 0.504];
    let parts = vec![0.25, 0.75, 0.5, 0.5];
    assert_eq!(press(Pressure::Radius, &rising), PenPressure::Radius(parts.clone()));
    assert_eq!(press(Pressure::Strength, &rising), PenPressure::Strength(parts));
    assert_eq!(press(Pressure::Off, &rising), PenPressure::Even);
    let lightest = [press(Pressure::Radius, &[0.0, -1.0]), press(Pressure::Strength, &[0.0, -1.0])];
    assert_eq!(lightest, [PenPressure::Radius(vec![0.1; 2]), PenPressure::Strength(vec![0.0; 2])]);
    for pressure in [Pressure::Radius, Pressure::Strength] {
        assert_eq!(press(pressure, &[f32::NAN, 9.0, 1.0]), PenPressure::Even, "as of a mouse");
    }
}

#[test]
fn samples_that_lie_nowhere_take_their_pressure_along() {
    let mut page = page();
    page.session.pointer(Phase::Down, &samples(400.0, &[0.2]));
    page.session.pointer(Phase::Move, &[f32::NAN, 0.0, 0.9, 520.0, 400.0, 0.4]);
    let shading = last(&page).shading().expect("a shade");
    assert_eq!(shading.pressure, PenPressure::Radius(vec![0.2, 0.4]));
}

#[test]
fn a_tone_of_a_shade_that_is_selected_is_one_of_what_is_under_it() {
    let mut page = page();
    page.stroke(BLUE, &[MIDDLE]);
    page.session.command(Command::Select(Selecting::Next));
    let shade = last(&page).clone();
    assert!(!shade.is_fill());
    for tone in [Tone::Darker, Tone::Darker, Tone::Lighter] {
        page.session.command(Command::Color(Ink::Tone(tone)));
        assert_eq!(last(&page).color, Paint::Color(tone.step(RED)));
    }
    page.session.command(Command::Undo);
    page.session.command(Command::Undo);
    assert_eq!(last(&page), &shade, "the same tone again is no change");
}

#[test]
fn strength_crossing_and_pen_are_for_the_shades_that_are_selected() {
    let mut page = page();
    set(&mut page, ModeChange::Strength(0.25));
    page.session.pointer(Phase::Down, &samples(400.0, &[0.5]));
    page.session.pointer(Phase::Move, &samples(420.0, &[0.75]));
    page.session.pointer(Phase::Up, &[]);
    let drawn = last(&page).clone();
    set(&mut page, ModeChange::Strength(0.9));
    page.session.command(Command::Select(Selecting::All));
    page.session.take_effects();
    let mode = |page: &mut Page| {
        page.session.take_effects().into_iter().rev().find_map(|effect| match effect {
            Effect::Mode(mode) => Some(mode),
            _ => None,
        })
    };
    for strength in [0.3, 0.5] {
        page.session.command(Command::Mode(ModeChange::Strength(strength)));
        assert_eq!(last(&page).shading().expect("a shade").strength, strength);
        assert_eq!(mode(&mut page).map(|mode| mode.strength), Some(strength), "and it is shown");
    }
    page.session.command(Command::Settle);
    page.session.command(Command::Mode(ModeChange::Crosses(true)));
    page.session.command(Command::Mode(ModeChange::Pressure(Pressure::Strength)));
    let pressure = PenPressure::Strength(vec![0.5, 0.75]);
    let after = Shading { strength: 0.5, crosses: true, pressure };
    assert_eq!(last(&page).kind, ScribbleKind::Shade(after));
    (0..3).for_each(|_| page.session.command(Command::Undo));
    assert_eq!(last(&page), &drawn, "a slider that was dragged is one gesture");
    page.session.take_effects();
    page.session.command(Command::Select(Selecting::None));
    assert_eq!(mode(&mut page).map(|mode| mode.strength), Some(0.9), "that of the next one");
}

#[test]
fn what_the_controls_show_of_a_shade_is_what_they_change() {
    let mut page = page();
    page.stroke(BLUE, &[MIDDLE]);
    let drawn = last(&page).clone();
    set(&mut page, ModeChange::OtherKind);
    page.session.command(Command::Select(Selecting::Next));
    // To and fro is no step.
    for strength in [0.2, 0.9, drawn.shading().expect("a shade").strength] {
        page.session.command(Command::Mode(ModeChange::Strength(strength)));
    }
    page.session.command(Command::Settle);
    assert_eq!(last(&page), &drawn);
    page.session.command(Command::Undo);
    assert_ne!(last(&page), &drawn, "undone as it was drawn");
    page.session.command(Command::Redo);
    page.session.command(Command::Select(Selecting::Next));
    page.session.take_effects();
    let mut told = |change: ModeChange| {
        page.session.command(Command::Mode(change));
        page.session.take_effects().into_iter().rev().find_map(|effect| match effect {
            Effect::Mode(mode) => Some((mode.kind, mode.pressure)),
            _ => None,
        })
    };
    // No pen pressed it: the list shows what was chosen all the same, for the next.
    assert_eq!(told(ModeChange::Pressure(Pressure::Strength)), Some((Kind::Shade, Pressure::Strength)));
    assert_eq!(told(ModeChange::Pressure(Pressure::Off)), Some((Kind::Shade, Pressure::Off)));
    assert_eq!(told(ModeChange::OtherKind), Some((Kind::Fill, Pressure::Off)), "other than what is shown");
}

#[test]
fn a_stroke_ends_as_it_began_whatever_is_set_meanwhile() {
    let mut page = page();
    page.pen(Phase::Down, MIDDLE);
    let [before, after] = [(); 2].map(|()| {
        set(&mut page, ModeChange::OtherKind);
        page.session.command(Command::BrushLarger);
        page.pen(Phase::Move, CORNER);
        (last(&page).width_du, last(&page).kind.clone())
    });
    assert_eq!(before, after);
    let shading = Shading { strength: 1.0, ..Shading::default() };
    assert_eq!(before, (64.0, ScribbleKind::Shade(shading)));
}

#[test]
fn pressure_changes_nothing_about_a_scribble_that_fills() {
    let mut page = Page::open(SQUARE);
    page.session.pointer(Phase::Down, &samples(400.0, &[0.1]));
    page.session.pointer(Phase::Up, &[]);
    assert_eq!((last(&page).width_du, &last(&page).kind), (16.0, &ScribbleKind::Fill));
}

#[test]
fn strengths_of_any_kind_stay_within_their_range() {
    let mut page = page();
    for (given, kept) in [(7.0, 1.0), (-1.0, 0.0), (f64::NAN, 0.0), (f64::INFINITY, 1.0)] {
        set(&mut page, ModeChange::Strength(given));
        page.stroke(BLUE, &[MIDDLE]);
        let shading = Shading { strength: kept, ..Shading::default() };
        assert_eq!(last(&page).kind, ScribbleKind::Shade(shading));
    }
}

#[test]
fn a_drawing_opens_with_its_scribbles_and_nothing_to_undo() {
    let mut page = Page::open(SQUARE);
    let scribble = Scribble {
        color: BLUE.into(),
        kind: ScribbleKind::Fill,
        width_du: 8.0,
        points: vec![(400.0, 400.0).into(), (420.0, 400.0).into()],
    };
    page.session.command(open(SQUARE, std::slice::from_ref(&scribble)));
    assert_eq!(last(&page), &scribble);
    assert_eq!(page.color_at(MIDDLE), BLUE);
    page.session.command(open(SQUARE, &[]));
    page.session.take_effects();
    page.session.command(Command::Undo);
    assert_eq!(page.session.take_effects(), [], "nobody has worked on either");
}
