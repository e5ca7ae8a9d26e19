//! The layer that sources lay over a region: its finer elements, their system, and what it covers.
//!
//! The elements of the region are made finer under the strokes; those that a layer reaches have a system of their own, with
//! nothing at its rim within the region and no flux through lines. It depends on neither the colours of sides nor which sides have
//! one.

use std::{array, iter};

use kurbo::Point;
use scumble_core::{BlendColor, SoftSource};

use super::SolveError;
use super::cells::Cells;
use super::dofs::{NONE, Unknowns};
use super::element::{self, Matrix, PLACES, Quadrature};
use super::refine::{self, Refined, Shape};
use super::system::System;
use crate::brush::{self, Brush, Segment};

/// A layer over a region.
#[derive(Debug)]
pub(super) struct Layer {
    sources: Vec<SoftSource>,
    /// All elements of the region.
    pub(super) shapes: Vec<Shape>,
    patch: Patch,
    system: System,
    /// By the unknown of the patch.
    covers: Vec<Cover>,
    is_solved: bool,
}

/// What a layer has at a place.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Cover {
    /// Blend-space colour times opacity, and opacity, times how much it covers.
    color: BlendColor,
    /// How much it covers, from 0 to 1.
    part: f64,
}

/// The elements that a layer reaches.
#[derive(Debug, Default)]
struct Patch {
    /// By the element of the region, which of the patch it is, or [`NONE`].
    of_shape: Vec<u32>,
    corners: Vec<[Point; 3]>,
    /// The six unknowns of each.
    dofs: Vec<[u32; 6]>,
    masses: Vec<Matrix>,
    loads: Vec<Load>,
}

/// What a source of value one adds to the right-hand side.
#[derive(Clone, Copy, Debug)]
struct Load {
    element: u32,
    source: u32,
    /// At its six unknowns.
    values: [f64; 6],
}

impl Layer {
    /// That of sources over a region of some cells.
    pub(super) fn new(coarse: &Cells, sources: Vec<SoftSource>) -> Self {
        let brushes: Vec<_> = sources.iter().map(Brush::new).collect();
        let Refined { shapes, dofs, dof_count } = refine::refine(coarse, &brushes);
        let mut patch = Patch { of_shape: vec![NONE; shapes.len()], ..Patch::default() };
        patch.integrate(&brushes, &shapes, &dofs);
        let mut numbered = Unknowns::of_elements(patch.dofs.clone());
        numbered.order();
        let is_fixed = patch.rim(&dofs, dof_count, &numbered);
        let system = System::new(&numbered, &|i| patch.matrix(i), &is_fixed);
        patch.dofs = numbered.of_element;
        Self { sources, shapes, patch, system, covers: Vec::new(), is_solved: false }
    }

    /// Number of its unknowns.
    pub(super) fn unknown_count(&self) -> usize {
        self.system.places().len()
    }

    /// Whether it is that of some sources.
    pub(super) fn is_of(&self, sources: &[SoftSource]) -> bool {
        self.sources == sources
    }

    /// Takes other colours, if nothing but these is another; `false` where more is.
    pub(super) fn recolor(&mut self, sources: &[SoftSource]) -> bool {
        let is_alike = |before: &SoftSource, after: &SoftSource| {
            *before == SoftSource { color: before.color, ..after.clone() }
        };
        let are_alike = self.sources.len() == sources.len()
            && self.sources.iter().zip(sources).all(|(before, after)| is_alike(before, after));
        if are_alike {
            self.sources = sources.to_vec();
            self.is_solved = false;
        }
        are_alike
    }

    /// The colours of its sources.
    pub(super) fn colors(&self) -> impl Iterator<Item = BlendColor> {
        self.sources.iter().map(|source| source.color)
    }

    /// Factors the system if that is not done yet.
    pub(super) fn factor(&mut self, memory: &mut Vec<f64>) -> Result<(), SolveError> {
        let patch = &self.patch;
        self.system.factor(&|i| patch.matrix(i), memory)
    }

    /// The memory of the factor.
    pub(super) fn into_memory(self) -> Option<Vec<f64>> {
        self.system.into_memory()
    }

    /// Computes what it covers if that is not known, and says whether it was not. The system is factored.
    pub(super) fn solve(&mut self) -> bool {
        let is_new = !self.is_solved;
        if is_new {
            let colors = self.values(|source| source.color);
            let is_opaque = self.sources.iter().all(|source| source.color[3] == 1.0);
            // Where all is opaque, opacity is cover.
            let parts = if is_opaque { colors.clone() } else { self.values(|_| [1.0; 4]) };
            let cover =
                |(color, part): (BlendColor, BlendColor)| Cover { color, part: part[3].clamp(0.0, 1.0) };
            self.covers = colors.into_iter().zip(parts).map(cover).collect();
            self.is_solved = true;
        }
        is_new
    }

