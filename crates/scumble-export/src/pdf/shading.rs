//! A mesh as a shading of type 4: free-form triangles with Gouraud shading. Triangles that share an edge follow each other
//! where they can, which takes one vertex each.

use crate::mesh::Linear;
use crate::numbers::push_numbers;
use crate::pdf::objects::Objects;

/// What of the colours is shaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Channels {
    /// Red, green, blue.
    Colors,
    /// The alpha, as grey.
    Alpha,
}

/// Coordinates are written with this many steps over the mesh, of 24 bits.
const PLACES: f64 = 16_777_215.0;

/// Channels are written with this many steps, of 16 bits.
const LEVELS: f64 = 65_535.0;

/// Meshes lie off by this much. Where a corner lies exactly on a row or a column of pixels, as at the edge of the page,
/// Chromium's viewer leaves out a row, and Firefox's paints black pixels.
const NUDGE_DU: f64 = -0.003;

/// A vertex as it is written: x, y, and one channel or three.
type Vertex = [u32; 5];

/// How a triangle follows the one before: not at all, on its edge from the second corner to the third, or from the
/// first to the third.
const FLAGS: [u8; 3] = [0, 1, 2];

/// Adds the shading of a mesh that has triangles, and gives its number.
pub(super) fn add(objects: &mut Objects, mesh: &[Linear], channels: Channels) -> usize {
    let bounds = bounds(mesh);
    let vertex = |corner: [f64; 2], color: [f64; 4]| vertex(corner, color, bounds, channels);
    let triangles = mesh.iter().map(|part| [0, 1, 2].map(|i| vertex(part.corners[i], part.colors[i])));
    let bytes = bytes(&Strips::new(triangles.collect()).written(), channels);
    let [[x0, y0], [x1, y1]] = bounds;
    let (space, decode) = match channels {
        Channels::Colors => ("/DeviceRGB", " 0 1 0 1 0 1"),
        Channels::Alpha => ("/DeviceGray", " 0 1"),
    };
    let mut entries =
        ["/ShadingType 4 /ColorSpace ", space, " /BitsPerFlag 8 /BitsPerCoordinate 24"].concat();
    entries.push_str(" /BitsPerComponent 16 /Decode [");
    push_numbers(&mut entries, &[x0, x1, y0, y1].map(|c| c + NUDGE_DU));
    entries.extend([decode, "]"]);
    objects.stream(&entries, &bytes)
}

/// Least and greatest coordinates, each a whole number, so that they can be written.
fn bounds(mesh: &[Linear]) -> [[f64; 2]; 2] {
    let corners = mesh.iter().flat_map(|part| part.corners);
    let least = |a: [f64; 2], b: [f64; 2]| [a[0].min(b[0].floor()), a[1].min(b[1].floor())];
    let most = |a: [f64; 2], b: [f64; 2]| [a[0].max(b[0].ceil()), a[1].max(b[1].ceil())];
    corners
        .fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], p| [least(low, p), most(high, p)])
}

fn vertex([x, y]: [f64; 2], [r, g, b, alpha]: [f64; 4], bounds: [[f64; 2]; 2], channels: Channels) -> Vertex {
    let [low, high] = bounds;
    let place =
        |c: f64, axis: usize| ((c - low[axis]) / (high[axis] - low[axis]).max(1.0) * PLACES).round() as u32;
    let level = |c: f64| (c * LEVELS).round() as u32;
    let levels = match channels {
        Channels::Colors => [r, g, b].map(level),
        Channels::Alpha => [level(alpha), 0, 0],
    };
    [place(x, 0), place(y, 1), levels[0], levels[1], levels[2]]
}

fn bytes(vertices: &[(u8, Vertex)], channels: Channels) -> Vec<u8> {
    let count = if channels == Channels::Colors { 3 } else { 1 };
    let mut bytes = Vec::with_capacity(13 * vertices.len());
    for (flag, [x, y, levels @ ..]) in vertices {
        bytes.push(*flag);
        [x, y].iter().for_each(|place| bytes.extend(&place.to_be_bytes()[1..]));
        levels[..count].iter().for_each(|level| bytes.extend(&level.to_be_bytes()[2..]));
    }
    bytes
}

/// Triangles, and which of them share edges.
struct Strips {
    triangles: Vec<[Vertex; 3]>,
    /// Each edge, the lesser vertex first, with its triangle; sorted.
    edges: Vec<([Vertex; 2], u32)>,
    used: Vec<bool>,
}

impl Strips {
    fn new(triangles: Vec<[Vertex; 3]>) -> Self {
        let edges =
            |(t, [a, b, c]): (u32, &[Vertex; 3])| [(a, b), (b, c), (c, a)].map(|(a, b)| (sorted(*a, *b), t));
        let mut edges: Vec<_> = (0..).zip(&triangles).flat_map(edges).collect();
        edges.sort_unstable();
        let used = vec![false; triangles.len()];
        Self { triangles, edges, used }
    }

    /// The vertices of all triangles, each with its flag.
    fn written(mut self) -> Vec<(u8, Vertex)> {
        let mut vertices = Vec::new();
        for start in 0..self.triangles.len() {
            if !std::mem::replace(&mut self.used[start], true) {
                self.strip(self.triangles[start], &mut vertices);
            }
        }
        vertices
    }

    /// Writes a triangle, and what follows it until nothing does.
    fn strip(&mut self, mut last: [Vertex; 3], vertices: &mut Vec<(u8, Vertex)>) {
        vertices.extend(last.map(|vertex| (FLAGS[0], vertex)));
        loop {
            let [a, b, c] = last;
            let next = [(FLAGS[1], b), (FLAGS[2], a)]
                .into_iter()
                .find_map(|(flag, start)| self.take_beyond(start, c).map(|vertex| (flag, start, vertex)));
            let Some((flag, start, vertex)) = next else { return };
            vertices.push((flag, vertex));
            last = [start, c, vertex];
        }
    }

    /// The third vertex of a triangle on an edge that has not been written yet.
    fn take_beyond(&mut self, a: Vertex, b: Vertex) -> Option<Vertex> {
        let edge = sorted(a, b);
        let first = self.edges.partition_point(|(other, _)| *other < edge);
        let on_it =
            self.edges[first..].iter().take_while(|(other, _)| *other == edge).map(|(_, t)| *t as usize);
        let next = on_it.into_iter().find(|t| !self.used[*t])?;
        self.used[next] = true;
        let third = self.triangles[next].into_iter().find(|vertex| *vertex != a && *vertex != b);
        Some(third.unwrap_or(a))
    }
}

fn sorted(a: Vertex, b: Vertex) -> [Vertex; 2] {
    [a.min(b), a.max(b)]
}
