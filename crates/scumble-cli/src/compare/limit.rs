//! The picture that finer and finer grids tend to, from two of them.

use scumble_core::{Boundary, PlanarMap};
use scumble_solve::View;
use scumble_solve::grid::{Constraints, GridSolver, TOLERANCE, Texel};

/// How many times smaller the pixels of the finer grid are.
const FINER: u32 = 2;

/// Errors fall with this power of the size of a pixel where they are largest: in regions with a tip that has a colour on one
/// side alone, where the solution goes as the fourth root of the distance.
const POWER: f32 = 0.5;

/// The limit at the centres of the pixels of a view, whose own solution is known.
///
/// # Errors
/// When a shade cannot be solved.
pub(super) fn limit(
    pixels: &[Texel],
    map: &PlanarMap,
    boundary: &Boundary,
    view: &View,
) -> anyhow::Result<Vec<Texel>> {
    let fine = View {
        px_from_du: view.px_from_du.then_scale(FINER.into()),
        width_px: FINER * view.width_px,
        height_px: FINER * view.height_px,
    };
    let mut solver = GridSolver::new(&Constraints::new(map, boundary, &fine)?);
    solver.solve(TOLERANCE);
    let finer = at_centres(&solver.pixels(), view);
    Ok(pixels.iter().zip(&finer).map(|(coarse, fine)| extrapolated(*coarse, *fine)).collect())
}

/// The means of the four finer pixels around the centres of a view's.
fn at_centres(fine: &[Texel], view: &View) -> Vec<Texel> {
    let (width, height) = (view.width_px as usize, view.height_px as usize);
    let load = |x: usize, y: usize| fine[y * FINER as usize * width + x];
    let mean = |x: usize, y: usize| {
        let corners = [(0, 0), (1, 0), (0, 1), (1, 1)].map(|(dx, dy)| load(2 * x + dx, 2 * y + dy));
        [0, 1, 2, 3].map(|c| corners.iter().map(|texel| 0.25 * texel[c]).sum())
    };
    (0..height).flat_map(|y| (0..width).map(move |x| (x, y))).map(|(x, y)| mean(x, y)).collect()
}

fn extrapolated(coarse: Texel, fine: Texel) -> Texel {
    let beyond = 1.0 / ((FINER as f32).powf(POWER) - 1.0);
    [0, 1, 2, 3].map(|c| fine[c] + beyond * (fine[c] - coarse[c]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_error_that_falls_with_the_root_is_taken_away() {
        let at = |size_px: f32| [0.3 + 0.1 * size_px.sqrt(), 0.7 - 0.2 * size_px.sqrt(), 0.5, 1.0];
        let limit = extrapolated(at(1.0), at(0.5));
        assert!(limit.iter().zip([0.3, 0.7, 0.5, 1.0]).all(|(a, b)| (a - b).abs() < 1e-6), "{limit:?}");
    }
}
