//! Gestures are transactions, and undo goes back by whole gestures.

use kurbo::{BezPath, Point, Rect};
use proptest::prelude::*;
use scumble_core::{
    Blend, ColorPoint, Curve, Deed, Document, Drawing, Editor, EngineKind, Paint, Scribble, ScribbleKind,
    Settings, Shading, Srgb8, Swatch, Tracing, Work, exact,
};

fn editor() -> Editor {
    Editor::new(Document::new(Drawing::new(Rect::new(0.0, 0.0, 72.0, 72.0))))
}

fn scribble(shade: u8) -> Scribble {
    Scribble {
        color: Srgb8([shade; 3]).into(),
        kind: ScribbleKind::Fill,
        width_du: 5.0,
        points: vec![Point::ZERO],
    }
}

fn begin(editor: &mut Editor, shade: u8) {
    editor.begin_scribble(scribble(shade));
}

fn curve(width: u8) -> Curve {
    let mut path = BezPath::new();
    path.move_to((0.0, 0.0));
    path.line_to((10.0, 10.0 * f64::from(width)));
    Curve { path, line: None }
}

/// Three curves, with colours set by hand at each.
fn editor_with_lines() -> Editor {
    let mut document = editor().document().clone();
    document.drawing.curves = [1, 2, 3].map(curve).to_vec();
    document.color_points = [2, 0, 1, 2]
        .map(|curve| ColorPoint { curve, is_left: true, at_du: f64::from(curve), color: Paint::Clear })
        .to_vec();
    Editor::new(document)
}

fn deeds_of(editor: &Editor) -> Vec<Deed> {
    editor.history().map(|entry| entry.deed).collect()
}

fn shades(editor: &Editor) -> Vec<u8> {
    editor
        .document()
        .scribbles
        .iter()
        .map(|scribble| match scribble.color {
            Paint::Color(color) => color.0[0],
            Paint::Clear => panic!("a colour"),
        })
        .collect()
}

/// An editor with scribbles of shades 0, 1, 2 and so on.
fn editor_with(count: u8) -> Editor {
    let mut editor = editor();
    for shade in 0..count {
        begin(&mut editor, shade);
    }
    editor.commit();
    editor
}

fn gap(gap_closing: f64) -> Settings {
    Settings { gap_closing, ..Settings::default() }
}

#[test]
fn undo_and_redo_walk_through_whole_gestures() {
    let mut editor = editor();
    for shade in [1, 2] {
        begin(&mut editor, shade);
        editor.draw_scribble(vec![Point::new(1.0, 1.0), Point::new(2.0, 2.0)], ScribbleKind::Fill);
        editor.commit();
    }
    let full = editor.document().scribbles.clone();
    assert!(editor.undo());
    assert_eq!(shades(&editor), [1]);
    assert!(editor.undo());
    assert!(!editor.undo());
    assert!(editor.redo() && editor.redo());
    assert!(!editor.redo());
    assert_eq!(editor.document().scribbles, full);
}

#[test]
fn an_aborted_gesture_never_was() {
    let mut editor = editor();
    begin(&mut editor, 1);
    editor.commit();
    editor.undo();
    begin(&mut editor, 2);
    editor.abort();
    assert!(shades(&editor).is_empty());
    assert!(editor.can_redo() && !editor.can_undo());
}

#[test]
fn a_pen_changes_the_scribble_in_hand_and_no_other() {
    let mut editor = editor();
    let shade = ScribbleKind::Shade(Shading::default());
    begin(&mut editor, 1);
    editor.draw_scribble(vec![Point::ZERO], shade.clone());
    editor.commit();
    editor.draw_scribble(vec![Point::ZERO], ScribbleKind::Fill);
    let of = |editor: &Editor| {
        editor.document().scribbles.iter().map(|scribble| scribble.kind.clone()).collect::<Vec<_>>()
    };
    assert_eq!(of(&editor), std::slice::from_ref(&shade));
    editor.undo();
    editor.redo();
    assert_eq!(of(&editor), std::slice::from_ref(&shade));
}

