//! `scumble agree`: how far the grid solver's picture is from the mesh solver's, pixel by pixel.

use std::path::Path;

use anyhow::Context;
use kurbo::{Point, Vec2};
use scumble_core::color::{LEAST_OPACITY, LINEAR_FROM_LMS, LMS_FROM_OKLAB, srgb_from_linear};
use scumble_core::{Blend, Boundary, PlanarMap, Settings, SideId};
use scumble_solve::grid::{CutLinks, GridSolver};
use scumble_solve::{Field, FieldTriangle, View};

use crate::clock::timed;
use crate::set::{self, Kind};
use crate::stages;

const SIZE_PX: u32 = 1024;

pub(crate) fn run(set: &Path, half: bool, every: usize, made: u32) -> anyhow::Result<()> {
    if made > 0 {
        let drawing = crate::made::drawing(made);
        let mut picture = scumble_solve::Picture::new(&drawing)?;
        let mut boundary = picture.color(&crate::made::scribbles(), &Settings::default());
        println!("{} pieces", picture.map().pieces().len());
        if half { uncolor_half(picture.map(), &mut boundary); }
        let view = stages::page_view(&drawing, SIZE_PX);
        return one("made", &mut picture, &boundary, &view);
    }
    for entry in set::entries(set)?.iter().step_by(every) {
        let mut opened = stages::open(&entry.svg()?)?;
        let scribbles = entry.scribbles(Kind::Dense, &opened.import.drawing)?;
        let mut boundary = opened.picture.color(&scribbles, &Settings::default());
        if half {
            uncolor_half(opened.picture.map(), &mut boundary);
        }
        let view = stages::page_view(&opened.import.drawing, SIZE_PX);
        one(&entry.id, &mut opened.picture, &boundary, &view).context(entry.id.clone())?;
    }
    Ok(())
}

fn uncolor_half(map: &PlanarMap, boundary: &mut Boundary) {
    for curve in 0..map.curve_count() {
        for right in [false, true] {
            if (curve * 2 + usize::from(right)).wrapping_mul(0x9e37_79b9) >> 7 & 1 == 1 {
                for step in map.steps(curve) {
                    let side = if right { step.left.opposite() } else { step.left };
                    if let Some(color) = boundary.sides.get_mut(side.index()) {
                        *color = None;
                    }
                }
            }
        }
    }
}

fn one(name: &str, picture: &mut scumble_solve::Picture, boundary: &Boundary, view: &View) -> anyhow::Result<()> {
    let links = CutLinks::new(picture.map(), boundary, view);
    let zone = zones(picture.map(), boundary, view);
    let field = picture.mesh().solve(boundary, Blend::Oklab)?;
    let mesh = centers(field, view);
    let (mut solver, setup_ms) = timed(|| GridSolver::new(&links));
    let mut pictures = vec![solver.pixels().to_vec()];
    let (_, step_ms) = timed(|| for _ in 0..10 {
        solver.step();
        pictures.push(solver.pixels().to_vec());
    });
    for _ in 0..20 { solver.step(); }
    let last = solver.pixels().to_vec();
    for _ in 0..5 { solver.step(); }
    let finals: Vec<_> = solver.pixels().iter().map(|&c| levels(c)).collect();
    let residual = last.iter().map(|&c| levels(c)).zip(&finals).map(|(a, b)| difference(a, *b)).fold(0.0, f64::max);
    let errors: Vec<_> = pictures.iter().map(|pixels| {
        pixels.iter().zip(&finals).map(|(&a, b)| difference(levels(a), *b)).fold(0.0, f64::max)
    }).collect();
    let diffs: Vec<f64> = mesh.iter().zip(&finals).map(|(&a, b)| difference(levels(a), *b)).collect();
    let mut worst: Vec<usize> = (0..diffs.len()).filter(|&i| zone[i] == 0 && diffs[i] > 4.0).collect();
    worst.sort_by(|&i, &j| diffs[j].total_cmp(&diffs[i]));
    for &i in worst.iter().step_by(worst.len() / 5 + 1) {
        println!("   {} {} of {}: {:.1} mesh {:?} grid {:?}", i % view.width_px as usize, i / view.width_px as usize, worst.len(), diffs[i], mesh[i], solver.pixels()[i]);
    }
    let far = stats(diffs.iter().zip(&zone).filter(|(_, z)| **z == 0).map(|(d, _)| *d));
    let special = stats(diffs.iter().zip(&zone).filter(|(_, z)| **z == 2).map(|(d, _)| *d));
    println!("{name:14.14} far {} special {} setup {setup_ms:.0} step {:.0} last {residual:.3} it {}", far, special, step_ms / 10.0,
        errors.iter().map(|e| format!("{e:.1}")).collect::<Vec<_>>().join(" "));
    Ok(())
}

fn stats(values: impl Iterator<Item = f64>) -> String {
    let mut v: Vec<f64> = values.collect();
    v.sort_by(f64::total_cmp);
    if v.is_empty() { return "-".into(); }
    format!("{:.3} {:.2} {:.1}", v.iter().sum::<f64>() / v.len() as f64, v[v.len() * 99 / 100], v[v.len() - 1])
}

