//! A line drawing, the scribbles on it, its planar map, and the colours that scribbles give its sides.
//!
//! | noun | file |
//! |---|---|
//! | colours and blend spaces | [`color`] |
//! | a line drawing in drawing units | [`drawing`] |
//! | a stroke of colour | [`scribble`] |
//! | the document, gestures, undo | [`edit`] |
//! | triangles, half-edges, sides | [`triangulation`] |
//! | curves sampled on a lattice | `sample` |
//! | crossings found and rounded | `snap` |
//! | curves as pieces that meet only at nodes | [`planar_map`] |
//! | samples along a stroke | `stroke` |
//! | what a point sees | [`visibility`] |
//! | which scribble colours which side | [`engine`], [`sight`], [`progressive`] |
//! | colours along the sides of curves | [`color_points`] |

pub mod color;
pub mod color_points;
pub mod drawing;
pub mod edit;
pub mod engine;
pub mod planar_map;
pub mod progressive;
mod sample;
pub mod scribble;
pub mod sight;
mod snap;
mod stroke;
pub mod triangulation;
pub mod visibility;

pub use color::{Blend, BlendColor, ColorError, Rgba8, Srgb8};
pub use color_points::{ColorPoint, ColorSpan, SideColors, color_spans, side_colors};
pub use drawing::{Curve, Drawing, Fill, Line};
pub use edit::{Document, Editor};
pub use engine::{Engine, Labels};
pub use planar_map::{Gap, MapError, Piece, PlanarMap, Sampling, Step};
pub use progressive::Progressive;
pub use scribble::Scribble;
pub use sight::Sight;
pub use triangulation::{HalfEdge, SideId, Triangulation};
pub use visibility::{Visible, visibility_polygon};
