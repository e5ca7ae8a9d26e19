//! The editor without a browser: gestures and commands in, paintings and effects out.

use kurbo::{Point, Rect, Vec2};
use scumble_core::{Blend, ColorPoint, EngineKind, Paint, Settings, Srgb8, Swatch, Tracing, exact};
use scumble_io::{read_file, write_file};
use scumble_web::brush::{Ink, ModeChange};
use scumble_web::command::{Command, Phase, Selecting, Setting, Tool, ViewChange};
use scumble_web::effect::{Effect, SheetState, TracingState};
use scumble_web::painting::{Changed, PAPER};

use crate::page::{self, DESK, Page, SQUARE, pixel};

const RED: Srgb8 = Srgb8([230, 25, 75]);
const BLUE: Srgb8 = Srgb8([0, 90, 200]);
const WHITE: Srgb8 = Srgb8([255; 3]);

const ACROSS: [(f64, f64); 3] = [(300.0, 300.0), (340.0, 320.0), (380.0, 310.0)];
const INSIDE: (f64, f64) = (600.0, 560.0);
const OUTSIDE: (f64, f64) = (100.0, 100.0);
/// Outside the square, under the ink of its left side.
const ON_THE_LINE: (f64, f64) = (198.0, 400.0);

#[test]
fn a_scribble_colours_its_square_and_nothing_else() {
    let mut page = Page::open(SQUARE);
    assert_eq!(page.color_at(INSIDE), WHITE);
    page.stroke(RED, &ACROSS);
    assert_eq!(page.color_at(INSIDE), RED);
    assert_eq!(page.color_at(ACROSS[1]), RED);
    assert_eq!(page.color_at(OUTSIDE), WHITE);
    assert_eq!(page.color_at(ON_THE_LINE), Srgb8([0; 3]));
    assert_eq!(page.color_at((-20.0, 400.0)), DESK);
}

#[test]
fn colour_follows_the_pen_before_it_is_lifted_and_escape_takes_it_back() {
    let mut page = Page::open(SQUARE);
    page.session.command(Command::Color(RED.into()));
    page.pen(Phase::Down, ACROSS[0]);
    assert_eq!(page.color_at(INSIDE), RED);
    page.pen(Phase::Move, ACROSS[1]);
    page.session.pointer(Phase::Cancel, &[]);
    assert_eq!(page.color_at(INSIDE), WHITE);
    assert!(page.session.document().scribbles.is_empty());
    page.pen(Phase::Move, ACROSS[2]);
    assert!(page.session.document().scribbles.is_empty(), "a move without a beginning is no scribble");
}

#[test]
fn one_gesture_is_one_step_of_undo() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &ACROSS);
    page.stroke(BLUE, &ACROSS);
    assert_eq!(page.color_at(INSIDE), BLUE);
    page.session.command(Command::Undo);
    assert_eq!(page.color_at(INSIDE), RED);
    page.session.command(Command::Undo);
    assert_eq!(page.color_at(INSIDE), WHITE);
    page.session.command(Command::Redo);
    assert_eq!(page.color_at(INSIDE), RED);
}

#[test]
fn effects_tell_what_has_changed_and_only_that() {
    let mut page = Page::open(SQUARE);
    let first = page.session.take_effects();
    assert!(first.contains(&Effect::Undo(false)) && first.contains(&Effect::Zoom(1.0)));
    assert!(first.contains(&Effect::Opened { notes: String::new() }));
    assert_eq!(page.session.take_effects(), []);
    page.session.command(Command::Color(RED.into()));
    assert_eq!(page.session.take_effects(), [Effect::Color(RED.into())]);
    page.stroke(RED, &ACROSS);
    let sheet = |revision| Effect::Sheet(SheetState { sheet: 1, revision });
    let told = page.session.take_effects();
    assert_eq!(told, [sheet(1), Effect::Undo(true), Effect::ScribbleAdded { count: 1, is_fill: true }]);
    page.session.command(Command::Undo);
    let told = page.session.take_effects();
    assert_eq!(told, [sheet(0), Effect::Undo(false), Effect::Redo(true), Effect::Undone]);
}

/// Places on a round way within the square.
fn round(count: u32) -> impl Iterator<Item = (f64, f64)> {
    let angles = (0..count).map(|i| 0.3 * f64::from(i));
    angles.map(|angle| (400.0 + 90.0 * angle.cos(), 400.0 + 90.0 * angle.sin()))
}

