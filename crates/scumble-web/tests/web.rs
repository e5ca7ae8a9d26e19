//! The page's module in a browser: what JavaScript sees of it, and that each renderer paints the same picture.
#![cfg(target_arch = "wasm32")]

use js_sys::{Array, Function, Object, Promise, Reflect, Uint8Array};
use kurbo::Point;
use scumble_core::{Document, Srgb8, Work, exact};
use scumble_io::import_svg;
use scumble_solve::Pixmap;
use scumble_web::App;
use scumble_web::command::{Command, Phase, ViewChange};
use scumble_web::screen::{CPU, GPU, Screen};
use scumble_web::session::Session;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use wasm_bindgen_test::{wasm_bindgen_test, wasm_bindgen_test_configure};
use web_sys::HtmlCanvasElement;

wasm_bindgen_test_configure!(run_in_browser);

/// A circle with a spiral arm in it: a closed region, an open curve, and a smooth shade between its sides.
const DRAWING: &[u8] = br#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 192">
    <g fill="none" stroke="black" stroke-width="3"><circle cx="128" cy="96" r="80"/>
    <path d="M48 96C80 60 110 60 128 96S170 130 190 96"/></g></svg>"#;

/// Neighbouring pixels that differ by more than this lie at an edge.
const EDGE_LEVELS: u8 = 8;

fn canvas() -> HtmlCanvasElement {
    let document = web_sys::window().and_then(|window| window.document()).expect("a page");
    document.create_element("canvas").expect("a canvas").unchecked_into()
}

/// The exact bytes of the drawing.
fn work() -> Vec<u8> {
    let drawing = import_svg(DRAWING).expect("a drawing").drawing;
    exact::write(&Work::new(Document::new(drawing)))
}

fn scribbled() -> Session {
    let mut session = Session::new(Srgb8([90; 3])).expect("a blank page");
    session.command(Command::View(ViewChange::Resize([640, 480], 1.0)));
    session.command(Command::Open { work: work(), notes: String::new() });
    for (color, from, to) in [
        (Srgb8([230, 25, 75]), (400.0, 200.0), (600.0, 220.0)),
        (Srgb8([0, 130, 200]), (400.0, 560.0), (600.0, 540.0)),
    ] {
        session.command(Command::Color(color.into()));
        session.pointer(Phase::Down, &sample(&session, from));
        session.pointer(Phase::Up, &sample(&session, to));
    }
    session
}

fn sample(session: &Session, place_du: (f64, f64)) -> [f32; 3] {
    let Point { x, y } = session.css_from_du() * Point::from(place_du);
    [x as f32, y as f32, 0.5]
}

async fn picture(session: &mut Session, renderer: &str) -> Pixmap {
    let lost = |error| wasm_bindgen_test::console_log!("{error}");
    let mut screen = Screen::open(canvas(), renderer, lost).await.expect("a screen");
    session.frame(&mut screen);
    let export = session.export();
    screen.picture(&export.painting()).await.expect("a picture")
}

#[wasm_bindgen_test]
async fn gpu_and_cpu_paint_the_same_picture() {
    let mut session = scribbled();
    let of_gpu = picture(&mut session, GPU).await;
    let of_cpu = picture(&mut session, CPU).await;
    assert_eq!((of_gpu.width_px, of_gpu.height_px), (1024, 768));
    let inner: Vec<_> = inner_pixels(&of_cpu).collect();
    assert!(inner.len() > 700_000, "most pixels are inner ones: {}", inner.len());
    for i in inner {
        let (a, b) = (&of_gpu.rgba[i..i + 4], &of_cpu.rgba[i..i + 4]);
        assert!(difference(a, b) <= 2, "{a:?} on the GPU, {b:?} on the CPU at byte {i}");
    }
    assert!(of_cpu.rgba.chunks(4).any(|p| p[0] > 60 && p[2] > 60 && p[1] < 160), "some of it is shaded");
}

