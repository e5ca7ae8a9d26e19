//! The flood: every triangle goes to the scribble with the cheapest way to it (Dijkstra from many seeds).

use std::cmp::Reverse;
use std::collections::BinaryHeap;

use kurbo::Point;

use super::pockets::{self, Rooms};
use super::slivers;
use crate::clearance::OPEN_DU;
use crate::pace;
use crate::planar_map::PlanarMap;
use crate::sort;
use crate::triangulation::{HalfEdge, Triangulation};

/// The cost of a way. Sums are exact: there are at most 2²² triangles, and a step costs less than 2¹⁰⁵.
pub(super) type Cost = u128;

/// Lengths are counted in these parts of a du, so that their sums are exact.
const PARTS_PER_DU: f64 = 4096.0;

/// Of lengths through passages there are no finer parts than these of a du, at the widest, for the sums' sake.
const COST_PARTS_PER_DU: f64 = 16.0;

/// Widths below this count as this, in du.
const LEAST_WIDTH_DU: f64 = 2.0;

/// Label of a triangle that no scribble reaches.
pub(super) const NONE: u32 = u32::MAX;

/// A gap costs as much as a way through a passage of its width, this part of that width long: as a hole has no length of its
/// own, that of the triangles beside it would count, and smaller ones would make it cheaper. Anything from 0.3 to 2 colours
/// the quality set as well.
const GAP_LENGTH: f64 = 0.5;

/// What it costs to go some way through a passage, both in du.
pub(super) fn cost(length_du: f64, width_du: f64) -> Cost {
    let narrowness = OPEN_DU / width_du.clamp(LEAST_WIDTH_DU, OPEN_DU);
    let squared = narrowness * narrowness;
    let fourth = squared * squared;
    (COST_PARTS_PER_DU * length_du * fourth * fourth) as Cost
}

/// What it costs to go through each gap of a map.
fn gap_costs(map: &PlanarMap) -> Vec<Cost> {
    let mesh = map.triangulation();
    let mut costs = vec![0; map.gaps().len()];
    for h in mesh.half_edges() {
        if let Some(gap) = mesh.gap(h) {
            let width_du = map.clearance().widths_du[h.index()].max(LEAST_WIDTH_DU);
            costs[gap as usize] = cost(GAP_LENGTH * width_du, width_du);
        }
    }
    costs
}

/// A length as a cost.
pub(super) fn length(length_du: f64) -> Cost {
    (PARTS_PER_DU * length_du) as Cost
}

/// What a half-edge is to colours.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Passage {
    /// Colours go on here from the first: neither a piece of line nor in a gap, but for those within a sliver.
    Plain,
    /// What has stopped at gaps and lines may go on here.
    Open,
    Closed,
}

/// The ways from triangle to triangle of the refined mesh.
#[derive(Clone, Debug)]
pub(super) struct Ways {
    /// What a step costs, per half-edge that is left through.
    pub(super) costs: Vec<Cost>,
    /// How long it is.
    pub(super) lengths: Vec<Cost>,
    /// Per triangle its room.
    pub(super) room_of: Vec<u32>,
    pub(super) rooms: Rooms,
    /// Per room whether not all of it lies under the ink of lines, and it is no sliver.
    pub(super) are_clear: Vec<bool>,
    /// Per side of a piece of curve; [`NONE`] for those that face no triangle.
    pub(super) triangle_of_side: Vec<u32>,
    /// The half-edges that lead through a gap, or across a line into a sliver.
    pub(super) gaps: Vec<HalfEdge>,
    /// The key of the door that each of those in gaps is in, but for those within slivers, with the index of that half-edge; by
    /// keys, in ascending order.
    doors: Vec<(u64, u32)>,
    /// Per half-edge.
    pub(super) passages: Vec<Passage>,
}

