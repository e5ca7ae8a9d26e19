//! The mesh solver: the colours of the sides of curves, spread by Laplace's equation into a picture.
//!
//! Quadratic finite elements on the refined triangulation (after S. Boyé, P. Barla, G. Guennebaud, *A vectorial
//! solver for free-form vector gradients*, 2012). There is one unknown for each sector of a node, one for each
//! edge inside a region and one for each side of a curve, so no colour leaks from one side to the other. Coloured
//! sides are fixed; the others, the frame, and closed gaps are no-flux barriers. A region without a coloured side stays
//! paper. At tips, and wherever else the solution is singular, elements have other functions.
//!
//! Every region is a linear system of its own. Its geometry is looked at when one of its gaps is closed or opened, its
//! matrix is factored when the set of its coloured sides changes, unless undo comes back to the one before, and a change of
//! colours costs two triangular solves. How much a soft source covers of a region is a system beside its own, of finer elements
//! around its stroke alone.
//! All sums are in a fixed order, so the same colours of sides give the same picture on every machine.

mod bent;
mod cells;
mod cholesky;
mod dissection;
mod dofs;
mod element;
mod elements;
mod fronts;
mod layer;
mod limit;
mod numbering;
mod once;
mod order;
mod pattern;
mod refine;
mod region;
mod singular;
mod stroke;
mod substitution;
mod system;

use std::mem;
use std::sync::Arc;

use scumble_core::pace::{self, Pace, Slices, now};
use scumble_core::{Blend, Boundary, SoftSource, Triangulation, sort};
use thiserror::Error;

use crate::barriers::Barriers;
use crate::field::{Field, FieldChange, FieldTriangle, Others};
use crate::reach::{Reach, Regions};
use numbering::Numbering;
pub(crate) use once::Once;
use once::bounds_du;
use region::Region;
use substitution::TileColumn;

/// Why a drawing has no colour field.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
pub enum SolveError {
    /// The factor of a region does not fit into memory or into 32-bit indices.
    #[error(
        "a region of the drawing has too much detail to be coloured; simplify it or divide it with a line"
    )]
    TooLarge,
    /// A pivot was not positive: corners that are not finite.
    #[error("a region of the drawing could not be solved; please report this drawing")]
    NotPositive,
}

/// Spreads the colours of sides over a mesh, and remembers what it can for the next time.
///
/// [`MeshSolver::solve`] does it all; its three stages can be called one by one, to time them. Each looks only at the
/// regions whose boundary changed. What is called an *-ing* does the same in slices.
#[derive(Debug)]
pub struct MeshSolver {
    mesh: Arc<Triangulation>,
    numbering: Numbering,
    /// As of the last look at the boundary.
    closed_gaps: Vec<bool>,
    /// By the first triangle of each.
    regions: Vec<Region>,
    /// Of the largest factor that was of no use any more.
    memory: Vec<TileColumn>,
    /// Whoever has a copy of it keeps it as it was.
    field: Arc<Field>,
    /// What of it is not what it was when somebody last asked.
    change: FieldChange,
    /// How many triangles of the field are those of each region; none are where the regions are others.
    emitted: Vec<usize>,
}

impl MeshSolver {
    /// Numbers the unknowns of a mesh, all gaps being open, and finds an order of elimination and its pattern.
    pub fn new(mesh: impl Into<Arc<Triangulation>>) -> Self {
        now(Self::meshing(mesh.into(), None))
    }

