// One step of Jacobi's method for the values in first and the right side in second, by the part of the way in third.

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let value = texel(first, place);
    let diagonal = texel(holds, place).y;
    if diagonal > 0.0 {
        let residual = texel(second, place) - multiplied(place);
        return value + residual * (texel(third, vec2(0)).x / diagonal);
    }
    return value;
}
