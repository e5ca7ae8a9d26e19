// Numbers are written as the halves that pass.wgsl reads, two in each channel, rounded to nearest; what is too large, as the
// largest.

fn written(numbers: vec4<f32>) -> vec4<u32> {
    let bits = bitcast<vec4<u32>>(0x1p-80f * numbers);
    let sizes = min(((bits & vec4(0x7fffffffu)) + 0x2000u) >> vec4(14u), vec4(0x7fffu));
    let halves = sizes | ((bits >> vec4(16u)) & vec4(0x8000u));
    return vec4(halves.xz | (halves.yw << vec2(16u)), 0u, 1u);
}
