//! Which gaps of the map a circuit closes.

use kurbo::Point;

use crate::planar_map::Gap;

/// How far a jump may be from a gap at either end: so many du, or this part of the gap's length if that is more.
const NEAR_DU: f64 = 6.0;
const NEAR_PART: f64 = 0.5;

/// The indices of the gaps that jumps go across: gaps that a jump runs along, its ends near theirs.
///
/// A circuit jumps from where a sample's glance leaves a line, the gap lies at the narrowest place, and the two need not
/// be the same node.
pub(super) fn across(points: &[Point], gaps: &[Gap], jumps: &[[Point; 2]]) -> Vec<u32> {
    let is_crossed = |gap: &Gap| {
        let [a, b] = gap.nodes.map(|node| points[node as usize]);
        let near_du = NEAR_DU.max(NEAR_PART * (b - a).hypot());
        let near = |[p, q]: [Point; 2]| (p - a).hypot() <= near_du && (q - b).hypot() <= near_du;
        jumps.iter().any(|&[p, q]| near([p, q]) || near([q, p]))
    };
    let crossed = gaps.iter().enumerate().filter(|(_, gap)| is_crossed(gap));
    crossed.map(|(i, _)| i as u32).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_jump_along_a_gap_closes_it_in_either_direction_and_no_other() {
        let points = [(0.0, 0.0), (40.0, 0.0), (0.0, 60.0), (40.0, 60.0)].map(Point::from);
        let gaps = [[0, 1], [2, 3]].map(|nodes| Gap { nodes, width_du: 40.0 });
        let jump = [Point::new(2.0, 5.0), Point::new(41.0, -3.0)];
        assert_eq!(across(&points, &gaps, &[jump]), [0]);
        assert_eq!(across(&points, &gaps, &[[jump[1], jump[0]]]), [0]);
        assert_eq!(across(&points, &gaps, &[[jump[0], points[3]]]), []);
    }
}
