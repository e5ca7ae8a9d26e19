//! The grid solver on the same problems, at 256² pixels.
//!
//! Where a curve runs through the centre of a pixel it is taken to pass 0.02 px beside it. That, the lattice, and the
//! chords of curves bound how small errors become; so the fall with the size of a pixel is looked at where they are
//! larger. At the tips of curves errors fall with the root of the size of a pixel, beyond with that size itself; with its fourth root and its root where
//! one side of the tip has a colour and the other has none.

use super::*;

const SIZE_PX: u32 = 256;

/// Checks that the error falls to this part of itself, or less, each time the size of the picture is doubled.
fn assert_grid_falls(
    problem: &Problem<'_>,
    sizes_px: &[u32],
    part: f64,
    place: impl Fn(Point) -> bool + Copy,
) {
    let errors: Vec<_> = sizes_px.iter().map(|&size_px| problem.largest_grid_error(size_px, place)).collect();
    assert!(errors.windows(2).all(|pair| pair[1] <= part * pair[0]), "{errors:?}");
}

#[track_caller]
fn assert_grid_level(problem: &Problem<'_>, bound: f64) {
    assert_level(problem.largest_grid_error(SIZE_PX, |_| true), bound);
}

#[test]
fn annulus_on_pixels() {
    for (r, levels) in [(200.0, 0.1), (100.0, 0.1), (30.0, 0.3)] {
        annulus(r, 400.0, |problem| assert_grid_level(problem, levels));
    }
    annulus(100.0, 400.0, |problem| assert_grid_falls(problem, &[64, 128, 256], 0.4, |_| true));
}

#[test]
fn disk_on_pixels() {
    for k in 1..=5 {
        for radius in [300.0, 450.0] {
            disk(radius, k, |problem| assert_grid_level(problem, 0.1));
        }
    }
    disk(450.0, 5, |problem| assert_grid_falls(problem, &[64, 128, 256], 0.4, |_| true));
}

#[test]
fn lines_and_eccentric_annuli_on_pixels() {
    parallel_lines(|problem| assert_grid_level(problem, 0.02));
    eccentric_annuli(|problem| assert_grid_level(problem, 0.4));
}

#[test]
fn wedge_on_pixels() {
    for (angle, levels) in [(FRAC_PI_2, 0.05), (2.0 * FRAC_PI_2 / 1.5, 0.05), (1.5 * PI, 1.5)] {
        wedge(angle, |problem| assert_grid_level(problem, levels));
    }
}

/// Checks the errors at a tip, and more than 60 du from it; and how they fall.
fn assert_grid_levels_at_tip(problem: &Problem<'_>, tip: Point, at_levels: f64, beyond_levels: f64) {
    let is_beyond = |p: Point| p.distance(tip) > 60.0;
    assert_grid_level(problem, at_levels);
    assert_level(problem.largest_grid_error(SIZE_PX, is_beyond), beyond_levels);
    assert_grid_falls(problem, &[128, 256, 512], 0.75, |_| true);
    assert_grid_falls(problem, &[128, 256, 512], 0.65, is_beyond);
}

#[test]
fn tips_on_pixels() {
    coloured_slit(|problem| assert_grid_levels_at_tip(problem, CENTRE, 5.2, 1.0));
    barrier_slit(|problem| assert_grid_levels_at_tip(problem, CENTRE, 2.6, 0.5));
    half_plane_with_a_barrier(|problem, tip| assert_grid_levels_at_tip(problem, tip, 1.5, 0.3));
}

#[test]
fn tip_with_one_coloured_side_on_pixels() {
    half_coloured_slit(|problem| {
        let is_beyond = |p: Point| p.distance(CENTRE) > 60.0;
        assert_grid_level(problem, 34.0);
        assert_level(problem.largest_grid_error(SIZE_PX, is_beyond), 11.0);
        assert_grid_falls(problem, &[128, 256, 512], 0.9, |_| true);
        assert_grid_falls(problem, &[128, 256, 512], 0.75, is_beyond);
    });
}

#[test]
fn a_diagonal_leaks_nothing_on_pixels() {
    diagonal(|problem| assert_grid_level(problem, 0.01));
}
