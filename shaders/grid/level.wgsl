// A level of the grid solver. Slot s of all cells lies in columns s · columns .. of the textures.

struct Level {
    columns: i32,
    slots: i32,
    // A uniform of WebGL is a multiple of 16 bytes.
    padding: vec2<i32>,
}

fn coarse_columns() -> i32 {
    return (level.columns + 1) / 2;
}
