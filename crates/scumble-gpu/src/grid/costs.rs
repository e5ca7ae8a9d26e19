//! What passes move and take, told from what was recorded.

use super::tape::{Pass, Tape};

/// What passes cost, however long they take.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Costs {
    /// Passes.
    pub passes: u64,
    /// Bytes that are read and written, each texel of a texture once a pass.
    pub bytes: u64,
}

/// What a solver costs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct SolverCosts {
    /// To build the levels.
    pub levels: Costs,
    /// To make a first picture.
    pub start: Costs,
    /// A step.
    pub step: Costs,
    /// Bytes of all textures.
    pub texture_bytes: u64,
}

impl SolverCosts {
    pub(super) fn of([build, start]: [&Tape; 2], [one, next]: [&Tape; 2]) -> Self {
        let texture_bytes = texture_bytes([build, start, one, next]);
        let [levels, start, step] = [build, start, one].map(Costs::of);
        Self { levels, start, step, texture_bytes }
    }

    /// A picture in other colours, in so many steps.
    pub fn recolor(&self, steps: u64) -> Costs {
        let Self { start, step, .. } = self;
        Costs { passes: start.passes + steps * step.passes, bytes: start.bytes + steps * step.bytes }
    }

    /// A picture from nothing, in so many steps.
    pub fn solve(&self, steps: u64) -> Costs {
        let (levels, rest) = (self.levels, self.recolor(steps));
        Costs { passes: levels.passes + rest.passes, bytes: levels.bytes + rest.bytes }
    }
}

impl Costs {
    pub(super) fn of(tape: &Tape) -> Self {
        let textures = |pass: &Pass| pass.reads.iter().chain([&pass.target]).map(bytes).sum::<u64>();
        Self { passes: tape.0.len() as u64, bytes: tape.0.iter().map(textures).sum() }
    }
}

/// Bytes of all textures that passes read or draw.
fn texture_bytes(tapes: [&Tape; 4]) -> u64 {
    let mut seen: Vec<&wgpu::Texture> = Vec::new();
    let views =
        tapes.into_iter().flat_map(|tape| &tape.0).flat_map(|pass| pass.reads.iter().chain([&pass.target]));
    let mut sum = 0;
    for view in views {
        if !seen.contains(&view.texture()) {
            seen.push(view.texture());
            sum += bytes(view);
        }
    }
    sum
}

fn bytes(view: &wgpu::TextureView) -> u64 {
    let texture = view.texture();
    let texel_bytes = texture.format().block_copy_size(None).unwrap_or(0);
    u64::from(texel_bytes) * u64::from(texture.width()) * u64::from(texture.height())
}
