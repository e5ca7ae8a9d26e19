//! What it takes to find what is hidden, and its limit.

/// What all shapes of a drawing may take, in comparisons of numbers: a second at most.
const MOST_WORK: u64 = 200_000_000;

/// It would take too long to find what is hidden.
#[derive(Debug)]
pub(crate) struct TooMuch;

/// What is left of it, in comparisons.
#[derive(Debug)]
pub(crate) struct Work(u64);

impl Work {
    pub(crate) fn new() -> Self {
        Self(MOST_WORK)
    }

    /// Takes some comparisons.
    ///
    /// # Errors
    /// When there are fewer left; then there are none.
    pub(crate) fn spend(&mut self, comparisons: u64) -> Result<(), TooMuch> {
        let left = self.0.checked_sub(comparisons);
        self.0 = left.unwrap_or(0);
        left.map(|_| ()).ok_or(TooMuch)
    }
}
