//! The ways to colour that are compared: engines and, on pixels, other people's methods; each by its name.

use scumble_core::{EngineKind, Settings};

use crate::rivals::{self, Sketch, SketchPixel};

/// A way to colour.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Method {
    /// As the user writes it.
    pub(crate) name: &'static str,
    pub(crate) way: Way,
}

/// What a method works on.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Way {
    /// The planar map.
    Engine(EngineKind),
    /// The planar map, by direct visibility.
    Sight,
    /// Pixels: labels all pixels of a sketch.
    Pixels(fn(&Sketch, Settings) -> Vec<SketchPixel>),
}

/// All scribbles at once.
const GLOBAL: Method = Method { name: "global", way: Way::Engine(EngineKind::Global) };

/// What a scribble sees is its own.
pub(crate) const SIGHT: Method = Method { name: "sight", way: Way::Sight };

/// Flood fill without gap closing.
pub(crate) const FLOOD: Method =
    Method { name: "flood", way: Way::Pixels(|sketch, settings| rivals::flood(sketch, settings.spread)) };

/// LazyBrush with hard scribbles: on thin scribbles the better one for it.
const LAZYBRUSH: Method =
    Method { name: "lazybrush", way: Way::Pixels(|sketch, _| rivals::lazybrush(sketch, rivals::HARD)) };

/// LazyBrush with scribbles as soft as the paper's.
const SOFT_LAZYBRUSH: Method =
    Method { name: "lazybrush-soft", way: Way::Pixels(|sketch, _| rivals::lazybrush(sketch, rivals::SOFT)) };

/// All methods. The last three spread colours with any settings: they leave no pixel out.
const METHODS: [Method; 7] = [
    GLOBAL,
    Method { name: "progressive", way: Way::Engine(EngineKind::Progressive) },
    SIGHT,
    FLOOD,
    LAZYBRUSH,
    SOFT_LAZYBRUSH,
    Method { name: "nearest", way: Way::Pixels(|sketch, _| rivals::nearest(sketch)) },
];

impl Default for Method {
    fn default() -> Self {
        GLOBAL
    }
}

impl Method {
    /// Reads a name.
    ///
    /// # Errors
    /// When there is no such method; the message names all.
    pub(crate) fn parse(name: &str) -> Result<Self, String> {
        let names = || METHODS.map(|method| method.name).join(", ");
        let found = METHODS.into_iter().find(|method| method.name == name);
        found.ok_or_else(|| format!("give one of {}", names()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn methods_are_found_by_their_names() {
        for method in METHODS {
            assert_eq!(Method::parse(method.name).unwrap().name, method.name);
        }
        let message = Method::parse("crayon").unwrap_err();
        assert!(METHODS.iter().all(|method| message.contains(method.name)), "{message}");
    }
}
