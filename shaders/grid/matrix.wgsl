// The matrix of a level, times the values in first: by the differences along links, whose rounding is as small as they are.

var<private> own: vec4<f32>;

fn linked_value(place: vec2<i32>) -> vec4<f32> {
    return texel(first, place) - own;
}

fn multiplied(place: vec2<i32>) -> vec4<f32> {
    own = texel(first, place);
    return texel(holds, place).x * own - linked(place);
}
