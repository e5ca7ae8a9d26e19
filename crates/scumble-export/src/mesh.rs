//! Shades as triangles whose corners' colours other programs blend linearly in sRGB.
//!
//! A field's triangles are quadratic in the blend space. They are cut where that shows: each edge for itself, so that
//! two triangles that share one cut it alike. What is straight along its three edges is straight within.

use scumble_solve::{FieldTriangle, quadratic};

use crate::tint::{HALF_LEVEL, Rgba, Tint, difference, settled};

/// Edges shorter than this, in du, are not cut.
const LEAST_EDGE_DU: f64 = 0.125;

/// Blend-space colours that are closer than this, in each channel, are blended linearly: all of that is within a level.
const ALIKE: f64 = 1e-3;

/// A triangle is cut at most so often.
const MOST_CUTS: u32 = 8;

/// A triangle between whose corners colours are blended linearly.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Linear {
    /// In du.
    pub(crate) corners: [[f64; 2]; 3],
    pub(crate) colors: [Rgba; 3],
}

/// Weights of the three corners of a triangle.
type Weights = [f64; 3];

const CORNERS: [Weights; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
const MIDDLES: [Weights; 3] = [[0.5, 0.5, 0.0], [0.0, 0.5, 0.5], [0.5, 0.0, 0.5]];

/// Triangles as linear ones that look the same.
pub(crate) fn linear(triangles: &[FieldTriangle], tint: &Tint) -> Vec<Linear> {
    let mut parts = Vec::with_capacity(triangles.len());
    for triangle in triangles {
        let corners = triangle.corners.map(|p| p.map(f64::from));
        Quadratic { corners, colors: triangle.colors.map(|c| c.map(f64::from)) }
            .cut(tint, MOST_CUTS, &mut parts);
    }
    parts
}

/// A triangle with blend-space colours at its corners and in the middle of its edges.
struct Quadratic {
    corners: [[f64; 2]; 3],
    colors: [[f64; 4]; 6],
}

impl Quadratic {
    fn cut(&self, tint: &Tint, cuts: u32, parts: &mut Vec<Linear>) {
        let [c0, c1, c2, m01, m12, m20] = self.colors;
        let bent = [[c0, m01, c1], [c1, m12, c2], [c2, m20, c0]].map(|edge| is_bent(edge, tint));
        let is_cut = |i: usize| cuts > 0 && bent[i] && self.length_du(i) > LEAST_EDGE_DU;
        let pieces = pieces([0, 1, 2].map(is_cut));
        if pieces.is_empty() {
            let colors = settled([c0, c1, c2].map(|color| tint.rgba(color)));
            parts.push(Linear { corners: self.corners, colors });
        }
        for piece in pieces {
            self.piece(piece).cut(tint, cuts - 1, parts);
        }
    }

    fn length_du(&self, edge: usize) -> f64 {
        let [[ax, ay], [bx, by]] = [self.corners[edge], self.corners[(edge + 1) % 3]];
        (bx - ax).hypot(by - ay)
    }

    fn piece(&self, corners: [Weights; 3]) -> Self {
        let [a, b, c] = corners;
        let nodes = [a, b, c, middle(a, b), middle(b, c), middle(c, a)];
        Self { corners: corners.map(|w| self.place(w)), colors: nodes.map(|w| self.color(w)) }
    }

    fn place(&self, weights: Weights) -> [f64; 2] {
        [0, 1].map(|axis| (0..3).map(|i| weights[i] * self.corners[i][axis]).sum())
    }

    fn color(&self, weights: Weights) -> [f64; 4] {
        let nodes = quadratic::triangle(weights);
        [0, 1, 2, 3].map(|c| nodes.iter().zip(&self.colors).map(|(weight, color)| weight * color[c]).sum())
    }
}

fn middle(a: Weights, b: Weights) -> Weights {
    [0, 1, 2].map(|i| 0.5 * (a[i] + b[i]))
}

/// Whether an edge with these colours at its ends and in its middle looks other than a linear blend from end to end.
fn is_bent([start, middle, end]: [[f64; 4]; 3], tint: &Tint) -> bool {
    if [start, middle].iter().all(|color| (0..4).all(|c| (color[c] - end[c]).abs() < ALIKE)) {
        return false;
    }
    let [first, last] = settled([start, end].map(|color| tint.rgba(color)));
    [0.25, 0.5, 0.75].iter().any(|t| {
        let [s, m, e] = quadratic::edge(*t);
        let there = tint.rgba([0, 1, 2, 3].map(|c| s * start[c] + m * middle[c] + e * end[c]));
        let blended = [0, 1, 2, 3].map(|c| (1.0 - t) * first[c] + t * last[c]);
        difference(there, blended) > HALF_LEVEL
    })
}

/// The pieces of a triangle some of whose edges are cut in the middle; none where none is.
fn pieces(is_cut: [bool; 3]) -> Vec<[Weights; 3]> {
    let [a, b, c] = CORNERS;
    let [ab, bc, ca] = MIDDLES;
    match is_cut {
        [false, false, false] => vec![],
        [true, false, false] => vec![[a, ab, c], [ab, b, c]],
        [false, true, false] => vec![[b, bc, a], [bc, c, a]],
        [false, false, true] => vec![[c, ca, b], [ca, a, b]],
        [true, true, false] => vec![[ab, b, bc], [a, ab, bc], [a, bc, c]],
        [false, true, true] => vec![[bc, c, ca], [b, bc, ca], [b, ca, a]],
        [true, false, true] => vec![[ca, a, ab], [c, ca, ab], [c, ab, b]],
        [true, true, true] => vec![[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]],
    }
}
