// What is in first, by what is in second, where that is above zero.

fn kernel(place: vec2<i32>) -> vec4<f32> {
    let divisor = texel(second, place);
    let is_above = divisor > vec4(0.0);
    return select(vec4(0.0), texel(first, place) / select(vec4(1.0), divisor, is_above), is_above);
}
