//! What the grid solver finds is drawn as the painter on the CPU paints it. Needs a graphics driver; Mesa's software one
//! is enough.

use kurbo::{Affine, BezPath, Circle, Point, Rect, Shape, Vec2};
use scumble_core::source::weight;
use scumble_core::{Bends, Blend, Boundary, Curve, Drawing, Gap, PlanarMap, Sampling, SoftSource, Srgb8};
use scumble_gpu::wgpu::TextureFormat::Rgba8Unorm;
use scumble_gpu::{Gpu, GpuError, GpuGridSolver, GridKernels, Renderer};
use scumble_solve::grid::{Constraints, GridPicture, GridProblem, GridSolver, Shades, Whole};
use scumble_solve::{Field, FieldChange, FieldTriangle, Part, Pixmap, View, paint_grid};

const PAPER: Option<Srgb8> = Some(Srgb8([255; 3]));
const RED: Srgb8 = Srgb8([230, 25, 75]);
const BLUE: Srgb8 = Srgb8([0, 130, 200]);
const GREEN: Srgb8 = Srgb8([60, 180, 75]);

/// An open device, or `None`, said aloud, where there is none.
fn gpu() -> Option<Gpu> {
    let failed = |error: GpuError| panic!("{error}");
    pollster::block_on(Gpu::headless(failed)).map_err(|error| eprintln!("skipped: {error}")).ok()
}

/// A circle with an open curve in it, of several colours, and around it paper; from an end of the curve to the circle is a gap.
fn map() -> PlanarMap {
    let mut arm = BezPath::new();
    arm.move_to((300.0, 400.0));
    arm.curve_to((450.0, 250.0), (600.0, 750.0), (740.0, 610.0));
    let curves = [Circle::new((512.0, 512.0), 340.3).to_path(1e-3), arm];
    let curves = curves.map(|path| Curve { path, line: None }).into();
    let drawing = Drawing { curves, ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0)) };
    let map = PlanarMap::build(&drawing, &Sampling::default()).expect("a map");
    let points = map.triangulation().points();
    let distance = |node: u32, place: Point| points[node as usize].distance(place);
    let nearest = |place: Point| {
        let nodes = 0..points.len() as u32;
        nodes.min_by(|a, b| distance(*a, place).total_cmp(&distance(*b, place))).expect("a node")
    };
    let nodes = [(740.0, 610.0), (849.6, 554.6)].map(|place| nearest(place.into()));
    map.with_gaps(vec![Gap { nodes, is_wide: false, is_plain: false, is_slight: false }])
}

/// Green inside of the circle, red and blue on the sides of the arm; the gap is closed.
fn boundary(map: &PlanarMap) -> Boundary {
    let mut sides = vec![None; map.side_count()];
    for (curve, colors) in [[Some(GREEN), None], [Some(RED), Some(BLUE)]].into_iter().enumerate() {
        for step in map.steps(curve) {
            for (side, color) in [step.left, step.left.opposite()].into_iter().zip(colors) {
                sides[side.index()] = color.map(|color| [Blend::Oklab.from_srgb8(color); 3]);
            }
        }
    }
    Boundary { closed_gaps: vec![true], ..sides.into() }
}

fn page(side_px: u32) -> View {
    View { px_from_du: Affine::scale(f64::from(side_px) / 1024.0), width_px: side_px, height_px: side_px }
}

/// A problem with so many pixels to a side, solved, in a renderer.
fn solved(gpu: &Gpu, side_px: u32) -> (GridProblem, GpuGridSolver, Renderer) {
    solved_with(gpu, side_px, &boundary(&map()))
}

fn solved_with(gpu: &Gpu, side_px: u32, boundary: &Boundary) -> (GridProblem, GpuGridSolver, Renderer) {
    let problem = GridProblem::new(&map(), boundary, &page(side_px), Blend::Oklab).expect("solved");
    let mut solver = GpuGridSolver::new(gpu, &GridKernels::new(gpu), &problem.constraints).expect("a solver");
    (0..8).for_each(|_| solver.step());
    let mut renderer = Renderer::new(gpu, Rgba8Unorm);
    renderer.set_problem(&problem);
    renderer.update_solution(&solver);
    (problem, solver, renderer)
}

