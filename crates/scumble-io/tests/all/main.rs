//! What is read and written, by the public functions.

mod bad_svg;
mod curve_set;
mod dice;
mod fuzz;
mod images;
mod links;
mod made;
mod masks;
mod palettes;
mod released;
mod scribbles;
mod svg;
mod work_files;
mod work_round_trips;