#[test]
fn a_scribble_in_hand_grows_at_its_end_alone_and_is_drawn_round() {
    let mut page = Page::open(SQUARE);
    page.session.command(Command::Color(RED.into()));
    let mut before: Vec<Point> = Vec::new();
    for (i, place) in round(12).enumerate() {
        page.pen(if i == 0 { Phase::Down } else { Phase::Move }, place);
        let points = page.session.document().scribbles[0].points.clone();
        assert!(points.starts_with(&before) && points.len() > before.len(), "the labels go on with it");
        before = points;
    }
    // Half way between two samples the arc lies 1 du beyond the chord; the rim of the scribble shows which.
    let half_width_du = page.session.document().scribbles[0].width_du / 2.0;
    let (sin, cos) = (0.3_f64 * 4.5).sin_cos();
    let at = |radius: f64| (400.0 + radius * cos, 400.0 + radius * sin);
    let rims = [half_width_du + 0.2, half_width_du + 5.0].map(|beyond| page.color_at(at(90.0 + beyond)));
    page.session.pointer(Phase::Up, &[]);
    assert_eq!(
        rims,
        [half_width_du + 0.2, half_width_du + 5.0].map(|beyond| page.color_at(at(90.0 + beyond)))
    );
    assert_ne!(rims[0], rims[1]);
}

/// The exact bytes of a drawing with a scribble across it.
fn scribbled() -> Vec<u8> {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &ACROSS);
    page.session.work()
}

#[test]
fn what_was_made_ready_opens_as_what_was_not() {
    let work = scribbled();
    let opened = [false, true].map(|is_prepared| {
        let mut page = Page::open(SQUARE);
        page.session.take_effects();
        if is_prepared {
            page.session.prepare(&work);
            let steps = std::iter::from_fn(|| page.session.prepare_on().then_some(())).count();
            assert!(steps >= 2, "{steps} and the last");
            assert_eq!(page.session.take_effects(), [], "nothing is shown of it");
            assert!(page.session.document().scribbles.is_empty());
        }
        page.session.command(Command::Open { work: work.clone(), notes: String::new() });
        assert!(page.session.take_effects().contains(&Effect::Opened { notes: String::new() }));
        (page.color_at(INSIDE), page.session.work())
    });
    assert_eq!(opened[0], opened[1]);
    assert_eq!(opened[1].0, RED);
}

#[test]
fn a_stroke_that_a_setting_ends_is_kept_as_any_other() {
    let strokes = [Some(Setting::Spread(true)), Some(Setting::GapClosing(0.2)), None].map(|setting| {
        let mut page = Page::open(SQUARE);
        for (i, place) in round(12).enumerate() {
            page.pen(if i == 0 { Phase::Down } else { Phase::Move }, place);
        }
        match setting {
            Some(setting) => page.session.command(Command::Set(setting)),
            None => page.session.pointer(Phase::Up, &[]),
        }
        page.session.document().scribbles[0].points.clone()
    });
    assert!(strokes[0].len() > 12);
    assert_eq!(strokes[0], strokes[2]);
    assert_eq!(strokes[1], strokes[2]);
}

#[test]
fn a_stroke_in_hand_is_kept_in_the_drawing_that_another_is_opened_over() {
    let mut page = Page::open(SQUARE);
    page.session.command(Command::Color(RED.into()));
    for (i, place) in ACROSS.into_iter().enumerate() {
        page.pen(if i == 0 { Phase::Down } else { Phase::Move }, place);
    }
    page.session.command(Command::Open { work: scribbled(), notes: String::new() });
    page.pen(Phase::Move, (500.0, 500.0));
    page.session.pointer(Phase::Up, &[]);
    assert_eq!(page.session.document().scribbles.len(), 1, "the pen goes on without drawing");
    page.session.command(Command::Undo);
    assert!(page.session.document().scribbles[0].points.len() >= ACROSS.len());
    assert_eq!(page.color_at(INSIDE), RED);
    page.session.command(Command::Undo);
    assert!(page.session.document().scribbles.is_empty());
}

#[test]
fn what_is_made_ready_may_be_left_damaged_or_something_else() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &ACROSS);
    let (before, work) = (page.session.work(), scribbled());
    page.session.prepare(&work);
    page.session.prepare_on();
    page.session.command(Command::StopPreparing);
    assert!(!page.session.prepare_on());
    page.session.prepare(b"damaged");
    assert!(!page.session.prepare_on());
    assert_eq!(page.session.work(), before);
    // Another drawing than the one that is ready.
    page.session.prepare(&work);
    while page.session.prepare_on() {}
    page.session.command(page::open(SQUARE, &[]));
    assert!(page.session.document().scribbles.is_empty());
}

#[test]
fn frames_are_painted_only_when_something_has_changed() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &ACROSS);
    page.color_at(INSIDE);
    page.color_at(INSIDE);
    assert_eq!(page.canvas.frames, [Changed::ALL]);
    page.view(ViewChange::Pan((3.0, 4.0).into()));
    page.color_at(INSIDE);
    assert_eq!(page.canvas.frames.last(), Some(&Changed::default()), "a move of the view uploads nothing");
    page.session.command(Command::Scribbles(false));
    page.color_at(INSIDE);
    let hidden = page.canvas.frames.last().cloned().expect("a frame");
    assert_eq!(hidden, Changed { scribbles: true, within_du: hidden.within_du, ..Changed::default() });
    // The stroke with its rim, and no more.
    let within = hidden.within_du.expect("a stroke");
    let stroke =
        ACROSS.map(Point::from).map(|p| Rect::from_points(p, p)).into_iter().reduce(|a, b| a.union(b));
    let room = within.size() - stroke.expect("a stroke").size();
    assert!((16.0..24.0).contains(&room.width) && (16.0..24.0).contains(&room.height), "{within}");
}

