//! What is seen from close by.

mod page;

use std::f64::consts::TAU;

use kurbo::{Point, Vec2};
use scumble_core::Srgb8;
use scumble_web::command::{Command, ViewChange};

use page::Page;

const RED: Srgb8 = Srgb8([230, 25, 75]);
const BLUE: Srgb8 = Srgb8([0, 90, 200]);
const WHITE: Srgb8 = Srgb8([255; 3]);

const RADIUS_DU: f64 = 20.0;
const CENTER: Point = Point::new(600.0, 400.0);
const CIRCLE: &[u8] = br#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1024 768">
    <circle cx="600" cy="400" r="20" fill="none" stroke="black" stroke-width="1"/></svg>"#;

/// Where the view is closest: the right end of the circle.
const AT: Vec2 = Vec2::new(RADIUS_DU, 0.0);
const ZOOM: f64 = 64.0;
const PX: f64 = 1.0 / ZOOM;

fn page() -> Page {
    let mut page = Page::open(CIRCLE);
    page.session.command(Command::Lines(false));
    page.session.command(Command::Scribbles(false));
    page
}

fn scribble(page: &mut Page, color: Srgb8) {
    page.stroke(color, &[(595.0, 400.0), (605.0, 400.0)]);
}

/// The colours a pixel and a half within the circle, and as far beyond it, along the part that is in view.
fn colors_at_rim(page: &mut Page) -> [Vec<Srgb8>; 2] {
    let angles = || (-40..40).map(|i| TAU * f64::from(i) / 1000.0);
    [-1.5, 1.5].map(|off_px| {
        let places = angles().map(|angle| CENTER + (RADIUS_DU + off_px * PX) * Vec2::from_angle(angle));
        places.map(|Point { x, y }| page.color_at((x, y))).collect()
    })
}

fn approach(page: &mut Page) {
    page.color_at(CENTER.into());
    let at_css = page.session.css_from_du() * (CENTER + AT);
    page.view(ViewChange::ZoomAt(at_css, ZOOM));
}

#[test]
fn a_circle_is_round() {
    let mut page = page();
    scribble(&mut page, RED);
    approach(&mut page);
    let [within, beyond] = colors_at_rim(&mut page);
    assert!(within.iter().all(|&color| color == RED), "{within:?}");
    assert!(beyond.iter().all(|&color| color == WHITE), "{beyond:?}");
}

/// The canvas compares each frame, of which it paints what has changed, with the whole painted anew.
#[test]
fn it_stays_round_while_it_is_coloured_and_moved_about() {
    let mut page = page();
    scribble(&mut page, RED);
    approach(&mut page);
    page.session.frame(&mut page.canvas);
    for _ in 0..8 {
        page.view(ViewChange::Pan(Vec2::new(0.0, 100.0)));
        page.session.frame(&mut page.canvas);
    }
    page.view(ViewChange::Pan(Vec2::new(0.0, -800.0)));
    scribble(&mut page, BLUE);
    let [within, beyond] = colors_at_rim(&mut page);
    assert!(within.iter().all(|&color| color == BLUE), "{within:?}");
    assert!(beyond.iter().all(|&color| color == WHITE), "{beyond:?}");
    page.session.command(Command::Undo);
    assert!(colors_at_rim(&mut page)[0].iter().all(|&color| color == RED));
    page.view(ViewChange::ZoomReset);
    assert_eq!(page.color_at(CENTER.into()), RED);
}

#[test]
fn what_is_exported_large_is_round() {
    let mut page = page();
    scribble(&mut page, RED);
    let picture = page.session.export(16_384.0, false);
    for (from_center_du, half_width_du) in [(0.0, RADIUS_DU), (12.0, 16.0)] {
        let row = (16.0 * (CENTER.y + from_center_du)) as u32;
        let pixels = picture.rows(row, 1, None).rgba;
        let width_px = pixels.chunks(4).filter(|pixel| pixel[3] > 127).count() as f64;
        assert!((width_px - 32.0 * half_width_du).abs() < 1.5, "{width_px}");
    }
}
