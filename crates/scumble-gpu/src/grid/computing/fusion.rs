//! Runs of passes over few texels, made one program each: a dispatch takes longer than such a pass.
//!
//! What such passes read and make stays in a pool. What others make of it is taken from their textures at the beginning of a
//! program, and what others are to read is given to its texture at the end.

use super::Programs;
use super::program::{GIVE, INLETS, Instruction, TAKE, Texels};
use crate::gpu::Gpu;
use crate::grid::kernels::{OPERANDS, Pipeline};
use crate::grid::tape::{Pass, Recipe, Tape};
use crate::grid::texels::FORMAT;

/// Texels of the largest texture that is in the pool: those of 16 × 16 cells of four slots. For more texels one work
/// group takes longer than all of a card with a dispatch a pass.
const MOST_TEXELS: u32 = 1024;

/// Makes programs of passes of some tapes. Textures that none of these passes makes never change; of those that they make, others
/// read one of few texels, and any that are as large as the picture.
pub(in crate::grid) fn fuse(
    gpu: &Gpu,
    programs: &Programs,
    tapes: &mut [&mut Tape],
    picture: &wgpu::TextureView,
    read_by_others: &wgpu::TextureView,
) {
    if texel_count(picture) > MOST_TEXELS {
        let pool = Pool::new(gpu, programs, tapes, read_by_others);
        pool.take_constants(tapes);
        tapes.iter_mut().for_each(|tape| pool.fuse_tape(tape));
    }
}

fn texel_count(view: &wgpu::TextureView) -> u32 {
    view.texture().width() * view.texture().height()
}

fn is_small(recipe: &Recipe) -> bool {
    recipe.views().all(|view| texel_count(view) <= MOST_TEXELS)
}

/// What passes over few texels read and make.
struct Pool<'a> {
    gpu: &'a Gpu,
    programs: &'a Programs,
    places: Vec<(wgpu::TextureView, Texels)>,
    buffer: wgpu::Buffer,
    read_by_others: &'a wgpu::TextureView,
}

impl<'a> Pool<'a> {
    fn new(
        gpu: &'a Gpu,
        programs: &'a Programs,
        tapes: &[&mut Tape],
        read_by_others: &'a wgpu::TextureView,
    ) -> Self {
        let (mut places, mut end) = (Vec::<(wgpu::TextureView, Texels)>::new(), 0);
        let recipes = tapes.iter().flat_map(|tape| &tape.recipes).filter(|recipe| is_small(recipe));
        for view in recipes.flat_map(Recipe::views) {
            if places.iter().all(|(other, _)| other != view) {
                debug_assert_eq!(view.texture().format(), FORMAT, "programs know no halves");
                let [width, height] = [view.texture().width(), view.texture().height()];
                places.push((view.clone(), Texels { offset: end, width, height }));
                end += width * height;
            }
        }
        Self { gpu, programs, places, buffer: buffer(gpu, end), read_by_others }
    }

    /// Takes at once what no pass makes.
    fn take_constants(&self, tapes: &[&mut Tape]) {
        let recipes = || tapes.iter().flat_map(|tape| &tape.recipes);
        let is_made = |view: &&wgpu::TextureView| recipes().any(|recipe| recipe.target == **view);
        let views = self.places.iter().map(|(view, _)| view);
        let constants: Vec<_> = views.filter(|view| !is_made(view)).collect();
        let passes = constants.chunks(INLETS).map(|inlets| self.program(inlets, &[], None)).collect();
        Tape { passes, ..Tape::default() }.play(self.gpu);
    }

    /// Makes programs of the runs of passes over few texels of a tape.
    fn fuse_tape(&self, tape: &mut Tape) {
        let recipes = &tape.recipes;
        let mut passes = std::mem::take(&mut tape.passes).into_iter();
        let (mut end, mut inlets) = (0, Vec::new());
        for run in recipes.chunk_by(|a, b| is_small(a) == is_small(b)) {
            end += run.len();
            let passes: Vec<_> = passes.by_ref().take(run.len()).collect();
            if is_small(&run[0]) {
                let outlet = self.outlet(run, &recipes[end..]);
                tape.passes.push(self.program(&std::mem::take(&mut inlets), run, outlet));
            } else {
                tape.passes.extend(passes);
                let made = run.iter().map(|recipe| &recipe.target);
                inlets.extend(made.filter(|view| self.find(view).is_some()));
            }
        }
        debug_assert!(inlets.is_empty(), "what others make is read by passes after them");
    }

