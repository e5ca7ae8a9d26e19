//! Times and their percentiles. The only clock of the project outside the page.

use std::time::Instant;

/// Runs something; its result and the milliseconds that it took.
pub(crate) fn timed<T>(run: impl FnOnce() -> T) -> (T, f64) {
    let start = Instant::now();
    let result = run();
    (result, start.elapsed().as_secs_f64() * 1e3)
}

/// Times of the same thing, in milliseconds.
#[derive(Clone, Debug, Default)]
pub(crate) struct Times(Vec<f64>);

impl Times {
    pub(crate) fn push(&mut self, ms: f64) {
        self.0.push(ms);
    }

    pub(crate) fn len(&self) -> usize {
        self.0.len()
    }

    /// The time that a part of all, from 0 to 1, stays at or below; 0 if there is none.
    pub(crate) fn percentile(&self, part: f64) -> f64 {
        let mut sorted = self.0.clone();
        sorted.sort_unstable_by(f64::total_cmp);
        let rank = (part * sorted.len() as f64).ceil() as usize;
        sorted.get(rank.saturating_sub(1)).copied().unwrap_or(0.0)
    }

    pub(crate) fn median(&self) -> f64 {
        self.percentile(0.5)
    }
}

/// Prints a table row: a name, the median, the 95th percentile and the largest.
pub(crate) fn print_row(name: &str, times: &Times) {
    let [p50, p95, max] = [0.5, 0.95, 1.0].map(|part| times.percentile(part));
    println!("{name:<46} {p50:9.2} {p95:9.2} {max:9.2}");
}

/// Prints the head of such a table.
pub(crate) fn print_head(title: &str) {
    println!("{title:<46} {:>9} {:>9} {:>9}", "median ms", "95 %", "largest");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn percentiles_are_times_that_were_taken() {
        let mut times = Times::default();
        assert_eq!(times.median(), 0.0);
        for ms in [5.0, 1.0, 4.0, 2.0, 3.0] {
            times.push(ms);
        }
        assert_eq!([0.0, 0.2, 0.5, 0.95, 1.0].map(|part| times.percentile(part)), [1.0, 1.0, 3.0, 5.0, 5.0]);
    }
}
