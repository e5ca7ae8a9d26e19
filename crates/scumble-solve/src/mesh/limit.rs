//! Keeps the values between the nodes of an element in a range, where those at the nodes are.
//!
//! A quadratic along an edge may go beyond both of its ends: its value in the middle is brought back as far as it takes. That
//! depends on the edge alone, so elements that share it still meet.

use scumble_core::BlendColor;

/// How far values along an edge may go beyond the range: half a level of 255. What that leaves of a steep passage is more than if they might
/// not go beyond at all.
const TOLERANCE: f64 = 0.5 / 255.0;

/// The value in the middle of an edge of which these are the ends, channel by channel.
pub(super) fn limited(ends: [[f32; 4]; 2], middle: [f32; 4], [least, most]: [BlendColor; 2]) -> [f32; 4] {
    [0, 1, 2, 3].map(|i| {
        let [a, b, middle] = [ends[0][i], ends[1][i], middle[i]].map(f64::from);
        // Bernstein's middle coefficient: with those at the ends, it bounds the quadratic.
        let control = 2.0 * middle - 0.5 * (a + b);
        let above = room(most[i] - a, most[i] - b);
        let below = room(a - least[i], b - least[i]);
        let limited = control.min(most[i] + above).max(least[i] - below);
        if limited == control { middle as f32 } else { (0.5 * limited + 0.25 * (a + b)) as f32 }
    })
}

/// How far beyond an end of the range the middle coefficient may be where those at the ends are so far within.
fn room(a: f64, b: f64) -> f64 {
    TOLERANCE + ((a + TOLERANCE).max(0.0) * (b + TOLERANCE).max(0.0)).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::quadratic;

    /// The least and the greatest value along an edge.
    fn extremes(a: f32, middle: f32, b: f32) -> [f64; 2] {
        let nodes = [a, middle, b].map(f64::from);
        let value =
            |i: i32| (0..3).map(|k| quadratic::edge(f64::from(i) / 1000.0)[k] * nodes[k]).sum::<f64>();
        (0..=1000).map(value).fold([1.0, 0.0], |[least, most], v| [v.min(least), v.max(most)])
    }

    #[test]
    fn values_between_go_no_farther_than_the_tolerance_and_as_far_where_they_must() {
        let range = [[0.0; 4], [1.0; 4]];
        for (a, b) in [(0.0, 0.0), (1.0, 1.0), (0.0, 0.4), (1.0, 0.2), (0.3, 0.6), (0.0, 1.0)] {
            for middle in (0..=20).map(|i| i as f32 / 20.0) {
                let found = limited([[a; 4], [b; 4]], [middle; 4], range)[0];
                let [least, most] = extremes(a, found, b);
                let is_in = |[least, most]: [f64; 2], more: f64| {
                    least >= -more * TOLERANCE && most <= 1.0 + more * TOLERANCE
                };
                assert!(is_in([least, most], 1.001), "{a} {middle} {b}: {least} {most}");
                assert_eq!(found == middle, is_in(extremes(a, middle, b), 1.001), "{a} {middle} {b}");
                let is_at_its_limit = !is_in([least, most], 0.99);
                assert!(found == middle || is_at_its_limit, "{a} {middle} {b}: {least} {most}");
            }
        }
    }
}
