//! Snap rounding: segments on a lattice become pieces that meet only at lattice points.
//!
//! J. D. Hobby, *Practical segment intersection with finite precision output*, Comput. Geom. 13 (1999): every end
//! and every rounded crossing makes its lattice cell *hot*, and each segment is led through the centres of all hot
//! cells that it passes. All tests are exact in integers, so that no two pieces of the result cross, overlap, or
//! touch other than at their ends.

use std::ops::RangeInclusive;

use crate::nearness;
use crate::pace::{self, Pace};
use crate::sample::LatticePoint;
use crate::sort;

/// A segment of the input; its ends differ.
pub(crate) type Segment = [LatticePoint; 2];

/// The pieces that replace the input segments.
#[derive(Debug, Default)]
pub(crate) struct Snapped {
    /// All nodes, each once, in the order that [`nearness::sort`] gives them.
    pub(crate) nodes: Vec<LatticePoint>,
    /// For each input segment the nodes that it passes, first end to last; two at least, neighbours differ.
    pub(crate) chains: Vec<Vec<u32>>,
}

/// Pairs of segments, or of a segment and a node, that are looked at before giving up: about a second's work.
const MAX_TESTS: u64 = 400_000_000;

/// Rounds segments with coordinates in `0..=frame`; gives up (`None`) above `limit` nodes, or where so much lies
/// on one spot that it would take longer than about a second.
pub(crate) async fn snap(segments: &[Segment], frame: LatticePoint, limit: usize) -> Option<Snapped> {
    let grid = segment_grid(segments, frame);
    let pairs = |square: &[u32]| (square.len() as u64).pow(2) / 2;
    if grid.squares().map(pairs).sum::<u64>() > MAX_TESTS {
        return None;
    }
    let mut nodes: Vec<_> = segments.iter().flatten().copied().collect();
    let mut pace = Pace::default();
    for square in grid.squares() {
        crossings(segments, square, &mut nodes);
        pace.work(1 + pairs(square) as usize).await;
        if nodes.len() > limit {
            sort_unique(&mut nodes);
        }
        if nodes.len() > limit {
            return None;
        }
    }
    sort_unique(&mut nodes);
    pace::pause().await;
    nearness::sort(&mut nodes, frame);
    let node_grid = node_grid(&nodes, frame);
    pace::pause().await;
    let tests = |(segments, nodes): (&[u32], &[u32])| segments.len() as u64 * nodes.len() as u64;
    let tests = grid.squares().zip(node_grid.squares()).map(tests);
    if nodes.len() > limit || tests.sum::<u64>() > MAX_TESTS {
        return None;
    }
    let mut chains = Vec::with_capacity(segments.len());
    pace::for_each(segments, |segment| chains.push(chain(segment, &nodes, &node_grid))).await;
    Some(Snapped { nodes, chains })
}

fn sort_unique(nodes: &mut Vec<LatticePoint>) {
    // Coordinates are not negative.
    sort::sort_copies_by_key(nodes, |node| sort::pair([node.x as u32, node.y as u32]));
    nodes.dedup();
}

/// Rounded crossings of all pairs of segments of one grid square.
fn crossings(segments: &[Segment], square: &[u32], nodes: &mut Vec<LatticePoint>) {
    for (i, &a) in square.iter().enumerate() {
        for &b in &square[i + 1..] {
            nodes.extend(crossing(&segments[a as usize], &segments[b as usize]));
        }
    }
}

