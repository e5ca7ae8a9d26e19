// What the grid solver found, through a view: smooth between curves, and cut at them exactly, at any zoom.

@group(1) @binding(0) var<uniform> grid: Grid;
@group(1) @binding(1) var values: texture_2d<u32>;
@group(1) @binding(2) var cells: texture_2d<u32>;
@group(1) @binding(3) var pieces: texture_2d<u32>;

// Places in a pixel where colours are looked up: a lattice of so many, in which no two share a column or a row.
const SAMPLES = 16;

@fragment
fn fragment(@builtin(position) position: vec4<f32>) -> @location(0) vec4<f32> {
    var is_cut = false;
    for (var i = 0; i < 9; i++) {
        let corner = position.xy + 0.5 * vec2<f32>(vec2(i % 3 - 1, i / 3 - 1));
        is_cut |= textureLoad(cells, cell_of(on_grid(corner)), 0).y > 0u;
    }
    if !is_cut {
        return painted(blended(color_at(on_grid(position.xy))));
    }
    var sum = vec4(0.0);
    for (var i = 0; i < SAMPLES; i++) {
        let sample = (vec2<f32>(vec2(i, i * 5 % SAMPLES)) + 0.5) / f32(SAMPLES) - 0.5;
        sum += painted(blended(color_at(on_grid(position.xy + sample))));
    }
    return sum / f32(SAMPLES);
}
