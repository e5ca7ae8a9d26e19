//! What one sample of a scribble sees, all the way round it, and where its glance jumps from one stretch of side to
//! another.

use std::ops::Range;

use kurbo::{Point, Vec2};

use super::index::Index;
use super::outline::Outline;
use crate::planar_map::PlanarMap;
use crate::triangulation::SideId;
use crate::visibility::{Visible, visibility_polygon};

/// A place on a scribble.
#[derive(Clone, Copy, Debug)]
pub(super) struct Sample {
    pub(super) eye: Point,
    /// The triangle that it lies in.
    pub(super) triangle: usize,
}

/// A side whose middle the sample sees.
#[derive(Clone, Copy, Debug)]
pub(super) struct Glimpse {
    pub(super) side: SideId,
    /// Where the side begins and ends.
    pub(super) line: [Point; 2],
    /// The first and the last place of it that is seen, in `0..=1`.
    interval: [f64; 2],
    /// From its middle to the eye.
    pub(super) to_eye: Vec2,
    pub(super) distance_du: f64,
    /// Whether the next glimpse goes on where this one ends.
    pub(super) joined: bool,
}

impl Glimpse {
    fn new(eye: Point, side: SideId, line: [Point; 2], interval: [f64; 2]) -> Self {
        let to_eye = eye - line[0].midpoint(line[1]);
        Self { side, line, interval, to_eye, distance_du: to_eye.hypot2().sqrt(), joined: false }
    }

    /// The first place of it that is seen.
    pub(super) fn entry(&self) -> Point {
        self.line[0].lerp(self.line[1], self.interval[0])
    }

    /// The last place of it that is seen.
    fn exit(&self) -> Point {
        self.line[0].lerp(self.line[1], self.interval[1])
    }
}

/// A way from the end of one side straight to the start of another, through nothing but free space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Jump {
    pub(super) from: SideId,
    pub(super) to: SideId,
    pub(super) kind: JumpKind,
}

/// How a jump lies to the samples that find it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum JumpKind {
    /// Past the end of something near to what is seen behind it.
    Outward,
    /// From what is seen behind it to the start of something near.
    Inward,
    /// From one near end across to another: what is seen between the two is left out.
    Across,
}

/// What is seen from one place.
#[derive(Clone, Debug)]
pub(super) struct View {
    pub(super) eye: Point,
    /// In the triangulation's sense of turn. The first one begins a run, unless all are joined.
    pub(super) glimpses: Vec<Glimpse>,
    runs: Vec<Run>,
    /// Distance of the nearest side, to within the length of one, in du.
    pub(super) clearance_du: f64,
}

impl View {
    /// What an eye in a triangle sees.
    pub(super) fn new(map: &PlanarMap, outline: &Outline, Sample { eye, triangle }: Sample) -> Self {
        let glimpses = glimpses(map, outline, eye, triangle);
        let mut runs = Vec::new();
        let mut first = 0;
        for run in glimpses.chunk_by(|a, _| a.joined) {
            runs.extend(Run::new(first, run));
            first += run.len();
        }
        mark_outward(eye, &mut runs);
        let clearance_du =
            glimpses.iter().map(|glimpse| glimpse.distance_du).reduce(f64::min).unwrap_or_default();
        Self { eye, glimpses, runs, clearance_du }
    }

    /// The jumps of a glance around: between neighbouring runs, and across the openings that it looks out of.
    pub(super) fn jumps(&self, found: &mut Vec<Jump>) {
        if self.glimpses.last().is_none_or(|last| last.joined) {
            return;
        }
        for (i, run) in self.runs.iter().enumerate() {
            let kind = if run.is_outward { JumpKind::Outward } else { JumpKind::Inward };
            found.push(Jump { kind, from: run.sides[1], to: self.run(i + 1).sides[0] });
            if run.is_outward {
                across(self.eye, &self.runs, i, found);
            }
        }
    }

    /// The sides that are seen.
    pub(super) fn sides(&self) -> impl Iterator<Item = SideId> {
        self.glimpses.iter().map(|glimpse| glimpse.side)
    }

    /// A run, counted on around the eye.
    fn run(&self, i: usize) -> &Run {
        &self.runs[i % self.runs.len()]
    }

    /// Whether there is nothing more to see between two views, as far as they tell: no run of either is missing from
    /// the other, and no two runs have changed which of them goes on behind the other.
    ///
    /// On the way from one to the other the eye may look down an alley: before, it sees one wall past the other,
    /// afterwards the other past the one.
    pub(super) fn is_like(&self, other: &Self, run_of: &mut Index) -> bool {
        self.is_in(other, run_of) && other.is_in(self, run_of)
    }

