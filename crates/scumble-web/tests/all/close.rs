//! The picture from close by: curves are round, whatever is done to it.

use crate::page::{Page, pixel};
use kurbo::{Point, Shape, Vec2};
use scumble_core::Srgb8;
use scumble_web::command::{Command, Phase, Selecting, Tool, ViewChange};
use scumble_web::painting::PAPER;

/// A circle of 20 du, which pieces of 6 du follow within a tenth.
const CIRCLE: &[u8] = br#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1024 768">
    <circle cx="512" cy="384" r="20" fill="none" stroke="black" stroke-width="1"/></svg>"#;
const CENTER: Point = Point::new(512.0, 384.0);
const RADIUS_DU: f64 = 20.0;
const ZOOM: f64 = 64.0;

const RED: Srgb8 = Srgb8([255, 0, 0]);
const BLUE: Srgb8 = Srgb8([0, 0, 255]);

/// Past the edge of the circle, which cubics follow within 0.4 px, and a pixel that it touches.
const BESIDE_PX: f64 = 2.0;

fn scribbled() -> Page {
    let mut page = Page::open(CIRCLE);
    page.stroke(RED, &[(505.0, 380.0), (519.0, 388.0)]);
    page.session.command(Command::Lines(false));
    page.session.command(Command::Scribbles(false));
    page
}

fn on_circle(angle: f64) -> Point {
    CENTER + RADIUS_DU * Vec2::from_angle(angle)
}

/// Looks at a place from as close by as one can.
fn look_at(page: &mut Page, place: Point) {
    let place_css = page.session.css_from_du() * place;
    page.view(ViewChange::ZoomAt(place_css, ZOOM));
    let place_css = page.session.css_from_du() * place;
    page.view(ViewChange::Pan(Vec2::new(600.0, 450.0) - place_css.to_vec2()));
    page.session.frame(&mut page.canvas);
}

/// Along the arc that is in view, one colour lies within the circle and paper around it.
fn assert_round(page: &mut Page, [center, place]: [Point; 2], color: Srgb8) {
    let angle = (place - center).atan2();
    for step in -40..=40 {
        let way = Vec2::from_angle(angle + 0.003 * f64::from(step));
        for (off_px, expected) in [(-BESIDE_PX, color), (BESIDE_PX, PAPER)] {
            let beside = center + (RADIUS_DU + off_px / ZOOM) * way;
            assert_eq!(page.color_at(beside.into()), expected, "at {angle} and {step}, {off_px} px off");
        }
    }
}

#[test]
fn a_circle_is_round_wherever_it_is_seen_and_in_each_colour() {
    let mut page = scribbled();
    for angle in [0.3, 1.1, 2.0, 4.4] {
        look_at(&mut page, on_circle(angle));
        assert_round(&mut page, [CENTER, on_circle(angle)], RED);
    }
    let place = on_circle(4.4);
    page.session.command(Command::Repaint { palette: Vec::new(), from: RED.into(), to: BLUE.into() });
    page.session.command(Command::Settle);
    assert_round(&mut page, [CENTER, place], BLUE);
    page.session.command(Command::Undo);
    assert_round(&mut page, [CENTER, place], RED);
}

#[test]
fn a_circle_that_is_moved_is_round_where_it_is_then() {
    let mut page = scribbled();
    let place = on_circle(1.1);
    look_at(&mut page, place);
    page.session.command(Command::Lines(true));
    page.session.command(Command::Tool(Tool::Select));
    page.pen(Phase::Down, place.into());
    page.session.pointer(Phase::Up, &[]);
    page.pen(Phase::Down, place.into());
    for part in [0.25, 0.5, 1.0] {
        page.pen(Phase::Move, (place + part * Vec2::new(0.4, -0.3)).into());
        page.session.frame(&mut page.canvas);
    }
    page.session.pointer(Phase::Up, &[]);
    page.session.command(Command::Lines(false));
    page.session.command(Command::Select(Selecting::None));
    let moved = page.session.document().drawing.curves[0].path.bounding_box().center();
    assert!((moved - CENTER).hypot() > 0.3);
    assert_round(&mut page, [moved, place], RED);
    page.session.command(Command::Undo);
    assert_round(&mut page, [CENTER, place], RED);
}

#[test]
fn a_large_picture_for_a_file_is_as_round() {
    let mut page = scribbled();
    let picture = page.session.export(16_384.0, false);
    let scale = 16.0;
    let first = ((CENTER.y - RADIUS_DU - 1.0) * scale) as u32;
    let rows = picture.rows(first, (2.0 * (RADIUS_DU + 1.0) * scale) as u32, Some(PAPER));
    for step in 0..2000 {
        let way = Vec2::from_angle(0.1 + 0.003 * f64::from(step));
        for (off_px, expected) in [(-BESIDE_PX, RED), (BESIDE_PX, PAPER)] {
            let place_px = scale * (CENTER.to_vec2() + (RADIUS_DU + off_px / scale) * way);
            let found = pixel(&rows, (place_px - Vec2::new(0.0, f64::from(first))).to_point());
            assert_eq!(found, expected, "at {step}, {off_px} px off");
        }
    }
}