fn difference(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|c| (a[c] - b[c]).abs()).fold(0.0, f64::max)
}

fn levels(color: [f32; 4]) -> [f64; 3] {
    let [l, a, b, opacity] = color.map(f64::from);
    let o = opacity.max(LEAST_OPACITY);
    let lab = [l / o, a / o, b / o];
    let lms = LMS_FROM_OKLAB.map(|r| (r[0] * lab[0] + r[1] * lab[1] + r[2] * lab[2]).powi(3));
    let rgb = LINEAR_FROM_LMS.map(|r| srgb_from_linear((r[0] * lms[0] + r[1] * lms[1] + r[2] * lms[2]).clamp(0.0, 1.0)));
    let opacity = opacity.clamp(0.0, 1.0);
    rgb.map(|c| 255.0 * (c * opacity + 1.0 - opacity))
}

fn zones(map: &PlanarMap, boundary: &Boundary, view: &View) -> Vec<u8> {
    let (w, h) = (view.width_px as i64, view.height_px as i64);
    let mut zone = vec![0u8; (w * h) as usize];
    let at = |n: u32| view.px_from_du * map.triangulation().points()[n as usize];
    let mut mark = |a: Point, b: Point, r: f64, z: u8| {
        for y in ((a.y.min(b.y) - r - 1.0).max(0.0) as i64)..((a.y.max(b.y) + r + 1.0) as i64).min(h) {
            for x in ((a.x.min(b.x) - r - 1.0).max(0.0) as i64)..((a.x.max(b.x) + r + 1.0) as i64).min(w) {
                let p = Point::new(x as f64 + 0.5, y as f64 + 0.5);
                let ab = b - a;
                let t = if ab.hypot2() > 0.0 { ((p - a).dot(ab) / ab.hypot2()).clamp(0.0, 1.0) } else { 0.0 };
                if (p - (a + t * ab)).hypot() <= r { zone[(y * w + x) as usize] = zone[(y * w + x) as usize].max(z); }
            }
        }
    };
    let n = map.triangulation().points().len();
    let mut degree = vec![0; n];
    let mut states: Vec<Vec<[bool; 2]>> = vec![Vec::new(); n];
    let colored = |s: SideId| boundary.sides.get(s.index()).copied().flatten().is_some();
    for (i, piece) in map.pieces().iter().enumerate() {
        if piece.curve.is_none() { continue; }
        let [a, b] = piece.nodes;
        mark(at(a), at(b), 2.0, 1);
        degree[a as usize] += 1;
        degree[b as usize] += 1;
        let (l, r) = (colored(SideId::of(i, false)), colored(SideId::of(i, true)));
        states[a as usize].push([l, r]);
        states[b as usize].push([r, l]);
    }
    for i in 0..n {
        let special = degree[i] == 1 || degree[i] > 2 || degree[i] == 2 && states[i][0] != [states[i][1][1], states[i][1][0]];
        if special { mark(at(i as u32), at(i as u32), 4.0, 2); }
    }
    for (gap, closed) in map.gaps().iter().zip(&boundary.closed_gaps) {
        if *closed { let [a, b] = gap.nodes.map(at); mark(a, b, 2.0, 1); mark(a, a, 4.0, 2); mark(b, b, 4.0, 2); }
    }
    zone
}

fn centers(field: &Field, view: &View) -> Vec<[f32; 4]> {
    let (w, h) = (view.width_px as i64, view.height_px as i64);
    let mut out = vec![[0.0; 4]; (w * h) as usize];
    for t in &field.triangles {
        let c = t.corners.map(|[x, y]| view.px_from_du * Point::new(x.into(), y.into()) - Vec2::new(0.5, 0.5));
        let range = |f: fn(&Point) -> f64, n: i64| {
            let lo = c.iter().map(f).fold(f64::INFINITY, f64::min).ceil().max(0.0) as i64;
            let hi = c.iter().map(f).fold(f64::NEG_INFINITY, f64::max).floor().min(n as f64 - 1.0) as i64;
            lo..hi + 1
        };
        let area = (c[1] - c[0]).cross(c[2] - c[0]);
        for y in range(|p| p.y, h) {
            for x in range(|p| p.x, w) {
                let p = Point::new(x as f64, y as f64);
                let v = (p - c[0]).cross(c[2] - c[0]) / area;
                let wt = (c[1] - c[0]).cross(p - c[0]) / area;
                let u = 1.0 - v - wt;
                if u >= -1e-9 && v >= -1e-9 && wt >= -1e-9 {
                    out[(y * w + x) as usize] = value(t, [u, v, wt]);
                }
            }
        }
    }
    out
}

fn value(t: &FieldTriangle, [a, b, c]: [f64; 3]) -> [f32; 4] {
    let s = [a * (2.0 * a - 1.0), b * (2.0 * b - 1.0), c * (2.0 * c - 1.0), 4.0 * a * b, 4.0 * b * c, 4.0 * c * a];
    [0, 1, 2, 3].map(|i| s.iter().zip(t.colors).map(|(s, color)| s * f64::from(color[i])).sum::<f64>() as f32)
}
