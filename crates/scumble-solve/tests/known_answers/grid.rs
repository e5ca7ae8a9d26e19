//! The grid solver on the same problems.

use super::*;

#[test]
fn report() {
    let at = |name: &str, problem: &Problem<'_>, tip: Option<Point>| {
        let errors: Vec<_> = [128, 256, 512]
            .map(|size| {
                let all = problem.largest_grid_error(size, |_| true);
                let far = tip.map(|tip| problem.largest_grid_error(size, |p| p.distance(tip) > 60.0));
                format!("{all:.4} {far:.4?}")
            })
            .into();
        println!("{name}: {errors:?}");
    };
    for (r, big) in [(100.0, 400.0), (200.0, 400.0), (30.0, 400.0)] {
        annulus(r, big, |p| at("annulus", p, None));
    }
    for k in 1..=5 {
        disk(450.0, k, |p| at("disk", p, None));
    }
    parallel_lines(|p| at("lines", p, None));
    eccentric_annuli(|p| at("eccentric", p, None));
    for angle in [FRAC_PI_2, 2.0 * FRAC_PI_2 / 1.5, 1.5 * PI] {
        wedge(angle, |p| at("wedge", p, None));
    }
    coloured_slit(|p| at("slit", p, Some(CENTRE)));
    barrier_slit(|p| at("barrier", p, Some(CENTRE)));
    half_plane_with_a_barrier(|p, tip| at("half plane", p, Some(tip)));
    diagonal(|p| at("diagonal", p, None));
}
