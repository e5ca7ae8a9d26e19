//! The names by which the page knows what there is to choose from.

use scumble_core::{Blend, ColorModel, Deed, EngineKind, Tone};

use crate::brush::{Ink, Kind, Pressure};
use crate::command::Tool;
use crate::effect::{Edit, Wanted};
use crate::solver::{Solver, Source};

pub(super) fn tool_from_name(name: &str) -> Option<Tool> {
    [Tool::Scribble, Tool::Erase, Tool::Select, Tool::Pick, Tool::Hand]
        .into_iter()
        .find(|tool| tool_name(*tool) == name)
}

pub(super) fn tool_name(tool: Tool) -> &'static str {
    match tool {
        Tool::Scribble => "scribble",
        Tool::Erase => "erase",
        Tool::Select => "select",
        Tool::Pick => "pick",
        Tool::Hand => "hand",
    }
}

pub(super) fn edit_name(edit: Edit) -> &'static str {
    match edit {
        Edit::Moved => "moved",
        Edit::Resized => "resized",
        Edit::Widened => "widened",
        Edit::Reshaded => "reshaded",
        Edit::Recolored => "recoloured",
        Edit::Duplicated => "duplicated",
        Edit::Forward => "forward",
        Edit::Backward => "backward",
        Edit::Foremost => "foremost",
        Edit::Hindmost => "hindmost",
        Edit::Deleted => "deleted",
        Edit::Hidden => "hidden",
        Edit::Shown => "shown",
    }
}

pub(super) fn wanted_name(wanted: Wanted) -> &'static str {
    match wanted {
        Wanted::Nothing => "",
        Wanted::Picture => "picture",
        Wanted::Mesh => "mesh",
    }
}

pub(super) fn deed_key(deed: Deed) -> &'static str {
    match deed {
        Deed::Added => "did-add",
        Deed::Shaded => "did-shade",
        Deed::Erased => "did-erase",
        Deed::Rubbed => "did-rub",
        Deed::Moved => "did-move",
        Deed::Resized => "did-resize",
        Deed::Widened => "brush-size",
        Deed::Reshaded => "did-reshade",
        Deed::Recolored => "did-recolour",
        Deed::Duplicated => "did-duplicate",
        Deed::Forward => "did-forward",
        Deed::Backward => "did-backward",
        Deed::Deleted => "did-delete",
        Deed::Hidden => "did-hide",
        Deed::Shown => "did-show",
        Deed::GapClosing => "gap-closing",
        Deed::Engine => "engine",
        Deed::Blend => "blend",
        Deed::Spread => "spread",
        Deed::SwatchAdded => "did-add-swatch",
        Deed::SwatchRemoved => "did-remove-swatch",
        Deed::SwatchNamed => "did-name-swatch",
        Deed::SwatchesOrdered => "did-order-swatches",
        Deed::Palette => "did-take-palette",
        Deed::Repainted => "did-repaint",
        Deed::Traced => "tracing",
        Deed::Untraced => "tracing-removed",
        Deed::Faded => "did-fade",
    }
}

pub(super) fn erasing_name(takes_parts: bool) -> &'static str {
    if takes_parts { "parts" } else { "whole" }
}

pub(super) fn kind_from_name(name: &str) -> Option<Kind> {
    [Kind::Fill, Kind::Shade].into_iter().find(|kind| kind_name(*kind) == name)
}

pub(super) fn kind_name(kind: Kind) -> &'static str {
    match kind {
        Kind::Fill => "fill",
        Kind::Shade => "shade",
    }
}

pub(super) fn pressure_from_name(name: &str) -> Option<Pressure> {
    [Pressure::Radius, Pressure::Strength, Pressure::Off]
        .into_iter()
        .find(|pressure| pressure_name(*pressure) == name)
}

pub(super) fn pressure_name(pressure: Pressure) -> &'static str {
    match pressure {
        Pressure::Radius => "radius",
        Pressure::Strength => "strength",
        Pressure::Off => "off",
    }
}

pub(crate) fn color_model_from_name(name: &str) -> Option<ColorModel> {
    match name {
        "oklch" => Some(ColorModel::Oklch),
        "hsv" => Some(ColorModel::Hsv),
        _ => None,
    }
}

/// A tone by its name, or a colour written as #rrggbb, or none.
pub(super) fn ink_from_name(name: &str) -> Option<Ink> {
    let tones = [Tone::Lighter, Tone::Darker, Tone::Warmer, Tone::Cooler];
    let tone = tones.into_iter().find(|tone| tone_name(*tone) == name);
    tone.map(Ink::Tone).or_else(|| name.parse().ok().map(Ink::Paint))
}

pub(super) fn tone_name(tone: Tone) -> &'static str {
    match tone {
        Tone::Lighter => "lighter",
        Tone::Darker => "darker",
        Tone::Warmer => "warmer",
        Tone::Cooler => "cooler",
    }
}

pub(super) fn engine_from_name(name: &str) -> Option<EngineKind> {
    [EngineKind::Global, EngineKind::Progressive].into_iter().find(|engine| engine_name(*engine) == name)
}

pub(super) fn engine_name(engine: EngineKind) -> &'static str {
    match engine {
        EngineKind::Global => "global",
        EngineKind::Progressive => "progressive",
    }
}

pub(super) fn blend_from_name(name: &str) -> Option<Blend> {
    [Blend::Oklab, Blend::Srgb].into_iter().find(|blend| blend_name(*blend) == name)
}

pub(super) fn blend_name(blend: Blend) -> &'static str {
    match blend {
        Blend::Oklab => "oklab",
        Blend::Srgb => "srgb",
    }
}

pub(super) fn solver_from_name(name: &str) -> Option<Solver> {
    [Solver::Automatic, Solver::Mesh, Solver::Gpu].into_iter().find(|solver| solver_name(*solver) == name)
}

pub(super) fn solver_name(solver: Solver) -> &'static str {
    match solver {
        Solver::Automatic => "automatic",
        Solver::Mesh => "mesh",
        Solver::Gpu => "gpu",
    }
}

pub(super) fn source_name(source: Source) -> &'static str {
    match source {
        Source::Mesh => "mesh",
        Source::Grid => "gpu",
        Source::MeshWithoutGpu => "without-gpu",
    }
}
