//! `scumble bench`: how long each stage takes on the drawings of a quality set, and labelling by each engine, on one
//! thread; or how labels and pictures grow on made drawings, or how long a frame
//! takes while a curve is moved, or how much memory pictures take.

mod drag;
mod growth;
mod labels;
mod memory;
mod passes;
mod pictures;
mod shades;

use std::path::Path;

use anyhow::Context;
use kurbo::{Affine, Vec2};
use scumble_core::pace::now;
use scumble_core::{Boundary, Drawing, Paint, PlanarMap, Scribble, Settings};
use scumble_solve::Picture;

use crate::clock::{Times, print_head, print_row, timed};
use crate::compare::{Both, Spread};
use crate::set::{self, Entry, Kind};
use crate::stages::{self, Opened, PAPER};
use labels::{CANDIDATES, Candidate, LabelTimes};
use shades::{ShadeTimes, WIDTHS_DU};

pub(crate) use drag::run as run_drag;
pub(crate) use growth::run as run_made;
pub(crate) use memory::run as run_memory;
pub(crate) use passes::run as run_passes;

/// Size of the pictures.
const SIZE_PX: u32 = 1024;

/// Size of large ones.
const LARGE_PX: u32 = 4096;

/// How far a curve is moved.
const MOVE_DU: Vec2 = Vec2::new(3.0, 2.0);

/// The baseline takes its time: it is run on every so many-th drawing.
const BASELINE_EVERY: usize = 5;

/// Times of everything, one entry for each drawing, or for each scribble after the first.
#[derive(Default)]
struct Report {
    read: Times,
    import: Times,
    map: Times,
    gaps: Times,
    mesh: Times,
    color: Times,
    analyse: Times,
    factor: Times,
    solve: Times,
    paint: Times,
    first_picture: Times,
    new_scribble: Times,
    repaint: Times,
    repaint_large: Times,
    recolor: Times,
    undo: Times,
    /// What each frame takes while a curve is moved, before a solver makes a picture of it.
    drag: Times,
    /// A field from nothing but the drawing and all of its scribbles.
    scratch: Times,
    /// Multigrid on pixels, curves cutting their links.
    baseline: Times,
    /// What the mesh solver's pictures are away from its, in levels.
    differences: Spread,
    /// From coloured sides to pixels, on the drawings of the baseline.
    beside_baseline: Times,
    labels: [LabelTimes; CANDIDATES.len()],
    shades: [ShadeTimes; WIDTHS_DU.len()],
}

/// Times the drawings of a set and prints the figures.
///
/// # Errors
/// When the set cannot be read or a drawing fails.
pub(crate) fn run(set: &Path) -> anyhow::Result<()> {
    let mut report = Report::default();
    for (i, entry) in set::entries(set)?.iter().enumerate() {
        let measured = report.drawing(entry, i % BASELINE_EVERY == 0);
        measured.with_context(|| format!("drawing {}", entry.id))?;
    }
    report.print();
    shades::print_crowds()
}

impl Report {
    fn drawing(&mut self, entry: &Entry, with_baseline: bool) -> anyhow::Result<()> {
        let (svg, read_ms) = timed(|| entry.svg());
        let mut opened = stages::open(&svg?)?;
        let scribbles = entry.scribbles(Kind::Dense, &opened.document.drawing)?;
        self.gaps.push(growth::map(&opened.document.drawing)?.2);
        for (candidate, times) in CANDIDATES.into_iter().zip(&mut self.labels) {
            times.take(candidate, opened.picture.map(), &scribbles);
        }
        let first = scribbles.len().min(1);
        let spread_ms = self.first_scribble(&mut opened, &scribbles[..first])?;
        let first_paint_ms = paint_ms(&mut opened, &scribbles[..first], SIZE_PX)?;
        self.read.push(read_ms);
        self.import.push(opened.import_ms);
        self.map.push(opened.map_ms);
        self.mesh.push(opened.mesh_ms);
        self.paint.push(first_paint_ms);
        self.first_picture
            .push(read_ms + opened.import_ms + opened.map_ms + opened.mesh_ms + spread_ms + first_paint_ms);
        self.more_scribbles(&mut opened, &scribbles)?;
        let boundary = opened.picture.boundary().clone();
        self.recolor(&mut opened, &scribbles)?;
        self.undo(&mut opened, &scribbles)?;
        self.repaint_large.push(paint_ms(&mut opened, &scribbles, LARGE_PX)?);
        self.drag(&opened.document.drawing, &scribbles)?;
        for (width_du, times) in WIDTHS_DU.into_iter().zip(&mut self.shades) {
            times.take(&mut opened, &scribbles, width_du)?;
        }
        if with_baseline { self.baseline(&mut opened, &boundary) } else { Ok(()) }
    }

    fn first_scribble(&mut self, opened: &mut Opened, first: &[Scribble]) -> anyhow::Result<f64> {
        let times = stages::spread(&mut opened.picture, first, &[], &Settings::default())?;
        self.color.push(times.color_ms);
        self.analyse.push(times.analyse_ms);
        self.factor.push(times.factor_ms);
        self.solve.push(times.solve_ms);
        Ok(times.total_ms())
    }

    /// Adds one scribble at a time.
    fn more_scribbles(&mut self, opened: &mut Opened, scribbles: &[Scribble]) -> anyhow::Result<()> {
        for count in 2..=scribbles.len() {
            let times = stages::spread(&mut opened.picture, &scribbles[..count], &[], &Settings::default())?;
            self.new_scribble.push(times.total_ms());
        }
        self.repaint.push(paint_ms(opened, scribbles, SIZE_PX)?);
        Ok(())
    }

