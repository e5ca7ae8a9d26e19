//! What passes move and take, told from what was recorded.

use super::tape::{Recipe, Tape};

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
        let views = tape.recipes.iter().flat_map(Recipe::views);
        Self { passes: tape.recipes.len() as u64, bytes: views.map(bytes).sum() }
    }
}

/// Bytes of all textures that passes read or draw.
fn texture_bytes(tapes: [&Tape; 4]) -> u64 {
    let mut seen: Vec<&wgpu::TextureView> = Vec::new();
    for view in tapes.into_iter().flat_map(|tape| &tape.recipes).flat_map(Recipe::views) {
        if !seen.contains(&view) {
            seen.push(view);
        }
    }
    seen.into_iter().map(bytes).sum()
}

fn bytes(view: &wgpu::TextureView) -> u64 {
    let texture = view.texture();
    let texel_bytes = texture.format().block_copy_size(None).unwrap_or(0);
    u64::from(texel_bytes) * u64::from(texture.width()) * u64::from(texture.height())
}