    /// The pass that takes what others have made, does what a run of passes does, and gives what others read.
    fn program(
        &self,
        inlets: &[&wgpu::TextureView],
        run: &[Recipe],
        outlet: Option<&wgpu::TextureView>,
    ) -> Pass {
        debug_assert!(inlets.len() <= INLETS, "{} inlets", inlets.len());
        let taken = inlets.iter().zip(0..).map(|(view, i)| self.take(view, i));
        let made = run.iter().map(|recipe| self.instruction(recipe));
        let given = outlet.iter().map(|view| self.give(view));
        let instructions: Vec<_> = taken.chain(made).chain(given).collect();
        Pass {
            pipeline: Pipeline::Computes(self.programs.pipeline.clone()),
            operands: self.programs.group(&self.gpu.device, &instructions, &self.buffer, inlets, outlet),
            level: None,
            target: self.programs.one().clone(),
        }
    }

    /// What a run makes that others read, after it on the same tape or apart from all tapes.
    fn outlet<'r>(&self, run: &'r [Recipe], after: &[Recipe]) -> Option<&'r wgpu::TextureView> {
        let is_outlet = |target: &&wgpu::TextureView| {
            let made_again = after.iter().position(|recipe| recipe.target == **target).unwrap_or(after.len());
            let mut others = after[..made_again].iter().filter(|recipe| !is_small(recipe));
            *target == self.read_by_others || others.any(|recipe| recipe.reads().any(|view| view == *target))
        };
        let mut outlets = run.iter().map(|recipe| &recipe.target).filter(is_outlet);
        let outlet = outlets.next();
        debug_assert!(outlets.all(|other| Some(other) == outlet), "a program has one outlet");
        outlet
    }

    fn find(&self, view: &wgpu::TextureView) -> Option<Texels> {
        self.places.iter().find(|(place, _)| place == view).map(|(_, texels)| *texels)
    }

    fn texels(&self, view: &wgpu::TextureView) -> Texels {
        self.find(view).expect("all views of passes over few texels have a place")
    }

    fn take(&self, view: &wgpu::TextureView, inlet: u32) -> Instruction {
        let operands = [Texels { offset: inlet, ..Default::default() }; OPERANDS];
        Instruction { kernel: TAKE, result: self.texels(view), operands, ..Default::default() }
    }

    fn give(&self, view: &wgpu::TextureView) -> Instruction {
        let texels = self.texels(view);
        Instruction { kernel: GIVE, result: texels, operands: [texels; OPERANDS], ..Default::default() }
    }

    fn instruction(&self, recipe: &Recipe) -> Instruction {
        let Recipe { kernel, operands, matrix, target } = recipe;
        let last = operands.len() - 1;
        let operands = std::array::from_fn(|i| self.texels(&operands[i.min(last)]));
        let plain = Instruction {
            kernel: *kernel as u32,
            result: self.texels(target),
            operands,
            ..Default::default()
        };
        let Some(matrix) = matrix else { return plain };
        let [columns, slots] = [matrix.size.columns, matrix.size.slots].map(|count| count as u32);
        let mut instruction = Instruction { columns, slots, ..plain };
        if kernel.reads_links() {
            instruction.links = matrix.links.each_ref().map(|view| self.texels(view));
        }
        if kernel.reads_holds() {
            instruction.holds = self.texels(&matrix.holds);
        }
        instruction
    }
}

fn buffer(gpu: &Gpu, texels: u32) -> wgpu::Buffer {
    gpu.device.create_buffer(&wgpu::BufferDescriptor {
        label: Some("pool"),
        size: u64::from(texels) * 16,
        usage: wgpu::BufferUsages::STORAGE,
        mapped_at_creation: false,
    })
}
