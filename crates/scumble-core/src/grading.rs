//! Lengths that grow from the ends of a line: where a colour jumps at a tip, it needs a fine mesh there, and no more than that.

/// A part of a line is no longer than this many times its distance from an end.
const GROWTH: f64 = 0.5;

/// Lengths up to so many times as long as they should be are as they should be: they are rounded.
const SLACK: f64 = 1.0 + 1e-9;

/// The places where the parts of a line begin and end, from 0 to 1: parts that are at most so long, and near an end as
/// long as is given for it or a part of the distance from there, whichever is more. All lengths are positive.
pub(crate) fn graded(length: f64, at_ends: [f64; 2], longest: f64) -> Vec<f64> {
    let count = (length / (SLACK * longest)).ceil().max(1.0);
    let at_ends = at_ends.map(|end| end / length);
    let mut places = vec![0.0];
    for i in 0..count as u64 {
        halve([i, i + 1].map(|i| i as f64 / count), at_ends, &mut places);
    }
    places
}

/// Adds the ends of the parts of a part.
fn halve([from, to]: [f64; 2], at_ends: [f64; 2], places: &mut Vec<f64>) {
    let longest = at_ends[0].max(GROWTH * from).min(at_ends[1].max(GROWTH * (1.0 - to)));
    let middle = 0.5 * (from + to);
    if to - from <= SLACK * longest || middle == from || middle == to {
        return places.push(to);
    }
    halve([from, middle], at_ends, places);
    halve([middle, to], at_ends, places);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lengths(length: f64, at_ends: [f64; 2]) -> Vec<f64> {
        graded(length, at_ends, 6.0).windows(2).map(|pair| length * (pair[1] - pair[0])).collect()
    }

    #[test]
    fn parts_are_equal_where_no_end_needs_shorter_ones() {
        assert_eq!(graded(18.0, [6.0; 2], 6.0), [0.0, 1.0 / 3.0, 2.0 / 3.0, 1.0]);
        assert_eq!(lengths(1e-3, [6.0; 2]), [1e-3]);
    }

    #[test]
    fn parts_grow_from_an_end_and_reach_the_other() {
        for at_ends in [[0.5, 6.0], [6.0, 0.5], [0.5, 0.5]] {
            let lengths = lengths(24.0, at_ends);
            assert_eq!(lengths.iter().sum::<f64>(), 24.0);
            assert_eq!([0, lengths.len() - 1].map(|i| lengths[i] <= 0.5), at_ends.map(|end| end == 0.5));
            assert!(lengths.contains(&3.0) && lengths.len() < 24, "{lengths:?}");
        }
    }
}