#[test]
fn a_gesture_in_hand_is_what_undo_takes_first() {
    let mut editor = editor();
    begin(&mut editor, 1);
    editor.commit();
    begin(&mut editor, 2);
    assert!(editor.undo());
    assert_eq!(shades(&editor), [1]);
    assert!(!editor.can_redo());
}

#[test]
fn a_new_gesture_ends_what_could_be_redone() {
    let mut editor = editor();
    begin(&mut editor, 1);
    editor.commit();
    editor.undo();
    editor.set_settings(Settings { blend: Blend::Srgb, ..Settings::default() });
    assert!(!editor.can_redo());
    editor.undo();
    assert_eq!(editor.document().settings, Settings::default());
}

#[test]
fn a_way_that_is_none_leaves_the_scribble_as_it_is() {
    let mut editor = editor();
    begin(&mut editor, 1);
    let end = Point::new(3.0, 3.0);
    for way in [vec![end, Point::new(f64::NAN, 1.0)], vec![Point::new(2.0, f64::INFINITY)], Vec::new()] {
        editor.draw_scribble(way, ScribbleKind::Fill);
        assert_eq!(editor.document().scribbles[0].points, [Point::ZERO]);
    }
    editor.draw_scribble(vec![end], ScribbleKind::Fill);
    editor.commit();
    assert_eq!(editor.document().scribbles[0].points, [end]);
}

#[test]
fn scribbles_are_erased_by_their_indices_and_come_back_to_their_places() {
    let mut editor = editor_with(5);
    assert_eq!(editor.erase_scribbles(&[3, 0, 3, 7]), 2);
    assert_eq!(shades(&editor), [1, 2, 4]);
    editor.undo();
    assert_eq!(shades(&editor), [0, 1, 2, 3, 4]);
    editor.redo();
    assert_eq!(shades(&editor), [1, 2, 4]);
}

#[test]
fn a_scribble_is_recoloured_in_its_place() {
    let mut editor = editor_with(3);
    editor.recolor_scribble(1, Srgb8([9; 3]).into());
    assert_eq!(shades(&editor), [0, 9, 2]);
    editor.undo();
    assert_eq!(shades(&editor), [0, 1, 2]);
}

#[test]
fn a_scribble_moves_to_an_index() {
    let mut editor = editor_with(4);
    editor.move_scribble(0, 2);
    assert_eq!(shades(&editor), [1, 2, 0, 3]);
    editor.move_scribble(3, 0);
    assert_eq!(shades(&editor), [3, 1, 2, 0]);
    editor.undo();
    editor.undo();
    assert_eq!(shades(&editor), [0, 1, 2, 3]);
}

#[test]
fn what_changes_nothing_is_no_gesture() {
    let mut editor = editor_with(2);
    editor.undo();
    editor.erase_scribbles(&[1, usize::MAX]);
    editor.recolor_scribble(1, Srgb8([9; 3]).into());
    editor.recolor_scribble(0, Srgb8([0; 3]).into());
    editor.move_scribble(0, 1);
    editor.move_scribble(1, 0);
    editor.move_scribble(0, 0);
    editor.set_settings(Settings::default());
    editor.begin(Deed::Moved);
    editor.commit();
    assert_eq!(shades(&editor), [0]);
    assert!(editor.can_redo());
}

#[test]
fn a_slider_that_is_dragged_is_one_gesture() {
    let mut editor = editor();
    editor.begin(Deed::Moved);
    for percent in 51..=80 {
        editor.set_settings(gap(f64::from(percent) / 100.0));
    }
    editor.commit();
    assert_eq!(editor.document().settings, gap(0.8));
    assert!(editor.undo());
    assert_eq!(editor.document().settings, gap(0.5));
    assert!(!editor.can_undo());
    assert!(editor.redo());
    assert_eq!(editor.document().settings, gap(0.8));
}

