// A level of the grid solver. Slot s of all cells lies in columns s · columns .. of the textures.

struct Level {
    columns: i32,
    slots: i32,
    // A uniform of WebGL is a multiple of 16 bytes.
    padding: vec2<i32>,
}

// By unknown: weights of the links to the slots of the cell to the east, of that to the south, and of its own; and how
// strongly it is held, the diagonal, the damping of the interpolation, and which slot of the coarser cell it is a part
// of, counted from 1, or 0.
@group(1) @binding(0) var<uniform> level: Level;
@group(1) @binding(1) var east: texture_2d<u32>;
@group(1) @binding(2) var south: texture_2d<u32>;
@group(1) @binding(3) var within: texture_2d<u32>;
@group(1) @binding(4) var holds: texture_2d<u32>;

fn coarse_columns() -> i32 {
    return (level.columns + 1) / 2;
}
