// The values in first with the correction of the coarser level: that of their own part, made smooth by one damped step of
// Jacobi's method.

fn value_at(place: vec2<i32>) -> vec4<f32> {
    return parent_value(place);
}

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let rough = multiplied(place) * texel(holds, place).z;
    return texel(first, place) + own - rough;
}
