//! Large drawings whose settings or lines change: their pictures are made step by step, and can be done without.

use scumble_core::{Document, EngineKind, Srgb8, Work, exact};
use scumble_io::import_svg;
use scumble_solve::Field;
use scumble_web::command::{Command, Phase, Setting, Tool, ViewChange};
use scumble_web::effect::Effect;
use scumble_web::painting::{Changed, Painter, Painting};
use scumble_web::session::Session;

use zigzags::zigzags;

mod zigzags;

/// A painter that keeps the field it is given.
#[derive(Default)]
struct Screen(Field);

impl Painter for Screen {
    fn paint(&mut self, painting: &Painting<'_>, changed: Changed) -> bool {
        if changed.field {
            self.0.clone_from(painting.field);
        }
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
        page.session.command(Command::View(ViewChange::Resize([1200, 900], 1.0)));
        page.session.command(Command::Open { work, notes: String::new() });
        page.session.command(Command::View(ViewChange::ZoomReset));
        page.rest();
        page
    }

    fn pen(&mut self, phase: Phase, point_du: (f64, f64)) {
        let point = self.session.css_from_du() * kurbo::Point::from(point_du);
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

    fn frame(&mut self) -> bool {
        self.session.frame(&mut self.screen)
    }

    /// Frames until there is nothing more to show; how many.
    fn rest(&mut self) -> usize {
        (1..100).find(|_| !self.frame()).expect("it comes to rest")
    }

    /// Whether the page was told last that a picture is on its way, if it was told anything of that.
    fn told(&mut self) -> Option<bool> {
        let told = |effect| if let Effect::Making(making) = effect { Some(making) } else { None };
        self.session.take_effects().into_iter().filter_map(told).next_back()
    }

    fn set_spread(&mut self, spread: bool) {
        self.session.command(Command::Set(Setting::Spread(spread)));
    }

    /// The picture shown is that of the work when it is opened anew.
    fn assert_right(&mut self) {
        let fresh = Self::of(self.session.work());
        assert!(self.screen.0 == fresh.screen.0);
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
        let before = page.screen.0.clone();
        assert!(page.frame() && page.frame());
        assert_eq!(page.told(), Some(true));
        assert!(page.screen.0 == before);
        page.session.command(Command::Color(Srgb8([1, 90, 200]).into()));
        page.stroke([(x, 97.0), (x + 100.0, 97.0)]);
        page.frame();
        assert!(page.screen.0 != before, "what is scribbled close to lines shows at once");
        assert!(page.rest() < 6);
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
    let before = page.screen.0.clone();
    page.told();
    assert!(page.frame());
    page.stroke([(100.0, 500.0), (900.0, 500.0)]);
    assert!(page.frame());
    assert_eq!(page.told(), Some(true));
    assert!(page.screen.0 == before);
    page.rest();
    assert_eq!(page.told(), Some(false));
    page.assert_right();
}

#[test]
fn what_asked_for_a_picture_is_taken_back_and_the_one_before_is_still_there() {
    for change in [Page::move_line as fn(&mut Page), |page| page.set_spread(true)] {
        let mut page = Page::open();
        let (work, picture) = (page.session.work(), page.screen.0.clone());
        change(&mut page);
        assert!(page.frame() && page.frame());
        page.told();
        page.session.command(Command::StopMaking);
        let effects = page.session.take_effects();
        assert!(effects.contains(&Effect::Making(false)) && effects.contains(&Effect::MakingStopped));
        assert_eq!(page.rest(), 1, "nothing is made anew");
        assert!(page.session.work() == work && page.screen.0 == picture);
        page.session.command(Command::Redo);
        page.rest();
        assert!(page.screen.0 != picture);
        page.assert_right();
    }
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
    let picture = page.screen.0.clone();
    let other = Page::open().session.work();
    page.session.command(Command::Open { work: other, notes: String::new() });
    page.set_spread(true);
    assert!(page.frame() && page.frame());
    page.session.command(Command::Undo);
    page.session.command(Command::Undo);
    page.rest();
    assert!(page.screen.0 == picture);
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
    assert!(page.screen.0 == exported);
    page.assert_right();
}