#[test]
fn the_exported_picture_is_the_canvas_at_100_percent() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &[(300.0, 300.0), (700.0, 650.0)]);
    page.stroke(BLUE, &[(250.0, 200.0), (300.0, 260.0)]);
    page.session.command(Command::Scribbles(false));
    page.session.frame(&mut page.canvas);
    let picture = page.session.export(1024.0, true).rows(0, 768, Some(PAPER));
    assert_eq!((picture.width_px, picture.height_px), (1024, 768));
    let shown = page.canvas.shown.as_ref().unwrap();
    let [.., x, y] = page.session.css_from_du().as_coeffs();
    for row in 0..768 {
        let start = 4 * ((row + y as usize) * 1200 + x as usize);
        let of_canvas = &shown.rgba[start..start + 4 * 1024];
        assert_eq!(of_canvas, &picture.rgba[4 * 1024 * row..4 * 1024 * (row + 1)], "row {row}");
    }
}

#[test]
fn an_exported_picture_comes_in_strips_and_stays_as_it_was() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &ACROSS);
    let export = page.session.export(500.0, false);
    page.session.command(Command::Undo);
    page.session.frame(&mut page.canvas);
    let whole = export.rows(0, export.view.height_px, None);
    let at = |(x, y): (f64, f64)| pixel(&whole, Point::new(x * 500.0 / 1024.0, y * 500.0 / 1024.0));
    assert_eq!((at(INSIDE), at(OUTSIDE)), (RED, Srgb8([0; 3])));
    let strips = [(0, 100), (100, 200), (300, 75)].map(|(first, count)| export.rows(first, count, None).rgba);
    assert!(strips.concat() == whole.rgba);
}

#[test]
fn the_thumbnail_is_the_whole_page_small_and_leaves_the_canvas_as_it_was() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &ACROSS);
    let before = page.color_at(OUTSIDE);
    let thumbnail = page.thumbnail();
    assert_eq!(thumbnail.width_px.max(thumbnail.height_px), 240);
    assert_eq!(thumbnail.rgba.len() as u32, 4 * thumbnail.width_px * thumbnail.height_px);
    let at = |(x, y): (f64, f64)| pixel(&thumbnail, Point::new(x * 240.0 / 1024.0, y * 240.0 / 1024.0));
    assert_eq!((at(INSIDE), at(OUTSIDE)), (RED, WHITE));
    assert_eq!(page.color_at(OUTSIDE), before);
}

#[test]
fn lines_and_scribbles_can_be_hidden() {
    let mut page = Page::open(SQUARE);
    page.session.command(Command::Set(Setting::Blend(Blend::Srgb)));
    page.stroke(RED, &[(50.0, 50.0), (90.0, 50.0)]);
    page.stroke(BLUE, &[(60.0, 40.0), (60.0, 60.0)]);
    page.session.command(Command::Lines(false));
    page.session.command(Command::Scribbles(false));
    let at_scribbles = |page: &mut Page| [(85.0, 50.0), (60.0, 57.0)].map(|place| page.color_at(place));
    assert_ne!(at_scribbles(&mut page), [RED, BLUE]);
    assert!([RED, BLUE].contains(&page.color_at(ON_THE_LINE)));
    page.session.command(Command::Lines(true));
    page.session.command(Command::Scribbles(true));
    assert_eq!(page.color_at(ON_THE_LINE), Srgb8([0; 3]));
    assert_eq!(at_scribbles(&mut page), [RED, BLUE]);
}

#[test]
fn a_drawing_is_opened_with_its_lines_shown() {
    let mut page = Page::open(SQUARE);
    page.session.command(Command::Lines(false));
    assert_ne!(page.color_at(ON_THE_LINE), Srgb8([0; 3]));
    page.session.command(Command::Open { work: page.session.work(), notes: String::new() });
    assert_eq!(page.color_at(ON_THE_LINE), Srgb8([0; 3]));
}

#[test]
fn a_file_holds_every_number_of_the_work() {
    let odd = br#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 333 777">
        <path d="M31.4159 27.1828C99 17.7 123.456 77 300.1 66.6V570.7H30.3Z" fill="none" stroke="black" stroke-width="1.7"/></svg>"#;
    let mut page = Page::open(odd);
    page.view(ViewChange::Fit);
    page.stroke(RED, &[(100.123, 200.456), (180.7, 260.9), (222.2, 333.3)]);
    page.session.command(Command::Mode(ModeChange::OtherKind));
    page.stroke(BLUE, &[(120.3, 400.4), (140.7, 460.1)]);
    page.session.command(Command::Select(Selecting::All));
    page.session.command(Command::Arrow(Vec2::new(0.7, 0.3), false));
    let work = page.session.work();
    let file = write_file(&exact::read(&work).expect("its own bytes")).expect("a file");
    assert_eq!(exact::write(&read_file(&file).expect("its own file")), work);
}

