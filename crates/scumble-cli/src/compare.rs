//! `scumble compare`: how far pictures on pixels, and those on a finer mesh, are from the mesh solver's, over a set of
//! drawings and a made one.
//!
//! Errors are in levels of sRGB over white paper, of which there are 255; of a pixel's channels the worst counts. They
//! are taken at pixel centres, away from curves and from the ends of curves, junctions and changes of what a side is;
//! near those they are reported apart. Where the two solvers differ, a mesh that is graded towards all such places tells which
//! is right.

mod both;
mod finer;
mod graded;
mod levels;
mod solver;
mod zones;

use std::path::Path;

use anyhow::Context;
use scumble_core::{Blend, Boundary, PlanarMap, Settings, SideId};
use scumble_solve::grid::{Constraints, JeschkeSolver};
use scumble_solve::{Picture, View, centers};

use crate::card::Card;
use crate::set::{self, Kind};
use crate::{made, stages};
use levels::{Levels, levels};
use zones::Zone;

pub(crate) use both::Both;
pub(crate) use levels::Spread;

/// Size of the pictures.
const SIZE_PX: u32 = 1024;

/// Steps of Jeschke's solver: as in the paper, and many more.
const JESCHKE_STEPS: [usize; 2] = [8, 64];

/// Cells of the made drawing, in rows and columns: it has 10,000 pieces.
const MADE_CELLS: u32 = 13;

/// Errors of one drawing, or of all.
#[derive(Clone, Default)]
struct Row {
    /// Steps of the grid solver, the most of all drawings.
    steps: usize,
    /// What further steps change.
    iteration: f64,
    away: Spread,
    special: Spread,
    /// What a mesh of half the width changes: everywhere, and away from special places.
    finer: [Spread; 2],
    jeschke: [Spread; JESCHKE_STEPS.len()],
    /// How far the mesh solver and the grid solver are from a picture that is nearly without error, away from curves.
    errors: Option<[Spread; 2]>,
}

/// What is compared, and of what.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct CompareOptions {
    /// Only half of the sides have colours.
    pub(crate) half: bool,
    /// A graded mesh tells which solver is right.
    pub(crate) referee: bool,
    /// The grid solver is the graphics card's.
    pub(crate) gpu: bool,
}

/// Compares on all drawings of a set, or on every so many-th; with all colours or with those of half the sides.
///
/// # Errors
/// When the set cannot be read, a drawing fails, or there is no graphics card where one is asked for.
pub(crate) fn run(set: &Path, every: usize, options: CompareOptions) -> anyhow::Result<()> {
    let card = options.gpu.then(Card::find).transpose()?;
    let card = card.as_ref();
    print_head(options.referee);
    let mut all = Row::default();
    for entry in set::entries(set)?.iter().step_by(every) {
        let row = drawing(entry, options, card).with_context(|| format!("drawing {}", entry.id))?;
        row.print(&entry.id);
        all.add(&row);
    }
    all.print("all of them");
    made_row(options, card)?.print("made, 10,000 pieces");
    Ok(())
}

fn drawing(entry: &set::Entry, options: CompareOptions, card: Option<&Card>) -> anyhow::Result<Row> {
    let mut opened = stages::open(&entry.svg()?)?;
    let scribbles = entry.scribbles(Kind::Dense, &opened.document.drawing)?;
    let boundary = opened.picture.color(&scribbles, &[], &Settings::default()).clone();
    let view = stages::page_view(&opened.document.drawing, SIZE_PX);
    row(&mut opened.picture, boundary, &view, options, card)
}

fn made_row(options: CompareOptions, card: Option<&Card>) -> anyhow::Result<Row> {
    let drawing = made::drawing(MADE_CELLS);
    let mut picture = Picture::new(&drawing)?;
    let boundary = picture.color(&made::scribbles(), &[], &Settings::default()).clone();
    row(&mut picture, boundary, &stages::page_view(&drawing, SIZE_PX), options, card)
}