    /// The same in slices. For what is needed once it takes less time, and the solver is of no use for anything else.
    pub(crate) fn meshing(mesh: Arc<Triangulation>, once: Option<Once<'_>>) -> Slices<'_, Self> {
        Slices::new(Self::meshed(mesh, once))
    }

    async fn meshed(mesh: Arc<Triangulation>, once: Option<Once<'_>>) -> Self {
        let closed_gaps = once.map(|once| once.boundary.closed_gaps.clone()).unwrap_or_default();
        let barriers = Barriers { mesh: &mesh, closed_gaps: &closed_gaps };
        let mut regions = numbering::regions(barriers, once).await;
        let numbering = Numbering::new(&mesh, &mut regions, once).await;
        Self {
            mesh,
            numbering,
            closed_gaps,
            regions: regions.into_iter().map(Region::new).collect(),
            memory: Vec::new(),
            field: Arc::default(),
            change: FieldChange::default(),
            emitted: Vec::new(),
        }
    }

    /// The colour field of the last solve. The solver is of no use any more afterwards.
    pub(crate) fn take_field(&mut self) -> Arc<Field> {
        mem::take(&mut self.field)
    }

    /// The colour field of the last solve; an empty one where there was none.
    pub(crate) fn field(&self) -> &Arc<Field> {
        &self.field
    }

    /// What of it is not what it was at the last call.
    pub(crate) fn take_change(&mut self) -> FieldChange {
        mem::take(&mut self.change)
    }

    /// Number of triangles of the mesh.
    pub fn triangle_count(&self) -> usize {
        self.mesh.triangle_count()
    }

    /// Number of unknowns of all regions, before colours fix some of them.
    pub fn unknown_count(&self) -> usize {
        self.regions.iter().map(Region::unknown_count).sum()
    }

    /// Begins the next step of what is done. Each region keeps the system that it has now, where that is not large: undo comes
    /// back to it. It goes at the end of a step that does not change it.
    pub fn begin_step(&mut self) {
        self.regions.iter_mut().for_each(Region::begin_step);
    }

    /// Sets up the systems of the regions whose gaps or set of coloured sides changed.
    pub fn analyse(&mut self, boundary: &Boundary) {
        now(Slices::new(self.analysing(boundary)));
    }

    async fn analysing(&mut self, boundary: &Boundary) {
        self.close_gaps(&boundary.closed_gaps).await;
        let reaches = self.reaches(&boundary.sources).await;
        let mut pace = Pace::default();
        for (i, region) in (0..).zip(&mut self.regions).filter(|(_, region)| region.is_needed()) {
            let mut sources = Vec::new();
            for (source, reach) in boundary.sources.iter().zip(&reaches) {
                if reach.meets(&self.mesh, i, region.triangles()) {
                    sources.push(source.clone());
                }
                pace.work(region.triangles().len()).await;
            }
            region.analyse(&self.mesh, &boundary.sides, &sources).await;
            pace.work(region.triangles().len()).await;
        }
    }

    async fn reaches(&self, sources: &[SoftSource]) -> Vec<Reach> {
        if sources.is_empty() {
            return Vec::new();
        }
        let regions = Regions::new(&self.mesh, &mut self.regions.iter().map(Region::triangles));
        let mut reaches = Vec::with_capacity(sources.len());
        for source in sources {
            pace::pause().await;
            reaches.push(regions.reach(source));
        }
        reaches
    }

    /// Numbers the regions anew that have a part in a gap which was closed or opened.
    async fn close_gaps(&mut self, closed_gaps: &[bool]) {
        let is_changed = differences(&self.closed_gaps, closed_gaps);
        if !is_changed.contains(&true) {
            return;
        }
        self.closed_gaps = closed_gaps.to_vec();
        self.emitted.clear();
        let regions = mem::take(&mut self.regions).into_iter();
        let (touched, kept): (Vec<_>, Vec<_>) = regions.partition(|region| region.touches(&is_changed));
        let mut triangles: Vec<_> = touched.iter().flat_map(Region::triangles).copied().collect();
        sort::sort_unique(&mut triangles);
        pace::pause().await;
        self.regions = kept;
        let barriers = Barriers { mesh: &self.mesh, closed_gaps: &self.closed_gaps };
        let numbered = self.numbering.regions(barriers, &triangles).await;
        self.regions.extend(numbered.into_iter().map(Region::new));
        sort::sort_by_key(&mut self.regions, |region| {
            region.triangles().first().copied().unwrap_or_default().into()
        });
    }

    /// Factors the systems of the last analysis that are not factored yet.
    ///
    /// # Errors
    /// See [`SolveError`].
    pub fn factor(&mut self) -> Result<(), SolveError> {
        now(Slices::new(self.factoring()))
    }

    async fn factoring(&mut self) -> Result<(), SolveError> {
        let mut pace = Pace::default();
        for region in &mut self.regions {
            region.factor(&self.mesh, &mut self.memory).await?;
            pace.work(region.triangles().len()).await;
        }
        Ok(())
    }

    /// The colour field of the last analysis, factored if it is not yet; see [`MeshSolver::solve`].
    ///
    /// # Errors
    /// See [`SolveError`].
    pub fn spread(&mut self, blend: Blend) -> Result<&Field, SolveError> {
        now(self.spreading(blend))
    }

    /// The same in slices.
    ///
    /// # Errors
    /// See [`SolveError`].
    pub fn spreading(&mut self, blend: Blend) -> Slices<'_, Result<&Field, SolveError>> {
        Slices::new(self.spread_out(blend))
    }

