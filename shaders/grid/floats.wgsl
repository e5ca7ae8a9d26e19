// Numbers are written as the bits of floats.

fn written(numbers: vec4<f32>) -> vec4<u32> {
    let bits = bitcast<vec4<u32>>(numbers);
    // By a last number of one bit, halves are told from floats: so small a float is zero.
    return vec4(bits.xyz, select(bits.w, 0u, bits.w == 1u));
}