fn row(
    picture: &mut Picture,
    mut boundary: Boundary,
    view: &View,
    options: CompareOptions,
    card: Option<&Card>,
) -> anyhow::Result<Row> {
    if options.half {
        uncolor_half(picture.map(), &mut boundary);
    }
    let blend = Settings::default().blend;
    let mut both = Both::new(picture, &boundary, blend, view, card)?;
    let referee = options.referee.then(|| graded::field(picture.map(), &boundary, blend)).transpose()?;
    let finer = finer::changes(picture.map(), &boundary, view, &both.mesh)?;
    Ok(Row {
        steps: both.steps,
        iteration: both.change_by_further_steps()?,
        away: both.differences(),
        special: both.between(Zone::Special, &both.grid, &both.mesh),
        finer,
        jeschke: JESCHKE_STEPS
            .map(|steps| both.between(Zone::Away, &jeschke(&both.constraints, steps, blend), &both.mesh)),
        errors: referee.map(|field| {
            let right = levels(&centers::colors(&field, view), blend);
            [&both.mesh, &both.grid].map(|picture| both.between(Zone::Away, picture, &right))
        }),
    })
}

fn jeschke(constraints: &Constraints, steps: usize, blend: Blend) -> Vec<Levels> {
    let mut solver = JeschkeSolver::new(constraints);
    (0..steps).for_each(|_| solver.step());
    levels(solver.pixels(), blend)
}

/// Takes their colours from about half of the sides of curves, whole sides at a time.
pub(crate) fn uncolor_half(map: &PlanarMap, boundary: &mut Boundary) {
    for (curve, right) in (0..map.curve_count()).flat_map(|curve| [(curve, false), (curve, true)]) {
        if is_uncolored(2 * curve + usize::from(right)) {
            let sides =
                map.steps(curve).iter().map(|step| if right { step.left.opposite() } else { step.left });
            sides.for_each(|side: SideId| boundary.sides[side.index()] = None);
        }
    }
}

/// A coin for each number: a bit of Fibonacci hashing (D. E. Knuth, *The Art of Computer Programming* 3, 6.4).
fn is_uncolored(number: usize) -> bool {
    (number as u32).wrapping_mul(0x9e37_79b9) >> 31 == 1
}

impl Row {
    fn add(&mut self, other: &Self) {
        self.steps = self.steps.max(other.steps);
        self.iteration = self.iteration.max(other.iteration);
        self.away.add(&other.away);
        self.special.add(&other.special);
        self.finer.iter_mut().zip(&other.finer).for_each(|(sum, other)| sum.add(other));
        self.jeschke.iter_mut().zip(&other.jeschke).for_each(|(sum, other)| sum.add(other));
        if let Some(errors) = &other.errors {
            let sums = self.errors.get_or_insert_default();
            sums.iter_mut().zip(errors).for_each(|(sum, other)| sum.add(other));
        }
    }

    fn print(&self, name: &str) {
        let name: String = name.chars().take(20).collect();
        print!("{name:<20} {:>5} {:>8.2}  {}  {}", self.steps, self.iteration, self.away, self.special);
        let errors = self.errors.iter().flatten();
        self.finer.iter().chain(&self.jeschke).chain(errors).for_each(|spread| print!("  {spread}"));
        println!();
    }
}

fn print_head(has_referee: bool) {
    println!("levels: mean, 99 %, largest");
    let [few, many] = JESCHKE_STEPS.map(|steps| format!("Jeschke, {steps} steps"));
    let columns = ["away from curves", "at ends, junctions", "finer mesh", "… away from ends", &few, &many];
    let errors = ["error of the mesh", "error of the grid"];
    print!("{:<20} {:>5} {:>8}", "drawing", "steps", "to come");
    let errors = if has_referee { &errors[..] } else { &[] };
    columns.iter().chain(errors).for_each(|column| print!("  {column:>20}"));
    println!();
}

#[cfg(test)]
mod tests {
    use kurbo::{BezPath, Point, Rect, Vec2};
    use scumble_core::{Curve, Drawing};

    use super::*;

    /// A made drawing, on fewer pixels than the table's.
    fn compared(options: CompareOptions, card: Option<&Card>) -> Row {
        let drawing = made::drawing(3);
        let mut picture = Picture::new(&drawing).expect("a map");
        let boundary = picture.color(&made::scribbles(), &[], &Settings::default()).clone();
        row(&mut picture, boundary, &stages::page_view(&drawing, 512), options, card).expect("a row")
    }

