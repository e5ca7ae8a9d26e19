// The first step of Jacobi's method from zero, for the right side in first, by the part of the way in second.

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let diagonal = texel(holds, place).y;
    if diagonal > 0.0 {
        return texel(first, place) * (texel(second, vec2(0)).x / diagonal);
    }
    return vec4(0.0);
}
