//! The elements of a region: those of the mesh, or finer ones where sources shade it; and their system.

use std::mem;

use kurbo::Point;
use scumble_core::{BlendColor, SoftSource, Triangulation};

use super::SolveError;
use super::dofs::Dofs;
use super::element::{self, Matrix};
use super::order::elimination_rank;
use super::refine::{self, Shape};
use super::system::{Element, System};
use crate::brush::{self, Brush};

/// Elements, and their system once one is needed.
#[derive(Debug)]
pub(super) struct Elements {
    pub(super) dofs: Dofs,
    shade: Option<Shade>,
    /// Whether the unknowns are in the order of elimination.
    is_ordered: bool,
    /// The last system, and which sides were coloured then; `None` also where it does not fit into memory.
    system: Option<(Vec<bool>, System)>,
}

/// What sources make of the elements of a region.
#[derive(Debug)]
struct Shade {
    shapes: Vec<Shape>,
    /// By the element, in ascending order.
    masses: Vec<(u32, Matrix)>,
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
        Self { dofs, shade: None, is_ordered: false, system: None }
    }

    /// Those that sources need in a region of the mesh, which may be paper.
    pub(super) fn shaded(mesh: &Triangulation, dofs: &Dofs, sources: &[SoftSource], is_paper: bool) -> Self {
        let brushes: Vec<_> = sources.iter().map(Brush::new).collect();
        let refined = refine::refine(mesh, dofs, &brushes);
        let mut shade = Shade { shapes: refined.shapes, masses: Vec::new(), loads: Vec::new() };
        shade.shade(&brushes);
        if is_paper {
            shade.fade(&brushes);
        }
        Self { shade: Some(shade), ..Self::new(refined.dofs) }
    }

    pub(super) fn corners(&self, mesh: &Triangulation, element: usize) -> [Point; 3] {
        match &self.shade {
            None => mesh.corners(self.dofs.triangles[element] as usize),
            Some(shade) => shade.shapes[element].corners,
        }
    }

    /// The edges of an element that bound the region, where it is not one of the mesh.
    pub(super) fn side_edges(&self, element: usize) -> Option<u32> {
        self.shade.as_ref().map(|shade| shade.shapes[element].side_edges)
    }

    /// Sets the system up if the coloured sides are others than those of the last one.
    pub(super) fn analyse(&mut self, mesh: &Triangulation, is_colored: &[bool]) {
        if self.system.as_ref().is_none_or(|(sides, _)| sides != is_colored) {
            self.system = self.new_system(mesh, is_colored).ok().map(|system| (is_colored.to_vec(), system));
        }
    }

    /// The system as of the last analysis.
    pub(super) fn system(&self) -> Option<&System> {
        self.system.as_ref().map(|(_, system)| system)
    }

    /// Factors the system if that is not done yet.
    pub(super) fn factor(&mut self) -> Result<(), SolveError> {
        self.system.as_mut().ok_or(SolveError::TooLarge)?.1.factor()
    }

    /// What sources of some colours add to the right-hand side: an unknown, and how much.
    pub(super) fn loads(&self, sources: &[SoftSource]) -> impl Iterator<Item = (u32, BlendColor)> {
        let loads = self.shade.iter().flat_map(|shade| &shade.loads);
        loads.flat_map(|load| {
            let dofs = self.dofs.of_triangle[load.element as usize];
            let color = sources[load.source as usize].color;
            dofs.into_iter().zip(load.values).map(move |(dof, value)| (dof, color.map(|c| value * c)))
        })
    }

    fn new_system(&mut self, mesh: &Triangulation, is_colored: &[bool]) -> Result<System, SolveError> {
        if !self.is_ordered {
            self.dofs.renumber(&elimination_rank(&self.dofs)?);
            self.is_ordered = true;
        }
        let mut fixed = vec![false; self.dofs.count];
        for (side, _) in self.dofs.sides.iter().zip(is_colored).filter(|(_, is_colored)| **is_colored) {
            side.dofs.iter().for_each(|&dof| fixed[dof as usize] = true);
        }
        let mut masses = self.shade.iter().flat_map(|shade| &shade.masses).peekable();
        let mut elements = self.dofs.of_triangle.iter().enumerate().map(|(i, &dofs)| Element {
            corners: self.corners(mesh, i),
            dofs,
            mass: masses.next_if(|(element, _)| *element as usize == i).map(|(_, mass)| mass),
        });
        Ok(System::new(&mut elements, &fixed))
    }
}

impl Shade {
    /// Adds the pull of the paper to all elements.
    fn fade(&mut self, brushes: &[Brush]) {
        let strength = brush::fade_strength(brushes.iter());
        let mut known = mem::take(&mut self.masses).into_iter().peekable();
        for (element, shape) in (0..).zip(&self.shapes) {
            let mut mass = element::mass(shape.corners, &|_| strength);
            if let Some((_, known)) = known.next_if(|(known, _)| *known == element) {
                add(&mut mass, &known);
            }
            self.masses.push((element, mass));
        }
    }

    /// Integrates what the sources add, over each element in turn.
    fn shade(&mut self, brushes: &[Brush]) {
        let mut near = Vec::new();
        for (element, shape) in (0..).zip(&self.shapes) {
            let [a, b, c] = shape.corners.map(Point::to_vec2);
            let middle = ((a + b + c) / 3.0).to_point();
            let reach_du =
                shape.corners.map(|corner| corner.distance(middle)).into_iter().fold(0.0, f64::max);
            for (source, brush) in (0..).zip(brushes) {
                brush.near(middle, reach_du, &mut near);
                if near.is_empty() {
                    continue;
                }
                let mass = element::mass(shape.corners, &|p| brush.strength(p, &near));
                self.loads.push(Load { element, source, values: mass.map(|row| row.iter().sum()) });
                match self.masses.last_mut() {
                    Some((last, sum)) if *last == element => add(sum, &mass),
                    _ => self.masses.push((element, mass)),
                }
            }
        }
    }
}

fn add(sum: &mut Matrix, mass: &Matrix) {
    sum.as_flattened_mut().iter_mut().zip(mass.as_flattened()).for_each(|(sum, entry)| *sum += entry);
}
