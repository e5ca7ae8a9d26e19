// The matrix of a level, times the vector that value_at gives, which each kernel has its own: by the differences along links,
// whose rounding is as small as they are.

var<private> own: vec4<f32>;

fn linked_value(place: vec2<i32>) -> vec4<f32> {
    return value_at(place) - own;
}

fn multiplied(place: vec2<i32>) -> vec4<f32> {
    own = value_at(place);
    return texel(holds, place).x * own - linked(place);
}