fn read(renderer: &mut Renderer, view: &View) -> Pixmap {
    pollster::block_on(renderer.read_back(view, PAPER)).expect("the pixels come back")
}

fn pixel(picture: &Pixmap, [x, y]: [f64; 2]) -> [u8; 3] {
    let start = 4 * (y as usize * picture.width_px as usize + x as usize);
    std::array::from_fn(|c| picture.rgba[start + c])
}

fn difference(a: &[u8], b: &[u8]) -> u8 {
    a.iter().zip(b).map(|(a, b)| a.abs_diff(*b)).max().unwrap_or_default()
}

/// Where curves pass, both take 16 samples of a pixel, but not the same.
#[track_caller]
fn assert_alike(drawn: &Pixmap, painted: &Pixmap) {
    let levels: Vec<u8> =
        drawn.rgba.chunks_exact(4).zip(painted.rgba.chunks_exact(4)).map(|(a, b)| difference(a, b)).collect();
    let beyond = |limit: u8| levels.iter().filter(|level| **level > limit).count();
    assert!(beyond(2) < levels.len() / 50, "{} pixels differ", beyond(2));
    assert!(beyond(40) < 20, "{} pixels differ much", beyond(40));
}

#[test]
fn pixel_for_pixel_it_is_what_the_painter_on_the_cpu_paints() {
    let Some(gpu) = gpu() else { return };
    let (problem, solver, mut renderer) = solved(&gpu, 300);
    let pixels = pollster::block_on(solver.pixels()).expect("the pixels come back");
    let (map, straight) = (map(), Bends::default());
    let found = GridPicture::new(&map, &straight, &boundary(&map), &problem.view, Blend::Oklab, pixels);
    let painted = paint_grid(&found, &[], &problem.view, PAPER);
    let drawn = read(&mut renderer, &problem.view);
    assert_alike(&drawn, &painted);
}

#[test]
fn curves_cut_it_exactly_at_any_zoom() {
    let Some(gpu) = gpu() else { return };
    let (_, _, mut renderer) = solved(&gpu, 256);
    // 16 pixels for one of the grid, at the right end of the circle: x = 852.3 there.
    let view = View {
        px_from_du: Affine::scale(4.0) * Affine::translate((-802.3, -487.0)),
        width_px: 400,
        height_px: 200,
    };
    let picture = read(&mut renderer, &view);
    for y in [80.0, 100.0, 120.0] {
        let inside = pixel(&picture, [197.0, y]);
        assert!(difference(&inside, &GREEN.0) <= 3, "{inside:?} inside");
        assert_eq!(pixel(&picture, [202.0, y]), [255; 3], "outside");
    }
}

/// Green in a circle so small that the pieces of its curve are chords of some pixels off it.
#[test]
fn a_part_from_close_by_is_cut_at_curves_as_they_bend() {
    let Some(gpu) = gpu() else { return };
    let (center, radius_du, px_per_du) = (Point::new(512.0, 512.0), 20.0, 32.0);
    let path = Circle::new(center, radius_du).to_path(1e-4);
    let drawing = Drawing {
        curves: vec![Curve { path, line: None }],
        ..Drawing::new(Rect::new(0.0, 0.0, 1024.0, 1024.0))
    };
    let map = PlanarMap::build(&drawing, &Sampling::default()).expect("a map");
    let boundary = boundary(&map);
    let whole = GridProblem::new(&map, &boundary, &page(256), Blend::Oklab).expect("a whole");
    let kernels = GridKernels::new(&gpu);
    let mut on_whole = GpuGridSolver::new(&gpu, &kernels, &whole.constraints).expect("a solver");
    (0..8).for_each(|_| on_whole.step());

    // In the middle of it the right end of the circle.
    let corner_du = Point::new(center.x + radius_du - 8.0, center.y - 8.0);
    let px_from_du = Affine::scale(px_per_du) * Affine::translate(-corner_du.to_vec2());
    let view = View { px_from_du, width_px: 512, height_px: 512 };
    let bends = Bends::within(&drawing, &map, Rect::from_origin_size(corner_du, (16.0, 16.0)), 0.003);
    let part = whole.part(&map, &bends, &boundary, &view);
    let mut on_part = GpuGridSolver::new(&gpu, &kernels, &part.constraints).expect("a solver");
    let mut renderer = Renderer::new(&gpu, Rgba8Unorm);
    renderer.set_problem(&whole);
    renderer.update_solution(&on_whole);
    renderer.set_part(Some(&part));
    renderer.begin_part(&kernels, &on_whole, &mut on_part);
    (0..8).for_each(|_| on_part.step());
    renderer.update_part(&on_part);
    let picture = read(&mut renderer, &view);
    for step in -30..=30 {
        let way = Vec2::from_angle(0.01 * f64::from(step));
        let [inside, outside] = [-1.5, 1.5].map(|off_px| {
            let place_px = view.px_from_du * (center + (radius_du + off_px / px_per_du) * way);
            pixel(&picture, [place_px.x, place_px.y])
        });
        assert!(difference(&inside, &GREEN.0) <= 3, "{inside:?} inside at {step}");
        assert_eq!(outside, [255; 3], "outside at {step}");
    }
}