#[test]
fn work_that_is_damaged_leaves_the_drawing_as_it_was() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &ACROSS);
    let whole = page.session.work();
    page.session.take_effects();
    for work in [&b""[..], b"<svg/>", &whole[1..], &whole[..whole.len() - 1]] {
        page.session.command(Command::Open { work: work.to_vec(), notes: String::new() });
        let effects = page.session.take_effects();
        assert!(matches!(effects[..], [Effect::Failed(_)]), "{effects:?}");
        assert_eq!(page.color_at(INSIDE), RED);
    }
}

#[test]
fn a_palette_is_of_its_drawing_and_undo_takes_it_back() {
    let mut page = Page::open(SQUARE);
    page.session.take_effects();
    let palette = [RED.into(), Paint::Clear].map(Swatch::from).to_vec();
    page.session.command(Command::Palette(palette.clone()));
    assert!(page.session.take_effects().contains(&Effect::Palette(palette.clone())));
    assert_eq!(exact::read(&page.session.work()).expect("work").document.palette, palette);
    page.session.command(Command::Palette(palette.clone()));
    page.session.command(Command::Undo);
    let effects = page.session.take_effects();
    assert!(effects.contains(&Effect::Palette(vec![])) && effects.contains(&Effect::Undone), "{effects:?}");
    page.session.command(Command::Redo);
    assert!(page.session.take_effects().contains(&Effect::Palette(palette.clone())));
    page.session.command(page::open(SQUARE, &[]));
    assert!(page.session.take_effects().contains(&Effect::Palette(vec![])));
    page.session.command(Command::Undo);
    assert!(page.session.take_effects().contains(&Effect::Palette(palette)));
}

#[test]
fn a_palette_that_comes_in_the_middle_of_a_scribble_keeps_it() {
    let mut page = Page::open(SQUARE);
    page.session.command(Command::Color(RED.into()));
    page.pen(Phase::Down, ACROSS[0]);
    page.session.command(Command::Palette(vec![Paint::from(RED).into()]));
    assert_eq!(page.session.document().scribbles.len(), 1);
    page.session.command(Command::Undo);
    assert_eq!((page.session.document().scribbles.len(), page.session.document().palette.len()), (1, 0));
}

#[test]
fn what_has_the_colour_of_a_swatch_follows_it_in_one_gesture() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &ACROSS);
    let palette = |color: Srgb8| vec![Swatch { color: color.into(), name: "Skin".into() }];
    page.session.command(Command::Palette(palette(RED)));
    let before = page.session.work();
    let repaint = |page: &mut Page, to: Srgb8| {
        page.session.command(Command::Repaint { palette: palette(to), from: RED.into(), to: to.into() });
    };
    for to in [Srgb8([90, 20, 200]), BLUE] {
        repaint(&mut page, to);
        assert_eq!(page.color_at(INSIDE), to, "seen at once");
    }
    page.session.command(Command::Settle);
    assert_eq!(page.session.document().palette, palette(BLUE));
    page.session.command(Command::Undo);
    assert_eq!(page.session.work(), before);
    assert_eq!(page.color_at(INSIDE), RED);
    page.session.command(Command::Redo);
    assert_eq!(page.color_at(INSIDE), BLUE);
}

#[test]
fn a_swatch_that_is_edited_while_the_pen_is_down_waits() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &ACROSS);
    page.session.command(Command::Tool(Tool::Erase));
    page.pen(Phase::Down, ACROSS[0]);
    assert_eq!(page.session.document().scribbles.len(), 0);
    page.session.command(Command::Repaint { palette: vec![], from: RED.into(), to: BLUE.into() });
    assert_eq!(page.session.document().scribbles.len(), 0, "what is erased stays so");
}

#[test]
fn colours_set_by_hand_show() {
    let mut page = Page::open(SQUARE);
    let mut work = exact::read(&page.session.work()).expect("work");
    let point = |is_left| ColorPoint { curve: 0, is_left, at_du: 0.0, color: RED.into() };
    work.document.color_points = vec![point(true), point(false)];
    page.session.command(Command::Open { work: exact::write(&work), notes: String::new() });
    assert_eq!(page.color_at(INSIDE), RED);
}

