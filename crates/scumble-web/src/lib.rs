//! The page's side of the boundary to the browser.
//!
//! | noun | file |
//! |---|---|
//! | a document under gestures and commands | [`session`] |
//! | what there is to paint | [`painting`] |
//! | the painter on the CPU: what has changed, in strips | [`strips`] |
//! | what the pen draws with | [`brush`] |
//! | the way of a pen, smooth and simple | [`stroke`] |
//! | what the page can ask for | [`command`] |
//! | what the page must know | [`effect`] |
//! | what is selected, and its frame | `selection` |
//! | rooms and gaps, to look at | `regions` |
//! | which solver makes the picture | [`solver`] |
//! | pan, zoom, fit | [`view`] |
//! | scribbles, ink and desk over the picture | [`layers`] |
//! | the canvas and what paints it: GPU or CPU | `screen` |
//! | the renderer of the other build, in its own module | `beside` |
//! | commands and effects as JavaScript values | `boundary` |
//! | what JavaScript calls | `app` |
//!
//! All but the last four are free of the browser and tested without one.

pub mod beside;
pub mod brush;
pub mod command;
pub mod effect;
pub mod layers;
pub mod painting;
mod regions;
mod selection;
pub mod session;
pub mod solver;
pub mod strips;
pub mod stroke;
pub mod view;

#[cfg(target_arch = "wasm32")]
mod app;
#[cfg(target_arch = "wasm32")]
mod boundary;
#[cfg(target_arch = "wasm32")]
pub mod screen;

#[cfg(target_arch = "wasm32")]
pub use app::App;
