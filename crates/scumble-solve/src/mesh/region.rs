//! One region: its coloured sides, its system, and the values of its unknowns.

use std::mem;

use scumble_core::{BlendColor, HalfEdge, SideColors, SoftSource, Triangulation};

use super::SolveError;
use super::cells::Cells;
use super::dofs::{Dofs, Side};
use super::elements::Elements;
use crate::barriers::Barriers;
use crate::field::FieldTriangle;
use crate::quadratic;

/// A region and what is known about it so far.
#[derive(Debug)]
pub(super) struct Region {
    base: Elements,
    /// Its triangles, to be bisected, once a source shades it.
    cells: Option<Cells>,
    /// Where sources shade it: them, and the elements that they need.
    shaded: Option<(Vec<SoftSource>, Elements)>,
    /// The colours of its sides, as of the last look at them.
    given: Vec<Option<[BlendColor; 3]>>,
    /// Whether sources shade it and no side is coloured, as of the same look.
    is_paper: bool,
    coloring: Coloring,
    /// The colour of each unknown, where the region is neither paper nor flat.
    values: Vec<[f32; 4]>,
    is_solved: bool,
    /// Whether corners and edges of its elements are in the field.
    is_shaped: bool,
}

/// How much there is to solve.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Coloring {
    /// Nothing gives it a colour, or all is clear.
    Paper,
    /// All given colours are the same.
    Flat(BlendColor),
    /// Colours run into each other.
    Blended,
}

impl Region {
    pub(super) fn new(dofs: Dofs) -> Self {
        Self {
            given: vec![None; dofs.sides.len()],
            is_paper: false,
            base: Elements::new(dofs),
            cells: None,
            shaded: None,
            coloring: Coloring::Paper,
            values: Vec::new(),
            is_solved: false,
            is_shaped: false,
        }
    }

    /// Its triangles in the mesh, in ascending order; one at least.
    pub(super) fn triangles(&self) -> &[u32] {
        &self.base.dofs.triangles
    }

    /// Whether it has a part in one of the gaps that are marked.
    pub(super) fn touches(&self, is_marked: &[bool]) -> bool {
        self.base.dofs.gaps.iter().any(|&gap| is_marked.get(gap as usize).copied().unwrap_or(false))
    }

    pub(super) fn unknown_count(&self) -> usize {
        self.elements().dofs.count
    }

    #[cfg(test)]
    pub(super) fn is_factored(&self) -> bool {
        self.elements().system().is_some_and(super::system::System::is_factored)
    }

    fn elements(&self) -> &Elements {
        self.shaded.as_ref().map_or(&self.base, |(_, elements)| elements)
    }

    fn sources(&self) -> &[SoftSource] {
        self.shaded.as_ref().map_or(&[], |(sources, _)| sources)
    }

    /// Takes in the colours and the sources that shade it; sets up the system if it is needed and is not that of
    /// the last time. Returns the memory of a factor that is of no use any more.
    pub(super) fn analyse(
        &mut self,
        mesh: &Triangulation,
        colors: &SideColors,
        sources: Vec<SoftSource>,
    ) -> Option<Vec<f64>> {
        let is_paper =
            !sources.is_empty() && self.base.dofs.sides.iter().all(|side| color(colors, side).is_none());
        let memory = self.shade(mesh, sources, is_paper);
        if !self.is_given(colors) {
            self.given = self.elements().dofs.sides.iter().map(|side| given(side, colors)).collect();
            self.is_solved = false;
        }
        if self.is_solved {
            return memory;
        }
        self.coloring = coloring(self.colors());
        if self.coloring == Coloring::Blended {
            let is_colored: Vec<_> = self.given.iter().map(Option::is_some).collect();
            let elements = self.shaded.as_mut().map_or(&mut self.base, |(_, elements)| elements);
            elements.analyse(mesh, &is_colored);
        }
        memory
    }

    fn shade(&mut self, mesh: &Triangulation, sources: Vec<SoftSource>, is_paper: bool) -> Option<Vec<f64>> {
        let is_same = mem::replace(&mut self.is_paper, is_paper) == is_paper;
        if self.sources() == sources && is_same {
            return None;
        }
        self.is_solved = false;
        match &mut self.shaded {
            Some((known, _)) if are_recolored(known, &sources) && is_same => {
                *known = sources;
                None
            }
            _ => {
                let memory = self.shaded.take().and_then(|(_, elements)| elements.into_memory());
                let dofs = &self.base.dofs;
                let shaded = |sources: Vec<SoftSource>| {
                    let cells = self.cells.get_or_insert_with(|| Cells::new(mesh, dofs));
                    let elements = Elements::shaded(cells, dofs, &sources, is_paper);
                    (sources, elements)
                };
                self.is_shaped = false;
                self.shaded = Some(sources).filter(|sources| !sources.is_empty()).map(shaded);
                memory
            }
        }
    }

    /// Factors the system if one is needed and not factored yet, and takes the memory for it.
    pub(super) fn factor(&mut self, mesh: &Triangulation, memory: &mut Vec<f64>) -> Result<(), SolveError> {
        let elements = self.shaded.as_mut().map_or(&mut self.base, |(_, elements)| elements);
        if self.coloring == Coloring::Blended { elements.factor(mesh, memory) } else { Ok(()) }
    }