/// The lattice point nearest to where two segments cross in their interiors.
fn crossing(a: &Segment, b: &Segment) -> Option<LatticePoint> {
    let (p, r) = (wide(a[0]), minus(wide(a[1]), wide(a[0])));
    let (q, s) = (wide(b[0]), minus(wide(b[1]), wide(b[0])));
    let det = cross(r, s);
    if det == 0 {
        return None;
    }
    let t = cross(minus(q, p), s) * det.signum();
    let u = cross(minus(q, p), r) * det.signum();
    let det = det.abs();
    if t <= 0 || u <= 0 || t >= det || u >= det {
        return None;
    }
    let round = |from: i64, step: i64| {
        let doubled = 2 * i128::from(step) * i128::from(t) + i128::from(det);
        from + doubled.div_euclid(2 * i128::from(det)) as i64
    };
    Some(LatticePoint { x: round(p.0, r.0) as i32, y: round(p.1, r.1) as i32 })
}

/// The nodes whose cells a segment passes, in its direction.
fn chain(segment: &Segment, nodes: &[LatticePoint], grid: &Buckets) -> Vec<u32> {
    let (a, along) = (wide(segment[0]), minus(wide(segment[1]), wide(segment[0])));
    // Nodes beside the first end may lie a little behind it.
    let key = |along: i64| along.wrapping_sub(i64::MIN) as u64;
    let mut passed: Vec<(u64, u32)> = grid
        .near(segment)
        .filter(|&node| passes(segment, nodes[node as usize]))
        .map(|node| {
            let to = minus(wide(nodes[node as usize]), a);
            (key(to.0 * along.0 + to.1 * along.1), node)
        })
        .collect();
    sort::sort(&mut passed);
    passed.into_iter().map(|(_, node)| node).collect()
}

/// Whether a segment meets the half-open cell `[x − ½, x + ½) × [y − ½, y + ½)` of a lattice point.
///
/// The cell, like the plane, is cut into half-open squares so that a segment along the border of two hot cells
/// belongs to one of them only.
fn passes(segment: &Segment, node: LatticePoint) -> bool {
    let (a, b) = (double(segment[0]), double(segment[1]));
    let c = double(node);
    let (mut enter, mut leave) = (Fraction::ZERO, Fraction::ONE);
    for (from, to, centre) in [(a.0, b.0, c.0), (a.1, b.1, c.1)] {
        let step = to - from;
        let (lo, hi) = (centre - 1 - from, centre + 1 - from);
        if step == 0 {
            if lo > 0 || hi <= 0 {
                return false;
            }
            continue;
        }
        let (first, last) = if step > 0 { (lo, hi) } else { (-hi, -lo) };
        enter = enter.max(Fraction { num: first, den: step.abs() });
        leave = leave.min(Fraction { num: last, den: step.abs() });
    }
    match enter.cmp(leave) {
        std::cmp::Ordering::Less => true,
        std::cmp::Ordering::Greater => false,
        std::cmp::Ordering::Equal => {
            let below_top = |from: i64, to: i64, centre: i64| {
                (from - centre - 1) * enter.den + (to - from) * enter.num < 0
            };
            below_top(a.0, b.0, c.0) && below_top(a.1, b.1, c.1)
        }
    }
}

/// A fraction with a positive denominator; both parts below 2^31, so that products are exact.
#[derive(Clone, Copy)]
struct Fraction {
    num: i64,
    den: i64,
}

impl Fraction {
    const ZERO: Self = Self { num: 0, den: 1 };
    const ONE: Self = Self { num: 1, den: 1 };

    fn cmp(self, other: Self) -> std::cmp::Ordering {
        (self.num * other.den).cmp(&(other.num * self.den))
    }

    fn max(self, other: Self) -> Self {
        if self.cmp(other).is_lt() { other } else { self }
    }

    fn min(self, other: Self) -> Self {
        if other.cmp(self).is_lt() { other } else { self }
    }
}

fn wide(p: LatticePoint) -> (i64, i64) {
    (i64::from(p.x), i64::from(p.y))
}

fn double(p: LatticePoint) -> (i64, i64) {
    (2 * i64::from(p.x), 2 * i64::from(p.y))
}

fn minus(a: (i64, i64), b: (i64, i64)) -> (i64, i64) {
    (a.0 - b.0, a.1 - b.1)
}

