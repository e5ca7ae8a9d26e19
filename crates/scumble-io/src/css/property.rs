//! A property whose values are colours.

use svgtypes::{Color, Paint};

/// The properties whose values are colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Property {
    Fill,
    Stroke,
    Color,
    StopColor,
}

impl Property {
    pub(crate) fn of(name: &str) -> Option<Self> {
        match name {
            "fill" => Some(Self::Fill),
            "stroke" => Some(Self::Stroke),
            "color" => Some(Self::Color),
            "stop-color" => Some(Self::StopColor),
            _ => None,
        }
    }

    /// What stands for a colour that nobody can read: a black line; and for an area what is no ink, so that it has an outline.
    pub(crate) fn stand_in(self) -> &'static str {
        match self {
            Self::Stroke | Self::Color => "black",
            Self::Fill | Self::StopColor => "white",
        }
    }

    /// Whether `usvg` reads a value.
    pub(super) fn reads(self, value: &str) -> bool {
        match self {
            Self::Fill | Self::Stroke => Paint::from_str(value).is_ok(),
            Self::Color => value == "inherit" || value.parse::<Color>().is_ok(),
            Self::StopColor => matches!(value, "inherit" | "currentColor") || value.parse::<Color>().is_ok(),
        }
    }

    /// A word that is no colour.
    pub(super) fn keyword(self, word: &str) -> Option<&'static str> {
        match &*word.to_ascii_lowercase() {
            "none" if matches!(self, Self::Fill | Self::Stroke) => Some("none"),
            "currentcolor" if self == Self::Color => Some("inherit"),
            "currentcolor" => Some("currentColor"),
            "initial" if self == Self::Stroke => Some("none"),
            "initial" => Some("black"),
            "" | "inherit" | "unset" | "revert" | "revert-layer" => Some("inherit"),
            _ => None,
        }
    }
}
