//! One region: its coloured sides, its system, and the values of its unknowns.

use std::{array, iter, mem};

use kurbo::Point;
use scumble_core::{BlendColor, HalfEdge, SideColors, SoftSource, Triangulation, pace};

use super::SolveError;
use super::cells::{Cells, WHOLE};
use super::dofs::{Dofs, Side};
use super::elements::Elements;
use super::layer::{Cover, Layer};
use super::limit;
use super::refine::Shape;
use super::substitution::TileColumn;
use crate::barriers::Barriers;
use crate::field::{FieldChange, FieldTriangle, Others};
use crate::quadratic;

/// A region and what is known about it so far.
#[derive(Debug)]
pub(super) struct Region {
    base: Elements,
    /// Which of its sides have colours, and these, as of the last look at them.
    given: Vec<(usize, [BlendColor; 3])>,
    coloring: Coloring,
    /// The colour of each unknown, where colours run into each other.
    values: Vec<[f32; 4]>,
    is_solved: bool,
    /// Its triangles, to be bisected, once a source shades it.
    cells: Option<Cells>,
    /// What sources lay over it, if any do.
    layer: Option<Layer>,
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
            given: Vec::new(),
            base: Elements::new(dofs),
            coloring: Coloring::Paper,
            values: Vec::new(),
            is_solved: false,
            cells: None,
            layer: None,
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

    /// Whether it is to be solved.
    pub(super) fn is_needed(&self) -> bool {
        self.base.dofs.unknowns.count > 0
    }

    pub(super) fn unknown_count(&self) -> usize {
        self.base.dofs.unknowns.count + self.layer.as_ref().map_or(0, Layer::unknown_count)
    }

    #[cfg(test)]
    pub(super) fn is_factored(&self) -> bool {
        self.base.system().is_some_and(super::system::System::is_factored)
    }

    /// See [`super::MeshSolver::begin_step`].
    pub(super) fn begin_step(&mut self) {
        self.base.begin_step();
    }

    /// Takes in the colours and the sources that shade it; sets up the systems that are needed and are not those of
    /// the last time.
    pub(super) async fn analyse(
        &mut self,
        mesh: &Triangulation,
        colors: &SideColors,
        sources: &[SoftSource],
    ) {
        let sides = &self.base.dofs.sides;
        let color = |side: &Side| colors.get(side.id.index()).and_then(Option::as_ref);
        let given = || sides.iter().enumerate().filter_map(|(i, side)| Some((i, color(side)?)));
        if !given().eq(self.given.iter().map(|(i, colors)| (*i, colors))) {
            self.given = given().map(|(i, colors)| (i, *colors)).collect();
            self.is_solved = false;
        }
        if !self.is_solved {
            self.coloring = coloring(self.given_colors());
            if self.coloring == Coloring::Blended {
                let mut is_colored = vec![false; sides.len()];
                self.given.iter().for_each(|(i, _)| is_colored[*i] = true);
                self.base.analyse(&is_colored).await;
            }
        }
        self.shade(mesh, sources).await;
    }

    async fn shade(&mut self, mesh: &Triangulation, sources: &[SoftSource]) {
        let is_known = self.layer.as_ref().map_or(sources.is_empty(), |layer| layer.is_of(sources));
        if is_known || self.layer.as_mut().is_some_and(|layer| layer.recolor(sources)) {
            return;
        }
        self.is_shaped = false;
        let before = self.layer.take();
        if !sources.is_empty() {
            let cells = self.cells.get_or_insert_with(|| Cells::new(mesh, &self.base.dofs));
            self.layer = Some(Layer::new(cells, sources, before).await);
        }
    }

    /// Factors the systems that are needed and not factored yet, and takes the memory for it.
    pub(super) async fn factor(
        &mut self,
        mesh: &Triangulation,
        memory: &mut Vec<TileColumn>,
    ) -> Result<(), SolveError> {
        if self.coloring == Coloring::Blended {
            self.base.factor(mesh, memory).await?;
        }
        match &mut self.layer {
            Some(layer) => layer.factor(memory).await,
            None => Ok(()),
        }
    }