#[test]
fn work_comes_back_with_all_that_was_opened_with_it() {
    let mut page = Page::open(SQUARE);
    let mut work = exact::read(&page.session.work()).expect("work");
    work.document.palette = [RED.into(), Paint::Clear].map(Swatch::from).to_vec();
    work.sample = Some("square.svg".into());
    let notes = "left out: 1 text".to_owned();
    page.session.command(Command::Open { work: exact::write(&work), notes: notes.clone() });
    let effects = page.session.take_effects();
    assert!(
        effects.contains(&Effect::Palette(work.document.palette.clone()))
            && effects.contains(&Effect::Opened { notes })
    );
    page.stroke(RED, &ACROSS);
    let again = exact::read(&page.session.work()).expect("work");
    let with_scribble = work.edited(page.session.document().clone());
    assert_eq!(exact::write(&again), exact::write(&with_scribble));
    assert_eq!((again.document.scribbles.len(), again.document.drawing.curves.len()), (1, 1));
}

#[test]
fn each_drawing_is_told_from_the_others_and_its_states_from_each_other() {
    let sheet = |page: &mut Page| {
        let sheets = page.session.take_effects().into_iter().filter_map(|effect| match effect {
            Effect::Sheet(SheetState { sheet, revision }) => Some((sheet, revision)),
            _ => None,
        });
        sheets.collect::<Vec<_>>()
    };
    let mut page = Page::open(SQUARE);
    assert_eq!(sheet(&mut page), [(1, 0)]);
    page.pen(Phase::Down, INSIDE);
    assert_eq!(sheet(&mut page), [], "a scribble in hand may be dropped yet");
    page.session.pointer(Phase::Up, &[]);
    assert_eq!(sheet(&mut page), [(1, 1)]);
    page.session.command(page::open(SQUARE, &[]));
    assert_eq!(sheet(&mut page), [(2, 0)]);
    page.session.command(Command::Undo);
    assert_eq!(sheet(&mut page), [(1, 1)]);
    page.session.command(Command::Undo);
    assert_eq!(sheet(&mut page), [(1, 0)]);
}

#[test]
fn drawings_that_undo_does_not_come_back_to_are_told_of() {
    let mut page = Page::open(SQUARE);
    page.session.take_effects();
    let mut closed = |command| {
        page.session.command(command);
        page.session.take_effects().into_iter().find_map(|effect| match effect {
            Effect::Closed(sheet) => Some(sheet),
            _ => None,
        })
    };
    assert_eq!(closed(page::open(SQUARE, &[])), Some(1), "nobody has worked on it");
    for opened in 2..10 {
        closed(Command::Palette(vec![Paint::from(RED).into()]));
        assert_eq!(closed(page::open(SQUARE, &[])), None, "over number {opened}");
    }
    closed(Command::Palette(vec![Paint::from(RED).into()]));
    assert_eq!(closed(page::open(SQUARE, &[])), Some(2));
    let undone: Vec<_> = (0..3).map(|_| closed(Command::Undo)).collect();
    assert_eq!(undone, [None; 3], "redo comes back to number 11 and 10");
    assert_eq!(closed(page::open(SQUARE, &[])), Some(11), "and no longer");
}

#[test]
fn samples_that_are_no_numbers_are_left_out() {
    let mut page = Page::open(SQUARE);
    page.session.pointer(Phase::Down, &[f32::NAN, 0.0, 0.5]);
    page.session.pointer(Phase::Up, &[]);
    assert!(page.session.document().scribbles.is_empty());
    page.session.pointer(Phase::Down, &[400.0, 400.0, 0.5, f32::INFINITY, 0.0, 0.5]);
    page.session.pointer(Phase::Up, &[f32::NAN, 1.0]);
    assert_eq!(page.session.document().scribbles.len(), 1);
    assert_eq!(page.session.document().scribbles[0].points.len(), 1);
}

#[test]
fn the_brush_stays_within_its_bounds_and_colours_swap() {
    let mut page = Page::open(SQUARE);
    for _ in 0..40 {
        page.session.command(Command::BrushSmaller);
    }
    assert!(page.session.take_effects().contains(&Effect::BrushSize(2.0)));
    for _ in 0..40 {
        page.session.command(Command::BrushLarger);
    }
    assert_eq!(page.session.take_effects(), [Effect::BrushSize(96.0)]);
    page.session.command(Command::Color(RED.into()));
    page.session.command(Command::Color(BLUE.into()));
    page.session.command(Command::SwapColors);
    assert_eq!(page.session.take_effects(), [Effect::Color(RED.into())]);
    page.session.command(Command::SwapColors);
    assert_eq!(page.session.take_effects(), [Effect::Color(BLUE.into())]);
}

#[test]
fn a_colour_that_is_tuned_leaves_the_one_before_as_it_is() {
    let mut page = Page::open(SQUARE);
    page.session.command(Command::Color(RED.into()));
    page.session.command(Command::Color(Srgb8([9; 3]).into()));
    page.session.command(Command::Tool(Tool::Erase));
    for color in [Srgb8([10; 3]), BLUE] {
        page.session.command(Command::TuneColor(color.into()));
    }
    let effects = page.session.take_effects();
    assert!(effects.contains(&Effect::Color(BLUE.into())), "{effects:?}");
    page.session.command(Command::SwapColors);
    assert_eq!(page.session.take_effects(), [Effect::Color(RED.into())]);
}

