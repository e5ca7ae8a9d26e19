//! What a mesh of half the width would change: whether the mesh is fine enough.

use scumble_core::{BlendColor, Boundary, PlanarMap, Settings, SideColors};
use scumble_solve::{MeshSolver, SolveError, View, centers, quadratic};

use super::levels::{Levels, Spread, levels};
use super::zones::{self, Zone};

/// Pixels nearer than this, in px, to an end, a junction or a change do not count as away.
const AWAY_PX: f64 = 16.0;

/// What half the width changes of the picture on the mesh: everywhere, and away from special places.
///
/// # Errors
/// When the solver fails.
pub(super) fn changes(
    map: &PlanarMap,
    boundary: &Boundary,
    view: &View,
    mesh: &[Levels],
) -> Result<[Spread; 2], SolveError> {
    let blend = Settings::default().blend;
    let halved = Boundary { sides: halved(&boundary.sides), ..boundary.clone() };
    let mut solver = MeshSolver::new(map.refined().halved());
    let finer = levels(&centers::colors(solver.solve(&halved, blend)?, view), blend);
    let zones = zones::zones(map, boundary, view, AWAY_PX);
    let is_away = |i: usize| zones[i] != Zone::Special;
    Ok([Spread::of(&finer, mesh, |_| true), Spread::of(&finer, mesh, is_away)])
}

/// The colours of the halves of sides: those of both halves of a piece follow one another.
pub(super) fn halved(sides: &SideColors) -> SideColors {
    let halves = |both: &[Option<[BlendColor; 3]>]| {
        let [left, right] = [both[0], both[1]].map(|side| side.map(halves));
        [
            left.map(|half| half[0]),
            right.map(|half| half[1]),
            left.map(|half| half[1]),
            right.map(|half| half[0]),
        ]
    };
    sides.chunks_exact(2).flat_map(halves).collect()
}

fn halves([start, middle, end]: [BlendColor; 3]) -> [[BlendColor; 3]; 2] {
    let at = |t: f64| {
        let [a, b, c] = quadratic::edge(t);
        [0, 1, 2, 3].map(|i| a * start[i] + b * middle[i] + c * end[i])
    };
    [[start, at(0.25), middle], [middle, at(0.75), end]]
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::compare::SIZE_PX;
    use crate::set::{self, Entry, Kind};
    use crate::stages;

    fn changes_of(entry: &Entry) -> [Spread; 2] {
        let mut opened = stages::open(&entry.svg().unwrap()).unwrap();
        let scribbles = entry.scribbles(Kind::Dense, &opened.document.drawing).unwrap();
        let settings = Settings::default();
        opened.picture.color(&scribbles, &[], &settings);
        let view = stages::page_view(&opened.document.drawing, SIZE_PX);
        let field = opened.picture.solve().unwrap();
        let mesh = levels(&centers::colors(field, &view), settings.blend);
        changes(opened.picture.map(), opened.picture.boundary(), &view, &mesh).unwrap()
    }

    #[test]
    fn half_the_width_changes_little() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../../shared/quality/dev");
        if !folder.exists() {
            return eprintln!("skipped: there are no drawings in {}", folder.display());
        }
        let [mut all, mut away] = [Spread::default(), Spread::default()];
        for entry in set::entries(&folder).unwrap() {
            let changes = changes_of(&entry);
            all.add(&changes[0]);
            away.add(&changes[1]);
        }
        println!("levels (mean, 99 %, largest): {all}, away {away}");
        assert!(all.mean() <= 0.1 && away.largest() <= 1.0);
    }
}
