// What an unknown adds to the right side of the coarser level, given the residual in first: the transpose of interpolate.

fn linked_value(place: vec2<i32>) -> vec4<f32> {
    return texel(first, place) * texel(holds, place).z;
}

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let hold = texel(holds, place);
    return texel(first, place) * (1.0 - hold.y * hold.z) + linked(place);
}