#[test]
fn a_slider_that_comes_back_to_where_it_was_has_done_nothing() {
    let mut editor = editor();
    editor.begin(Deed::Moved);
    assert!(!editor.can_undo());
    editor.set_settings(gap(0.7));
    assert!(editor.can_undo());
    editor.set_settings(gap(0.5));
    assert!(!editor.can_undo());
    editor.commit();
    assert!(!editor.can_undo());
}

#[test]
fn a_gesture_takes_its_changes_back_together() {
    let mut editor = editor_with(4);
    editor.begin(Deed::Moved);
    editor.erase_scribbles(&[1]);
    editor.erase_scribbles(&[0, 1]);
    editor.commit();
    assert_eq!(shades(&editor), [3]);
    editor.undo();
    assert_eq!(shades(&editor), [0, 1, 2, 3]);
    editor.begin(Deed::Moved);
    editor.erase_scribbles(&[2]);
    editor.abort();
    assert_eq!(shades(&editor), [0, 1, 2, 3]);
    assert!(editor.can_redo());
}

#[test]
fn scribbles_keep_their_numbers_wherever_they_come_to_lie() {
    let mut editor = editor_with(3);
    let [a, b, c] = *editor.scribble_ids() else { panic!("three scribbles") };
    editor.move_scribble(0, 2);
    editor.replace_scribble(0, scribble(9));
    assert_eq!(editor.scribble_ids(), [b, c, a]);
    editor.insert_scribble(1, scribble(7));
    assert_eq!(shades(&editor), [9, 7, 2, 0]);
    assert!(![a, b, c].contains(&editor.scribble_ids()[1]));
    editor.erase_scribbles(&[0, 1]);
    assert_eq!(editor.scribble_ids(), [c, a]);
    while editor.undo() {}
    editor.redo();
    assert_eq!(editor.scribble_ids(), [a]);
}

#[test]
fn a_gesture_that_restarts_forgets_what_it_did_and_goes_on() {
    let mut editor = editor_with(2);
    editor.begin(Deed::Moved);
    for shade in [5, 6, 7] {
        editor.restart();
        editor.replace_scribble(0, scribble(shade));
    }
    editor.commit();
    assert_eq!(shades(&editor), [7, 1]);
    editor.undo();
    assert_eq!(shades(&editor), [0, 1]);
    editor.begin(Deed::Moved);
    editor.replace_scribble(0, scribble(5));
    editor.restart();
    editor.commit();
    assert_eq!(shades(&editor), [0, 1]);
    assert!(editor.can_redo(), "nothing was done");
}

#[test]
fn a_curve_that_is_removed_takes_its_colours_with_it() {
    let mut editor = editor_with_lines();
    let revision = editor.lines_revision();
    editor.remove_curve(1);
    let at = |editor: &Editor| {
        editor.document().color_points.iter().map(|p| (p.curve, p.at_du)).collect::<Vec<_>>()
    };
    assert_eq!(at(&editor), [(1, 2.0), (0, 0.0), (1, 2.0)]);
    assert_eq!(editor.document().drawing.curves, [1, 3].map(curve));
    assert!(editor.has_other_lines() && editor.lines_revision() != revision);
    editor.undo();
    assert_eq!(at(&editor), [(2, 2.0), (0, 0.0), (1, 1.0), (2, 2.0)]);
    assert_eq!(editor.document().drawing.curves, [1, 2, 3].map(curve));
    assert!(!editor.has_other_lines());
}

#[test]
fn states_of_the_lines_are_told_apart_and_known_again() {
    let mut editor = editor_with_lines();
    let opened = editor.lines_revision();
    editor.remove_curve(0);
    let fewer = editor.lines_revision();
    editor.insert_scribble(0, scribble(0));
    assert_eq!(editor.lines_revision(), fewer);
    editor.go_to(0);
    assert_eq!(editor.lines_revision(), opened);
    editor.begin(Deed::Moved);
    editor.replace_curve(0, curve(7));
    let moved = editor.lines_revision();
    assert!(![opened, fewer].contains(&moved));
    editor.restart();
    assert_eq!(editor.lines_revision(), opened);
    editor.replace_curve(0, curve(8));
    assert!(![opened, fewer, moved].contains(&editor.lines_revision()));
    editor.abort();
    assert_eq!(editor.lines_revision(), opened);
    editor.redo();
    assert_eq!(editor.lines_revision(), fewer);
}