#[test]
fn edges_are_sharp_at_800_percent() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &ACROSS);
    let at = page.session.css_from_du() * Point::new(200.0, 400.0);
    page.view(ViewChange::ZoomAt(at, 8.0));
    page.session.command(Command::Scribbles(false));
    page.session.frame(&mut page.canvas);
    let middle = page.session.css_from_du() * Point::new(200.0, 400.0);
    let shown = page.canvas.shown.as_ref().unwrap();
    let along = (-60..60).map(|dx| pixel(shown, middle + Vec2::new(f64::from(dx), 0.0)));
    let blurred = along.filter(|color| ![WHITE, Srgb8([0; 3]), RED].contains(color)).count();
    assert!(blurred <= 4, "two edges of a line, at most two pixels each; {blurred}");
    assert_eq!(page.session.css_from_du().as_coeffs()[0], 8.0);
}

#[test]
fn undo_brings_back_the_drawing_that_another_was_opened_over() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &ACROSS);
    let blank = br#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 9 9"><path d="M1 1h6" stroke="black"/></svg>"#;
    page.session.command(page::open(blank, &[]));
    assert!(page.session.document().scribbles.is_empty());
    page.session.command(Command::Undo);
    page.view(ViewChange::ZoomReset);
    assert_eq!(page.session.document().scribbles.len(), 1);
    assert_eq!(page.color_at((440.0, 200.0)), RED);
    page.session.command(Command::Undo);
    page.session.command(Command::Undo);
    assert!(page.session.document().scribbles.is_empty());
}

#[test]
fn redo_brings_back_an_opening_that_was_undone_until_something_else_is_done() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &ACROSS);
    page.stroke(BLUE, &ACROSS);
    page.session.command(Command::Undo);
    page.session.command(page::open(SQUARE, &[]));
    page.stroke(BLUE, &ACROSS);
    let done = |page: &mut Page, command: Command| {
        page.session.take_effects();
        page.session.command(command);
        let told = page.session.take_effects();
        (told.contains(&Effect::Undone) || told.contains(&Effect::Redone))
            .then(|| page.color_at((440.0, 200.0)))
    };
    let mut colors =
        |commands: &[Command]| commands.iter().map(|c| done(&mut page, c.clone())).collect::<Vec<_>>();
    let back = [Command::Undo, Command::Undo];
    assert_eq!(colors(&back), [Some(PAPER), Some(RED)]);
    assert_eq!(colors(&[Command::Redo, Command::Redo, Command::Redo]), [Some(PAPER), Some(BLUE), None]);
    assert_eq!(colors(&back), [Some(PAPER), Some(RED)]);
    page.pen(Phase::Down, (650.0, 200.0));
    assert_eq!(done(&mut page, Command::Redo), None, "while the pen is down");
    page.session.pointer(Phase::Up, &[]);
    assert!(page.session.take_effects().contains(&Effect::Closed(2)), "the drawing under it is another");
    assert_eq!(done(&mut page, Command::Redo), None);
}

#[test]
fn a_stroke_off_the_page_is_no_scribble() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &[(-40.0, 100.0), (-30.0, 300.0)]);
    assert!(page.session.document().scribbles.is_empty());
    page.session.take_effects();
    page.session.command(Command::Undo);
    assert!(page.session.take_effects().is_empty(), "there is nothing to undo");
}

const BY_ENGINE: Setting = Setting::Engine(EngineKind::Progressive);

fn set(page: &mut Page, setting: Setting) {
    page.session.command(Command::Set(setting));
}

#[test]
fn each_setting_is_a_step_of_undo() {
    let mut page = Page::open(SQUARE);
    page.session.take_effects();
    let start = Settings::default();
    let ways = [
        (Setting::Blend(Blend::Srgb), Settings { blend: Blend::Srgb, ..start }),
        (BY_ENGINE, Settings { engine: EngineKind::Progressive, ..start }),
        (Setting::GapClosing(0.8), Settings { gap_closing: 0.8, ..start }),
        (Setting::Spread(true), Settings { spread: true, ..start }),
    ];
    for (setting, settings) in ways {
        set(&mut page, setting);
        page.session.command(Command::Settle);
        assert_eq!(page.session.document().settings, settings);
        assert!(page.session.take_effects().contains(&Effect::Settings(settings)));
        page.session.command(Command::Undo);
        assert_eq!(page.session.document().settings, start);
    }
}

/// Rooms in a row, with wider and wider doors from one to the next.
const ROOMS: &[u8] = br#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1024 768">
    <path d="M100 200H900V600H100ZM300 200V390M300 410V600M500 200V380M500 420V600M700 200V360M700 440V600"
    fill="none" stroke="black" stroke-width="4"/></svg>"#;

