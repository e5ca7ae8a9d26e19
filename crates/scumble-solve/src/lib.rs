//! Colour points in, colour field out: the mesh solver, the grid solver on the CPU, and a painter.
//!
//! | noun | file |
//! |---|---|
//! | what no colour passes | `barriers` |
//! | the soft brush of a shading scribble | `brush` |
//! | a field at the centres of pixels | [`centers`] |
//! | triangles with colours: the solved picture | [`field`] |
//! | the grid solver, on pixels | [`grid`] |
//! | lines, fills and scribbles as flat shapes | [`ink`] |
//! | the mesh solver | [`mesh`] |
//! | the painter on the CPU | [`mod@paint`] |
//! | all that is derived from a document | [`picture`] |
//! | shape functions of quadratic elements | [`quadratic`] |
//! | which regions a shading scribble shades | `reach` |
//! | what a painter paints | [`scene`] |

mod barriers;
mod brush;
pub mod centers;
pub mod field;
pub mod grid;
pub mod ink;
pub mod mesh;
pub mod paint;
pub mod picture;
pub mod quadratic;
mod reach;
pub mod scene;

pub use field::{EVERYWHERE, Field, FieldChange, FieldTriangle};
pub use ink::{fill_shapes, line_shapes, scribble_shape};
pub use mesh::{MeshSolver, SolveError};
pub use paint::{Pixmap, Repainter, paint, paint_grid};
pub use picture::Picture;
pub use scene::{Part, Scene, Shape, View};
