// Shared by the kernels of the grid solver, each a pass that computes every texel of its target from texels of others.
// Their twins on the CPU have the same names. What a pass reads is first, second and third.
//
// Textures hold the bits of floats: whole numbers can be drawn on every device, floats on some alone.

@group(0) @binding(0) var first: texture_2d<u32>;
@group(0) @binding(1) var second: texture_2d<u32>;
@group(0) @binding(2) var third: texture_2d<u32>;

// A texel within the border.
fn texel(texels: texture_2d<u32>, place: vec2<i32>) -> vec4<f32> {
    return bitcast<vec4<f32>>(textureLoad(texels, place, 0));
}

// A texel, zeros beyond the border.
fn load(texels: texture_2d<u32>, place: vec2<i32>) -> vec4<f32> {
    if any(place < vec2(0)) || any(place >= vec2<i32>(textureDimensions(texels))) {
        return vec4(0.0);
    }
    return texel(texels, place);
}
