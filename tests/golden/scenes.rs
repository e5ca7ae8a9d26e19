//! Pictures that every painter must draw alike: one scene, every backend.

use kurbo::{Affine, Arc, BezPath, Circle, Rect, Shape as _};
use scumble_core::{
    Blend, BlendColor, Boundary, Curve, Drawing, Gap, Paint, PlanarMap, Rgba8, Sampling, Srgb8,
};
use scumble_solve::{Field, FieldTriangle, MeshSolver, Pixmap, Scene, Shape, View, paint};

/// How far painters may be apart in a channel, in 8-bit levels, where no edge passes.
const LEVELS: u8 = 2;

/// How far they may be apart in the mean over the channels of the pixels that edges pass through: they take different
/// numbers of samples there.
const MEAN_EDGE_LEVELS: f64 = 4.0;

/// A scene and how it is looked at.
#[derive(Debug)]
pub(crate) struct Golden {
    /// What is particular about it.
    pub name: &'static str,
    /// The paper.
    pub paper: Option<Srgb8>,
    /// The field.
    pub field: Field,
    /// What lies over the field.
    pub scribbles: Vec<Shape>,
    /// Fills and lines, over the scribbles.
    pub ink: Vec<Shape>,
    /// What is shown of it.
    pub view: View,
}

/// All of them.
pub(crate) fn all() -> Vec<Golden> {
    vec![
        flat(),
        ring(Blend::Oklab),
        ring(Blend::Srgb),
        shapes(),
        transparent(),
        zoomed(),
        sliver(),
        clear(WHITE),
        clear(None),
        closed_gap(),
    ]
}

const WHITE: Option<Srgb8> = Some(Srgb8([255; 3]));
const RED: Srgb8 = Srgb8([230, 25, 75]);
const BLUE: Srgb8 = Srgb8([0, 130, 200]);
const GREEN: Srgb8 = Srgb8([60, 180, 75]);

/// Two flat regions that share a curved side.
fn flat() -> Golden {
    let bent = |x: f64, y: f64| [x + 30.0 * (y / 40.0).sin(), y];
    let left = sheet(7, |u, v| bent(20.0 + 100.0 * u, 10.0 + 200.0 * v), |_, _| Blend::Oklab.from_srgb8(RED));
    let right =
        sheet(7, |u, v| bent(120.0 + 80.0 * u, 10.0 + 200.0 * v), |_, _| Blend::Oklab.from_srgb8(BLUE));
    Golden {
        name: "two flat regions",
        paper: WHITE,
        field: Field { blend: Blend::Oklab, triangles: [left, right].concat() },
        ink: vec![],
        scribbles: vec![],
        view: View { px_from_du: Affine::IDENTITY, width_px: 251, height_px: 223 },
    }
}

/// A ring from one colour inside to another outside, turned and moved by fractions of a pixel.
fn ring(blend: Blend) -> Golden {
    let place = |u: f64, v: f64| {
        let (sin, cos) = (u * std::f64::consts::TAU).sin_cos();
        [512.0 + (100.0 + 350.0 * v) * cos, 512.0 + (100.0 + 350.0 * v) * sin]
    };
    let color = |_, v: f64| mixed(blend, RED, GREEN, (1.0 + 3.5 * v).ln() / 4.5_f64.ln());
    Golden {
        name: "a ring",
        paper: WHITE,
        field: Field { blend, triangles: sheet(24, place, color) },
        ink: vec![],
        scribbles: vec![],
        view: View {
            px_from_du: Affine::translate((20.3, -40.7)) * Affine::rotate(0.2) * Affine::scale(0.23),
            width_px: 256,
            height_px: 256,
        },
    }
}

/// Opaque and translucent shapes that overlap themselves and each other, over a field.
fn shapes() -> Golden {
    let shape =
        |triangles: Vec<[[f32; 2]; 3]>, color| Shape { triangles: triangles.into(), color: Rgba8(color) };
    let cross = shape([disk(60.0, 100.0, 40.0), disk(90.0, 100.0, 40.0)].concat(), [0, 0, 0, 130]);
    let disk = |x: f32, y: f32, radius: f32, color| shape(disk(x, y, radius), color);
    Golden {
        name: "shapes",
        paper: Some(Srgb8([250, 240, 200])),
        ink: vec![disk(60.0, 60.0, 45.0, [200, 40, 40, 255]), cross, disk(110.0, 50.0, 30.0, [0, 0, 0, 255])],
        scribbles: vec![disk(75.0, 75.0, 35.0, [60, 180, 75, 90]), disk(95.0, 75.0, 35.0, [0, 130, 200, 90])],
        ..sheet_golden()
    }
}

