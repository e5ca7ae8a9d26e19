// The vector that a matrix is multiplied with: what is in first.
fn value_at(place: vec2<i32>) -> vec4<f32> {
    return texel(first, place);
}