impl Ways {
    /// With `spread`, all gaps are open; else only the ways into slivers, until [`Ways::open_to`].
    pub(super) async fn new(map: &PlanarMap, spread: bool) -> Self {
        let mesh = map.refined();
        let (mut room_of, room_count) = mesh.finding_rooms().await;
        pace::pause().await;
        let mut gaps: Vec<_> = mesh.half_edges().filter(|&h| mesh.gap(h).is_some()).collect();
        pace::pause().await;
        let mut passages: Vec<_> = mesh.half_edges().map(|h| passage(mesh, h, spread)).collect();
        pace::pause().await;
        let bases = bases(map).await;
        let mut are_clear = vec![false; room_count];
        for (&room, &base) in room_of.iter().zip(&bases) {
            are_clear[room as usize] |= map.clearance().place_widths_du[base as usize] > 0.0;
        }
        pace::pause().await;
        if !spread {
            slivers::join(map, &mut gaps, &mut passages, &mut room_of, &mut are_clear).await;
            pace::pause().await;
        }
        let rooms = Rooms::new(map, &gaps, &room_of, &are_clear).await;
        pace::pause().await;
        let key = |&h: &HalfEdge| {
            let door = pockets::door(map, &room_of, h).filter(|_| passages[h.index()] != Passage::Plain)?;
            Some((sort::pair(door), h.index() as u32))
        };
        let mut doors = Vec::with_capacity(gaps.len());
        pace::for_each(&gaps, |h| doors.extend(key(h))).await;
        sort::sort(&mut doors);
        pace::pause().await;
        let triangle_of_side = vec![NONE; map.side_count()];
        let costs = vec![0; 3 * mesh.triangle_count()];
        let lengths = costs.clone();
        let mut ways =
            Self { costs, lengths, room_of, rooms, are_clear, triangle_of_side, gaps, doors, passages };
        pace::pause().await;
        let gap_costs = gap_costs(map);
        pace::pause().await;
        pace::for_each(bases.into_iter().map(|base| base as usize).enumerate(), |(t, base)| {
            (0..3).for_each(|i| ways.measure(map, HalfEdge::of(t, i), base, &gap_costs));
        })
        .await;
        ways
    }

    /// Opens the gaps that lead into the pockets and corners of what was drawn, pairs of a kind of scribble and a room in
    /// ascending order, and closes all others; says whether any opened, and whether any closed.
    pub(super) async fn open_to(&mut self, drawn: &[[u32; 2]]) -> [bool; 2] {
        let open = self.rooms.open_doors(drawn).await;
        let mut open = open.into_iter().map(sort::pair).peekable();
        let [mut opens, mut closes] = [false; 2];
        for &(door, h) in &self.doors {
            while open.next_if(|&open| open < door).is_some() {}
            let is_open = open.peek() == Some(&door);
            let passage = if is_open { Passage::Open } else { Passage::Closed };
            let was_open = std::mem::replace(&mut self.passages[h as usize], passage) == Passage::Open;
            opens |= is_open && !was_open;
            closes |= was_open && !is_open;
        }
        [opens, closes]
    }

    /// Whether what has stopped at gaps and lines may go on through a half-edge.
    pub(super) fn lead_through(&self, h: HalfEdge) -> bool {
        self.passages[h.index()] != Passage::Closed
    }

    /// Sets what lies at a half-edge of the refined mesh, or what it takes to go through it, either way, from a triangle
    /// whose centroid lies in the triangle `base` of the map.
    fn measure(&mut self, map: &PlanarMap, h: HalfEdge, base: usize, gap_costs: &[Cost]) {
        let mesh = map.refined();
        if let Some(side) = mesh.side(h) {
            self.triangle_of_side[side.index()] = h.triangle() as u32;
        }
        let Some(twin) = mesh.passage(h).filter(|&twin| h < twin) else { return };
        let [a, b] = mesh.segment(h);
        let [from, to] = [h, twin].map(|h| centroid(mesh, h.triangle()));
        let length_du = (to - from).hypot();
        let step_cost =
            || cost(length_du, map.clearance().narrowest_du(map, [from, a.midpoint(b), to], base));
        let cost = mesh.gap(h).map_or_else(step_cost, |gap| gap_costs[gap as usize]);
        for h in [h, twin] {
            (self.costs[h.index()], self.lengths[h.index()]) = (cost, length(length_du));
        }
    }
}

/// What a half-edge is at first: with `spread`, all gaps are open.
fn passage(mesh: &Triangulation, h: HalfEdge, spread: bool) -> Passage {
    match (mesh.side(h), mesh.gap(h)) {
        (None, None) => Passage::Plain,
        (None, Some(_)) if spread => Passage::Open,
        _ => Passage::Closed,
    }
}

/// Per triangle of the refined mesh the one of the map that its centroid lies in: from each to those beside it, as it is a
/// long way to the one that is next in the list. Of a rough map that is the triangle itself.
async fn bases(map: &PlanarMap) -> Vec<u32> {
    let count = map.refined().triangle_count() as u32;
    if map.is_rough() {
        return (0..count).collect();
    }
    let mut bases = vec![NONE; count as usize];
    let mut waiting = vec![(0, 0)];
    pace::repeat(|| find_base(map, &mut bases, &mut waiting)).await;
    bases
}

