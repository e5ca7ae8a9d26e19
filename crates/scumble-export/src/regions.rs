//! The regions of a field: those of one colour as paths, the others as the triangles that they are.

use kurbo::BezPath;
use scumble_core::Srgb8;
use scumble_solve::{Field, FieldTriangle};

use crate::outline::{Edge, Outline, outline};
use crate::tint::{HALF_LEVEL, Rgba, Tint, bytes};

/// Width of the lines along seams, wide enough to cover the pixels that an edge touches also in small pictures.
pub(crate) const SEAM_DU: f64 = 1.0;

/// The next triangle over each edge, if there is one.
type Neighbors = [Option<u32>; 3];

/// A region that is of one colour all over.
#[derive(Debug)]
pub(crate) struct Flat {
    pub(crate) color: Srgb8,
    /// Its outline; what an odd number of subpaths surrounds is inside.
    pub(crate) path: BezPath,
    /// The parts of the outline along which another region lies. Two areas that share an edge let what is behind them
    /// shine through where each covers a part of a pixel: a line along it in the colour of one keeps the paper out.
    pub(crate) seams: BezPath,
}

/// What a field is made of.
#[derive(Debug, Default)]
pub(crate) struct Regions {
    pub(crate) flats: Vec<Flat>,
    /// The triangles of all regions that are shaded or not opaque.
    pub(crate) smooth: Vec<FieldTriangle>,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Kind {
    Clear,
    Smooth,
    Flat(Srgb8),
}

impl Regions {
    pub(crate) fn new(field: &Field, tint: &Tint) -> Self {
        let triangles = &field.triangles;
        let neighbors = neighbors(triangles);
        let (members, region_of) = connected(triangles, &neighbors);
        let kinds: Vec<_> = members.iter().map(|members| kind(triangles, members, tint)).collect();
        let mut regions = Self::default();
        for (region, members) in (0..).zip(&members) {
            match kinds[region as usize] {
                Kind::Clear => {}
                Kind::Smooth => regions.smooth.extend(members.iter().map(|&t| triangles[t as usize])),
                Kind::Flat(color) => {
                    let rim = rim(triangles, &neighbors, &region_of, members);
                    let edges = rim.map(|(points, beyond)| Edge {
                        points,
                        is_seam: beyond.is_some_and(|b| is_seam(&kinds, region, b)),
                    });
                    let Outline { path, seams } = outline(edges.collect());
                    regions.flats.push(Flat { color, path, seams });
                }
            }
        }
        regions
    }
}

/// The edges on the rim of a region, with the regions beyond them.
fn rim<'a>(
    triangles: &'a [FieldTriangle],
    neighbors: &'a [Neighbors],
    region_of: &'a [u32],
    members: &'a [u32],
) -> impl Iterator<Item = ([[f32; 2]; 2], Option<u32>)> + 'a {
    let region = members.first().map(|&t| region_of[t as usize]);
    let edges = members.iter().flat_map(move |&t| {
        let corners = triangles[t as usize].corners;
        (0..3).map(move |i| {
            let beyond = neighbors[t as usize][i].map(|next| region_of[next as usize]);
            ([corners[i], corners[(i + 1) % 3]], beyond)
        })
    });
    edges.filter(move |(_, beyond)| *beyond != region)
}

/// Whether a flat region's edge is a seam to the region beyond it; of two flat ones it is the first one's.
fn is_seam(kinds: &[Kind], region: u32, beyond: u32) -> bool {
    match kinds[beyond as usize] {
        Kind::Clear => false,
        Kind::Smooth => true,
        Kind::Flat(_) => region < beyond,
    }
}

/// What is drawn of a region.
fn kind(triangles: &[FieldTriangle], members: &[u32], tint: &Tint) -> Kind {
    let colors = || members.iter().flat_map(|&t| triangles[t as usize].colors);
    if colors().all(|[.., opacity]| opacity <= 0.0) {
        return Kind::Clear;
    }
    let (mut low, mut high): (Rgba, Rgba) = ([1.0; 4], [0.0; 4]);
    for color in colors() {
        let color = tint.rgba(color.map(f64::from));
        for c in 0..4 {
            (low[c], high[c]) = (low[c].min(color[c]), high[c].max(color[c]));
        }
        if low[3] < 1.0 || (0..3).any(|c| high[c] - low[c] > HALF_LEVEL) {
            return Kind::Smooth;
        }
    }
    Kind::Flat(Srgb8(bytes([0, 1, 2].map(|c| 0.5 * (low[c] + high[c])))))
}

/// The triangles of each region, in the order of their first ones, and the region of each triangle. No region reaches
/// over the side of a curve, except around its end.
fn connected(triangles: &[FieldTriangle], neighbors: &[Neighbors]) -> (Vec<Vec<u32>>, Vec<u32>) {
    let mut regions: Vec<Vec<u32>> = Vec::new();
    let mut region_of = vec![None; triangles.len()];
    for start in 0..triangles.len() as u32 {
        let region = regions.len() as u32;
        if region_of[start as usize].is_none() {
            region_of[start as usize] = Some(region);
            regions.push(spread(start, triangles, neighbors, &mut region_of));
        }
    }
    (regions, region_of.into_iter().flatten().collect())
}

/// The triangles of the region that one is in; they are given its region.
fn spread(
    start: u32,
    triangles: &[FieldTriangle],
    neighbors: &[Neighbors],
    region_of: &mut [Option<u32>],
) -> Vec<u32> {
    let region = region_of[start as usize];
    let mut members = vec![start];
    let mut at = 0;
    while let Some(t) = members.get(at).map(|&t| t as usize) {
        at += 1;
        let sides = triangles[t].side_edges;
        for next in (0..3).filter(|i| sides >> i & 1 == 0).filter_map(|i| neighbors[t][i]) {
            if region_of[next as usize].is_none() {
                region_of[next as usize] = region;
                members.push(next);
            }
        }
    }
    members
}

/// Which triangles lie edge to edge.
fn neighbors(triangles: &[FieldTriangle]) -> Vec<Neighbors> {
    let bits = |[x, y]: [f32; 2]| [x.to_bits(), y.to_bits()];
    let mut edges: Vec<_> = (0..)
        .zip(triangles)
        .flat_map(|(t, triangle)| {
            let corners = triangle.corners.map(bits);
            (0..3).map(move |i| {
                let [a, b] = [corners[i], corners[(i + 1) % 3]];
                ([a.min(b), a.max(b)], t, i)
            })
        })
        .collect();
    edges.sort_unstable();
    let mut neighbors = vec![[None; 3]; triangles.len()];
    for pair in edges.windows(2) {
        let [(a, s, i), (b, t, j)] = [pair[0], pair[1]];
        if a == b {
            neighbors[s as usize][i] = Some(t);
            neighbors[t as usize][j] = Some(s);
        }
    }
    neighbors
}
