//! `scumble corpus`: every drawing of a folder through all stages, looking for panics, failures and lost curves.

use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};
use std::process::ExitCode;

use kurbo::{Line, ParamCurve, ParamCurveNearest, PathEl, Point, Rect, Shape};
use scumble_core::{Drawing, PlanarMap, Scribble, ScribbleKind, Settings, Srgb8, Step};
use scumble_io::ImportError;

use crate::clock::{self, Times};
use crate::stages::{self, Opened, SpreadTimes};

/// What became of one drawing.
enum Outcome {
    Sound(Box<Opened>, SpreadTimes),
    /// There is nothing to colour in it.
    NoCurves,
    Faulty(String),
}

/// Tries the drawings and prints what is wrong, then the times.
///
/// # Errors
/// When the folder cannot be read.
pub(crate) fn run(folder: &Path, take: Option<usize>) -> anyhow::Result<ExitCode> {
    let paths = evenly_spaced(crate::files::drawings(folder)?, take);
    let mut table = Table::default();
    let (mut empty, mut faulty) = (0, 0);
    for path in &paths {
        let outcome = catch_unwind(AssertUnwindSafe(|| try_drawing(path)));
        match outcome.unwrap_or_else(|_| Outcome::Faulty("panicked".into())) {
            Outcome::Sound(opened, spread) => table.add(&opened, &spread),
            Outcome::NoCurves => empty += 1,
            Outcome::Faulty(reason) => {
                faulty += 1;
                println!("{}: {reason}", path.display());
            }
        }
    }
    println!("{} drawings: {} sound, {empty} without lines, {faulty} faulty", paths.len(), table.total.len());
    table.print();
    Ok(if faulty > 0 { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}

fn evenly_spaced(paths: Vec<PathBuf>, take: Option<usize>) -> Vec<PathBuf> {
    let count = take.unwrap_or(paths.len()).min(paths.len());
    (0..count).map(|i| paths[i * paths.len() / count].clone()).collect()
}

fn try_drawing(path: &Path) -> Outcome {
    match color_twice(path) {
        Ok((opened, spread)) => match lost_curves(&opened.document.drawing, opened.picture.map()) {
            lost if lost.is_empty() => Outcome::Sound(Box::new(opened), spread),
            lost => Outcome::Faulty(format!("lost curves {lost:?}")),
        },
        Err(error) if matches!(error.downcast_ref(), Some(ImportError::NoCurves(_))) => Outcome::NoCurves,
        Err(error) => Outcome::Faulty(format!("{error:#}")),
    }
}

fn color_twice(path: &Path) -> anyhow::Result<(Opened, SpreadTimes)> {
    let mut opened = stages::open(&crate::files::read(path)?)?;
    let scribbles = scribbles_on(&opened.document.drawing);
    let times = stages::spread(&mut opened.picture, &scribbles, &[], &Settings::default())?;
    Ok((opened, times))
}

/// A scribble across the centre of a drawing and one in its first quarter.
pub(crate) fn scribbles_on(drawing: &Drawing) -> Vec<Scribble> {
    let size = drawing.size_du();
    let at = |x: f64, y: f64| Point::new(x * size.width, y * size.height);
    let scribble =
        |rgb, points| Scribble { color: Srgb8(rgb).into(), kind: ScribbleKind::Fill, width_du: 8.0, points };
    vec![
        scribble([230, 25, 75], vec![at(0.45, 0.5), at(0.5, 0.48), at(0.55, 0.5)]),
        scribble([0, 130, 200], vec![at(0.25, 0.25), at(0.25, 0.32)]),
    ]
}

/// Spacing of the lattice of the planar map, in du: what is smaller than a few of these may vanish.
const LATTICE_DU: f64 = 1.0 / 1024.0;

/// Distance between the places at which a curve is looked for, in du.
const PROBE_SPACING_DU: f64 = 3.0;

/// How far from its place a curve may be found, in du: half the distance of nodes, for turns between two of them.
const REACH_DU: f64 = 1.6;

/// The curves of which the map lacks a part.
fn lost_curves(drawing: &Drawing, map: &PlanarMap) -> Vec<usize> {
    let is_lost = |curve: &usize| {
        let probes = probes(drawing.curves[*curve].path.elements(), drawing.frame());
        let bounds = probes.iter().map(|p| Rect::from_points(*p, *p)).reduce(|a, b| a.union(b));
        let is_visible = bounds.unwrap_or_default().size().max_side() > 2.0 * LATTICE_DU;
        let pieces: Vec<_> = map.steps(*curve).iter().map(|step| segment(map, step)).collect();
        let is_found =
            |p: &Point| pieces.iter().any(|piece| piece.nearest(*p, 1e-6).distance_sq <= REACH_DU.powi(2));
        is_visible && !probes.iter().all(is_found)
    };
    (0..drawing.curves.len()).filter(is_lost).collect()
}

fn segment(map: &PlanarMap, step: &Step) -> Line {
    let [a, b] = map.ends(step.left).map(|node| map.triangulation().points()[node as usize]);
    Line::new(a, b)
}

/// Points along a path that lie on the page.
fn probes(path: &[PathEl], page: Rect) -> Vec<Point> {
    let mut probes = Vec::new();
    let mut probe = |line: Line| {
        let count = (line.length() / PROBE_SPACING_DU).ceil();
        if line.bounding_box().overlaps(page) && count < MAX_PROBES {
            let points = (0..=count as usize).map(|i| line.eval(i as f64 / count.max(1.0)));
            probes.extend(points.filter(|p| page.contains(*p)));
        }
    };
    let (mut at, mut start) = (Point::ORIGIN, Point::ORIGIN);
    kurbo::flatten(path.iter().copied(), 0.1, |element| match element {
        PathEl::MoveTo(p) => (at, start) = (p, p),
        PathEl::ClosePath => probe(Line::new(at, start)),
        element => {
            let p = element.end_point().unwrap_or(at);
            probe(Line::new(at, p));
            at = p;
        }
    });
    probes
}

/// Probes of one straight line; the rest of a longer one lies far off the page.
const MAX_PROBES: f64 = 1e6;

/// Times of all sound drawings.
#[derive(Default)]
struct Table {
    stages: [Times; 7],
    total: Times,
}

impl Table {
    const NAMES: [&str; 7] = ["import", "map", "mesh", "color two scribbles", "analyse", "factor", "solve"];

    fn add(&mut self, opened: &Opened, spread: &SpreadTimes) {
        let ms = [
            opened.import_ms,
            opened.map_ms,
            opened.mesh_ms,
            spread.color_ms,
            spread.analyse_ms,
            spread.factor_ms,
            spread.solve_ms,
        ];
        for (times, ms) in self.stages.iter_mut().zip(ms) {
            times.push(ms);
        }
        self.total.push(ms.iter().sum());
    }

    fn print(&self) {
        clock::print_head("one drawing");
        for (name, times) in Self::NAMES.iter().zip(&self.stages) {
            clock::print_row(name, times);
        }
        clock::print_row("all", &self.total);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use kurbo::BezPath;
    use scumble_core::{Curve, Sampling};

    fn drawing(paths: &[&str]) -> Drawing {
        let mut drawing = Drawing::new(Rect::new(0.0, 0.0, 64.0, 64.0));
        let curve = |path: &&str| Curve { path: BezPath::from_svg(path).unwrap(), line: None };
        drawing.curves = paths.iter().map(curve).collect();
        drawing
    }

    #[test]
    fn a_curve_that_the_map_lacks_is_lost() {
        let given =
            drawing(&["M 9 9 L 99 99", "M 200 9 C 200 99 300 99 300 9", "M -9 -9 L -99 9", "M 5 5 L 5 5"]);
        let whole = PlanarMap::build(&given, &Sampling::default()).unwrap();
        assert_eq!(lost_curves(&given, &whole), [0_usize; 0]);
        let short = drawing(&["M 9 9 L 90 90", "M 200 9 C 200 99 300 99 300 9", "", ""]);
        let lacking = PlanarMap::build(&short, &Sampling::default()).unwrap();
        assert_eq!(lost_curves(&given, &lacking), [0]);
        let none = PlanarMap::build(&drawing(&["", "", "", ""]), &Sampling::default()).unwrap();
        assert_eq!(lost_curves(&given, &none), [0, 1]);
    }

    #[test]
    fn drawings_are_taken_evenly_spaced() {
        let paths: Vec<PathBuf> = (0..10).map(|i| PathBuf::from(i.to_string())).collect();
        let taken = |take| evenly_spaced(paths.clone(), take).len();
        assert_eq!((taken(None), taken(Some(3)), taken(Some(99))), (10, 3, 10));
        assert_eq!(
            evenly_spaced(paths.clone(), Some(3)),
            [&paths[0], &paths[3], &paths[6]].map(Clone::clone)
        );
    }
}
