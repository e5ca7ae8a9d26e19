//! The names that a file has for things.

use kurbo::{Cap, Join, Stroke};
use scumble_core::{Blend, EngineKind};

pub(super) const BLENDS: [(&str, Blend); 2] = [("oklab", Blend::Oklab), ("srgb", Blend::Srgb)];

pub(super) const ENGINES: [(&str, EngineKind); 2] =
    [("global", EngineKind::Global), ("progressive", EngineKind::Progressive)];

pub(super) const CAPS: [(&str, Cap); 3] =
    [("butt", Cap::Butt), ("round", Cap::Round), ("square", Cap::Square)];

pub(super) const JOINS: [(&str, Join); 3] =
    [("miter", Join::Miter), ("round", Join::Round), ("bevel", Join::Bevel)];

pub(super) const RULES: [(&str, bool); 2] = [("nonzero", false), ("evenodd", true)];

/// Whether a scribble shades.
pub(super) const KINDS: [(&str, bool); 2] = [("fill", false), ("shade", true)];

pub(super) const SIDES: [(&str, bool); 2] = [("left", true), ("right", false)];

/// What a line is where nothing else is said, as in SVG.
pub(super) fn plain_stroke() -> Stroke {
    Stroke::new(1.0).with_caps(Cap::Butt).with_join(Join::Miter).with_miter_limit(4.0)
}

/// The name of a value.
pub(super) fn name<T: PartialEq + Copy, const N: usize>(
    names: &[(&'static str, T); N],
    value: T,
) -> &'static str {
    names.iter().find(|(_, known)| *known == value).map_or("", |(name, _)| name)
}
