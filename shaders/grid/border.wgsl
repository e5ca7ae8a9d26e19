// What holds pixels of a part of a picture to what a grid of the whole has beyond its borders. Each is given by its centre in
// clip space, with the right side of its equation and, a bit for each, its links that lead out: to the east, south, west
// and north.

@group(0) @binding(0) var<uniform> grid: Grid;
@group(0) @binding(1) var values: texture_2d<u32>;
@group(0) @binding(2) var cells: texture_2d<u32>;
@group(0) @binding(3) var pieces: texture_2d<u32>;

struct Varying {
    @builtin(position) position: vec4<f32>,
    @location(0) @interpolate(flat) right: vec4<u32>,
    @location(1) @interpolate(flat) links: u32,
}

@vertex
fn vertex(
    @location(0) center: vec2<f32>,
    @location(1) right: vec4<u32>,
    @location(2) links: u32,
) -> Varying {
    return Varying(vec4(center, 0.0, 1.0), right, links);
}

@fragment
fn fragment(in: Varying) -> @location(0) vec4<u32> {
    var right = bitcast<vec4<f32>>(in.right);
    for (var link = 0u; link < 4u; link++) {
        if (in.links & (1u << link)) != 0u {
            let along = 1.0 - f32(link & 2u);
            let way = select(vec2(along, 0.0), vec2(0.0, along), (link & 1u) == 1u);
            right += color_at(on_grid(in.position.xy + way));
        }
    }
    return bitcast<vec4<u32>>(right);
}
