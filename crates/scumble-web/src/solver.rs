//! Which solver makes the picture on the canvas. Files and lists of drawings have that of the mesh solver always.

use scumble_core::drawing::LONGER_SIDE_DU;

/// What the user asks for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Solver {
    /// The mesh solver, and before it the grid solver where that is there sooner.
    #[default]
    Automatic,
    /// On triangles: exact at every zoom.
    Mesh,
    /// On pixels.
    Gpu,
}

/// What a painter can do with problems of the grid solver.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Grids {
    /// Nothing.
    #[default]
    No,
    /// It solves them, without a graphics card.
    Slow,
    /// It solves them.
    Fast,
}

/// Where the picture on the canvas comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Source {
    /// The mesh solver.
    #[default]
    Mesh,
    /// The grid solver.
    Grid,
    /// The mesh solver: the grid solver was asked for, but the painter solves no grids.
    MeshWithoutGpu,
}

/// What is asked for, and what it comes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SolverState {
    /// By the user.
    pub asked: Solver,
    /// For the picture of the moment.
    pub source: Source,
}

/// Pixels of a grid to a side, at most: between and around their centres there is one more, which every device has room for.
const MOST_PX: f64 = 2047.0;

/// The same for a picture that another follows at once.
const FEW_PX: f64 = 512.0;

/// The same without a graphics card.
const FEWEST_PX: f64 = 256.0;

/// Pixels to a side, at most, of a page of which a part is solved by itself.
pub(crate) const WHOLE_PX: f64 = 1024.0;

/// The mesh solver takes longer to its first picture of a drawing with more pieces than the grid solver takes for
/// [`FEW_PX`].
const MANY_PIECES: usize = 100_000;

/// Where lines are moved in a drawing of more pieces than this, the mesh solver no longer keeps up with the pen.
pub(crate) const PIECES_IN_HAND: usize = 4000;

/// Nor does what comes before any solver, where there are more than this.
const MOST_PIECES_IN_HAND: usize = 20_000;

/// What rounding to whole pixels may add to a part.
const RIM_PX: f64 = 4.0;

/// Half a step from one size of a grid to the next, rounded up.
pub(crate) const HALF_STEP: f64 = 1.19;

/// What the choice depends on.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Moment {
    pub(crate) grids: Grids,
    /// Device pixels of one du.
    pub(crate) px_per_du: f64,
    pub(crate) pieces: usize,
    /// Whether the mesh is there.
    pub(crate) has_mesh: bool,
    /// Whether lines are being moved.
    pub(crate) is_in_motion: bool,
}

impl Solver {
    /// Where the picture is to come from.
    pub(crate) fn source(self, moment: &Moment) -> Source {
        match self {
            Self::Automatic if moment.is_grid_quicker() => Source::Grid,
            Self::Automatic | Self::Mesh => Source::Mesh,
            Self::Gpu if moment.grids == Grids::No => Source::MeshWithoutGpu,
            Self::Gpu => Source::Grid,
        }
    }
}

impl Moment {
    /// Whether the grid solver has a picture well before the mesh solver.
    fn is_grid_quicker(&self) -> bool {
        let is_first = self.pieces > MANY_PIECES && !self.has_mesh;
        let is_followed = self.is_in_motion && self.pieces > PIECES_IN_HAND;
        self.grids == Grids::Fast && (is_first || is_followed)
    }

    /// Whether lines can be followed in each frame while they are moved.
    pub(crate) fn is_live(&self, solver: Solver) -> bool {
        let by_grid = solver.source(self) == Source::Grid;
        self.pieces <= if by_grid { MOST_PIECES_IN_HAND } else { PIECES_IN_HAND }
    }

    /// Pixels of a grid of the whole page for one du, about as large as those of the canvas.
    pub(crate) fn grid_scale(&self, solver: Solver) -> f64 {
        step(self.px_per_du).min(self.most_px(solver) / LONGER_SIDE_DU)
    }

    /// The same of a part of the page, given its longest side.
    pub(crate) fn part_scale(&self, solver: Solver, side_du: f64) -> f64 {
        let most = (self.most_px(solver) - RIM_PX) / side_du;
        step(self.px_per_du.min(most / HALF_STEP))
    }

