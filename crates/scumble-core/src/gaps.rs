//! Gaps: narrow passages between wide places, where a person would say that a shape ends.
//!
//! Places are joined through their passages, the widest first, as in a watershed of the clearance. A passage that is
//! much narrower than the widest places on both its sides stays closed: it is a gap. This is the persistence of a
//! saddle (H. Edelsbrunner et al., *Topological persistence and simplification*, 2002), as a ratio.
//!
//! Beside the border of the page passages count as wider than they are, and so do places, for those passages. For all others
//! the border is a wall: what hangs from it parts no sky.

use kurbo::Vec2;

use crate::clearance::{Clearance, clear_width_du, is_gabriel, lines_du};
use crate::pace::{self, Slices, now};
use crate::planar_map::{Gap, PlanarMap};
use crate::sets::Sets;
use crate::sort;
use crate::triangulation::{HalfEdge, Triangulation};

/// The ratio of widths below which a passage is a gap, where all gaps are closed that could be.
const LARGEST_RATIO: f64 = 0.95;

/// Where no line ends, a passage must be this much narrower still to be a gap: a waist is no hole in an outline.
const WAIST: f64 = 0.7;

/// A gap is wide if it leaves more than this part of the narrower of the places it joins.
const WIDE: f64 = 0.2;

/// A gap is slight if it is no more than so many times as wide as the lines at its ends.
const SLIGHT: f64 = 1.5;

/// A line means to reach the border of the page where it ends within this part of its length of it, and points there.
const REACH: f64 = 0.125;

/// A line points along what its direction has at least this cosine with.
const POINTED: f64 = 0.5;

/// The ratio for a gap closing from 0 to 1: half of it for a little less than a third of the way, where it matters.
fn closed_below(closing: f64) -> f64 {
    let closing = closing.clamp(0.0, 1.0);
    LARGEST_RATIO * closing * (2.0 - closing)
}

impl PlanarMap {
    /// The same map with its gaps found anew: the passages narrower than the wide places on both their sides by more
    /// than `closing` tells, from 0 (only where drawn lines overlap) to 1 (wherever it gets a little narrower).
    pub fn with_gaps_closed(mut self, closing: f64) -> Self {
        self.close_gaps(closing);
        self
    }

    /// Finds the gaps of this map anew, as [`PlanarMap::with_gaps_closed`] does, and says whether they changed. Then
    /// what was derived from the map does not fit it any more.
    pub fn close_gaps(&mut self, closing: f64) -> bool {
        now(self.closing_gaps(closing))
    }

    /// The same in slices.
    pub fn closing_gaps(&mut self, closing: f64) -> Slices<'_, bool> {
        Slices::new(self.closed(closing))
    }

    /// Per node the length of the last curve through it, in du.
    pub(crate) fn line_lengths_du(&self) -> Vec<f64> {
        let mut lengths_du = vec![0.0; self.triangulation().points().len()];
        for piece in self.pieces() {
            let steps = piece.curve.map_or(&[][..], |curve| self.steps(curve as usize));
            let length_du = steps.last().map_or(0.0, |step| step.arc_du[1]);
            piece.nodes.iter().for_each(|&node| lengths_du[node as usize] = length_du);
        }
        lengths_du
    }

    async fn closed(&mut self, closing: f64) -> bool {
        self.measuring().await;
        pace::pause().await;
        let gaps = find(self, self.clearance(), closed_below(closing)).await;
        let changed = gaps != self.gaps();
        if changed {
            pace::pause().await;
            self.set_gaps(gaps);
        }
        changed
    }
}

/// The passages that stay closed when those with a clear width of at least `ratio` times that of the narrower of the
/// places they join are open.
async fn find(map: &PlanarMap, clearance: &Clearance, ratio: f64) -> Vec<Gap> {
    let mesh = map.triangulation();
    let mut basins = Basins::new(map, clearance).await;
    let mut gaps = Vec::new();
    let lengths_du = map.line_lengths_du();
    pace::pause().await;
    let mut passages = passages(mesh, clearance);
    pace::pause().await;
    sort::sort_copies_by_key(&mut passages, |&(width_du, ..)| !sort::float(width_du));
    pace::pause().await;
    pace::for_each(passages, |(width_du, h, twin)| {
        let [a, b] = [h, twin].map(|h| basins.sets.find(h.triangle() as u32));
        let narrower_du = basins.narrower_du([a, b], map.is_at_border(&mesh.ends(h))).max(0.0);
        if a != b && stays_closed(map, clearance, h, [width_du, ratio * narrower_du]) {
            gaps.push(gap(map, &lengths_du, h, [width_du, WIDE * narrower_du]));
        } else {
            basins.join(a, b);
        }
    })
    .await;
    gaps
}

