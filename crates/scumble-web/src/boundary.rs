//! Commands and effects as JavaScript values.
//!
//! Effects go out as a flat list, name and value in turn; `web/main.js` has a handler for each name.

use js_sys::{Array, Float64Array, Object, Reflect, Uint8Array};
use kurbo::{Point, Rect, Vec2};
use scumble_core::{Entry, Paint, Settings, Srgb8, Swatch};
use wasm_bindgen::{JsCast, JsValue};

use crate::brush::{Ink, Mode, ModeChange};
use crate::command::{Arranging, Command, Selecting, Setting, ViewChange};
use crate::effect::{Effect, SelectionState, SheetState, TracingState};
use crate::solver::SolverState;
use crate::view::Turn;

mod names;

pub(crate) use names::color_model_from_name;
use names::{
    blend_from_name, blend_name, deed_key, edit_name, engine_from_name, engine_name, erasing_name,
    ink_from_name, kind_from_name, kind_name, pressure_from_name, pressure_name, solver_from_name,
    solver_name, source_name, tone_name, tool_from_name, tool_name, wanted_name,
};

/// The command of a name, or `None` where there is none of it that takes these arguments.
pub(crate) fn command_from_js(name: &str, args: &JsValue) -> Option<Command> {
    Some(match name {
        "open" => Command::Open {
            work: field(args, "work").dyn_into::<Uint8Array>().ok()?.to_vec(),
            notes: field(args, "notes").as_string()?,
        },
        "stop-preparing" => Command::StopPreparing,
        "stop-making" => Command::StopMaking,
        "tool" => Command::Tool(tool_from_name(&args.as_string()?)?),
        "color" => Command::Color(ink_from_name(&args.as_string()?)?),
        "color-sought" => Command::ColorSought(ink_from_name(&args.as_string()?)?),
        "tune-color" => Command::TuneColor(paint(args)?),
        "brush-color" => Command::BrushColor(paint(args)?),
        "swap-colors" => Command::SwapColors,
        "kind" => Command::Mode(ModeChange::Kind(kind_from_name(&args.as_string()?)?)),
        "other-kind" => Command::Mode(ModeChange::OtherKind),
        "strength" => Command::Mode(ModeChange::Strength(args.as_f64()?)),
        "crosses" => Command::Mode(ModeChange::Crosses(args.as_bool()?)),
        "pressure" => Command::Mode(ModeChange::Pressure(pressure_from_name(&args.as_string()?)?)),
        "brush-size" => Command::BrushSize(args.as_f64()?),
        "brush-larger" => Command::BrushLarger,
        "brush-smaller" => Command::BrushSmaller,
        "select-all" => Command::Select(Selecting::All),
        "select-none" => Command::Select(Selecting::None),
        "select-next" => Command::Select(Selecting::Next),
        "select-previous" => Command::Select(Selecting::Previous),
        "forward" => Command::Arrange(Arranging::Forward),
        "backward" => Command::Arrange(Arranging::Backward),
        "duplicate" => Command::Arrange(Arranging::Duplicate),
        "delete-selected" => Command::Arrange(Arranging::Delete),
        "hide" => Command::Arrange(Arranging::Hide),
        "arrow" => {
            let [x, y, far] = numbers(args)?;
            Command::Arrow(Vec2::new(x, y), far > 0.0)
        }
        "finger" => Command::Finger(args.as_bool()?),
        "erasing" => Command::EraseParts(args.as_string()? == erasing_name(true)),
        "other-erasing" => Command::OtherErasing,
        "undo" => Command::Undo,
        "redo" => Command::Redo,
        "go-to" => Command::GoTo(args.as_f64()? as usize),
        "blend" => Command::Set(Setting::Blend(blend_from_name(&args.as_string()?)?)),
        "engine" => Command::Set(Setting::Engine(engine_from_name(&args.as_string()?)?)),
        "gap-closing" => Command::Set(Setting::GapClosing(args.as_f64()?)),
        "spread" => Command::Set(Setting::Spread(args.as_bool()?)),
        "palette" => Command::Palette(palette(args)?),
        "repaint" => Command::Repaint {
            palette: palette(&field(args, "palette"))?,
            from: paint(&field(args, "from"))?,
            to: paint(&field(args, "to"))?,
        },
        "trace" => Command::Trace(args.as_f64().map(|image| image as u32)),
        "tracing-opacity" => Command::TracingOpacity(args.as_f64()?),
        "settle" => Command::Settle,
        "solver" => Command::Solver(solver_from_name(&args.as_string()?)?),
        "lines" => Command::Lines(args.as_bool()?),
        "scribbles" => Command::Scribbles(args.as_bool()?),
        "paper" => Command::Paper(args.as_bool()?),
        "result" => Command::Result(args.as_bool()?),
        "regions" => Command::Regions(args.as_bool()?),
        "before" => Command::Before(args.as_bool()?),
        "desk" => Command::Desk(color(args)?),
        _ => Command::View(view_change(name, args)?),
    })
}