    async fn spread_out(&mut self, blend: Blend) -> Result<&Field, SolveError> {
        Slices::new(self.factoring()).await?;
        let (mut is_changed, mut pace) = (Vec::with_capacity(self.regions.len()), Pace::default());
        for region in &mut self.regions {
            is_changed.push(region.solve().await);
            pace.work(region.triangles().len()).await;
        }
        if is_changed.contains(&true) {
            self.emit(&is_changed).await;
        }
        if self.field.blend != blend {
            Arc::make_mut(&mut self.field).blend = blend;
            self.change = FieldChange::ALL;
        }
        Ok(&self.field)
    }

    /// The colour field. The colours of the sides are in the space `blend`; every value lies within the range of the
    /// colours that are given to its region, channel by channel, and is exact where that is a single colour. Regions
    /// that are clear have no triangles.
    ///
    /// # Errors
    /// See [`SolveError`].
    pub fn solve(&mut self, boundary: &Boundary, blend: Blend) -> Result<&Field, SolveError> {
        now(self.solving(boundary, blend))
    }

    /// The same in slices. What is left of a solver that was not let finish is of no use.
    ///
    /// # Errors
    /// See [`SolveError`].
    pub fn solving<'a: 'b, 'b>(
        &'a mut self,
        boundary: &'b Boundary,
        blend: Blend,
    ) -> Slices<'b, Result<&'a Field, SolveError>> {
        Slices::new(async move {
            Slices::new(self.analysing(boundary)).await;
            self.spreading(blend).await
        })
    }

    /// Puts the triangles of the regions that changed into the field; those of the others go along to where they are now. Notes
    /// what has changed of it.
    async fn emit(&mut self, is_changed: &[bool]) {
        let counts: Vec<_> = self.regions.iter().map(Region::emitted_count).collect();
        let mut before = mem::replace(&mut self.emitted, counts);
        let are_same_regions = !before.is_empty();
        before.resize(self.emitted.len(), 0);
        let all = &mut Arc::make_mut(&mut self.field).triangles;
        self.change.add(beyond(all, self.emitted.iter().sum()));
        move_parts(all, &before, &self.emitted).await;
        pace::pause_after(all.len()).await;
        let (mut pace, mut end) = (Pace::default(), 0);
        let barriers = Barriers { mesh: &self.mesh, closed_gaps: &self.closed_gaps };
        for (i, region) in self.regions.iter_mut().enumerate() {
            let places = end..end + self.emitted[i];
            end = places.end;
            let is_new = before[i] != places.len();
            if is_changed[i] || is_new {
                let own = &mut all[places.clone()];
                let mut change = region.emit(barriers, is_new, places.start, own).await;
                if is_new && are_same_regions {
                    // What was at these places is elsewhere by now.
                    let within_du = bounds_du(&self.mesh, region.triangles());
                    change = FieldChange { places: places.start..usize::MAX, within_du };
                }
                self.change.add(change);
            }
            pace.work(places.len()).await;
        }
    }
}

/// What changes as triangles from a place on go.
fn beyond(triangles: &[FieldTriangle], end: usize) -> FieldChange {
    let mut gone = Others::none();
    for (place, triangle) in triangles.iter().enumerate().skip(end) {
        gone.add(place, &triangle.corners);
    }
    gone.change()
}

/// Makes room in a list for other parts: those that are as long as before move to where they begin now.
async fn move_parts(list: &mut Vec<FieldTriangle>, before: &[usize], now: &[usize]) {
    let total: usize = now.iter().sum();
    let missing = list.len()..total;
    list.reserve(missing.len());
    pace::for_each(missing, |_| list.push(FieldTriangle::default())).await;
    let mut starts = [0; 2];
    let mut to_the_right = Vec::new();
    for (&before, &now) in before.iter().zip(now) {
        let [from, to] = starts;
        starts = [from + before, to + now];
        if before == now && to < from {
            list.copy_within(from..from + now, to);
        } else if before == now && to > from {
            to_the_right.push((from, to, now));
        }
    }
    // From the last on, so that none is written over before it is moved.
    for (from, to, count) in to_the_right.into_iter().rev() {
        list.copy_within(from..from + count, to);
    }
    list.truncate(total);
}