/// Whether a passage as wide as the first of these widths is a gap, if all that are narrower than the second may be.
fn stays_closed(map: &PlanarMap, clearance: &Clearance, h: HalfEdge, [width_du, below_du]: [f64; 2]) -> bool {
    let mesh = map.triangulation();
    let is_at_tip = || {
        let clear_du = clear_width_du(map, h);
        mesh.ends(h).iter().any(|&node| clearance.tips.loose(node, clear_du).is_some())
    };
    width_du < below_du && is_gabriel(mesh, h) && (width_du < WAIST * below_du || is_at_tip())
}

/// The gap that counts as wide as the first of these widths, and is wide above the second. Beside the border of the page, what is
/// at hand counts as much as a passage there counts, unless a line means to reach it.
fn gap(map: &PlanarMap, lengths_du: &[f64], h: HalfEdge, [width_du, wide_du]: [f64; 2]) -> Gap {
    let nodes = map.triangulation().ends(h);
    let clear_du = clear_width_du(map, h);
    let counts = map.is_at_border(&nodes) && !means_to_reach(map, lengths_du, h);
    let is_wide = if counts { width_du } else { clear_du } > wide_du;
    Gap {
        nodes,
        is_wide,
        is_plain: is_wide && width_du > wide_du,
        is_slight: clear_du <= SLIGHT * lines_du(map, h),
    }
}

/// Whether a line that ends at an edge of the triangulation, and points along it, is so long beside it that it means to
/// reach the other end; by the lengths of the lines at each node.
fn means_to_reach(map: &PlanarMap, lengths_du: &[f64], h: HalfEdge) -> bool {
    let mesh = map.triangulation();
    let [a, b] = mesh.segment(h);
    let is_near = |node: u32, way: Vec2| {
        let tip = map.clearance().tips.direction(node);
        let length_du = way.hypot();
        length_du < REACH * lengths_du[node as usize]
            && tip.is_some_and(|direction| direction.dot(way) > POINTED * length_du)
    };
    let [from, to] = mesh.ends(h);
    is_near(from, b - a) || is_near(to, a - b)
}

/// All passages with their widths, once each, by both their half-edges.
fn passages(mesh: &Triangulation, clearance: &Clearance) -> Vec<(f64, HalfEdge, HalfEdge)> {
    let passage = |h: HalfEdge| {
        let twin = mesh.passage(h).filter(|twin| h < *twin)?;
        Some((clearance.widths_du[h.index()], h, twin))
    };
    mesh.half_edges().filter_map(passage).collect()
}

/// How wide a place is, in du.
#[derive(Clone, Copy)]
struct Width {
    /// For passages beside the border of the page.
    counted_du: f64,
    /// For all others.
    walled_du: f64,
}

/// Basins of a watershed: sets of triangles, each with its widest place.
struct Basins {
    sets: Sets,
    widths: Vec<Width>,
}

impl Basins {
    /// One for each triangle.
    async fn new(map: &PlanarMap, clearance: &Clearance) -> Self {
        let mut widths = Vec::with_capacity(clearance.place_widths_du.len());
        pace::for_each(clearance.place_widths_du.iter().enumerate(), |(triangle, &counted_du)| {
            widths.push(Width { counted_du, walled_du: clearance.walled_width_du(map, triangle) });
        })
        .await;
        Self { sets: Sets::new(widths.len()), widths }
    }

    /// The width of the narrower of two, for a passage between them.
    fn narrower_du(&self, basins: [u32; 2], is_at_border: bool) -> f64 {
        let [a, b] = basins.map(|basin| self.widths[basin as usize]);
        if is_at_border { a.counted_du.min(b.counted_du) } else { a.walled_du.min(b.walled_du) }
    }

    /// Joins two under the one with the wider place.
    fn join(&mut self, a: u32, b: u32) {
        let [one, other] = [a, b].map(|basin| self.widths[basin as usize]);
        let (wide, narrow) = if one.counted_du >= other.counted_du { (a, b) } else { (b, a) };
        self.sets.join(narrow, wide);
        self.widths[wide as usize] = Width {
            counted_du: one.counted_du.max(other.counted_du),
            walled_du: one.walled_du.max(other.walled_du),
        };
    }
}
