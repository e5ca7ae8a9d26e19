// The matrix times a vector.

fn kernel(place: vec2<i32>) -> vec4<f32> {
    return multiplied(place);
}
