//! Many edits in a row, one on top of the other: the picture is that of the work, whatever led to it.

use kurbo::Vec2;
use scumble_core::{Blend, EngineKind, Srgb8};
use scumble_solve::Field;
use scumble_web::brush::ModeChange;
use scumble_web::command::{Arranging, Command, Phase, Selecting, Setting, Tool};
use scumble_web::painting::{Changed, PAPER, Painter, Painting};

use crate::followed::follow;
use crate::page::Page;

/// Two rooms, one with a gap in its wall and a pillar, a wave across, and an arc of solid ink.
const ROOMS: &[u8] = br#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1024 768">
    <path d="M100 100H500V500H320M280 500H100Z" fill="none" stroke="black" stroke-width="4"/>
    <path d="M520 100H920V500H520Z" fill="none" stroke="black" stroke-opacity="0.5" stroke-width="4"/>
    <circle cx="300" cy="300" r="60" fill="none" stroke="black" stroke-width="3"/>
    <path d="M50 400C300 200 600 650 980 350" fill="none" stroke="black" stroke-width="3"/>
    <path d="M300 600H700V700H300Z" fill="black"/></svg>"#;

const COLORS: [Srgb8; 4] =
    [Srgb8([230, 25, 75]), Srgb8([0, 90, 200]), Srgb8([20, 160, 60]), Srgb8([250, 220, 90])];

/// When there are more, they are deleted.
const MOST_SCRIBBLES: usize = 24;

/// Numbers that look random and are always the same.
struct Dice(u64);

impl Dice {
    fn below(&mut self, count: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % count
    }

    fn one_of<T: Clone>(&mut self, list: &[T]) -> T {
        list[self.below(list.len() as u64) as usize].clone()
    }

    fn is_heads(&mut self) -> bool {
        self.below(2) == 0
    }

    fn place(&mut self) -> (f64, f64) {
        (self.below(1100) as f64 - 30.0, self.below(800) as f64 - 20.0)
    }
}

/// Keeps the field that is shown, without painting it.
#[derive(Default)]
struct Shown(Field);

impl Painter for Shown {
    fn paint(&mut self, painting: &Painting<'_>, changed: Changed) -> bool {
        if changed.field.is_any() {
            follow(&mut self.0, painting.field, &changed.field);
        }
        true
    }
}

fn drag(page: &mut Page, way_du: &[(f64, f64)]) {
    for (i, &place) in way_du.iter().enumerate() {
        page.pen(if i == 0 { Phase::Down } else { Phase::Move }, place);
    }
    page.session.pointer(Phase::Up, &[]);
}

fn arranging(dice: &mut Dice) -> Command {
    let all =
        [Arranging::Forward, Arranging::Backward, Arranging::Duplicate, Arranging::Delete, Arranging::Hide];
    Command::Arrange(dice.one_of(&all))
}

fn setting(dice: &mut Dice) -> Command {
    Command::Set(match dice.below(4) {
        0 => Setting::Blend(dice.one_of(&[Blend::Oklab, Blend::Srgb])),
        1 => Setting::Engine(dice.one_of(&[EngineKind::Global, EngineKind::Progressive])),
        2 => Setting::GapClosing(dice.below(11) as f64 / 10.0),
        _ => Setting::Spread(dice.is_heads()),
    })
}

/// What comes next, in commands: a part of it is for what is selected.
fn command(dice: &mut Dice) -> Command {
    match dice.below(12) {
        0 => Command::Select(Selecting::All),
        1..=3 => Command::Select(Selecting::Next),
        4 => arranging(dice),
        5 => Command::Arrow(Vec2::new(dice.below(3) as f64 - 1.0, 1.0), dice.is_heads()),
        6 => Command::BrushSize(dice.below(200) as f64),
        7 => Command::Mode(ModeChange::OtherKind),
        8 => Command::EraseParts(dice.is_heads()),
        9 => Command::Color(dice.one_of(&COLORS).into()),
        10 => setting(dice),
        _ => Command::Settle,
    }
}

fn something(page: &mut Page, dice: &mut Dice) {
    let way: Vec<_> = (0..1 + dice.below(4)).map(|_| dice.place()).collect();
    match dice.below(10) {
        0..=2 => {
            page.session.command(Command::Tool(Tool::Scribble));
            page.stroke(dice.one_of(&COLORS), &way);
        }
        3 | 4 => {
            let tools = [Tool::Select, Tool::Select, Tool::Erase, Tool::Hand];
            page.session.command(Command::Tool(dice.one_of(&tools)));
            drag(page, &way);
        }
        5 | 6 => page.session.command(if dice.below(3) < 2 { Command::Undo } else { Command::Redo }),
        _ => page.session.command(command(dice)),
    }
    if page.session.document().scribbles.len() > MOST_SCRIBBLES {
        page.session.command(Command::Select(Selecting::All));
        page.session.command(Command::Arrange(Arranging::Delete));
    }
}

/// The field that is shown, once it has come to rest.
fn field(page: &mut Page) -> Field {
    let mut shown = Shown::default();
    page.session.repaint();
    while page.session.make_on() || page.session.frame(&mut shown) {}
    shown.0
}

/// Opens work afresh.
fn opened(work: &[u8]) -> Page {
    let mut page = Page::open(ROOMS);
    page.session.command(Command::Open { work: work.to_vec(), notes: String::new() });
    page
}

#[test]
fn ten_thousand_edits_with_undo_and_redo_leave_the_field_of_a_fresh_solve() {
    let (mut page, mut dice) = (Page::open(ROOMS), Dice(1));
    let (work, blank) = (page.session.work(), field(&mut page));
    let mut shown = Shown::default();
    for round in 0..40 {
        for _ in 0..250 {
            something(&mut page, &mut dice);
            page.session.frame(&mut shown);
        }
        page.session.command(Command::Settle);
        let (after, done) = (page.session.work(), page.session.history().1);
        let is_right = |page: &mut Page| field(page) == field(&mut opened(&after));
        assert!(is_right(&mut page), "round {round}");
        page.session.command(Command::GoTo(0));
        assert!(page.session.work() == work && field(&mut page) == blank, "undone, round {round}");
        page.session.command(Command::GoTo(done));
        assert!(page.session.work() == after && is_right(&mut page), "done again, round {round}");
        page.session.command(Command::GoTo(0));
    }
}

#[test]
fn whatever_is_done_the_painting_is_that_of_the_work() {
    for seed in 2..6 {
        let (mut page, mut dice) = (Page::open(ROOMS), Dice(seed));
        for _ in 0..30 {
            something(&mut page, &mut dice);
            page.session.frame(&mut page.canvas);
        }
        page.session.command(Command::Settle);
        let mut fresh = opened(&page.session.work());
        let [here, there] = [&mut page, &mut fresh]
            .map(|page| page.session.export(512.0, true).rows(0, 384, Some(PAPER)).rgba);
        assert!(here == there, "seed {seed}");
    }
}