/// What a person may do, with indices that may be those of no scribble.
#[derive(Clone, Debug)]
enum Act {
    Scribble(u8),
    Erase(Vec<usize>),
    Recolor(usize, u8),
    Move(usize, usize),
    Insert(usize, u8),
    Replace(usize, u8),
    ReplaceCurve(usize, u8),
    RemoveCurve(usize),
    Restart,
    Set(Settings),
    Begin,
    Commit,
    Abort,
    Undo,
    Redo,
}

fn settings() -> impl Strategy<Value = Settings> {
    let engine = prop_oneof![Just(EngineKind::Global), Just(EngineKind::Progressive)];
    let blend = prop_oneof![Just(Blend::Oklab), Just(Blend::Srgb)];
    let gap_closing = prop_oneof![Just(0.25), Just(0.5), Just(2.0), Just(f64::NAN)];
    (blend, engine, gap_closing, any::<bool>()).prop_map(|(blend, engine, gap_closing, spread)| Settings {
        blend,
        engine,
        gap_closing,
        spread,
    })
}

fn act() -> impl Strategy<Value = Act> {
    prop_oneof![
        4 => any::<u8>().prop_map(Act::Scribble),
        2 => prop::collection::vec(0..8_usize, 0..4).prop_map(Act::Erase),
        2 => (0..8_usize, 0..4_u8).prop_map(|(index, shade)| Act::Recolor(index, shade)),
        2 => (0..8_usize, 0..8_usize).prop_map(|(from, to)| Act::Move(from, to)),
        2 => (0..8_usize, 0..4_u8).prop_map(|(index, shade)| Act::Insert(index, shade)),
        2 => (0..8_usize, 0..4_u8).prop_map(|(index, shade)| Act::Replace(index, shade)),
        2 => (0..4_usize, 0..4_u8).prop_map(|(index, width)| Act::ReplaceCurve(index, width)),
        2 => (0..4_usize).prop_map(Act::RemoveCurve),
        1 => Just(Act::Restart),
        2 => settings().prop_map(Act::Set),
        1 => Just(Act::Begin),
        1 => Just(Act::Commit),
        1 => Just(Act::Abort),
        2 => Just(Act::Undo),
        1 => Just(Act::Redo),
    ]
}

fn perform(editor: &mut Editor, act: &Act) {
    match act {
        Act::Scribble(shade) => begin(editor, *shade),
        Act::Erase(indices) => assert!(editor.erase_scribbles(indices) <= indices.len()),
        Act::Recolor(index, shade) => editor.recolor_scribble(*index, Srgb8([*shade; 3]).into()),
        Act::Move(from, to) => editor.move_scribble(*from, *to),
        Act::Insert(index, shade) => editor.insert_scribble(*index, scribble(*shade)),
        Act::Replace(index, shade) => editor.replace_scribble(*index, scribble(*shade)),
        Act::ReplaceCurve(index, width) => editor.replace_curve(*index, curve(*width)),
        Act::RemoveCurve(index) => editor.remove_curve(*index),
        Act::Restart => editor.restart(),
        Act::Set(settings) => editor.set_settings(*settings),
        Act::Begin => editor.begin(Deed::Moved),
        Act::Commit => editor.commit(),
        Act::Abort => editor.abort(),
        Act::Undo => assert_eq!(editor.can_undo(), editor.undo()),
        Act::Redo => assert_eq!(editor.can_redo(), editor.redo()),
    }
}

/// All that a gesture may have changed, and the numbers by which it is known.
type Source = (Vec<Scribble>, Vec<Curve>, Vec<ColorPoint>, Settings, Vec<u32>, Vec<u32>);