    /// Computes the values if anything changed, and says whether it did. The systems are factored.
    pub(super) async fn solve(&mut self) -> bool {
        let is_new = !mem::replace(&mut self.is_solved, true);
        if let (true, Coloring::Blended, Some(system)) = (is_new, self.coloring, self.base.system()) {
            let range = range(self.given_colors()).map(|color| color.map(|c| c as f32));
            let sums = system.right_hand_sides(self.conditions(), iter::empty());
            pace::pause_after(sums.len()).await;
            let values = system.solve(sums).await;
            self.values.clear();
            if let Some(values) = values {
                let value = |&place: &u32| within(values[place as usize], range);
                self.values.extend(system.places().iter().map(value));
            }
        }
        let is_shaded_anew = match &mut self.layer {
            Some(layer) => layer.solve().await,
            None => false,
        };
        is_new || is_shaded_anew || !self.is_shaped
    }

    /// How many triangles it has in the field.
    pub(super) fn emitted_count(&self) -> usize {
        match (&self.layer, self.coloring) {
            (Some(layer), _) => layer.shapes().len(),
            (None, Coloring::Paper) => 0,
            (None, _) => self.base.dofs.triangles.len(),
        }
    }

    /// The element of the mesh that one of its triangles in the field is, or is a part of; and where in that its corners
    /// are: the weights of that one's corners.
    pub(super) fn part(&self, i: usize) -> (usize, [[f32; 3]; 3]) {
        let (parent, weights) = match &self.layer {
            Some(layer) => (layer.shapes()[i].parent as usize, layer.shapes()[i].weights),
            None => (i, WHOLE),
        };
        (self.triangles()[parent] as usize, weights)
    }

    /// Writes its triangles, as many as there are, or their colours alone where the rest is there since the last time. Gives
    /// what has changed of a field in which they begin at a place.
    pub(super) async fn emit(
        &mut self,
        barriers: Barriers<'_>,
        is_new: bool,
        first: usize,
        triangles: &mut [FieldTriangle],
    ) -> FieldChange {
        let has_shapes = mem::replace(&mut self.is_shaped, true) && !is_new;
        let range = self.layer.as_ref().map(|layer| self.range_under(layer));
        let mut others = Others::none();
        pace::for_each((first..).zip(triangles), |(place, triangle)| {
            let i = place - first;
            if !has_shapes {
                let (corners, side_edges) = self.shape(barriers, i);
                let corners = corners.map(|p| [p.x as f32, p.y as f32]);
                if (corners, side_edges) != (triangle.corners, triangle.side_edges) {
                    others.add(place, &triangle.corners);
                    others.add(place, &corners);
                    (triangle.corners, triangle.side_edges) = (corners, side_edges);
                }
            }
            let is_other = match (&self.layer, range) {
                (Some(layer), Some(range)) => {
                    replace(&mut triangle.colors, &self.shaded(layer, i, range), [0, 1, 2, 3, 4, 5])
                }
                _ => self.put_colors(i, &mut triangle.colors),
            };
            if is_other {
                others.add(place, &triangle.corners);
            }
        })
        .await;
        others.change()
    }

    /// The corners of one of its triangles in the field, and which of its edges bound the region.
    fn shape(&self, barriers: Barriers<'_>, i: usize) -> ([Point; 3], u32) {
        if let Some(layer) = &self.layer {
            let Shape { corners, side_edges, .. } = layer.shapes()[i];
            return (corners, side_edges);
        }
        let t = self.base.dofs.triangles[i] as usize;
        (barriers.mesh.corners(t), side_edges(barriers, t))
    }

    /// What colours lie within, with a layer over them.
    fn range_under(&self, layer: &Layer) -> [BlendColor; 2] {
        let paper = (self.coloring == Coloring::Paper).then_some([0.0; 4]);
        range(self.given_colors().chain(layer.colors()).chain(paper))
    }

    /// The colours of one of its triangles, with the layer over them.
    fn shaded(&self, layer: &Layer, i: usize, range: [BlendColor; 2]) -> [[f32; 4]; 6] {
        covered(self.colors_of_part(&layer.shapes()[i]), &layer.covers(i), range)
    }