/// The same without paper.
fn transparent() -> Golden {
    Golden { name: "shapes without paper", paper: None, ..shapes() }
}

/// 6400 % in the far corner of the page, where `f32` is coarsest.
fn zoomed() -> Golden {
    let place = |u: f64, v: f64| [1016.0 + 7.9 * u + 0.3 * v, 1017.0 + 6.5 * v - 0.2 * u];
    let color = |u: f64, v: f64| mixed(Blend::Oklab, BLUE, RED, 0.5 * (u * u + v));
    Golden {
        name: "6400 %",
        paper: WHITE,
        field: Field { blend: Blend::Oklab, triangles: sheet(9, place, color) },
        ink: vec![Shape { triangles: disk(1020.0, 1020.0, 0.7).into(), color: Rgba8([20, 20, 20, 255]) }],
        scribbles: vec![],
        view: View {
            px_from_du: Affine::scale(64.0) * Affine::translate((-1018.03, -1018.06)),
            width_px: 300,
            height_px: 280,
        },
    }
}

/// Two regions with a third between them, a third of a pixel wide and with all of a gradient in it.
fn sliver() -> Golden {
    let band = |from: f64, to: f64, [left, right]: [Srgb8; 2]| {
        let place = move |u: f64, v: f64| [from + (to - from) * u + 12.0 * v, 4.0 + 56.0 * v];
        sheet(3, place, move |u, _| mixed(Blend::Srgb, left, right, u))
    };
    let bands =
        [band(4.0, 30.0, [RED, BLUE]), band(30.0, 30.15, [GREEN, RED]), band(30.15, 50.0, [BLUE, RED])];
    Golden {
        name: "a sliver",
        field: Field { blend: Blend::Srgb, triangles: bands.concat() },
        view: View { px_from_du: Affine::scale(2.0), width_px: 128, height_px: 128 },
        ..sheet_golden()
    }
}

/// A ring from a colour inside to a clear scribble outside: it fades into the paper.
fn clear(paper: Option<Srgb8>) -> Golden {
    let circle = |radius_du: f64| Circle::new((512.0, 512.0), radius_du).to_path(1e-6);
    let colors = [[Some(BLUE.into()), Some(RED.into())], [Some(Paint::Clear), None]];
    Golden {
        name: if paper.is_some() { "a clear scribble" } else { "a clear scribble without paper" },
        paper,
        field: solved(&[circle(100.0), circle(450.0)], &colors),
        view: View { px_from_du: Affine::scale(0.2), width_px: 205, height_px: 205 },
        ..sheet_golden()
    }
}

/// A shape with an opening that lets no colour through, and a smaller one in it.
fn closed_gap() -> Golden {
    let arc = Arc::new((512.0, 512.0), (400.0, 300.0), 0.1, std::f64::consts::TAU - 0.2, 0.3).to_path(1e-6);
    let inner = Circle::new((600.0, 560.0), 80.0).to_path(1e-6);
    let colors = [[Some(RED.into()), Some(BLUE.into())], [None, Some(GREEN.into())]];
    Golden {
        name: "a closed gap",
        field: solved(&[arc, inner], &colors),
        view: View { px_from_du: Affine::scale(0.25), width_px: 256, height_px: 256 },
        ..sheet_golden()
    }
}