fn source(editor: &Editor) -> Source {
    let Document { drawing, scribbles, color_points, settings, .. } = editor.document().clone();
    let ids = [editor.scribble_ids(), editor.curve_ids()].map(<[u32]>::to_vec);
    let [scribble_ids, curve_ids] = ids;
    (scribbles, drawing.curves, color_points, settings, scribble_ids, curve_ids)
}

#[test]
fn undo_comes_back_to_a_revision_and_another_gesture_never_does() {
    let mut editor = editor_with(2);
    let two = editor.revision();
    editor.undo();
    let one = editor.revision();
    editor.undo();
    assert_eq!(editor.revision(), 0);
    editor.redo();
    assert_eq!(editor.revision(), one);
    editor.redo();
    assert_eq!(editor.revision(), two);
    editor.undo();
    begin(&mut editor, 7);
    assert_eq!(editor.revision(), one, "a gesture in hand may be dropped yet");
    editor.commit();
    assert!(![0, one, two].contains(&editor.revision()));
}

proptest! {
    #[test]
    fn undo_goes_back_to_the_start_and_redo_to_the_end(acts in prop::collection::vec(act(), 0..40)) {
        let mut editor = editor_with_lines();
        let start = source(&editor);
        for act in &acts {
            perform(&mut editor, act);
        }
        editor.commit();
        while editor.redo() {}
        let end = source(&editor);
        let mut ways = vec![end.clone()];
        while editor.undo() {
            prop_assert_eq!(editor.scribble_ids().len(), editor.document().scribbles.len());
            prop_assert_eq!(editor.curve_ids().len(), editor.document().drawing.curves.len());
            ways.push(source(&editor));
        }
        prop_assert_eq!(ways.pop(), Some(start));
        prop_assert!(!editor.can_undo());
        prop_assert!(!editor.has_other_lines());
        while editor.redo() {
            if let Some(before) = ways.pop() {
                prop_assert_eq!(source(&editor), before);
            }
        }
        prop_assert_eq!(source(&editor), end);
        prop_assert!(!editor.can_redo());
    }
}

#[test]
fn another_palette_is_a_gesture_of_its_own() {
    let mut editor = editor();
    let swatch = |rgb, name: &str| Swatch { color: Paint::Color(Srgb8(rgb)), name: name.into() };
    let [red, blue] = [swatch([200, 0, 0], ""), swatch([0, 0, 200], "Sea")];
    editor.set_palette(vec![red.clone()]);
    begin(&mut editor, 1);
    editor.set_palette(vec![red.clone(), blue.clone()]);
    assert_eq!((shades(&editor), editor.document().palette.len()), (vec![1], 2));
    assert!(editor.undo());
    assert_eq!((shades(&editor), &editor.document().palette), (vec![1], &vec![red.clone()]));
    assert!(editor.redo());
    assert_eq!(editor.document().palette, [red.clone(), blue.clone()]);
    let revision = editor.revision();
    editor.set_palette(vec![red.clone(), blue.clone()]);
    assert_eq!(editor.revision(), revision, "nothing has changed");
}

#[test]
fn the_history_tells_what_was_done_to_the_palette() {
    let mut editor = editor();
    let swatch = |rgb, name: &str| Swatch { color: Paint::Color(Srgb8(rgb)), name: name.into() };
    let [red, blue] = [swatch([200, 0, 0], ""), swatch([0, 0, 200], "Sea")];
    let sky = Swatch { name: "Sky".into(), ..blue.clone() };
    let green = swatch([0, 200, 0], "");
    for palette in
        [vec![red.clone()], vec![red.clone(), blue.clone()], vec![blue, red.clone()], vec![sky, red.clone()]]
    {
        editor.set_palette(palette);
    }
    editor.set_palette(vec![red]);
    editor.set_palette(vec![green]);
    let deeds = [
        Deed::SwatchAdded,
        Deed::SwatchAdded,
        Deed::SwatchesOrdered,
        Deed::SwatchNamed,
        Deed::SwatchRemoved,
        Deed::Palette,
    ];
    assert_eq!(deeds_of(&editor), deeds);
}