#[test]
fn a_slider_is_followed_while_it_is_dragged_and_is_one_step_of_undo() {
    let mut page = Page::open(ROOMS);
    page.stroke(RED, &[(150.0, 300.0), (200.0, 400.0)]);
    page.stroke(BLUE, &[(850.0, 300.0), (840.0, 400.0)]);
    page.session.frame(&mut page.canvas);
    for percent in [60.0, 20.0, 65.0, 10.0, 71.0] {
        set(&mut page, Setting::GapClosing(percent / 100.0));
        page.session.frame(&mut page.canvas);
        assert!(
            page.canvas.frames.last().is_some_and(|changed| changed.field.is_any()),
            "the picture follows"
        );
    }
    page.session.command(Command::Settle);
    set(&mut page, BY_ENGINE);
    page.session.command(Command::Undo);
    assert_eq!(page.session.document().settings, Settings { gap_closing: 0.71, ..Settings::default() });
    page.session.command(Command::Undo);
    assert_eq!(page.session.document().settings, Settings::default());
    assert_eq!(page.session.document().scribbles.len(), 2);
}

#[test]
fn nothing_is_left_of_a_picture_whose_mesh_and_colours_go_at_once() {
    let mut page = Page::open(ROOMS);
    page.stroke(RED, &[(150.0, 300.0), (200.0, 400.0)]);
    page.session.frame(&mut page.canvas);
    set(&mut page, Setting::GapClosing(0.2));
    page.session.command(Command::Settle);
    page.session.frame(&mut page.canvas);
    assert_eq!(page.color_at((150.0, 500.0)), RED);
    page.session.command(Command::GoTo(0));
    page.session.frame(&mut page.canvas);
    assert_eq!(page.color_at((150.0, 500.0)), PAPER);
}

#[test]
fn a_slider_that_is_not_a_number_or_out_of_range_does_no_harm() {
    let mut page = Page::open(SQUARE);
    for gap_closing in [f64::NAN, f64::INFINITY, -3.0] {
        set(&mut page, Setting::GapClosing(gap_closing));
        assert!((0.0..=1.0).contains(&page.session.document().settings.gap_closing));
    }
}

/// Three scribbles side by side, at x = 300, 400 and 500 du, from y = 300 to 400 du.
fn page_with_three() -> Page {
    let mut page = Page::open(SQUARE);
    for (x, color) in [(300.0, RED), (400.0, BLUE), (500.0, WHITE)] {
        page.stroke(color, &[(x, 300.0), (x, 400.0)]);
    }
    page.session.command(Command::Tool(Tool::Erase));
    page.session.take_effects();
    page
}

fn colors(page: &Page) -> Vec<Paint> {
    page.session.document().scribbles.iter().map(|scribble| scribble.color).collect()
}

#[test]
fn a_click_with_the_eraser_takes_the_scribble_under_it_away() {
    let mut page = page_with_three();
    page.pen(Phase::Down, (402.0, 350.0));
    page.session.pointer(Phase::Up, &[]);
    assert_eq!(colors(&page), [RED, WHITE].map(Paint::Color));
    let told = page.session.take_effects();
    assert!(told.contains(&Effect::ScribblesErased { erased: 1, count: 2 }), "{told:?}");
    page.session.command(Command::Undo);
    assert_eq!(colors(&page), [RED, BLUE, WHITE].map(Paint::Color));
    page.session.command(Command::Redo);
    assert_eq!(colors(&page), [RED, WHITE].map(Paint::Color));
}

#[test]
fn an_eraser_that_is_dragged_takes_all_that_it_crosses_in_one_gesture() {
    let mut page = page_with_three();
    page.pen(Phase::Down, (450.0, 350.0));
    page.pen(Phase::Move, (380.0, 350.0));
    assert_eq!(colors(&page), [RED, WHITE].map(Paint::Color), "while it is dragged");
    page.pen(Phase::Move, (250.0, 350.0));
    page.session.pointer(Phase::Up, &[]);
    assert_eq!(colors(&page), [WHITE].map(Paint::Color));
    page.session.command(Command::Undo);
    assert_eq!(colors(&page), [RED, BLUE, WHITE].map(Paint::Color));
}

#[test]
fn an_eraser_that_touches_nothing_or_is_dropped_leaves_all_as_it_was() {
    let mut page = page_with_three();
    page.pen(Phase::Down, (450.0, 350.0));
    page.pen(Phase::Move, (450.0, 500.0));
    page.session.pointer(Phase::Up, &[]);
    assert_eq!(page.session.take_effects(), [Effect::ScribblesErased { erased: 0, count: 3 }]);
    page.pen(Phase::Down, (300.0, 350.0));
    assert_eq!(colors(&page), [BLUE, WHITE].map(Paint::Color));
    page.session.pointer(Phase::Cancel, &[]);
    assert_eq!(colors(&page), [RED, BLUE, WHITE].map(Paint::Color));
    page.pen(Phase::Move, (400.0, 350.0));
    assert_eq!(colors(&page), [RED, BLUE, WHITE].map(Paint::Color));
}