fn cross(a: (i64, i64), b: (i64, i64)) -> i64 {
    a.0 * b.1 - a.1 * b.0
}

/// Side of a grid square in lattice units, as a power of two: 4 du, a little more than the longest piece of a curve.
const SQUARE_SHIFT: u32 = 12;

fn square_of(coordinate: i32) -> usize {
    (coordinate.max(0) >> SQUARE_SHIFT) as usize
}

fn segment_grid(segments: &[Segment], frame: LatticePoint) -> Buckets {
    Buckets::new(frame, segments.len(), |i| squares_near(&segments[i], 0))
}

fn node_grid(nodes: &[LatticePoint], frame: LatticePoint) -> Buckets {
    Buckets::new(frame, nodes.len(), |i| squares_near(&[nodes[i]; 2], 0))
}

/// Columns and rows of the squares within `margin` of a segment's bounding box.
fn squares_near([a, b]: &Segment, margin: i32) -> [RangeInclusive<usize>; 2] {
    let range = |a: i32, b: i32| square_of(a.min(b) - margin)..=square_of(a.max(b) + margin);
    [range(a.x, b.x), range(a.y, b.y)]
}

/// Lists of items per square of the frame, as one flat array.
struct Buckets {
    columns: usize,
    starts: Vec<u32>,
    items: Vec<u32>,
}

impl Buckets {
    /// `squares_of(i)` gives the columns and rows of item `i`.
    fn new(
        frame: LatticePoint,
        count: usize,
        squares_of: impl Fn(usize) -> [RangeInclusive<usize>; 2],
    ) -> Self {
        let columns = square_of(frame.x) + 2;
        let squares = columns * (square_of(frame.y) + 2);
        let visit = |item: usize, visitor: &mut dyn FnMut(usize)| {
            let [across, down] = squares_of(item);
            for row in down {
                across.clone().for_each(|column| visitor(row * columns + column));
            }
        };
        let mut starts = vec![0_u32; squares + 1];
        (0..count).for_each(|item| visit(item, &mut |square| starts[square + 1] += 1));
        (1..=squares).for_each(|square| starts[square] += starts[square - 1]);
        let mut next = starts.clone();
        let mut items = vec![0; starts[squares] as usize];
        (0..count).for_each(|item| {
            visit(item, &mut |square| {
                items[next[square] as usize] = item as u32;
                next[square] += 1;
            });
        });
        Self { columns, starts, items }
    }

    fn square(&self, square: usize) -> &[u32] {
        &self.items[self.starts[square] as usize..self.starts[square + 1] as usize]
    }

    fn squares(&self) -> impl Iterator<Item = &[u32]> {
        (0..self.starts.len() - 1).map(|square| self.square(square))
    }