    /// Puts the colours of one of its triangles, without what lies over them, in place of others, and says whether any is
    /// another.
    fn put_colors(&self, i: usize, colors: &mut [[f32; 4]; 6]) -> bool {
        let flat;
        let (values, dofs) = match self.coloring {
            Coloring::Blended => (&self.values[..], self.base.dofs.unknowns.of_element[i]),
            Coloring::Flat(color) => {
                flat = [color.map(|c| c as f32)];
                (&flat[..], [0; 6])
            }
            Coloring::Paper => (&[[0.0; 4]][..], [0; 6]),
        };
        replace(colors, values, dofs)
    }

    /// The colours of a part of a triangle, without what lies over them.
    fn colors_of_part(&self, part: &Shape) -> [[f32; 4]; 6] {
        let mut colors = [[0.0; 4]; 6];
        self.put_colors(part.parent as usize, &mut colors);
        if self.coloring != Coloring::Blended || part.weights == WHOLE {
            return colors;
        }
        let [a, b, c] = part.weights;
        let middle = |a: [f32; 3], b: [f32; 3]| [0, 1, 2].map(|i| 0.5 * (a[i] + b[i]));
        [a, b, c, middle(a, b), middle(b, c), middle(c, a)]
            .map(|weights| quadratic::color(&colors, weights.map(f64::from)))
    }

    fn given_colors(&self) -> impl Iterator<Item = BlendColor> {
        self.given.iter().flat_map(|(_, colors)| colors).copied()
    }

    /// The unknowns of the coloured sides, with their colours.
    fn conditions(&self) -> impl Iterator<Item = ([u32; 3], &[BlendColor; 3])> {
        self.given.iter().map(|(i, colors)| (self.base.dofs.sides[*i].dofs, colors))
    }
}

/// Puts those of some colours that are at six places in place of others, and says whether any is another, by its bits: all at
/// once, without a branch for each.
fn replace(colors: &mut [[f32; 4]; 6], by: &[[f32; 4]], places: [u32; 6]) -> bool {
    let mut others = [0; 4];
    for (color, place) in colors.iter_mut().zip(places) {
        let before = mem::replace(color, by[place as usize]);
        (0..4).for_each(|i| others[i] |= before[i].to_bits() ^ color[i].to_bits());
    }
    others != [0; 4]
}

/// Colours of an element under a layer, within a range. Edges at the rim of the layer stay as they are in the element beyond.
fn covered(under: [[f32; 4]; 6], covers: &[Cover; 6], range: [BlendColor; 2]) -> [[f32; 4]; 6] {
    if !covers.iter().any(Cover::is_any) {
        return under;
    }
    let mut colors = array::from_fn(|k| clamped(covers[k].over(under[k].map(f64::from)), range));
    for nodes in [[0, 1, 3], [1, 2, 4], [2, 0, 5]] {
        let [a, b, middle] = nodes;
        if nodes.iter().any(|&k| covers[k].is_any()) {
            colors[middle] = limit::limited([colors[a], colors[b]], colors[middle], range);
        }
    }
    colors
}

/// The least and the greatest of some colours, channel by channel.
fn range(colors: impl Iterator<Item = BlendColor>) -> [BlendColor; 2] {
    let start = [[f64::INFINITY; 4], [f64::NEG_INFINITY; 4]];
    colors.fold(start, |[least, most], color| {
        [[0, 1, 2, 3].map(|i| color[i].min(least[i])), [0, 1, 2, 3].map(|i| color[i].max(most[i]))]
    })
}

fn clamped(value: BlendColor, [least, most]: [BlendColor; 2]) -> [f32; 4] {
    [0, 1, 2, 3].map(|i| value[i].max(least[i]).min(most[i]) as f32)
}

/// What [`clamped`] gives for a value that is single already.
fn within(value: [f32; 4], [least, most]: [[f32; 4]; 2]) -> [f32; 4] {
    [0, 1, 2, 3].map(|i| value[i].max(least[i]).min(most[i]))
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colours_are_others_if_any_bit_of_them_is() {
        let by = [[0.5, 0.25, 0.0, 1.0], [0.5, 0.25, -0.0, 1.0]];
        let mut colors = [by[0]; 6];
        assert!(!replace(&mut colors, &by, [0; 6]));
        assert!(replace(&mut colors, &by, [0, 0, 0, 0, 0, 1]));
        assert_eq!(colors[5][2].to_bits(), (-0.0_f32).to_bits());
        assert!(!replace(&mut colors, &by, [0, 0, 0, 0, 0, 1]));
    }
}