    /// Gives the last scribble another colour.
    fn recolor(&mut self, opened: &mut Opened, scribbles: &[Scribble]) -> anyhow::Result<()> {
        let mut recolored = scribbles.to_vec();
        if let Some(Scribble { color: Paint::Color(color), .. }) = recolored.last_mut() {
            color.0[1] ^= 0x40;
        }
        let times = stages::spread(&mut opened.picture, &recolored, &[], &Settings::default())?;
        self.recolor.push(times.total_ms());
        Ok(())
    }

    /// Takes the last scribble back.
    fn undo(&mut self, opened: &mut Opened, scribbles: &[Scribble]) -> anyhow::Result<()> {
        let before = &scribbles[..scribbles.len().saturating_sub(1)];
        let times = stages::spread(&mut opened.picture, before, &[], &Settings::default())?;
        self.undo.push(times.total_ms());
        Ok(())
    }

    /// Moves the first curve, and lets it go.
    fn drag(&mut self, drawing: &Drawing, scribbles: &[Scribble]) -> anyhow::Result<()> {
        let mut moved = drawing.clone();
        if let Some(curve) = moved.curves.first_mut() {
            curve.path.apply_affine(Affine::translate(MOVE_DU));
        }
        let (picture, map_ms) = timed(|| Picture::new(&moved));
        let mut picture = picture?;
        let ((), color_ms) = timed(|| now(picture.coloring(scribbles, &[], &Settings::default())));
        let (solved, solve_ms) = timed(|| picture.solve().map(|_| ()));
        solved?;
        self.drag.push(map_ms + color_ms);
        self.scratch.push(map_ms + color_ms + solve_ms);
        Ok(())
    }

    /// The same colours by multigrid on pixels and, from scratch, by ours.
    fn baseline(&mut self, opened: &mut Opened, boundary: &Boundary) -> anyhow::Result<()> {
        let view = stages::page_view(&opened.document.drawing, SIZE_PX);
        let both = Both::new(&mut opened.picture, boundary, Settings::default().blend, &view, None)?;
        self.baseline.push(both.grid_ms);
        self.differences.add(&both.differences());
        let mut fresh = scumble_solve::MeshSolver::new(opened.picture.map().refined().clone());
        let (painted, ours_ms) = timed(|| {
            let field = fresh.solve(boundary, Settings::default().blend)?;
            Ok::<_, scumble_solve::SolveError>(stages::paint_page(field, &[], &view, Some(PAPER)))
        });
        painted?;
        self.beside_baseline.push(ours_ms);
        Ok(())
    }

    fn print(&self) {
        print_head(&format!("{} drawings, one thread", self.import.len()));
        for (name, times) in [
            ("read", &self.read),
            ("import", &self.import),
            ("map", &self.map),
            ("… of which gaps", &self.gaps),
            ("mesh", &self.mesh),
            ("first scribble: color", &self.color),
            ("first scribble: analyse", &self.analyse),
            ("first scribble: factor", &self.factor),
            ("first scribble: solve", &self.solve),
            ("paint at 1024 px", &self.paint),
            ("file to first picture at 1024 px", &self.first_picture),
        ]
        .into_iter()
        .chain(self.changes())
        {
            print_row(name, times);
        }
        self.print_ratio();
        for (width_du, times) in WIDTHS_DU.into_iter().zip(&self.shades) {
            shades::print(times, width_du);
        }
        labels::print(&format!("labels, {} drawings", self.import.len()), &self.labels);
    }

    /// What comes after the first picture.
    fn changes(&self) -> [(&'static str, &Times); 7] {
        [
            ("a new scribble (color to solve)", &self.new_scribble),
            ("a scribble recoloured (color to solve)", &self.recolor),
            ("a scribble taken back (color to solve)", &self.undo),
            ("a curve moved: map and color", &self.drag),
            ("… and let go: from scratch (map to solve)", &self.scratch),
            ("paint at 1024 px with all scribbles", &self.repaint),
            ("paint at 4096 px with all scribbles", &self.repaint_large),
        ]
    }

    fn print_ratio(&self) {
        println!();
        print_head(&format!("{} of them, colours on sides to pixels", self.baseline.len()));
        print_row("multigrid with cut links on 1024² pixels", &self.baseline);
        print_row("analyse, factor, solve, paint at 1024 px", &self.beside_baseline);
        println!("between the two, in levels: mean, 99 %, largest {}", self.differences);
        println!();
        println!("{:<46} {:>9} {:>12}", "of medians: baseline / ours", "multigrid", "from scratch");
        for (name, times) in [("analyse, factor, solve, paint at 1024 px", &self.beside_baseline)]
            .into_iter()
            .chain(self.changes())
        {
            let [multigrid, scratch] =
                [&self.baseline, &self.scratch].map(|baseline| baseline.median() / times.median());
            println!("{name:<46} {multigrid:9.1} {scratch:12.1}");
        }
    }
}

/// Labelling by one engine on one drawing.
fn times_of(candidate: Candidate, map: &PlanarMap, scribbles: &[Scribble]) -> LabelTimes {
    let mut times = LabelTimes::default();
    times.take(candidate, map, scribbles);
    times
}

fn paint_ms(opened: &mut Opened, scribbles: &[Scribble], size_px: u32) -> anyhow::Result<f64> {
    opened.picture.color(scribbles, &[], &Settings::default());
    let view = stages::page_view(&opened.document.drawing, size_px);
    let field = opened.picture.solve()?;
    let (_, paint_ms) = timed(|| stages::paint_page(field, &[], &view, Some(PAPER)));
    Ok(paint_ms)
}
