// By unknown: weights of the links to the slots of the cell to the east, of that to the south, and of its own; and how
// strongly it is held, the diagonal, the damping of the interpolation, and which slot of the coarser cell it is a part
// of, counted from 1, or 0.
@group(1) @binding(0) var<uniform> level: Level;
@group(1) @binding(1) var east: Texels;
@group(1) @binding(2) var south: Texels;
@group(1) @binding(3) var within: Texels;
@group(1) @binding(4) var holds: Texels;

// The weights of links, or how strongly an unknown is held, zeros beyond the border. Of pixels that is one float a texel, which
// would be taken for halves.
fn weights(texels: Texels, place: vec2<i32>) -> vec4<f32> {
    if level.slots > 1 {
        return load(texels, place);
    }
    if any(place < vec2(0)) || any(place >= extent(texels)) {
        return vec4(0.0);
    }
    return bitcast<vec4<f32>>(textureLoad(texels, place, 0));
}
