//! The page's module in a browser: what JavaScript sees of it.

use js_sys::{Array, Function, Object, Promise, Reflect, Uint8Array};
use scumble_core::{Document, Work, exact};
use scumble_io::import_svg;
use scumble_solve::Field;
use scumble_web::App;
use scumble_web::screen::CPU;
use wasm_bindgen::{JsCast, JsValue};
use wasm_bindgen_futures::JsFuture;
use wasm_bindgen_test::wasm_bindgen_test;
use web_sys::HtmlCanvasElement;

/// A circle with a spiral arm in it: a closed region, an open curve, and a smooth shade between its sides.
const DRAWING: &[u8] = br#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 256 192">
    <g fill="none" stroke="black" stroke-width="3"><circle cx="128" cy="96" r="80"/>
    <path d="M48 96C80 60 110 60 128 96S170 130 190 96"/></g></svg>"#;

fn canvas() -> HtmlCanvasElement {
    let document = web_sys::window().and_then(|window| window.document()).expect("a page");
    document.create_element("canvas").expect("a canvas").unchecked_into()
}

/// The exact bytes of the drawing.
fn work() -> Vec<u8> {
    let drawing = import_svg(DRAWING).expect("a drawing").drawing;
    exact::write(&Work::new(Document::new(drawing)))
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
    app.command("resize", &numbers(&[800.0, 600.0, 1.0, 0.0, 0.0])).expect("effects");
    app.pointer("down", &[400.0, 300.0, 0.5]).expect("effects");
    assert_eq!(names(&app.pointer("up", &[]).expect("effects")), ["sheet", "scribble-added"]);
    assert!(exact::read(&app.work()).is_some_and(|work| work.document.scribbles.len() == 1));
    app.pointer("down", &[0.0, 0.0, 0.5]).expect("effects");
    assert_eq!(names(&app.pointer("up", &[]).expect("effects")), ["scribble-dropped"], "off the page");
    assert_eq!(names(&app.frame()), Vec::<String>::new());
    let red_and_beyond =
        app.colors("oklch", &[0.627_955, 0.257_683, 29.234, 0.627_955, 0.4, 29.234]).expect("colours");
    assert_eq!(red_and_beyond.iter().map(|packed| packed >> 24).collect::<Vec<_>>(), [0, 1]);
    assert_eq!(red_and_beyond[0], 0xff_0000);
    assert_eq!(app.color_numbers("hsv", 0x00_80_80).expect("numbers"), [180.0, 1.0, 128.0 / 255.0]);
    assert!(app.colors("rgb", &[]).is_err() && app.color_numbers("lab", 0).is_err());
    let palette = |values: [&str; 2]| values.into_iter().map(JsValue::from).collect::<Array>();
    assert_eq!(
        names(&app.command("palette", &palette(["#102030", "Ink"])).expect("effects")),
        ["sheet", "palette"]
    );
    let repaint = object(&[
        ("palette", palette(["#405060", "Ink"]).into()),
        ("from", "#102030".into()),
        ("to", "#405060".into()),
    ]);
    assert_eq!(names(&app.command("repaint", &repaint).expect("effects")), ["palette"]);
    assert_eq!(names(&app.command("settle", &JsValue::NULL).expect("effects")), ["sheet"]);
    assert!(app.command("palette", &palette(["red", "Ink"])).is_err());
    assert!(app.command("no such command", &JsValue::NULL).is_err());
    assert!(app.command("color", &"red".into()).is_err());
    assert!(app.pointer("sideways", &[]).is_err());
}

#[wasm_bindgen_test]
async fn a_picture_for_a_file_is_had_in_strips_with_its_field() {
    let options = object(&[("renderer", CPU.into()), ("desk", "#808080".into()), ("wake", wake().into())]);
    let app = App::create(canvas(), options).await.expect("an app");
    let open = object(&[("work", Uint8Array::from(&work()[..]).into()), ("notes", "".into())]);
    app.command("open", &open).expect("effects");
    let export = app.export(512.0, true);
    assert_eq!((export.width(), export.height()), (512, 384));
    assert_eq!(export.rows(380, 4, false), [255; 4 * 4 * 512]);
    assert_eq!(export.rows(380, 4, true), [0; 4 * 4 * 512]);
    assert!(export.rows(190, 4, true).chunks(4).any(|pixel| pixel == [0, 0, 0, 255]), "lines are there");
    assert!(Field::from_bytes(&export.field()).is_some());
}

#[wasm_bindgen_test]
async fn a_lost_canvas_is_replaced_and_painted_from_the_document() {
    let options = object(&[("renderer", CPU.into()), ("desk", "#808080".into()), ("wake", wake().into())]);
    let app = App::create(canvas(), options).await.expect("an app");
    app.command("resize", &numbers(&[64.0, 48.0, 1.0, 0.0, 0.0])).expect("effects");
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