    /// Computes the values if the colours changed, and says whether they did. The system is factored.
    pub(super) fn solve(&mut self) -> bool {
        let changed = !self.is_solved;
        if let (true, Coloring::Blended, Some(system)) = (changed, self.coloring, self.elements().system()) {
            let [least, most] = self.range();
            let clamp = |value: BlendColor| [0, 1, 2, 3].map(|i| value[i].max(least[i]).min(most[i]) as f32);
            let values = system.solve(self.conditions(), self.elements().loads(self.sources()));
            let of_unknown = |values: Vec<BlendColor>| {
                system.places().iter().map(|&place| clamp(values[place as usize])).collect()
            };
            self.values = values.map(of_unknown).unwrap_or_default();
        }
        self.is_solved = true;
        changed
    }

    /// How many triangles it has in the field.
    pub(super) fn emitted_count(&self) -> usize {
        if self.coloring == Coloring::Paper { 0 } else { self.elements().dofs.triangles.len() }
    }

    /// Writes its triangles, as many as there are, or their colours alone where the rest is there since the last time.
    pub(super) fn emit(&mut self, barriers: Barriers<'_>, is_new: bool, triangles: &mut [FieldTriangle]) {
        if is_new || !self.is_shaped {
            self.emit_shapes(barriers, triangles);
            self.is_shaped = true;
        }
        for (of_triangle, triangle) in self.elements().dofs.of_triangle.iter().zip(triangles) {
            triangle.colors = match self.coloring {
                Coloring::Flat(color) => [color.map(|c| c as f32); 6],
                _ => of_triangle.map(|dof| self.values[dof as usize]),
            };
        }
    }

    fn emit_shapes(&self, barriers: Barriers<'_>, triangles: &mut [FieldTriangle]) {
        let elements = self.elements();
        for ((i, &t), triangle) in elements.dofs.triangles.iter().enumerate().zip(triangles) {
            triangle.corners = elements.corners(barriers.mesh, i).map(|p| [p.x as f32, p.y as f32]);
            triangle.side_edges = elements.side_edges(i).unwrap_or_else(|| side_edges(barriers, t as usize));
        }
    }

    /// The unknowns of the coloured sides, with their colours.
    fn conditions(&self) -> impl Iterator<Item = ([u32; 3], &[BlendColor; 3])> {
        let sides = self.elements().dofs.sides.iter().zip(&self.given);
        sides.filter_map(|(side, given)| Some((side.dofs, given.as_ref()?)))
    }

    /// Whether these are the colours of the last look at the sides.
    fn is_given(&self, colors: &SideColors) -> bool {
        let sides = &self.elements().dofs.sides;
        sides.len() == self.given.len()
            && sides.iter().zip(&self.given).all(|(side, known)| given(side, colors) == *known)
    }

    /// The colours that are given: by sides, by sources, and by the paper where these are on it.
    fn colors(&self) -> impl Iterator<Item = BlendColor> {
        let paper = self.is_paper.then_some([0.0; 4]);
        let sources = self.sources().iter().map(|source| source.color);
        self.given.iter().flatten().flatten().copied().chain(sources).chain(paper)
    }

    /// The least and the greatest value given, channel by channel.
    fn range(&self) -> [BlendColor; 2] {
        let start = [[f64::INFINITY; 4], [f64::NEG_INFINITY; 4]];
        self.colors().fold(start, |[least, most], color| {
            [[0, 1, 2, 3].map(|i| color[i].min(least[i])), [0, 1, 2, 3].map(|i| color[i].max(most[i]))]
        })
    }
}

fn given(side: &Side, colors: &SideColors) -> Option<[BlendColor; 3]> {
    color(colors, side).map(|colors| colors_of_part(*colors, side.part))
}

/// The colours of the side of a curve that a side is a part of.
fn color<'a>(colors: &'a SideColors, side: &Side) -> Option<&'a [BlendColor; 3]> {
    colors.get(side.id.index()).and_then(Option::as_ref)
}

/// The colours at the start, the middle and the end of a part of a side.
fn colors_of_part(colors: [BlendColor; 3], part: [f64; 2]) -> [BlendColor; 3] {
    if part == [0.0, 1.0] {
        return colors;
    }
    [part[0], 0.5 * (part[0] + part[1]), part[1]].map(|t| {
        let weights = quadratic::edge(t);
        [0, 1, 2, 3]
            .map(|i| weights[0] * colors[0][i] + weights[1] * colors[1][i] + weights[2] * colors[2][i])
    })
}

/// Whether sources differ in nothing but their colours.
fn are_recolored(before: &[SoftSource], after: &[SoftSource]) -> bool {
    before.len() == after.len()
        && before
            .iter()
            .zip(after)
            .all(|(before, after)| *before == SoftSource { color: before.color, ..after.clone() })
}

fn coloring(mut colors: impl Iterator<Item = BlendColor>) -> Coloring {
    match colors.next() {
        None => Coloring::Paper,
        Some(first) if colors.all(|color| color == first) => {
            if first == [0.0; 4] {
                Coloring::Paper
            } else {
                Coloring::Flat(first)
            }
        }
        Some(_) => Coloring::Blended,
    }
}

/// The edges of a triangle of the mesh that bound its region.
fn side_edges(barriers: Barriers<'_>, t: usize) -> u32 {
    (0..3).map(|i| u32::from(barriers.is_barrier(HalfEdge::of(t, i))) << i).sum()
}