/// The field between curves with colours on their left and right sides. The ends of the first, if it has any, are
/// joined by a closed gap.
fn solved(curves: &[BezPath], colors: &[[Option<Paint>; 2]]) -> Field {
    let curves = curves.iter().map(|path| Curve { path: path.clone(), line: None }).collect();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
    let map = PlanarMap::build(&drawing, &Sampling { spacing_du: 24.0, tip_du: 24.0, chord_du: 0.5 })
        .expect("a map");
    let (first, last) = (map.steps(0).first().expect("a step"), map.steps(0).last().expect("a step"));
    let nodes = [map.ends(first.left)[0], map.ends(last.left)[1]];
    let map = map.with_gaps(vec![Gap { nodes, is_wide: false, is_plain: false, is_slight: false }]);
    let mut sides = vec![None; map.side_count()];
    for (curve, [left, right]) in colors.iter().enumerate() {
        for step in map.steps(curve) {
            for (side, paint) in [(step.left, left), (step.left.opposite(), right)] {
                sides[side.index()] = paint.map(|paint| [Blend::Oklab.from_paint(paint); 3]);
            }
        }
    }
    let boundary = Boundary { closed_gaps: vec![true], ..sides.into() };
    MeshSolver::new(map.refined().clone()).solve(&boundary, Blend::Oklab).expect("a field").clone()
}

/// A square with a saddle of colours.
fn sheet_golden() -> Golden {
    let color = |u: f64, v: f64| mixed(Blend::Oklab, RED, BLUE, u * (1.0 - v) + v * (1.0 - u));
    Golden {
        name: "a saddle",
        paper: WHITE,
        field: Field {
            blend: Blend::Oklab,
            triangles: sheet(5, |u, v| [10.0 + 100.0 * u, 10.0 + 90.0 * v], color),
        },
        ink: vec![],
        scribbles: vec![],
        view: View { px_from_du: Affine::scale(1.1), width_px: 170, height_px: 160 },
    }
}

/// The unit square as `2 n²` triangles, moved into place; its border is a side.
fn sheet(
    n: u32,
    place: impl Fn(f64, f64) -> [f64; 2],
    color: impl Fn(f64, f64) -> BlendColor,
) -> Vec<FieldTriangle> {
    let triangle = |corners: [[u32; 2]; 3]| {
        let nodes = [0, 1, 2].map(|i| corners[i].map(|c| f64::from(c) / f64::from(n)));
        let middle = |i: usize, j: usize| [0, 1].map(|k| (nodes[i][k] + nodes[j][k]) / 2.0);
        let on_border = |i: usize, j: usize| {
            (0..2).any(|k| corners[i][k] == corners[j][k] && corners[i][k].is_multiple_of(n))
        };
        let side_edges = [(0, 1), (1, 2), (2, 0)].map(|(i, j)| u32::from(on_border(i, j)));
        FieldTriangle {
            corners: nodes.map(|[u, v]| place(u, v).map(|c| c as f32)),
            colors: [nodes[0], nodes[1], nodes[2], middle(0, 1), middle(1, 2), middle(2, 0)]
                .map(|[u, v]| color(u, v).map(|c| c as f32)),
            side_edges: side_edges[0] | side_edges[1] << 1 | side_edges[2] << 2,
        }
    };
    let cells = (0..n).flat_map(|i| (0..n).map(move |j| [i, j]));
    cells
        .flat_map(|[i, j]| {
            [[[i, j], [i + 1, j], [i + 1, j + 1]], [[i, j], [i + 1, j + 1], [i, j + 1]]].map(&triangle)
        })
        .collect()
}

fn mixed(blend: Blend, from: Srgb8, to: Srgb8, t: f64) -> BlendColor {
    let (from, to) = (blend.from_srgb8(from), blend.from_srgb8(to));
    [0, 1, 2, 3].map(|c| from[c] + t * (to[c] - from[c]))
}

/// A disk of 32 triangles.
fn disk(x: f32, y: f32, radius: f32) -> Vec<[[f32; 2]; 3]> {
    let rim = |i: u8| {
        let (sin, cos) = (f32::from(i % 32) * std::f32::consts::TAU / 32.0).sin_cos();
        [x + radius * cos, y + radius * sin]
    };
    (0..32).map(|i| [[x, y], rim(i), rim(i + 1)]).collect()
}

impl Golden {
    /// What the painter on the CPU makes of it.
    pub(crate) fn painted(&self) -> Pixmap {
        let shapes = [self.scribbles.as_slice(), &self.ink].concat();
        paint(&Scene { paper: self.paper, field: &self.field, shapes: &shapes }, &self.view)
    }

