// What is in first, without what is in second, times what is in the one texel of third.

fn kernel(place: vec2<i32>) -> vec4<f32> {
    return texel(first, place) - texel(second, place) * texel(third, vec2(0));
}
