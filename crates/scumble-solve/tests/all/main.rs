//! What the solvers make, by their public functions.

mod coloring;
mod colors_by_hand;
mod gaps;
mod grid_shading;
mod grid_solver;
mod known_answers;
mod mesh_solver;
mod settings;
mod shading;
mod shading_known_answers;
mod shading_odd_input;
mod shading_on_a_grid;
mod slices;
