//! The equations of pixels that are not like all others: those at curves, at gaps and at the border.

use super::constraints::Constraints;
use super::cut_links::{Cut, Link};
use super::texture::{Texel, plus, times};

/// What the equation of one pixel has. Where no list names a pixel, it is [`Equation::PLAIN`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Equation {
    /// The pixel: row times width plus column.
    pub pixel: u32,
    /// Weight of the link to the pixel to the east.
    pub east: f32,
    /// Weight of the link to the pixel to the south.
    pub south: f32,
    /// How strongly the pixel is held to given colours.
    pub hold: f32,
    /// These colours, each times how strongly it holds, and what is added.
    pub right: Texel,
}

impl Equation {
    /// That of a pixel with whole links and without colours.
    pub const PLAIN: Self = Self { pixel: 0, east: 1.0, south: 1.0, hold: 0.0, right: [0.0; 4] };

    fn hold_to(&mut self, color: Texel, strength: f32) {
        self.hold += strength;
        self.add(times(color, strength));
    }

    fn add(&mut self, color: Texel) {
        self.right = plus(self.right, color);
    }
}

impl Constraints {
    /// The equations that are not plain, by pixel in ascending order.
    pub fn equations(&self) -> Vec<Equation> {
        let named = self.cuts.iter().map(|cut| cut.pixel).chain(self.faces.iter().map(|face| face.pixel));
        let named = named.chain(self.pulls.iter().map(|pull| pull.pixel));
        let named = named.chain(self.sources.iter().map(|source| source.pixel));
        let named = named.chain(self.last_column()).chain(self.last_row());
        let mut list = List::new(named, self.width_px as usize * self.height_px as usize);
        self.last_column().for_each(|pixel| list.at(pixel).east = 0.0);
        self.last_row().for_each(|pixel| list.at(pixel).south = 0.0);
        self.faces.iter().for_each(|face| *list.link(face.pixel, face.link) *= face.width);
        self.cuts.iter().for_each(|cut| list.cut(cut));
        self.pulls.iter().for_each(|pull| list.at(pull.pixel).hold_to(pull.color, pull.strength));
        self.sources.iter().for_each(|source| list.at(source.pixel).add(source.color));
        list.equations
    }

    /// Whether each pixel hangs together with one that is held to a colour.
    pub(super) fn reached(&self) -> Vec<bool> {
        let (width, count) = (self.width_px as usize, self.width_px as usize * self.height_px as usize);
        let (mut leads_on, mut is_reached, mut open) =
            (vec![[true; 2]; count], vec![false; count], Vec::new());
        for Equation { pixel, east, south, hold, .. } in self.equations() {
            leads_on[pixel as usize] = [east > 0.0, south > 0.0];
            if hold > 0.0 {
                is_reached[pixel as usize] = true;
                open.push(pixel as usize);
            }
        }
        while let Some(i) = open.pop() {
            let mut visit = |is_linked: bool, next: usize| {
                if is_linked && !std::mem::replace(&mut is_reached[next], true) {
                    open.push(next);
                }
            };
            visit(leads_on[i][0], i + 1);
            visit(leads_on[i][1], i + width);
            visit(i >= 1 && leads_on[i - 1][0], i.wrapping_sub(1));
            visit(i >= width && leads_on[i - width][1], i.wrapping_sub(width));
        }
        is_reached
    }

    fn last_column(&self) -> impl Iterator<Item = u32> + use<> {
        let width = self.width_px;
        (1..=self.height_px).map(move |row| row * width - 1)
    }

    fn last_row(&self) -> impl Iterator<Item = u32> + use<> {
        let count = self.width_px * self.height_px;
        count - self.width_px..count
    }
}

/// Equations by pixel.
struct List {
    equations: Vec<Equation>,
    /// Which pixels have one, a bit each, 64 of them together; and how many are before these.
    named: Vec<(u64, u32)>,
}

impl List {
    /// Plain ones for all pixels that are named.
    fn new(pixels: impl Iterator<Item = u32>, count: usize) -> Self {
        let (mut equations, mut named) = (Vec::new(), vec![(0, 0); count.div_ceil(64)]);
        pixels.for_each(|pixel| named[pixel as usize / 64].0 |= 1 << (pixel % 64));
        for (i, (bits, before)) in (0..).zip(&mut named) {
            *before = equations.len() as u32;
            let mut rest: u64 = *bits;
            while rest != 0 {
                equations.push(Equation { pixel: 64 * i + rest.trailing_zeros(), ..Equation::PLAIN });
                rest &= rest - 1;
            }
        }
        Self { equations, named }
    }

    fn at(&mut self, pixel: u32) -> &mut Equation {
        let (bits, before) = self.named[pixel as usize / 64];
        debug_assert!(bits >> (pixel % 64) & 1 == 1);
        let beside = bits & ((1 << (pixel % 64)) - 1);
        &mut self.equations[(before + beside.count_ones()) as usize]
    }

    fn cut(&mut self, cut: &Cut) {
        if matches!(cut.link, Link::East | Link::South) {
            *self.link(cut.pixel, cut.link) = 0.0;
        }
        if let Some(color) = cut.color {
            self.at(cut.pixel).hold_to(color, 1.0 / cut.fraction);
        }
    }

    fn link(&mut self, pixel: u32, link: Link) -> &mut f32 {
        let equation = self.at(pixel);
        if link == Link::East { &mut equation.east } else { &mut equation.south }
    }
}
