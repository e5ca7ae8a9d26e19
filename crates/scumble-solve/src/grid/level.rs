//! One level of the hierarchy of grids: cells in rows, and how their unknowns hang together.
//!
//! On the finest level a cell is a pixel with one unknown. On the coarser ones it is four cells of the level before, and
//! has several unknowns, its *slots*: one for each part of the cell that no wall divides, so that what is on one side of
//! a curve is never mixed with what is on the other. Parts beyond the number of slots, those that given colours hold
//! anyway, are left to the finer level.
//!
//! Slot `s` of all cells lies in columns `s · columns ..` of the textures, so that slots that are hardly used lie
//! together.

use super::constraints::Constraints;
use super::equations::Equation;
use super::parts;
use super::texture::{Texel, Texture};

/// Slots of a cell of the level next to the pixels, and of all others.
const SLOTS: [usize; 2] = [2, 4];

/// How large a level is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    /// Cells of a row.
    pub columns: usize,
    /// Rows of cells.
    pub rows: usize,
    /// Unknowns of a cell.
    pub slots: usize,
}

impl Size {
    /// All levels, from that of the pixels of a picture to that of a single cell.
    pub fn levels(constraints: &Constraints) -> Vec<Self> {
        let coarser = |size: &Self| (size.columns.max(size.rows) > 1).then(|| size.coarser());
        std::iter::successors(Some(Self::finest(constraints)), coarser).collect()
    }

    fn finest(constraints: &Constraints) -> Self {
        Self { columns: constraints.width_px as usize, rows: constraints.height_px as usize, slots: 1 }
    }

    fn coarser(&self) -> Self {
        let slots = SLOTS[usize::from(self.slots > 1)];
        Self { columns: self.columns.div_ceil(2), rows: self.rows.div_ceil(2), slots }
    }
}

/// A level: the matrix of its unknowns. It is symmetric; what a row has besides its links holds it to given colours.
#[derive(Clone, Debug)]
pub struct Level {
    /// Cells of a row.
    pub columns: usize,
    /// Rows of cells.
    pub rows: usize,
    /// Unknowns of a cell.
    pub slots: usize,
    /// Weights of the links of each unknown to the slots of the cell to the east.
    pub east: Texture,
    /// The same for the cell to the south.
    pub south: Texture,
    /// The same for the other slots of its own cell: weak links, or the two would be one.
    pub within: Texture,
    /// For each unknown: how strongly it is held, the diagonal of the matrix, the damping of the interpolation to it,
    /// and which slot of the coarser cell it is a part of, counted from 1; 0 for none.
    pub holds: Texture,
}

impl Level {
    /// The finest level, and the right side of its equations.
    pub(super) fn finest(constraints: &Constraints) -> (Self, Texture) {
        let mut level = Self::empty(Size::finest(constraints));
        let mut right = Texture::new(level.columns, level.rows);
        level.east.texels.fill([Equation::PLAIN.east, 0.0, 0.0, 0.0]);
        level.south.texels.fill([Equation::PLAIN.south, 0.0, 0.0, 0.0]);
        for equation in constraints.equations() {
            let i = equation.pixel as usize;
            level.east.texels[i][0] = equation.east;
            level.south.texels[i][0] = equation.south;
            level.holds.texels[i][0] = equation.hold;
            right.texels[i] = equation.right;
        }
        level.sum_up();
        (level, right)
    }

    fn empty(Size { columns, rows, slots }: Size) -> Self {
        let texture = Texture::new(columns * slots, rows);
        let [east, south, within] = [(); 3].map(|()| texture.clone());
        Self { columns, rows, slots, east, south, within, holds: texture }
    }

    fn size(&self) -> Size {
        Size { columns: self.columns, rows: self.rows, slots: self.slots }
    }

    /// The next coarser level; marks which unknown of this one is a part of which.
    pub(super) fn coarser(&mut self) -> Self {
        let mut coarse = Self::empty(self.size().coarser());
        parts::mark(self, coarse.slots);
        self.gather_into(&mut coarse);
        coarse.sum_up();
        coarse
    }

    /// Adds up what the unknowns give to those of the coarser level that they are parts of: links, and what holds them, each
    /// through the links of that part.
    fn gather_into(&self, coarse: &mut Self) {
        for y in 0..self.rows as i32 {
            for cell in 0..self.columns as i32 {
                (0..self.slots as i32).for_each(|slot| self.add_to(coarse, [cell, y], slot));
            }
        }
    }