    /// The values at the unknowns, where each source has a value.
    fn values(&self, value: impl Fn(&SoftSource) -> BlendColor) -> Vec<BlendColor> {
        let loads = self.patch.loads.iter().map(|load| {
            let dofs = self.patch.dofs[load.element as usize];
            (dofs, load.values, value(&self.sources[load.source as usize]))
        });
        let values = self.system.solve(iter::empty(), loads).unwrap_or_default();
        self.system.places().iter().filter_map(|&place| values.get(place as usize).copied()).collect()
    }

    /// What it has at the six places of an element of the region; `None` where it does not reach it.
    pub(super) fn covers(&self, element: usize) -> Option<[Cover; 6]> {
        let dofs = self.patch.dofs.get(self.patch.of_shape[element] as usize)?;
        Some(dofs.map(|dof| self.covers[dof as usize]))
    }
}

impl Cover {
    /// Whether it covers anything.
    pub(super) fn is_any(&self) -> bool {
        self.part > 0.0
    }

    /// What is seen where it lies over something.
    pub(super) fn over(&self, under: BlendColor) -> BlendColor {
        [0, 1, 2, 3].map(|i| (1.0 - self.part) * under[i] + self.color[i])
    }
}

impl Patch {
    /// Integrates what the sources do, over each element in turn.
    fn integrate(&mut self, brushes: &[Brush], shapes: &[Shape], dofs: &[[u32; 6]]) {
        let quadrature = Quadrature::new();
        let mut near = vec![Vec::new(); brushes.len()];
        for (i, shape) in shapes.iter().enumerate() {
            find_near(brushes, shape.corners, &mut near);
            if near.iter().all(Vec::is_empty) {
                continue;
            }
            self.of_shape[i] = self.corners.len() as u32;
            self.dofs.push(dofs[i]);
            let factors = self.pull(&quadrature, brushes, &near, shape.corners);
            self.masses.push(quadrature.mass(shape.corners, &factors));
            self.corners.push(shape.corners);
        }
    }

    /// Adds the loads of the sources on the next element; and the factor of `u` in the equation where the rule needs it.
    fn pull(
        &mut self,
        quadrature: &Quadrature,
        brushes: &[Brush],
        near: &[Vec<Segment>],
        corners: [Point; 3],
    ) -> [f64; PLACES] {
        let element = self.corners.len() as u32;
        let places = quadrature.places(corners);
        let (mut factors, mut lengths_du) = ([0.0; PLACES], [0.0_f64; PLACES]);
        for ((source, brush), near) in (0..).zip(brushes).zip(near).filter(|(_, near)| !near.is_empty()) {
            let pulls = places.map(|p| brush.pull(p, near));
            let strengths = pulls.map(|pull| pull.strength);
            if strengths != [0.0; PLACES] {
                let values = quadrature.load(corners, &strengths);
                self.loads.push(Load { element, source, values });
            }
            for k in 0..PLACES {
                factors[k] += strengths[k];
                lengths_du[k] = lengths_du[k].max(pulls[k].length_du);
            }
        }
        array::from_fn(|k| factors[k] + (lengths_du[k] * lengths_du[k]).recip())
    }

    /// Which of its unknowns, as they are numbered now, are those of elements beyond it too.
    fn rim(&self, all: &[[u32; 6]], count: usize, numbered: &Unknowns) -> Vec<bool> {
        let mut is_beyond = vec![false; count];
        let beyond = all.iter().zip(&self.of_shape).filter(|(_, of_patch)| **of_patch == NONE);
        beyond.flat_map(|(dofs, _)| dofs).for_each(|&dof| is_beyond[dof as usize] = true);
        let mut is_rim = vec![false; numbered.count];
        let numbers = numbered.of_element.as_flattened().iter().zip(self.dofs.as_flattened());
        numbers.for_each(|(&number, &dof)| is_rim[number as usize] = is_beyond[dof as usize]);
        is_rim
    }

    /// What an element adds to the matrix.
    fn matrix(&self, element: usize) -> Matrix {
        let mut matrix = element::stiffness(self.corners[element]);
        add(&mut matrix, &self.masses[element]);
        matrix
    }
}

/// The segments of each brush that count in a triangle.
fn find_near(brushes: &[Brush], corners: [Point; 3], near: &mut [Vec<Segment>]) {
    let (middle, spread_du) = brush::around(corners);
    brushes.iter().zip(near).for_each(|(brush, near)| brush.near(middle, spread_du, near));
}

fn add(sum: &mut Matrix, other: &Matrix) {
    sum.iter_mut().zip(other).for_each(|(sum, entry)| *sum += entry);
}
