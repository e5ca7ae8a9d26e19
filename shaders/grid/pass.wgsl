// Shared by the kernels of the grid solver, each a pass that computes every texel of its target from texels of others.
// Their twins on the CPU have the same names. What a pass reads is first, second and third.
//
// Programs compute many texels in one invocation: private variables keep what the last one has left, so kernels set all that
// they read.
//
// Textures hold the bits of floats, or of halves: whole numbers can be drawn on every device, floats on some alone.

alias Texels = texture_2d<u32>;

@group(0) @binding(0) var first: Texels;
@group(0) @binding(1) var second: Texels;
@group(0) @binding(2) var third: Texels;

fn extent(texels: Texels) -> vec2<i32> {
    return vec2<i32>(textureDimensions(texels));
}

// A texel within the border.
fn texel(texels: Texels, place: vec2<i32>) -> vec4<f32> {
    return numbers(textureLoad(texels, place, 0));
}

// A texel of two channels has 0 and 1 in the place of the others, and holds two halves in each: a sign, six bits of exponent and
// nine of fraction, which stand for floats of 2^-46 to 2^17. The halves that devices know end above what small residuals need,
// and are of medium precision in WebGL.
fn numbers(bits: vec4<u32>) -> vec4<f32> {
    if bits.z == 0u && bits.w == 1u {
        let halves = bitcast<vec4<i32>>(bits.xxyy << vec4(16u, 0u, 16u, 0u));
        return 0x1p80f * bitcast<vec4<f32>>((halves >> vec4(2u)) & vec4<i32>(-0x60004000));
    }
    return bitcast<vec4<f32>>(bits);
}