fn view_change(name: &str, args: &JsValue) -> Option<ViewChange> {
    Some(match name {
        "zoom-in" => ViewChange::ZoomIn,
        "zoom-out" => ViewChange::ZoomOut,
        "zoom-reset" => ViewChange::ZoomReset,
        "fit" => ViewChange::Fit,
        "pan" => {
            let [x, y] = numbers(args)?;
            ViewChange::Pan(Vec2::new(x, y))
        }
        "zoom-at" => {
            let [x, y, factor] = numbers(args)?;
            ViewChange::ZoomAt(Point::new(x, y), factor)
        }
        "rotate-at" => {
            let [x, y, degrees] = numbers(args)?;
            ViewChange::RotateAt(Point::new(x, y), degrees)
        }
        "rotate-left" => ViewChange::RotateStep { is_clockwise: false },
        "rotate-right" => ViewChange::RotateStep { is_clockwise: true },
        "rotate-reset" => ViewChange::RotateReset,
        "mirror" => ViewChange::Mirror,
        "resize" => {
            let [width_px, height_px, px_per_css, left_css, top_css] = numbers(args)?;
            let corner_css = Point::new(left_css, top_css);
            ViewChange::Resize { size_px: [width_px as u32, height_px as u32], px_per_css, corner_css }
        }
        _ => return None,
    })
}

/// A field of an object; `undefined` where there is none.
pub(crate) fn field(object: &JsValue, name: &str) -> JsValue {
    Reflect::get(object, &name.into()).unwrap_or_default()
}

/// A colour written as #rrggbb.
pub(crate) fn color(value: &JsValue) -> Option<Srgb8> {
    value.as_string()?.parse().ok()
}

/// A colour written as #rrggbb, or none.
fn paint(value: &JsValue) -> Option<Paint> {
    value.as_string()?.parse().ok()
}

/// A list of swatches: the colour and the name of each, in turn.
fn palette(value: &JsValue) -> Option<Vec<Swatch>> {
    let list = value.dyn_ref::<Array>()?;
    let swatch = |i| Some(Swatch { color: paint(&list.get(i))?, name: list.get(i + 1).as_string()? });
    (0..list.length()).step_by(2).map(swatch).collect()
}

fn numbers<const N: usize>(value: &JsValue) -> Option<[f64; N]> {
    let array = value.dyn_ref::<Array>()?;
    let mut numbers = [0.0; N];
    for (number, i) in numbers.iter_mut().zip(0..) {
        *number = array.get(i).as_f64()?;
    }
    Some(numbers)
}

/// Name and value of each effect, in turn.
pub(crate) fn js_from_effects(effects: Vec<Effect>) -> Array {
    let list = Array::new();
    for effect in effects {
        let (name, value) = js_from_effect(effect);
        list.push(&name.into());
        list.push(&value);
    }
    list
}

