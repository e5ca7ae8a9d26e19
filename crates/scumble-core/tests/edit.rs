//! Gestures are transactions, and undo goes back by whole gestures.

use kurbo::{Point, Rect};
use scumble_core::{Blend, Document, Drawing, Editor, Paint, Scribble, Srgb8};

fn editor() -> Editor {
    Editor::new(Document::new(Drawing::new(Rect::new(0.0, 0.0, 72.0, 72.0))))
}

fn begin(editor: &mut Editor, shade: u8) {
    editor.begin_scribble(Scribble {
        color: Srgb8([shade; 3]).into(),
        width_du: 5.0,
        points: vec![Point::ZERO],
    });
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

#[test]
fn undo_and_redo_walk_through_whole_gestures() {
    let mut editor = editor();
    for shade in [1, 2] {
        begin(&mut editor, shade);
        editor.extend_scribble(&[Point::new(1.0, 1.0), Point::new(2.0, 2.0)]);
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
    editor.set_blend(Blend::Srgb);
    assert!(!editor.can_redo());
    editor.undo();
    assert_eq!(editor.document().blend, Blend::Oklab);
}

#[test]
fn points_that_are_no_numbers_are_left_out() {
    let mut editor = editor();
    begin(&mut editor, 1);
    editor.extend_scribble(&[
        Point::new(f64::NAN, 1.0),
        Point::new(2.0, f64::INFINITY),
        Point::new(3.0, 3.0),
    ]);
    editor.commit();
    assert_eq!(editor.document().scribbles[0].points, [Point::ZERO, Point::new(3.0, 3.0)]);
}
