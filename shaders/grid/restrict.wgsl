// What an unknown adds to the right side of the coarser level, given the residual in first: the transpose of interpolate.

fn value_at(place: vec2<i32>) -> vec4<f32> {
    return texel(first, place) * texel(holds, place).z;
}

fn kernel(place: vec2<i32>) -> vec4<f32> {
    return texel(first, place) - multiplied(place);
}
