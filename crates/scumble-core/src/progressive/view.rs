//! What one sample of a scribble sees, all the way round it, and where its glance jumps from one stretch of side to
//! another.

use kurbo::Point;

use super::outline::{Outline, ends};
use crate::planar_map::PlanarMap;
use crate::triangulation::SideId;
use crate::visibility::visibility_polygon;

/// A side whose middle the sample sees.
#[derive(Clone, Copy, Debug)]
pub(super) struct Glimpse {
    pub(super) side: SideId,
    /// The first and the last place of it that is seen.
    pub(super) seen: [Point; 2],
    /// Whether the next glimpse goes on where this one ends.
    pub(super) joined: bool,
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
    let mut all: Vec<Glimpse> = Vec::new();
    for visible in visibility_polygon(mesh, eye, triangle) {
        let (Some(side), [from, to]) = (mesh.side(visible.half_edge), visible.interval) else { continue };
        if from <= 0.5 && 0.5 <= to && all.last().is_none_or(|last| last.side != side) {
            let [a, b] = mesh.segment(visible.half_edge);
            all.push(Glimpse { side, seen: [a.lerp(b, from), a.lerp(b, to)], joined: false });
        }
    }
    join(map, outline, all)
}

fn join(map: &PlanarMap, outline: &Outline, mut all: Vec<Glimpse>) -> Vec<Glimpse> {
    let whole: Vec<_> = all.iter().map(|glimpse| ends(map, glimpse.side)).collect();
    let joined = |i: usize| {
        let j = (i + 1) % all.len();
        all[i].seen[1] == whole[i][1]
            && all[j].seen[0] == whole[j][0]
            && outline.next(all[i].side) == all[j].side
    };
    let joints: Vec<_> = (0..all.len()).map(joined).collect();
    for (glimpse, &joined) in all.iter_mut().zip(&joints) {
        glimpse.joined = joined;
    }
    let first = joints.iter().position(|joined| !joined).map_or(0, |last| last + 1);
    let len = all.len().max(1);
    all.rotate_left(first % len);
    all
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
        let places = glimpses.iter().map(|glimpse| glimpse.seen[0]);
        let nearest = places.min_by(|a, b| (*a - eye).hypot2().total_cmp(&(*b - eye).hypot2()))?;
        Some(Self { sides: [first.side, last.side], entry: first.seen[0], exit: last.seen[1], nearest })
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
