// The first two steps of Jacobi's method from zero, for the right side in first, by the parts of the way in the one texel of
// second.

// After the first of them.
fn value_at(place: vec2<i32>) -> vec4<f32> {
    let diagonal = texel(holds, place).y;
    if diagonal > 0.0 {
        return texel(first, place) * (texel(second, vec2(0)).x / diagonal);
    }
    return vec4(0.0);
}

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let diagonal = texel(holds, place).y;
    if diagonal > 0.0 {
        let residual = texel(first, place) - multiplied(place);
        return own + residual * (texel(second, vec2(0)).y / diagonal);
    }
    return vec4(0.0);
}
