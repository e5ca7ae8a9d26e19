//! The elements of a region: those of the mesh, or finer ones where sources shade it; and their system.

use kurbo::Point;
use scumble_core::{BlendColor, SoftSource, Triangulation};

use super::SolveError;
use super::cells::Cells;
use super::dofs::{Dofs, NONE};
use super::element::{self, Matrix, Quadrature};
use super::refine::{self, Shape};
use super::system::System;
use crate::brush::{self, Brush};

/// Elements, and their system once one is needed.
#[derive(Debug)]
pub(super) struct Elements {
    pub(super) dofs: Dofs,
    shade: Option<Shade>,
    /// The last system, and which sides were coloured then.
    system: Option<(Vec<bool>, System)>,
}

/// What sources make of the elements of a region.
#[derive(Debug)]
struct Shade {
    shapes: Vec<Shape>,
    /// By the element, where its mass is, or [`NONE`].
    mass_of: Vec<u32>,
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

impl Elements {
    /// Those of the mesh.
    pub(super) fn new(dofs: Dofs) -> Self {
        Self { dofs, shade: None, system: None }
    }

    /// Those that sources need in a region of some cells, which may be paper.
    pub(super) fn shaded(coarse: &Cells, dofs: &Dofs, sources: &[SoftSource], is_paper: bool) -> Self {
        let brushes: Vec<_> = sources.iter().map(Brush::new).collect();
        let refined = refine::refine(coarse, dofs, &brushes);
        let (mass_of, finer) =
            (vec![NONE; refined.shapes.len()], refined.shapes.len() - dofs.triangles.len());
        let (masses, loads) = (Vec::with_capacity(finer), Vec::with_capacity(finer));
        let mut shade = Shade { shapes: refined.shapes, mass_of, masses, loads };
        shade.shade(&brushes);
        if is_paper {
            shade.fade(&brushes);
        }
        Self { shade: Some(shade), ..Self::new(refined.dofs) }
    }

    pub(super) fn corners(&self, mesh: &Triangulation, element: usize) -> [Point; 3] {
        corners(mesh, &self.dofs, self.shade.as_ref(), element)
    }

    /// The edges of an element that bound the region, where it is not one of the mesh.
    pub(super) fn side_edges(&self, element: usize) -> Option<u32> {
        self.shade.as_ref().map(|shade| shade.shapes[element].side_edges)
    }

    /// Sets the system up if the coloured sides are others than those of the last one.
    pub(super) fn analyse(&mut self, mesh: &Triangulation, is_colored: &[bool]) {
        if self.system.as_ref().is_none_or(|(sides, _)| sides != is_colored) {
            self.system = Some((is_colored.to_vec(), self.new_system(mesh, is_colored)));
        }
    }

    /// The system as of the last analysis.
    pub(super) fn system(&self) -> Option<&System> {
        self.system.as_ref().map(|(_, system)| system)
    }

    /// Factors the system if that is not done yet.
    pub(super) fn factor(&mut self, mesh: &Triangulation, memory: &mut Vec<f64>) -> Result<(), SolveError> {
        let (dofs, shade) = (&self.dofs, self.shade.as_ref());
        let system = self.system.as_mut().map(|(_, system)| system);
        system.map_or(Ok(()), |system| system.factor(&|i| matrix(mesh, dofs, shade, i), memory))
    }

    /// The memory of the factor.
    pub(super) fn into_memory(self) -> Option<Vec<f64>> {
        self.system.and_then(|(_, system)| system.into_memory())
    }

    /// What sources of some colours add to the right-hand side, element by element: its unknowns, what each has of the colour,
    /// and that.
    pub(super) fn loads(
        &self,
        sources: &[SoftSource],
    ) -> impl Iterator<Item = ([u32; 6], [f64; 6], BlendColor)> {
        let loads = self.shade.iter().flat_map(|shade| &shade.loads);
        loads.map(|load| {
            let dofs = self.dofs.of_triangle[load.element as usize];
            (dofs, load.values, sources[load.source as usize].color)
        })
    }

    fn new_system(&mut self, mesh: &Triangulation, is_colored: &[bool]) -> System {
        self.dofs.order();
        let mut fixed = vec![false; self.dofs.count];
        for (side, _) in self.dofs.sides.iter().zip(is_colored).filter(|(_, is_colored)| **is_colored) {
            side.dofs.iter().for_each(|&dof| fixed[dof as usize] = true);
        }
        let (dofs, shade) = (&self.dofs, self.shade.as_ref());
        System::new(dofs, &|i| matrix(mesh, dofs, shade, i), &fixed)
    }
}

fn corners(mesh: &Triangulation, dofs: &Dofs, shade: Option<&Shade>, element: usize) -> [Point; 3] {
    match shade {
        None => mesh.corners(dofs.triangles[element] as usize),
        Some(shade) => shade.shapes[element].corners,
    }
}

/// What an element adds to the matrix.
fn matrix(mesh: &Triangulation, dofs: &Dofs, shade: Option<&Shade>, element: usize) -> Matrix {
    let mut matrix = element::stiffness(corners(mesh, dofs, shade, element));
    if let Some(mass) = shade.and_then(|shade| shade.mass(element)) {
        add(&mut matrix, mass);
    }
    matrix
}

impl Shade {
    fn mass(&self, element: usize) -> Option<&Matrix> {
        self.masses.get(self.mass_of[element] as usize)
    }

    fn add_mass(&mut self, element: usize, mass: Matrix) {
        match self.masses.get_mut(self.mass_of[element] as usize) {
            Some(sum) => add(sum, &mass),
            None => {
                self.mass_of[element] = self.masses.len() as u32;
                self.masses.push(mass);
            }
        }
    }

    /// Adds the pull of the paper to all elements.
    fn fade(&mut self, brushes: &[Brush]) {
        let quadrature = Quadrature::new();
        let strength = brush::fade_strength(brushes.iter());
        for element in 0..self.shapes.len() {
            let mass = quadrature.mass(self.shapes[element].corners, &|_| strength);
            self.add_mass(element, mass);
        }
    }

    /// Integrates what the sources add, over each element in turn.
    fn shade(&mut self, brushes: &[Brush]) {
        let quadrature = Quadrature::new();
        let mut near = Vec::new();
        for element in 0..self.shapes.len() {
            let corners = self.shapes[element].corners;
            let [a, b, c] = corners.map(Point::to_vec2);
            let middle = ((a + b + c) / 3.0).to_point();
            let reach_du = corners.map(|corner| corner.distance(middle)).into_iter().fold(0.0, f64::max);
            for (source, brush) in (0..).zip(brushes) {
                brush.near(middle, reach_du, &mut near);
                if near.is_empty() {
                    continue;
                }
                let mass = quadrature.mass(corners, &|p| brush.strength(p, &near));
                let load = Load { element: element as u32, source, values: element::row_sums(&mass) };
                self.loads.push(load);
                self.add_mass(element, mass);
            }
        }
    }
}

fn add(sum: &mut Matrix, other: &Matrix) {
    sum.iter_mut().zip(other).for_each(|(sum, entry)| *sum += entry);
}
