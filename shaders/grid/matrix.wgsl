// The matrix of a level, times the values in first.

fn linked_value(place: vec2<i32>) -> vec4<f32> {
    return textureLoad(first, place, 0);
}

fn multiplied(place: vec2<i32>) -> vec4<f32> {
    let diagonal = textureLoad(holds, place, 0).y;
    return diagonal * textureLoad(first, place, 0) - linked(place);
}