    /// Adds what one unknown gives.
    fn add_to(&self, coarse: &mut Self, [cell, y]: [i32; 2], slot: i32) {
        let x = self.column(cell, slot);
        let [hold, diagonal, damping, parent] = self.holds.load(x, y);
        if parent == 0.0 {
            return;
        }
        let own = parent as usize - 1;
        let i = (y / 2) as usize * coarse.holds.width + coarse.column(cell / 2, own as i32) as usize;
        let mut sum = (diagonal - hold) / diagonal * hold;
        self.for_each_link(x, y, |weight, nx, ny| {
            let [other_hold, other_diagonal, other_damping, other_parent] = self.holds.load(nx, ny);
            if other_parent == 0.0 {
                sum += weight / other_diagonal * other_hold;
                return;
            }
            let (beside, _) = self.cell_and_slot(nx);
            let other = other_parent as usize - 1;
            let links = match (beside / 2 - cell / 2, ny / 2 - y / 2) {
                (1, 0) => &mut coarse.east,
                (0, 1) => &mut coarse.south,
                (0, 0) if other != own => &mut coarse.within,
                _ => return,
            };
            links.texels[i][other] += lengthened(weight, damping + other_damping);
        });
        coarse.holds.texels[i][0] += sum;
    }

    /// Completes the numbers of the unknowns.
    fn sum_up(&mut self) {
        let mut holds = Texture::new(self.holds.width, self.holds.height);
        holds.draw(|x, y| summed(self, x, y));
        self.holds = holds;
    }

    /// The cell and the slot of the unknown in a column of the textures.
    #[inline]
    pub(super) fn cell_and_slot(&self, x: i32) -> (i32, i32) {
        let columns = self.columns as i32;
        if self.slots == 1 { (x, 0) } else { (x % columns, x / columns) }
    }

    /// The column of an unknown.
    #[inline]
    pub(super) fn column(&self, cell_x: i32, slot: i32) -> i32 {
        slot * self.columns as i32 + cell_x
    }

    /// Visits the links of an unknown: weight, and the place of the other one.
    ///
    /// Where there is no cell beside it, another one is looked at: its weight there is zero.
    #[inline]
    pub(super) fn for_each_link(&self, x: i32, y: i32, mut visit: impl FnMut(f32, i32, i32)) {
        let (cell, slot) = self.cell_and_slot(x);
        let [to_east, to_south, within] = [&self.east, &self.south, &self.within].map(|t| t.load(x, y));
        for other in 0..self.slots as i32 {
            let column = self.column(cell, other);
            let mut visit = |weight: f32, x: i32, y: i32| {
                if weight > 0.0 {
                    visit(weight, x, y);
                }
            };
            visit(to_east[other as usize], column + 1, y);
            visit(to_south[other as usize], column, y + 1);
            visit(self.east.load(column - 1, y)[slot as usize], column - 1, y);
            visit(self.south.load(column, y - 1)[slot as usize], column, y - 1);
            visit(within[other as usize], column, y);
        }
    }

    /// The slot of the coarser cell that an unknown is a part of, counted from 1; 0 for none.
    #[inline]
    pub(super) fn parent(&self, x: i32, y: i32) -> i32 {
        self.holds.load(x, y)[3] as i32
    }

    /// The places of the unknowns that the one in a column and a row of the coarser level is made of.
    pub(super) fn parts(&self, coarse: &Self, x: i32, y: i32) -> impl Iterator<Item = (i32, i32)> + use<'_> {
        let (cell, slot) = coarse.cell_and_slot(x);
        let columns = self.columns as i32;
        let quarters = [(0, 0), (1, 0), (0, 1), (1, 1)].into_iter();
        let cells =
            quarters.map(move |(dx, dy)| (2 * cell + dx, 2 * y + dy)).filter(move |&(x, _)| x < columns);
        let places =
            cells.flat_map(move |(x, y)| (0..self.slots as i32).map(move |s| (self.column(x, s), y)));
        places.filter(move |&(x, y)| self.parent(x, y) == slot + 1)
    }
}

/// The numbers of an unknown whose links and hold are known.
fn summed(level: &Level, x: i32, y: i32) -> Texel {
    let [hold, ..] = level.holds.load(x, y);
    let (mut sum, mut largest) = (0.0, 0.0_f32);
    level.for_each_link(x, y, |weight, _, _| {
        sum += weight;
        largest = largest.max(weight);
    });
    let diagonal = hold + sum;
    let damping = diagonal.max(4.0 * largest);
    [hold, diagonal, if damping > 0.0 { 1.0 / damping } else { 0.0 }, 0.0]
}

/// The weight of a link that leads on, from the middle of one part to that of the other: half of it for one as strong as
/// the links around it; all of a weak one, such as one through a gap.
fn lengthened(weight: f32, dampings: f32) -> f32 {
    weight / (1.0 + 2.0 * weight * dampings)
}