/// Where in `rgba` the pixels start that differ little from their eight neighbours.
fn inner_pixels(picture: &Pixmap) -> impl Iterator<Item = usize> {
    let row = 4 * picture.width_px as usize;
    let at = |i: usize| &picture.rgba[i..i + 4];
    let around = [row + 4, row, row - 4, 4];
    let is_inner = move |i: &usize| {
        around
            .iter()
            .all(|step| difference(at(*i), at(i - step)).max(difference(at(*i), at(i + step))) <= EDGE_LEVELS)
    };
    (row + 4..picture.rgba.len() - row - 4).step_by(4).filter(is_inner)
}

fn difference(a: &[u8], b: &[u8]) -> u8 {
    a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max().unwrap_or_default()
}

#[wasm_bindgen_test]
async fn javascript_sees_effects_by_name_and_errors_for_what_does_not_exist() {
    let options = object(&[("renderer", CPU.into()), ("desk", "#808080".into()), ("wake", wake().into())]);
    let app = App::create(canvas(), options).await.expect("an app");
    let open = object(&[("work", Uint8Array::from(&work()[..]).into()), ("notes", "".into())]);
    let effects = names(&app.command("open", &open).expect("effects"));
    for name in [
        "sheet",
        "palette",
        "undo",
        "redo",
        "zoom",
        "view",
        "color",
        "brush-size",
        "lines",
        "scribbles",
        "settings",
        "tool",
        "opened",
    ] {
        assert!(effects.contains(&name.to_owned()), "{name} is missing in {effects:?}");
    }
    app.command("resize", &numbers(&[800.0, 600.0, 1.0])).expect("effects");
    app.pointer("down", &[400.0, 300.0, 0.5]).expect("effects");
    assert_eq!(names(&app.pointer("up", &[]).expect("effects")), ["sheet", "scribble-added"]);
    assert!(exact::read(&app.work()).is_some_and(|work| work.document.scribbles.len() == 1));
    app.pointer("down", &[0.0, 0.0, 0.5]).expect("effects");
    assert_eq!(names(&app.pointer("up", &[]).expect("effects")), ["scribble-dropped"], "off the page");
    assert_eq!(names(&app.frame()), Vec::<String>::new());
    assert!(app.command("no such command", &JsValue::NULL).is_err());
    assert!(app.command("color", &"red".into()).is_err());
    assert!(app.pointer("sideways", &[]).is_err());
}

#[wasm_bindgen_test]
async fn a_lost_canvas_is_replaced_and_painted_from_the_document() {
    let options = object(&[("renderer", CPU.into()), ("desk", "#808080".into()), ("wake", wake().into())]);
    let app = App::create(canvas(), options).await.expect("an app");
    app.command("resize", &numbers(&[64.0, 48.0, 1.0])).expect("effects");
    app.frame();
    assert!(names(&app.command("lost", &JsValue::NULL).expect("effects")).contains(&"lost".to_owned()));
    let fresh = canvas();
    let next = object(&[("canvas", fresh.clone().into()), ("renderer", CPU.into())]);
    app.command("canvas", &next).expect("effects");
    JsFuture::from(Promise::resolve(&JsValue::NULL)).await.expect("a turn of the event loop");
    assert_eq!(names(&app.frame()), ["renderer"]);
    assert_eq!((fresh.width(), fresh.height()), (64, 48));
}

fn numbers(values: &[f64]) -> JsValue {
    values.iter().copied().map(JsValue::from).collect::<Array>().into()
}

#[wasm_bindgen_test]
async fn a_start_without_its_options_is_an_error() {
    assert!(App::create(canvas(), JsValue::UNDEFINED).await.is_err());
    let options = object(&[("renderer", CPU.into()), ("desk", "grey".into()), ("wake", wake().into())]);
    assert!(App::create(canvas(), options).await.is_err());
}

fn wake() -> Function {
    Function::new_no_args("")
}

fn object(fields: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (name, value) in fields {
        Reflect::set(&object, &(*name).into(), value).expect("a plain object takes any field");
    }
    object.into()
}

fn names(effects: &Array) -> Vec<String> {
    effects.iter().step_by(2).filter_map(|name| name.as_string()).collect()
}