    fn is_in(&self, other: &Self, run_of: &mut Index) -> bool {
        for (i, run) in other.runs.iter().enumerate() {
            other.glimpses[run.glimpses.clone()].iter().for_each(|glimpse| run_of.set(glimpse.side, i));
        }
        let is_in = self.is_found(other, run_of);
        run_of.clear(other.sides());
        is_in
    }

    fn is_found(&self, other: &Self, run_of: &Index) -> bool {
        let ends = |run: &Run| {
            let mut found =
                self.glimpses[run.glimpses.clone()].iter().filter_map(|glimpse| run_of.get(glimpse.side));
            let first = found.next()?;
            Some([first, found.next_back().unwrap_or(first)])
        };
        let Some(ends) = self.runs.iter().map(ends).collect::<Option<Vec<_>>>() else { return false };
        (0..ends.len()).all(|i| {
            let [before, after] = [ends[i][1], ends[(i + 1) % ends.len()][0]];
            let are_neighbors = before != after && (before + 1) % other.runs.len() == after;
            !are_neighbors || self.runs[i].is_outward == other.runs[before].is_outward
        })
    }
}

fn glimpses(map: &PlanarMap, outline: &Outline, eye: Point, triangle: usize) -> Vec<Glimpse> {
    let mesh = map.triangulation();
    let mut all: Vec<Glimpse> = Vec::new();
    visibility_polygon(mesh, eye, triangle, |Visible { half_edge, interval }| {
        let is_new = |side: &SideId| all.last().is_none_or(|last| last.side != *side);
        let is_middle_seen = interval[0] <= 0.5 && 0.5 <= interval[1];
        if let Some(side) = mesh.side(half_edge).filter(|side| is_middle_seen && is_new(side)) {
            all.push(Glimpse::new(eye, side, mesh.segment(half_edge), interval));
        }
    });
    join(outline, &mut all);
    let first = all.iter().position(|glimpse| !glimpse.joined).map_or(0, |last| (last + 1) % all.len());
    all.rotate_left(first);
    all
}

fn join(outline: &Outline, all: &mut [Glimpse]) {
    for i in 0..all.len() {
        let next = all[(i + 1) % all.len()];
        let glimpse = &mut all[i];
        glimpse.joined =
            glimpse.interval[1] == 1.0 && next.interval[0] == 0.0 && outline.next(glimpse.side) == next.side;
    }
}

/// A stretch of sides that a sample sees without a break.
#[derive(Clone, Debug)]
struct Run {
    glimpses: Range<usize>,
    sides: [SideId; 2],
    entry: Point,
    exit: Point,
    /// The place of it that lies nearest to the eye.
    nearest: Point,
    /// Whether what is seen next lies behind its end.
    is_outward: bool,
}

impl Run {
    /// The run of some glimpses, of which the first has a number.
    fn new(number: usize, glimpses: &[Glimpse]) -> Option<Self> {
        let [first, last] = [glimpses.first()?, glimpses.last()?];
        let nearest = glimpses.iter().min_by(|a, b| a.distance_du.total_cmp(&b.distance_du))?;
        Some(Self {
            glimpses: number..number + glimpses.len(),
            sides: [first.side, last.side],
            entry: first.entry(),
            exit: last.exit(),
            nearest: nearest.entry(),
            is_outward: false,
        })
    }
}

fn mark_outward(eye: Point, runs: &mut [Run]) {
    let far = |p: Point| (p - eye).hypot2();
    for i in 0..runs.len() {
        runs[i].is_outward = far(runs[i].exit) <= far(runs[(i + 1) % runs.len()].entry);
    }
}

/// The jumps from the end of run `opening` to where something near begins again, as long as all between lies behind.
fn across(eye: Point, runs: &[Run], opening: usize, found: &mut Vec<Jump>) {
    let start = runs[opening].exit;
    // What reaches furthest inward of all that was passed: a jump must not go behind it.
    let mut innermost = None::<Point>;
    for step in 1..=runs.len() {
        let i = (opening + step) % runs.len();
        let run = &runs[i];
        for place in [run.entry, run.nearest, run.exit] {
            if (start - eye).cross(place - eye) < 0.0 {
                return;
            }
            let is_inner = innermost.is_none_or(|inner| (inner - start).cross(place - start) >= 0.0);
            let closes = step > 1 && !runs[(i + runs.len() - 1) % runs.len()].is_outward;
            if is_inner && place == run.entry && closes {
                found.push(Jump { kind: JumpKind::Across, from: runs[opening].sides[1], to: run.sides[0] });
            }
            if is_inner {
                innermost = Some(place);
            }
        }
    }
}
