//! How long a frame takes while the end of a curve is moved: a drawing of 5,000 pieces, whose picture is the grid solver's.

use std::f64::consts::TAU;

use kurbo::{PathEl, Vec2};
use scumble_core::pace::now;
use scumble_core::{Blend, Drawing, Scribble, Settings};
use scumble_gpu::{Gpu, GpuGridSolver, GridError, GridKernels};
use scumble_solve::grid::{Constraints, FRAME_STEPS, GridProblem};
use scumble_solve::{Picture, View};

use crate::clock::{Times, print_head, print_row, timed};
use crate::{made, stages};

/// Cells in a row, for 5,000 pieces.
const CELLS: u32 = 5;

/// Longer sides of the pictures.
const SIZES_PX: [u32; 2] = [256, 1024];

/// Frames of the move.
const FRAMES: u32 = 12;

/// How far the end goes to and fro, in du.
const REACH_DU: f64 = 20.0;

/// Bytes that the solver uploads for the equation of one pixel.
const EQUATION_BYTES: usize = 36;

/// Times of all frames.
#[derive(Default)]
struct Report {
    map: Times,
    labels: Times,
    constraints: Times,
    levels: Times,
    steps: Times,
    frame: Times,
    /// What the mesh solver takes from the labels to the field.
    mesh: Times,
    /// Pixels whose equations are uploaded.
    uploads: Times,
}

/// Times the frames of a move and prints the figures.
///
/// # Errors
/// When the made drawing has no map, or there is no graphics device.
pub(crate) fn run() -> anyhow::Result<()> {
    let gpu = pollster::block_on(Gpu::headless(|error| eprintln!("scumble: {error}")))?;
    let info = gpu.adapter.get_info();
    println!("{} ({:?}), {FRAME_STEPS} steps a frame", info.name, info.device_type);
    for size_px in SIZES_PX {
        let mut report = Report::default();
        let mut scene = Scene::new(&gpu, size_px)?;
        for frame in 1..=FRAMES {
            scene.frame(frame, &mut report)?;
            report.mesh(&mut scene)?;
        }
        report.print(&scene);
    }
    Ok(())
}

/// A drawing in the hand, and its picture.
struct Scene {
    scribbles: Vec<Scribble>,
    picture: Picture,
    view: View,
    kernels: GridKernels,
    solver: GpuGridSolver,
}

/// The made drawing with the end of its first curve where it is in a frame.
pub(super) fn drawing(frame: u32) -> Drawing {
    let mut drawing = made::drawing(CELLS);
    let angle = TAU * f64::from(frame) / f64::from(FRAMES);
    if let Some(PathEl::LineTo(end)) = drawing.curves[0].path.elements_mut().last_mut() {
        *end += REACH_DU * (Vec2::from_angle(angle) - Vec2::new(1.0, 0.0));
    }
    drawing
}

impl Scene {
    fn new(gpu: &Gpu, size_px: u32) -> anyhow::Result<Self> {
        let (drawing, scribbles) = (drawing(0), made::scribbles());
        let mut picture = Picture::new(&drawing)?;
        picture.color(&scribbles, &[], &Settings::default());
        let view = stages::page_view(&drawing, size_px);
        let (constraints, kernels) =
            (Constraints::new(picture.map(), picture.boundary(), &view)?, GridKernels::new(gpu));
        let solver = GpuGridSolver::new(gpu, &kernels, &constraints)?;
        Ok(Self { scribbles, picture, view, kernels, solver })
    }

