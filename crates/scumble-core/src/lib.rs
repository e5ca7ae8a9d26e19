//! A line drawing, the scribbles on it, its planar map, and the colours that scribbles give its sides.
//!
//! | noun | file |
//! |---|---|
//! | colours and blend spaces | [`color`] |
//! | colours by the numbers that people turn | [`color_model`] |
//! | swatches | [`palette`] |
//! | a line drawing in drawing units | [`drawing`] |
//! | a stroke of colour | [`scribble`] |
//! | a scribble of which a part is rubbed out | `rub` |
//! | shading scribbles as soft sources | [`source`] |
//! | colours for highlights and shadows | [`tone`] |
//! | the document, gestures, undo | [`edit`] |
//! | triangles, half-edges, sides | [`triangulation`] |
//! | Delaunay triangulation, and its refinement | `delaunay`, `refinement` |
//! | distances along a path | [`measured_path`] |
//! | lengths that grow from the ends of a line | `grading` |
//! | curves sampled on a lattice | `sample` |
//! | crossings found and rounded | `snap` |
//! | an order of nodes in the plane | `nearness` |
//! | curves as pieces that meet only at nodes | [`planar_map`] |
//! | curves between the nodes of a map | [`bends`] |
//! | paths by where they start | [`starts`] |
//! | samples along a stroke | `stroke` |
//! | what a point sees | `visibility` |
//! | how wide the ways between lines are | `clearance` |
//! | narrow passages between wide places | `gaps` |
//! | which scribble colours which side | [`engine`], [`global`], [`progressive`], [`sight`] |
//! | how a drawing is coloured | [`settings`] |
//! | a picture under the lines | [`tracing`] |
//! | colours along the sides of curves | [`color_points`] |
//! | what the solver is given to spread | [`boundary`](mod@boundary) |
//! | what is kept of somebody's work | [`work`] |
//! | … as bytes that lose nothing | [`exact`] |
//! | long work in slices | [`pace`] |
//! | numbers as files hold them | `kept` |
//! | numbers and points within bounds | [`clamp`] |
//! | angles that are the same on every machine | `angle` |
//! | sorting, small maps and disjoint sets, with little code | [`sort`], `small_map`, `sets` |

mod angle;
pub mod bends;
pub mod boundary;
pub mod bounds;
pub mod clamp;
mod clearance;
pub mod color;
pub mod color_model;
pub mod color_points;
mod delaunay;
pub mod drawing;
pub mod edit;
pub mod engine;
pub mod exact;
mod gaps;
pub mod global;
mod grading;
mod kept;
pub mod measured_path;
mod nearness;
pub mod pace;
pub mod palette;
pub mod planar_map;
pub mod progressive;
mod refinement;
mod rub;
mod sample;
pub mod scribble;
pub mod sets;
pub mod settings;
pub mod sight;
mod small_map;
mod snap;
pub mod sort;
pub mod source;
pub mod starts;
mod stroke;
pub mod tone;
pub mod tracing;
pub mod triangulation;
mod visibility;
pub mod work;

pub use angle::{angle_part, unit_vector};
pub use bends::Bends;
pub use boundary::{Boundary, KnownBoundary, SideColors, boundary};
pub use clamp::{clamped, nearest_in};
pub use color::{Blend, BlendColor, ColorError, Paint, Rgba8, Srgb8};
pub use color_model::ColorModel;
pub use color_points::ColorPoint;
pub use drawing::{Curve, Drawing, Fill, Line};
pub use edit::{Deed, Document, Editor, Entry};
pub use engine::{Engine, Labels};
pub use global::Global;
pub use palette::Swatch;
pub use planar_map::{Gap, MapError, Piece, PlanarMap, Sampling, Step};
pub use progressive::Progressive;
pub use sample::clip;
pub use scribble::{PenPressure, Scribble, ScribbleKind, Shading};
pub use settings::{EngineKind, Settings};
pub use sight::Sight;
pub use source::SoftSource;
pub use tone::Tone;
pub use tracing::Tracing;
pub use triangulation::{HalfEdge, SideId, Triangulation};
pub use work::Work;
