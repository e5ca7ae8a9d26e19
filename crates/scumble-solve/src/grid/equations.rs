//! The equations of pixels that are not like all others: those at curves, at gaps and at the border.

use std::iter;

use scumble_core::sets::Sets;

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

    /// Whether each pixel hangs together with none that is held to a colour.
    pub(super) fn unreached(&self) -> Vec<bool> {
        let Runs { ends, mut sets } = Runs::new(&self.equations(), self.width_px);
        let mut is_unreached = Vec::new();
        for (run, end) in (1..).zip(ends) {
            is_unreached.resize(end as usize, sets.find(run) != sets.find(COLORED));
        }
        is_unreached
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

/// Pixels beside each other in a row that hang together, as far as they do, and which of these runs hang together.
struct Runs {
    /// The pixel after the last of each.
    ends: Vec<u32>,
    /// Of runs by their numbers, and of [`COLORED`].
    sets: Sets,
}

/// What pixels hang together with that are held to a colour; runs are numbered from 1 on.
const COLORED: u32 = 0;

impl Runs {
    fn new(equations: &[Equation], width_px: u32) -> Self {
        let mut runs = Self { ends: Vec::new(), sets: Sets::new(equations.len() + 1) };
        let mut closed = Vec::new();
        for equation in equations {
            if equation.hold > 0.0 {
                runs.join(runs.ends.len() as u32 + 1, COLORED);
            }
            if equation.south == 0.0 {
                closed.push(equation.pixel);
            }
            if equation.east == 0.0 {
                runs.ends.push(equation.pixel + 1);
            }
        }
        runs.join_rows(&closed, width_px);
        runs
    }

    /// Joins runs with those in the row below, but where all links that lead there are closed, which are those of these pixels.
    fn join_rows(&mut self, closed: &[u32], width_px: u32) {
        let mut closed = closed.iter().peekable();
        let ([mut upper, mut lower], mut start) = ([0; 2], 0);
        while let Some(&below) = self.ends.get(lower) {
            let [above, below] = [self.ends[upper], below.saturating_sub(width_px)];
            let end = above.min(below);
            let closed_count = iter::from_fn(|| closed.next_if(|&&pixel| pixel < end)).count();
            if closed_count < (end - start) as usize {
                self.join(upper as u32 + 1, lower as u32 + 1);
            }
            upper += usize::from(above == end);
            lower += usize::from(below == end);
            start = end;
        }
    }

    fn join(&mut self, a: u32, b: u32) {
        let [a, b] = [a, b].map(|run| self.sets.find(run));
        self.sets.join(a, b);
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

#[cfg(test)]
mod tests {
    use proptest::collection::vec;
    use proptest::prelude::*;

    use super::*;

    /// Pixels of the largest picture.
    const MOST: usize = 35;

    fn cut(pixel: u32, link: Link, color: Option<Texel>) -> Cut {
        Cut { pixel, link, fraction: 0.5, color }
    }

    fn constraints([width_px, height_px]: [u32; 2], cuts: Vec<Cut>) -> Constraints {
        Constraints {
            width_px,
            height_px,
            cuts,
            faces: Vec::new(),
            pulls: Vec::new(),
            sources: Vec::new(),
            exits: Vec::new(),
            covers: None,
        }
    }

    /// Goes from pixel to pixel as long as there is a way.
    fn reached(constraints: &Constraints) -> Vec<bool> {
        let (width, count) = (constraints.width_px, constraints.width_px * constraints.height_px);
        let mut is_reached = vec![false; count as usize];
        let is_open = |pixel, link| constraints.cuts.iter().all(|cut| (cut.pixel, cut.link) != (pixel, link));
        for cut in constraints.cuts.iter().filter(|cut| cut.color.is_some()) {
            is_reached[cut.pixel as usize] = true;
        }
        for _ in 0..count {
            for pixel in 0..count {
                let east = (pixel % width + 1 < width && is_open(pixel, Link::East)).then_some(pixel + 1);
                let south = (pixel + width < count && is_open(pixel, Link::South)).then_some(pixel + width);
                for other in [east, south].into_iter().flatten().map(|other| other as usize) {
                    let pair = is_reached[pixel as usize] || is_reached[other];
                    (is_reached[pixel as usize], is_reached[other]) = (pair, pair);
                }
            }
        }
        is_reached
    }

    proptest! {
        #[test]
        fn a_pixel_is_unreached_if_there_is_no_way_from_one_with_a_colour(
            size_px in [1..8_u32, 1..6_u32],
            walls in vec(any::<[bool; 2]>(), MOST),
            colored in vec(0..MOST as u32, 0..3),
        ) {
            let mut cuts = Vec::new();
            for (pixel, [east, south]) in (0..size_px[0] * size_px[1]).zip(walls) {
                cuts.extend(east.then(|| cut(pixel, Link::East, None)));
                cuts.extend(south.then(|| cut(pixel, Link::South, None)));
                cuts.extend(colored.contains(&pixel).then(|| cut(pixel, Link::North, Some([1.0; 4]))));
            }
            let constraints = constraints(size_px, cuts);
            let expected: Vec<_> = reached(&constraints).into_iter().map(|is_reached| !is_reached).collect();
            prop_assert_eq!(constraints.unreached(), expected);
        }
    }
}