fn js_from_effect(effect: Effect) -> (&'static str, JsValue) {
    match effect {
        Effect::Sheet(SheetState { sheet, revision }) => {
            ("sheet", object(&[("sheet", sheet.into()), ("revision", revision.into())]))
        }
        Effect::Closed(sheet) => ("closed", sheet.into()),
        Effect::Undo(possible) => ("undo", possible.into()),
        Effect::Redo(possible) => ("redo", possible.into()),
        Effect::Zoom(zoom) => ("zoom", zoom.into()),
        Effect::View(css_from_du) => ("view", Float64Array::from(&css_from_du.as_coeffs()[..]).into()),
        Effect::Turn(turn) => ("turn", js_from_turn(turn)),
        Effect::Turned(turn) => ("turned", js_from_turn(turn)),
        Effect::Tool(tool) => ("tool", tool_name(tool).into()),
        Effect::Mode(mode) => ("mode", js_from_mode(mode)),
        Effect::Color(Ink::Paint(color)) => ("color", color.to_string().into()),
        Effect::Color(Ink::Tone(tone)) => ("color", tone_name(tone).into()),
        Effect::BrushSize(size_du) => ("brush-size", size_du.into()),
        Effect::Selection(state) => ("selection", js_from_selection(state)),
        Effect::EraseParts(parts) => ("erasing", erasing_name(parts).into()),
        Effect::Lines(shown) => ("lines", shown.into()),
        Effect::Scribbles(shown) => ("scribbles", shown.into()),
        Effect::Tracing(state) => ("tracing", js_from_tracing(state)),
        Effect::Result(shown) => ("result", shown.into()),
        Effect::Regions(shown) => ("regions", shown.into()),
        Effect::Settings(settings) => ("settings", js_from_settings(settings)),
        Effect::Solver(SolverState { asked, source }) => (
            "solver",
            object(&[("asked", solver_name(asked).into()), ("source", source_name(source).into())]),
        ),
        Effect::Opened { notes } => ("opened", object(&[("notes", notes.into())])),
        Effect::Palette(palette) => ("palette", js_from_palette(palette).into()),
        Effect::ScribbleAdded { count, is_fill } => {
            ("scribble-added", object(&[("count", (count as f64).into()), ("isFill", is_fill.into())]))
        }
        Effect::ScribblesErased { erased, count } => (
            "scribbles-erased",
            object(&[("erased", (erased as f64).into()), ("count", (count as f64).into())]),
        ),
        Effect::EraserTurned { parts } => ("eraser-turned", object(&[("parts", parts.into())])),
        Effect::ScribblesRubbed { count } => {
            ("scribbles-rubbed", object(&[("count", (count as f64).into())]))
        }
        Effect::Selected { scribbles, lines, place, total } => (
            "selected",
            object(&[
                ("scribbles", (scribbles as f64).into()),
                ("lines", (lines as f64).into()),
                ("place", (place as f64).into()),
                ("total", (total as f64).into()),
            ]),
        ),
        Effect::Edited { edit, scribbles, lines } => (
            "edited",
            object(&[
                ("edit", edit_name(edit).into()),
                ("scribbles", (scribbles as f64).into()),
                ("lines", (lines as f64).into()),
            ]),
        ),
        Effect::Picked(color) => ("picked", object(&[("color", color.to_string().into())])),
        Effect::ScribbleDropped => ("scribble-dropped", object(&[])),
        Effect::Making(wanted) => ("making", wanted_name(wanted).into()),
        Effect::MakingStopped => ("making-stopped", object(&[])),
        Effect::Undone => ("undone", object(&[])),
        Effect::Redone => ("redone", object(&[])),
        Effect::Failed(sentence) => ("failed", object(&[("sentence", sentence.into())])),
        Effect::Unopened(sheet, sentence) => {
            ("unopened", object(&[("sheet", sheet.into()), ("sentence", sentence.into())]))
        }
        Effect::Renderer(name) => ("renderer", name.into()),
        Effect::Lost(next) => ("lost", next.map_or(JsValue::NULL, JsValue::from)),
    }
}

fn js_from_turn(turn: Turn) -> JsValue {
    object(&[("degrees", turn.degrees.into()), ("mirrored", turn.is_mirrored.into())])
}

/// What gestures did, as keys of the page's messages, and their colours, in turn, and how many gestures are not taken back.
pub(crate) fn js_from_history((entries, place): (Vec<Entry>, usize)) -> JsValue {
    let steps = Array::new();
    for Entry { deed, paint } in entries {
        steps.push(&deed_key(deed).into());
        steps.push(&paint.map_or_else(String::new, |paint| paint.to_string()).into());
    }
    object(&[("steps", steps.into()), ("place", (place as f64).into())])
}

fn js_from_palette(palette: Vec<Swatch>) -> Array {
    let list = Array::new();
    for swatch in palette {
        list.push(&swatch.color.to_string().into());
        list.push(&swatch.name.into());
    }
    list
}

fn js_from_mode(mode: Mode) -> JsValue {
    object(&[
        ("kind", kind_name(mode.kind).into()),
        ("strength", mode.strength.into()),
        ("crosses", mode.crosses.into()),
        ("pressure", pressure_name(mode.pressure).into()),
        ("largest", mode.sizes_du()[1].into()),
    ])
}

fn js_from_selection(state: SelectionState) -> JsValue {
    object(&[
        ("scribbles", (state.scribbles as f64).into()),
        ("lines", (state.lines as f64).into()),
        ("hidden", state.are_hidden.into()),
        ("frame", js_from_rect(state.frame_css)),
        ("handles", (state.handles as f64).into()),
        ("marquee", js_from_rect(state.marquee_css)),
    ])
}

/// Left, top, width, height; `undefined` where there is none.
fn js_from_rect(rect: Option<Rect>) -> JsValue {
    rect.map_or(JsValue::UNDEFINED, |rect| {
        Float64Array::from(&[rect.x0, rect.y0, rect.width(), rect.height()][..]).into()
    })
}

fn js_from_tracing(TracingState { tracing, page }: TracingState) -> JsValue {
    object(&[
        ("image", tracing.map(|tracing| tracing.image).into()),
        ("opacity", tracing.map(|tracing| tracing.opacity).into()),
        ("width", page.width.into()),
        ("height", page.height.into()),
    ])
}

fn js_from_settings(settings: Settings) -> JsValue {
    object(&[
        ("blend", blend_name(settings.blend).into()),
        ("engine", engine_name(settings.engine).into()),
        ("gapClosing", settings.gap_closing.into()),
        ("spread", settings.spread.into()),
    ])
}

fn object(fields: &[(&str, JsValue)]) -> JsValue {
    let object = Object::new();
    for (name, value) in fields {
        // Setting a field of a plain object that was made here cannot fail.
        let _ = Reflect::set(&object, &(*name).into(), value);
    }
    object.into()
}
