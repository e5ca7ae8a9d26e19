// The matrix of a level, times the values in first: by the differences along links, whose rounding is as small as they are.

var<private> own: vec4<f32>;

fn linked_value(place: vec2<i32>) -> vec4<f32> {
    return textureLoad(first, place, 0) - own;
}

fn multiplied(place: vec2<i32>) -> vec4<f32> {
    own = textureLoad(first, place, 0);
    return textureLoad(holds, place, 0).x * own - linked(place);
}