    /// What is wrong with a picture of it, if anything.
    pub(crate) fn differences(&self, picture: &Pixmap) -> Option<String> {
        let painted = self.painted();
        if (picture.width_px, picture.height_px) != (painted.width_px, painted.height_px) {
            return Some(format!("{}: {} × {} px", self.name, picture.width_px, picture.height_px));
        }
        let on_edge = self.edge_pixels();
        // Colours count as much as they are opaque.
        let apart = |i: usize| {
            let [found, wanted] = [picture, &painted].map(|picture| picture.rgba.as_chunks::<4>().0[i]);
            let weight = |c: usize| if c == 3 { 255 } else { u32::from(found[3].max(wanted[3])) };
            [0, 1, 2, 3].map(|c| (u32::from(found[c].abs_diff(wanted[c])) * weight(c)).div_ceil(255) as u8)
        };
        let (edge, inner): (Vec<usize>, Vec<usize>) = (0..on_edge.len()).partition(|&i| on_edge[i]);
        let wrong = inner.iter().filter(|&&i| apart(i).iter().any(|&levels| levels > LEVELS)).count();
        let sum: u32 = edge.iter().flat_map(|&i| apart(i)).map(u32::from).sum();
        let mean = f64::from(sum) / (4 * edge.len()).max(1) as f64;
        (wrong > 0 || mean > MEAN_EDGE_LEVELS).then(|| {
            format!(
                "{}: {wrong} of {} pixels differ, and edges by {mean:.1} levels in the mean",
                self.name,
                inner.len()
            )
        })
    }

    /// Marks the pixels that a side, the border of the field or the outline of a shape comes close to.
    fn edge_pixels(&self) -> Vec<bool> {
        let mut marked = vec![false; (self.view.width_px * self.view.height_px) as usize];
        let field: Vec<_> = self.field.triangles.iter().map(|t| t.corners).collect();
        let shapes = self.ink.iter().chain(&self.scribbles).map(|shape| outline(&shape.triangles));
        let sides = self.field.triangles.iter().flat_map(sides);
        for [a, b] in outline(&field).into_iter().chain(sides).chain(shapes.flatten()) {
            mark(&mut marked, &self.view, a, b);
        }
        marked
    }
}

type Edge = [[f32; 2]; 2];

fn edges(triangle: &[[f32; 2]; 3]) -> [Edge; 3] {
    let [a, b, c] = *triangle;
    [[a, b], [b, c], [c, a]]
}

fn sides(triangle: &FieldTriangle) -> impl Iterator<Item = Edge> + use<> {
    let bits = triangle.side_edges;
    edges(&triangle.corners)
        .into_iter()
        .enumerate()
        .filter(move |(i, _)| bits >> i & 1 == 1)
        .map(|(_, edge)| edge)
}

/// The edges that only one triangle has.
fn outline(triangles: &[[[f32; 2]; 3]]) -> Vec<Edge> {
    let key = |edge: &Edge| {
        let mut ends = edge.map(|end| end.map(f32::to_bits));
        ends.sort();
        ends
    };
    let mut all: Vec<Edge> = triangles.iter().flat_map(edges).collect();
    all.sort_by_key(key);
    all.chunk_by(|a, b| key(a) == key(b)).filter(|same| same.len() == 1).map(|same| same[0]).collect()
}

/// Marks the pixels whose centre is less than 1.5 px from a segment.
fn mark(marked: &mut [bool], view: &View, a: [f32; 2], b: [f32; 2]) {
    let px = |p: [f32; 2]| view.px_from_du * kurbo::Point::new(f64::from(p[0]), f64::from(p[1]));
    let segment = kurbo::Line::new(px(a), px(b));
    let near = kurbo::Shape::bounding_box(&segment).inflate(2.0, 2.0);
    let picture = Rect::new(0.0, 0.0, f64::from(view.width_px), f64::from(view.height_px));
    let near = near.intersect(picture);
    for y in near.y0 as u32..near.y1 as u32 {
        for x in near.x0 as u32..near.x1 as u32 {
            let center = kurbo::Point::new(f64::from(x) + 0.5, f64::from(y) + 0.5);
            if kurbo::ParamCurveNearest::nearest(&segment, center, 1e-6).distance_sq < 1.5 * 1.5 {
                marked[(y * view.width_px + x) as usize] = true;
            }
        }
    }
}
