//! One region: its coloured sides, its system, and the values of its unknowns.

use scumble_core::{BlendColor, HalfEdge, SideColors, Triangulation};

use super::SolveError;
use super::barriers::Barriers;
use super::dofs::Dofs;
use super::order::elimination_rank;
use super::system::System;
use crate::field::FieldTriangle;

/// A region and what is known about it so far.
#[derive(Debug)]
pub(super) struct Region {
    dofs: Dofs,
    /// Whether the unknowns are in the order of elimination.
    is_ordered: bool,
    /// The colours of its sides, as of the last look at them.
    given: Vec<Option<[BlendColor; 3]>>,
    coloring: Coloring,
    /// The last system, and which sides were coloured then; `None` also where it does not fit into memory.
    system: Option<(Vec<bool>, System)>,
    /// The colour of each unknown, where the region is neither paper nor flat.
    values: Vec<[f32; 4]>,
    is_solved: bool,
}

/// How much there is to solve.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Coloring {
    /// No side has a colour, or all are clear.
    Paper,
    /// All given colours are the same.
    Flat(BlendColor),
    /// Colours run into each other.
    Blended,
}

impl Region {
    pub(super) fn new(dofs: Dofs) -> Self {
        let given = vec![None; dofs.sides.len()];
        Self {
            dofs,
            is_ordered: false,
            given,
            coloring: Coloring::Paper,
            system: None,
            values: Vec::new(),
            is_solved: false,
        }
    }

    /// Its triangles, in ascending order; one at least.
    pub(super) fn triangles(&self) -> &[u32] {
        &self.dofs.triangles
    }

    /// Whether it has a part in one of the gaps that are marked.
    pub(super) fn touches(&self, is_marked: &[bool]) -> bool {
        self.dofs.gaps.iter().any(|&gap| is_marked.get(gap as usize).copied().unwrap_or(false))
    }

    pub(super) fn unknown_count(&self) -> usize {
        self.dofs.count
    }

    #[cfg(test)]
    pub(super) fn is_factored(&self) -> bool {
        self.system.as_ref().is_some_and(|(_, system)| system.is_factored())
    }

    /// Takes in the colours; sets up the system if it is needed and the set of coloured sides is another one.
    pub(super) fn analyse(&mut self, mesh: &Triangulation, colors: &SideColors) {
        let sides = self.dofs.sides.iter();
        let given: Vec<_> = sides.map(|(side, _)| colors.get(side.index()).copied().flatten()).collect();
        if given != self.given {
            self.given = given;
            self.coloring = coloring(&self.given);
            self.is_solved = false;
        }
        let is_colored = || self.given.iter().map(Option::is_some);
        if self.coloring == Coloring::Blended
            && self.system.as_ref().is_none_or(|(sides, _)| !is_colored().eq(sides.iter().copied()))
        {
            let sides = is_colored().collect();
            self.system = self.new_system(mesh).ok().map(|system| (sides, system));
        }
    }

    /// Factors the system if one is needed and not factored yet.
    pub(super) fn factor(&mut self) -> Result<(), SolveError> {
        match (self.coloring, &mut self.system) {
            (Coloring::Blended, Some((_, system))) => system.factor(),
            (Coloring::Blended, None) => Err(SolveError::TooLarge),
            _ => Ok(()),
        }
    }

    /// Computes the values if the colours changed, and says whether they did. The system is factored.
    ///
    /// A channel of one value is not solved for: in opaque regions the opacity costs nothing.
    pub(super) fn solve(&mut self) -> bool {
        let changed = !self.is_solved;
        if let (true, Coloring::Blended, Some((_, system))) = (changed, self.coloring, &self.system) {
            let mut values = self.fixed_values();
            let [least, most] = self.range();
            let channels: Vec<_> = (0..4).filter(|&i| least[i] != most[i]).collect();
            system.solve(&mut values, &channels);
            let clamp = |value: BlendColor| [0, 1, 2, 3].map(|i| value[i].max(least[i]).min(most[i]) as f32);
            self.values = values.into_iter().map(clamp).collect();
        }
        self.is_solved = true;
        changed
    }

    /// Adds the triangles of a coloured region.
    pub(super) fn emit(&self, barriers: Barriers<'_>, triangles: &mut Vec<FieldTriangle>) {
        let color = |dof: u32| self.values[dof as usize];
        let colors = |dofs: &[u32; 6]| match self.coloring {
            Coloring::Flat(color) => [color.map(|c| c as f32); 6],
            _ => dofs.map(color),
        };
        if self.coloring != Coloring::Paper {
            let pairs = self.dofs.triangles.iter().zip(&self.dofs.of_triangle);
            triangles.extend(pairs.map(|(&t, dofs)| field_triangle(barriers, t as usize, colors(dofs))));
        }
    }

    fn new_system(&mut self, mesh: &Triangulation) -> Result<System, SolveError> {
        if !self.is_ordered {
            self.dofs.renumber(&elimination_rank(&self.dofs)?);
            self.is_ordered = true;
        }
        System::new(mesh, &self.dofs, &self.fixed())
    }

    /// The unknowns of the coloured sides, with their colours.
    fn conditions(&self) -> impl Iterator<Item = (usize, BlendColor)> {
        let sides = self.dofs.sides.iter().zip(&self.given);
        sides.flat_map(|((_, dofs), given)| {
            given.iter().flat_map(|colors| dofs.iter().map(|&dof| dof as usize).zip(*colors))
        })
    }

    fn fixed(&self) -> Vec<bool> {
        let mut fixed = vec![false; self.dofs.count];
        self.conditions().for_each(|(dof, _)| fixed[dof] = true);
        fixed
    }

    /// The values of the fixed unknowns: the mean, where two sides meet with different colours.
    fn fixed_values(&self) -> Vec<BlendColor> {
        let mut values = vec![None; self.dofs.count];
        for (dof, color) in self.conditions() {
            values[dof] = Some(values[dof].map_or(color, |other| mean(other, color)));
        }
        values.into_iter().map(Option::unwrap_or_default).collect()
    }

    /// The least and the greatest value given, channel by channel.
    fn range(&self) -> [BlendColor; 2] {
        let start = [[f64::INFINITY; 4], [f64::NEG_INFINITY; 4]];
        self.conditions().fold(start, |[least, most], (_, color)| {
            [[0, 1, 2, 3].map(|i| color[i].min(least[i])), [0, 1, 2, 3].map(|i| color[i].max(most[i]))]
        })
    }
}

fn coloring(given: &[Option<[BlendColor; 3]>]) -> Coloring {
    let mut colors = given.iter().flatten().flatten();
    match colors.next() {
        None => Coloring::Paper,
        Some(&first) if colors.all(|&color| color == first) => {
            if first == [0.0; 4] {
                Coloring::Paper
            } else {
                Coloring::Flat(first)
            }
        }
        Some(_) => Coloring::Blended,
    }
}

fn mean(a: BlendColor, b: BlendColor) -> BlendColor {
    [0, 1, 2, 3].map(|i| 0.5 * (a[i] + b[i]))
}

fn field_triangle(barriers: Barriers<'_>, t: usize, colors: [[f32; 4]; 6]) -> FieldTriangle {
    let side_bit = |i: usize| u32::from(barriers.is_barrier(HalfEdge::of(t, i))) << i;
    FieldTriangle {
        corners: barriers.mesh.corners(t).map(|p| [p.x as f32, p.y as f32]),
        colors,
        side_edges: (0..3).map(side_bit).sum(),
    }
}