#[test]
fn a_click_erases_the_uppermost_of_scribbles_that_overlap() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &[(300.0, 350.0), (500.0, 350.0)]);
    page.stroke(BLUE, &[(400.0, 300.0), (400.0, 400.0)]);
    page.session.command(Command::Tool(Tool::Erase));
    page.pen(Phase::Down, (400.0, 350.0));
    page.pen(Phase::Move, (401.0, 351.0));
    page.session.pointer(Phase::Up, &[]);
    assert_eq!(colors(&page), [RED].map(Paint::Color));
}

#[test]
fn the_other_end_of_the_pen_erases_whatever_the_tool_and_a_colour_is_for_scribbling() {
    let mut page = page_with_three();
    page.session.command(Command::Color(BLUE.into()));
    assert!(page.session.take_effects().contains(&Effect::Tool(Tool::Scribble)));
    page.pen(Phase::Erase, (300.0, 350.0));
    page.session.pointer(Phase::Up, &[]);
    assert_eq!(colors(&page), [BLUE, WHITE].map(Paint::Color));
}

#[test]
fn a_scribble_of_no_colour_keeps_its_place_free() {
    let mut page = Page::open(SQUARE);
    page.session.command(Command::Scribbles(false));
    page.stroke(RED, &ACROSS);
    page.session.command(Command::Color(Ink::Paint(Paint::Clear)));
    page.pen(Phase::Down, INSIDE);
    assert_ne!(page.color_at(INSIDE), RED);
    page.session.pointer(Phase::Cancel, &[]);
    assert_eq!(page.color_at(INSIDE), RED);
    page.session.command(Command::SwapColors);
    assert!(page.session.take_effects().contains(&Effect::Color(RED.into())));
}

/// What the page is told about the picture under the lines, and where among the effects, beside where it is told of the
/// sheet.
fn told_of_tracing(page: &mut Page) -> (Option<Tracing>, bool) {
    let effects = page.session.take_effects();
    let place = |is: fn(&Effect) -> bool| effects.iter().position(is);
    let tracing = place(|effect| matches!(effect, Effect::Tracing(_))).expect("news of it");
    let sheet = place(|effect| matches!(effect, Effect::Sheet(_)));
    let Effect::Tracing(TracingState { tracing: told, page: size }) = effects[tracing] else { panic!() };
    assert_eq!((size.width, size.height), (1024.0, 768.0));
    (told, sheet.is_some_and(|sheet| sheet > tracing))
}

#[test]
fn a_picture_under_the_lines_is_told_of_before_the_sheet_that_it_changes() {
    let mut page = Page::open(SQUARE);
    page.session.take_effects();
    page.session.command(Command::Trace(Some(1)));
    assert_eq!(told_of_tracing(&mut page), (Some(Tracing::faded(1)), true));
    for opacity in [0.6, 0.9] {
        page.session.command(Command::TracingOpacity(opacity));
        assert_eq!(told_of_tracing(&mut page), (Some(Tracing { image: 1, opacity }), false), "in hand");
    }
    page.session.command(Command::Settle);
    page.session.command(Command::Trace(Some(2)));
    assert_eq!(
        told_of_tracing(&mut page),
        (Some(Tracing { image: 2, opacity: 0.9 }), true),
        "as the one before"
    );
    page.session.command(Command::Trace(None));
    assert_eq!(told_of_tracing(&mut page), (None, true));
    page.session.command(Command::TracingOpacity(0.1));
    page.session.command(Command::Settle);
    for tracing in [Tracing { image: 2, opacity: 0.9 }, Tracing { image: 1, opacity: 0.9 }, Tracing::faded(1)]
    {
        page.session.command(Command::Undo);
        assert_eq!(told_of_tracing(&mut page), (Some(tracing), true));
        let kept = exact::read(&page.session.work()).expect("work");
        assert_eq!((kept.document.tracing, kept.image.len()), (Some(tracing), 0));
    }
}

#[test]
fn without_paper_the_canvas_is_clear_where_nothing_is_coloured_and_pictures_for_files_are_not() {
    let mut page = Page::open(SQUARE);
    page.stroke(RED, &ACROSS);
    page.session.command(Command::Trace(Some(1)));
    page.session.command(Command::Paper(false));
    let mut alpha_at = |place: (f64, f64)| {
        page.session.frame(&mut page.canvas);
        let shown = page.canvas.shown.as_ref().expect("a painting");
        let Point { x, y } = page.session.css_from_du() * Point::from(place);
        shown.rgba[4 * (y as usize * shown.width_px as usize + x as usize) + 3]
    };
    assert_eq!([OUTSIDE, INSIDE, ON_THE_LINE, (-20.0, 400.0)].map(&mut alpha_at), [0, 255, 255, 255]);
    assert!(page.thumbnail().rgba.iter().skip(3).step_by(4).all(|alpha| *alpha == 255));
    page.session.command(Command::Paper(true));
    assert_eq!(page.color_at(OUTSIDE), WHITE);
}