#[test]
fn a_picture_under_the_lines_comes_and_goes_by_gestures() {
    let mut editor = editor();
    let tracing = |editor: &Editor| editor.document().tracing;
    editor.set_tracing(Some(Tracing::faded(1)));
    let faded = Tracing { image: 1, opacity: 0.25 };
    editor.begin(Deed::Moved);
    for opacity in [0.4, 0.3, 0.25] {
        editor.set_tracing(Some(Tracing { opacity, ..faded }));
    }
    editor.commit();
    editor.set_tracing(Some(Tracing::faded(2)));
    editor.set_tracing(None);
    editor.set_tracing(None);
    let ways = [None, Some(Tracing::faded(2)), Some(faded), Some(Tracing::faded(1)), None];
    for (step, way) in ways.iter().enumerate() {
        assert_eq!(tracing(&editor), *way);
        assert_eq!(editor.undo(), step + 1 < ways.len());
    }
    while editor.redo() {}
    assert_eq!((tracing(&editor), editor.revision()), (None, 4));
}

#[test]
fn a_slider_of_one_thing_does_not_swallow_that_of_another() {
    let mut editor = editor();
    editor.begin(Deed::Moved);
    editor.set_settings(gap(0.7));
    editor.set_tracing(Some(Tracing::faded(1)));
    editor.set_settings(gap(0.9));
    editor.set_tracing(None);
    editor.commit();
    assert!(editor.undo());
    assert_eq!((editor.document().settings, editor.document().tracing), (gap(0.5), None));
    assert!(editor.redo());
    assert_eq!((editor.document().settings, editor.document().tracing), (gap(0.9), None));
}

/// Red and blue scribbles and colours set by hand, and a palette of both.
fn painted(red: Srgb8) -> Document {
    let [red, blue] = [red.into(), Srgb8([0, 0, 200]).into()];
    let mut document = Document::new(Drawing::new(Rect::new(0.0, 0.0, 72.0, 72.0)));
    for color in [red, blue, Paint::Clear, red] {
        let kind = ScribbleKind::Shade(Shading::default());
        document.scribbles.push(Scribble { color, kind, width_du: 5.0, points: vec![Point::ZERO] });
        document.color_points.push(ColorPoint { curve: 1, is_left: true, at_du: 2.0, color });
    }
    document.palette = [red, blue].map(Swatch::from).to_vec();
    document
}

/// All of a document that can be edited, to the last bit.
fn exactly(document: &Document) -> Vec<u8> {
    exact::write(&Work::new(document.clone()))
}

/// Another red in the palette, and wherever there was red.
fn repaint(editor: &mut Editor, from: Srgb8, to: Srgb8) {
    editor.set_palette(painted(to).palette);
    editor.repaint(from.into(), to.into());
}

#[test]
fn a_repainted_document_is_as_one_made_with_the_new_colour() {
    let [red, green] = [Srgb8([200, 0, 0]), Srgb8([0, 200, 0])];
    let mut editor = Editor::new(painted(red));
    editor.begin(Deed::Moved);
    repaint(&mut editor, red, green);
    editor.commit();
    assert_eq!(exactly(editor.document()), exactly(&painted(green)));
    assert!(editor.undo());
    assert_eq!(exactly(editor.document()), exactly(&painted(red)));
    assert!(!editor.can_undo(), "one gesture");
    assert!(editor.redo());
    assert_eq!(exactly(editor.document()), exactly(&painted(green)));
}

#[test]
fn a_colour_on_its_way_past_another_does_not_take_it_along() {
    let [red, blue, green] = [Srgb8([200, 0, 0]), Srgb8([0, 0, 200]), Srgb8([0, 200, 0])];
    let mut editor = Editor::new(painted(red));
    editor.begin(Deed::Moved);
    for to in [Srgb8([100, 0, 100]), blue, green] {
        editor.restart();
        repaint(&mut editor, red, to);
    }
    editor.commit();
    assert_eq!(exactly(editor.document()), exactly(&painted(green)));
    editor.begin(Deed::Moved);
    for to in [blue, green] {
        editor.restart();
        repaint(&mut editor, green, to);
    }
    editor.commit();
    assert!(editor.undo());
    assert_eq!(exactly(editor.document()), exactly(&painted(red)), "a way to and fro is no gesture");
}

