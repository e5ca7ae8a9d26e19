//! What one sample of a scribble sees, all the way round it, and where its glance jumps from one stretch of side to
//! another.

use kurbo::Point;

use super::outline::Outline;
use crate::planar_map::PlanarMap;
use crate::triangulation::SideId;
use crate::visibility::visibility_polygon;

/// A side whose middle the sample sees.
#[derive(Clone, Copy, Debug)]
pub(super) struct Glimpse {
    pub(super) side: SideId,
    /// Where the side begins and ends.
    pub(super) line: [Point; 2],
    /// The first and the last place of it that is seen, in `0..=1`.
    interval: [f64; 2],
    /// Whether the next glimpse goes on where this one ends.
    pub(super) joined: bool,
}

impl Glimpse {
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

/// The sides that an eye in a triangle sees, in the triangulation's sense of turn. The first one begins a run, unless
/// all are joined.
pub(super) fn glimpses(map: &PlanarMap, outline: &Outline, eye: Point, triangle: usize) -> Vec<Glimpse> {
    let mesh = map.triangulation();
    let polygon = visibility_polygon(mesh, eye, triangle);
    let mut all: Vec<Glimpse> = Vec::with_capacity(polygon.len());
    for visible in polygon {
        let (Some(side), interval @ [from, to]) = (mesh.side(visible.half_edge), visible.interval) else {
            continue;
        };
        if from <= 0.5 && 0.5 <= to && all.last().is_none_or(|last| last.side != side) {
            all.push(Glimpse { side, line: mesh.segment(visible.half_edge), interval, joined: false });
        }
    }
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
#[derive(Clone, Copy, Debug)]
struct Run {
    sides: [SideId; 2],
    entry: Point,
    exit: Point,
    /// The place of it that lies nearest to the eye.
    nearest: Point,
}

impl Run {
    fn new(eye: Point, glimpses: &[Glimpse]) -> Option<Self> {
        let [first, last] = [glimpses.first()?, glimpses.last()?];
        let places = glimpses.iter().map(Glimpse::entry).map(|place| ((place - eye).hypot2(), place));
        let (_, nearest) = places.min_by(|a, b| a.0.total_cmp(&b.0))?;
        Some(Self { sides: [first.side, last.side], entry: first.entry(), exit: last.exit(), nearest })
    }
}

/// The jumps of a glance around: between neighbouring runs, and across the openings that it looks out of.
pub(super) fn jumps(eye: Point, glimpses: &[Glimpse], found: &mut Vec<Jump>) {
    if glimpses.last().is_none_or(|last| last.joined) {
        return;
    }
    let runs: Vec<_> = glimpses.chunk_by(|a, _| a.joined).filter_map(|run| Run::new(eye, run)).collect();
    let far = |p: Point| (p - eye).hypot2();
    let is_outward = |i: usize| far(runs[i].exit) <= far(runs[(i + 1) % runs.len()].entry);
    for (i, run) in runs.iter().enumerate() {
        let kind = if is_outward(i) { JumpKind::Outward } else { JumpKind::Inward };
        found.push(Jump { kind, from: run.sides[1], to: runs[(i + 1) % runs.len()].sides[0] });
        if kind == JumpKind::Outward {
            across(eye, &runs, i, |last| !is_outward(last), found);
        }
    }
}

/// The jumps from the end of run `opening` to where something near begins again, as long as all between lies behind.
fn across(eye: Point, runs: &[Run], opening: usize, closes: impl Fn(usize) -> bool, found: &mut Vec<Jump>) {
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
            if is_inner && place == run.entry && step > 1 && closes((i + runs.len() - 1) % runs.len()) {
                found.push(Jump { kind: JumpKind::Across, from: runs[opening].sides[1], to: run.sides[0] });
            }
            if is_inner {
                innermost = Some(place);
            }
        }
    }
}