/// Finds that of the next triangle that waits, with one of the map that is near it, and tells whether there was one. All
/// triangles of a page hang together.
fn find_base(map: &PlanarMap, bases: &mut [u32], waiting: &mut Vec<(usize, usize)>) -> bool {
    let mesh = map.refined();
    let Some((t, hint)) = waiting.pop() else { return false };
    if bases.get(t) == Some(&NONE) {
        let base = map.triangulation().locate(centroid(mesh, t), hint).unwrap_or(hint);
        bases[t] = base as u32;
        waiting.extend((0..3).filter_map(|i| Some((mesh.twin(HalfEdge::of(t, i))?.triangle(), base))));
    }
    true
}

fn centroid(mesh: &Triangulation, triangle: usize) -> Point {
    let [a, b, c] = mesh.corners(triangle).map(|p| p.to_vec2());
    ((a + b + c) / 3.0).to_point()
}

/// Which scribble each triangle belongs to, so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Flood {
    /// Per triangle the scribble, or [`NONE`].
    pub(super) labels: Vec<u32>,
    /// Per triangle the cost of the way to it.
    pub(super) costs: Vec<Cost>,
    /// Cost, rank of the scribble, triangle, scribble.
    front: BinaryHeap<Reverse<(Cost, u32, u32, u32)>>,
}

impl Flood {
    /// A dry map, of which no triangle is reached at more than `limit`.
    pub(super) fn new(map: &PlanarMap, limit: Cost) -> Self {
        let count = map.refined().triangle_count();
        Self { labels: vec![NONE; count], costs: vec![limit; count], front: BinaryHeap::new() }
    }

    /// Gives labels other numbers, those that they have in `kept`, and dries what the ones have that are [`NONE`] there: what
    /// is around floods on from its borders. The limit is that of [`Flood::new`], as which a flood begins that is of no map.
    pub(super) fn withdraw(&mut self, map: &PlanarMap, kept: &[u32], limit: Cost) {
        if self.labels.is_empty() {
            *self = Self::new(map, limit);
        }
        let mut dried = Vec::new();
        for (triangle, label) in self.labels.iter_mut().enumerate().filter(|(_, label)| **label != NONE) {
            *label = kept[*label as usize];
            if *label == NONE {
                self.costs[triangle] = limit;
                dried.push(triangle);
            }
        }
        for h in dried.into_iter().flat_map(|triangle| (0..3).map(move |i| HalfEdge::of(triangle, i))) {
            if let Some(beside) = map.refined().passage(h).map(HalfEdge::triangle) {
                let (cost, label) = (self.costs[beside], self.labels[beside]);
                if label != NONE {
                    // Which comes first does not matter.
                    self.front.push(Reverse((cost, 0, beside as u32, label)));
                }
            }
        }
    }

    /// Lets a scribble come to a triangle at a cost. Where two come at the same cost, the lower rank wins.
    pub(super) fn reach(&mut self, triangle: usize, cost: Cost, label: u32, ranks: &[u32]) {
        let rank = |label: u32| ranks.get(label as usize).copied().unwrap_or(NONE);
        if (cost, rank(label)) < (self.costs[triangle], rank(self.labels[triangle])) {
            (self.costs[triangle], self.labels[triangle]) = (cost, label);
            self.front.push(Reverse((cost, rank(label), triangle as u32, label)));
        }
    }

    /// Floods on from wherever scribbles have come to, through all that is plain.
    pub(super) async fn run(&mut self, map: &PlanarMap, costs: &[Cost], ranks: &[u32], passages: &[Passage]) {
        pace::repeat(|| self.go_on(map, costs, ranks, |_, h| passages[h.index()] == Passage::Plain)).await;
    }

    /// Floods on from the triangle that is reached next, through the half-edges that are open to `may_go(next triangle,
    /// half-edge)`, each at its cost; tells whether there was one.
    pub(super) fn go_on(
        &mut self,
        map: &PlanarMap,
        costs: &[Cost],
        ranks: &[u32],
        may_go: impl Fn(usize, HalfEdge) -> bool,
    ) -> bool {
        let Some(Reverse((cost, _, triangle, label))) = self.front.pop() else { return false };
        let triangle = triangle as usize;
        if (cost, label) == (self.costs[triangle], self.labels[triangle]) {
            for h in (0..3).map(|i| HalfEdge::of(triangle, i)) {
                if let Some(twin) = map.refined().twin(h).filter(|twin| may_go(twin.triangle(), h)) {
                    self.reach(twin.triangle(), cost + costs[h.index()], label, ranks);
                }
            }
        }
        true
    }
}
