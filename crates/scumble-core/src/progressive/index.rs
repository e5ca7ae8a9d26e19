//! A number for each of a few sides.

use crate::triangulation::SideId;

/// A number for each side that has one; kept between calls so that it need not be cleared whole.
#[derive(Clone, Debug)]
pub(super) struct Index(Vec<u32>);

impl Index {
    const ABSENT: u32 = u32::MAX;

    /// With none, for a map of so many sides.
    pub(super) fn new(side_count: usize) -> Self {
        Self(vec![Self::ABSENT; side_count])
    }

    /// The number of a side, if it has one.
    pub(super) fn get(&self, side: SideId) -> Option<usize> {
        let number = self.0[side.index()];
        (number != Self::ABSENT).then_some(number as usize)
    }

    /// Gives a side a number less than 2³² − 1.
    pub(super) fn set(&mut self, side: SideId, number: usize) {
        self.0[side.index()] = number as u32;
    }

    /// Takes their numbers from sides.
    pub(super) fn clear(&mut self, sides: impl Iterator<Item = SideId>) {
        sides.for_each(|side| self.0[side.index()] = Self::ABSENT);
    }
}
