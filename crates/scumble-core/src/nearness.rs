//! An order of nodes in which each lies near the one before it: what is done from node to node in turn finds what it needs
//! close at hand, in the plane and in memory.
//!
//! Along a Hilbert curve, in a few rounds, each of some times as many nodes as the one before (N. Amenta, S. Choi, G. Rote,
//! *Incremental constructions con BRIO*, 2003): so a triangulation to which they are added one by one soon has about its
//! shape.

use crate::sample::LatticePoint;
use crate::sort;

/// A node in 2³ along the curve comes before the last round, one in 2³ of these before the round before that, and so on.
const ROUND_BITS: u32 = 3;

/// Number of rounds.
const ROUNDS: u32 = 8;

/// Halvings of the square that the curve fills: coordinates are at most 2²⁰.
const HALVINGS: u32 = 21;

/// Sorts nodes within a frame. Its corners, if they are nodes, come first: all others lie between them.
pub(crate) fn sort(nodes: &mut Vec<LatticePoint>, frame: LatticePoint) {
    sort::sort_copies_by_key(nodes, |&node| along_curve(node));
    let round = |(place, node): (u32, &LatticePoint)| (round(place, *node, frame), place);
    let mut places: Vec<_> = (0..).zip(&*nodes).map(round).collect();
    sort::sort(&mut places);
    *nodes = places.iter().map(|&(_, place)| nodes[place as usize]).collect();
}

/// The round that a node comes in, from its place along the curve.
fn round(place: u32, LatticePoint { x, y }: LatticePoint, frame: LatticePoint) -> u64 {
    let is_corner = [0, frame.x].contains(&x) && [0, frame.y].contains(&y);
    let rounds_before = (place + 1).trailing_zeros() / ROUND_BITS;
    if is_corner { 0 } else { (ROUNDS - rounds_before.min(ROUNDS - 1)).into() }
}

/// How far along the curve a node is (D. Hilbert, *Ueber die stetige Abbildung einer Linie auf ein Flächenstück*, 1891).
fn along_curve(node: LatticePoint) -> u64 {
    let [mut x, mut y] = [node.x, node.y];
    (0..HALVINGS).rev().fold(0, |along, bit| {
        let [right, up] = [x, y].map(|coordinate| (coordinate >> bit & 1) as u64);
        if up == 0 {
            // The curve of this quarter is turned, and in the one on the right the other way round.
            (x, y) = if right == 1 { (!y, !x) } else { (y, x) };
        }
        along << 2 | ((3 * right) ^ up)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(side: i32) -> Vec<LatticePoint> {
        (0..side).flat_map(|y| (0..side).map(move |x| LatticePoint { x, y })).collect()
    }

    #[test]
    fn the_curve_goes_from_each_node_to_one_beside_it() {
        let mut nodes = square(32);
        sort::sort_copies_by_key(&mut nodes, |&node| along_curve(node));
        let step = |pair: &[LatticePoint]| (pair[1].x - pair[0].x).abs() + (pair[1].y - pair[0].y).abs();
        assert!(nodes.windows(2).all(|pair| step(pair) == 1));
        assert_eq!(nodes.iter().map(|&node| along_curve(node)).max(), Some(32 * 32 - 1));
    }

    #[test]
    fn corners_come_first_and_all_nodes_stay() {
        let mut nodes = square(32);
        let mut before = nodes.clone();
        sort(&mut nodes, LatticePoint { x: 31, y: 31 });
        assert!(nodes[..4].iter().all(|node| [0, 31].contains(&node.x) && [0, 31].contains(&node.y)));
        nodes.sort_unstable();
        before.sort_unstable();
        assert_eq!(nodes, before);
    }
}