/// Where two lists differ, each taken to go on with `false`.
fn differences(a: &[bool], b: &[bool]) -> Vec<bool> {
    let at = |list: &[bool], i: usize| list.get(i).copied().unwrap_or(false);
    (0..a.len().max(b.len())).map(|i| at(a, i) != at(b, i)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::{Circle, Line, Rect, Shape};
    use scumble_core::{BlendColor, Curve, Drawing, Gap, PlanarMap, Sampling};

    use crate::field::EVERYWHERE;

    /// A circle with two lines in it, with a gap between them, and a circle elsewhere.
    pub(super) fn map() -> PlanarMap {
        let circles = [(300.0, 300.0), (800.0, 800.0)].map(|at| Circle::new(at, 200.0).to_path(1e-6));
        let lines = [(100.0, 290.0), (310.0, 500.0)]
            .map(|(x0, x1)| Line::new((x0, 300.0), (x1, 300.0)).to_path(1e-6));
        let curves = circles.into_iter().chain(lines).map(|path| Curve { path, line: None }).collect();
        let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
        let map = PlanarMap::build(&drawing, &Sampling::default()).expect("a map");
        let (last, first) = (map.steps(2).last().expect("a step"), map.steps(3).first().expect("a step"));
        let nodes = [map.ends(last.left)[1], map.ends(first.left)[0]];
        map.with_gaps(vec![Gap { nodes, is_wide: false, is_plain: false, is_slight: false }])
    }

    #[test]
    fn parts_that_are_as_long_as_before_move_whatever_moves_beside_them() {
        let counts = [[2, 0], [3, 3], [0, 5], [1, 1], [4, 4], [0, 0], [9, 1], [2, 2], [1, 9], [3, 3]];
        let [before, now] = [0, 1].map(|side| counts.map(|both| both[side]));
        let part = |i: usize| FieldTriangle { side_edges: i as u32, ..FieldTriangle::default() };
        let list = |counts: &[usize]| -> Vec<_> {
            counts.iter().enumerate().flat_map(|(i, &count)| vec![part(i); count]).collect()
        };
        for [before, now] in [[before, now], [now, before]] {
            let mut moved = list(&before);
            pace::now(Slices::new(move_parts(&mut moved, &before, &now)));
            assert_eq!(moved.len(), now.iter().sum::<usize>());
            let expected = list(&now);
            let kept =
                |i: &usize| before[expected[*i].side_edges as usize] == now[expected[*i].side_edges as usize];
            (0..moved.len()).filter(kept).for_each(|i| assert_eq!(moved[i], expected[i], "{i}"));
        }
    }

    #[test]
    fn a_solver_for_one_boundary_alone_gives_the_same_field() {
        let map = map();
        // The disc elsewhere has no colour, or one that is clear, or one that is not.
        for (disc, is_paper) in [(None, true), (Some([[0.0; 4]; 3]), true), (Some([[7.0; 4]; 3]), false)] {
            let mut sides: Vec<_> = (0..map.side_count()).map(|i| Some([[i as f64; 4]; 3])).collect();
            map.steps(1).iter().for_each(|step| sides[step.left.index()] = disc);
            let boundary = Boundary { closed_gaps: vec![true], ..sides.into() };
            let once = Once { boundary: &boundary, part_du: EVERYWHERE };
            let fields = [None, Some(once)].map(|once| {
                let mut solver = now(MeshSolver::meshing(map.refined().clone(), once));
                solver.solve(&boundary, Blend::Oklab).expect("a field").triangles.clone()
            });
            assert!(!fields[0].is_empty());
            assert_eq!(fields[0].len() < map.refined().triangle_count(), is_paper);
            assert_eq!(fields[0].len(), fields[1].len());
            for (all, only) in fields[0].iter().zip(&fields[1]) {
                assert_eq!((all.corners, all.side_edges), (only.corners, only.side_edges));
                let pairs = all.colors.as_flattened().iter().zip(only.colors.as_flattened());
                pairs.for_each(|(a, b)| assert!((a - b).abs() < 1e-3, "{a} {b}"));
            }
        }
    }

    #[test]
    fn what_has_changed_of_the_field_is_the_region_that_has_other_colours_or_none() {
        let map = map();
        let mut solver = MeshSolver::new(map.refined().clone());
        let mut change = |sides: &[Option<[BlendColor; 3]>]| {
            let boundary = Boundary { closed_gaps: vec![false], ..sides.to_vec().into() };
            let count = solver.solve(&boundary, Blend::Oklab).expect("a field").triangles.len();
            (count, solver.take_change())
        };
        let mut sides = vec![Some([[0.5; 4]; 3]); map.side_count()];
        let (all, first) = change(&sides);
        assert_eq!(first.places, 0..all);
        assert_eq!(change(&sides), (all, FieldChange::default()));
        let disc = Some(Rect::new(600.0, 600.0, 1000.0, 1000.0));
        let is_disc = |change: &FieldChange| {
            let off = |a: Rect, b: Rect| (a.x0 - b.x0).abs().max((a.y1 - b.y1).abs());
            change.within_du.zip(disc).is_some_and(|(a, b)| off(a, b) < 1.0)
        };
        map.steps(1).iter().for_each(|step| sides[step.left.index()] = Some([[0.25; 4]; 3]));
        let (count, other) = change(&sides);
        assert!(count == all && other.places.len() < all && is_disc(&other), "{other:?}");
        map.steps(1).iter().for_each(|step| sides[step.left.index()] = None);
        let (count, gone) = change(&sides);
        assert!(count < all && is_disc(&gone), "{gone:?}");
        map.steps(1).iter().for_each(|step| sides[step.left.index()] = Some([[0.25; 4]; 3]));
        let (count, back) = change(&sides);
        assert!(count == all && is_disc(&back), "{back:?}");
    }

    #[test]
    fn only_the_regions_at_a_gap_lose_their_factors() {
        let map = map();
        let sides = (0..map.side_count()).map(|i| Some([[i as f64; 4]; 3])).collect::<Vec<_>>();
        let mut solver = MeshSolver::new(map.refined().clone());
        let mut factored_after = |closed: bool| {
            let boundary = Boundary { closed_gaps: vec![closed], ..sides.clone().into() };
            now(Slices::new(solver.close_gaps(&boundary.closed_gaps)));
            let kept = solver.regions.iter().filter(|region| region.is_factored()).count();
            solver.analyse(&boundary);
            solver.factor().expect("factors");
            (kept, solver.regions.len())
        };
        assert_eq!(
            [false, false, true, true, false].map(&mut factored_after),
            [(0, 3), (3, 3), (2, 4), (4, 4), (2, 3)]
        );
    }

    #[test]
    fn factors_are_kept_from_before_the_last_step_and_none_that_are_older() {
        let map = map();
        let all: Vec<_> = (0..map.side_count()).map(|i| Some([[i as f64; 4]; 3])).collect();
        let without_part_of = |curves: &[(usize, usize)]| {
            let mut sides = all.clone();
            for &(curve, parts) in curves {
                let steps = map.steps(curve);
                steps[steps.len() / parts..].iter().for_each(|step| sides[step.left.index()] = None);
            }
            Boundary::from(sides)
        };
        let [none, less, first, both, second] =
            [&[][..], &[(0, 3)], &[(0, 2)], &[(0, 2), (1, 2)], &[(1, 2)]].map(without_part_of);
        let mut solver = MeshSolver::new(map.refined().clone());
        let mut factored_for = |frames: &[&Boundary]| {
            solver.begin_step();
            let mut count = 0;
            for boundary in frames {
                solver.analyse(boundary);
                count = solver.regions.iter().filter(|region| region.is_factored()).count();
                solver.factor().expect("factors");
            }
            count
        };
        let steps =
            [&[&none][..], &[&less, &first], &[&none], &[&first], &[&both], &[&first], &[&both], &[&second]];
        assert_eq!(steps.map(&mut factored_for), [0, 2, 3, 3, 2, 3, 3, 2]);
    }
}
