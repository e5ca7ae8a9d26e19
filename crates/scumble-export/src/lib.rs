//! Pictures as files that other programs show: SVG and PDF, with what they are made of.
//!
//! Where a region is of one colour it becomes a filled path; lines and solid ink stay the paths that they are. Shades
//! become triangles that PDF blends by itself, and pixels in SVG, which has nothing for them.
//!
//! | noun | file |
//! |---|---|
//! | what is exported, and how it is to look | `export` |
//! | the page that it is written on | `sheet` |
//! | regions of a field, those of one colour as paths | `regions`, `outline` |
//! | colours as other programs have them | `tint` |
//! | shades as triangles that are blended linearly | `mesh` |
//! | lines and solid ink as paths | `ink` |
//! | SVG | `svg` |
//! | PDF, its objects, its shadings | `pdf`, `pdf/objects`, `pdf/shading` |
//! | numbers in files | `numbers` |

mod export;
mod ink;
mod mesh;
mod numbers;
mod outline;
mod pdf;
mod regions;
mod sheet;
mod svg;
mod tint;

pub use export::{Export, Look, PX_PER_DU, RASTER_PX};