#[test]
fn a_field_takes_its_place() {
    let Some(gpu) = gpu() else { return };
    let (problem, _, mut renderer) = solved(&gpu, 64);
    let corners = [[-1.0, -1.0], [9000.0, -1.0], [-1.0, 9000.0]];
    let color = Blend::Oklab.from_srgb8(RED).map(|c| c as f32);
    let triangles = vec![FieldTriangle { corners, colors: [color; 6], side_edges: 7 }];
    renderer.set_field(&Field { blend: Blend::Oklab, triangles }, &FieldChange::ALL);
    assert_eq!(pixel(&read(&mut renderer, &problem.view), [32.0, 32.0]), RED.0);
}

/// Dark across the left border of a part.
fn shade() -> SoftSource {
    SoftSource {
        points: vec![Point::new(380.0, 560.0), Point::new(500.0, 620.0)],
        radius_du: 60.0,
        weight: weight(0.8),
        color: Blend::Oklab.from_srgb8(Srgb8([20; 3])),
        crosses: true,
        parts: Vec::new(),
    }
}

/// A part of the page on pixels four times smaller, with ends of the arm, of the circle and of a shade beyond its borders.
#[test]
fn a_part_takes_what_the_whole_has_beyond_its_borders_as_on_the_cpu() {
    let Some(gpu) = gpu() else { return };
    let (map, view) = (map(), page(1024).part(&Part { columns: 420..780, rows: 300..800 }));
    let without_shade = boundary(&map);
    let boundary = Boundary { sources: vec![shade()], ..without_shade.clone() };
    let (whole, solver, mut renderer) = solved_with(&gpu, 256, &boundary);

    let straight = Bends::default();
    let part = whole.part(&map, &straight, &boundary, &view);
    let kernels = GridKernels::new(&gpu);
    let mut on_gpu = GpuGridSolver::new(&gpu, &kernels, &part.constraints).expect("a solver");
    renderer.set_part(Some(&part));
    // Once more makes no difference.
    for _ in 0..2 {
        renderer.begin_part(&kernels, &solver, &mut on_gpu);
        (0..10).for_each(|_| on_gpu.step());
    }
    let found = pollster::block_on(on_gpu.pixels()).expect("the pixels come back");

    let on_cpu = |constraints: Constraints| {
        let mut solver = GridSolver::new(&constraints);
        solver.solve(1e-6);
        solver.pixels()
    };
    let pixels = on_cpu(Constraints::new(&map, &without_shade, &whole.view).expect("a whole"));
    let whole = Whole::new(&map, &straight, &without_shade, &whole.view, pixels);
    let shades = Shades::new(&map, &boundary).expect("shades");
    let expected = on_cpu(Constraints::within(&whole, &map, &straight, &boundary, &shades, &view));
    let levels =
        |(a, b): (&[f32; 4], &[f32; 4])| (0..4).map(|c| 255.0 * (a[c] - b[c]).abs()).fold(0.0, f32::max);
    let largest = found.iter().zip(&expected).map(levels).fold(0.0, f32::max);
    assert!(largest < 0.1, "{largest} levels");

    let before = read(&mut renderer, &view);
    renderer.update_part(&on_gpu);
    let after = read(&mut renderer, &view);
    let found = GridPicture::new(&map, &straight, &boundary, &view, Blend::Oklab, found);
    assert_alike(&after, &paint_grid(&found, &[], &view, PAPER));
    assert_ne!(before, after, "the whole is less sharp");
}