    fn assert_near(row: &Row) {
        assert!(row.away.mean() <= 0.4 && row.away.percentile(0.99) <= 3.0, "{}", row.away);
        assert!(row.iteration <= 0.5, "{}", row.iteration);
    }

    #[test]
    fn the_grid_solver_is_as_near_to_the_mesh_solver_as_is_asked_and_jeschkes_is_not() {
        let row = compared(CompareOptions::default(), None);
        assert_near(&row);
        for jeschke in row.jeschke {
            assert!(jeschke.mean() > 2.0 * row.away.mean(), "{jeschke}");
        }
    }

    #[test]
    fn so_is_that_of_the_graphics_card() {
        match Card::find() {
            Ok(card) => assert_near(&compared(CompareOptions::default(), Some(&card))),
            Err(error) => eprintln!("skipped: {error}"),
        }
    }

    #[test]
    fn where_half_of_the_sides_have_no_colour_a_graded_mesh_tells_who_is_right() {
        let row = compared(CompareOptions { half: true, referee: true, gpu: false }, None);
        let [mesh, grid] = row.errors.expect("a referee");
        assert!(row.iteration <= 0.5 && mesh.mean() > 0.0 && grid.mean() > 0.0);
        assert!(mesh.mean() <= 0.1 && grid.mean() <= 0.5, "{mesh} {grid}");
    }

    /// A box, in which there is a smaller one and what a line that crosses a wall ends with: so long, and at such an angle to it.
    fn crossed_box(length_du: f64, angle_deg: f64) -> Drawing {
        let curve = |path: &str| Curve { path: BezPath::from_svg(path).expect("a path"), line: None };
        let (foot, along) = (Point::new(200.0, 500.0), Vec2::from_angle((90.0 - angle_deg).to_radians()));
        let (from, tip) = (foot - 90.0 * along, foot + length_du * along);
        let curves = vec![
            curve("M 200 200 V 800 H 800 V 200 Z"),
            curve("M 480 520 H 560 V 600 H 480 Z"),
            curve(&format!("M {} {} L {} {}", from.x, from.y, tip.x, tip.y)),
        ];
        Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) }
    }

    /// The walls of the larger box give no colour, the smaller one gives another one than the line, on its left side, on its
    /// right one or on both. 99 % of the mesh solver's picture are off by so many levels at most.
    fn assert_near_needle(length_du: f64, angle_deg: f64, is_colored: [bool; 2], off_mesh: f64) {
        let drawing = crossed_box(length_du, angle_deg);
        let mut picture = Picture::new(&drawing).expect("a map");
        let mut boundary = picture.color(&[], &[], &Settings::default()).clone();
        boundary.sides = vec![None; picture.map().side_count()];
        for (curve, lightness, is_colored) in [(1, 0.0, [true; 2]), (2, 0.8, is_colored)] {
            for step in picture.map().steps(curve) {
                let sides = [step.left, step.left.opposite()].into_iter().zip(is_colored);
                for (side, _) in sides.filter(|(_, is_colored)| *is_colored) {
                    boundary.sides[side.index()] = Some([[lightness, 0.0, 0.0, 1.0]; 3]);
                }
            }
        }
        let options = CompareOptions { referee: true, ..CompareOptions::default() };
        let row =
            row(&mut picture, boundary, &stages::page_view(&drawing, 512), options, None).expect("a row");
        let [mesh, grid] = row.errors.expect("a referee");
        let name = format!("{length_du} du, {angle_deg}°, {is_colored:?}: {mesh} {grid}");
        assert!(mesh.percentile(0.99) <= off_mesh, "{name}");
        assert!(grid.mean() <= 0.25 && grid.percentile(0.99) <= 4.0, "{name}");
    }

    #[test]
    fn what_crosses_a_wall_without_colours_by_less_than_a_pixel_is_not_lost() {
        assert_near_needle(0.3, 90.0, [true, true], 0.5);
        assert_near_needle(1.2, 45.0, [true, false], 1.5);
        assert_near_needle(0.3, 30.0, [true, false], 2.5);
        // These have pieces in common with the wall.
        assert_near_needle(0.1, 30.0, [false, true], 4.0);
        assert_near_needle(0.8, 165.0, [true, true], 3.0);
    }
}
