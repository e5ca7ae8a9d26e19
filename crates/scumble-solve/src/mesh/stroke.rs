//! How much one stroke of a soft brush covers: the equation of a source on the elements that it reaches.
//!
//! They have a system of their own, with nothing at its rim within the region and no flux through lines. It knows no
//! colours, so it is solved once, wherever the stroke is and whatever others are beside it.

use std::{array, iter, mem};

use kurbo::Point;
use scumble_core::SoftSource;
use scumble_core::pace;

use super::SolveError;
use super::dofs::Unknowns;
use super::element::{self, Matrix, PLACES, Quadrature};
use super::refine::Refined;
use super::substitution::TileColumn;
use super::system::System;
use crate::brush::{self, Brush, Segment};

/// A stroke in a region.
#[derive(Debug)]
pub(super) struct Stroke {
    source: SoftSource,
    /// The elements that it reaches.
    corners: Vec<[Point; 3]>,
    /// Their unknowns, each once, by the numbers that the region has for them.
    dofs: Vec<u32>,
    /// What there is to solve, until it is solved.
    problem: Option<Problem>,
    /// How much it covers at these unknowns, from 0 to 1.
    covers: Vec<f64>,
}

/// A system, and what is on its right-hand side.
#[derive(Debug)]
struct Problem {
    system: System,
    masses: Vec<Matrix>,
    /// Where in the system the unknowns are.
    places: Vec<u32>,
    loads: Vec<Load>,
}

/// What an element adds to the right-hand side at its six unknowns.
type Load = ([u32; 6], [f64; 6]);

/// The elements that a stroke reaches: where each is in the region, and the six unknowns of each.
#[derive(Default)]
struct Patch {
    elements: Vec<u32>,
    corners: Vec<[Point; 3]>,
    dofs: Vec<[u32; 6]>,
}

impl Stroke {
    /// The stroke of a source in a refined region; one of those that there were before, where nothing of it has changed but its
    /// colour.
    pub(super) async fn new(
        source: &SoftSource,
        region: &Refined,
        before: &mut Vec<Self>,
        seen: &mut Seen,
    ) -> Self {
        let brush = Brush::new(source);
        let patch = Patch::new(&brush, region).await;
        let dofs = seen.distinct(&patch.dofs);
        let is_same = |stroke: &Self| stroke.is_alike(source) && stroke.corners == patch.corners;
        let known = before.iter().position(is_same).map(|i| before.swap_remove(i));
        let source = source.clone();
        match known {
            Some(known) => Self { source, dofs, ..known },
            None => {
                let problem = Some(Problem::new(&brush, &patch, &dofs, region).await);
                Self { source, corners: patch.corners, dofs, problem, covers: Vec::new() }
            }
        }
    }

    /// Whether a source differs from its own in nothing but the colour.
    pub(super) fn is_alike(&self, source: &SoftSource) -> bool {
        self.source.is_alike(source)
    }

    pub(super) fn recolor(&mut self, source: &SoftSource) {
        self.source.color = source.color;
    }

    pub(super) fn unknown_count(&self) -> usize {
        self.dofs.len()
    }

    pub(super) fn source(&self) -> &SoftSource {
        &self.source
    }

    /// The numbers of the unknowns that it reaches, and how much it covers there.
    pub(super) fn covers(&self) -> impl Iterator<Item = (u32, f64)> {
        self.dofs.iter().copied().zip(self.covers.iter().copied())
    }

    /// Solves what is not solved yet, in some memory for a factor. What fails is there to fail again: a stroke that could not be
    /// solved is never taken for one that covers nothing.
    pub(super) async fn solve(&mut self, memory: &mut Vec<TileColumn>) -> Result<(), SolveError> {
        if let Some(problem) = &mut self.problem {
            problem.factor(&self.corners, memory).await?;
        }
        if let Some(problem) = self.problem.take() {
            self.covers = problem.solve(memory).await;
        }
        Ok(())
    }
}

/// Which list each unknown of a region has been seen in last.
#[derive(Debug)]
pub(super) struct Seen {
    lists: Vec<u32>,
    list: u32,
}

impl Seen {
    pub(super) fn new(dof_count: usize) -> Self {
        Self { lists: vec![0; dof_count], list: 0 }
    }

    /// Each number of another list, in the order of their first place.
    fn distinct(&mut self, dofs: &[[u32; 6]]) -> Vec<u32> {
        self.list += 1;
        let is_new = |&dof: &u32| mem::replace(&mut self.lists[dof as usize], self.list) != self.list;
        dofs.as_flattened().iter().copied().filter(is_new).collect()
    }
}