#[test]
fn repainting_in_the_middle_of_a_scribble_keeps_it() {
    let mut editor = editor();
    begin(&mut editor, 1);
    editor.repaint(Srgb8([1; 3]).into(), Srgb8([2; 3]).into());
    assert_eq!(shades(&editor), [2]);
    assert!(editor.undo());
    assert_eq!(shades(&editor), [1]);
}

#[test]
fn each_gesture_has_a_name_whichever_way_it_was_gone() {
    let mut editor = editor_with(1);
    let shade = Scribble { kind: ScribbleKind::Shade(Shading::default()), ..scribble(1) };
    editor.begin_scribble(shade.clone());
    editor.insert_scribble(0, shade);
    editor.set_settings(gap(0.7));
    editor.set_settings(Settings { engine: EngineKind::Progressive, ..gap(0.7) });
    editor.begin(Deed::Resized);
    editor.replace_scribble(0, scribble(9));
    editor.commit();
    editor.set_tracing(Some(Tracing::faded(1)));
    editor.set_tracing(Some(Tracing { opacity: 0.9, ..Tracing::faded(1) }));
    editor.set_tracing(None);
    let deeds = [
        Deed::Added,
        Deed::Shaded,
        Deed::Shaded,
        Deed::GapClosing,
        Deed::Engine,
        Deed::Resized,
        Deed::Traced,
        Deed::Faded,
        Deed::Untraced,
    ];
    for _ in 0..=deeds.len() {
        assert_eq!(deeds_of(&editor), deeds);
        editor.undo();
    }
    assert_eq!(editor.place(), 0);
    for place in 1..=deeds.len() {
        editor.redo();
        assert_eq!((deeds_of(&editor), editor.place()), (deeds.to_vec(), place));
    }
}

#[test]
fn the_history_has_the_colour_of_what_came_and_went() {
    let mut editor = editor_with(3);
    let [red, blue] = [Srgb8([200, 0, 0]), Srgb8([0, 0, 200])].map(Paint::from);
    let shade = |shade| Some(Srgb8([shade; 3]).into());
    editor.erase_scribbles(&[1]);
    editor.begin(Deed::Recolored);
    (0..2).for_each(|i| editor.recolor_scribble(i, red));
    editor.begin(Deed::Repainted);
    editor.set_palette(vec![Swatch { color: Paint::Clear, name: String::new() }]);
    editor.repaint(red, Paint::Clear);
    editor.commit();
    editor.move_scribble(0, 1);
    editor.recolor_scribble(1, blue);
    editor.erase_scribbles(&[0, 1]);
    let paints = [shade(0), shade(1), shade(2), shade(1), None, Some(Paint::Clear), None, Some(blue), None];
    for place in [9, 0, 4, 9] {
        editor.go_to(place);
        assert_eq!(editor.history().map(|entry| entry.paint).collect::<Vec<_>>(), paints);
    }
}

#[test]
fn one_goes_to_any_place_of_a_long_way_at_once() {
    let mut editor = editor();
    for shade in 0..2000_u32 {
        begin(&mut editor, (shade % 256) as u8);
    }
    editor.commit();
    for place in [0, 1999, 3, 1200] {
        assert!(editor.go_to(place));
        assert_eq!((editor.place(), shades(&editor).len()), (place, place));
        assert_eq!(editor.history().count(), 2000);
    }
    assert!(!editor.go_to(1200));
    assert!(editor.go_to(usize::MAX));
    assert_eq!(editor.place(), 2000);
    editor.go_to(10);
    begin(&mut editor, 7);
    assert!(!editor.go_to(2000), "what is in hand is kept, and ends what could be done again");
    assert_eq!((editor.place(), editor.history().count()), (11, 11));
}