    /// All items of the squares that a segment or the lattice cells beside it may touch.
    fn near(&self, segment: &Segment) -> impl Iterator<Item = u32> {
        let [across, down] = squares_near(segment, 1);
        down.flat_map(move |row| {
            across.clone().flat_map(move |column| self.square(row * self.columns + column).iter().copied())
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pace::{Slices, now};
    use proptest::prelude::*;

    const FRAME: LatticePoint = LatticePoint { x: 512, y: 512 };

    fn at(x: i32, y: i32) -> LatticePoint {
        LatticePoint { x, y }
    }

    fn pieces(snapped: &Snapped) -> Vec<Segment> {
        let mut pieces: Vec<Segment> = snapped
            .chains
            .iter()
            .flat_map(|chain| chain.windows(2).map(|w| [w[0].min(w[1]), w[0].max(w[1])]))
            .map(|ends| ends.map(|node| snapped.nodes[node as usize]))
            .collect();
        pieces.sort_unstable();
        pieces.dedup();
        pieces
    }

    /// Whether two different pieces share more than a common end, by exact orientation tests.
    fn clash(a: &Segment, b: &Segment) -> bool {
        let turn = |p, q, r| cross(minus(wide(q), wide(p)), minus(wide(r), wide(p))).signum();
        let [o1, o2] = b.map(|r| turn(a[0], a[1], r));
        let [o3, o4] = a.map(|r| turn(b[0], b[1], r));
        let strictly_within = |s: &Segment, p: LatticePoint| {
            let (u, v) = (minus(wide(p), wide(s[0])), minus(wide(p), wide(s[1])));
            u.0 * v.0 + u.1 * v.1 < 0 && turn(s[0], s[1], p) == 0
        };
        (o1 * o2 < 0 && o3 * o4 < 0)
            || b.iter().any(|&p| strictly_within(a, p))
            || a.iter().any(|&p| strictly_within(b, p))
    }

    fn assert_planar(segments: &[Segment]) -> Snapped {
        let snapped = now(Slices::new(snap(segments, FRAME, 100_000))).expect("below the limits");
        for (segment, chain) in segments.iter().zip(&snapped.chains) {
            let ends = [chain[0], chain[chain.len() - 1]].map(|node| snapped.nodes[node as usize]);
            assert_eq!(ends, *segment);
        }
        let pieces = pieces(&snapped);
        for (i, a) in pieces.iter().enumerate() {
            for b in &pieces[i + 1..] {
                assert!(!clash(a, b), "{a:?} {b:?}");
            }
        }
        snapped
    }

    #[test]
    fn a_cross_meets_in_a_node() {
        let snapped = assert_planar(&[[at(0, 0), at(100, 100)], [at(0, 100), at(100, 0)]]);
        assert!(snapped.nodes.contains(&at(50, 50)));
        assert_eq!(pieces(&snapped).len(), 4);
    }

    #[test]
    fn overlaps_and_touches_become_shared_pieces() {
        let snapped =
            assert_planar(&[[at(0, 0), at(100, 0)], [at(150, 0), at(50, 0)], [at(70, 0), at(70, 90)]]);
        assert_eq!(pieces(&snapped).len(), 5);
    }

    #[test]
    fn thousands_of_crossings_through_one_point_are_one_node() {
        let star: Vec<Segment> = (-100..100)
            .flat_map(|i| [[at(100 + i, 0), at(100 - i, 200)], [at(0, 100 + i), at(200, 100 - i)]])
            .collect();
        let snapped = assert_planar(&star);
        assert!(
            snapped
                .chains
                .iter()
                .all(|chain| chain.iter().any(|&n| snapped.nodes[n as usize] == at(100, 100)))
        );
    }

    #[test]
    fn too_much_on_one_spot_is_refused() {
        let crowd: Vec<Segment> = (0..40_000).map(|i| [at(i % 200, 0), at(200 - i % 173, 200)]).collect();
        assert!(now(Slices::new(snap(&crowd, FRAME, 1_000_000))).is_none());
    }

    fn segments(range: i32, count: usize) -> impl Strategy<Value = Vec<Segment>> {
        let point = move || (0..range, 0..range).prop_map(|(x, y)| at(x, y));
        let segment =
            (point(), point()).prop_filter("ends differ", |(a, b)| a != b).prop_map(|(a, b)| [a, b]);
        proptest::collection::vec(segment, 1..count)
    }

    proptest! {
        #[test]
        fn random_segments_become_planar(s in segments(400, 40)) { assert_planar(&s); }

        #[test]
        fn crowded_segments_become_planar(s in segments(12, 40)) { assert_planar(&s); }

        #[test]
        fn nearly_parallel_segments_become_planar(y in proptest::collection::vec((0..4, 0..4), 2..30)) {
            let s: Vec<Segment> = y.iter().enumerate()
                .map(|(i, &(a, b))| [at(i as i32, 100 + a), at(300 - i as i32, 100 + b)]).collect();
            assert_planar(&s);
        }
    }
}