impl Patch {
    async fn new(brush: &Brush, region: &Refined) -> Self {
        let mut patch = Self::default();
        let mut near = Vec::new();
        pace::for_each(region.near(brush.bounds()), |i| {
            let (middle, spread_du) = region.circles[i];
            brush.near(middle, spread_du, &mut near);
            if !near.is_empty() {
                patch.elements.push(i as u32);
                patch.corners.push(region.shapes[i].corners);
                patch.dofs.push(region.dofs[i]);
            }
        })
        .await;
        patch
    }

    /// Which unknowns of the region are those of elements beyond it.
    fn is_beyond(&self, region: &Refined) -> Vec<bool> {
        let mut is_beyond = vec![false; region.dof_count];
        let mut own = self.elements.iter().peekable();
        for (i, dofs) in (0..).zip(&region.dofs) {
            if own.next_if_eq(&&i).is_none() {
                dofs.iter().for_each(|&dof| is_beyond[dof as usize] = true);
            }
        }
        is_beyond
    }
}

impl Problem {
    async fn new(brush: &Brush, patch: &Patch, dofs: &[u32], region: &Refined) -> Self {
        let (masses, loads) = integrals(brush, &patch.corners).await;
        let mut unknowns = Unknowns::of_elements(patch.dofs.clone());
        unknowns.order();
        let mut place_of = vec![0; region.dof_count];
        let numbers = unknowns.of_element.as_flattened().iter().zip(patch.dofs.as_flattened());
        numbers.for_each(|(&number, &dof)| place_of[dof as usize] = number);
        let is_beyond = patch.is_beyond(region);
        let mut is_rim = vec![false; unknowns.count];
        dofs.iter().for_each(|&dof| is_rim[place_of[dof as usize] as usize] = is_beyond[dof as usize]);
        let system = System::new(&unknowns, &is_rim).await;
        let loads =
            loads.into_iter().map(|(element, values)| (unknowns.of_element[element], values)).collect();
        let places = dofs.iter().map(|&dof| place_of[dof as usize]).collect();
        Self { system, masses, places, loads }
    }

    async fn factor(
        &mut self,
        corners: &[[Point; 3]],
        memory: &mut Vec<TileColumn>,
    ) -> Result<(), SolveError> {
        let masses = &self.masses;
        self.system.factor(&|i| matrix(corners, masses, i), memory).await
    }

    /// How much is covered at the unknowns; gives the memory of the factor back. It is factored.
    async fn solve(self, memory: &mut Vec<TileColumn>) -> Vec<f64> {
        let loads = self.loads.iter().map(|&(dofs, values)| (dofs, values, [1.0, 0.0, 0.0, 0.0]));
        let sums = self.system.right_hand_sides(iter::empty(), loads);
        let values = self.system.solve(sums).await.unwrap_or_default();
        let places = self.system.places();
        let cover = |&place: &u32| {
            values
                .get(places[place as usize] as usize)
                .map_or(0.0, |value| f64::from(value[0].clamp(0.0, 1.0)))
        };
        let covers = self.places.iter().map(cover).collect();
        *memory = self.system.into_memory().unwrap_or_default();
        covers
    }
}

/// What the terms of the equation besides Laplace's are on each element; and on the right-hand side, where that is anything.
async fn integrals(brush: &Brush, corners: &[[Point; 3]]) -> (Vec<Matrix>, Vec<(usize, [f64; 6])>) {
    let quadrature = Quadrature::new();
    let (mut near, mut loads) = (Vec::new(), Vec::new());
    let mut masses = Vec::with_capacity(corners.len());
    pace::for_each(corners.iter().enumerate(), |(i, &corners)| {
        let (middle, spread_du) = brush::around(corners);
        brush.near(middle, spread_du, &mut near);
        let pulls = quadrature.places(corners).map(|p| pull(brush, p, &near));
        let strengths = pulls.map(|[strength, _]| strength);
        if strengths != [0.0; PLACES] {
            loads.push((i, quadrature.load(corners, &strengths)));
        }
        masses.push(quadrature.mass(corners, &array::from_fn(|k| pulls[k][0] + pulls[k][1])));
    })
    .await;
    (masses, loads)
}

/// How strongly a place is drawn to be covered and not to be, in 1/du².
fn pull(brush: &Brush, p: Point, near: &[Segment]) -> [f64; 2] {
    let pull = brush.pull(p, near);
    [pull.strength, (pull.length_du * pull.length_du).recip()]
}

/// What an element adds to the matrix.
fn matrix(corners: &[[Point; 3]], masses: &[Matrix], element: usize) -> Matrix {
    let mut matrix = element::stiffness(corners[element]);
    matrix.iter_mut().zip(&masses[element]).for_each(|(sum, entry)| *sum += entry);
    matrix
}
