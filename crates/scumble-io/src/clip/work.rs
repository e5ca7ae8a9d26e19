//! What it takes to find what is hidden, and its limit.

/// What all shapes of a drawing may take, in comparisons of numbers: some tenths of a second.
const MOST_WORK: u64 = 50_000_000;

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
    /// When there are fewer left.
    pub(crate) fn spend(&mut self, comparisons: u64) -> Result<(), TooMuch> {
        self.0 = self.0.checked_sub(comparisons).ok_or(TooMuch)?;
        Ok(())
    }
}