    /// All that a frame of the move takes, as in the page.
    fn frame(&mut self, frame: u32, report: &mut Report) -> anyhow::Result<()> {
        let drawing = drawing(frame);
        let (picture, map_ms) = timed(|| Picture::new(&drawing));
        self.picture = picture?;
        let ((), labels_ms) =
            timed(|| now(self.picture.coloring(&self.scribbles, &[], &Settings::default())));
        let picture = &self.picture;
        let (problem, constraints_ms) =
            timed(|| GridProblem::new(picture.map(), picture.boundary(), &self.view, Blend::default()));
        let problem = problem?;
        let (uploads, levels_ms) = timed(|| self.build(&problem.constraints));
        let (stepped, steps_ms) = timed(|| self.step());
        stepped?;
        report.uploads.push(uploads? as f64);
        let times_ms = [map_ms, labels_ms, constraints_ms, levels_ms, steps_ms];
        report.stages().into_iter().zip(times_ms).for_each(|(times, ms)| times.push(ms));
        report.frame.push(times_ms.iter().sum());
        Ok(())
    }

    /// Waits for the first picture; tells of how many pixels the equations were uploaded.
    fn build(&mut self, constraints: &Constraints) -> Result<usize, GridError> {
        let uploads = self.solver.update(&self.kernels, constraints)?;
        pollster::block_on(self.solver.last_change())?;
        Ok(uploads)
    }

    /// Waits for the picture.
    fn step(&mut self) -> Result<f32, GridError> {
        (0..FRAME_STEPS).for_each(|_| self.solver.step());
        Ok(pollster::block_on(self.solver.last_change())?)
    }
}

impl Report {
    fn stages(&mut self) -> [&mut Times; 5] {
        [&mut self.map, &mut self.labels, &mut self.constraints, &mut self.levels, &mut self.steps]
    }

    fn mesh(&mut self, scene: &mut Scene) -> anyhow::Result<()> {
        let (solved, mesh_ms) = timed(|| scene.picture.solve().map(|_| ()));
        solved?;
        self.mesh.push(mesh_ms);
        Ok(())
    }

    fn print(&self, scene: &Scene) {
        let View { width_px, height_px, .. } = scene.view;
        println!();
        print_head(&format!("{} pieces, {width_px} × {height_px} px", scene.picture.map().pieces().len()));
        for (name, times) in [
            ("map", &self.map),
            ("labels", &self.labels),
            ("constraints", &self.constraints),
            ("upload, levels and first picture", &self.levels),
            ("steps", &self.steps),
            ("a frame: all of these", &self.frame),
            ("beside it: mesh, factor and solve", &self.mesh),
        ] {
            print_row(name, times);
        }
        let count = self.uploads.median();
        let all = f64::from(width_px) * f64::from(height_px);
        println!("uploaded: {count} of {all} equations, {EQUATION_BYTES} bytes each");
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use scumble_solve::grid::{GridSolver, TOLERANCE};

    /// A tenth of an 8-bit level.
    const TENTH: f32 = 0.1 / 255.0;

    #[test]
    fn every_frame_of_a_move_among_5_000_pieces_shows_the_new_picture_without_a_mesh() {
        let Ok(gpu) = pollster::block_on(Gpu::headless(|error| panic!("{error}"))) else {
            return eprintln!("skipped: no device");
        };
        let (mut scene, mut report) = (Scene::new(&gpu, 128).expect("a scene"), Report::default());
        assert!(scene.picture.map().pieces().len() >= 5000);
        for frame in 1..=4 {
            scene.frame(frame, &mut report).expect("a frame");
            let mut twin = GridSolver::new(
                &Constraints::new(scene.picture.map(), scene.picture.boundary(), &scene.view)
                    .expect("constraints"),
            );
            twin.solve(0.1 * TOLERANCE);
            let pixels = pollster::block_on(scene.solver.pixels()).expect("pixels");
            let pairs = pixels.iter().flatten().zip(twin.pixels().into_iter().flatten());
            let farthest = pairs.fold(0.0, |most, (a, b)| (a - b).abs().max(most));
            assert!(farthest <= TENTH, "{} levels in frame {frame}", 255.0 * farthest);
            assert!(!scene.picture.has_mesh());
        }
        assert!(report.uploads.percentile(1.0) < 0.2 * 128.0 * 128.0, "few equations are others");
    }
}