    /// Pixels of a grid to a side, at most.
    fn most_px(&self, solver: Solver) -> f64 {
        match (self.grids, solver) {
            (Grids::Fast, Solver::Gpu) => MOST_PX,
            (Grids::Fast, _) if self.is_in_motion => MOST_PX,
            (Grids::Fast, _) => FEW_PX,
            _ => FEWEST_PX,
        }
    }
}

/// A scale in steps of √2, so that a grid is solved anew only once in a while as the zoom changes.
fn step(scale: f64) -> f64 {
    ((2.0 * scale.log2()).round() / 2.0).exp2()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SMALL: Moment =
        Moment { grids: Grids::Fast, px_per_du: 1.0, pieces: 1000, has_mesh: false, is_in_motion: false };
    const LARGE: Moment = Moment { pieces: 200_000, ..SMALL };

    #[test]
    fn what_is_asked_for_is_taken_where_it_can_be() {
        for grids in [Grids::Slow, Grids::Fast] {
            assert_eq!(Solver::Gpu.source(&Moment { grids, ..SMALL }), Source::Grid);
        }
        assert_eq!(Solver::Gpu.source(&Moment { grids: Grids::No, ..SMALL }), Source::MeshWithoutGpu);
        assert_eq!(Solver::Gpu.source(&Moment { px_per_du: 64.0, ..SMALL }), Source::Grid);
        assert_eq!(Solver::Mesh.source(&LARGE), Source::Mesh);
    }

    #[test]
    fn a_large_drawing_has_a_grid_until_its_mesh_is_there_where_a_graphics_card_solves_it() {
        assert_eq!(Solver::Automatic.source(&LARGE), Source::Grid);
        assert_eq!(Solver::Automatic.source(&SMALL), Source::Mesh);
        for moment in [Moment { has_mesh: true, ..LARGE }, Moment { grids: Grids::Slow, ..LARGE }] {
            assert_eq!(Solver::Automatic.source(&moment), Source::Mesh);
        }
    }

    #[test]
    fn lines_in_motion_have_a_grid_where_the_mesh_cannot_follow() {
        let moving = |pieces| Moment { pieces, is_in_motion: true, has_mesh: true, ..SMALL };
        assert_eq!(Solver::Automatic.source(&moving(1000)), Source::Mesh);
        assert_eq!(Solver::Automatic.source(&moving(5000)), Source::Grid);
        assert_eq!(Solver::Automatic.source(&Moment { is_in_motion: false, ..moving(5000) }), Source::Mesh);
        assert_eq!(Solver::Automatic.source(&Moment { grids: Grids::Slow, ..moving(5000) }), Source::Mesh);
        assert_eq!(moving(5000).grid_scale(Solver::Automatic), moving(5000).grid_scale(Solver::Gpu));
        assert!(moving(5000).is_live(Solver::Automatic) && moving(1000).is_live(Solver::Mesh));
        assert!(!moving(5000).is_live(Solver::Mesh) && !moving(30_000).is_live(Solver::Automatic));
    }

    #[test]
    fn pixels_of_a_grid_are_about_those_of_the_canvas() {
        for px_per_du in [0.05, 0.3, 0.7, 1.0, 1.3, 1.9] {
            let wide_px = px_per_du / Moment { px_per_du, ..SMALL }.grid_scale(Solver::Gpu);
            assert!((0.84..=1.19).contains(&wide_px), "{wide_px} at {px_per_du}");
        }
        let close = Moment { px_per_du: 64.0, ..SMALL };
        assert_eq!(close.grid_scale(Solver::Gpu) * LONGER_SIDE_DU, MOST_PX);
        assert_eq!(close.part_scale(Solver::Gpu, 20.0), 64.0);
        assert_eq!(close.part_scale(Solver::Gpu, 100.0), 16.0);
    }

    #[test]
    fn in_haste_a_grid_has_few_pixels() {
        assert_eq!(LARGE.grid_scale(Solver::Automatic) * LONGER_SIDE_DU, FEW_PX);
        let without_card = Moment { grids: Grids::Slow, ..SMALL };
        assert_eq!(without_card.grid_scale(Solver::Gpu) * LONGER_SIDE_DU, FEWEST_PX);
    }
}
