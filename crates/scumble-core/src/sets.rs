//! Disjoint sets of numbers.

/// Sets of the numbers from 0 on, each known by one of its members.
#[derive(Clone, Debug)]
pub struct Sets(Vec<u32>);

impl Sets {
    /// Each number alone.
    pub fn new(count: usize) -> Self {
        Self((0..count as u32).collect())
    }

    /// The member that stands for the set of a number, halving the way to it for the next time.
    pub fn find(&mut self, mut number: u32) -> u32 {
        while self.0[number as usize] != number {
            let next = self.0[self.0[number as usize] as usize];
            self.0[number as usize] = next;
            number = next;
        }
        number
    }

    /// Adds the set that `from` stands for to that of `to`, which stands for both then.
    pub fn join(&mut self, from: u32, to: u32) {
        self.0[from as usize] = to;
    }
}
